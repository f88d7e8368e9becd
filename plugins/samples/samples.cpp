// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/samples.h"

#include "core/base/split_mix.h"
#include "plugins/samples/portable_math.h"

#include <tan/data.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetra {

namespace {

/// Where a point of a grid lies, and the field there.
struct GridPoint {
    Eigen::Vector3d position{0, 0, 0};
    double value = 0; ///< in [0, 1]
};

/// A grid as a mapping of the unit cube of computational space; the same bits on every machine. Called from many
/// threads.
using GridFunction = std::function<GridPoint(const std::array<double, 3>& place)>;

/// A scattered point, and the field there.
struct ScatteredPoint {
    Eigen::Vector3d position{0, 0, 0};
    double value = 0; ///< in [0, 1]
};

/// Random points, evenly spread over the unit ball, one after the other; the same bits on every machine for the same
/// seed. The field are waves that grow finer outwards, (1 + cos(2 pi (1.5 r^2 + z / 2))) / 2. The coordinates are
/// numbers of SplitMix64 (see whiteNoise()), three at a time until they fall into the ball.
class ScatteredBall {
public:
    explicit ScatteredBall(std::uint64_t seed) : state_(seed) {}
    ScatteredPoint next();

private:
    double nextCoordinate();

    std::uint64_t state_;
};

/// Coordinates of the cube's points along an axis, in [-1, 1].
std::vector<double> axisCoordinates(std::uint32_t size)
{
    std::vector<double> coordinates(size);
    for (std::uint32_t i = 0; i < size; ++i)
        coordinates[i] = (2.0 * i - (size - 1.0)) / (size - 1.0);
    return coordinates;
}

constexpr std::size_t atomCount = 60;

/// The corners of the truncated icosahedron with edge length 2: the even permutations of (0, 1, 3g), (1, 2 + g, 2g) and
/// (g, 2, 2g + 1) with all signs, g the golden ratio.
std::array<Eigen::Vector3d, atomCount> truncatedIcosahedron()
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    const std::array<Eigen::Vector3d, 3> families = {Eigen::Vector3d(0, 1, 3 * golden),
                                                     Eigen::Vector3d(1, 2 + golden, 2 * golden),
                                                     Eigen::Vector3d(golden, 2, 2 * golden + 1)};
    std::array<Eigen::Vector3d, atomCount> corners;
    std::size_t count = 0;
    for (const Eigen::Vector3d& family : families)
        for (int shift = 0; shift < 3; ++shift)
            for (int signs = 0; signs < 8; ++signs) {
                if (family[0] == 0 && (signs & 1) != 0)
                    continue; // zero has no second sign
                Eigen::Vector3d corner;
                for (int axis = 0; axis < 3; ++axis)
                    corner[(axis + shift) % 3] = (signs >> axis & 1) != 0 ? -family[axis] : family[axis];
                corners[count++] = corner;
            }
    return corners;
}

/// A Gaussian is the product of one factor per axis: tables of size * 60 numbers take the place of size^3 * 60
/// exponentials.
struct GaussianTables {
    std::uint32_t size = 0;
    std::array<std::vector<double>, 3> factors; ///< factors[axis][atom * size + i]
};

GaussianTables gaussianTables(std::uint32_t size, double reach, double width)
{
    constexpr double bond = 1.43;
    const std::array<Eigen::Vector3d, atomCount> atoms = truncatedIcosahedron();
    const std::vector<double> coordinates = axisCoordinates(size);
    GaussianTables tables{size, {}};
    for (int axis = 0; axis < 3; ++axis)
        for (const Eigen::Vector3d& atom : atoms)
            for (const double coordinate : coordinates) {
                const double distance = (coordinate * reach - atom[axis] * (bond / 2)) / width;
                tables.factors[axis].push_back(portableExponential(-0.5 * distance * distance));
            }
    return tables;
}

} // namespace

