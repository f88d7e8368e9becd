// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the PLOT3D reader with a pair of files: a byte each for the scalar and for the number of the grid, two for the
// length of the grid file, and both files.
#include "plugins/readers/plot3d/plot3d_arrays.h"
#include "plugins/readers/plot3d/plot3d_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    constexpr std::size_t headBytes = 4;
    if (size < headBytes)
        return 0;
    static const FuzzFolder folder;
    const std::span files = std::as_bytes(std::span(bytes, size)).subspan(headBytes);
    const std::size_t gridBytes = std::min<std::size_t>(bytes[2] + 256 * bytes[3], files.size());
    const auto grid = folder.write("volume.xyz", files.first(gridBytes));
    const auto solution = folder.write("volume.q", files.subspan(gridBytes));
    const auto names = plot3dArrayNames();
    const std::size_t name = bytes[0] % (names.size() + 1);
    const ParameterValues values = {
        {"array", name < names.size() ? std::string(names[name]) : std::string("automatic")},
        {"grid", std::int64_t(bytes[1])}};
    const Plot3dReader reader;
    for (const auto& path : {grid, solution})
        requireSound(reader.read(path, values, {}));
    return 0;
}
