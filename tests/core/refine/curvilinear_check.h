// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/refine/bent_grids.h"
#include "tests/core/refine/recorded_history.h"

#include <map>

namespace tetra {

/// What a mesh of a history is, found without any of the code that made it.
struct MeshFindings {
    std::size_t tetrahedra = 0;
    bool covers = false;    ///< positive tetrahedra of computational space that fill it, every point in one at least
    bool conforming = true; ///< faces belong to two tetrahedra, or to one on the boundary
    bool delaunay = true;   ///< no point of the mesh lies strictly inside a circumsphere (unblocked meshes)
    bool bounded = true;    ///< no tetrahedron exceeds the accuracy that the history gives it, but by rounding
    std::size_t inverted = 0;
    std::size_t degenerate = 0;
    double error = 0;
    double warping = 0;
};

class MeshCheck {
public:
    MeshCheck(const BentGrid& grid, const RecordedHistory& history, std::span<const float> weights = {})
        : grid_(grid), history_(history), weights_(weights)
    {
        std::int64_t balance = 0;
        for (std::uint32_t z = 0; z + 1 < grid.size[2]; ++z)
            for (std::uint32_t y = 0; y + 1 < grid.size[1]; ++y)
                for (std::uint32_t x = 0; x + 1 < grid.size[0]; ++x) {
                    const std::uint64_t o = (std::uint64_t(z) * grid.size[1] + y) * grid.size[0] + x;
                    const std::int64_t volume =
                        physicalVolume({o, o + 1, o + grid.size[0], o + std::uint64_t(grid.size[0]) * grid.size[1]});
                    balance += volume > 0 ? 1 : volume < 0 ? -1 : 0;
                }
        handedness_ = balance < 0 ? -1 : 1;
    }

    /// The mesh of the first `sites` sites.
    MeshFindings look(std::size_t sites, bool testSpheres) const
    {
        MeshFindings findings;
        std::int64_t total = 0;
        std::vector<bool> covered(grid_.values.size(), false);
        std::map<std::array<std::uint64_t, 3>, int> faces;
        for (const RecordedHistory::Tetrahedron& tetrahedron : history_.tetrahedra) {
            if (!history_.alive(tetrahedron, sites))
                continue;
            ++findings.tetrahedra;
            Vertices vertices{};
            for (std::size_t i = 0; i < 4; ++i)
                vertices[i] = history_.points[tetrahedron.sites[i]];
            const std::int64_t volume = this->volume(vertices);
            if (volume <= 0)
                return findings;
            total += volume;
            const std::int64_t physical = handedness_ * physicalVolume(vertices);
            findings.inverted += physical < 0;
            findings.degenerate += physical == 0;
            measure(tetrahedron, vertices, volume, covered, findings);
            for (std::size_t i = 0; i < 4; ++i) {
                std::array<std::uint64_t, 3> face{vertices[(i + 1) % 4], vertices[(i + 2) % 4], vertices[(i + 3) % 4]};
                std::ranges::sort(face);
                ++faces[face];
            }
            if (testSpheres)
                for (std::size_t site = 0; site < sites; ++site)
                    findings.delaunay = findings.delaunay && !insideSphere(vertices, history_.points[site]);
        }
        findings.covers = total == std::int64_t(6) * (grid_.size[0] - 1) * (grid_.size[1] - 1) * (grid_.size[2] - 1) &&
                          std::ranges::all_of(covered, [](bool is) { return is; });
        for (const auto& [face, count] : faces)
            findings.conforming = findings.conforming && count == (onBoundary(face) ? 1 : 2);
        return findings;
    }

private:
    using Integers = std::array<std::int64_t, 3>;
    using Vertices = std::array<std::uint64_t, 4>;

