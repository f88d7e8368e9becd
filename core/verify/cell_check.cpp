// SPDX-License-Identifier: GPL-3.0-or-later
// One loop looks at the cells of a mesh, whatever the domain: how a cell is turned, which samples lie in it, and what
// the residual is there. How that is known is what a kind of residual says: LatticeErrors, GridWarpings, PointErrors.
#include "core/verify/cell_check.h"

#include "core/base/rounding.h"
#include "core/mesh/tetrahedron_planes.h"
#include "core/mesh/topology.h"
#include "core/verify/error_in_space.h"
#include "core/verify/verify_irregular.h"
#include "core/verify/verify_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace tetra {

Original::Original(const Dataset& given) : dataset(given), extent(given.values.range().extent())
{
    const Eigen::AlignedBox3d bounds = given.bounds();
    diagonal = bounds.diagonal().norm();
    warpingAllowance = allowedWarping(bounds);
}

Result<Original> Original::make(const Model& model, const Dataset& dataset, std::vector<std::string>& failures,
                                const Progress& progress)
{
    Original original(dataset);
    if (dataset.domain == DomainClass::Curvilinear) {
        auto made = CurvilinearOriginal::make(dataset, model.description().leftHanded, failures, progress);
        if (!made)
            return made.error();
        original.curvilinear = *std::move(made);
        original.gridPoints.emplace(dataset);
    } else if (dataset.domain == DomainClass::Scattered) {
        original.scattered.emplace(dataset);
    } else if (dataset.domain == DomainClass::Irregular) {
        original.irregular.emplace(dataset, failures);
    }
    return original;
}

Residual Residual::error(const MeshToVerify& mesh)
{
    const double extent = mesh.original.extent;
    return {mesh, "error", "range", extent, 1e-12 * extent, &MeshBounds::error, mesh.model.ownErrors()};
}

Residual Residual::warping(const MeshToVerify& mesh)
{
    const double diagonal = mesh.original.diagonal, allowance = mesh.original.warpingAllowance;
    return {mesh, "warping", "diagonal", diagonal, allowance, &MeshBounds::warping, mesh.model.ownWarpings()};
}

double Residual::own(std::size_t cell) const
{
    const auto number = mesh.cells.historyNumber(cell);
    return number ? static_cast<double>(halfToFloat(ownOfHistory[*number])) * size
                  : std::numeric_limits<double>::infinity();
}

std::string Residual::moreThanClaimed(std::uint64_t sample, const std::string& at, double residual) const
{
    return "The " + std::string(name) + " at " + at + " is " + textOf(percent(residual)) + " % of the " +
           std::string(whole) + ", more than the claimed " + textOf(percent(claimed(sample))) + " %";
}

