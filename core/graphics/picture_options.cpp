// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/picture_options.h"

#include <algorithm>
#include <string>

namespace tetra {

Status checkOptions(const PictureOptions& options)
{
    if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > largestPictureSide)
        return Error{ErrorKind::WrongUsage, "A picture cannot be " + std::to_string(options.width) + " x " +
                                                std::to_string(options.height) + " pixels. Each side must be 1 to " +
                                                std::to_string(largestPictureSide) + "."};
    if (options.samplesPerAxis < 1 || options.samplesPerAxis > 4)
        return Error{ErrorKind::WrongUsage, "The samples per axis of a pixel must be 1 to 4."};
    if (options.threads < 0)
        return Error{ErrorKind::WrongUsage, "The number of threads must not be negative; 0 means all."};
    return {};
}

} // namespace tetra
