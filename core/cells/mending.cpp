// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/mending.h"

#include <string_view>

namespace tetra {

namespace {

class Remarks {
public:
    /// "3 cells were left out: ..." or "1 cell was left out: ..."
    void add(std::uint64_t count, std::string_view one, std::string_view several, std::string_view rest)
    {
        if (count > 0)
            sentences.push_back(std::to_string(count) + " " + std::string(count == 1 ? one : several) +
                                std::string(rest));
    }
    std::vector<std::string> sentences;
};

} // namespace

std::vector<std::string> mendingRemarks(const Mending& mending)
{
    Remarks remarks;
    if (mending.cellValues)
        remarks.sentences.emplace_back("The values belong to cells: each point got the mean of the cells around it.");
    remarks.add(mending.flatShapes, "cell is", "cells are",
                " a vertex, line or polygon without volume and not part of the mesh.");
    remarks.add(mending.blanked, "cell is", "cells are", " blanked out in the file: a hole.");
    remarks.add(mending.notFinite, "cell has", "cells have", " a value that is not finite and became a hole.");
    remarks.add(mending.repeated, "cell names a corner twice, has no volume and was",
                "cells name a corner twice, have no volume and were", " left out.");
    remarks.add(mending.flat, "cell without volume was", "cells without volume were", " left out.");
    if (mending.turned > 0 && mending.turned == mending.cells)
        remarks.sentences.emplace_back("All cells had inverted orientation and were corrected.");
    else
        remarks.add(mending.turned, "cell had inverted orientation and was", "cells had inverted orientation and were",
                    " corrected.");
    remarks.add(mending.welded, "point", "points", " on the place of another one joined with it.");
    remarks.add(mending.conflicting, "place had", "places had", " different values and got their mean.");
    remarks.add(mending.middles, "node in the middle of an edge or face was",
                "nodes in the middle of edges and faces were",
                " left out: not all cells there have them, or cells bend too much.");
    remarks.add(mending.recut, "cell was", "cells were", " cut along other diagonals, because the faces are not flat.");
    remarks.add(mending.warped, "cell was", "cells were",
                " left out: too warped to be cut into tetrahedra without a new point.");
    remarks.add(mending.duplicates, "tetrahedron was", "tetrahedra were", " there twice.");
    remarks.add(mending.pinching, "tetrahedron was", "tetrahedra were",
                " left out where parts of the mesh touched in an edge or a point only.");
    remarks.add(mending.unused, "point is", "points are", " of no cell: left out.");
    return std::move(remarks.sentences);
}

} // namespace tetra
