// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/base/sort_unique.h"
#include "core/data/cells/cell_complex.h"
#include "core/data/cells/clean_cells.h"
#include "core/data/cells/cut_cells.h"
#include "core/data/cells/faulty_cells.h"
#include "core/data/cells/polyhedron.h"
#include "core/mesh/topology.h"

#include <tan/data.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace tetra {

namespace {

/// Sums for each point, as means that do not overflow.
class Means {
public:
    explicit Means(std::size_t points) : means_(points), counts_(points) {}
    void add(std::size_t point, double value)
    {
        const double count = ++counts_[point];
        means_[point] = means_[point] * ((count - 1) / count) + value / count;
    }
    std::uint32_t count(std::size_t point) const { return counts_[point]; }
    double mean(std::size_t point) const { return means_[point]; }
    std::vector<double> take() { return std::move(means_); }

private:
    std::vector<double> means_;
    std::vector<std::uint32_t> counts_;
};

std::vector<double> valuesOfCells(const CellComplex& complex, const ComplexValues& values, const CleanCells& cells,
                                  const CutCells& cut)
{
    constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    std::vector<bool> kept(cells.count());
    for (const std::uint32_t cell : cut.cells)
        kept[cell] = true;
    Means means(complex.positions.size());
    std::vector<std::uint64_t> lastCell(complex.positions.size(), none); // a cell counts once, in however many parts
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        if (!kept[cell])
            continue;
        const std::uint64_t origin = cells.origins[cell];
        for (const std::uint32_t node : cells.nodesOf(cell))
            if (std::exchange(lastCell[node], origin) != origin)
                means.add(node, values.values[origin]);
    }
    return means.take();
}

std::vector<double> valuesOfPoints(const CellComplex& complex, const ComplexValues& values, const CleanCells& cells,
                                   Repairs& repairs)
{
    if (repairs.welded == 0)
        return values.values;
    std::vector<bool> used(complex.positions.size());
    std::vector<std::uint64_t> memory;
    for (const std::uint64_t origin : cells.origins) {
        const auto points = pointsOf(complex, origin, memory);
        for (const std::uint64_t point : *points)
            used[point] = true;
    }
    const std::vector<std::uint32_t> first = firstOnPlace(complex.positions, used);
    Means means(complex.positions.size());
    std::vector<bool> conflict(complex.positions.size());
    for (std::size_t point = 0; point < first.size(); ++point) {
        if (!used[point])
            continue;
        conflict[first[point]] = conflict[first[point]] || values.values[point] != values.values[first[point]];
        means.add(first[point], values.values[point]);
    }
    repairs.conflicting = static_cast<std::uint64_t>(std::ranges::count(conflict, true));
    std::vector<double> result = values.values;
    for (std::size_t point = 0; point < result.size(); ++point)
        if (conflict[point])
            result[point] = means.mean(point);
    return result;
}

/// A value for each point of the complex that a tetrahedron uses, others hold anything: its own, the mean of those on
/// its place, or the mean of the cells around it; then for those in the middle of cells, the value of the cell, or the
/// one that its corners have there. `repairs` is told.
std::vector<double> pointValues(const CellComplex& complex, const ComplexValues& values, const CleanCells& cells,
                                const CutCells& cut, Repairs& repairs)
{
    repairs.cellValues = values.perCell;
    std::vector<double> all =
        values.perCell ? valuesOfCells(complex, values, cells, cut) : valuesOfPoints(complex, values, cells, repairs);
    for (std::size_t i = 0; i < cut.centres.size(); ++i) {
        const std::uint32_t cell = cut.centreCells[i];
        all.push_back(values.perCell ? values.values[cells.origins[cell]]
                                     : valueAmong(complex.positions, cells.nodesOf(cell), all, cut.centres[i]));
    }
    return all;
}

/// The type that holds such values: means of whole numbers are none, and a float cannot hold every double.
SampleType typeOfPointValues(const ComplexValues& values, const Repairs& repairs, const std::vector<double>& usedValues)
{
    const auto exceeds = [&](double largest) {
        return std::ranges::any_of(usedValues, [&](double value) { return std::abs(value) > largest; });
    };
    SampleType type = values.type;
    if (isInteger(type)) {
        const bool fits = visitSampleType(type, [&]<class T>() {
            return std::ranges::all_of(usedValues, [](double value) {
                return value >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                       value <= static_cast<double>(std::numeric_limits<T>::max());
            });
        });
        if (fits && !values.perCell && repairs.conflicting == 0 && repairs.centres == 0)
            return type;
        type = sampleSize(type) > sizeof(std::uint16_t) ? SampleType::Float64 : SampleType::Float32;
    }
    const bool tooLarge = type == SampleType::Float32 && exceeds(std::numeric_limits<float>::max());
    return tooLarge ? SampleType::Float64 : type;
}