    Integers place(std::uint64_t point) const
    {
        const auto at = grid_.place(point);
        return {at[0], at[1], at[2]};
    }
    static Integers difference(const Integers& a, const Integers& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
    static std::int64_t determinant(const Integers& u, const Integers& v, const Integers& w)
    {
        return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
               u[2] * (v[0] * w[1] - v[1] * w[0]);
    }
    std::int64_t volume(const Vertices& v) const
    {
        const Integers o = place(v[0]);
        return determinant(difference(place(v[1]), o), difference(place(v[2]), o), difference(place(v[3]), o));
    }
    std::int64_t physicalVolume(const Vertices& v) const
    {
        const auto physical = [this](std::uint64_t point) -> Integers {
            const Eigen::Vector3d scaled = 64 * grid_.positions[point];
            return {std::lround(scaled.x()), std::lround(scaled.y()), std::lround(scaled.z())};
        };
        const Integers o = physical(v[0]);
        return determinant(difference(physical(v[1]), o), difference(physical(v[2]), o), difference(physical(v[3]), o));
    }
    bool insideSphere(const Vertices& v, std::uint64_t point) const
    {
        // The in-sphere determinant of a positive tetrahedron, expanded along its last column.
        std::array<Integers, 4> rows{};
        std::array<std::int64_t, 4> squares{};
        for (std::size_t i = 0; i < 4; ++i) {
            rows[i] = difference(place(v[i]), place(point));
            squares[i] = rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1] + rows[i][2] * rows[i][2];
        }
        return squares[0] * determinant(rows[1], rows[2], rows[3]) -
                   squares[1] * determinant(rows[0], rows[2], rows[3]) +
                   squares[2] * determinant(rows[0], rows[1], rows[3]) -
                   squares[3] * determinant(rows[0], rows[1], rows[2]) >
               0;
    }
    bool onBoundary(const std::array<std::uint64_t, 3>& face) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t plane = place(face[0])[axis];
            if ((plane == 0 || plane == grid_.size[axis] - 1) && place(face[1])[axis] == plane &&
                place(face[2])[axis] == plane)
                return true;
        }
        return false;
    }

    /// The accuracies of the points inside by barycentric weights of computational space (R4, R5).
    void measure(const RecordedHistory::Tetrahedron& tetrahedron, const Vertices& vertices, std::int64_t whole,
                 std::vector<bool>& covered, MeshFindings& findings) const
    {
        for (std::uint64_t point = 0; point < grid_.values.size(); ++point) {
            double value = 0;
            Eigen::Vector3d position(0, 0, 0);
            bool inside = true;
            for (std::size_t i = 0; i < 4 && inside; ++i) {
                Vertices replaced = vertices;
                replaced[i] = point;
                const std::int64_t part = volume(replaced);
                inside = part >= 0;
                const double weight = static_cast<double>(part) / static_cast<double>(whole);
                value += weight * grid_.values[vertices[i]];
                position += weight * grid_.positions[vertices[i]];
            }
            if (!inside)
                continue;
            covered[point] = true;
            const double weight = weights_.empty() ? 1.0 : weights_[point];
            const double error = weight * std::abs(value - grid_.values[point]);
            const double warping = weight * (position - grid_.positions[point]).norm();
            findings.error = std::max(findings.error, error);
            findings.warping = std::max(findings.warping, warping);
            // A point on a face counts for one of the two that share it.
            const bool own = std::ranges::none_of(vertices, [&](std::uint64_t v) { return v == point; }) &&
                             strictlyInside(vertices, point);
            if (own)
                findings.bounded = findings.bounded && error <= double(tetrahedron.error) + 1e-12 &&
                                   warping <= double(tetrahedron.warping) + 1e-12;
        }
    }
    bool strictlyInside(const Vertices& vertices, std::uint64_t point) const
    {
        for (std::size_t i = 0; i < 4; ++i) {
            Vertices replaced = vertices;
            replaced[i] = point;
            if (volume(replaced) <= 0)
                return false;
        }
        return true;
    }

    const BentGrid& grid_;
    const RecordedHistory& history_;
    std::span<const float> weights_;
    int handedness_ = 1;
};

} // namespace tetra
