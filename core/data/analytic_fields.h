// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tetra {

/// A field that TAn makes itself: to try it without data, to test and to measure it.
struct SampleKind {
    std::string_view name;        ///< as on the command line
    std::string_view description; ///< one sentence for the user
    SampleType type;              ///< unless asked otherwise
    DomainClass domain = DomainClass::RegularLattice;
};

/// All kinds: c60, hydrogen, marschner-lobb, noise; the curvilinear grids blunt-body, o-grid, bent-duct, stretched;
/// scattered points: scattered; an irregular mesh: part.
std::span<const SampleKind> sampleKinds();

struct SampleRequest {
    std::string_view name = "c60";
    std::uint32_t size = 64;        ///< points along each axis, from smallestSampleSize to largestSampleSize
    std::optional<SampleType> type; ///< the kind's own if nothing is said
    std::uint64_t seed = 1;         ///< of noise and scattered; the other kinds have no chance in them
};

constexpr std::uint32_t smallestSampleSize = 2;
constexpr std::uint32_t largestSampleSize = 2048;
/// Of scattered points, where it is the cube root of their number, and of the irregular mesh.
constexpr std::uint32_t largestScatteredSize = 512;

/// Makes the dataset on all threads: a cube with spacing 1 and origin 0, a curvilinear grid, size^3 scattered
/// points, or a mesh of tetrahedra. Every field has values in [0, 1]; floating-point types hold them as they are,
/// integer types hold value * largest number of the type, rounded to nearest. The samples are the same bits on every
/// machine and with any number of threads. Errors: unknown name (naming the known ones), size out of bounds, not enough
/// memory, cancelled. Formulas and sources: core/data/analytic_functions.h, analytic_grids.h, analytic_points.h and
/// analytic_part.h.
Result<Dataset> makeSample(const SampleRequest& request, const Progress& progress = {});

} // namespace tetra
