// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds arbitrary bytes to the NRRD reader: header, geometry, every encoding, components and steps.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const auto path = folder.write("volume.nrrd", asBytes(asText(bytes, size)));
    requireSound(LatticeReader().read(path, {}, {}));
    requireSound(LatticeReader().read(path, {{"component", std::string("1")}, {"time", std::int64_t(2)}}, {}));
    return 0;
}
