// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/radix_sort.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace tetra;

namespace {

bool same(const Buffer<KeyedIndex>& one, const Buffer<KeyedIndex>& other)
{
    return std::ranges::equal(one, other,
                              [](const auto& a, const auto& b) { return a.key == b.key && a.index == b.index; });
}

} // namespace

class RadixSortTest : public QObject {
    Q_OBJECT

private slots:
    /// As std::stable_sort does it: few and many items, few and many different keys.
    void sortsStably()
    {
        std::mt19937 random(1);
        for (const std::size_t count : {0u, 1u, 2u, 1000u, 70'000u, 300'000u})
            for (const int bits : {1, 11, 12, 30, 32}) {
                Buffer<KeyedIndex> items(count);
                for (std::size_t i = 0; i < count; ++i)
                    items[i] = {static_cast<std::uint32_t>(random()) >> (32 - bits), static_cast<std::uint32_t>(i)};
                Buffer<KeyedIndex> expected = items;
                std::ranges::stable_sort(expected, {}, &KeyedIndex::key);
                radixSort(items, bits);
                QVERIFY(same(items, expected));
            }
    }
};

QTEST_GUILESS_MAIN(RadixSortTest)
#include "radix_sort_test.moc"