namespace {

std::string nameOfSample(const Original& original, std::uint64_t sample)
{
    if (!isOnLattice(original.dataset.domain))
        return "point " + std::to_string(sample) + " " + textOf(original.points().positions[sample]);
    const auto c = original.dataset.lattice.coordinates(sample);
    return "sample " + textOf(LatticePoint{c[0], c[1], c[2]});
}

/// How a cell is turned in the space in which a kind of residual looks at it.
enum class Turn {
    FoundAlready, ///< not positive where another kind looks
    Flat,
    Inverted,
    Positive, ///< the first that interpolates
    FlatInSpace,
    AllowedInSpace, ///< inverted in physical space as the grid itself is
    InvertedInSpace,
};

Turn turnOf(std::int64_t sign)
{
    return sign > 0 ? Turn::Positive : sign == 0 ? Turn::Flat : Turn::Inverted;
}

template <class Corners> void noteTurn(CellFindings& found, Turn turn, std::size_t number, const Corners& corners)
{
    const auto add = [&](const char* before, const char* after) {
        found.turned.add(number, [&] { return before + textOf(corners) + after; });
    };
    switch (turn) {
    case Turn::FoundAlready:
    case Turn::Positive: return;
    case Turn::Flat: return add("Flat cell with corners ", ".");
    case Turn::Inverted: return add("Inverted cell with corners ", ".");
    case Turn::FlatInSpace: ++found.degenerate; return;
    case Turn::AllowedInSpace: ++found.allowed; return;
    case Turn::InvertedInSpace: return add("Cell with corners ", " is inverted in physical space.");
    }
}

/// The one check of a mesh's cells. A kind has
/// - cell(number): the cell's `corners` and what else it needs,
/// - turn(cell), and forEachSample(cell, visit), which calls visit(sample, residual) for every sample in a closed cell
///   that interpolates; residuals are weighted (R6) and of the type Number,
/// - bound(cell, value): what residuals may reach that are claimed to be at most `value`, and value(cell, residual),
/// - tellsOfEachSample: of those beyond the claim; else of the largest one of each cell.
template <class Kind> Status checkEveryCell(const Kind& kind, CellFindings& found, const Progress& progress)
{
    using Number = typename Kind::Number;
    const Residual& residual = kind.residual;
    const MeshToVerify& mesh = residual.mesh;
    const bool uniform = mesh.bounds.areUniform();
    const auto checkCell = [&](std::size_t number) {
        const auto cell = kind.cell(number);
        const Turn turn = kind.turn(cell);
        noteTurn(found, turn, number, cell.corners);
        if (turn < Turn::Positive)
            return; // a flat cell interpolates nothing
        const auto addBeyond = [&](std::uint64_t place, std::uint64_t sample, Number size) {
            found.beyondClaim.add(place, [&] {
                return residual.moreThanClaimed(sample, nameOfSample(mesh.original, sample), kind.value(cell, size)) +
                       ", in the cell with corners " + textOf(cell.corners) + ".";
            });
        };
        const Number own = kind.bound(cell, residual.own(number));
        const Number claimed = uniform ? kind.bound(cell, residual.claimed(0)) : Number(0);
        Number worstBeyond = 0; ///< of those larger than what is claimed
        std::uint64_t sampleBeyond = 0;
        kind.forEachSample(cell, [&](std::uint64_t sample, Number size) {
            found.mark(sample, size <= own);
            if (const auto several = found.numberOfSeveral(sample)) {
                found.leastOfSeveral.lower(*several, kind.value(cell, size));
                return;
            }
            if (size > 0)
                found.residuals.raise(sample, kind.value(cell, size));
            if (!(size > worstBeyond && size > (uniform ? claimed : kind.bound(cell, residual.claimed(sample)))))
                return;
            if constexpr (Kind::tellsOfEachSample) {
                addBeyond(sample, sample, size);
            } else {
                worstBeyond = size;
                sampleBeyond = sample;
            }
        });
        if (worstBeyond > 0)
            addBeyond(number, sampleBeyond, worstBeyond);
    };
    return verifyEach(mesh.cells.size(), Kind::cellsAtOnce, Kind::activity, progress, checkCell);
}

/// The claim at samples with several values: the cell that comes closest counts.
void checkSeveralValued(const Residual& residual, CellFindings& found)
{
    for (std::size_t number = 0; number < found.severalValued.size(); ++number) {
        const std::uint32_t sample = found.severalValued[number];
        const double least = found.leastOfSeveral.at(number);
        if (!found.isCovered(sample))
            continue;
        found.residuals.raise(sample, least);
        if (least > residual.claimed(sample) + residual.allowance)
            found.beyondClaim.add(sample, [&] {
                return residual.moreThanClaimed(sample, nameOfSample(residual.mesh.original, sample), least) +
                       ", in every cell that holds it.";
            });
    }
}

/// What the check of all cells says of samples. That one lies in no cell is told with the errors alone.
void moveSamplesTo(const Residual& residual, bool tellsOfUncovered, CellFindings& found, LevelReport& verdict)
{
    const MeshToVerify& mesh = residual.mesh;
    Findings notCovered;
    Findings beyondOwn;
    const bool ofHistory = mesh.ofHistory();
    for (std::uint64_t sample = 0; sample < found.states.size(); ++sample)
        if (tellsOfUncovered && !found.isCovered(sample))
            notCovered.add(sample, [&] {
                std::string name = nameOfSample(mesh.original, sample);
                name[0] = name[0] == 's' ? 'S' : 'P';
                return name + " lies in no cell.";
            });
        else if (ofHistory && !found.isWithinOwn(sample))
            beyondOwn.add(sample, [&] {
                std::string text = "The ";
                text.append(residual.name).append(" at ").append(nameOfSample(mesh.original, sample));
                text.append(" is larger than the own ").append(residual.name).append(" of every cell that holds it.");
                return text;
            });
    verdict.covers = verdict.covers && notCovered.none();
    for (Findings* findings : {&notCovered, &found.beyondClaim, &beyondOwn})
        findings->moveTo(verdict.failures);
}

/// Calls function(sample, weights) for every lattice point in the closed cell, which is positive, row by row: weights
/// are six volumes times its barycentric coordinates, exact.
template <class Function>
void forEachLatticePoint(const Lattice& lattice, const LatticeCorners& corners, Function&& function)
{
    // Each coordinate is zero on one face and, inwards, six volumes at the corner opposite to it.
    std::array<LatticePoint, 4> normals;
    LatticePoint low = corners[0];
    LatticePoint high = corners[0];
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto& [first, second, third] = cornersOfFace[corner];
        normals[corner] =
            crossProduct(difference(corners[third], corners[first]), difference(corners[second], corners[first]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], corners[corner][axis]);
            high[axis] = std::max(high[axis], corners[corner][axis]);
        }
    }
    for (std::int64_t k = low[2]; k <= high[2]; ++k)
        for (std::int64_t j = low[1]; j <= high[1]; ++j) {
            std::array<std::int64_t, 4> weights;
            for (std::size_t corner = 0; corner < 4; ++corner)
                weights[corner] =
                    dotProduct(normals[corner], difference({low[0], j, k}, corners[cornersOfFace[corner][0]]));
            std::uint64_t sample = lattice.index(static_cast<std::uint32_t>(low[0]), static_cast<std::uint32_t>(j),
                                                 static_cast<std::uint32_t>(k));
            for (std::int64_t i = low[0]; i <= high[0]; ++i, ++sample) {
                if ((weights[0] | weights[1] | weights[2] | weights[3]) >= 0)
                    function(sample, weights);
                for (std::size_t corner = 0; corner < 4; ++corner)
                    weights[corner] += normals[corner][0];
            }
        }
}

