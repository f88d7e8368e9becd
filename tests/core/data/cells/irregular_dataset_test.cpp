// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/irregular_check.h"
#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "tests/core/data/cells/cell_cases.h"

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
            QVERIFY(!remarks.contains("touched"));
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
        QVERIFY(remarksOf(*dataset).contains("9 points belong to no cell"));
    }

    void seamsAreWelded()
    {
        CellComplex complex = twoCubes({2, 0, 0});
        ComplexValues values = linearValues(complex);
        auto dataset = datasetOf(complex, values);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), 12);
        QVERIFY(remarksOf(*dataset).contains("4 points on the place of another one"));
        QVERIFY(!remarksOf(*dataset).contains("different values"));
        values.values[8] += 1;
        dataset = datasetOf(complex, values);
        QVERIFY(dataset.ok());
        QVERIFY(remarksOf(*dataset).contains("1 place had different values"));
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
        QVERIFY(remarksOf(*dataset).contains("2 cells name a corner twice"));
        QVERIFY(remarksOf(*dataset).contains("1 cell without volume was"));
        QVERIFY(remarksOf(*dataset).contains("2 points belong to no cell"));
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
        QVERIFY(remarksOf(*dataset).contains("6 tetrahedra were there twice"));
    }

    /// Parts that touch in an edge: refused if they are much of the mesh, and cut back where a mask made them.
    void pinches()
    {
        const CellComplex diagonal = lattice(2, [](auto i, auto j, auto) { return i == j; });
        const auto refused = datasetOf(diagonal, linearValues(diagonal));
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().find("2 edges in which parts") != std::string::npos,
                 refused.error().text().c_str());
        CellComplex masked = lattice(2, [](auto, auto, auto) { return true; });
        masked.blanked = {0, 1, 1, 0, 0, 1, 1, 0};
        const auto dataset = datasetOf(masked, linearValues(masked));
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QVERIFY(remarksOf(*dataset).contains("touched only in an edge"));
        QVERIFY(totalVolume6(*dataset) < 6.0 * 4);
    }

    void refusals_data()
    {
        QTest::addColumn<CellComplex>("complex");
        QTest::addColumn<QString>("says");
        QTest::newRow("overlap") << twoCubes({1, 1, 1}) << "cut or touch";
        QTest::newRow("hanging corners") << twoCubes({2, 0.5, 0}) << "cut or touch";
        QTest::newRow("touching corner") << twoCubes({2, 2, 2}) << "point in which parts";
        QTest::newRow("inside") << twoCubes({0.5, 0.5, 0.5}, 0.25) << "1 part inside another part";
        CellComplex complex = complexOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}}, CellShape::Tetrahedron,
                                        {{0, 1, 2, 3}, {0, 1, 2, 4}});
        QTest::newRow("same side") << complex << "2 tetrahedra that overlap a neighbour";
        complex.positions.insert(complex.positions.end(), {{0, 0, -1}});
        complex = complexOf(complex.positions, CellShape::Tetrahedron, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}});
        QTest::newRow("three at a face") << complex << "3 tetrahedra at faces";
        complex = singleCell(CellShape::Hexahedron);
        complex.corners[3] = 8;
        QTest::newRow("range") << complex << "Cells name points that do not exist (1 in all, the first is cell 0)";
        complex = singleCell(CellShape::Hexahedron);
        complex.shapes[0] = CellShape::Polyhedron;
        QTest::newRow("polyhedron") << complex << "polyhedra";
        complex = singleCell(CellShape::Hexahedron);
        complex.shapes[0] = CellShape::Prism;
        QTest::newRow("corner count") << complex << "another number of corners";
        complex = singleCell(CellShape::Hexahedron);
        complex.positions[2][1] = notANumber;
        QTest::newRow("place") << complex << "not finite";
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