using Tetrahedra = std::vector<std::array<std::uint32_t, 4>>;

using Positions = std::span<const Eigen::Vector3d>;

/// Whether points lie in the part of a complex that has to be sound.
bool isJudged(const CellComplex& complex, Positions positions, std::span<const std::uint32_t> points)
{
    return !complex.region ||
           std::ranges::all_of(points, [&](std::uint32_t point) { return complex.region->contains(positions[point]); });
}

/// Of how many cells the tetrahedra are.
std::uint64_t cellsOf(const CutCells& cut)
{
    std::vector<std::uint32_t> cells = cut.cells;
    sortUnique(cells);
    return cells.size();
}

void append(CutCells& cut, const CutCells& more)
{
    cut.tetrahedra.insert(cut.tetrahedra.end(), more.tetrahedra.begin(), more.tetrahedra.end());
    cut.cells.insert(cut.cells.end(), more.cells.begin(), more.cells.end());
}

/// takeOutFaulty() where it is judged.
Status takeOutFaultyWithin(const CellComplex& complex, Positions positions, const CleanCells& cells, CutCells& cut,
                           Repairs& repairs, const Progress& progress)
{
    if (!complex.region)
        return takeOutFaulty(positions, cells, cells.count(), complex.mostFaulty, cut, repairs, progress);
    CutCells within, beyond;
    for (std::size_t t = 0; t < cut.tetrahedra.size(); ++t) {
        CutCells& part = isJudged(complex, positions, cut.tetrahedra[t]) ? within : beyond;
        part.tetrahedra.push_back(cut.tetrahedra[t]);
        part.cells.push_back(cut.cells[t]);
    }
    if (within.tetrahedra.empty())
        return {};
    const Status sound =
        takeOutFaulty(positions, cells, cellsOf(within), complex.mostFaulty, within, repairs, progress);
    append(within, beyond);
    cut.tetrahedra = std::move(within.tetrahedra);
    cut.cells = std::move(within.cells);
    return sound;
}

/// How many of the cells are judged.
std::uint64_t judgedCount(const CellComplex& complex, const CleanCells& cells)
{
    std::uint64_t count = 0;
    for (std::uint32_t cell = 0; cell < cells.count(); ++cell)
        count += isJudged(complex, complex.positions, cells.nodesOf(cell)) ? 1 : 0;
    return count;
}

/// Those of the cells that are judged and of a shape that `counts`.
template <class Counts> std::vector<std::uint32_t> judgedOf(const CellComplex& complex, const CleanCells& cells,
                                                            const std::vector<std::uint32_t>& which,
                                                            const Counts& counts)
{
    std::vector<std::uint32_t> judged;
    std::ranges::copy_if(which, std::back_inserter(judged), [&](std::uint32_t cell) {
        return counts(cells.shapes[cell]) && isJudged(complex, complex.positions, cells.nodesOf(cell));
    });
    return judged;
}

bool isPolyhedron(CellShape shape)
{
    return shape == CellShape::Polyhedron;
}

Eigen::Vector3d firstPlaceOf(const CellComplex& complex, const CleanCells& cells, std::uint32_t cell)
{
    const auto nodes = cells.nodesOf(cell);
    return nodes.empty() ? Eigen::Vector3d::Zero() : complex.positions[nodes.front()];
}

/// Holes that cells too warped to be cut leave are said; with a larger share of them the mesh is another one.
constexpr double mostWarped = 0.01;

Status checkWarped(const CellComplex& complex, const CleanCells& cells, const CutCells& cut, Repairs& repairs)
{
    const std::vector<std::uint32_t> warped = judgedOf(complex, cells, cut.warped, std::not_fn(isPolyhedron));
    repairs.warped = warped.size();
    for (const std::uint32_t cell : warped)
        repairs.faulty.push_back({cells.origins[cell], CellFault::Warped});
    const std::uint64_t count = judgedCount(complex, cells);
    const double most = std::max(mostWarped, complex.mostFaulty);
    if (static_cast<double>(warped.size()) <= most * static_cast<double>(count))
        return {};
    const Eigen::Vector3d place = firstPlaceOf(complex, cells, warped.front());
    return Error{ErrorKind::BadInput,
                 Message::say("%1 cells are folded or so warped that no tetrahedra fill them, more than %2; the first "
                              "is cell %3 at (%4, %5, %6). Repair the mesh in the program that made it, or allow more "
                              "cells to be left out, as with '--faulty %7'.",
                              warped.size(), shareText(most), cells.origins[warped.front()], formatNumber(place[0]),
                              formatNumber(place[1]), formatNumber(place[2]),
                              largerShareText(most, warped.size(), count))};
}

