// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/volume/ray_integrator.h"

#include "core/render/volume/volume_view.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra::testing {
namespace {

using Eigen::Vector3d;

Eigen::AlignedBox3d boundsOf(const TetrahedralMesh& mesh)
{
    Eigen::AlignedBox3d bounds;
    for (const auto& position : mesh.positions)
        if (position.allFinite())
            bounds.extend(Vector3d(position.cast<double>()));
    return bounds;
}

bool isUsable(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& corners)
{
    return std::ranges::all_of(corners, [&](std::uint32_t corner) {
        return mesh.positions[corner].allFinite() && std::isfinite(mesh.values[corner]);
    });
}

Eigen::Matrix3d edgesOf(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& corners)
{
    Eigen::Matrix3d edges;
    for (int i = 0; i < 3; ++i)
        edges.col(i) = mesh.positions[corners[static_cast<std::size_t>(i) + 1]] - mesh.positions[corners[0]];
    return edges;
}

/// For light, at each vertex.
std::vector<Vector3d> gradientsForLight(const TetrahedralMesh& mesh)
{
    std::vector<Vector3d> sums(mesh.positions.size(), Vector3d::Zero());
    std::vector<double> volumes(sums.size(), 0);
    for (const auto& corners : mesh.tetrahedra) {
        const Eigen::Matrix3d edges = edgesOf(mesh, corners);
        const double volume = std::abs(edges.determinant());
        if (!isUsable(mesh, corners) || volume == 0)
            continue;
        Vector3d rises;
        for (int i = 0; i < 3; ++i)
            rises[i] = double(mesh.values[corners[static_cast<std::size_t>(i) + 1]]) - mesh.values[corners[0]];
        const Vector3d gradient = edges.inverse().transpose() * rises;
        for (const std::uint32_t corner : corners) {
            sums[corner] += volume * gradient;
            volumes[corner] += volume;
        }
    }
    double longest = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (volumes[i] > 0)
            sums[i] /= volumes[i];
        longest = std::max(longest, sums[i].norm());
    }
    for (Vector3d& gradient : sums)
        gradient /= longest > 0 ? longest : 1;
    return sums;
}

} // namespace

RayIntegrator::RayIntegrator(const TetrahedralMesh& mesh, const TransferFunction& function, const Camera& camera,
                             int width, int height, RayScene scene)
    : function_(function), camera_(camera), width_(width), height_(height), scene_(std::move(scene)),
      bounds_(boundsOf(mesh).merged(scene_.bounds))
{
    worldFromClip_ = (projectionMatrix(camera, double(width) / height, bounds_) * viewMatrix(camera)).inverse();
    const auto onNearPlane = [this](double x, double y) -> Vector3d {
        return (worldFromClip_ * Eigen::Vector4d(x, y, -1, 1)).hnormalized();
    };
    const Vector3d right = (onNearPlane(1, 0) - onNearPlane(0, 0)).normalized();
    const Vector3d up = (onNearPlane(0, 1) - onNearPlane(0, 0)).normalized();
    cameraFromWorld_ << right.transpose(), up.transpose(), right.cross(up).transpose();
    for (const OpacityPoint& point : function_.opacities) {
        extinctions_.push_back(extinctionOf(point.opacity, function_.unitDistance));
        mostExtinction_ = std::max(mostExtinction_, extinctions_.back());
    }
    const std::vector<Vector3d> gradients = gradientsForLight(mesh);
    for (const auto& corners : mesh.tetrahedra)
        if (isUsable(mesh, corners))
            addCell(mesh, corners, gradients);
}

void RayIntegrator::addCell(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& corners,
                            const std::vector<Vector3d>& gradients)
{
    Vector3d places[4];
    for (std::size_t i = 0; i < 4; ++i)
        places[i] = mesh.positions[corners[i]].cast<double>();
    const Eigen::Matrix3d edges = edgesOf(mesh, corners);
    if (edges.determinant() == 0)
        return;
    Cell cell;
    cell.corner = places[0];
    cell.inverse = edges.inverse();
    for (std::size_t i = 0; i < 4; ++i) {
        cell.values[static_cast<int>(i)] = mesh.values[corners[i]];
        cell.gradients.col(static_cast<int>(i)) = gradients[corners[i]];
    }
    cell.centre = (places[0] + places[1] + places[2] + places[3]) / 4;
    cell.squaredRadius = 0;
    for (const Vector3d& place : places)
        cell.squaredRadius = std::max(cell.squaredRadius, (place - cell.centre).squaredNorm());
    cells_.push_back(cell);
}