RowFunction c60Density(std::uint32_t size)
{
    constexpr double reach = 4.7;
    constexpr double width = 0.62;
    constexpr double largest = 1.218187078; // near each atom, a little inside the cage; found by search, rounded up
    return [tables = gaussianTables(size, reach, width)](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        std::ranges::fill(row, 0.0);
        for (std::size_t atom = 0; atom < atomCount; ++atom) {
            const std::size_t first = atom * tables.size;
            const double weight = tables.factors[1][first + j] * tables.factors[2][first + k] / largest;
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] += weight * tables.factors[0][first + i];
        }
    };
}

namespace {

/// Probability density of the hydrogen atom's 3d electron with m = 0: |psi|^2 over its largest value,
/// ((3 z^2 - r^2) / 72)^2 exp(4 - 2 r / 3), lengths in Bohr radii, which the cube holds 20 of from its centre along
/// each axis. (The wave function is in every text on quantum mechanics, e.g. Griffiths, section 4.2.)
RowFunction hydrogenDensity(std::uint32_t size)
{
    return [places = axisCoordinates(size)](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        constexpr double reach = 20;
        const double y = reach * places[j];
        const double z = reach * places[k];
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double x = reach * places[i];
            const double radiusSquared = x * x + y * y + z * z;
            const double amplitude = (3 * z * z - radiusSquared) / 72;
            row[i] = amplitude * amplitude * portableExponential(4 - std::sqrt(radiusSquared) * 2 / 3);
        }
    };
}

} // namespace

RowFunction marschnerLobbSignal(std::uint32_t size)
{
    return [places = axisCoordinates(size)](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        constexpr double frequency = 6;
        constexpr double ripple = 0.25;
        const double slope = 1 - portableCosineOfTurns(places[k] / 4 - 0.25); // the sine of a quarter turn times z
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double radius = std::sqrt(places[i] * places[i] + places[j] * places[j]);
            const double wave = portableCosineOfTurns(frequency * portableCosineOfTurns(radius / 4));
            row[i] = (slope + ripple * (1 + wave)) / (2 * (1 + ripple));
        }
    };
}

namespace {

/// White noise: sample n is the top 53 bits of the n-th number of SplitMix64 (Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014) from `seed`. No sample tells of its neighbour: the worst case.
RowFunction whiteNoise(std::uint32_t size, std::uint64_t seed)
{
    return [size, seed](std::uint32_t j, std::uint32_t k, std::span<double> row) {
        const std::uint64_t first = (std::uint64_t(k) * size + j) * size;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::uint64_t bits = splitMix(seed + (first + i + 1) * splitMixStep);
            row[i] = static_cast<double>(bits >> 11) * 0x1p-53;
        }
    };
}

/// The sine and cosine of an angle in turns. Exact at multiples of a quarter.
struct GridDirection {
    double cosine;
    double sine;
};

GridDirection direction(double turns)
{
    return {portableCosineOfTurns(turns), portableCosineOfTurns(turns - 0.25)};
}

/// 0 far below, 1 far above.
double smoothStep(double x)
{
    return 1 / (1 + portableExponential(-x));
}

/// `x` in whole parts of 2^-bits.
double roundedTo(int bits, double x)
{
    return std::ldexp(std::floor(std::ldexp(x, bits) + 0.5), -bits);
}

/// Points of equal k lie exactly in a plane with the axis, in floats, too: otherwise cells at the axis, which have no
/// volume, would be turned over by rounding.
GridPoint bluntBody(const std::array<double, 3>& place)
{
    const double radius = 1 + place[0] * (0.7 + 1.3 * place[0]);
    const GridDirection fromAxis = direction(place[1] / 4);
    const GridDirection around = direction(place[2] / 2);
    const double shock = 1.5 + 0.6 * (1 - fromAxis.cosine);
    const double inside = smoothStep((shock - radius) / 0.05);
    const double strength = 0.3 + 0.7 * fromAxis.cosine * fromAxis.cosine;
    const double distance = roundedTo(11, radius * fromAxis.sine); // with 10 bits more it fits the 24 of a float
    return {
        {-radius * fromAxis.cosine, distance * roundedTo(10, around.cosine), -distance * roundedTo(10, around.sine)},
        inside * strength / (radius * radius)};
}

