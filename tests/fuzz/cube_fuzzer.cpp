// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds arbitrary text to the reader of Gaussian cubes, with the first of their orbitals and with the second.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const LatticeReader reader;
    const auto path = folder.write("volume.cube", asBytes(asText(bytes, size)));
    requireSound(reader.read(path, {}, {}));
    requireSound(reader.read(path, {{"array", std::string("2")}}, {}));
    return 0;
}
