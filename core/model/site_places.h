// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/result.h"
#include "core/model/model.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace tetra {

/// What the meshes of all kinds of queries are filled with: of the first `sites` sites, not more than the model has.
/// Results take the place of what was in the buffers. They do not ask whether the file changed meanwhile
/// (Model::checkIntact()): whoever puts a mesh together does that at its end.

/// Where sites lie in physical space, rounded to floats. Errors: a damaged file.
Status placeSites(const Model& model, std::uint32_t sites, Buffer<Eigen::Vector3f>& positions);

/// The values of sites, rounded to floats. Errors: a damaged file.
Status copyValues(const Model& model, std::uint32_t sites, Buffer<float>& values);

/// Makes tetrahedra that are positive in the space that the model was made in positive in physical space.
void turnToPhysicalSpace(const Model& model, std::span<std::array<std::uint32_t, 4>> tetrahedra);

/// That numbers in the model's file contradict each other, or that it changed meanwhile: `what` is the end of a
/// sentence.
Error inconsistentModel(const Model& model, const std::string& what);

} // namespace tetra