GridPoint oGrid(const std::array<double, 3>& place)
{
    constexpr double length = 4;
    const GridDirection around = direction(place[0]);
    const double radius = 0.5 * portableExponential(3 * place[1]);
    const double inverseSquare = 0.25 / (radius * radius);
    const double outwards = (1 - inverseSquare) * around.cosine;
    const double along = -(1 + inverseSquare) * around.sine;
    const double pressure = 1 - outwards * outwards - along * along; // from -3 to 1
    const double span = 0.7 + 0.3 * direction(place[2]).cosine;
    return {{radius * around.cosine, radius * around.sine, length * place[2]}, 0.75 + 0.25 * pressure * span};
}

GridPoint bentDuct(const std::array<double, 3>& place)
{
    const GridDirection bend = direction(place[0] / 4);
    const double radius = 1.5 + place[1];
    const double profile = 16 * place[1] * (1 - place[1]) * place[2] * (1 - place[2]);
    const double shifted = 1 + 0.8 * (place[1] - 0.5) * bend.sine;
    return {{radius * bend.cosine, radius * bend.sine, place[2]}, profile * shifted / 1.04};
}

GridPoint stretched(const std::array<double, 3>& place)
{
    const double x = 4 * place[0];
    const double y = (portableExponential(4 * place[1]) - 1) / (portableExponential(4) - 1);
    const double z = 2 * place[2] * place[2];
    const double thickness = 0.02 + 0.05 * x;
    return {{x, y, z}, (1 - portableExponential(-y / thickness)) * (0.9 + 0.1 * direction(z / 2).cosine)};
}

/// The grid called `name`, empty if there is none. The kinds of trouble that real grids have:
/// - "blunt-body": the flow in front of a hemisphere. i goes from the body outwards, j from the axis, where all points
///   of k coincide (a collapsed axis, S6), k half around it. The field is the density behind a bow shock.
/// - "o-grid": potential flow around a cylinder. i goes around and the last plane is the first one, j outwards, getting
///   coarser, k along the cylinder; left-handed. The field is the pressure.
/// - "bent-duct": a square duct that turns by 90 degrees, i along it. The field is the speed, faster on the outside.
/// - "stretched": a box with spacings that grow from one wall (rectilinear). The field is a layer at that wall.
GridFunction gridFunction(std::string_view name)
{
    if (name == "blunt-body")
        return bluntBody;
    if (name == "o-grid")
        return oGrid;
    if (name == "bent-duct")
        return bentDuct;
    if (name == "stretched")
        return stretched;
    return {};
}

/// In [-1, 1) and a multiple of 2^-23: a float holds it, and a double the squares and their sums without rounding.
double ScatteredBall::nextCoordinate()
{
    state_ += splitMixStep;
    return static_cast<double>(splitMix(state_) >> 40) * 0x1p-23 - 1;
}

ScatteredPoint ScatteredBall::next()
{
    ScatteredPoint point;
    do {
        for (double& coordinate : point.position)
            coordinate = nextCoordinate();
    } while (point.position.squaredNorm() > 1);
    const double turns = 1.5 * point.position.squaredNorm() + point.position[2] / 2;
    point.value = (1 + portableCosineOfTurns(turns)) / 2;
    return point;
}

constexpr std::uint32_t tilesAlongX = 3, tilesAlongY = 2;
constexpr double tileEdge = 2, holeRadius = 0.5, thickness = 1;
/// The tile with the cavity.
constexpr std::uint32_t closedX = 1, closedY = 1;

using PlanePlace = Eigen::Vector2d;

struct Quadrilateral {
    std::array<std::uint32_t, 4> corners;
    bool overCavity;
};