/// Errors of linear interpolation in a cell of a lattice, comparable with what a model claims: numerators over the
/// cell's six volumes, integers without rounding. Weights are six volumes times barycentric coordinates. 8 and 16 bits:
/// below 2^40 * 2^17 * 4, fits 64 bits; 32 bits need 128.
template <class Sample> struct ExactNumbers {
    using Wide = __int128;
    using Number = std::conditional_t<sizeof(Sample) <= 2, std::int64_t, Wide>;

    static Number at(const std::array<std::int64_t, 4>& weights, const std::array<Sample, 4>& corners, Sample sample,
                     std::int64_t /*sixVolumes*/, double /*weight*/)
    {
        Number sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += static_cast<Number>(weights[i]) * (static_cast<Number>(corners[i]) - static_cast<Number>(sample));
        return sum < 0 ? -sum : sum;
    }

    /// floor(claimed * sixVolumes), or the largest Number if that is too large.
    static Number bound(double claimed, double /*allowance*/, std::int64_t sixVolumes)
    {
        constexpr Number half = Number(1) << (8 * sizeof(Number) - 2);
        constexpr Number largest = half - 1 + half;
        constexpr int digits = std::numeric_limits<double>::digits;
        if (!(claimed > 0) || sixVolumes <= 0)
            return 0;
        if (std::isinf(claimed))
            return largest;
        int exponent = 0;
        const double fraction = std::frexp(claimed, &exponent);
        exponent -= digits;
        Wide number = static_cast<Wide>(std::ldexp(fraction, digits)) * sixVolumes; // below 2^93
        if (exponent < 0)
            number = exponent <= -127 ? 0 : number >> -exponent;
        else if (exponent > 60 || number >> (126 - exponent) != 0)
            return largest;
        else
            number <<= exponent;
        return number > static_cast<Wide>(largest) ? largest : static_cast<Number>(number);
    }

    static double inUnits(Number error, std::int64_t sixVolumes)
    {
        return static_cast<double>(error) / static_cast<double>(sixVolumes);
    }
};

/// The same in units of the values, for what no integer holds: floating-point samples and weighted errors (R6).
template <class Sample> struct RoundedNumbers {
    using Number = double;

    static Number at(const std::array<std::int64_t, 4>& weights, const std::array<Sample, 4>& corners, Sample sample,
                     std::int64_t sixVolumes, double weight)
    {
        Number sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += static_cast<double>(weights[i]) / static_cast<double>(sixVolumes) *
                   (static_cast<double>(corners[i]) - static_cast<double>(sample));
        return std::abs(sum) * weight;
    }
    static Number bound(double claimed, double allowance, std::int64_t /*sixVolumes*/) { return claimed + allowance; }
    static double inUnits(Number error, std::int64_t /*sixVolumes*/) { return error; }
};

