// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>

#include <functional>

namespace tetra {

/// What a run of `tan` left.
struct Run {
    int exitCode = -1; ///< -1 if it crashed
    QByteArray output;
    QByteArray messages;

    /// Standard output, which must be one JSON object and nothing else; an empty one otherwise.
    QJsonObject json() const { return QJsonDocument::fromJson(output).object(); }
};

inline QString tanProgram()
{
    return TAN_BINARY_DIR "/bin/tan";
}

/// Collects what an ended process left.
inline Run collect(QProcess& process)
{
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

/// Runs `tan` in `folder`, as a user would; `environment` adds variables; `prepare` is called in its process before.
inline Run runTan(const QStringList& words, const QString& folder, const QMap<QString, QString>& environment = {},
                  const std::function<void()>& prepare = {})
{
    constexpr int patience = 120'000;
    QProcess process;
    auto variables = QProcessEnvironment::systemEnvironment();
    for (auto at = environment.begin(); at != environment.end(); ++at)
        variables.insert(at.key(), at.value());
    process.setProcessEnvironment(variables);
    process.setWorkingDirectory(folder);
    process.setChildProcessModifier(prepare);
    process.start(tanProgram(), words);
    process.waitForFinished(patience);
    return collect(process);
}

} // namespace tetra
