// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_program.h"
#include "core/graphics/scene.h"

#include <span>

namespace tetra {

/// The length of the arrays in cut.frag and volume.frag.
inline constexpr std::size_t largestClipPlaneCount = 16;

Status checkClipPlanes(std::span<const ClipPlane> planes);

/// Sets the uniforms of cut.frag in the program in use, for places relative to `origin`.
void setCuts(const GlProgram& program, std::span<const ClipPlane> planes, const Eigen::Vector3d& origin);

} // namespace tetra
