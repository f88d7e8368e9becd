// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of cells of mixed shapes: a VTK XML file if the bytes begin as one, else AVS UCD.
#include "plugins/readers/cells/cells_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const std::string_view text = asText(bytes, size);
    const auto path = folder.write(text.starts_with('<') ? "cells.vtu" : "cells.inp", asBytes(text));
    const CellsReader reader;
    reader.score(path, asBytes(text.substr(0, 4096)));
    const auto dataset = reader.read(path, {}, {});
    requireSound(dataset);
    if (!dataset)
        return 0;
    require(dataset->tetrahedra && !dataset->tetrahedra->empty(), "a mesh has tetrahedra");
    for (const auto& tetrahedron : *dataset->tetrahedra)
        require(*std::ranges::max_element(tetrahedron) < dataset->pointCount(), "tetrahedra are of points");
    return 0;
}
