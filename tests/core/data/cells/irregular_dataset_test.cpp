// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/irregular_check.h"
#include "core/data/dataset_part.h"
#include "core/geometry/orientation.h"
#include "core/geometry/tetrahedron_overlap.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "tests/core/data/cells/cell_cases.h"
#include "tests/core/data/cells/damaged_cells.h"

#include <tan/data.h>

#include <QTest>

#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace tetra;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Times six.
double totalVolume6(const Dataset& dataset)
{
    double volume = 0;
    for (const auto& tetrahedron : *dataset.tetrahedra) {
        const Eigen::Vector3d a = (*dataset.positions)[tetrahedron[0]];
        const auto from = [&](int i) { return ((*dataset.positions)[tetrahedron[std::size_t(i)]] - a).eval(); };
        volume += from(1).dot(from(2).cross(from(3)));
    }
    return volume;
}

/// The corners of a tetrahedron of the file, in the order that makes it positive; any if it is flat.
std::array<std::uint32_t, 4> positive(const CellComplex& complex, std::uint64_t cell)
{
    std::array<std::uint32_t, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = static_cast<std::uint32_t>(complex.corners[4 * cell + i]);
    if (orientation(complex.positions, corners) < 0)
        std::swap(corners[0], corners[1]);
    return corners;
}

/// Of a grid of 12^3 cells: seven of its corners, each of one cell, have no value, and three cells are blanked out.
constexpr std::uint32_t side = 13, end = side - 1;
Dataset gridWithHoles(const Eigen::Vector3d& lastPlace = {end, end, end})
{
    Dataset grid{.domain = DomainClass::Curvilinear, .lattice = {}, .values = {}, .source = {}};
    grid.lattice.size = {side, side, side};
    std::vector<Eigen::Vector3d> places;
    std::vector<float> values;
    for (std::uint32_t k = 0; k < side; ++k)
        for (std::uint32_t j = 0; j < side; ++j)
            for (std::uint32_t i = 0; i < side; ++i) {
                places.emplace_back(i, j, k);
                values.push_back(static_cast<float>(i + 2 * j + 3 * k));
            }
    for (std::uint32_t corner = 0; corner < 7; ++corner)
        values[grid.lattice.index(corner % 2 * end, corner / 2 % 2 * end, corner / 4 * end)] = std::nanf("");
    std::vector<GridCell> cells(end * end * end, GridCell::Kept);
    for (const std::size_t blanked : {300, 301, 900})
        cells[blanked] = GridCell::Blanked;
    places.back() = lastPlace;
    grid.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(places));
    grid.values = ScalarField::of(std::move(values));
    grid.cells = std::make_shared<const std::vector<GridCell>>(std::move(cells));
    return grid;
}

/// By a slow way: each face in one or two tetrahedra.
bool conforms(const Dataset& dataset)
{
    std::map<std::array<std::uint32_t, 3>, int> counts;
    for (const auto& t : *dataset.tetrahedra)
        for (const auto& face : cornersOfFace) {
            std::array<std::uint32_t, 3> key = {t[face[0]], t[face[1]], t[face[2]]};
            std::ranges::sort(key);
            if (++counts[key] > 2)
                return false;
        }
    return true;
}

} // namespace

class IrregularDatasetTest : public QObject {
    Q_OBJECT
private slots:
    /// R1.
    void everyShape()
    {
        for (int number = 0; number < static_cast<int>(CellShape::Polyhedron); ++number) {
            const auto shape = static_cast<CellShape>(number);
            const CellComplex complex = singleCell(shape);
            const auto dataset = datasetOf(complex, linearValues(complex));
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QVERIFY2(dataset->remarks.empty(), qPrintable(remarksOf(*dataset)));
            QCOMPARE(totalVolume6(*dataset), referenceVolume6(shape));
            QCOMPARE(dataset->positions->size(), complex.positions.size());
            QCOMPARE(dataset->domain, DomainClass::Irregular);
        }
    }

