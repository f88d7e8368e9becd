// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/box_tree.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace tetra;

/// What a tree finds against what looking at every item finds.
class BoxTreeTest : public QObject {
    Q_OBJECT

private slots:
    void findsAllThatMeet_data() { counts(); }
    void findsAllThatMeet();
    void findsTheNearest_data() { counts(); }
    void findsTheNearest();

private:
    static void counts()
    {
        QTest::addColumn<int>("count");
        for (const int count : {0, 1, 4, 5, 9, 100, 1000})
            QTest::addRow("%d", count) << count;
    }
    /// Some of them in the same place, some flat.
    std::vector<Eigen::AlignedBox3d> randomBoxes(int count)
    {
        std::vector<Eigen::AlignedBox3d> boxes;
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector3d corner = i % 7 == 6 ? boxes.back().min() : randomPlace();
            boxes.emplace_back(corner, corner + (i % 5 == 0 ? 0.0 : 0.1) * randomPlace());
        }
        return boxes;
    }
    Eigen::Vector3d randomPlace()
    {
        std::uniform_real_distribution<double> number(0, 1);
        return {number(random_), number(random_), number(random_)};
    }
    static BoxTree treeOf(const std::vector<Eigen::AlignedBox3d>& boxes)
    {
        return BoxTree(
            boxes.size(), [&](std::uint32_t i) { return boxes[i]; },
            [&](std::uint32_t i, Eigen::Index axis) { return boxes[i].center()[axis]; });
    }

    std::mt19937 random_{7};
};

void BoxTreeTest::findsAllThatMeet()
{
    QFETCH(int, count);
    const std::vector<Eigen::AlignedBox3d> boxes = randomBoxes(count);
    const BoxTree tree = treeOf(boxes);
    std::size_t looked = 0, met = 0;
    for (int question = 0; question < 50; ++question) {
        const Eigen::Vector3d corner = randomPlace();
        const Eigen::AlignedBox3d asked(corner, corner + 0.05 * randomPlace());
        std::set<std::uint32_t> found;
        tree.visitNear([&](const Eigen::AlignedBox3d& box) { return box.intersects(asked); },
                       [&](std::uint32_t item) {
                           QVERIFY(found.insert(item).second); // once
                           ++looked;
                       });
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].intersects(asked)) {
                QVERIFY(found.contains(i));
                ++met;
            }
    }
    QVERIFY2(count < 1000 || looked < 1000 * 50 / 5, "it should look at few of many");
    QVERIFY(looked >= met);
}

void BoxTreeTest::findsTheNearest()
{
    QFETCH(int, count);
    const std::vector<Eigen::AlignedBox3d> boxes = randomBoxes(count);
    const BoxTree tree = treeOf(boxes);
    std::size_t looked = 0;
    for (int question = 0; question < 50; ++question) {
        const Eigen::Vector3d place = 3 * randomPlace() - Eigen::Vector3d(1, 1, 1);
        double nearest = std::numeric_limits<double>::infinity();
        tree.visitNearer(
            place, [&] { return nearest; },
            [&](std::uint32_t item) {
                nearest = std::min(nearest, boxes[item].exteriorDistance(place));
                ++looked;
            });
        double expected = std::numeric_limits<double>::infinity();
        for (const Eigen::AlignedBox3d& box : boxes)
            expected = std::min(expected, box.exteriorDistance(place));
        QCOMPARE(nearest, expected);
    }
    QVERIFY2(count < 1000 || looked < 1000 * 50 / 5, "it should look at few of many");
}

QTEST_GUILESS_MAIN(BoxTreeTest)
#include "box_tree_test.moc"
