// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

/// Evaluates a field along one row of a cube of size^3 points, all i at (j, k): row[i] in [0, 1]. Called from many
/// threads. The cube's points are the regular ones of [-1, 1]^3, its corners included: u = 2 i / (size - 1) - 1.
using RowFunction = std::function<void(std::uint32_t j, std::uint32_t k, std::span<double> row)>;

/// Electron density of the C60 molecule, after the model of independent atoms: the sum over the 60 corners p of a
/// truncated icosahedron with edges of 1.43 Angstrom (the mean of the molecule's bond lengths, 1.40 and 1.45) of
/// exp(-|x - p|^2 / (2 w^2)), w = 0.62 Angstrom, divided by its largest value. The cube reaches 4.7 Angstrom from the
/// centre along each axis. Smooth, with a hollow inside: the stand-in for the literature's Bucky Ball at any size.
RowFunction c60Density(std::uint32_t size);

/// The test signal of S. Marschner and R. Lobb, "An evaluation of reconstruction filters for volume rendering", IEEE
/// Visualization 1994: (1 - sin(pi z / 2) + a (1 + cos(2 pi f cos(pi r / 2)))) / (2 (1 + a)), r = sqrt(x^2 + y^2), with
/// f = 6 and a = 0.25. Its ripples near the Nyquist limit of 40^3 points are hard to reproduce.
RowFunction marschnerLobbSignal(std::uint32_t size);

/// A mesh of tetrahedra, with a value in [0, 1] for each point.
struct AnalyticMesh {
    std::vector<Eigen::Vector3d> positions; ///< floats
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    std::vector<double> values;
};

/// A machine part: a plate of 6 x 4 x 1 with five round holes through it, and, where a sixth one would be, a closed
/// cavity within; finer at the holes. `size` / 8 cells on half a hole's distance, at least 2; about size^3 / 20 points.
/// The field is the equivalent stress (von Mises) under tension along x, after the plane solution for one hole in an
/// infinite plate (G. Kirsch, "Die Theorie der Elastizitaet und die Beduerfnisse der Festigkeitslehre", 1898), what
/// the holes change added up, over the largest there can be. The same bits on every machine.
AnalyticMesh analyticPart(std::uint32_t size);

/// A field that TAn makes itself: to try it without data, to test and to measure it.
struct SampleKind {
    std::string_view name;        ///< as on the command line
    std::string_view description; ///< one sentence for the user
    SampleType type;              ///< unless asked otherwise
    DomainClass domain = DomainClass::RegularLattice;
    bool hasChance = false; ///< its values or its points follow SampleRequest::seed
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
/// memory, cancelled.
Result<Dataset> makeSample(const SampleRequest& request, const Progress& progress = {});

} // namespace tetra
