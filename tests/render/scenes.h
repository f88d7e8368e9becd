// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/shading.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>

namespace tetra::testing {

using MeshPointer = std::shared_ptr<const TriangleMesh>;

/// A lit colour that faces the eye, or that of a surface without normals.
inline Colour facing(const Colour& colour)
{
    return shaded(colour, lightOn<float>(0, 0, 1, 1));
}

/// A parallelogram with one normal.
inline MeshPointer quad(const Eigen::Vector3d& corner, const Eigen::Vector3d& along, const Eigen::Vector3d& across)
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = {corner, corner + along, corner + along + across, corner + across};
    mesh->normals.assign(4, along.cross(across).normalized().cast<float>());
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// A sphere with exact normals, so fine that its triangles are nearly pixels.
inline MeshPointer sphere(const Eigen::Vector3d& centre, double radius, std::uint32_t rings = 256)
{
    auto mesh = std::make_shared<TriangleMesh>();
    const std::uint32_t sectors = 2 * rings;
    for (std::uint32_t ring = 0; ring <= rings; ++ring)
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            const double polar = std::numbers::pi * ring / rings;
            const double around = 2 * std::numbers::pi * sector / sectors;
            const Eigen::Vector3d normal(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                                         std::cos(polar));
            mesh->positions.push_back(centre + radius * normal);
            mesh->normals.push_back(normal.cast<float>());
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            const std::uint32_t a = ring * sectors + sector;
            const std::uint32_t b = ring * sectors + (sector + 1) % sectors;
            mesh->triangles.push_back({a, a + sectors, b + sectors});
            mesh->triangles.push_back({a, b + sectors, b});
        }
    return mesh;
}

/// A flat sheet in the plane y = 0 over [-1, 1]^2 in x and z, of `cells` squared cells whose inner corners are moved at
/// random and whose diagonals are, too. Its normals lie in the sheet, so a headlight before it gives no highlight.
inline MeshPointer crumpledSheet(std::uint32_t cells, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(-0.2f, 0.2f); // more could turn a triangle over
    auto mesh = std::make_shared<TriangleMesh>();
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const bool inside = i > 0 && i < cells && j > 0 && j < cells;
            const Eigen::Vector2f place(static_cast<float>(i) + (inside ? jitter(random) : 0),
                                        static_cast<float>(j) + (inside ? jitter(random) : 0));
            const Eigen::Vector2f scaled = place * (2.0f / static_cast<float>(cells)) - Eigen::Vector2f(1, 1);
            mesh->positions.emplace_back(scaled.x(), 0.0f, scaled.y());
            mesh->normals.emplace_back(1.0f, 0.0f, 0.0f);
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i;
            const std::array<std::uint32_t, 4> corners = {a, a + 1, a + cells + 2, a + cells + 1};
            const std::size_t turn = random() % 2;
            const bool flip = random() % 2 == 0;
            const auto corner = [&](std::size_t n) { return corners[(n + turn) % 4]; };
            mesh->triangles.push_back({corner(0), corner(flip ? 2 : 1), corner(flip ? 1 : 2)});
            mesh->triangles.push_back({corner(0), corner(2), corner(3)});
        }
    return mesh;
}

inline Eigen::AlignedBox3d cube(double half)
{
    return {Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half)};
}

} // namespace tetra::testing