/// The error at the samples of a lattice, in computational space.
template <class Sample, class Numbers> struct LatticeErrors {
    using Number = typename Numbers::Number;
    static constexpr std::size_t cellsAtOnce = 1024;
    static constexpr MarkedText activity = Message::marked("Verifying the error at every sample");
    static constexpr bool tellsOfEachSample = false;

    struct Cell {
        LatticeCorners corners;
        std::int64_t volume; ///< six times
        std::array<Sample, 4> values;
    };

    const MeshToVerify& mesh;
    Residual residual = Residual::error(mesh);
    std::span<const Sample> samples = mesh.original.dataset.values.template as<Sample>();

    Cell cell(std::size_t number) const
    {
        const LatticeCorners corners = mesh.cells.corners(number);
        const auto [a, b, c, d] = mesh.cells.points(number);
        return {corners, sixVolumes(corners), {samples[a], samples[b], samples[c], samples[d]}};
    }
    Turn turn(const Cell& cell) const { return turnOf(cell.volume); }
    template <class Visit> void forEachSample(const Cell& cell, const Visit& visit) const
    {
        forEachLatticePoint(
            mesh.original.dataset.lattice, cell.corners, [&](std::uint64_t sample, const auto& weights) {
                visit(sample, Numbers::at(weights, cell.values, samples[sample], cell.volume, mesh.weight(sample)));
            });
    }
    Number bound(const Cell& cell, double error) const
    {
        return Numbers::bound(error, residual.allowance, cell.volume);
    }
    double value(const Cell& cell, Number error) const { return Numbers::inUnits(error, cell.volume); }
};

/// The warping at the samples of a curvilinear grid: in physical space, by the weights in computational space.
struct GridWarpings {
    using Number = double;
    static constexpr std::size_t cellsAtOnce = 256;
    static constexpr MarkedText activity = Message::marked("Verifying the warping at every sample");
    static constexpr bool tellsOfEachSample = false;

    struct Cell {
        LatticeCorners corners;
        std::int64_t volume; ///< six times
        PlacedCell places;
    };

    const MeshToVerify& mesh;
    const Dataset& dataset = mesh.original.dataset;
    Residual residual = Residual::warping(mesh);

    Cell cell(std::size_t number) const
    {
        const LatticeCorners corners = mesh.cells.corners(number);
        return {corners, sixVolumes(corners), placedCell(*dataset.positions, mesh.cells.points(number))};
    }
    Turn turn(const Cell& cell) const
    {
        const CurvilinearOriginal& grid = *mesh.original.curvilinear;
        if (cell.volume <= 0)
            return Turn::FoundAlready;
        const int sign = volumeSign(cell.places);
        return sign == 0                           ? Turn::FlatInSpace
               : sign == grid.hand()               ? Turn::Positive
               : grid.allowsInverted(cell.corners) ? Turn::AllowedInSpace
                                                   : Turn::InvertedInSpace;
    }
    template <class Visit> void forEachSample(const Cell& cell, const Visit& visit) const
    {
        forEachLatticePoint(dataset.lattice, cell.corners, [&](std::uint64_t sample, const auto& weights) {
            const Eigen::Vector3d place = dataset.position(sample);
            Eigen::Vector3d offset(0, 0, 0);
            for (std::size_t corner = 0; corner < 4; ++corner)
                offset += static_cast<double>(weights[corner]) / static_cast<double>(cell.volume) *
                          (cell.places[corner] - place);
            visit(sample, offset.norm() * mesh.weight(sample));
        });
    }
    double bound(const Cell&, double warping) const { return warping + residual.allowance; }
    double value(const Cell&, double warping) const { return warping; }
};

} // namespace

std::optional<Eigen::Vector3d> placeInside(const PlacedCell& cell)
{
    const Eigen::Vector3d middle = (cell[0] + cell[1] + cell[2] + cell[3]) / 4;
    return volumeSign(cell) > 0 && holdsInside(cell, middle) ? std::optional(middle) : std::nullopt;
}

std::size_t countHolding(std::span<const Eigen::Vector3d> positions, const LevelCells& cells,
                         const Eigen::Vector3d& place)
{
    std::atomic<std::size_t> count = 0;
    tbb::parallel_for(std::size_t(0), cells.size(), [&](std::size_t number) {
        const PlacedCell cell = placedCell(positions, cells.points(number));
        if (boxOf(cell).contains(place) && volumeSign(cell) > 0 && holds(cell, place))
            ++count;
    });
    return count;
}

namespace {

/// The error at original points, where exact signs say that a cell holds them.
struct PointErrors {
    using Number = double;
    static constexpr std::size_t cellsAtOnce = 256;
    static constexpr MarkedText activity = Message::marked("Verifying the error at every point");
    static constexpr bool tellsOfEachSample = true;

