// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for the text of a camera and of clip planes; what is read comes back from its text.
#include "tests/fuzz/fuzz_input.h"

#include <tan/render.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    const Eigen::AlignedBox3d bounds(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(31, 31, 31));
    const std::string_view text = asText(bytes, size);
    if (const auto camera = cameraFromText(text, bounds)) {
        const std::string written = cameraToText(*camera);
        const auto again = cameraFromText(written, bounds);
        require(again && cameraToText(*again) == written, "a camera comes back");
    } else {
        requireText(camera.error());
    }
    if (const auto planes = parseClipPlanes(text)) {
        const std::string written = clipPlanesText(*planes);
        const auto again = parseClipPlanes(written);
        require(again && clipPlanesText(*again) == written, "clip planes come back");
    } else {
        requireText(planes.error());
    }
    return 0;
}
