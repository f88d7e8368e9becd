// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/video_encoding.h"

#include "ui/session/target_path.h"

#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

namespace tetra {
namespace {

constexpr int askEncoderEvery = 100; // milliseconds
constexpr int endWithin = 500;       // milliseconds
constexpr int mostErrorText = 600;   ///< characters, from the end

QString suffixOf(const QString& name)
{
    return QFileInfo(name).suffix().toLower();
}

Error encoderError(const QString& encoder, const QString& text)
{
    return {ErrorKind::CannotWrite,
            Message::say("The video could not be made: %1 says \"%2\". Choose another format, or PNG pictures.",
                         encoder.toStdString(), text.trimmed().right(mostErrorText).toStdString())};
}

} // namespace

QString findVideoEncoder()
{
    return QStandardPaths::findExecutable("ffmpeg");
}

bool isVideoFile(const std::filesystem::path& path)
{
    const QString suffix = suffixOf(pathText(path));
    return suffix == "mp4" || suffix == "webm";
}

QStringList encoderArguments(const QString& pattern, double framesPerSecond, const QString& output)
{
    QStringList arguments{"-nostdin",   "-y",
                          "-loglevel",  "error",
                          "-framerate", QString::number(framesPerSecond),
                          "-i",         pattern,
                          "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2", // 4:2:0 wants even sides
                          "-pix_fmt",   "yuv420p"};
    if (suffixOf(output) == "webm")
        arguments << "-c:v"
                  << "libvpx-vp9"
                  << "-crf"
                  << "24"
                  << "-b:v"
                  << "0";
    else
        arguments << "-c:v"
                  << "libx264"
                  << "-crf"
                  << "18"
                  << "-movflags"
                  << "+faststart";
    return arguments << output;
}

Status encodeVideo(const QString& encoder, const QStringList& arguments, const std::filesystem::path& folder,
                   const Progress& progress)
{
    QProcess process;
    process.setWorkingDirectory(pathText(folder));
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(encoder, arguments);
    if (!process.waitForStarted())
        return encoderError(encoder, process.errorString());
    while (!process.waitForFinished(askEncoderEvery) && process.state() != QProcess::NotRunning)
        if (progress.cancelled()) {
            process.kill();
            process.waitForFinished(endWithin);
            return cancelledError(Message::marked("The video"));
        }
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return encoderError(encoder, QString::fromLocal8Bit(process.readAllStandardError()));
    return {};
}

} // namespace tetra
