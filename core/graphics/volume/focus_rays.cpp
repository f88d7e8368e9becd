// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/focus_rays.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

using Eigen::Vector3d;

constexpr double everywhere = std::numeric_limits<double>::infinity();

double distanceFromBox(const Vector3d& place, const Vector3d& halfSize)
{
    return (place.cwiseAbs() - halfSize).cwiseMax(0).norm();
}

} // namespace

FocusRays::FocusRays(const FocusVolume& focus, const VolumeView& view)
    : region_(focus.region), border_(std::max(0.0, focus.border)), perspective_(view.perspective),
      nearest_(view.perspective ? view.nearest : -everywhere), firstX_(view.firstX()), firstY_(view.firstY()),
      worldFromImage_(view.imageFromWorld.leftCols<3>().inverse())
{
    if (const Sphere* const ball = std::get_if<Sphere>(&region_)) {
        centre_ = ball->centre;
        radius_ = std::max(0.0, ball->radius);
    } else {
        const Box& box = std::get<Box>(region_);
        centre_ = (box.least + box.largest) / 2;
        halfSize_ = (box.largest - box.least).cwiseMax(0) / 2;
    }
    origin_ = -(worldFromImage_ * view.imageFromWorld.col(3)) - centre_;
}

FocusRays::Ray FocusRays::rayOf(int column, int row) const
{
    const Vector3d place(column + firstX_, row + firstY_, 1);
    if (perspective_)
        return {origin_, worldFromImage_ * place};
    return {origin_ + worldFromImage_.leftCols<2>() * place.head<2>(), worldFromImage_.col(2)};
}

std::pair<double, double> FocusRays::within(const Ray& ray, double margin) const
{
    const auto& [start, direction] = ray;
    if (std::holds_alternative<Sphere>(region_)) {
        const double squared = direction.squaredNorm();
        const double nearest = -start.dot(direction) / squared;
        const double radius = radius_ + margin;
        const double rest = radius * radius - (start + nearest * direction).squaredNorm();
        const double half = rest > 0 ? std::sqrt(rest / squared) : 0;
        return {nearest - half, nearest + half};
    }
    double first = -everywhere, last = everywhere;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = halfSize_[axis] + margin;
        if (direction[axis] == 0) {
            if (std::abs(start[axis]) > size)
                return {0, 0};
            continue;
        }
        const double one = (-size - start[axis]) / direction[axis], other = (size - start[axis]) / direction[axis];
        first = std::max(first, std::min(one, other));
        last = std::min(last, std::max(one, other));
    }
    return {first, last};
}

FocusRays::Passage FocusRays::at(int column, int row) const
{
    const Ray ray = rayOf(column, row);
    const auto [enter, leave] = within(ray, border_);
    if (!(leave > enter && leave > nearest_))
        return {0, 0, 0, 0};
    const auto [in, out] = within(ray, 0);
    Passage passage{enter, in, out, leave};
    if (!(out > in))
        passage.in = passage.out = (enter + leave) / 2;
    for (double* const place : {&passage.enter, &passage.in, &passage.out})
        *place = std::max(*place, nearest_);
    return passage;
}

FocusWeights FocusRays::weightsFrom(int column, int row) const
{
    constexpr double steepest = 1e30;
    const Ray first = rayOf(column, row), right = rayOf(column + 1, row), below = rayOf(column, row + 1);
    FocusWeights weights;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        const auto affine = [&](FocusWeights::Affine& to, const Vector3d Ray::*part) {
            to.origin[axis] = static_cast<float>((first.*part)[i]);
            to.perColumn[axis] = static_cast<float>((right.*part)[i] - (first.*part)[i]);
            to.perRow[axis] = static_cast<float>((below.*part)[i] - (first.*part)[i]);
        };
        affine(weights.start, &Ray::start);
        affine(weights.direction, &Ray::direction);
        weights.halfSize[axis] = static_cast<float>(halfSize_[i]);
    }
    weights.radius = static_cast<float>(radius_);
    weights.perBorder = static_cast<float>(border_ > 0 ? std::min(1 / border_, steepest) : steepest);
    return weights;
}

bool FocusRays::holds(const Eigen::Vector3f& place) const
{
    const Vector3d fromCentre = place.cast<double>() - centre_;
    return std::holds_alternative<Sphere>(region_) ? fromCentre.norm() <= radius_
                                                   : distanceFromBox(fromCentre, halfSize_) == 0;
}

} // namespace tetra
