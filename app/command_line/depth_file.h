// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <filesystem>

namespace tetra {

/// What the greys of a picture of depths mean.
struct DepthScale {
    double nearest = 0;  ///< of grey 0, in units of the dataset
    double farthest = 0; ///< of grey 65534; linear between
};

/// Writes Picture::depth as a grey PNG of 16 bits, which every picture viewer opens; 65535 is nothing seen. The file's
/// text chunks "nearest" and "farthest" hold the scale, which is also returned: 0 to 0 if nothing is seen at all.
Result<DepthScale> writeDepth(const std::filesystem::path& path, const Picture& picture);

} // namespace tetra