PlanePlace centreOf(std::uint32_t tileX, std::uint32_t tileY)
{
    return {tileEdge * (tileX + 0.5), tileEdge * (tileY + 0.5)};
}

/// The plan of the plate: rings of quadrilaterals between circles and squares; in the cavity's tile also within.
class Plan {
public:
    explicit Plan(std::uint32_t edgeCells) : edgeCells_(edgeCells), ringCells_(edgeCells / 2 + 1)
    {
        for (std::uint32_t y = 0; y < tilesAlongY; ++y)
            for (std::uint32_t x = 0; x < tilesAlongX; ++x)
                addTile(x, y);
    }
    const std::vector<PlanePlace>& places() const { return places_; }
    const std::vector<Quadrilateral>& cells() const { return cells_; }

private:
    using Index = std::pair<std::uint32_t, std::uint32_t>;

    /// Of the points around a square of edgeCells_^2 cells, counterclockwise.
    Index around(std::uint32_t step) const
    {
        const std::uint32_t side = step / edgeCells_ % 4, along = step % edgeCells_;
        switch (side) {
        case 0: return {along, 0};
        case 1: return {edgeCells_, along};
        case 2: return {edgeCells_ - along, edgeCells_};
        default: return {0, edgeCells_ - along};
        }
    }
    /// In [-1, 1]^2.
    PlanePlace onSquare(const Index& index) const
    {
        return {2.0 * index.first / edgeCells_ - 1, 2.0 * index.second / edgeCells_ - 1};
    }

    std::uint32_t add(const PlanePlace& place)
    {
        places_.push_back(place);
        return static_cast<std::uint32_t>(places_.size() - 1);
    }
    /// Neighbouring tiles have the points on their common edge together.
    std::uint32_t edgePoint(std::uint32_t tileX, std::uint32_t tileY, const Index& index)
    {
        const Index key{tileX * edgeCells_ + index.first, tileY * edgeCells_ + index.second};
        const auto [found, isNew] = edgePoints_.emplace(key, 0);
        if (isNew)
            found->second = add({tileEdge * key.first / edgeCells_, tileEdge * key.second / edgeCells_});
        return found->second;
    }

    void addTile(std::uint32_t tileX, std::uint32_t tileY)
    {
        const PlanePlace centre = centreOf(tileX, tileY);
        const std::uint32_t steps = 4 * edgeCells_;
        std::vector<std::vector<std::uint32_t>> rings(ringCells_ + 1);
        for (std::uint32_t ring = 0; ring <= ringCells_; ++ring)
            for (std::uint32_t step = 0; step < steps; ++step) {
                const PlanePlace corner = onSquare(around(step));
                const double part = static_cast<double>(ring) / ringCells_;
                const double outwards = part * (0.5 + 0.5 * part); // finer at the hole
                const PlanePlace inner = holeRadius * corner / corner.norm();
                const PlanePlace outer = tileEdge / 2 * corner;
                rings[ring].push_back(ring == ringCells_ ? edgePoint(tileX, tileY, around(step))
                                                         : add(centre + inner + outwards * (outer - inner)));
            }
        for (std::uint32_t ring = 0; ring < ringCells_; ++ring)
            for (std::uint32_t step = 0; step < steps; ++step) {
                const std::uint32_t next = (step + 1) % steps;
                cells_.push_back(
                    {{rings[ring][step], rings[ring + 1][step], rings[ring + 1][next], rings[ring][next]}, false});
            }
        if (tileX == closedX && tileY == closedY)
            addCore(centre, rings[0]);
    }

