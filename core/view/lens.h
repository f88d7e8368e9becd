// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/view.h>

#include <Eigen/Core>

#include <array>
#include <span>

namespace tetra {

/// A lens in a picture of some size, in pixels: it shows a part of the same picture drawn larger.
struct LensPicture {
    PixelRectangle square; ///< of the picture that the lens covers, a circle up to its sides; may reach beyond
    int width = 0;         ///< of the enlarged picture
    int height = 0;
    PixelRectangle part; ///< of the enlarged picture, which is seen in the lens
    int left = 0;        ///< where that lies in the square
    int top = 0;
    double magnification = 1; ///< in fact: the enlarged picture is none that back ends refuse
    bool operator==(const LensPicture&) const = default;
};

TAN_INTERNAL LensPicture lensPicture(const LensState& lens, int width, int height);

/// Whether a place of the picture is in the lens.
TAN_INTERNAL bool holds(const LensState& lens, const LensPicture& picture, const Eigen::Vector2d& place);

/// The place of the picture that is seen at a place in the lens, in pixels.
TAN_INTERNAL Eigen::Vector2d placeUnder(const LensPicture& lens, const Eigen::Vector2d& place);

/// The four half-spaces whose common part, the frustum of the lens's square, holds all that is seen in the lens.
TAN_INTERNAL std::array<HalfSpace, 4> seenInLens(const LensPicture& lens, const Camera& camera);

/// The mesh of the lens: that of the picture, but of this error (%) where all the half-spaces meet, if that is smaller.
/// The budget of a picture is not the lens's: its mesh has at least the error that the budget allows for. A range of
/// accuracies stays as it is.
TAN_INTERNAL MeshQuery lensQuery(MeshQuery query, double error, std::span<const HalfSpace> frustum, const Model& model);

} // namespace tetra
