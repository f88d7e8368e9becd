// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_orders.h"
#include "core/decimate/decimated_mesh.h"
#include "core/decimate/vertex_star.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

using namespace tetra;

/// What exact order is made of, each against the plainest way to do the same.
class DecimationOrderTest : public QObject {
    Q_OBJECT

private slots:
    void theSmallestKeyComesFirst();
    void numbersAreToldApart();
    void theLargestKeyIsKnown();
};

/// Keys rise on the whole, as in a decimation, but smaller ones than the last come in, too; many are equal.
void DecimationOrderTest::theSmallestKeyComesFirst()
{
    using Entry = CollapseQueue::Entry;
    const auto earlier = [](const Entry& one, const Entry& other) {
        return std::tie(one.key, one.vertex) < std::tie(other.key, other.vertex);
    };
    std::mt19937 random(1);
    std::exponential_distribution<float> keys(.1F);
    CollapseQueue queue;
    std::vector<Entry> expected;
    float last = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const bool wantsMore = expected.empty() || random() % 5 < (i < 10000 ? 3U : 2U);
        if (wantsMore) {
            const float key = i % 3 == 0 ? float(random() % 4) / 2 : last * .9F + keys(random);
            const Entry entry{key, static_cast<std::uint32_t>(random()), i, i};
            queue.push(entry);
            expected.insert(std::ranges::upper_bound(expected, entry, earlier), entry);
        } else {
            QCOMPARE(queue.leastKey(), expected.front().key);
            const Entry first = queue.pop();
            QCOMPARE(first.key, expected.front().key);
            QCOMPARE(first.vertex, expected.front().vertex);
            QCOMPARE(first.version, expected.front().version);
            expected.erase(expected.begin());
            last = first.key;
        }
        QCOMPARE(queue.empty(), expected.empty());
    }
}

/// Also more different ones than registers hold.
void DecimationOrderTest::numbersAreToldApart()
{
    std::mt19937 random(2);
    DistinctNumbers finder;
    std::vector<std::uint32_t> distinct;
    for (std::uint32_t size = 0; size < 300; ++size) {
        std::vector<std::uint32_t> numbers(size), places(size), expected;
        const std::uint32_t range = 1 + static_cast<std::uint32_t>(random() % (size / 2 + 2));
        for (std::uint32_t& number : numbers) {
            number = static_cast<std::uint32_t>(random() % range) * 0x01000193U;
            if (std::ranges::find(expected, number) == expected.end())
                expected.push_back(number);
        }
        finder.find(numbers, distinct, places);
        QCOMPARE(distinct, expected);
        for (std::size_t i = 0; i < size; ++i)
            QCOMPARE(distinct[places[i]], numbers[i]);
    }
}

void DecimationOrderTest::theLargestKeyIsKnown()
{
    std::mt19937 random(3);
    for (const std::size_t count : {std::size_t(1), std::size_t(16), std::size_t(17), std::size_t(700)}) {
        KeyTournament tournament(count);
        std::vector<float> keys(count, 0);
        for (int i = 0; i < 3000; ++i) {
            const std::size_t index = random() % count;
            keys[index] = float(random() % 50);
            tournament.set(index, keys[index]);
            QCOMPARE(tournament.largest(), *std::ranges::max_element(keys));
        }
    }
}

QTEST_APPLESS_MAIN(DecimationOrderTest)
#include "decimation_order_test.moc"