    struct Cell {
        PlacedCell corners;
        std::array<std::uint32_t, 4> points;
        std::array<double, 4> values;
        double own; ///< what the history grants it
    };

    const MeshToVerify& mesh;
    const ScatteredOriginal& original = mesh.original.points();
    Residual residual = Residual::error(mesh);

    Cell cell(std::size_t number) const
    {
        Cell cell;
        cell.points = mesh.cells.points(number);
        cell.corners = placedCell(original.positions, cell.points);
        for (std::size_t corner = 0; corner < 4; ++corner)
            cell.values[corner] = original.values[cell.points[corner]];
        cell.own = residual.own(number);
        return cell;
    }
    Turn turn(const Cell& cell) const { return turnOf(volumeSign(cell.corners)); }
    template <class Visit> void forEachSample(const Cell& cell, const Visit& visit) const
    {
        const TetrahedronPlanes planes(cell.corners);
        const auto mayMeet = [&planes](const Eigen::AlignedBox3d& box) { return planes.mayMeet(box); };
        original.tree.visitNear(mayMeet, [&](std::uint32_t point) {
            const Eigen::Vector3d& place = original.positions[point];
            if (std::ranges::find(cell.points, point) != cell.points.end())
                visit(point, 0);
            else if (holds(cell.corners, place))
                visit(point, errorAt(cell, point, place));
        });
    }
    /// With 113 bits where it is close to what is claimed or granted.
    double errorAt(const Cell& cell, std::uint32_t point, const Eigen::Vector3d& place) const
    {
        const double weight = mesh.weight(point);
        const CellError quick = quickError(cell.corners, cell.values, place, original.values[point]);
        if ((quick.error + quick.doubt) * weight <= std::min(cell.own, residual.claimed(point)))
            return weight * quick.error;
        return weight * preciseError(cell.corners, cell.values, place, original.values[point]);
    }
    double bound(const Cell&, double error) const { return error + residual.allowance; }
    double value(const Cell&, double error) const { return error; }
};

/// The check of all cells for errors, as the domain has them.
Status checkErrors(const MeshToVerify& mesh, CellFindings& found, const Progress& progress)
{
    const Dataset& dataset = mesh.original.dataset;
    if (!isOnLattice(dataset.domain))
        return checkEveryCell(PointErrors{mesh}, found, progress);
    return visitSampleType(dataset.values.type(), [&]<class Sample>() {
        using Rounded = RoundedNumbers<Sample>;
        using Exact = std::conditional_t<std::floating_point<Sample>, Rounded, ExactNumbers<Sample>>;
        // Builders round, too, if there are weights and for curvilinear data.
        if (!mesh.weights.empty() || dataset.domain == DomainClass::Curvilinear)
            return checkEveryCell(LatticeErrors<Sample, Rounded>{mesh}, found, progress);
        return checkEveryCell(LatticeErrors<Sample, Exact>{mesh}, found, progress);
    });
}

/// Whether the volumes add up to the lattice's.
void verifyVolume(const MeshToVerify& mesh, LevelReport& verdict)
{
    std::int64_t sum = 0;
    for (std::size_t number = 0; number < mesh.cells.size(); ++number)
        sum += sixVolumes(mesh.cells.corners(number));
    const auto domain = 6 * static_cast<std::int64_t>(mesh.original.dataset.lattice.cellCount());
    verdict.covers = sum == domain;
    if (!verdict.covers)
        verdict.failures.push_back("The cells fill " + std::to_string(sum) +
                                   " sixths of a lattice cell, and the domain has " + std::to_string(domain) + ".");
}

/// Conforming positive cells whose boundary is the domain's cover every place inside it equally often, so one place
/// tells of all.
void verifyCoveredOnce(const MeshToVerify& mesh, LevelReport& verdict)
{
    const std::span<const Eigen::Vector3d> positions = mesh.original.points().positions;
    for (std::size_t number = 0; number < mesh.cells.size(); ++number)
        if (const auto place = placeInside(placedCell(positions, mesh.cells.points(number)))) {
            const std::size_t count = countHolding(positions, mesh.cells, *place);
            if (count != 1)
                verdict.failures.push_back("The place " + textOf(*place) + " lies in " + std::to_string(count) +
                                           " cells.");
            verdict.covers = verdict.covers && count == 1;
            return;
        }
    verdict.covers = false;
    verdict.failures.emplace_back("No cell has an inside.");
}

/// Whether all vertices of the face lie on one side of the lattice.
bool isOnSide(const MeshToVerify& mesh, const Triangle& face)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const std::int64_t side : {std::int64_t(0), std::int64_t(mesh.original.dataset.lattice.size[axis]) - 1})
            if (std::ranges::all_of(face, [&](std::uint32_t v) { return mesh.cells.place(v)[axis] == side; }))
                return true;
    return false;
}

