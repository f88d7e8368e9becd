// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the texts that TIFF files hold about their pages: a byte for the kind, and the text.
#include "plugins/readers/images/tiff/image_description.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    if (size == 0)
        return 0;
    const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
    const auto requireSound = [](const PictureDescription& description) {
        const bool isBounded = description.channels >= 1 && description.slices >= 1 && description.times >= 1 &&
                               description.planeCount() <= mostPlanes;
        const std::uint64_t last =
            description.plane(description.channels - 1, description.slices - 1, description.times - 1);
        if (!isBounded || last + 1 != description.planeCount())
            std::abort();
        for (const auto& length : description.spacing)
            if (length && !(*length >= 0))
                std::abort();
    };
    if (bytes[0] % 2 == 0) {
        requireSound(imageJDescription(text, {10.0, 10.0}, bytes[0] % 4 == 0));
        return 0;
    }
    const auto description = omeDescription(text, bytes[0] / 64, "a.ome.tif");
    if (description)
        requireSound(*description);
    else
        requireText(description.error());
    return 0;
}
