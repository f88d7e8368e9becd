// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/query_state.h"

#include <tan/query.h>
#include <tan/render.h>

#include <array>
#include <optional>
#include <span>

namespace tetra {

/// A lens over the picture (C5; "magnify" in 5.1 of the paper): what lies under its middle, enlarged, and of a mesh
/// that is finer there. It lies in the picture, not in space: the camera moves beneath it.
struct LensState {
    enum class Shape { None, Circle, Square };
    Shape shape = Shape::None;
    double x = 0.5;           ///< of the middle, as a share of the picture's width from the left ...
    double y = 0.5;           ///< ... and of its height from above
    double radius = 0.25;     ///< half of a side, as a share of the picture's shorter side
    double magnification = 3; ///< see lensPicture()
    double error = 0.25;      ///< of the mesh in it, % of the value range; see lensQuery()
    bool operator==(const LensState&) const = default;

    bool isOn() const noexcept { return shape != Shape::None; }
};

inline constexpr std::array<const char*, 3> lensShapeNames{"none", "circle", "square"};
inline constexpr double leastMagnification = 1;
inline constexpr double largestMagnification = 16;
inline constexpr double leastLensRadius = 0.05;
inline constexpr double largestLensRadius = 0.5;

/// Within these limits and within the picture; what is not a number is as it was `before`.
LensState corrected(LensState lens, const LensState& before);

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

LensPicture lensPicture(const LensState& lens, int width, int height);

/// Whether a place of the picture is in the lens.
bool holds(const LensState& lens, const LensPicture& picture, const Eigen::Vector2d& place);

/// The place of the picture that is seen at a place in the lens, in pixels.
Eigen::Vector2d placeUnder(const LensPicture& lens, const Eigen::Vector2d& place);

/// The four half-spaces whose common part, the frustum of the lens's square, holds all that is seen in the lens.
std::array<HalfSpace, 4> seenInLens(const LensPicture& lens, const Camera& camera);

/// The mesh of the lens: that of the picture, but of this error (%) where all the half-spaces meet, if that is smaller.
/// The budget of a picture is not the lens's: its mesh has at least the error that the budget allows for. A range of
/// accuracies stays as it is.
MeshQuery lensQuery(MeshQuery query, double error, std::span<const HalfSpace> frustum, const Model& model);

} // namespace tetra
