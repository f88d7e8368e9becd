// SPDX-License-Identifier: GPL-3.0-or-later
// The samples and the tiles that a cell may cover.
#include "core/render/volume/projected_vertices.h"

#include <QTest>

#include <random>

using namespace tetra;

class SampleBoxTest : public QObject {
    Q_OBJECT

private slots:
    /// Every sample of every side that tiles can have.
    void tilesAreFoundAsByDivision()
    {
        for (int side = 1; side <= 255; ++side) {
            const TileFinder finder(TileGrid{1 << 15, 1 << 15, side});
            for (int sample = 0; sample <= 1 << 15; ++sample)
                if (finder.tileOf(sample) != sample / side)
                    QFAIL(qPrintable(QString("sample %1, tiles of %2").arg(sample).arg(side)));
        }
        const TileGrid grid{130, 70, 64};
        QCOMPARE(TileFinder(grid).numberOf(1, 2), std::size_t(5));
        QCOMPARE(grid.tile(5).left, 128);
    }

    void boxesHoldTheCorners()
    {
        std::mt19937 random(5);
        std::uniform_int_distribution<std::int16_t> place(-32767, 32767);
        ProjectedVertices projected;
        for (int i = 0; i < 1000; ++i)
            projected.samples.push_back({place(random), place(random)});
        for (int trial = 0; trial < 10000; ++trial) {
            std::array<std::uint32_t, 4> corners{};
            for (std::uint32_t& corner : corners)
                corner = random() % 1000;
            check(std::span<const std::uint32_t, 4>(corners), projected);
            check(std::span<const std::uint32_t, 4>(corners).first<3>(), projected);
        }
    }

private:
    template <std::size_t count>
    static void check(std::span<const std::uint32_t, count> corners, const ProjectedVertices& projected)
    {
        SampleRectangle expected{32767, 32767, -32767, -32767};
        for (const std::uint32_t corner : corners) {
            const VertexSample sample = projected.samples[corner];
            expected = {std::min<int>(expected.left, sample.column), std::min<int>(expected.top, sample.row),
                        std::max<int>(expected.right, sample.column), std::max<int>(expected.bottom, sample.row)};
        }
        QVERIFY(boxOf(corners, projected, VolumeView{}) == expected);
    }
};

QTEST_APPLESS_MAIN(SampleBoxTest)
#include "sample_box_test.moc"