    void addCore(const PlanePlace& centre, const std::vector<std::uint32_t>& circle)
    {
        std::map<Index, std::uint32_t> points;
        for (std::uint32_t step = 0; step < circle.size(); ++step)
            points[around(step)] = circle[step];
        for (std::uint32_t j = 1; j < edgeCells_; ++j)
            for (std::uint32_t i = 1; i < edgeCells_; ++i) {
                // Squares that become round outwards.
                const PlanePlace place = onSquare({i, j});
                const double outwards = place.cwiseAbs().maxCoeff();
                const double length = place.norm();
                const PlanePlace onDisk = length > 0 ? PlanePlace(place * (outwards / length)) : place;
                constexpr double squareness = 0.7;
                points[{i, j}] = add(centre + holeRadius * (outwards * onDisk + (1 - outwards) * squareness * place));
            }
        for (std::uint32_t j = 0; j < edgeCells_; ++j)
            for (std::uint32_t i = 0; i < edgeCells_; ++i)
                cells_.push_back(
                    {{points[{i, j}], points[{i + 1, j}], points[{i + 1, j + 1}], points[{i, j + 1}]}, true});
    }

    std::uint32_t edgeCells_;
    std::uint32_t ringCells_;
    std::vector<PlanePlace> places_;
    std::vector<Quadrilateral> cells_;
    std::map<Index, std::uint32_t> edgePoints_;
};

/// xx, yy and xy of what a hole around the origin changes of a stress of 1 along x.
Eigen::Vector3d stressOfHole(const PlanePlace& place)
{
    const double square = std::max(place.squaredNorm(), holeRadius * holeRadius);
    const double length = std::max(place.squaredNorm(), 1e-30);
    const double ratio = holeRadius * holeRadius / square;
    const double cosine = (place[0] * place[0] - place[1] * place[1]) / length; // of the double angle
    const double sine = 2 * place[0] * place[1] / length;
    const double radial = (1 - ratio) / 2 + (1 - 4 * ratio + 3 * ratio * ratio) / 2 * cosine;
    const double around = (1 + ratio) / 2 - (1 + 3 * ratio * ratio) / 2 * cosine;
    const double shear = -(1 + 2 * ratio - 3 * ratio * ratio) / 2 * sine;
    const double mean = (radial + around) / 2, difference = (radial - around) / 2;
    return {mean + difference * cosine - shear * sine - 1, mean - difference * cosine + shear * sine,
            difference * sine + shear * cosine};
}

double stressAt(const Eigen::Vector3d& position)
{
    constexpr double largest = 3.2;
    Eigen::Vector3d stress(1, 0, 0);
    for (std::uint32_t y = 0; y < tilesAlongY; ++y)
        for (std::uint32_t x = 0; x < tilesAlongX; ++x) {
            // The cavity weakens the plate most in its middle.
            const double fromMiddle = (position[2] - thickness / 2) / (thickness / 3);
            const double share = x == closedX && y == closedY ? 1 / (1 + fromMiddle * fromMiddle) : 1;
            stress += share * stressOfHole(position.head<2>() - centreOf(x, y));
        }
    const double xx = stress[0], yy = stress[1], xy = stress[2];
    const double equivalent = std::sqrt(std::max(xx * xx - xx * yy + yy * yy + 3 * xy * xy, 0.0));
    return std::min(equivalent / largest, 1.0);
}

/// Three tetrahedra between two copies of a triangle; prisms that share a side cut it alike, for the order of the
/// vertices decides.
void addPrism(std::array<std::uint32_t, 3> triangle, std::uint32_t below, std::uint32_t above, AnalyticMesh& mesh)
{
    std::ranges::sort(triangle);
    const auto [a, b, c] = triangle;
    for (std::array<std::uint32_t, 4> piece : {std::array<std::uint32_t, 4>{a + below, b + below, c + below, c + above},
                                               {a + below, b + below, b + above, c + above},
                                               {a + below, a + above, b + above, c + above}}) {
        const Eigen::Vector3d origin = mesh.positions[piece[0]];
        const auto edge = [&](std::size_t i) { return (mesh.positions[piece[i]] - origin).eval(); };
        if (edge(1).dot(edge(2).cross(edge(3))) < 0)
            std::swap(piece[2], piece[3]);
        mesh.tetrahedra.push_back(piece);
    }
}

