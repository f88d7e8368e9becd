// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// The coding of a history's arrays, group by group (FORMAT.md, "Packed form", "Stored by parts"). A group is coded by
/// what it does to the mesh before it: which tetrahedra it destroys, found by going from one to its neighbours, and
/// what fills the cavity that they leave, face by face. So whoever decodes has the mesh of the sites so far, with its
/// neighbours, and what is near in the mesh predicts the rest: points, positions, values and bounds.

/// What the coding knows beforehand: of the header.
struct HistoryFacts {
    DomainClass domain = DomainClass::RegularLattice;
    SampleType sampleType = SampleType::UInt8;
    Lattice lattice;
    std::size_t coordinateBytes = 0; ///< of the sites' positions: 4 or 8; 0 of regular lattices
    bool decimals = false;           ///< coordinates are coded as decimals: most of them are short ones
    bool delaunay = true;
    double extent = 0;        ///< of the values
    double diagonal = 0;      ///< of the bounding box
    double warpingWeight = 0; ///< there are own warpings if canWarp(domain)
    std::uint32_t siteCount = 0;
    std::uint64_t tetrahedronCount = 0;
};

/// Whether a model's positions are best coded as decimals, as those of text files are. O(sites).
bool hasDecimals(const Model& model);

/// The arrays of the sites and tetrahedra so far (FORMAT.md); a destroyer that has not come yet is Model::never.
struct HistoryArrays {
    std::vector<std::uint32_t> points;
    std::vector<std::byte> values;
    std::vector<std::byte> positions; ///< three coordinates a site; empty of regular lattices
    std::vector<float> runningKeys;
    std::vector<std::uint64_t> starOffsets{0};
    std::vector<std::uint32_t> meshSizes;
    std::vector<std::uint8_t> groupGoesOn;
    std::vector<std::array<std::uint32_t, 3>> otherSites;
    std::vector<std::uint32_t> destroyers;
    std::vector<std::uint16_t> ownErrors;
    std::vector<std::uint16_t> ownWarpings; ///< empty without warping
};

/// What the coded bytes are for.
struct HistoryCost {
    std::uint64_t positions = 0;
    std::uint64_t values = 0;
    std::uint64_t accuracy = 0; ///< running keys
    std::uint64_t ownErrors = 0;
    std::uint64_t mesh = 0;  ///< which tetrahedra die, and which take their place
    std::uint64_t order = 0; ///< of tetrahedra in their stars, and of the sites in these
};

struct HistoryState;

/// Codes a model from its first site on. Memory: about 80 bytes a tetrahedron that ever lived. May throw
/// std::bad_alloc.
class HistoryEncoder {
public:
    HistoryEncoder(const Model& model, const HistoryFacts& facts);
    ~HistoryEncoder();

    /// The sites from those that have been coded on up to `end`, which ends a group. Errors: arrays that contradict
    /// each other; then the encoder is of no further use.
    Result<std::vector<std::byte>> encode(std::uint32_t end);
    const HistoryCost& cost() const noexcept { return cost_; }
    /// What the decoder has then.
    const HistoryArrays& arrays() const noexcept;

private:
    const Model& model_;
    std::unique_ptr<HistoryState> state_;
    std::vector<std::uint64_t> deathOffsets_; ///< of each site in deaths_
    std::vector<std::uint32_t> deaths_;       ///< tetrahedra in the order of their destroyers
    HistoryCost cost_;
};

/// The other way. Memory as for the encoder. May throw std::bad_alloc.
class HistoryDecoder {
public:
    explicit HistoryDecoder(const HistoryFacts& facts);
    ~HistoryDecoder();

    /// False if the bytes are not what an encoder makes of `end` - arrays().points.size() more sites: then the decoder
    /// is of no further use. Whatever the bytes are, takes no more memory and time than the facts allow for.
    [[nodiscard]] bool decode(std::span<const std::byte> bytes, std::uint32_t end);
    const HistoryArrays& arrays() const noexcept;

private:
    std::unique_ptr<HistoryState> state_;
};

} // namespace tetra
