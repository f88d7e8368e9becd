// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/film_file.h"

#include "core/base/file_writer.h"
#include "core/base/finished_file.h"
#include "core/base/folder.h"
#include "core/base/system_error.h"
#include "core/base/work_folder.h"
#include "ui/session/files.h"

#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QString>

#include <algorithm>

namespace tetra {
namespace {

constexpr int leastDigits = 4;
constexpr double drawingPart = 0.93; ///< of the time of a video
constexpr const char* framePattern = "%06d.png";

std::filesystem::path numbered(const std::filesystem::path& folder, int frame)
{
    return folder / QString::asprintf(framePattern, frame).toStdString();
}

Status drawFrames(const FilmOrder& order, const std::filesystem::path& folder, const Progress& progress)
{
    FilmFrames frames;
    const int count = frameCount(order.view.animation);
    for (int i = 0; i < count; ++i) {
        progress.report(static_cast<double>(i) / count, {});
        const auto picture = frames.draw(order, i, progress.withCallback({}));
        if (!picture)
            return picture.error();
        if (progress.cancelled())
            return cancelledError(Message::marked("The film"));
        if (const Status written = writePicture(*picture, numbered(folder, i), pngFacts(order.picture)); !written)
            return written;
    }
    return {};
}

Status nameFrames(const FilmOrder& order, const std::filesystem::path& folder)
{
    const int count = frameCount(order.view.animation);
    for (int i = 0; i < count; ++i)
        if (const Status moved = replaceFile(numbered(folder, i), framePath(order.target, i, count)); !moved)
            return moved;
    return {};
}

Status encode(const FilmOrder& order, const std::filesystem::path& folder, const Progress& progress)
{
    std::filesystem::path film = "film";
    film += order.target.extension();
    const auto arguments = encoderArguments(framePattern, order.view.animation.framesPerSecond, pathText(film));
    progress.report(0, {});
    if (const Status encoded = encodeVideo(order.encoder, arguments, folder, progress); !encoded)
        return encoded;
    return replaceFile(folder / film, order.target);
}

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

std::filesystem::path framePath(const std::filesystem::path& target, int frame, int count)
{
    const int digits = std::max(leastDigits, static_cast<int>(QString::number(count).size()));
    const QString number = QString("%1").arg(frame + 1, digits, 10, QChar('0'));
    return target.parent_path() / filePath(pathText(target.stem()) + '_' + number + pathText(target.extension()));
}

std::vector<std::filesystem::path> filesInTheWay(const std::filesystem::path& target, int count)
{
    std::error_code failed;
    if (isVideoFile(target))
        return std::filesystem::exists(target, failed) ? std::vector{target} : std::vector<std::filesystem::path>();
    const QString begin = pathText(target.stem()) + '_';
    const QString end = pathText(target.extension());
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& path : pathsIn(target.parent_path(), failed)) {
        const QString name = pathText(path.filename());
        if (!name.startsWith(begin) || !name.endsWith(end))
            continue;
        const int frame = name.mid(begin.size()).chopped(end.size()).toInt();
        if (frame > 0 && frame <= count && filePath(name) == framePath(target, frame - 1, count).filename())
            files.push_back(target.parent_path() / filePath(name));
    }
    std::ranges::sort(files);
    return files;
}

Status writeFilm(const FilmOrder& order, const Progress& progress)
{
    if (frameCount(order.view.animation) == 0)
        return Error{ErrorKind::WrongUsage, Message::say("A film needs at least two key frames. Add another view.")};
    std::filesystem::path beside = behindLinks(order.target);
    beside += ".frames";
    const auto folder = WorkFolder::open(beside, WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    const bool isVideo = isVideoFile(order.target);
    if (const Status drawn = drawFrames(order, folder->path(), progress.part(0, isVideo ? drawingPart : 1)); !drawn)
        return drawn;
    if (const Status right = order.model->confirm(progress.withCallback({})); !right)
        return right;
    return isVideo ? encode(order, folder->path(), progress.part(drawingPart, 1)) : nameFrames(order, folder->path());
}

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
