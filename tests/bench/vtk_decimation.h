// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/plain_mesh.h"

#include <QString>

#include <optional>
#include <vector>

namespace tetra {

/// What vtkUnstructuredGridQuadricDecimation makes of a file's tetrahedra.
struct VtkDecimation {
    struct Level {
        double share = 0; ///< of the tetrahedra, asked for
        double seconds = 0;
        PlainMesh mesh;
    };
    PlainMesh original;
    std::vector<Level> levels;
};

/// In a process of its own, by the Python packages of VTK. None where these are not installed.
std::optional<VtkDecimation> decimateByVtk(const QString& file, const std::vector<double>& shares);

} // namespace tetra
