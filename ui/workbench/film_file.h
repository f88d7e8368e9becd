// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/film.h"

#include <tan/base.h>

#include <QStringList>

#include <filesystem>
#include <vector>

namespace tetra {

/// A film to write.
struct FilmOrder : Film {
    std::filesystem::path target{}; ///< a video, or name.png for name_0001.png and so on
    QString encoder{};              ///< of videos
};

/// The file of a frame: NAME_0001.png, of as many digits as `count` needs, four at least.
std::filesystem::path framePath(const std::filesystem::path& target, int frame, int count);

/// Existing files that the film would replace. O(files in the folder), which may lie far away: not for the
/// GUI thread.
std::vector<std::filesystem::path> filesInTheWay(const std::filesystem::path& target, int count);

/// Draws all frames into a folder beside the target; when all are done they take their names, or become the video.
/// Cancelled or failed it leaves nothing behind, and what was there stays.
Status writeFilm(const FilmOrder& order, const Progress& progress);

/// The ffmpeg program in PATH; empty if there is none.
QString findVideoEncoder();

/// Whether the name is that of a video that encodeVideo() writes: .mp4 (H.264) or .webm (VP9), both in yuv420p.
bool isVideoFile(const std::filesystem::path& path);

/// What the program is told, run in the folder of the frames: `pattern` as in "%06d.png".
QStringList encoderArguments(const QString& pattern, double framesPerSecond, const QString& output);

/// Runs it, without a shell, and shows what it has to say against it. Ends it within a second when cancelled.
Status encodeVideo(const QString& encoder, const QStringList& arguments, const std::filesystem::path& folder,
                   const Progress& progress);

} // namespace tetra
