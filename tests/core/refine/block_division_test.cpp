// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/block_division.h"

#include <QTest>

using namespace tetra;

class BlockDivisionTest : public QObject {
    Q_OBJECT
private slots:
    /// R10: the blocks cover every cell once, and a point belongs to just the blocks whose boxes hold it.
    void pointsBelongToTheBlocksThatHoldThem_data()
    {
        QTest::addColumn<quint32>("edge");
        QTest::addColumn<quint32>("blocks");
        QTest::newRow("none") << 0u << 1u;
        QTest::newRow("one cell") << 1u << 6u * 4u * 1u;
        QTest::newRow("smaller at the end") << 4u << 2u * 1u * 1u;
        QTest::newRow("fitting") << 3u << 2u * 2u * 1u;
        QTest::newRow("larger than the lattice") << 50u << 1u;
    }
    void pointsBelongToTheBlocksThatHoldThem()
    {
        QFETCH(quint32, edge);
        QFETCH(quint32, blocks);
        const std::array<std::uint32_t, 3> size{7, 5, 2};
        const BlockDivision division(size, edge);
        QCOMPARE(division.count(), blocks);
        std::uint32_t cells = 0;
        for (std::uint32_t block = 0; block < division.count(); ++block) {
            const LatticeBox box = division.box(block);
            cells += (box.size[0] - 1) * (box.size[1] - 1) * (box.size[2] - 1);
        }
        QCOMPARE(cells, 6u * 4u * 1u);
        std::vector<std::uint32_t> found;
        for (std::uint32_t z = 0; z < size[2]; ++z)
            for (std::uint32_t y = 0; y < size[1]; ++y)
                for (std::uint32_t x = 0; x < size[0]; ++x) {
                    const std::array<std::uint32_t, 3> point{x, y, z};
                    std::vector<std::uint32_t> expected;
                    for (std::uint32_t block = 0; block < division.count(); ++block) {
                        const LatticeBox box = division.box(block);
                        bool inside = true;
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            inside = inside && point[axis] >= box.origin[axis] && point[axis] <= box.last(axis);
                        if (inside)
                            expected.push_back(block);
                    }
                    division.blocksOf(point, found);
                    QCOMPARE(found, expected);
                }
    }

    void neighboursHaveOppositeParity()
    {
        const BlockDivision division({9, 9, 9}, 4);
        QCOMPARE(division.count(), 8u);
        QVERIFY(!division.odd(0));
        QVERIFY(division.odd(1) && division.odd(2) && division.odd(4) && division.odd(7));
        QVERIFY(!division.odd(3) && !division.odd(5) && !division.odd(6));
    }
};

QTEST_APPLESS_MAIN(BlockDivisionTest)
#include "block_division_test.moc"
