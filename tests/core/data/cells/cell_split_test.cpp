// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/cell_split.h"
#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "tests/core/data/cells/reference_cells.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace tetra;

namespace {

Triangle sorted(Triangle triangle)
{
    std::ranges::sort(triangle);
    return triangle;
}

/// The faces of pieces that only one of them has; empty if a face is in more than two.
std::set<Triangle> outerFaces(const CellPieces& pieces)
{
    std::map<Triangle, int> counts;
    for (const auto& piece : pieces)
        for (const auto& face : cornersOfFace)
            ++counts[sorted({piece[face[0]], piece[face[1]], piece[face[2]]})];
    std::set<Triangle> outer;
    for (const auto& [face, count] : counts) {
        if (count > 2)
            return {};
        if (count == 1)
            outer.insert(face);
    }
    return outer;
}

/// What is wrong with the cut of the reference cell whose nodes have these numbers; empty if nothing is.
QString mistakes(CellShape shape, const std::vector<std::uint32_t>& numbers)
{
    const std::vector<Eigen::Vector3d> nodes = referenceNodes(shape);
    std::vector<Eigen::Vector3d> positions(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        positions[numbers[i]] = nodes[i];
    CellPieces pieces;
    splitCell(shape, numbers, pieces);
    double volume = 0;
    std::set<std::uint32_t> used;
    for (const auto& piece : pieces) {
        if (orientation(positions, piece) <= 0)
            return "a piece is not positive";
        volume += 6 * volumeOf(positions, piece);
        used.insert(piece.begin(), piece.end());
    }
    if (volume != referenceVolume6(shape))
        return "the pieces do not fill the cell";
    if (used.size() != nodes.size())
        return "a node is left out";
    CellSurface surface;
    cellSurface(shape, numbers, {}, surface);
    std::set<Triangle> triangles;
    for (const Triangle& triangle : surface)
        triangles.insert(sorted(triangle));
    if (triangles != outerFaces(pieces))
        return "the pieces do not end on the surface";
    return {};
}

} // namespace

class CellSplitTest : public QObject {
    Q_OBJECT
private slots:
    /// R1: no numbering of the corners leaves a cell without a cut.
    void allNumberings_data()
    {
        QTest::addColumn<int>("shape");
        for (const CellShape shape :
             {CellShape::Tetrahedron, CellShape::Pyramid, CellShape::Prism, CellShape::Hexahedron})
            QTest::newRow(std::string(cellShapeName(shape)).c_str()) << static_cast<int>(shape);
    }
    void allNumberings()
    {
        QFETCH(const int, shape);
        std::vector<std::uint32_t> numbers(nodeCount(static_cast<CellShape>(shape)));
        std::iota(numbers.begin(), numbers.end(), 0);
        do {
            const QString wrong = mistakes(static_cast<CellShape>(shape), numbers);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        } while (std::ranges::next_permutation(numbers).found);
    }

    /// The middles decide, so their numberings are tried at random.
    void quadraticCells_data()
    {
        QTest::addColumn<int>("shape");
        for (const CellShape shape : {CellShape::QuadraticTetrahedron, CellShape::QuadraticPyramid,
                                      CellShape::QuadraticPrism, CellShape::QuadraticHexahedron})
            QTest::newRow(std::string(cellShapeName(shape)).c_str()) << static_cast<int>(shape);
    }
    void quadraticCells()
    {
        QFETCH(const int, shape);
        std::mt19937 random(11);
        std::vector<std::uint32_t> numbers(nodeCount(static_cast<CellShape>(shape)));
        std::iota(numbers.begin(), numbers.end(), 0);
        for (int trial = 0; trial < 5000; ++trial) {
            std::ranges::shuffle(numbers, random);
            const QString wrong = mistakes(static_cast<CellShape>(shape), numbers);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        }
    }
    void quadraticTetrahedronMakesEight()
    {
        CellPieces pieces;
        splitCell(CellShape::QuadraticTetrahedron, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, pieces);
        QCOMPARE(pieces.size(), 8);
    }

    /// A hexahedron with two corners on one is a prism, and so on: what is left has the cell's volume.
    void collapsedEdgesLeaveTheRest()
    {
        const auto nodes = referenceNodes(CellShape::Hexahedron);
        std::vector<std::uint32_t> numbers(8);
        std::iota(numbers.begin(), numbers.end(), 0);
        do {
            std::vector<Eigen::Vector3d> positions(8);
            for (std::size_t i = 0; i < 8; ++i)
                positions[numbers[i]] = nodes[i];
            std::vector<std::uint32_t> collapsed = numbers;
            collapsed[3] = collapsed[0];
            collapsed[7] = collapsed[4];
            CellPieces pieces;
            splitCell(CellShape::Hexahedron, collapsed, pieces);
            double volume = 0;
            for (const auto& piece : pieces) {
                QVERIFY(orientation(positions, piece) > 0);
                volume += 6 * volumeOf(positions, piece);
            }
            QCOMPARE(volume, 24.0);
        } while (std::ranges::next_permutation(numbers).found);
    }

    /// The search finds a cut whenever some cell with these diagonals has one, and never a wrong one: of the 64 choices
    /// of a hexahedron's diagonals, and of the 8 of a prism's, where the two cyclic ones have none.
    void searchFindsAllCuts()
    {
        for (const auto& [shape, withCut] : {std::pair(CellShape::Prism, 6), std::pair(CellShape::Pyramid, 2)}) {
            const auto positions = referenceNodes(shape);
            std::vector<std::uint32_t> numbers(positions.size());
            std::iota(numbers.begin(), numbers.end(), 0);
            const auto faces = quadrilateralsOf(shape, numbers);
            int found = 0;
            for (unsigned mask = 0; mask < 1U << faces.size(); ++mask) {
                CellSurface surface;
                unsigned face = 0;
                cellSurface(
                    shape, numbers, [&](const CellPolygon&) { return (mask >> face++ & 1) != 0; }, surface);
                std::uint64_t steps = 5000;
                const auto pieces = fillCavity(positions, surface, steps);
                if (!pieces)
                    continue;
                ++found;
                double volume = 0;
                for (const auto& piece : *pieces)
                    volume += 6 * volumeOf(positions, piece);
                QCOMPARE(volume, referenceVolume6(shape));
            }
            QCOMPARE(found, withCut);
        }
    }
};

QTEST_GUILESS_MAIN(CellSplitTest)
#include "cell_split_test.moc"
