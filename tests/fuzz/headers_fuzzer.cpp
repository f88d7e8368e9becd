// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds MetaImages, NIfTI files and pairs, and MRC maps to their reader: a byte for the name, one for the time step,
// two for the length of the file that is opened, and two files, of which the second holds samples.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

#include <array>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    constexpr std::array opened = {"image.mhd", "image.nii", "pair.hdr", "image.map"};
    constexpr std::array samples = {"image.raw", "image.raw", "pair.img", "image.raw"};
    constexpr std::size_t headBytes = 4;
    if (size < headBytes)
        return 0;
    static const FuzzFolder folder;
    const std::size_t kind = bytes[0] % opened.size();
    const std::span files = std::as_bytes(std::span(bytes, size)).subspan(headBytes);
    const std::size_t firstBytes = std::min<std::size_t>(bytes[2] + 256 * bytes[3], files.size());
    const auto path = folder.write(opened[kind], files.first(firstBytes));
    folder.write(samples[kind], files.subspan(firstBytes));
    ParameterValues values;
    if (bytes[1] > 1)
        values = {{"time", std::int64_t(bytes[1] % 16)}, {"component", std::to_string(bytes[1] / 16)}};
    const LatticeReader reader;
    const auto contents = reader.probe(path, values, {});
    if (!contents)
        requireText(contents.error());
    const auto dataset = reader.read(path, values, {});
    require(contents.ok() || !dataset.ok(), "what is refused at once is not read");
    requireSound(dataset);
    return 0;
}
