// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/written_content.h"

#include <random>

namespace tetra {

/// Random numbers in the shape of surfaces: a writer must not care whether they are any.
struct RandomSurface {
    RandomSurface(std::size_t vertices, std::size_t triangleCount, unsigned seed)
    {
        std::mt19937 random(seed);
        std::normal_distribution<float> number(0, 1000);
        std::uniform_real_distribution<float> channel(0, 1);
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
            positions.emplace_back(number(random), number(random), number(random) / 3e7F);
            normals.push_back(Eigen::Vector3f(number(random), number(random), number(random)).normalized());
            values.push_back(number(random));
            colours.push_back({channel(random), channel(random), channel(random)});
        }
        for (std::size_t i = 0; i < triangleCount; ++i) {
            const auto first = static_cast<std::uint32_t>(random() % vertices);
            const auto count = static_cast<std::uint32_t>(vertices);
            triangles.push_back({first, (first + 1) % count, (first + 2) % count});
        }
    }
    /// An isosurface, or with `valued` one that has a value at each vertex and no normals.
    SurfacePart part(const std::string& name, bool valued = false) const
    {
        SurfacePart result{.name = name, .positions = positions, .normals = {}, .triangles = triangles};
        if (valued)
            result.values = std::span<const float>(values);
        else
            result.normals = normals;
        return result;
    }

    std::vector<Eigen::Vector3d> positions;
    std::vector<Eigen::Vector3f> normals;
    std::vector<float> values;
    std::vector<Colour> colours;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

} // namespace tetra