void dropUnused(AnalyticMesh& mesh)
{
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> numbers(mesh.positions.size(), unused);
    for (const auto& tetrahedron : mesh.tetrahedra)
        for (const std::uint32_t point : tetrahedron)
            numbers[point] = 0;
    std::uint32_t kept = 0;
    for (std::size_t point = 0; point < numbers.size(); ++point)
        if (numbers[point] != unused) {
            mesh.positions[kept] = mesh.positions[point];
            numbers[point] = kept++;
        }
    mesh.positions.resize(kept);
    for (auto& tetrahedron : mesh.tetrahedra)
        for (std::uint32_t& point : tetrahedron)
            point = numbers[point];
}

} // namespace

AnalyticMesh analyticPart(std::uint32_t size)
{
    constexpr std::uint32_t sizeOfCell = 8, layersOfThird = 3;
    const std::uint32_t edgeCells = std::max<std::uint32_t>(2, size / sizeOfCell);
    const std::uint32_t third = std::max<std::uint32_t>(1, edgeCells / layersOfThird), layers = 3 * third;
    const Plan plan(edgeCells);
    const auto perLayer = static_cast<std::uint32_t>(plan.places().size());
    AnalyticMesh mesh;
    mesh.positions.reserve(std::size_t(perLayer) * (layers + 1));
    for (std::uint32_t layer = 0; layer <= layers; ++layer)
        for (const PlanePlace& place : plan.places()) {
            const Eigen::Vector3d position(place[0], place[1], thickness * layer / layers);
            mesh.positions.push_back(position.cast<float>().cast<double>()); // files and models stay small
        }
    for (std::uint32_t layer = 0; layer < layers; ++layer)
        for (const auto& [corners, overCavity] : plan.cells()) {
            if (overCavity && layer / third == 1)
                continue;
            const auto first = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
            const std::uint32_t below = layer * perLayer, above = below + perLayer;
            for (std::size_t i = 1; i < 3; ++i)
                addPrism({corners[first], corners[(first + i) % 4], corners[(first + i + 1) % 4]}, below, above, mesh);
        }
    dropUnused(mesh);
    for (const Eigen::Vector3d& position : mesh.positions)
        mesh.values.push_back(stressAt(position));
    return mesh;
}

