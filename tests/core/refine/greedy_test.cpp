// SPDX-License-Identifier: GPL-3.0-or-later
/// The loop of refinement and the orders that it goes through, on spaces whose answers are known: numbers to be taken.
#include "core/refine/greedy.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

using namespace tetra;

namespace {

Error anError()
{
    return {ErrorKind::BadInput, Message::say("No more.")};
}

/// Takes the largest of some numbers; each is made of two halves.
struct Halves {
    struct Next {
        float key = 0;
        bool complete = true;
    };
    Next next() const
    {
        const float largest = numbers.empty() ? 0 : std::ranges::max(numbers);
        return {largest, largest < incompleteFrom};
    }
    Status insert(const Next& next)
    {
        if (taken.size() == failsAt)
            return anError();
        numbers.erase(std::ranges::find(numbers, next.key));
        numbers.push_back(next.key / 2);
        numbers.push_back(next.key / 2);
        taken.push_back(next.key);
        return {};
    }
    std::uint64_t work() const { return workOfEach; }
    std::uint64_t pointsAboveStop() const
    {
        return static_cast<std::uint64_t>(std::ranges::count_if(numbers, [](float number) { return number > 1; }));
    }
    void sweep() { ++sweeps; }
    void archive(StateArchive& archive) { archive(numbers, taken); }

    std::vector<float> numbers;
    std::vector<float> taken{};
    float incompleteFrom = 1e9f;
    std::size_t failsAt = ~std::size_t(0);
    std::uint64_t workOfEach = 1;
    int sweeps = 0;
};

struct EndOfHistory final : HistorySink {
    Status add(const HistoryStep&) override { return {}; }
    Status finish(float key) override
    {
        finalKey = key;
        return fails ? Status(anError()) : Status();
    }
    float finalKey = -1;
    bool fails = false;
};

/// Cells of a row, each with a weight, of which in rounds the heaviest are taken; that makes its neighbours half as
/// heavy and takes back what was found in them.
struct Row {
    struct Found {
        std::size_t cell;
        int change; ///< how often the cell had changed when it was found
        double weight;
    };
    explicit Row(std::vector<double> ofCells) : weights(std::move(ofCells)), changes(weights.size(), 0) { find(); }
    bool find()
    {
        round.found.clear();
        for (std::size_t cell = 0; cell < weights.size(); ++cell)
            if (weights[cell] > 1)
                round.found.push_back({cell, changes[cell], weights[cell]});
        return round.begin([](const Found& one, const Found& other) {
            return one.weight != other.weight ? one.weight > other.weight : one.cell < other.cell;
        });
    }
    const Found* next()
    {
        return round.next([this](const Found& one) { return changes[one.cell] == one.change; });
    }
    Status insert(const Found& one)
    {
        taken.push_back(one.cell);
        change(one.cell, 0);
        if (one.cell > 0)
            change(one.cell - 1, 0.5);
        if (one.cell + 1 < weights.size())
            change(one.cell + 1, 0.5);
        return {};
    }
    void change(std::size_t cell, double factor)
    {
        weights[cell] *= factor;
        ++changes[cell];
    }
    std::uint64_t work() const { return Round<Found>::work; }
    Status pause()
    {
        pauses.push_back(taken.size());
        return pauses.size() == cancelledAt ? Status(cancelledError(Message::say("The row"))) : Status();
    }
    Result<bool> look()
    {
        looks.push_back(taken.size());
        return looks.size() == failsAt ? Result<bool>(anError()) : Result<bool>(find());
    }

    std::vector<double> weights;
    std::vector<int> changes;
    Round<Found> round;
    std::vector<std::size_t> taken, looks, pauses;
    std::size_t cancelledAt = 0, failsAt = 0;
};

} // namespace