RayIntegrator::Ray RayIntegrator::rayOf(double column, double row) const
{
    // Where samples lie in their pixels is the renderer's choice; all else here is not.
    const double x = (column + sampleX) / (width_ / 2.0) - 1;
    const double y = 1 - (row + sampleY) / (height_ / 2.0);
    const Vector3d start = (worldFromClip_ * Eigen::Vector4d(x, y, -1, 1)).hnormalized();
    const Vector3d end = (worldFromClip_ * Eigen::Vector4d(x, y, 1, 1)).hnormalized();
    return {start, (end - start).normalized()};
}

bool RayIntegrator::cut(const Ray& ray, const Cell& cell, Piece& piece) const
{
    // Most cells are far from the ray; written out, as builds for finding errors call a function for each operator.
    const double x = cell.centre[0] - ray.start[0], y = cell.centre[1] - ray.start[1],
                 z = cell.centre[2] - ray.start[2];
    const double along = x * ray.direction[0] + y * ray.direction[1] + z * ray.direction[2];
    if (x * x + y * y + z * z - along * along > cell.squaredRadius * (1 + 1e-9))
        return false;
    Eigen::Vector4d weights, perLength;
    weights << 0, cell.inverse * (ray.start - cell.corner);
    perLength << 0, cell.inverse * ray.direction;
    weights[0] = 1 - weights.sum();
    perLength[0] = -perLength.sum();
    piece.enter = 0;
    piece.leave = 1e300;
    for (int i = 0; i < 4; ++i) {
        if (perLength[i] > 0)
            piece.enter = std::max(piece.enter, -weights[i] / perLength[i]);
        else if (perLength[i] < 0)
            piece.leave = std::min(piece.leave, -weights[i] / perLength[i]);
        else if (weights[i] < 0)
            return false;
    }
    if (!clip(ray, piece))
        return false;
    const auto valueAt = [&](double place) {
        return std::clamp(cell.values.dot(weights + place * perLength), cell.values.minCoeff(), cell.values.maxCoeff());
    };
    piece.valueIn = valueAt(piece.enter);
    piece.valueOut = valueAt(piece.leave);
    piece.cell = &cell;
    piece.weights = weights;
    piece.perLength = perLength;
    return true;
}

/// Returns whether anything is left.
bool RayIntegrator::clip(const Ray& ray, Piece& piece) const
{
    for (const ClipPlane& plane : scene_.clipPlanes) {
        const double atStart = plane.normal.dot(ray.start) - plane.offset;
        const double perLength = plane.normal.dot(ray.direction);
        if (perLength > 0)
            piece.enter = std::max(piece.enter, -atStart / perLength);
        else if (perLength < 0)
            piece.leave = std::min(piece.leave, -atStart / perLength);
        else if (atStart < 0)
            return false;
    }
    return piece.enter < piece.leave;
}

namespace {

/// A value's place between two points of a curve.
struct Between {
    std::size_t first;
    std::size_t second;
    double share;
};

template <class Point> Between between(const std::vector<Point>& points, double value)
{
    std::size_t after = 0;
    while (after < points.size() && points[after].value <= value)
        ++after;
    const std::size_t first = after == 0 ? 0 : after - 1, second = std::min(after, points.size() - 1);
    const double width = points[second].value - points[first].value;
    return {first, second, width > 0 ? (value - points[first].value) / width : 0};
}

} // namespace

/// As evaluate(), with the logarithms taken once.
TransferSample RayIntegrator::look(double value) const
{
    const auto& [colours, opacities, unitDistance, mask] = function_;
    if (colours.empty() || opacities.empty())
        return {};
    TransferSample sample;
    const Between colour = between(colours, value), opacity = between(opacities, value);
    for (std::size_t channel = 0; channel < 3; ++channel)
        sample.colour[channel] =
            std::lerp(colours[colour.first].colour[channel], colours[colour.second].colour[channel], colour.share);
    sample.extinction = std::lerp(extinctions_[opacity.first], extinctions_[opacity.second], opacity.share);
    return sample;
}

/// A part of a cell in which the colour changes little; where knots are in it, cut in halves first.
void RayIntegrator::step(Light& light, double length, double valueIn, double valueOut, double at, int halvings) const
{
    const auto isCrossed = [&](const auto& point) { return (point.value - valueIn) * (point.value - valueOut) < 0; };
    const bool crosses =
        std::ranges::any_of(function_.colours, isCrossed) || std::ranges::any_of(function_.opacities, isCrossed);
    if (halvings > 0 && crosses) {
        const double middle = (valueIn + valueOut) / 2;
        step(light, length / 2, valueIn, middle, at, halvings - 1);
        step(light, length / 2, middle, valueOut, at + length / 2, halvings - 1);
        return;
    }
    const TransferSample sample = look((valueIn + valueOut) / 2);
    pass(light, {sample.colour[0], sample.colour[1], sample.colour[2]}, sample.extinction, length, at);
}

