// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/picture_file.h"

namespace tetra {

bool writesTiff()
{
    return false;
}

Result<std::vector<std::byte>> tiffOf(const Picture&, const PngFacts&)
{
    return Error{ErrorKind::OutOfResource, Message::say("This TAn was built without libtiff, which writes TIFF files. "
                                                        "Save the picture as PNG.")};
}

} // namespace tetra