class GreedyTest : public QObject {
    Q_OBJECT
private slots:
    void takesTheWorstFirstUntilTheStop()
    {
        Halves space{{3, 8, 1}};
        EndOfHistory history;
        const Result<float> key = refineWorstFirst(space, 1.5, history, {});
        QVERIFY(key.ok());
        QCOMPARE(space.taken, (std::vector<float>{8, 4, 4, 3, 2, 2, 2, 2}));
        QCOMPARE(*key, 1.5f);
        QCOMPARE(history.finalKey, 1.5f);
    }
    /// A mesh that is not complete goes on below the stop.
    void goesOnUntilTheMeshIsComplete()
    {
        Halves space{{8}};
        space.incompleteFrom = 1.5f;
        EndOfHistory history;
        const Result<float> key = refineWorstFirst(space, 5, history, {});
        QVERIFY(key.ok());
        QCOMPARE(*key, 1.0f);
    }
    void handsErrorsOn()
    {
        Halves space{{8}};
        space.failsAt = 3;
        EndOfHistory history;
        QVERIFY(refineWorstFirst(space, 1, history, {}).error().kind == ErrorKind::BadInput);
        QCOMPARE(space.taken.size(), std::size_t(3));
        QCOMPARE(history.finalKey, -1.0f);
        Halves whole{{8}};
        history.fails = true;
        QVERIFY(refineWorstFirst(whole, 1, history, {}).error().kind == ErrorKind::BadInput);
    }
    /// Pauses come by work, in them progress, sweeping and the end of cancelled work.
    void pausesByWork()
    {
        Halves space{{1024}};
        space.workOfEach = 1u << 18;
        EndOfHistory history;
        double last = 0;
        int reports = 0;
        std::stop_source stop;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            QVERIFY(fraction >= last && fraction <= 1);
            last = fraction;
            if (++reports == 5)
                stop.request_stop();
        });
        const Result<float> key = refineWorstFirst(space, 1, history, progress);
        QVERIFY(!key.ok() && key.error().kind == ErrorKind::Cancelled);
        QCOMPARE(reports, 5);
        QCOMPARE(space.sweeps, 5);
        QCOMPARE(space.taken.size(), std::size_t(24)); // four for each pause
    }
    /// What is saved in a pause goes on to the same end.
    void goesOnFromAPause()
    {
        Halves whole{{100, 77, 31}};
        EndOfHistory history;
        QVERIFY(refineWorstFirst(whole, 1, history, {}).ok());
        QTemporaryDir folder;
        const std::filesystem::path place = folder.path().toStdString();
        {
            const auto state = SavedState::open(place, 1);
            QVERIFY(state.ok());
            Halves space{{100, 77, 31}};
            space.workOfEach = 1u << 18;
            std::stop_source stop;
            const Progress progress(stop.get_token(), [&](double, const Message&) { stop.request_stop(); });
            QVERIFY(!refineWorstFirst(space, 1, history, progress, state->get()).ok());
        }
        const auto state = SavedState::open(place, 1);
        QVERIFY(state.ok() && (*state)->found());
        Halves space;
        QVERIFY((*state)->load(space).ok());
        QVERIFY(!space.taken.empty() && space.taken.size() < whole.taken.size());
        QVERIFY(refineWorstFirst(space, 1, history, {}, state->get()).ok());
        QCOMPARE(space.taken, whole.taken);
    }

    void takesInARoundWhatStillStands()
    {
        Row row({4, 6, 4, 2, 3});
        QVERIFY(refineGreedily(row).ok());
        // First 6 and 3, whose neighbours wait for the next look: 2, 2 and 0.5.
        QCOMPARE(row.taken, (std::vector<std::size_t>{1, 4, 0, 2}));
        QCOMPARE(row.looks, (std::vector<std::size_t>{2, 4}));
        QVERIFY(std::ranges::max(row.weights) <= 1);
    }
    void looksAtOnceIfThereIsNothing()
    {
        Row row({1, 0.5});
        QVERIFY(refineGreedily(row).ok());
        QVERIFY(row.taken.empty());
        QCOMPARE(row.looks, std::vector<std::size_t>{0});
    }
    void handsErrorsOfALookOn()
    {
        Row row({4, 6, 4, 2, 3});
        row.failsAt = 1;
        QVERIFY(refineGreedily(row).error().kind == ErrorKind::BadInput);
        QCOMPARE(row.taken.size(), std::size_t(2));
    }
    /// In a round that is never measured, every 256 insertions.
    void pausesInARound()
    {
        std::vector<double> weights(2000, 0);
        for (std::size_t cell = 0; cell < weights.size(); cell += 2)
            weights[cell] = 2;
        Row row(weights);
        QVERIFY(refineGreedily(row).ok());
        QCOMPARE(row.taken.size(), std::size_t(1000));
        QCOMPARE(row.pauses, (std::vector<std::size_t>{256, 512, 768}));
        Row cancelled(weights);
        cancelled.cancelledAt = 2;
        QVERIFY(refineGreedily(cancelled).error().kind == ErrorKind::Cancelled);
        QCOMPARE(cancelled.taken.size(), std::size_t(512));
    }
};

QTEST_GUILESS_MAIN(GreedyTest)
#include "greedy_test.moc"
