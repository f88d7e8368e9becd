// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/reproduction.h"

#include <filesystem>
#include <vector>

namespace tetra {

/// Draws Fig. 10 (sites against error, ours as lines, the paper's tables as rings) and Fig. 11 (the vertices of
/// BluntFin, all and those of the mesh at 2 %, 2 %) into `folder`, each as PNG and as SVG, and the pictures of Fig. 13
/// to 15 as PNG, as far as the reproduction has the models. Gives the files written.
/// Errors: a file that cannot be written, no font.
Result<std::vector<std::filesystem::path>> drawFigures(const Reproduction& reproduction,
                                                       const std::filesystem::path& folder);

} // namespace tetra
