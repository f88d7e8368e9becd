// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/view_transform.h"

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// Samples are divided into this many steps an axis; corners are rounded to them or coarser, so that the tests of the
/// rasteriser are exact integers.
inline constexpr int subsampleBits = 11;
inline constexpr int subsampleSteps = 1 << subsampleBits;

/// A corner in the picture.
struct ScreenVertex {
    std::int32_t x = 0; ///< in steps of 1 / subsampleSteps sample from the part's left ...
    std::int32_t y = 0; ///< ... and upper edge
    float nearness = 0; ///< larger is nearer, affine in the picture: q of ViewTransform
    float weight = 1;   ///< 1 / w: attributes times weight are affine in the picture
    Eigen::Vector3f normal{0, 0, 1};
};

/// What triangles of a surface have in common.
struct SurfaceLook {
    Colour colour;
    float opacity = 1;
    bool lit = true;
    bool clipped = true;               ///< by clip planes
    bool coloured = false;             ///< at each vertex by itself
    const FocusShare* share = nullptr; ///< Surface::share
    bool isOpaque() const noexcept { return opacity >= 1 && share == nullptr; }
};

struct ScreenTriangle {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t look; ///< number of one
};

/// q of the first overlay, nearer than everything else; each further one is a little nearer than the one before.
inline constexpr float overlayNearness = 1e9f;

/// A scene projected into a part of a picture: all that the tiles need. Triangles are in the order of the scene; those
/// outside the part or turned away from it as the surface does not want are left out, those that reach behind the eye
/// or far beyond the picture are cut.
struct DrawList {
    Buffer<ScreenVertex> vertices;
    Buffer<Colour> colours; ///< of vertices whose look is coloured, at their places; may end before them
    Buffer<ScreenTriangle> triangles;
    std::vector<SurfaceLook> looks;
};

/// Where surfaces are looked at, and how exactly.
enum class SamplePlaces {
    /// In the middle of their squares, corners rounded to 1/256 sample: as OpenGL does.
    Middle,
    /// At sampleX and sampleY, corners rounded to 1/2048 sample: where the rays through a volume are.
    Rays,
};

/// `transform` is of the whole picture, so that a part has the very corners that the whole has there. O(vertices +
/// triangles), on all threads of the current arena. Incomplete if cancelled. Errors: a scene whose indices lead
/// nowhere. May throw std::bad_alloc.
Result<DrawList> makeDrawList(const Scene& scene, const ViewTransform& transform, const SampleRectangle& part,
                              double samplesPerPixelAxis, SamplePlaces places, const Progress& progress);

} // namespace tetra
