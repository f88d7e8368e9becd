// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ordered_mesh.h"

namespace tetra {

Result<std::shared_ptr<const TetrahedralMesh>> OrderedMesh::ordered(const Progress& progress)
{
    if (!ordered_) {
        auto made = inSpatialOrder(*original_, progress);
        if (!made)
            return made.error();
        ordered_ = std::make_shared<const TetrahedralMesh>(*std::move(made));
    }
    return ordered_;
}

} // namespace tetra
