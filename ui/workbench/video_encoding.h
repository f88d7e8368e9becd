// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QStringList>

#include <filesystem>

namespace tetra {

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
