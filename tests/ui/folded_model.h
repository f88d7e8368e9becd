// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/build.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

namespace tetra {

/// A model, in that file, of a small curvilinear grid that crosses itself: it lists faulty cells, and knows where they
/// are, as every point is a site.
inline Status buildFoldedModel(const std::filesystem::path& path)
{
    constexpr std::uint32_t side = 5;
    std::vector<Eigen::Vector3d> positions;
    const auto values = std::make_shared<std::vector<float>>();
    for (std::uint32_t point = 0; point < side * side * side; ++point) {
        // Nothing is linear.
        const Eigen::Vector3d place(point % side, point / side % side, point / side / side);
        positions.push_back(place + 0.05 * Eigen::Array3d(1.7 * point, 2.9 * point, 4.3 * point).sin().matrix());
        values->push_back(static_cast<float>(std::sin(5.1 * point)));
    }
    positions[(2 * side + 2) * side + 2].x() -= 4; // through its neighbours
    const ScalarField field(SampleType::Float32, values->size(),
                            {values, reinterpret_cast<const std::byte*>(values->data())});
    const auto grid = curvilinearDataset({side, side, side}, std::move(positions), field, "folded");
    if (!grid)
        return grid.error();
    const auto built = tetra::buildModel(*grid, path, Refinement{});
    return built ? Status() : built.error();
}

} // namespace tetra
