// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The values of a variable in a zone: of the two the one that the file declares, single precision if it says nothing.
struct TecplotValues {
    Buffer<float> singles;
    Buffer<double> doubles;

    std::size_t size() const { return singles.size() + doubles.size(); }
    double at(std::size_t i) const { return doubles.empty() ? double(singles[i]) : doubles[i]; }
};

enum class TecplotElement : std::uint8_t { Ordered, Point, Line, Triangle, Quadrilateral, Tetrahedron, Brick };

/// How many nodes an element of a finite-element zone has; 0 for ordered ones.
std::size_t cornersOf(TecplotElement element) noexcept;

struct TecplotZone {
    std::string name;
    TecplotElement element = TecplotElement::Ordered;
    std::array<std::uint32_t, 3> size{}; ///< of an ordered zone
    std::uint64_t nodes = 0;
    std::uint64_t elements = 0;                                    ///< of an ordered zone its cells
    std::vector<std::shared_ptr<const TecplotValues>> values;      ///< one a variable; null if it has none here
    std::vector<bool> perElement;                                  ///< one a variable
    std::shared_ptr<const std::vector<std::int64_t>> connectivity; ///< nodes, from 0
    std::int64_t strand = 0; ///< zones of one strand are the same at several times; below 1: of none
    double time = 0;         ///< of a zone of a strand
};

struct TecplotFile {
    std::vector<std::string> variables;
    std::array<std::size_t, 3> axes{}; ///< which of them are x, y and z
    std::vector<TecplotZone> zones;
};

/// Reads Tecplot's text format: ordered and finite-element zones, by points or by blocks, values of nodes or elements,
/// shared and passive variables, repeated values ("12*0.5"). VTK's reader takes ordered zones by blocks for such by
/// points if they say ZONETYPE, rounds all to single precision, and makes zeros of what is missing.
/// Errors: anything that is missing or too much, with the zone; polyhedral zones, which have no simple cells. Linear.
Result<TecplotFile> readTecplot(std::string_view text);

/// The times at which zones of strands stand, ascending, each once: the file's steps.
std::vector<double> tecplotTimes(const TecplotFile& file);

/// Whether a zone is there at a time: those that belong to no strand always are.
bool isThereAt(const TecplotZone& zone, double time);

/// Whether a text begins as such files do: "TITLE =", "FILETYPE =" or "VARIABLES =", with VARIABLES in its first bytes.
bool looksLikeTecplot(std::string_view firstBytes);

} // namespace tetra
