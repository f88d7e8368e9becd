// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <cstring>
#include <memory>
#include <vector>

namespace tetra {

/// read_with_vtk.py, which reads one file after another: starting it takes a second.
class VtkProcess : public QProcess {
public:
    /// The one of this program, started when it is first asked for and ended with the application.
    static VtkProcess& running()
    {
        auto* process = dynamic_cast<VtkProcess*>(QCoreApplication::instance()->findChild<QProcess*>("vtkProcess"));
        if (process && process->state() == QProcess::Running)
            return *process;
        delete process;
        return *new VtkProcess;
    }
    ~VtkProcess() override
    {
        closeWriteChannel();
        waitForFinished();
    }

    /// A line; empty if it ended instead.
    QByteArray answer(const QByteArray& question)
    {
        write(question + '\n');
        constexpr int patience = 120'000;
        while (!canReadLine() && waitForReadyRead(patience)) {
        }
        return canReadLine() ? readLine() : QByteArray();
    }

private:
    VtkProcess() : QProcess(QCoreApplication::instance())
    {
        setObjectName("vtkProcess");
        // The interpreter that Debian's packages belong to, whatever stands before it in the path.
        start("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/plugins/writers/read_with_vtk.py"});
        waitForStarted();
    }
};

/// A mesh file as VTK reads it, by read_with_vtk.py.
class VtkReader {
public:
    explicit VtkReader(const QString& path)
    {
        VtkProcess& process = VtkProcess::running();
        told_ = QJsonDocument::fromJson(
                    process.answer(QJsonDocument(QJsonArray{path, folder_.path()}).toJson(QJsonDocument::Compact)))
                    .object();
        if (told_.isEmpty())
            process.waitForFinished();
        missing_ = process.error() == QProcess::FailedToStart ||
                   (process.state() == QProcess::NotRunning && process.exitCode() == 77);
        messages_ = process.readAllStandardError();
    }

    /// Without python3-vtk9 there is nothing to compare with.
    bool isMissing() const { return missing_; }
    bool ok() const { return told_["errors"].toInt(-1) == 0; }
    const QByteArray& messages() const { return messages_; }
    const QJsonObject& told() const { return told_; }
    /// "points", "cells" or "point.NAME", "cell.NAME".
    template <class T> std::vector<T> array(const QString& name) const
    {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QByteArray bytes = file.readAll();
        std::vector<T> values(static_cast<std::size_t>(bytes.size()) / sizeof(T));
        if (!values.empty())
            std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
        return values;
    }
    /// Three coordinates for each point, whether the file has floats or doubles.
    std::vector<double> places() const
    {
        std::vector<double> doubles = array<double>("points");
        if (static_cast<qint64>(doubles.size()) == 3 * told_["points"].toInteger())
            return doubles;
        const std::vector<float> floats = array<float>("points");
        return {floats.begin(), floats.end()};
    }

private:
    QTemporaryDir folder_;
    bool missing_ = false;
    QJsonObject told_;
    QByteArray messages_;
};

} // namespace tetra