Error tooManyUncut(const CellComplex& complex, const CleanCells& cells, std::uint32_t first, std::uint64_t faulty,
                   std::uint64_t count)
{
    const Eigen::Vector3d place = firstPlaceOf(complex, cells, first);
    const Message where = Message::say("cell %1 at (%2, %3, %4)", cells.origins[first], formatNumber(place[0]),
                                       formatNumber(place[1]), formatNumber(place[2]));
    const std::string share = largerShareText(complex.mostFaulty, faulty, count);
    if (complex.addsCentres)
        return {ErrorKind::BadInput,
                Message::say("%1 of the mesh's %2 cells are polyhedra in which no point sees all of their faces, more "
                             "than %3; the first is %4. Repair the mesh in the program that made it, or allow more "
                             "cells to be left out, as with '--faulty %5'.",
                             faulty, count, shareText(complex.mostFaulty), where, share)};
    return {ErrorKind::BadInput,
            Message::say("%1 of the mesh's %2 cells are polyhedra that no tetrahedra between their own points fill, "
                         "more than %3; the first is %4. With '--polyhedra centre' they get a point in the middle; "
                         "with '--faulty %5' they are left out.",
                         faulty, count, shareText(complex.mostFaulty), where, share)};
}

/// Of polyhedra, what has no cut.
Status checkPolyhedra(const CellComplex& complex, const CleanCells& cells, const CutCells& cut, Repairs& repairs)
{
    const std::vector<std::uint32_t> uncut = judgedOf(complex, cells, cut.warped, isPolyhedron);
    const std::vector<std::uint32_t> open = judgedOf(complex, cells, cut.open, isPolyhedron);
    repairs.centresTried = complex.addsCentres;
    repairs.uncut = uncut.size();
    repairs.open = open.size();
    for (const std::uint32_t cell : uncut)
        repairs.faulty.push_back({cells.origins[cell], CellFault::Warped});
    for (const std::uint32_t cell : open)
        repairs.faulty.push_back({cells.origins[cell], CellFault::NoVolume});
    const std::uint64_t count = judgedCount(complex, cells);
    const auto tooMany = [&](std::uint64_t faulty) {
        return static_cast<double>(faulty) > complex.mostFaulty * static_cast<double>(count);
    };
    if (tooMany(open.size())) {
        const Eigen::Vector3d place = firstPlaceOf(complex, cells, open.front());
        return Error{ErrorKind::BadInput,
                     Message::say("The faces of %1 of the mesh's %2 cells do not enclose a volume; the first is cell "
                                  "%3 at (%4, %5, %6). Repair the mesh in the program that made it, or allow more "
                                  "cells to be left out, as with '--faulty %7'.",
                                  open.size(), count, cells.origins[open.front()], formatNumber(place[0]),
                                  formatNumber(place[1]), formatNumber(place[2]),
                                  largerShareText(complex.mostFaulty, open.size(), count))};
    }
    if (tooMany(uncut.size()))
        return tooManyUncut(complex, cells, uncut.front(), uncut.size(), count);
    return {};
}

Result<CutCells> cutChecked(const CellComplex& complex, CleanCells& cells, Repairs& repairs, const Progress& progress)
{
    const Repairs before = repairs;
    dropMiddlesIfMixed(cells, repairs);
    auto result = cutCells(complex.positions, cells, complex.addsCentres, repairs, progress);
    if (!result || result->warped.empty() || repairs.middles > before.middles)
        return result;
    Repairs again = before;
    dropMiddles(cells, again);
    if (again.middles == before.middles)
        return result;
    repairs = again;
    return cutCells(complex.positions, cells, complex.addsCentres, repairs, progress);
}

std::vector<Eigen::Vector3d> placesOfCorners(const CellComplex& complex, std::uint64_t cell)
{
    const CellShape shape = complex.shapes[cell];
    std::vector<Eigen::Vector3d> places(cellTopology(shape).cornerCount);
    for (std::uint32_t i = 0; i < places.size(); ++i)
        places[shape == CellShape::Voxel ? hexahedronCorner(i) : i] =
            complex.positions[complex.corners[complex.offsets[cell] + i]];
    return places;
}

