// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/graphics/volume/ray_integrator.h"

#include "core/graphics/volume/volume_view.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

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

} // namespace

RayIntegrator::RayIntegrator(const TetrahedralMesh& mesh, const TransferFunction& function, const Camera& camera,
                             int width, int height)
    : mesh_(mesh), function_(function), camera_(camera), width_(width), height_(height),
      worldFromClip_((projectionMatrix(camera, double(width) / height, boundsOf(mesh)) * viewMatrix(camera)).inverse())
{
}

RayIntegrator::Ray RayIntegrator::rayOf(int column, int row) const
{
    // Where samples lie in their pixels is the renderer's choice; all else here is not.
    const VolumeView view = makeVolumeView(camera_, width_, height_, boundsOf(mesh_));
    const double x = (column + view.firstX()) / (width_ / 2.0);
    const double y = -(row + view.firstY()) / (height_ / 2.0);
    const Vector3d start = (worldFromClip_ * Eigen::Vector4d(x, y, -1, 1)).hnormalized();
    const Vector3d end = (worldFromClip_ * Eigen::Vector4d(x, y, 1, 1)).hnormalized();
    return {start, (end - start).normalized()};
}

bool RayIntegrator::cut(const Ray& ray, const std::array<std::uint32_t, 4>& cell, Piece& piece) const
{
    Vector3d corners[4];
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = mesh_.positions[cell[i]].cast<double>();
        if (!corners[i].allFinite() || !std::isfinite(mesh_.values[cell[i]]))
            return false;
    }
    Eigen::Matrix3d edges;
    edges << corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0];
    if (edges.determinant() == 0)
        return false;
    const Eigen::Matrix3d inverse = edges.inverse();
    Eigen::Vector4d weights, perLength;
    weights << 0, inverse * (ray.start - corners[0]);
    perLength << 0, inverse * ray.direction;
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
    Eigen::Vector4d values;
    for (std::size_t i = 0; i < 4; ++i)
        values[static_cast<int>(i)] = mesh_.values[cell[i]];
    const auto valueAt = [&](double along) {
        return std::clamp(values.dot(weights + along * perLength), values.minCoeff(), values.maxCoeff());
    };
    piece.valueIn = valueAt(piece.enter);
    piece.valueOut = valueAt(piece.leave);
    return piece.enter < piece.leave;
}

void RayIntegrator::march(Light& light, double length, double valueIn, double valueOut, int halvings) const
{
    const auto crosses = [&](const TransferPoint& point) {
        return (point.value - valueIn) * (point.value - valueOut) < 0;
    };
    if (halvings > 0 && std::ranges::any_of(function_.points, crosses)) {
        const double middle = (valueIn + valueOut) / 2;
        march(light, length / 2, valueIn, middle, halvings - 1);
        march(light, length / 2, middle, valueOut, halvings - 1);
        return;
    }
    const TransferSample sample = evaluate(function_, (valueIn + valueOut) / 2);
    const double through = std::exp(-sample.extinction * length);
    for (std::size_t channel = 0; channel < 3; ++channel)
        light.colour[channel] += light.left * (1 - through) * sample.colour[channel];
    light.left *= through;
}

std::array<double, 4> RayIntegrator::sample(int column, int row) const
{
    const Ray ray = rayOf(column, row);
    std::vector<Piece> pieces;
    Piece piece;
    for (const auto& cell : mesh_.tetrahedra)
        if (cut(ray, cell, piece))
            pieces.push_back(piece);
    std::ranges::sort(pieces, {}, [](const Piece& one) { return one.enter + one.leave; });

    double most = 0;
    for (const TransferPoint& point : function_.points)
        most = std::max(most, extinctionOf(point.opacity, function_.unitDistance));
    Light light;
    for (const Piece& one : pieces) {
        const double length = one.leave - one.enter;
        const int steps = static_cast<int>(std::clamp(length * most * 30, 30.0, 3000.0));
        for (int i = 0; i < steps && light.left > 1e-9; ++i)
            march(light, length / steps, std::lerp(one.valueIn, one.valueOut, double(i) / steps),
                  std::lerp(one.valueIn, one.valueOut, (i + 1.0) / steps), 10);
    }
    return {light.colour[0], light.colour[1], light.colour[2], 1 - light.left};
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
