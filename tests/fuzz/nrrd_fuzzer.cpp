// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds arbitrary bytes to the NRRD reader: header, geometry, every encoding.
#include "tests/plugins/readers/lattice/nrrd_in_memory.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const auto dataset = tetra::readNrrdInMemory({reinterpret_cast<const char*>(bytes), size});
    if (dataset && dataset->values.count() != dataset->lattice.pointCount())
        std::abort();
    return 0;
}