    /// R1, S6: any mixture of shapes, numberings and directions: nothing of the volume is lost, values stay at their
    /// places.
    void mixedCellsKeepTheVolume()
    {
        for (std::uint32_t seed = 0; seed < 60; ++seed) {
            const RandomCells cells({1 + seed % 5, 1 + seed % 3, 1 + seed % 4}, 0.12, seed);
            const auto dataset = datasetOf(cells.complex(), linearValues(cells.complex()));
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QCOMPARE(totalVolume6(*dataset), 6 * cells.volume());
            QVERIFY(conforms(*dataset));
            const Status sound = checkIrregular(*dataset);
            QVERIFY2(sound.ok(), sound ? "" : sound.error().text().c_str());
            for (std::uint64_t point = 0; point < dataset->pointCount(); ++point)
                QCOMPARE(dataset->values.at(point), (*dataset->positions)[point].dot(Eigen::Vector3d(1, 2, 4)));
        }
    }

    /// S20: points anywhere. Such a mesh is given up in seconds, whatever its size, and not searched through cell by
    /// cell.
    void garbageIsRefusedSoon()
    {
        const RandomCells cells({20, 20, 20}, 0.1, 3, RandomCells::Kinds::NoTetrahedra);
        CellComplex complex = cells.complex();
        std::mt19937 random(4);
        std::uniform_real_distribution<double> anywhere(-1e90, 1e90);
        for (Eigen::Vector3d& position : complex.positions)
            position = {anywhere(random), 1e-80 * anywhere(random), anywhere(random)};
        QVERIFY(!datasetOf(complex, linearValues(complex)));
    }

    /// Faces far from flat: whatever is accepted without leaving cells out covers the box.
    void warpedCellsAreCutAnotherWayOrRefused()
    {
        int resplit = 0, whole = 0;
        for (std::uint32_t seed = 0; seed < 60; ++seed) {
            const RandomCells cells({5, 5, 5}, 0.24 + 0.002 * seed, seed, RandomCells::Kinds::NoTetrahedra);
            const auto dataset = datasetOf(cells.complex(), linearValues(cells.complex()));
            if (!dataset) {
                QCOMPARE(dataset.error().kind, ErrorKind::BadInput);
                continue;
            }
            QVERIFY(checkIrregular(*dataset).ok());
            const QString remarks = remarksOf(*dataset);
            if (remarks.contains("left out: too warped"))
                continue;
            ++whole;
            QCOMPARE(totalVolume6(*dataset), 6 * cells.volume());
            resplit += remarks.contains("other diagonals");
        }
        QVERIFY2(whole >= 20 && resplit >= 5, qPrintable(QString("%1 whole, %2 recut").arg(whole).arg(resplit)));
    }