/// A length of one colour and extinction.
void RayIntegrator::pass(Light& light, const std::array<double, 3>& colour, double extinction, double length,
                         double at) const
{
    const double through = std::exp(-extinction * length);
    for (std::size_t channel = 0; channel < 3; ++channel)
        light.colour[channel] += light.left * (1 - through) * colour[channel];
    if (light.left > 0.5 && light.left * through <= 0.5)
        light.halfAt = at + std::log(2 * light.left) / extinction;
    light.left *= through;
}

RayIntegrator::Falling RayIntegrator::fallingAt(const Ray& ray, const Piece& piece, double place) const
{
    const Vector3d gradient = piece.cell->gradients * (piece.weights + place * piece.perLength);
    if (gradient.norm() < 1e-6)
        return {};
    const double along = gradient.dot(ray.direction) / gradient.norm();
    const Vector3d normal = cameraFromWorld_ * gradient.normalized() * (along > 0 ? -1 : 1);
    const double front = std::min(1.0, 0.5 + 2 * std::abs(along));
    const auto falling = [&](double right, double up, double back) {
        const double cosine = normal.dot(Vector3d(right, up, back));
        return front * std::max(0.0, cosine) + (1 - front) * std::max(0.0, -cosine);
    };
    const double key = falling(-96.0 / 169, 72.0 / 169, 119.0 / 169), fill = falling(0.8, -0.36, 0.48),
                 rim = falling(0.36, 0.8, -0.48);
    return {0.08 + 0.52 * std::abs(along) + 0.45 * key + 0.1 * fill + 0.1 * rim,
            0.18 * std::pow(std::max(0.0, normal.dot(Vector3d(-4, 3, 12) / 13)), 32)};
}

/// The values of points of the transfer function between two values, in the order from the first to the second.
std::vector<double> RayIntegrator::knotsBetween(double valueIn, double valueOut) const
{
    std::vector<double> knots;
    const auto add = [&](const auto& point) {
        if ((point.value - valueIn) * (point.value - valueOut) < 0)
            knots.push_back(point.value);
    };
    std::ranges::for_each(function_.colours, add);
    std::ranges::for_each(function_.opacities, add);
    std::ranges::sort(knots);
    if (valueIn > valueOut)
        std::ranges::reverse(knots);
    return knots;
}

/// As march(), under light, slab by slab.
void RayIntegrator::marchLit(const Ray& ray, Light& light, const Piece& piece, double from, double to) const
{
    const double enter = std::lerp(piece.enter, piece.leave, from), leave = std::lerp(piece.enter, piece.leave, to);
    const double valueIn = std::lerp(piece.valueIn, piece.valueOut, from);
    const double valueOut = std::lerp(piece.valueIn, piece.valueOut, to);
    const Falling first = fallingAt(ray, piece, enter), last = fallingAt(ray, piece, leave);
    std::vector<double> ends = knotsBetween(valueIn, valueOut);
    ends.push_back(valueOut);
    double value = valueIn, share = 0;
    for (const double end : ends) {
        const bool isLast = &end == &ends.back();
        const double endShare = isLast ? 1 : (end - valueIn) / (valueOut - valueIn);
        const auto colourAt = [&](double place, double at) {
            // From within the slab, where the colours step at its ends.
            const TransferSample sample = look(std::lerp(at, (value + end) / 2, 1e-9));
            std::array<double, 3> lit{};
            for (std::size_t channel = 0; channel < 3; ++channel)
                lit[channel] = std::min(1.0, sample.colour[channel] * std::lerp(first.factor, last.factor, place) +
                                                 std::lerp(first.highlight, last.highlight, place));
            return lit;
        };
        marchSlab(light, {std::lerp(enter, leave, share), std::lerp(enter, leave, endShare), value, end,
                          colourAt(share, value), colourAt(endShare, end)});
        value = end;
        share = endShare;
    }
}

void RayIntegrator::marchSlab(Light& light, const Slab& slab) const
{
    const double length = slab.leave - slab.enter;
    const int steps = static_cast<int>(std::clamp(length * mostExtinction_ * 30, 16.0, 3000.0));
    for (int i = 0; i < steps && light.left > 1e-9; ++i) {
        const double middle = (i + 0.5) / steps;
        std::array<double, 3> colour{};
        for (std::size_t channel = 0; channel < 3; ++channel)
            colour[channel] = std::lerp(slab.colourIn[channel], slab.colourOut[channel], middle);
        pass(light, colour, look(std::lerp(slab.valueIn, slab.valueOut, middle)).extinction, length / steps,
             slab.enter + i * length / steps);
    }
}

