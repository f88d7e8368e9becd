// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/lens.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Back ends draw no larger ones.
constexpr double largestSide = 32767;
constexpr double errorBeside = 100; ///< %; outside of the frustum

int rounded(double number)
{
    return static_cast<int>(std::lround(number));
}

} // namespace

LensState corrected(LensState lens, const LensState& before)
{
    struct Limits {
        double LensState::*member;
        double least, largest;
    };
    for (const auto& [member, least, largest] :
         {Limits{&LensState::x, 0, 1}, Limits{&LensState::y, 0, 1},
          Limits{&LensState::radius, leastLensRadius, largestLensRadius},
          Limits{&LensState::magnification, leastMagnification, largestMagnification},
          Limits{&LensState::error, 0, 100}})
        lens.*member = std::clamp(std::isfinite(lens.*member) ? lens.*member : before.*member, least, largest);
    return lens;
}

LensPicture lensPicture(const LensState& lens, int width, int height)
{
    LensPicture result;
    result.magnification = std::max(1.0, std::min(lens.magnification, largestSide / std::max(width, height)));
    result.width = rounded(width * result.magnification);
    result.height = rounded(height * result.magnification);
    const int radius = std::max(1, rounded(lens.radius * std::min(width, height)));
    result.square = {rounded(lens.x * width) - radius, rounded(lens.y * height) - radius, 2 * radius, 2 * radius};
    // Around the same place of the enlarged picture, as far as that reaches.
    const int left = rounded(lens.x * result.width) - radius, top = rounded(lens.y * result.height) - radius;
    result.left = std::max(0, -left);
    result.top = std::max(0, -top);
    result.part = {left + result.left, top + result.top,
                   std::min(2 * radius - result.left, result.width - left - result.left),
                   std::min(2 * radius - result.top, result.height - top - result.top)};
    return result;
}

bool holds(const LensState& lens, const LensPicture& picture, const Eigen::Vector2d& place)
{
    const double radius = picture.square.width / 2.0;
    const Eigen::Vector2d fromMiddle =
        place - Eigen::Vector2d(picture.square.left + radius, picture.square.top + radius);
    switch (lens.shape) {
    case LensState::Shape::Circle: return fromMiddle.norm() <= radius;
    case LensState::Shape::Square: return fromMiddle.cwiseAbs().maxCoeff() <= radius;
    default: return false;
    }
}

Eigen::Vector2d placeUnder(const LensPicture& lens, const Eigen::Vector2d& place)
{
    const Eigen::Vector2d inEnlarged(place.x() - lens.square.left - lens.left + lens.part.left,
                                     place.y() - lens.square.top - lens.top + lens.part.top);
    return inEnlarged / lens.magnification;
}

std::array<HalfSpace, 4> seenInLens(const LensPicture& lens, const Camera& camera)
{
    const Eigen::Matrix4d view = viewMatrix(camera);
    const Eigen::Matrix4d projection = projectionMatrix(camera, static_cast<double>(lens.width) / lens.height, {});
    // Where the part ends to the left, right, top and bottom: one unit before the eye, or without perspective anywhere.
    const auto across = [&](int pixel, int all, int axis) {
        return (2.0 * pixel / all - 1) * (axis == 0 ? 1 : -1) / projection(axis, axis);
    };
    const std::array ends{
        across(lens.part.left, lens.width, 0), across(lens.part.left + lens.part.width, lens.width, 0),
        across(lens.part.top, lens.height, 1), across(lens.part.top + lens.part.height, lens.height, 1)};
    std::array<HalfSpace, 4> planes;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        // In the eye's coordinates, z towards the viewer: sign * place <= sign * end, times the distance -z.
        const double sign = i == 0 || i == 3 ? -1 : 1;
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        normal[i < 2 ? 0 : 1] = sign;
        normal.z() = camera.perspective ? sign * ends[i] : 0;
        const double offset = camera.perspective ? 0 : sign * ends[i];
        const double length = normal.norm();
        planes[i].normal = view.topLeftCorner<3, 3>().transpose() * normal / length;
        planes[i].offset = (offset - normal.dot(view.topRightCorner<3, 1>())) / length;
    }
    return planes;
}

MeshQuery lensQuery(MeshQuery query, double error, std::span<const HalfSpace> frustum, const Model& model)
{
    if (query.range)
        return query;
    const bool warps = model.description().warpingWeight > 0;
    const bool warpsAlike = query.warping == query.error;
    const bool anyWarps = query.warping.isConstant() && query.warping.bounds().minimum >= anyWarping;
    if (query.budget) {
        query.error = errorWithin(model, *query.budget);
        query.budget.reset();
        if (!anyWarps)
            query.warping = query.error;
    }
    if (frustum.empty() || error >= query.error.bounds().maximum)
        return query;
    const auto refined = [&](const ErrorField& field) {
        const double within = std::min(error, field.bounds().maximum);
        ErrorField inside = SpaceRamp{frustum.front(), within, errorBeside, 0};
        for (const HalfSpace& plane : frustum.subspan(1))
            inside = largerOf(inside, SpaceRamp{plane, within, errorBeside, 0});
        return smallerOf(field, inside);
    };
    const ErrorField fine = refined(query.error);
    if (warps && !anyWarps)
        query.warping = warpsAlike ? fine : refined(query.warping);
    query.error = fine;
    return query;
}

} // namespace tetra
