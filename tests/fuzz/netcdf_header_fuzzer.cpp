// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds what looks through the header of a classic NetCDF file before its library does.
#include "plugins/readers/netcdf/classic_check.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    if (size == 0)
        return 0;
    static const FuzzFolder folder;
    const auto path = folder.write("grid.nc", std::as_bytes(std::span(bytes, size)));
    if (const auto checked = checkClassicNetCdf(path); !checked)
        requireText(checked.error());
    return 0;
}
