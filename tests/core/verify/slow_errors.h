// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace tetra::testing {

/// How far the place is from the triangle, and the linear value at the place of it that is next.
inline std::pair<double, double> nextOn(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& values,
                                        const Eigen::Vector3d& place)
{
    std::pair<double, double> best = {std::numeric_limits<double>::infinity(), 0};
    const auto offer = [&](const Eigen::Vector3d& weights) {
        const Eigen::Vector3d there = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
        if (const double distance = (there - place).norm(); distance < best.first)
            best = {distance, weights.dot(values)};
    };
    Eigen::Matrix<double, 3, 2> edges;
    edges << corners[1] - corners[0], corners[2] - corners[0];
    const Eigen::Vector2d inside = edges.colPivHouseholderQr().solve(place - corners[0]);
    if (inside.minCoeff() >= 0 && inside.sum() <= 1)
        offer({1 - inside.sum(), inside[0], inside[1]});
    for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector3d from = corners[static_cast<std::size_t>(corner)];
        const Eigen::Vector3d edge = corners[static_cast<std::size_t>((corner + 1) % 3)] - from;
        const double along = std::clamp(edge.dot(place - from) / edge.squaredNorm(), 0.0, 1.0);
        Eigen::Vector3d weights(0, 0, 0);
        weights[corner] = 1 - along;
        weights[(corner + 1) % 3] = along;
        offer(weights);
    }
    return best;
}

/// The error of each point at its place in space, in % of the range, found by looking at every tetrahedron of the mesh
/// and, for points outside, at every face of its boundary.
struct SlowErrors {
    std::vector<double> percents;
    std::uint64_t outside = 0;
    std::uint64_t twice = 0; ///< points that lie inside several tetrahedra

    SlowErrors(const Dataset& dataset, const Model& model, std::uint32_t sites)
    {
        const auto mesh = extractPrefix(model, sites).value();
        const auto place = [&](std::uint32_t v) { return dataset.position(model.points()[v]); };
        const auto value = [&](std::uint32_t v) { return dataset.values.at(model.points()[v]); };
        std::map<std::array<std::uint32_t, 3>, int> faces;
        for (const auto& t : mesh.tetrahedra)
            for (std::size_t opposite = 0; opposite < 4; ++opposite) {
                std::array face = {t[(opposite + 1) % 4], t[(opposite + 2) % 4], t[(opposite + 3) % 4]};
                std::ranges::sort(face);
                ++faces[face];
            }
        for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
            const Eigen::Vector3d at = dataset.position(point);
            double least = std::numeric_limits<double>::infinity();
            int holding = 0;
            for (const auto& t : mesh.tetrahedra) {
                Eigen::Matrix4d corners;
                Eigen::Vector4d values;
                for (int corner = 0; corner < 4; ++corner) {
                    corners.col(corner) << place(t[static_cast<std::size_t>(corner)]), 1;
                    values[corner] = value(t[static_cast<std::size_t>(corner)]);
                }
                const Eigen::Vector4d weights =
                    corners.fullPivLu().solve(Eigen::Vector4d(at[0], at[1], at[2], 1)); // no tetrahedron is flat
                if (weights.minCoeff() < -1e-9)
                    continue;
                least = std::min(least, std::abs(weights.dot(values) - dataset.values.at(point)));
                holding += weights.minCoeff() > 1e-9 ? 1 : 0;
            }
            twice += holding > 1 ? 1 : 0;
            if (std::isinf(least)) {
                ++outside;
                std::vector<std::pair<double, double>> next;
                for (const auto& [face, count] : faces)
                    if (const auto& [a, b, c] = face; count == 1)
                        next.push_back(nextOn({place(a), place(b), place(c)}, {value(a), value(b), value(c)}, at));
                const double nearest = std::ranges::min(next).first; // at several places, where these are symmetric
                for (const auto& [distance, there] : next)
                    if (distance <= nearest * (1 + 1e-9))
                        least = std::min(least, std::abs(there - dataset.values.at(point)));
            }
            percents.push_back(100 * least / dataset.values.range().extent());
        }
    }
};

/// The same to the last digits but a few.
inline bool areSame(const ResidualStatistics& found, std::vector<double> percents)
{
    const auto near = [](double one, double other) { return std::abs(one - other) <= 1e-9 * (1 + other); };
    std::ranges::sort(percents);
    const auto count = static_cast<double>(percents.size());
    const double squares = std::inner_product(percents.begin(), percents.end(), percents.begin(), 0.0);
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * count));
    return near(found.largest, percents.back()) && near(found.percentile99, percents[rank - 1]) &&
           near(found.mean, std::accumulate(percents.begin(), percents.end(), 0.0) / count) &&
           near(found.rootMeanSquare, std::sqrt(squares / count));
}

} // namespace tetra::testing