/// From one part of a piece to another, both in [0, 1].
void RayIntegrator::march(const Ray& ray, Light& light, const Piece& piece, double from, double to) const
{
    if (scene_.shaded) {
        marchLit(ray, light, piece, from, to);
        return;
    }
    const double whole = piece.leave - piece.enter;
    const double length = (to - from) * whole;
    const int steps = static_cast<int>(std::clamp(length * mostExtinction_ * 30, 16.0, 3000.0));
    for (int i = 0; i < steps && light.left > 1e-9; ++i) {
        const double begin = std::lerp(from, to, double(i) / steps), end = std::lerp(from, to, (i + 1.0) / steps);
        step(light, length / steps, std::lerp(piece.valueIn, piece.valueOut, begin),
             std::lerp(piece.valueIn, piece.valueOut, end), piece.enter + begin * whole, 10);
    }
}

void RayIntegrator::meet(Light& light, const IsoLayer& layer, double at) const
{
    for (std::size_t channel = 0; channel < 3; ++channel)
        light.colour[channel] += light.left * layer.opacity * layer.colour[channel];
    const double before = light.left;
    light.left *= 1 - layer.opacity;
    if (before > 0.5 && light.left <= 0.5)
        light.halfAt = at;
}

/// A piece with the layers in it.
void RayIntegrator::through(const Ray& ray, Light& light, const Piece& piece) const
{
    std::vector<std::pair<double, const IsoLayer*>> met;
    for (const IsoLayer& layer : scene_.layers)
        if ((piece.valueIn >= layer.value) != (piece.valueOut >= layer.value))
            met.emplace_back((layer.value - piece.valueIn) / (piece.valueOut - piece.valueIn), &layer);
    std::ranges::sort(met);
    double from = 0;
    for (const auto& [at, layer] : met) {
        if (!scene_.wholeCells) {
            march(ray, light, piece, from, at);
            from = at;
        }
        meet(light, *layer, std::lerp(piece.enter, piece.leave, at));
    }
    march(ray, light, piece, from, 1);
}

RayIntegrator::Sample RayIntegrator::trace(double column, double row) const
{
    const Ray ray = rayOf(column, row);
    std::vector<Piece> pieces;
    Piece piece{};
    for (const Cell& cell : cells_)
        if (cut(ray, cell, piece))
            pieces.push_back(piece);
    std::ranges::sort(pieces, {}, [](const Piece& one) { return one.enter + one.leave; });
    Light light;
    for (const Piece& one : pieces)
        through(ray, light, one);
    double depth = std::numeric_limits<double>::infinity();
    if (light.halfAt >= 0) {
        const Vector3d place = ray.start + light.halfAt * ray.direction;
        depth = -(viewMatrix(camera_) * place.homogeneous()).z();
    }
    return {{light.colour[0], light.colour[1], light.colour[2], 1 - light.left}, depth};
}

bool RayIntegrator::isDoubtful(int column, int row) const
{
    constexpr double aside = 0.002;
    const std::array<double, 4> here = sample(column, row);
    for (const auto& [x, y] : {std::pair{aside, aside}, {aside, -aside}, {-aside, aside}, {-aside, -aside}}) {
        const std::array<double, 4> there = trace(column + x, row + y).colour;
        for (std::size_t channel = 0; channel < 4; ++channel)
            if (std::abs(here[channel] - there[channel]) > 1.0 / 255)
                return true;
    }
    return false;
}

PictureDifference compare(const VolumePicture& picture, const RayIntegrator& integrator)
{
    PictureDifference difference;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const std::array<double, 4> expected = integrator.sample(column, row);
            const auto& found = picture.samples[static_cast<std::size_t>(row * picture.width + column)];
            for (std::size_t channel = 0; channel < 4; ++channel) {
                // Written so that NaN counts as far off.
                const double apart = std::abs(found[channel] - expected[channel]);
                difference.largest = apart <= difference.largest ? difference.largest : std::isnan(apart) ? 1e9 : apart;
                difference.mean += apart;
            }
            difference.seen += expected[3];
        }
    difference.mean /= 4.0 * static_cast<double>(picture.samples.size());
    difference.seen /= static_cast<double>(picture.samples.size());
    return difference;
}

} // namespace tetra::testing
