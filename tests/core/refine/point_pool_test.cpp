// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/point_pool.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <vector>

using namespace tetra;

/// Buckets that split as refinement splits them: every list must stay as it was written.
class PointPoolTest : public QObject {
    Q_OBJECT
private slots:
    /// Places are numbers of 32 bits, and lists of any sizes take up to twice their points.
    void refusesMorePointsThanItHasPlaces()
    {
        PointPool pool;
        QVERIFY(pool.reserve(PointPool::mostPoints).ok()); // takes addresses only
        const Status refused = pool.reserve(std::uint64_t(1) << 31);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
    }

    void listsKeepTheirPointsWhileTheySplit()
    {
        constexpr std::uint32_t total = 20000;
        PointPool pool;
        QVERIFY(pool.reserve(total).ok());
        struct List {
            std::uint32_t place;
            std::vector<PackedPoint> points;
        };
        std::mt19937 random(7);
        std::vector<List> lists;
        const auto add = [&](std::vector<PackedPoint> points) {
            const std::uint32_t count = static_cast<std::uint32_t>(points.size());
            const std::uint32_t place = pool.allocate(count);
            std::ranges::copy(points, pool.points(place, count).begin());
            lists.push_back({place, std::move(points)});
        };
        std::vector<PackedPoint> all(total);
        for (std::uint32_t i = 0; i < total; ++i)
            all[i] = i * 2654435761u;
        add(all);
        std::size_t checked = 0;
        while (!lists.empty()) {
            const std::size_t chosen = random() % lists.size();
            const List list = lists[chosen];
            const auto stored = pool.points(list.place, static_cast<std::uint32_t>(list.points.size()));
            QVERIFY(std::ranges::equal(stored, list.points));
            checked += list.points.size() == 1;
            lists[chosen] = lists.back();
            lists.pop_back();
            pool.free(list.place, static_cast<std::uint32_t>(list.points.size()));
            if (list.points.size() == 1)
                continue;
            const std::size_t cut = 1 + random() % (list.points.size() - 1);
            add({list.points.begin(), list.points.begin() + static_cast<std::ptrdiff_t>(cut)});
            add({list.points.begin() + static_cast<std::ptrdiff_t>(cut), list.points.end()});
        }
        QCOMPARE(checked, std::size_t(total));
    }
};

QTEST_APPLESS_MAIN(PointPoolTest)
#include "point_pool_test.moc"