namespace {

constexpr std::array<SampleKind, 10> kinds = {{
    {"c60", Message::marked("electron density of the C60 molecule, a hollow ball of smooth bumps"), SampleType::UInt8},
    {"hydrogen", Message::marked("probability density of the hydrogen atom's 3d electron: two lobes and a ring"),
     SampleType::Float32},
    {"marschner-lobb", Message::marked("the test signal of Marschner and Lobb: ripples that are hard to reproduce"),
     SampleType::Float32},
    {"noise", Message::marked("white noise, the worst case: no sample predicts its neighbour"), SampleType::UInt8,
     DomainClass::RegularLattice, true},
    {"blunt-body", Message::marked("flow in front of a hemisphere: a curvilinear grid whose axis is collapsed"),
     SampleType::Float32, DomainClass::Curvilinear},
    {"o-grid", Message::marked("flow around a cylinder: a curvilinear grid that closes on itself"), SampleType::Float32,
     DomainClass::Curvilinear},
    {"bent-duct", Message::marked("flow through a bent duct: a curvilinear grid"), SampleType::Float32,
     DomainClass::Curvilinear},
    {"stretched", Message::marked("a layer at a wall: a rectilinear grid with growing spacing"), SampleType::Float32,
     DomainClass::Curvilinear},
    {"scattered", Message::marked("random points in a ball, with waves that become finer outwards"),
     SampleType::Float32, DomainClass::Scattered, true},
    {"part", Message::marked("stress in a plate with five holes and a closed cavity: an irregular mesh"),
     SampleType::Float32, DomainClass::Irregular},
}};

RowFunction rowFunction(const SampleRequest& request)
{
    if (request.name == "c60")
        return c60Density(request.size);
    if (request.name == "hydrogen")
        return hydrogenDensity(request.size);
    if (request.name == "marschner-lobb")
        return marschnerLobbSignal(request.size);
    return whiteNoise(request.size, request.seed);
}

Error unknownKind(std::string_view name)
{
    std::string names;
    for (const SampleKind& kind : kinds)
        names += " " + std::string(kind.name);
    return {ErrorKind::WrongUsage, Message::say("There is no sample called '%1'. Available:%2.", name, names)};
}

template <class T> void quantise(std::span<const double> values, T* samples)
{
    std::ranges::transform(values, samples, [](double value) {
        if constexpr (std::is_integral_v<T>)
            return static_cast<T>(std::floor(std::min(value, 1.0) * std::numeric_limits<T>::max() + 0.5));
        else
            return static_cast<T>(value);
    });
}

using PlaneFunction = std::function<void(std::uint32_t k)>;

/// Makes all planes of the sample, on all threads.
Status forEachPlane(std::uint32_t size, const Progress& progress, const PlaneFunction& plane)
{
    constexpr MarkedText activity = Message::marked("Making the sample");
    std::mutex reporting;
    std::uint32_t planesDone = 0;
    tbb::parallel_for(std::uint32_t(0), size, [&](std::uint32_t k) {
        if (progress.cancelled())
            return;
        plane(k);
        const std::scoped_lock lock(reporting);
        progress.report(++planesDone / static_cast<double>(size), activity);
    });
    if (progress.cancelled())
        return cancelledError(activity);
    return {};
}

void storeRow(std::span<const double> row, SampleType type, std::uint64_t first, std::byte* samples)
{
    visitSampleType(type, [&]<class T>() { quantise(row, reinterpret_cast<T*>(samples) + first); });
}

Status fillCube(const RowFunction& rows, SampleType type, std::uint32_t size, std::byte* samples,
                const Progress& progress)
{
    return forEachPlane(size, progress, [&](std::uint32_t k) {
        std::vector<double> row(size);
        for (std::uint32_t j = 0; j < size; ++j) {
            rows(j, k, row);
            storeRow(row, type, (std::uint64_t(k) * size + j) * size, samples);
        }
    });
}

Status fillGrid(const GridFunction& grid, SampleType type, std::uint32_t size, std::byte* samples,
                std::vector<Eigen::Vector3d>& positions, const Progress& progress)
{
    const auto fraction = [size](std::uint32_t index) { return index / (size - 1.0); };
    return forEachPlane(size, progress, [&](std::uint32_t k) {
        std::vector<double> row(size);
        for (std::uint32_t j = 0; j < size; ++j) {
            const std::uint64_t first = (std::uint64_t(k) * size + j) * size;
            for (std::uint32_t i = 0; i < size; ++i) {
                const GridPoint point = grid({fraction(i), fraction(j), fraction(k)});
                positions[first + i] = point.position.cast<float>().cast<double>(); // files and models stay small
                row[i] = point.value;
            }
            storeRow(row, type, first, samples);
        }
    });
}

/// On one thread: each random number follows from the one before.
Status fillBall(std::uint64_t seed, SampleType type, std::byte* samples, std::vector<Eigen::Vector3d>& positions,
                const Progress& progress)
{
    constexpr std::size_t pointsBetweenReports = 1 << 14;
    constexpr MarkedText activity = Message::marked("Making the sample");
    ScatteredBall ball(seed);
    std::vector<double> row;
    for (std::size_t first = 0; first < positions.size(); first += row.size()) {
        if (progress.cancelled())
            return cancelledError(activity);
        row.resize(std::min(pointsBetweenReports, positions.size() - first));
        for (std::size_t i = 0; i < row.size(); ++i) {
            const ScatteredPoint point = ball.next();
            positions[first + i] = point.position;
            row[i] = point.value;
        }
        storeRow(row, type, first, samples);
        progress.report(static_cast<double>(first + row.size()) / static_cast<double>(positions.size()), activity);
    }
    return {};
}

bool onGrid(const SampleKind& kind)
{
    return kind.domain == DomainClass::RegularLattice || kind.domain == DomainClass::Curvilinear;
}

std::string nameOf(const SampleKind& kind, std::uint32_t size, std::uint64_t points)
{
    const std::string edge = std::to_string(size);
    return std::string(kind.name) + " " + (onGrid(kind) ? edge + "x" + edge + "x" + edge : std::to_string(points));
}

/// A mesh, on one thread.
Result<Dataset> partDataset(SampleType type, std::uint32_t size, const Progress& progress)
{
    AnalyticMesh mesh = analyticPart(size);
    if (progress.cancelled())
        return cancelledError(Message::marked("Making the sample"));
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(type, mesh.values.size());
    if (!samples)
        return samples.error();
    storeRow(mesh.values, type, 0, samples->get());
    Dataset dataset;
    dataset.lattice.size = {static_cast<std::uint32_t>(mesh.values.size()), 1, 1};
    dataset.values = ScalarField(type, mesh.values.size(), *std::move(samples));
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(mesh.positions));
    dataset.tetrahedra = std::make_shared<const std::vector<std::array<std::uint32_t, 4>>>(std::move(mesh.tetrahedra));
    return dataset;
}

