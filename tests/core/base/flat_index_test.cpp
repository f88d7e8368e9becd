// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/flat_index.h"

#include <QTest>

#include <array>
#include <random>
#include <unordered_map>
#include <vector>

using namespace tetra;

namespace {

using Random = std::mt19937_64;

/// One place for all keys: each is found behind all the others.
struct SameHash {
    std::uint64_t operator()(std::uint64_t) const noexcept { return ~std::uint64_t(0); }
};

/// The same numbers, by the library's container.
template <class Key> class Numbers {
public:
    std::uint32_t numberOf(Key key)
    {
        const auto [known, isNew] = numbers_.try_emplace(key, static_cast<std::uint32_t>(keys_.size()));
        if (isNew)
            keys_.push_back(key);
        return known->second;
    }
    std::uint32_t find(Key key) const
    {
        const auto known = numbers_.find(key);
        return known == numbers_.end() ? 0xffffffff : known->second;
    }
    const std::vector<Key>& keys() const { return keys_; }

private:
    std::unordered_map<Key, std::uint32_t> numbers_;
    std::vector<Key> keys_;
};

/// Keys one by one, many together, and questions in between, as `nextKey` gives them; then the same again in the same
/// memory.
template <class Key, class Hash, class NextKey> void compare(std::size_t steps, std::size_t most, NextKey&& nextKey)
{
    Random random(steps + most);
    FlatIndex<Key, Hash> index;
    for (const std::size_t expected : {std::size_t(0), most, std::size_t(3)}) {
        if (expected > 0)
            index.clear(expected);
        Numbers<Key> numbers;
        for (std::size_t step = 0; step < steps; ++step) {
            const Key key = nextKey(random);
            QCOMPARE(index.find(key), numbers.find(key));
            QCOMPARE(index.contains(key), numbers.find(key) != index.none);
            if (random() % 4 > 0) {
                QCOMPARE(index.numberOf(key), numbers.numberOf(key));
            } else {
                std::vector<Key> keys(random() % most);
                for (Key& one : keys)
                    one = nextKey(random);
                std::size_t taken = 0;
                index.numberAll(keys, [&](std::size_t i, std::uint32_t number) {
                    QCOMPARE(i, taken++);
                    QCOMPARE(number, numbers.numberOf(keys[i]));
                });
                QCOMPARE(taken, keys.size());
            }
            QCOMPARE(index.size(), numbers.keys().size());
        }
        QVERIFY(std::ranges::equal(index.keys(), numbers.keys()));
    }
}

template <class Key, class Hash = FibonacciHash> void compareAll(std::size_t steps, std::size_t most)
{
    compare<Key, Hash>(steps, most, [](Random& random) { return static_cast<Key>(random()); });
    compare<Key, Hash>(steps, most, [](Random& random) { return static_cast<Key>(random() % 50); });
    compare<Key, Hash>(steps, most, [next = Key(0)](Random&) mutable { return next++; });
    // The lower bits are all the same, or the upper ones.
    compare<Key, Hash>(steps, most,
                       [](Random& random) { return static_cast<Key>(Key(random() % 2000) << (8 * sizeof(Key) - 11)); });
    compare<Key, Hash>(steps, most, [](Random& random) { return static_cast<Key>(~Key(0) - Key(random() % 2000)); });
}

} // namespace

class FlatIndexTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAsTheLibraryDoes()
    {
        compareAll<std::uint32_t>(500, 100);
        compareAll<std::uint64_t>(500, 100);
        compareAll<std::uint64_t>(100, 5000);
        compareAll<std::uint64_t, SameHash>(40, 20);
    }

    /// Keys are indices into an array, and equal if what lies there is.
    void comparesWhatKeysStandFor()
    {
        using Place = std::array<int, 2>;
        struct Hash {
            const std::vector<Place>* places;
            std::uint64_t operator()(std::uint32_t i) const
            {
                return FibonacciHash()(static_cast<std::uint64_t>((*places)[i][0] * 10 + (*places)[i][1]));
            }
        };
        struct Equal {
            const std::vector<Place>* places;
            bool operator()(std::uint32_t a, std::uint32_t b) const { return (*places)[a] == (*places)[b]; }
        };
        Random random(1);
        std::vector<Place> places(1000);
        for (Place& place : places)
            place = {int(random() % 10), int(random() % 10)};
        FlatIndex<std::uint32_t, Hash, Equal> index({&places}, {&places});
        for (std::uint32_t i = 0; i < places.size(); ++i) {
            const auto first = std::ranges::find(places, places[i]) - places.begin();
            QCOMPARE(index.firstLike(i), static_cast<std::uint32_t>(first));
        }
        QCOMPARE(index.size(), std::size_t(100));
    }

    void emptyOnesFindNothing()
    {
        FlatIndex<std::uint64_t> index;
        QCOMPARE(index.find(0), index.none);
        QVERIFY(index.keys().empty());
        index.numberAll({}, [](std::size_t, std::uint32_t) { QFAIL("there are no keys"); });
        QCOMPARE(index.numberOf(7), 0u);
        QVERIFY(index.contains(7) && !index.contains(0));
        index.clear();
        QCOMPARE(index.find(7), index.none);
        QCOMPARE(index.numberOf(0), 0u);
    }
};

QTEST_GUILESS_MAIN(FlatIndexTest)
#include "flat_index_test.moc"