/// Whether all initial sites lie on one side of a face.
bool isOnHull(const MeshToVerify& mesh, std::uint32_t initialSites, const Triangle& face)
{
    const std::span<const Eigen::Vector3d> positions = mesh.original.points().positions;
    const auto place = [&](std::size_t corner) { return positions[mesh.cells.point(face[corner])]; };
    const Eigen::Vector3d a = place(0), b = place(1), c = place(2);
    int side = 0;
    for (std::uint32_t site = 0; site < initialSites; ++site) {
        const int sign = volumeSign(a, b, c, positions[mesh.model.points()[site]]);
        if (sign * side < 0)
            return false;
        side = side == 0 ? sign : side;
    }
    return true;
}

FaceRule faceRule(const MeshToVerify& mesh)
{
    if (isOnLattice(mesh.original.dataset.domain))
        return {[&mesh](const Triangle& face) { return isOnSide(mesh, face); },
                [&mesh](std::uint32_t vertex) { return textOf(mesh.cells.place(vertex)); }};
    const auto place = [&mesh](std::uint32_t vertex) {
        return textOf(mesh.original.points().positions[mesh.cells.point(vertex)]);
    };
    if (mesh.original.irregular)
        return {[](const Triangle&) { return true; }, place};
    return {[&mesh, sites = initialSiteCount(mesh.model)](const Triangle& face) { return isOnHull(mesh, sites, face); },
            place};
}

/// What of cells of curvilinear data holds in physical space: inverted cells, and the warping at every sample (R4).
Status verifyWarping(const MeshToVerify& mesh, LevelReport& verdict, const Progress& progress)
{
    const GridWarpings warpings{mesh};
    CellFindings found(mesh.original.dataset.pointCount());
    if (const Status done = checkEveryCell(warpings, found, progress); !done)
        return done;
    verdict.measured.warping = found.residuals.statistics(warpings.residual.percent(1));
    verdict.inverted += found.turned.count() + found.allowed;
    verdict.invertedInData = found.allowed;
    verdict.degenerate = found.degenerate;
    found.turned.moveTo(verdict.failures);
    moveSamplesTo(warpings.residual, false, found, verdict);
    return {};
}

} // namespace

Status verifyCells(const MeshToVerify& mesh, LevelReport& verdict, const Progress& progress)
{
    const DomainClass domain = mesh.original.dataset.domain;
    const double cellsEnd = canWarp(domain) ? 0.3 : 0.6; // how far it is after each part
    const double facesEnd = canWarp(domain) ? 0.5 : 1;
    constexpr double warpingEnd = 0.7;
    CellFindings found(mesh.original.dataset.pointCount(), mesh.original.touchingPoints());
    if (const Status done = checkErrors(mesh, found, progress.part(0, cellsEnd)); !done)
        return done;
    const Residual errors = Residual::error(mesh);
    checkSeveralValued(errors, found);
    verdict.tetrahedra = mesh.cells.size();
    verdict.inverted = found.turned.count();
    found.turned.moveTo(verdict.failures);
    verdict.covers = true;
    if (isOnLattice(domain))
        verifyVolume(mesh, verdict);
    std::vector<BoundaryFace> boundary;
    if (const Status done = verifyFaces(mesh.cells, faceRule(mesh), verdict, progress.part(cellsEnd, facesEnd),
                                        canWarp(domain) ? &boundary : nullptr);
        !done)
        return done;
    if (domain == DomainClass::Irregular)
        return verifyIrregular(mesh, found, boundary, verdict, progress.part(facesEnd, 1));
    if (domain == DomainClass::Scattered)
        verifyCoveredOnce(mesh, verdict);
    moveSamplesTo(errors, true, found, verdict);
    verdict.measured.error = found.residuals.statistics(errors.percent(1));
    verdict.measured.errorInSpace = {verdict.measured.error};
    if (domain != DomainClass::Curvilinear)
        return {};
    if (const Status done = verifyWarping(mesh, verdict, progress.part(facesEnd, warpingEnd)); !done)
        return done;
    return verifyErrorInSpace(mesh, boundary, verdict, progress.part(warpingEnd, 1));
}

} // namespace tetra
