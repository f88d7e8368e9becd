// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds arbitrary bytes to the reader of OpenDX: objects, numbers in text and bytes; `data file volume.dx` names the
// same file as another one.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const LatticeReader reader;
    const auto path = folder.write("volume.dx", asBytes(asText(bytes, size)));
    requireSound(reader.read(path, {}, {}));
    requireSound(reader.read(path, {{"array", std::string("2")}, {"component", std::string("1")}}, {}));
    for (const auto& name : reader.companions(path, {}))
        require(!name.empty(), "another file has a name");
    return 0;
}
