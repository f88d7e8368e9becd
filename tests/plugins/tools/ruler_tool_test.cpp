// SPDX-License-Identifier: GPL-3.0-or-later
// The ruler against arithmetic: what it measures, keeps and shows.
#include "plugins/tools/ruler/ruler_tool.h"

#include "tests/plugins/tools/tool_fixture.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace tetra;
using namespace tetra::testing;

namespace {

using Vector = Eigen::Vector3d;

const RulerTool tool{};

ToolFixture withUnit(const std::string& unit)
{
    ToolFixture fixture{tool, "ruler"};
    fixture.model.lengthUnit = unit;
    return fixture;
}

std::vector<std::string> textsOf(const ToolFixture& fixture)
{
    std::vector<std::string> texts;
    for (const ToolText& text : fixture.drawing().texts)
        texts.push_back(text.text.text());
    return texts;
}

} // namespace

class RulerToolTest : public QObject {
    Q_OBJECT

private slots:
    /// 3, 4, 12: 13; with a right angle, and 5, 12: 13.
    void twoClicksMeasureADistanceAThirdAnAngle()
    {
        ToolFixture ruler = withUnit("mm");
        ruler.click(seenAt({1, 1, 1}));
        QVERIFY(textsOf(ruler).empty());
        QVERIFY(ruler.readings().empty());
        ruler.click(seenAt({4, 5, 13}));
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"13 mm"}));
        QCOMPARE(ruler.readings().front().label.text(), std::string("Ruler 1"));
        QCOMPARE(ruler.readings().front().text.text(), std::string("13 mm"));
        QVERIFY(ruler.drawing().texts.front().place == Vector(2.5, 3, 7));
        ruler.click(seenAt(Vector(4, 5, 13) + Vector(4, -3, 0) * 2)); // across the first
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"13 mm", "10 mm", "90°"}));
        QVERIFY(ruler.drawing().texts.back().place == Vector(4, 5, 13));
        QCOMPARE(ruler.readings().front().text.text(), std::string("13 mm and 10 mm, 90° between them"));
        ruler.click(seenAt({0, 0, 0})); // a fourth begins another
        QCOMPARE(rulersFromText(ruler.value()).all.size(), std::size_t(2));
        QCOMPARE(ruler.names, (std::vector<std::string>{"Measure Distance", "Measure Distance", "Measure Angle",
                                                        "Measure Distance"}));
    }

    void withoutAUnitItSaysWhoseTheUnitsAre()
    {
        ToolFixture ruler = withUnit("");
        ruler.click(seenAt({0, 0, 0}));
        ruler.click(seenAt({0.125, 0, 0}));
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"0.125 units of the file"}));
    }

    void numbersAreThoseOfTheUsersLanguage()
    {
        ToolFixture ruler = withUnit("mm");
        ruler.numbers = [](double number, int digits) {
            return "<" + formatNumber(number) + " in " + std::to_string(digits) + ">";
        };
        ruler.click(seenAt({0, 0, 0}));
        ruler.click(seenAt({0, 12.5, 0}));
        ruler.click(seenAt({1, 12.5, 0}));
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"<12.5 in 5> mm", "<1 in 5> mm", "<90 in 5>°"}));
    }

    /// Small angles and nearly straight ones, which the cosine cannot tell.
    void anglesAreRight_data()
    {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {1e-7, 0.01, 30.0, 60.0, 90.0, 135.0, 179.9999, 180.0})
            QTest::addRow("%g", degrees) << degrees;
    }
    void anglesAreRight()
    {
        QFETCH(double, degrees);
        const double angle = degrees * std::numbers::pi / 180;
        const Vector vertex(100, -20, 3);
        // In an oblique plane, with arms of different lengths.
        const Vector one = Vector(1, 2, 3).normalized(), other = one.cross(Vector(0, 1, 0)).normalized();
        const Ruler ruler{vertex + 2.5 * one, vertex, vertex + 0.7 * (std::cos(angle) * one + std::sin(angle) * other)};
        QVERIFY(std::abs(angleOf(ruler) - degrees) < 1e-9 * std::max(1.0, degrees) + 1e-12);
        QCOMPARE(angleOf({vertex, vertex, vertex}), 0.0);
    }

    /// The text comes back as the same numbers, whatever they are.
    void whatIsKeptComesBack()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> exponent(-300, 300), part(-1, 1);
        for (int round = 0; round < 200; ++round) {
            Rulers rulers;
            for (auto count = random() % 4; count > 0; --count) {
                Ruler ruler;
                for (auto places = 1 + random() % 3; places > 0; --places)
                    ruler.push_back(Vector(part(random), part(random), part(random)) * std::pow(10, exponent(random)));
                rulers.all.push_back(ruler);
            }
            rulers.complete = !rulers.all.empty() && random() % 2 == 0;
            QVERIFY2(rulersFromText(rulersToText(rulers)) == rulers, rulersToText(rulers).c_str());
        }
        QCOMPARE(rulersToText({}), std::string());
    }

    void whatIsNoRulerIsPassedOver_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("left");
        QTest::newRow("nothing") << ""
                                 << "";
        QTest::newRow("words") << "hello"
                               << "";
        QTest::newRow("two coordinates") << "1,2"
                                         << "";
        QTest::newRow("four coordinates") << "1,2,3,4"
                                          << "";
        QTest::newRow("four places") << "1,2,3 4,5,6 7,8,9 1,1,1"
                                     << "";
        QTest::newRow("endless") << "1,2,inf 4,5,6"
                                 << "";
        QTest::newRow("one of two") << "1,2,x;4,5,6  7,8,9"
                                    << "4,5,6 7,8,9";
        QTest::newRow("blanks") << " 1,2,3 ; ;"
                                << "1,2,3;";
    }
    void whatIsNoRulerIsPassedOver()
    {
        QFETCH(QString, text);
        QFETCH(QString, left);
        QCOMPARE(QString::fromStdString(rulersToText(rulersFromText(text.toStdString()))), left);
    }

    void handlesMovePlacesToWhatIsSeenOrInThePlaneOfThePicture()
    {
        ToolFixture ruler = withUnit("mm");
        ruler.click(seenAt({0, 0, 0}));
        ruler.click(seenAt({1, 0, 0}));
        const ToolDrawing drawing = ruler.drawing();
        QCOMPARE(drawing.handles.size(), std::size_t(2));
        QVERIFY(drawing.handles[1].seeks && !drawing.handles[1].name.empty());
        HandleMove move{.handle = drawing.handles[1].id, .from = {1, 0, 0}, .to = {2, 0, 0}};
        ruler.move(move);
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"2 mm"}));
        move.pointer = seenAt({0, 0, 7});
        ruler.move(move);
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"7 mm"}));
        QCOMPARE(ruler.names.back(), std::string("Move Ruler"));
        const std::string before = ruler.value();
        for (const char* handle : {"", "7.0", "0.2", "x.y"}) {
            move.handle = handle;
            ruler.move(move);
            QCOMPARE(ruler.value(), before);
        }
    }

    void aClickAtTheSamePlaceTwiceMeasuresNothing()
    {
        ToolFixture ruler = withUnit("mm");
        ruler.click(seenAt({1, 2, 3}));
        ruler.click(seenAt({1, 2, 3}));
        QCOMPARE(rulersFromText(ruler.value()).all.front().size(), std::size_t(1));
        QCOMPARE(ruler.names.size(), std::size_t(1));
    }

    void commandsBeginAndRemoveRulers()
    {
        ToolFixture ruler = withUnit("m");
        for (const char* command : {"new", "remove", "clear"})
            QVERIFY2(!ruler.isEnabled(command), command);
        ruler.command("remove");
        QCOMPARE(ruler.value(), std::string());
        for (const double x : {0.0, 1.0})
            ruler.click(seenAt({x, 0, 0}));
        QVERIFY(ruler.isEnabled("new"));
        ruler.command("new");
        QVERIFY(!ruler.isEnabled("new"));
        for (const double x : {0.0, 2.0})
            ruler.click(seenAt({x, 0, 0}));
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"1 m", "2 m"}));
        ruler.handle = "0.1";
        ruler.command("remove"); // the selected one
        QCOMPARE(textsOf(ruler), (std::vector<std::string>{"2 m"}));
        QVERIFY(ruler.handle.empty());
        QVERIFY(ruler.isEnabled("new")); // the other one still takes a third place
        ruler.command("remove");         // the last one
        QCOMPARE(ruler.value(), std::string());
        ruler.click(seenAt({0, 0, 0}));
        ruler.command("clear");
        QCOMPARE(ruler.value(), std::string());
    }
};

QTEST_GUILESS_MAIN(RulerToolTest)
#include "ruler_tool_test.moc"
