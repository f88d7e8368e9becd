// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of bricks of values with a header up to an empty line, and its data file behind it.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const LatticeReader reader;
    const std::string_view text = asText(bytes, size);
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    const std::string_view data = text.substr(std::min(end + 2, text.size()));
    for (const char* const name : {"volume.values", "volume.values.gz"})
        folder.write(name, asBytes(data));
    const auto path = folder.write("volume.bov", asBytes(text.substr(0, end)));
    requireSound(reader.read(path, {}, {}));
    requireSound(reader.read(path, {{"component", std::string("1")}}, {}));
    return 0;
}
