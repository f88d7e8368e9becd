// SPDX-License-Identifier: GPL-3.0-or-later
/// R6: what counts, where and how much, and its text.

#include "plugins/samples/samples.h"

#include <tan/data.h>

#include <QTest>

#include <random>

using namespace tetra;

namespace {

QString mistakeIn(const char* text)
{
    const auto weighting = parseWeighting(text);
    return weighting ? QString() : QString::fromStdString(weighting.error().text());
}

} // namespace

class WeightingTest : public QObject {
    Q_OBJECT

private slots:
    void weightsFallFromOneToTheFloor_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("weight");
        QTest::newRow("no terms") << "" << 5.0 << 1.0 << 1.0;
        QTest::newRow("at the point") << "point:5,0,0,10" << 5.0 << 1.0 << 1.0;
        QTest::newRow("half way") << "point:5,0,0,10,0.5" << 10.0 << 1.0 << 0.75;
        QTest::newRow("at the reach") << "point:5,0,0,10" << 15.0 << 1.0 << 0.1;
        QTest::newRow("far away") << "point:5,0,0,10" << 1e9 << 1.0 << 0.1;
        QTest::newRow("in the box") << "box:-5,-1,-1,5,1,1,2" << 4.0 << 1.0 << 1.0;
        QTest::newRow("on the box") << "box:-5,-1,-1,5,1,1,2" << 5.0 << 1.0 << 1.0;
        QTest::newRow("beside the box") << "box:-5,-1,-1,5,1,1,2,0.5" << -6.0 << 1.0 << 0.75;
        QTest::newRow("sharp box, inside") << "box:-5,-1,-1,5,1,1,0" << 5.0 << 1.0 << 1.0;
        QTest::newRow("sharp box, outside") << "box:-5,-1,-1,5,1,1,0,0.25" << 5.01 << 1.0 << 0.25;
        QTest::newRow("the value") << "value:7,2" << 0.0 << 7.0 << 1.0;
        QTest::newRow("near the value") << "value:7,2,0.5" << 0.0 << 6.0 << 0.75;
        QTest::newRow("the largest term holds") << "value:7,2,0.5; point:0,0,0,1" << 0.0 << 50.0 << 1.0;
        QTest::newRow("not a smaller one") << "point:9,0,0,1;value:7,2,0.5" << 0.0 << 50.0 << 0.5;
    }
    void weightsFallFromOneToTheFloor()
    {
        QFETCH(QString, text);
        QFETCH(double, x);
        QFETCH(double, value);
        QFETCH(double, weight);
        const auto weighting = parseWeighting(text.toStdString());
        QVERIFY2(weighting.ok(), qPrintable(mistakeIn(qPrintable(text))));
        QVERIFY(std::abs(weighting->weight({x, 0, 0}, value) - weight) < 1e-15);
    }

    void textComesBack()
    {
        const auto weighting = parseWeighting(" value: 120 , 15 ;point:1,2.5,-3e-2,4; box:0,0,0,1,1,1,0,.2 ");
        QVERIFY(weighting.ok());
        const std::string text = weightingText(*weighting);
        QCOMPARE(text, std::string("point:1,2.5,-0.03,4,0.1;box:0,0,0,1,1,1,0,0.2;value:120,15,0.1"));
        QCOMPARE(weightingText(parseWeighting(text).value()), text);
        QCOMPARE(weightingText(parseWeighting(" ").value()), std::string());
        // A sharp box of one point stays a box: points need a reach.
        const std::string sharp = "box:1,2,3,1,2,3,0,0.5";
        QCOMPARE(weightingText(parseWeighting(sharp).value()), sharp);
        // The logarithm of a value of the data, where values are logarithms.
        QCOMPARE(weightingText(parseWeighting("value:log10(1e-3),2").value()), std::string("value:-3,2,0.1"));
    }

    void badTextsAreRefusedWithTheReason_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        QTest::newRow("unknown") << "sphere:1,2,3,4"
                                 << "begins with 'point:'";
        QTest::newRow("no colon") << "point"
                                  << "begins with 'point:'";
        QTest::newRow("empty term") << "point:1,2,3,4;"
                                    << "begins with 'point:'";
        QTest::newRow("too few") << "point:1,2,3"
                                 << "it has 3 numbers, and the form is point:x,y,z,reach[,floor]";
        QTest::newRow("too many") << "value:1,2,0.3,4"
                                  << "it has 4 numbers";
        QTest::newRow("no number") << "point:1,b,3,4"
                                   << "'b' is not a number";
        QTest::newRow("empty number") << "point:1,,3,4"
                                      << "'' is not a number";
        QTest::newRow("infinite") << "point:1,inf,3,4"
                                  << "'inf' is not a number";
        QTest::newRow("logarithm of zero") << "value:log10(0),2"
                                           << "'log10(0)' is not a number";
        QTest::newRow("logarithm of a length") << "value:1,log10(2)"
                                               << "'log10(2)' is not a number";
        QTest::newRow("decimal comma") << "value:1,5,2,0,3"
                                       << "it has 5 numbers";
        QTest::newRow("no reach") << "value:1,0"
                                  << "its reach is 0 and must be above 0";
        QTest::newRow("negative reach") << "box:0,0,0,1,1,1,-2"
                                        << "its reach is -2 and must be at least 0";
        QTest::newRow("floor of 0") << "value:1,1,0"
                                    << "its floor is 0 and must be from 1e-06 to 1";
        QTest::newRow("floor above 1") << "value:1,1,1.5"
                                       << "its floor is 1.5";
        QTest::newRow("box upside down") << "box:0,5,0,1,1,1,1"
                                         << "first corner";
    }
    void badTextsAreRefusedWithTheReason()
    {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        const auto weighting = parseWeighting(text.toStdString());
        QVERIFY(!weighting.ok());
        QCOMPARE(weighting.error().kind, ErrorKind::WrongUsage);
        QVERIFY2(mistakeIn(qPrintable(text)).contains(reason), qPrintable(mistakeIn(qPrintable(text))));
    }

    /// Whatever is written, it is read or refused, and what is read comes back.
    void mutatedTextsAreReadOrRefused()
    {
        const std::string characters = "point:box:value:0123456789.,;-e+ \xff";
        std::mt19937 random(1);
        int read = 0;
        for (int attempt = 0; attempt < 20000; ++attempt) {
            std::string text = "point:1,2,3,4;value:5,6,.7;box:1,2,3,4,5,6,7";
            for (std::uint32_t change = random() % 3; change > 0; --change)
                text[random() % text.size()] = characters[random() % characters.size()];
            const auto weighting = parseWeighting(text);
            if (!weighting)
                continue;
            ++read;
            const std::string canonical = weightingText(*weighting);
            QCOMPARE(weightingText(parseWeighting(canonical).value()), canonical);
            const double weight = weighting->weight({1, 1, 1}, 3);
            QVERIFY(weight > 0 && weight <= 1);
        }
        QVERIFY(read > 5000);
    }

    void everyPointGetsItsWeight()
    {
        Dataset dataset = makeSample({"noise", 9, {}, 1}).value();
        dataset.lattice.spacing = {1, 2, 3};
        dataset.lattice.origin = {-4, 0, 7};
        QVERIFY(pointWeights({}, dataset)->empty());
        const Weighting weighting = parseWeighting("point:0,8,19,6;value:200,30,0.01").value();
        const auto weights = pointWeights(weighting, dataset);
        QVERIFY(weights.ok());
        QCOMPARE(weights->size(), std::size_t(9 * 9 * 9));
        for (std::uint64_t point = 0; point < weights->size(); ++point)
            QCOMPARE((*weights)[point],
                     static_cast<float>(weighting.weight(dataset.position(point), dataset.values.at(point))));
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled = pointWeights(weighting, dataset, Progress(stop.get_token(), {}));
        QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(WeightingTest)
#include "weighting_test.moc"
