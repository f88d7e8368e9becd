// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds arbitrary bytes to the reader of NumPy's arrays: header, types, both orders.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    requireSound(LatticeReader().read(folder.write("volume.npy", asBytes(asText(bytes, size))), {}, {}));
    return 0;
}
