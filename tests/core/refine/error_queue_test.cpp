// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/error_queue.h"

#include <QTest>

#include <random>

using namespace tetra;

/// R8 and S3: the queue gives the bucket of the largest error, ties by the point's place, whatever changed meanwhile.
class ErrorQueueTest : public QObject {
    Q_OBJECT
private slots:
    void equalsASearchThroughAllBuckets_data()
    {
        QTest::addColumn<int>("differentErrors");
        QTest::addColumn<double>("largest");
        QTest::newRow("many ties") << 5 << 255.0;
        QTest::newRow("few ties") << 100000 << 255.0;
        QTest::newRow("larger than announced") << 1000 << 1.0;
        QTest::newRow("tiny") << 1000 << 1e30;
    }
    void equalsASearchThroughAllBuckets()
    {
        QFETCH(int, differentErrors);
        QFETCH(double, largest);
        const PackedLattice lattice({40, 40, 40});
        ErrorQueue queue;
        queue.start(1000);
        queue.push(0, {1, 0, 0, 77, 0}); // What a former run left is forgotten.
        queue.start(static_cast<float>(largest));
        std::vector<PointBucket> buckets(300);
        std::mt19937 random(3);
        const auto renew = [&](std::uint32_t number) {
            const float error = 255.0f * static_cast<float>(1 + random() % static_cast<unsigned>(differentErrors)) /
                                static_cast<float>(differentErrors);
            buckets[number] = {1, 0, lattice.pack(random() % 40, random() % 40, random() % 40), error, number};
            queue.push(number, buckets[number]);
        };
        for (std::uint32_t number = 0; number < buckets.size(); ++number)
            renew(number);
        for (int step = 0; step < 20000; ++step) {
            const std::uint32_t top = queue.top(buckets);
            std::uint32_t expected = ErrorQueue::none;
            const auto before = [&](const PointBucket& a, const PointBucket& b) {
                return a.error != b.error ? a.error > b.error : lattice.index(a.worst) < lattice.index(b.worst);
            };
            for (std::uint32_t number = 0; number < buckets.size(); ++number)
                if (buckets[number].count > 0 &&
                    (expected == ErrorQueue::none || before(buckets[number], buckets[expected])))
                    expected = number;
            QCOMPARE(top == ErrorQueue::none, expected == ErrorQueue::none);
            if (top == ErrorQueue::none)
                break;
            QCOMPARE(buckets[top].error, buckets[expected].error);
            QCOMPARE(lattice.index(buckets[top].worst), lattice.index(buckets[expected].worst));
            buckets[top].count = 0;
            // Some buckets change or vanish without being on top; fewer and fewer are made anew.
            if (random() % 20000 > static_cast<unsigned>(step))
                renew(random() % static_cast<unsigned>(buckets.size()));
            if (random() % 3 == 0)
                buckets[random() % buckets.size()].count = 0;
            if (step % 500 == 0)
                queue.sweep(buckets);
        }
    }
};

QTEST_APPLESS_MAIN(ErrorQueueTest)
#include "error_queue_test.moc"
