// SPDX-License-Identifier: GPL-3.0-or-later
// Which values of a histogram are the background.
#include <tan/transfer.h>

#include <QTest>

using namespace tetra;

namespace {

constexpr std::size_t parts = 200;

/// All alike but for these.
ValueHistogram histogram(const std::vector<std::pair<std::size_t, std::uint64_t>>& others)
{
    ValueHistogram result{-10, 190, std::vector<std::uint64_t>(parts, 10)}; // a part for each unit
    for (const auto& [part, count] : others)
        result.counts[part] = count;
    return result;
}

} // namespace

class BackgroundValuesTest : public QObject {
    Q_OBJECT

private slots:
    void oneValueAtAnEndOrBetween_data()
    {
        QTest::addColumn<int>("part");
        QTest::addColumn<double>("commonest");
        QTest::newRow("least") << 0 << -10.0;
        QTest::newRow("between") << 70 << 60.5;
        QTest::newRow("largest") << 199 << 190.0;
    }
    void oneValueAtAnEndOrBetween()
    {
        QFETCH(int, part);
        QFETCH(double, commonest);
        const auto background = backgroundValues(histogram({{static_cast<std::size_t>(part), 5000}}));
        QVERIFY(background.has_value());
        QCOMPARE(background->least, -10.0 + part);
        QCOMPARE(background->commonest, commonest);
        QCOMPARE(background->largest, -9.0 + part);
    }

    /// To both sides, as far as each value has a tenth of the commonest's share.
    void noiseBelongsToIt()
    {
        const auto background =
            backgroundValues(histogram({{40, 499}, {41, 600}, {42, 5000}, {43, 3000}, {44, 501}, {45, 499}}));
        QVERIFY(background.has_value());
        QCOMPARE(background->least, 31.0);
        QCOMPARE(background->commonest, 32.5);
        QCOMPARE(background->largest, 35.0);
    }

    void itIsAnEighthOfTheRangeAtMost()
    {
        std::vector<std::pair<std::size_t, std::uint64_t>> broad;
        for (std::size_t part = 100; part < 150; ++part)
            broad.emplace_back(part, part == 120 ? 4000 : 2000);
        const auto background = backgroundValues(histogram(broad));
        QVERIFY(background.has_value());
        QCOMPARE(background->largest - background->least, 25.0);
        QVERIFY(background->least < 110.5 && background->largest > 110.5);
    }

    void whereNothingIsMuchMoreFrequentThereIsNone()
    {
        QVERIFY(!backgroundValues(histogram({})));
        QVERIFY(!backgroundValues(histogram({{70, 20}})));
        QVERIFY(!backgroundValues({0, 1, {}}));
        QVERIFY(!backgroundValues({0, 1, {0, 0, 0}}));
        QVERIFY(!backgroundValues({3, 3, {0, 9, 0}}));
    }
};

QTEST_APPLESS_MAIN(BackgroundValuesTest)
#include "background_values_test.moc"
