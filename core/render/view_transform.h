// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <vector>

namespace tetra {

/// The samples [left, right) x [top, bottom) of a picture.
struct SampleRectangle {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    int width() const noexcept { return right - left; }
    int height() const noexcept { return bottom - top; }
    bool operator==(const SampleRectangle&) const = default;
};

inline SampleRectangle intersection(const SampleRectangle& a, const SampleRectangle& b)
{
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

inline bool isEmpty(const SampleRectangle& box)
{
    return box.left >= box.right || box.top >= box.bottom;
}

/// Where a sample lies, from the upper left corner of its square. Not quite in the middle, so that the corners and
/// faces of lattices, which views along an axis would put there, do not fall on samples.
inline constexpr double sampleX = 0.5 + 0.00137;
inline constexpr double sampleY = 0.5 + 0.00211;

/// A camera made ready to draw a picture of `width` x `height` pixels or samples.
///
/// How near a point is, is told by q = 1 / w in perspective, else -w, with its distance w from the eye along the view's
/// axis, in units of the camera's distance: q is affine in the picture on every plane, and larger is nearer.
struct ViewTransform {
    double width = 1;
    double height = 1;
    Eigen::Matrix4d clipFromWorld = Eigen::Matrix4d::Identity();
    bool perspective = true;
    /// The direction from what is seen towards the eye, not of unit length, in world coordinates, for a place in the
    /// picture measured from its upper left corner: towardsEye + x * towardsEyePerX + y * towardsEyePerY.
    Eigen::Vector3f towardsEye{0, 0, 1};
    Eigen::Vector3f towardsEyePerX{0, 0, 0};
    Eigen::Vector3f towardsEyePerY{0, 0, 0};
    /// The camera's axes: right, up, back.
    Eigen::Matrix3f cameraFromWorld = Eigen::Matrix3f::Identity();
    /// Of clip space: q = nearnessPerClip * z / w + nearnessAtZero, in perspective of 1 in place of z.
    double nearnessPerClip = -1;
    double nearnessAtZero = 0;
};

/// q of a point in clip space.
inline double nearnessOf(const ViewTransform& transform, const Eigen::Vector4d& clip)
{
    const double numerator = transform.perspective ? 1 : clip.z();
    return transform.nearnessPerClip * numerator / clip.w() + transform.nearnessAtZero;
}

ViewTransform makeViewTransform(const Camera& camera, double width, double height, const Eigen::AlignedBox3d& bounds);
/// The same view of a part of the picture, as a picture of its own.
ViewTransform partOf(const ViewTransform& whole, const SampleRectangle& part);

/// A line as a rectangle that faces the eye: four corners in clip space, in order around it.
using LineQuad = std::array<Eigen::Vector4d, 4>;

/// The visible segments of `lines` as rectangles `width` samples wide, at least one. The ends reach half a width
/// further, so that lines that meet close their corner. Both back ends draw these, since OpenGL's own lines may be one
/// pixel wide only. O(segments). May throw std::bad_alloc.
std::vector<LineQuad> thickLines(const LineSet& lines, const ViewTransform& transform, double width);

} // namespace tetra
