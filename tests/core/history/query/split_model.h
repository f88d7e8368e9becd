// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>
#include <tan/model.h>

#include <filesystem>
#include <memory>

namespace tetra {

/// A lattice's model as no Delaunay refinement makes it: each point only splits the tetrahedra that it lies in, worst
/// first, and nothing is flipped. For small lattices. What fails here fails the test.
std::shared_ptr<const Model> splitModel(const Dataset& dataset, const std::filesystem::path& path);

} // namespace tetra
