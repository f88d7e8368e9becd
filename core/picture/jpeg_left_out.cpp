// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/picture_file.h"

namespace tetra {

bool writesJpeg()
{
    return false;
}

Result<std::vector<std::byte>> jpegOf(const Picture&, const PngFacts&)
{
    return Error{ErrorKind::OutOfResource, Message::say("This TAn was built without libjpeg, which writes JPEG files. "
                                                        "Save the picture as PNG.")};
}

} // namespace tetra