/// Each once, with the first of its faults. Holes by their value may be most of the cells: they get no corners.
std::shared_ptr<const std::vector<FaultyCell>> listed(std::vector<FaultyCell> faulty, const CellComplex& complex)
{
    if (faulty.empty())
        return nullptr;
    std::ranges::sort(faulty, {}, [](const FaultyCell& one) { return std::pair(one.cell, one.fault); });
    const auto again = std::ranges::unique(faulty, {}, &FaultyCell::cell);
    faulty.erase(again.begin(), again.end());
    for (FaultyCell& one : faulty)
        if (one.fault != CellFault::NotFinite)
            one.corners = placesOfCorners(complex, one.cell);
    return std::make_shared<const std::vector<FaultyCell>>(std::move(faulty));
}

Result<ScalarField> fieldOf(const std::vector<double>& values, SampleType type)
{
    auto samples = allocateSamples(type, values.size());
    if (!samples)
        return samples.error();
    visitSampleType(type, [&]<class T>() {
        std::ranges::transform(values, reinterpret_cast<T*>(samples->get()),
                               [](double value) { return static_cast<T>(value); });
    });
    return ScalarField(type, values.size(), *std::move(samples));
}

/// Those of the complex, and behind them the points in the middle of cells; empty if there are none.
std::vector<Eigen::Vector3d> positionsWithCentres(const CellComplex& complex, const CutCells& cut)
{
    std::vector<Eigen::Vector3d> positions;
    if (!cut.centres.empty()) {
        positions.reserve(complex.positions.size() + cut.centres.size());
        positions = complex.positions;
        positions.insert(positions.end(), cut.centres.begin(), cut.centres.end());
    }
    return positions;
}

Result<Dataset> makeDataset(const CellComplex& complex, const ComplexValues& values, const Source& source,
                            Repairs repairs, const Progress& progress)
{
    auto cells = cleanCells(complex, values, repairs);
    if (!cells)
        return cells.error();
    auto cutting = cutChecked(complex, *cells, repairs, progress.part(0, 0.5));
    if (!cutting)
        return cutting.error();
    if (const Status sound = checkWarped(complex, *cells, *cutting, repairs); !sound)
        return sound.error();
    if (const Status sound = checkPolyhedra(complex, *cells, *cutting, repairs); !sound)
        return sound.error();
    if (cutting->tetrahedra.empty())
        return Error{ErrorKind::BadInput, Message::say("No cell of the mesh has a volume: nothing is left.")};
    const std::vector<Eigen::Vector3d> withCentres = positionsWithCentres(complex, *cutting);
    const Positions places = withCentres.empty() ? Positions(complex.positions) : withCentres;
    if (const Status sound = takeOutFaultyWithin(complex, places, *cells, *cutting, repairs, progress.part(0.5, 0.95));
        !sound)
        return sound.error();
    const std::vector<double> all = pointValues(complex, values, *cells, *cutting, repairs);
    Tetrahedra tetrahedra = std::move(cutting->tetrahedra);

    const std::vector<std::uint32_t> used = renumberUsed(tetrahedra, places.size());
    std::vector<double> usedValues(used.size());
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(used.size());
    for (std::size_t point = 0; point < used.size(); ++point) {
        (*positions)[point] = places[used[point]];
        usedValues[point] = all[used[point]];
        repairs.centres += used[point] >= complex.positions.size();
    }
    const auto field = fieldOf(usedValues, typeOfPointValues(values, repairs, usedValues));
    if (!field)
        return field.error();
    const std::uint64_t explained = used.size() - repairs.centres + repairs.welded + repairs.middles;
    repairs.unused = complex.positions.size() - std::min<std::uint64_t>(explained, complex.positions.size());

    Dataset dataset;
    dataset.domain = DomainClass::Irregular;
    dataset.lattice.size = {static_cast<std::uint32_t>(used.size()), 1, 1};
    dataset.positions = std::move(positions);
    dataset.values = *field;
    dataset.tetrahedra = std::make_shared<const Tetrahedra>(std::move(tetrahedra));
    dataset.convex = !complex.region && hasConvexDomain(dataset);
    dataset.source = source;
    dataset.source.hash = contentHash(dataset.values, dataset.positions, dataset.tetrahedra);
    dataset.remarks = repairRemarks(repairs);
    dataset.faultyCells = listed(std::move(repairs.faulty), complex);
    return dataset;
}

} // namespace

Result<Dataset> irregularDataset(const CellComplex& complex, const ComplexValues& values, const Source& source,
                                 const Progress& progress)
{
    return irregularDatasetBeside({}, complex, values, source, progress);
}

Result<Dataset> irregularDatasetBeside(const Repairs& holes, const CellComplex& complex, const ComplexValues& values,
                                       const Source& source, const Progress& progress)
{
    return guarded(Message::marked("Not enough memory for the mesh. Take a part of it."),
                   [&] { return makeDataset(complex, values, source, holes, progress); });
}

} // namespace tetra
