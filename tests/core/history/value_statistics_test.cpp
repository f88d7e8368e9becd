// SPDX-License-Identifier: GPL-3.0-or-later
// Mean and standard deviation of values (R19): what models keep of them, and what can be typed. Their numbers are
// judged by numpy (tests/app/deviations.py).
#include "core/history/value_statistics.h"

#include <tbb/global_control.h>

#include <QTest>

#include <cmath>

using namespace tetra;

class ValueStatisticsTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreTheSameWithAnyNumberOfThreads()
    {
        std::vector<float> values;
        for (int i = 0; i < 300'000; ++i)
            values.push_back(1e6F + static_cast<float>(std::sin(i * 0.37)));
        const ScalarField field = ScalarField::of(values);
        const ValueStatistics usual = statisticsOf(field);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        QCOMPARE(statisticsOf(field), usual);
        // Far from zero, where sums of squares would have nothing left: a sine in steps of 1/16. By numpy:
        QVERIFY2(std::abs(usual.deviation - 0.7085277796687482) < 1e-6, QByteArray::number(usual.deviation, 'g', 12));
    }

    void aModelKeepsThemOfMaps()
    {
        Dataset dataset;
        dataset.values = ScalarField::of(std::vector<float>{1, 2, 3, 6});
        for (const char* name : {"a.nrrd", "map", "a.mrc.nrrd", "mrc", ""}) {
            dataset.source.name = name;
            QVERIFY2(statisticsTexts(dataset).empty(), name);
        }
        for (const char* name : {"a.mrc", "A.MAP", "b.ccp4", "emd_1.map.gz", "a.map, region 0,0,0,1,1,1, stride 2"}) {
            dataset.source.name = name;
            const auto kept = keptStatistics(statisticsTexts(dataset));
            QVERIFY2(kept, name);
            QCOMPARE(*kept, (ValueStatistics{3, std::sqrt(3.5), ValueStatistics::Of::Samples}));
            QCOMPARE(kept->valueAt(2), 3 + 2 * std::sqrt(3.5));
            QVERIFY(std::abs(kept->deviationsAt(kept->valueAt(-1.25)) + 1.25) < 1e-12);
        }
    }

    void whatIsNoneIsNotKept()
    {
        using Texts = std::vector<std::pair<std::string, std::string>>;
        QVERIFY(!keptStatistics(Texts{}));
        QVERIFY(!keptStatistics(Texts{{"values.mean", "1"}}));
        for (const char* deviation : {"", "x", "0", "-1", "nan", "inf"})
            QVERIFY2(!keptStatistics(Texts{{"values.mean", "1"}, {"values.deviation", deviation}}), deviation);
        QVERIFY(keptStatistics(Texts{{"values.mean", "1"}, {"values.deviation", "1e-3"}}));
    }

    void deviationsAreTyped()
    {
        QCOMPARE(parseDeviations("2.5sd"), std::optional(2.5));
        QCOMPARE(parseDeviations("-1e-1sd"), std::optional(-0.1));
        for (const char* text : {"", "sd", "2.5", "2.5 sd ", "2.5sds", "nansd", "infsd", "2.5sd:gold", "2,5sd"})
            QVERIFY2(!parseDeviations(text), text);
    }
};

QTEST_GUILESS_MAIN(ValueStatisticsTest)
#include "value_statistics_test.moc"
