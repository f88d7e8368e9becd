// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/topology.h"
#include "core/refine/lattice/block_division.h"

#include <tan/query.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

// Tetrahedra are by numbers of the lattice's points, and positive.

/// What a mesh with a focus should be, by trying everything and in integers of 128 bits, sharing no code with what it
/// checks: all tetrahedra are tested for every point, all samples for every tetrahedron.
class SlowFocus {
public:
    SlowFocus(const Model& model, const BlockDivision& division) : model_(model), division_(division) {}

    /// The mesh of the first `coarse` sites, refined by the sites of the ramp and then repaired until it keeps it.
    /// For samples of up to 16 bits.
    std::vector<Tetrahedron> meshOf(const SpaceRamp& ramp);

    /// What is wrong with a mesh as one that keeps the ramp; empty if nothing is. `room` is allowed for rounding.
    std::string faultOf(const std::vector<Tetrahedron>& mesh, const SpaceRamp& ramp, double room) const;

private:
    struct Place {
        std::int64_t x, y, z;
    };
    struct Violation {
        double excess, error;
        std::uint32_t point;
        Tetrahedron tetrahedron;
    };

    Place placeOf(std::uint32_t point) const;
    double sampleAt(std::uint32_t point) const;
    bool asksFor(const SpaceRamp& ramp, std::uint32_t site) const;
    double limitAt(const ErrorField& field, std::uint32_t point) const;
    void insert(std::uint32_t point);
    void insertInto(const LatticeBox& box, std::uint32_t point);
    std::vector<Violation> worstOf(const std::vector<Tetrahedron>& mesh, const ErrorField& field, double room) const;
    bool liesIn(const Tetrahedron& tetrahedron, const LatticeBox& box) const;

    const Model& model_;
    BlockDivision division_;
    std::vector<Tetrahedron> mesh_;
    std::vector<bool> vertices_;
};

} // namespace tetra