Dataset described(Dataset dataset, const SampleKind& kind, std::uint32_t size)
{
    dataset.domain = kind.domain;
    if (dataset.domain == DomainClass::Curvilinear) // meshes are looked at where they are made
        dataset.convex = hasConvexDomain(dataset);
    dataset.source.name = nameOf(kind, size, dataset.pointCount());
    dataset.source.hash = contentHash(dataset.values, dataset.positions, dataset.tetrahedra);
    return dataset;
}

Status checkSize(const SampleKind& kind, std::uint32_t size)
{
    const std::uint32_t largest = onGrid(kind) ? largestSampleSize : largestScatteredSize;
    if (size >= smallestSampleSize && size <= largest)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("The sample '%1' has from %2 to %3 points along each axis, not %4.", kind.name,
                              smallestSampleSize, largest, size)};
}

} // namespace

std::span<const SampleKind> sampleKinds()
{
    return kinds;
}

Result<Dataset> makeSample(const SampleRequest& request, const Progress& progress)
try {
    const auto kind = std::ranges::find(kinds, request.name, &SampleKind::name);
    if (kind == kinds.end())
        return unknownKind(request.name);
    if (const Status fits = checkSize(*kind, request.size); !fits)
        return fits.error();
    const SampleType type = request.type.value_or(kind->type);
    if (kind->domain == DomainClass::Irregular) {
        Result<Dataset> part = partDataset(type, request.size, progress);
        return part ? described(*std::move(part), *kind, request.size) : part;
    }
    Dataset dataset;
    dataset.lattice.size = {request.size, request.size, request.size};
    const std::uint64_t count = dataset.lattice.pointCount();
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(type, count);
    if (!samples)
        return samples.error();
    Status filled;
    if (const GridFunction grid = gridFunction(request.name)) {
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(count);
        filled = fillGrid(grid, type, request.size, samples->get(), *positions, progress);
        dataset.positions = std::move(positions);
    } else if (kind->domain == DomainClass::Scattered) {
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(count);
        filled = fillBall(request.seed, type, samples->get(), *positions, progress);
        dataset.positions = std::move(positions);
        dataset.lattice.size = {static_cast<std::uint32_t>(count), 1, 1};
    } else {
        filled = fillCube(rowFunction(request), type, request.size, samples->get(), progress);
    }
    if (!filled)
        return filled.error();
    dataset.values = ScalarField(type, count, *std::move(samples));
    return described(std::move(dataset), *kind, request.size);
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 Message::say("Not enough memory to make the sample. Choose a smaller size.")};
}

} // namespace tetra
