// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <cstring>
#include <memory>
#include <vector>

namespace tetra {

/// A mesh file as VTK reads it, by read_with_vtk.py.
class VtkReader {
public:
    explicit VtkReader(const QString& path)
    {
        QProcess process;
        // The interpreter that Debian's packages belong to, whatever stands before it in the path.
        process.start("/usr/bin/python3",
                      {TAN_SOURCE_DIR "/tests/core/mesh/files/read_with_vtk.py", path, folder_.path()});
        constexpr int patience = 120'000;
        started_ = process.waitForStarted() && process.waitForFinished(patience);
        exitCode_ = started_ && process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
        told_ = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        messages_ = process.readAllStandardError();
    }

    /// Without python3-vtk9 there is nothing to compare with.
    bool isMissing() const { return !started_ || exitCode_ == 77; }
    bool ok() const { return exitCode_ == 0 && told_["errors"].toInt(-1) == 0; }
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

private:
    QTemporaryDir folder_;
    bool started_ = false;
    int exitCode_ = -1;
    QJsonObject told_;
    QByteArray messages_;
};

} // namespace tetra
