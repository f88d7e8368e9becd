// SPDX-License-Identifier: GPL-3.0-or-later
// A batch has one form, whatever the order in which its independent steps came (S1).
#include "core/history/batch_builder.h"

#include <QTest>

#include <algorithm>

using namespace tetra;

namespace {

struct Made {
    std::uint64_t point;
    std::vector<HistoryTetrahedron> star;
    std::vector<std::uint32_t> destroyed;
};

void add(HistoryBatch& batch, const Made& made)
{
    batch.add({made.point, 1, made.star, made.destroyed});
}

} // namespace

class HistoryBatchTest : public QObject {
    Q_OBJECT

private slots:
    /// Site 12 uses up a tetrahedron of site 10; site 11 has nothing to do with them.
    void sitesThatDependOnEachOtherAreAGroup()
    {
        HistoryBatch batch;
        batch.start(10, 50);
        add(batch, {70, {{{0, 1, 2}}, {{0, 1, 3}}}, {4}});
        add(batch, {30, {{{4, 5, 6}}}, {7}});
        add(batch, {20, {{{0, 1, 2}}}, {51, 8}});
        batch.arrange();
        QCOMPARE(batch.siteCount(), 3u);
        QCOMPARE(batch.pointAt(0), std::uint64_t(20));
        QCOMPARE(batch.pointAt(1), std::uint64_t(70));
        QCOMPARE(batch.pointAt(2), std::uint64_t(30));
        QVERIFY(batch.groupGoesOn(0) && !batch.groupGoesOn(1) && !batch.groupGoesOn(2));
        QCOMPARE(batch.placeOf(10), 1u);
        QCOMPARE(batch.placeOf(11), 2u);
        QCOMPARE(batch.placeOf(12), 0u);
        std::vector<bool> dropped;
        std::ranges::transform(batch.tetrahedra(), std::back_inserter(dropped), &HistoryBatch::Tetrahedron::dropped);
        QCOMPARE(dropped, (std::vector<bool>{false, true, false, false}));
    }

    /// A tetrahedron that stays joins its sites, too.
    void sitesOfOneTetrahedronAreAGroup()
    {
        HistoryBatch batch;
        batch.start(8, 20);
        add(batch, {9, {{{0, 1, 2}}}, {4}});
        add(batch, {5, {{{0, 1, 8}}}, {6}});
        batch.arrange();
        QVERIFY(batch.groupGoesOn(0));
        QCOMPARE(batch.pointAt(0), std::uint64_t(5));
    }

    void theOrderOfIndependentStepsMakesNoDifference()
    {
        std::vector<Made> steps = {{40, {{{0, 1, 2}}}, {1}}, {10, {{{1, 2, 3}}}, {2}}, {25, {{{2, 3, 4}}}, {3}}};
        std::ranges::sort(steps, {}, &Made::point);
        do {
            HistoryBatch batch;
            batch.start(100, 1000);
            for (const Made& step : steps)
                add(batch, step);
            batch.arrange();
            for (std::uint32_t place = 0; place < 3; ++place)
                QVERIFY(!batch.groupGoesOn(place));
            QCOMPARE(batch.pointAt(0), std::uint64_t(10));
            QCOMPARE(batch.pointAt(1), std::uint64_t(25));
            QCOMPARE(batch.pointAt(2), std::uint64_t(40));
        } while (std::ranges::next_permutation(steps, {}, &Made::point).found);
    }

    /// The latest site comes first and the orientation stays: every even permutation is tried on one tetrahedron.
    void bringingTheLatestToTheFrontKeepsTheOrientation()
    {
        std::array<std::uint32_t, 4> sites = {0, 1, 2, 3};
        do {
            const auto result = latestFirst(sites);
            QCOMPARE(result[0], 3u);
            QCOMPARE(inversions(result) % 2, inversions(sites) % 2);
        } while (std::ranges::next_permutation(sites).found);
    }

private:
    static int inversions(const std::array<std::uint32_t, 4>& sites)
    {
        int count = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j)
                count += sites[i] > sites[j] ? 1 : 0;
        return count;
    }
};

QTEST_GUILESS_MAIN(HistoryBatchTest)
#include "history_batch_test.moc"
