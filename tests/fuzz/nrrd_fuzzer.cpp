// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds arbitrary bytes to the NRRD reader: header, geometry, every encoding.
#include "tests/fuzz/fuzz_input.h"
#include "tests/plugins/readers/lattice/nrrd_in_memory.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    tetra::requireSound(tetra::readNrrdInMemory(tetra::asText(bytes, size)));
    return 0;
}