    /// Quadratic neighbours agree on their common faces; the fine mesh has all nodes.
    void quadraticNeighbours()
    {
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            // The diagonal of a face has a middle, which a hexahedron beside it would not have.
            RandomCells cells({2, 2, 2}, 0.1, seed,
                              seed % 2 == 0 ? RandomCells::Kinds::NoTetrahedra : RandomCells::Kinds::OnlyTetrahedra);
            CellComplex quadratic;
            quadratic.positions = cells.complex().positions;
            quadratic.offsets = {0};
            std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> middles;
            for (std::size_t cell = 0; cell < cells.complex().shapes.size(); ++cell) {
                const CellShape shape = cells.complex().shapes[cell];
                const std::uint64_t* corners = cells.complex().corners.data() + cells.complex().offsets[cell];
                const CellTopology& topology = cellTopology(shape);
                quadratic.corners.insert(quadratic.corners.end(), corners, corners + topology.cornerCount);
                for (const auto& [a, b] : topology.edges) {
                    const auto [found, isNew] =
                        middles.emplace(std::minmax(corners[a], corners[b]), quadratic.positions.size());
                    if (isNew)
                        quadratic.positions.push_back(
                            (quadratic.positions[corners[a]] + quadratic.positions[corners[b]]) / 2);
                    quadratic.corners.push_back(found->second);
                }
                quadratic.offsets.push_back(quadratic.corners.size());
                constexpr CellShape quadraticShapes[] = {CellShape::QuadraticTetrahedron, CellShape::QuadraticPyramid,
                                                         CellShape::QuadraticPrism, CellShape::QuadraticHexahedron};
                quadratic.shapes.push_back(quadraticShapes[static_cast<std::size_t>(shape)]);
            }
            const auto dataset = datasetOf(quadratic, linearValues(quadratic));
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QVERIFY2(!remarksOf(*dataset).contains("middle"), qPrintable(remarksOf(*dataset)));
            QCOMPARE(totalVolume6(*dataset), 6 * cells.volume());

            // A linear cell among them has no nodes there: none are used.
            const std::uint64_t end = quadratic.offsets[1];
            constexpr CellShape linearShapes[] = {CellShape::Tetrahedron, CellShape::Pyramid, CellShape::Prism,
                                                  CellShape::Hexahedron};
            const std::size_t kind = static_cast<std::size_t>(quadratic.shapes[0]) -
                                     static_cast<std::size_t>(CellShape::QuadraticTetrahedron);
            const std::uint64_t kept = nodeCount(linearShapes[kind]);
            quadratic.shapes[0] = linearShapes[kind];
            quadratic.corners.erase(quadratic.corners.begin() + std::ptrdiff_t(kept),
                                    quadratic.corners.begin() + std::ptrdiff_t(end));
            for (std::size_t cell = 1; cell < quadratic.offsets.size(); ++cell)
                quadratic.offsets[cell] -= end - kept;
            const auto mixed = datasetOf(quadratic, linearValues(quadratic));
            QVERIFY2(mixed.ok(), mixed ? "" : mixed.error().text().c_str());
            QVERIFY(remarksOf(*mixed).contains("in the middle of"));
            QCOMPARE(totalVolume6(*mixed), 6 * cells.volume());
        }
    }

    /// S20: random holes, until nothing is left; a lattice with a cell value each, the rest is still sound.
    void holesOfValuesThatAreNotFinite()
    {
        for (std::uint32_t seed = 0; seed < 30; ++seed) {
            RandomCells cells({4, 4, 4}, 0.1, seed);
            ComplexValues values{.values = {}, .perCell = true, .type = SampleType::UInt8};
            for (std::size_t cell = 0; cell < cells.complex().shapes.size(); ++cell)
                values.values.push_back(cells.random(10) < seed % 8 ? notANumber : 3);
            const auto dataset = datasetOf(cells.complex(), values);
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QVERIFY(checkIrregular(*dataset).ok());
            QCOMPARE(dataset->values.type(), SampleType::Float32);
            QCOMPARE(dataset->values.range().minimum, 3.0);
            QCOMPARE(dataset->values.range().maximum, 3.0);
            QVERIFY(remarksOf(*dataset).contains("mean of the cells"));
            QCOMPARE(remarksOf(*dataset).contains("not finite and became"),
                     std::ranges::count_if(values.values, [](double v) { return std::isnan(v); }) > 0);
        }
    }

    /// S20: cells of a grid that are blanked out or have a corner without a finite value become holes and are counted,
    /// each as what it is.
    void holesOfGrids()
    {
        const auto dataset = withHoles(gridWithHoles());
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(totalVolume6(*dataset), 6.0 * (end * end * end - 3 - 7));
        const auto remarks = remarksOf(*dataset);
        QVERIFY(remarks.contains("3 cells are blanked out in the file: holes."));
        QVERIFY(remarks.contains("7 cells have a value that is not finite and became holes."));
        QVERIFY(remarks.contains("7 of its 2197 points"));
    }

    /// As where latitudes fall: nothing is wrong with its cells.
    void gridsThatRunBackwards()
    {
        Dataset grid = gridWithHoles();
        std::vector<Eigen::Vector3d> places = *grid.positions;
        for (Eigen::Vector3d& place : places)
            place[1] = -place[1];
        grid.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(places));
        const auto dataset = withHoles(grid);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(totalVolume6(*dataset), 6.0 * (end * end * end - 3 - 7));
        QVERIFY2(!remarksOf(*dataset).contains("orientation"), qPrintable(remarksOf(*dataset)));
    }

    /// Its last corner lies far inside of the last cell's others, so that this cell alone is inside out.
    void faultyCellsOfGridsHaveTheGridsNumbers()
    {
        const auto dataset = withHoles(gridWithHoles({end - 1.8, end - 1.8, end - 1.8}));
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->faultyCells && dataset->faultyCells->size() == 1);
        QCOMPARE(dataset->faultyCells->front().cell, end * end * end - 1);
    }

    void cellValuesAreAveraged()
    {
        const CellComplex complex = lattice(2, [](auto, auto, auto k) { return k == 0; });
        const ComplexValues values{.values = {1, 2, 3, 6}, .perCell = true, .type = SampleType::Float32};
        const auto dataset = datasetOf(complex, values);
        QVERIFY(dataset.ok());
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
            const Eigen::Vector3d& place = (*dataset->positions)[point];
            if (place[0] == 1 && place[1] == 1)
                QCOMPARE(dataset->values.at(point), 3.0);
            if (place[0] == 1 && place[1] == 0)
                QCOMPARE(dataset->values.at(point), 1.5);
        }
        QVERIFY(remarksOf(*dataset).contains("9 points belong to no cell with a volume"));
    }

    void seamsAreWelded()
    {
        CellComplex complex = twoCubes({2, 0, 0});
        ComplexValues values = linearValues(complex);
        auto dataset = datasetOf(complex, values);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), 12);
        QVERIFY(remarksOf(*dataset).contains("4 points at the same place as another"));
        QVERIFY(!remarksOf(*dataset).contains("different values"));
        values.values[8] += 1;
        dataset = datasetOf(complex, values);
        QVERIFY(dataset.ok());
        QVERIFY(remarksOf(*dataset).contains("1 place had several different values"));
        QCOMPARE(dataset->values.at(1), 2.5);
        complex.positions[8][0] = -0.0; // the same place as 0
        complex.positions[0][0] = 0.0;
        QVERIFY(!datasetOf(complex, values).ok());
    }

    void directionsAreMended()
    {
        CellComplex complex = lattice(2, [](auto, auto, auto) { return true; });
        for (std::size_t cell = 0; cell < 8; ++cell)
            std::rotate(complex.corners.begin() + std::ptrdiff_t(8 * cell),
                        complex.corners.begin() + std::ptrdiff_t(8 * cell + 4),
                        complex.corners.begin() + std::ptrdiff_t(8 * cell + 8));
        auto dataset = datasetOf(complex, linearValues(complex));
        QVERIFY(dataset.ok());
        QCOMPARE(remarksOf(*dataset), "All cells had inverted orientation and were corrected. ");
        std::rotate(complex.corners.begin(), complex.corners.begin() + 4, complex.corners.begin() + 8);
        dataset = datasetOf(complex, linearValues(complex));
        QVERIFY(remarksOf(*dataset).startsWith("7 cells had inverted orientation and were corrected."));
    }

    void cellsWithoutVolumeAreLeftOut()
    {
        CellComplex complex = singleCell(CellShape::Tetrahedron);
        complex.positions.insert(complex.positions.end(), {{2, 2, 0}, {9, 9, 9}});
        for (const std::array<std::uint64_t, 4>& corners :
             {std::array<std::uint64_t, 4>{1, 1, 2, 3}, {0, 1, 2, 0}, {0, 1, 2, 4}}) {
            complex.shapes.push_back(CellShape::Tetrahedron);
            complex.corners.insert(complex.corners.end(), corners.begin(), corners.end());
            complex.offsets.push_back(complex.corners.size());
        }
        complex.shapes.push_back(CellShape::Flat);
        complex.corners.push_back(3);
        complex.offsets.push_back(complex.corners.size());
        const auto dataset = datasetOf(complex, linearValues(complex));
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->tetrahedra->size(), 1);
        QVERIFY(remarksOf(*dataset).contains("1 cell is a vertex"));
        QVERIFY(remarksOf(*dataset).contains("2 cells use a corner twice"));
        QVERIFY(remarksOf(*dataset).contains("1 cell without volume was"));
        QVERIFY(remarksOf(*dataset).contains("2 points belong to no cell with a volume"));
    }

    void blankedAndRepeatedCells()
    {
        CellComplex complex = lattice(3, [](auto, auto, auto) { return true; });
        complex.blanked.assign(27, 0);
        complex.blanked[13] = 1;
        auto dataset = datasetOf(complex, linearValues(complex));
        QVERIFY(dataset.ok());
        QCOMPARE(totalVolume6(*dataset), 6.0 * 26);
        QVERIFY(remarksOf(*dataset).contains("1 cell is blanked out"));
        complex.blanked.clear();
        complex.shapes.push_back(CellShape::Hexahedron);
        complex.corners.insert(complex.corners.end(), complex.corners.begin() + 8 * 5, complex.corners.begin() + 8 * 6);
        complex.offsets.push_back(complex.corners.size());
        dataset = datasetOf(complex, linearValues(complex));
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(totalVolume6(*dataset), 6.0 * 27);
        QVERIFY(remarksOf(*dataset).contains("6 tetrahedra appeared twice"));
    }

    /// C10: parts that touch in an edge, a point or a place of a face are taken as they are, whether a mask made them
    /// or not.
    void partsThatOnlyTouch()
    {
        const CellComplex diagonal = lattice(2, [](auto i, auto j, auto) { return i == j; });
        CellComplex masked = lattice(2, [](auto, auto, auto) { return true; });
        masked.blanked = {0, 1, 1, 0, 0, 1, 1, 0};
        for (const CellComplex& complex : {diagonal, masked}) {
            const auto dataset = datasetOf(complex, linearValues(complex));
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QCOMPARE(totalVolume6(*dataset), 6.0 * 4);
            QVERIFY(!dataset->faultyCells);
        }
        for (const Eigen::Vector3d& offset : {Eigen::Vector3d(2, 2, 2), Eigen::Vector3d(2, 0.5, 0)}) {
            const auto dataset = datasetOf(twoCubes(offset), linearValues(twoCubes(offset)));
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QCOMPARE(totalVolume6(*dataset), 6.0 * 16);
        }
    }

    /// C10: of a mesh of 6^3 cubes, in six or so tetrahedra each, a few cells are faulty, each in its way: they are
    /// taken out, listed by their numbers in the file, and counted in the remarks.
    void faultyCellsAreListed()
    {
        const RandomCells sound({6, 6, 6}, 0.1, 5, RandomCells::Kinds::OnlyTetrahedra);
        CellComplex complex = sound.complex();
        const std::uint64_t count = complex.shapes.size();
        const auto point = [&](const Eigen::Vector3d& place) {
            complex.positions.push_back(place);
            return complex.positions.size() - 1;
        };
        const auto add = [&](const std::array<std::uint64_t, 4>& corners) {
            complex.shapes.push_back(CellShape::Tetrahedron);
            complex.corners.insert(complex.corners.end(), corners.begin(), corners.end());
            complex.offsets.push_back(complex.corners.size());
        };
        // Around the middle: small, and it overlaps whatever is there.
        const Eigen::Vector3d middle(3.1, 3.2, 3.3);
        add({point(middle), point(middle + Eigen::Vector3d(0.9, 0, 0)), point(middle + Eigen::Vector3d(0, 0.9, 0)),
             point(middle + Eigen::Vector3d(0, 0, 0.9))});
        // One with neighbours on all sides, away from that.
        const std::uint64_t* first = complex.corners.data();
        const auto isInner = [&](std::uint64_t corner) {
            const Eigen::Vector3d& place = complex.positions[corner];
            return place.minCoeff() > 0 && place.maxCoeff() < 6 && (place - middle).norm() > 1.5;
        };
        while (!std::all_of(first, first + 4, isInner))
            first += 4;
        const std::array<std::uint64_t, 4> known{first[0], first[1], first[2], first[3]};
        add({known[1], known[0], known[2], known[3]});
        const Eigen::Vector3d halfWay = (complex.positions[known[0]] + complex.positions[known[1]]) / 2;
        add({known[0], known[1], known[2], point(halfWay)});
        ComplexValues values = linearValues(complex);
        auto dataset = datasetOf(complex, values);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        std::vector<FaultyCell> expected{
            {count, CellFault::Overlap}, {count + 1, CellFault::Duplicate}, {count + 2, CellFault::NoVolume}};
        for (FaultyCell& cell : expected)
            for (std::size_t corner = 0; corner < 4; ++corner)
                cell.corners.push_back(complex.positions[complex.corners[complex.offsets[cell.cell] + corner]]);
        QVERIFY(dataset->faultyCells && *dataset->faultyCells == expected);
        QCOMPARE(totalVolume6(*dataset), 6 * sound.volume());
        QVERIFY2(remarksOf(*dataset).contains("1 cell was left out: it overlaps others."),
                 qPrintable(remarksOf(*dataset)));
        QVERIFY(checkIrregular(*dataset).ok());

        // A third cell at a face, with its point in one of the two.
        const Eigen::Vector3d within = (complex.positions[known[0]] + complex.positions[known[1]] +
                                        complex.positions[known[2]] + complex.positions[known[3]]) /
                                       4;
        add({known[0], known[1], known[2], point(within)});
        values = linearValues(complex);
        dataset = datasetOf(complex, values);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->faultyCells && dataset->faultyCells->back().cell == count + 3);
        QCOMPARE(dataset->faultyCells->back().fault, CellFault::CrowdedFace);
        QVERIFY(checkIrregular(*dataset).ok());

        // Two of them are more than a thousandth, in number and in volume.
        for (const double shift : {-1.5, -1.0, 1.0})
            add({point(middle + Eigen::Vector3d(shift, 0, 0)), point(middle + Eigen::Vector3d(shift + 0.9, 0, 0)),
                 point(middle + Eigen::Vector3d(shift, 0.9, 0)), point(middle + Eigen::Vector3d(shift, 0, 0.9))});
        values = linearValues(complex);
        dataset = datasetOf(complex, values);
        QVERIFY(!dataset.ok());
        const QString text = QString::fromStdString(dataset.error().text());
        QVERIFY2(text.contains("cells are faulty, more than 0.1%. The first is cell"), qPrintable(text));
        QVERIFY2(text.endsWith("or allow more cells to be left out, as with '--faulty 5%'."), qPrintable(text));

        // As many as one says.
        complex.mostFaulty = 0.05;
        dataset = datasetOf(complex, values);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QVERIFY(checkIrregular(*dataset).ok());
        QVERIFY(dataset->faultyCells && dataset->faultyCells->size() > 4);
    }

    /// Cells that have no cut are counted against the same share, if that is more than one in a hundred.
    void asManyWarpedCellsAsOneSays()
    {
        CellComplex complex = lattice(3, [](auto, auto, auto) { return true; });
        CellComplex folded = singleCell(CellShape::Hexahedron);
        std::swap(folded.positions[0], folded.positions[6]);
        const std::uint64_t first = complex.positions.size();
        for (const Eigen::Vector3d& place : folded.positions)
            complex.positions.push_back(place + Eigen::Vector3d(10, 0, 0));
        for (const std::uint64_t corner : folded.corners)
            complex.corners.push_back(first + corner);
        complex.shapes.push_back(CellShape::Hexahedron);
        complex.offsets.push_back(complex.corners.size());
        const auto refused = datasetOf(complex, linearValues(complex));
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().find("more than 1%; the first is cell 27") != std::string::npos,
                 refused.error().text().c_str());
        complex.mostFaulty = 0.05;
        const auto dataset = datasetOf(complex, linearValues(complex));
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(totalVolume6(*dataset), 6.0 * 27);
        QVERIFY(dataset->faultyCells && dataset->faultyCells->size() == 1);
        for (const double share : {-0.1, 1.1}) {
            complex.mostFaulty = share;
            const auto nonsense = datasetOf(complex, linearValues(complex));
            QVERIFY(!nonsense.ok());
            QCOMPARE(nonsense.error().kind, ErrorKind::WrongUsage);
        }
    }

    /// Only what is taken is judged: two cubes that overlap, and a third one far from them.
    void whatLiesBeyondARegionIsNotJudged()
    {
        CellComplex complex = twoCubes({0.5, 0.5, 0.5}, 0.25);
        const auto firstPoint = static_cast<std::uint64_t>(complex.positions.size());
        const CellComplex third = singleCell(CellShape::Hexahedron);
        for (const Eigen::Vector3d& place : third.positions)
            complex.positions.push_back(place + Eigen::Vector3d(10, 0, 0));
        for (const std::uint64_t corner : third.corners)
            complex.corners.push_back(firstPoint + corner);
        complex.shapes.push_back(CellShape::Hexahedron);
        complex.offsets.push_back(complex.corners.size());
        const ComplexValues values = linearValues(complex);
        QVERIFY(!datasetOf(complex, values).ok());

        DatasetPart part;
        part.region = complex.region = Eigen::AlignedBox3d(Eigen::Vector3d(9, -1, -1), Eigen::Vector3d(13, 3, 3));
        const auto whole = datasetOf(complex, values);
        QVERIFY2(whole.ok(), whole ? "" : whole.error().text().c_str());
        const auto taken = takePart(*whole, part);
        QVERIFY2(taken.ok(), taken ? "" : taken.error().text().c_str());
        QCOMPARE(totalVolume6(*taken), referenceVolume6(CellShape::Hexahedron));
        QVERIFY(checkIrregular(*taken).ok());
        QVERIFY2(remarksOf(*taken).contains("Part of the data: 8 of the 24 points."), qPrintable(remarksOf(*taken)));

        // Around the others they are refused, and counted without the third one.
        complex.region = Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(3, 3, 3));
        const auto refused = datasetOf(complex, values);
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().starts_with("At least 1 of the mesh's 2 cells are faulty"),
                 refused.error().text().c_str());
        // A region without anything is takePart()'s to refuse.
        part.region = complex.region = Eigen::AlignedBox3d(Eigen::Vector3d(50, 0, 0), Eigen::Vector3d(51, 1, 1));
        const auto nothing = datasetOf(complex, values);
        QVERIFY2(nothing.ok(), nothing ? "" : nothing.error().text().c_str());
        QVERIFY(!takePart(*nothing, part).ok());
    }

    /// C10: meshes damaged at random in up to a thousandth of their cells: what is left covers its domain once, and
    /// what was taken out because of an overlap does overlap a cell of the file. Nothing else is missing.
    void randomDamage()
    {
        std::uint32_t overlapping = 0;
        for (std::uint32_t seed = 0; seed < 10; ++seed) {
            const DamagedCells damaged(11, seed);
            const CellComplex& complex = damaged.complex();
            const auto dataset = datasetOf(complex, damaged.values());
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            const Status sound = checkIrregular(*dataset);
            QVERIFY2(sound.ok(), sound ? "" : sound.error().text().c_str());
            std::uint64_t blanked = 0;
            for (std::size_t cell = 0; cell < complex.shapes.size(); ++cell)
                blanked += complex.blanked[cell] != 0;
            const std::size_t faulty = dataset->faultyCells ? dataset->faultyCells->size() : 0;
            QCOMPARE(dataset->tetrahedra->size() + blanked + faulty, complex.shapes.size());
            for (std::size_t i = 0; i < faulty; ++i) {
                const FaultyCell& one = (*dataset->faultyCells)[i];
                QVERIFY(i == 0 || (*dataset->faultyCells)[i - 1].cell < one.cell);
                if (one.fault < CellFault::CrowdedFace)
                    continue;
                ++overlapping;
                bool overlaps = false;
                for (std::size_t cell = 0; cell < complex.shapes.size() && !overlaps; ++cell)
                    overlaps = cell != one.cell && tetrahedraOverlap(complex.positions, positive(complex, one.cell),
                                                                     positive(complex, cell));
                QVERIFY(overlaps);
            }
        }
        QVERIFY(overlapping > 6);
    }

    void refusals_data()
    {
        QTest::addColumn<CellComplex>("complex");
        QTest::addColumn<QString>("says");
        const QString faulty = "At least 1 of the mesh's 2 cells are faulty, more than 0.1%. The first is cell 1 at ";
        QTest::newRow("overlap") << twoCubes({1, 1, 1}) << faulty + "(1, 1, 1): it overlaps others.";
        QTest::newRow("inside") << twoCubes({0.5, 0.5, 0.5}, 0.25) << faulty + "(0.5, 0.5, 0.5): it overlaps others.";
        CellComplex complex = complexOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}}, CellShape::Tetrahedron,
                                        {{0, 1, 2, 3}, {0, 1, 2, 4}});
        QTest::newRow("same side") << complex << faulty + "(0, 0, 0): it is inverted and overlaps its neighbours.";
        complex.positions.insert(complex.positions.end(), {{0, 0, -1}});
        complex = complexOf(complex.positions, CellShape::Tetrahedron, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}});
        QTest::newRow("three at a face") << complex << "more than two cells share one of its faces.";
        complex = singleCell(CellShape::Hexahedron);
        complex.corners[3] = 8;
        QTest::newRow("range") << complex << "Cells refer to points that do not exist (1 in all, the first is cell 0)";
        complex = singleCell(CellShape::Hexahedron);
        complex.shapes[0] = CellShape::Polyhedron;
        QTest::newRow("polyhedron") << complex << "Faces of polyhedra have more points than are listed";
        complex = singleCell(CellShape::Hexahedron);
        complex.shapes[0] = CellShape::Prism;
        QTest::newRow("corner count") << complex << "the number of corners";
        complex = singleCell(CellShape::Hexahedron);
        complex.positions[2][1] = notANumber;
        QTest::newRow("place") << complex << "not finite";
        complex.positions[2][1] = -1e120;
        QTest::newRow("far") << complex << "or too large to compute with (1 in all, the first is cell 0)";
        complex = singleCell(CellShape::Hexahedron);
        complex.offsets[1] = 7;
        QTest::newRow("offsets") << complex << "offsets";
        complex = singleCell(CellShape::Hexahedron);
        complex.blanked = {1};
        QTest::newRow("nothing left") << complex << "nothing is left";
        QTest::newRow("empty") << CellComplex{} << "no cells";
        complex = singleCell(CellShape::Hexahedron);
        std::swap(complex.positions[0], complex.positions[6]);
        QTest::newRow("folded") << complex << "folded or so warped";
    }
    void refusals()
    {
        QFETCH(const CellComplex, complex);
        QFETCH(const QString, says);
        ComplexValues values;
        values.values.resize(complex.positions.size(), 1);
        const auto dataset = datasetOf(complex, values);
        QVERIFY(!dataset.ok());
        QCOMPARE(dataset.error().kind, ErrorKind::BadInput);
        QVERIFY2(QString::fromStdString(dataset.error().text()).contains(says), dataset.error().text().c_str());
    }

    void cancelled()
    {
        const CellComplex complex = lattice(3, [](auto, auto, auto) { return true; });
        std::stop_source stop;
        stop.request_stop();
        const auto dataset = irregularDataset(complex, linearValues(complex), {.name = "cells", .path = {}, .hash = 0},
                                              Progress(stop.get_token(), [](double, const Message&) {}));
        QVERIFY(!dataset.ok());
        QCOMPARE(dataset.error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(IrregularDatasetTest)
#include "irregular_dataset_test.moc"
