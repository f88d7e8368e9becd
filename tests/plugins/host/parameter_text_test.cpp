// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parameter_text.h"

#include "plugins/host/colour_text.h"
#include "plugins/host/parameter_values.h"

#include <QTest>

using namespace tetra;

namespace {

Parameter described(ParameterValue byDefault, double least = 0, double most = 0)
{
    return {.id = "it",
            .label = "",
            .explanation = "",
            .unit = "%",
            .defaultValue = std::move(byDefault),
            .minimum = least,
            .maximum = most};
}

} // namespace

class ParameterTextTest : public QObject {
    Q_OBJECT

private slots:
    void valuesRoundTrip()
    {
        Isovalue isovalue{.value = -1.25, .red = 1, .green = 0.5f, .blue = 0, .opacity = 0.25f};
        isovalue.green = 128.0f / 255.0f;
        const std::vector<ParameterValue> values = {
            true,
            false,
            std::int64_t(-9'007'199'254'740'993),
            0.1,
            1e300,
            std::string("a text"),
            transferFunctionFromPoints({{0.1, {0, 0.5f, 1}, 0.25f}, {3, {}, 1}}, 2.5),
            std::vector{isovalue, isovalue},
            Colour{1, 0, 0.2f},
            Eigen::Vector3d(0.1, -2, 1e300),
            OwnValue{"example.band", R"({"low": 1})"}};
        for (const ParameterValue& value : values) {
            const auto read = parseParameter(described(value), parameterText(value));
            QVERIFY2(read, parameterText(value).c_str());
            QVERIFY2(*read == value, parameterText(value).c_str());
        }
    }

    /// An option exists under the name that the error calls it.
    void whatIsOfNoUseNamesOptionsThatExist()
    {
        Parameter surface{.id = "surface", .defaultValue = true};
        Parameter lines{.id = "lines", .defaultValue = false};
        Parameter kind{.id = "kind", .defaultValue = std::string("plain")};
        Parameter colour{.id = "colour", .defaultValue = 1.0, .onlyWith = {"surface", {true}}};
        Parameter width{.id = "width", .defaultValue = 1.0, .onlyWith = {"lines", {true}}};
        Parameter depth{.id = "depth", .defaultValue = 1.0, .onlyWith = {"kind", {std::string("deep")}}};
        const std::vector<Parameter> all = {surface, lines, kind, colour, width, depth};
        const OptionOfParameter option = [](const Parameter& parameter) {
            return parameter.id == "surface" ? "--no-surface" : "--" + parameter.id;
        };
        const auto textOf = [&](const ParameterValues& values) {
            const Status status = checkOfUse(all, values, option);
            return status ? std::string() : status.error().text();
        };
        QCOMPARE(textOf({{"colour", 2.0}, {"surface", false}}),
                 "'--colour' applies only without '--no-surface'. Leave one of them out.");
        QCOMPARE(textOf({{"width", 2.0}}), "'--width' applies only with '--lines'. Leave it out, or give both.");
        QCOMPARE(textOf({{"depth", 2.0}}), "'--depth' applies only if '--kind' is deep. Leave it out, or choose that.");
        QCOMPARE(textOf({{"colour", 2.0}}), std::string());
        QCOMPARE(checkOfUse(all, {{"width", 2.0}}).error().text(),
                 "'width' applies only if 'lines' is true. Leave it out, or choose that.");
    }

    /// What depends on a parameter that does not matter itself does not, either; in a circle nothing is followed twice.
    void whatMattersDependsOnWhatMatters()
    {
        const Parameter kind{.id = "kind", .defaultValue = std::string("plain")};
        const Parameter light{.id = "light", .defaultValue = true, .onlyWith = {"kind", {std::string("deep")}}};
        const Parameter shine{.id = "shine", .defaultValue = 1.0, .onlyWith = {"light", {true}}};
        const Parameter one{.id = "one", .defaultValue = true, .onlyWith = {"other", {true}}};
        const Parameter other{.id = "other", .defaultValue = true, .onlyWith = {"one", {true}}};
        const std::vector<Parameter> all = {kind, light, shine, one, other};
        QVERIFY(!matters(light, all, {}) && !matters(shine, all, {}));
        QVERIFY(!matters(shine, all, {{"light", true}}));
        QVERIFY(matters(shine, all, {{"kind", std::string("deep")}}));
        QVERIFY(!matters(shine, all, {{"kind", std::string("deep")}, {"light", false}}));
        QVERIFY(matters(one, all, {}) && !matters(one, all, {{"one", false}}));
    }

    void refusesWhatDoesNotFit_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"", "yes", "1", "True"})
            QTest::addRow("bool %s", text) << "bool" << QByteArray(text);
        for (const char* text : {"", "1.5", "11", "-1", "1e1", "9999999999999999999"})
            QTest::addRow("whole %s", text) << "whole" << QByteArray(text);
        for (const char* text : {"", "1,5", "10.01", "-0.1", "nan", "inf", "1e999", "1 ", "0x1"})
            QTest::addRow("number %s", text) << "number" << QByteArray(text);
        for (const char* text : {"", "three"})
            QTest::addRow("choice %s", text) << "choice" << QByteArray(text);
        for (const char* text : {"", "5:", "5:red:", "5:red:0", "5:red:1.1", "5:red:1:1", ":red", "5,,6", "11", "nan",
                                 "5:#12345", "5:#12345g", "5:red:nan"})
            QTest::addRow("isovalues %s", text) << "isovalues" << QByteArray(text);
        for (const char* text : {"", "red,", "#12", "1,0,0"})
            QTest::addRow("colour %s", text) << "colour" << QByteArray(text);
        for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,2,x", "1,2,nan", "1,2,11"})
            QTest::addRow("vector %s", text) << "vector" << QByteArray(text);
        QTest::newRow("a value that its plugin refuses") << "own" << QByteArray("refused");
    }
    void refusesWhatDoesNotFit()
    {
        QFETCH(QString, kind);
        QFETCH(QByteArray, text);
        Parameter choice = described(std::string("one"));
        choice.choices = {"one", "two"};
        Parameter own = described(OwnValue{"example.band", ""});
        own.mistake = [](const std::string& given) { return given == "refused" ? "It is no band." : ""; };
        const QHash<QString, Parameter> parameters = {{"bool", described(true)},
                                                      {"whole", described(std::int64_t(5), 0, 10)},
                                                      {"number", described(5.0, 0, 10)},
                                                      {"choice", choice},
                                                      {"isovalues", described(std::vector<Isovalue>{}, 0, 10)},
                                                      {"colour", described(Colour{})},
                                                      {"vector", described(Eigen::Vector3d(1, 2, 3), 0, 10)},
                                                      {"own", own}};
        const auto read = parseParameter(parameters[kind], text.toStdString());
        QVERIFY(!read);
        QCOMPARE(read.error().kind, ErrorKind::WrongUsage);
        QVERIFY(!read.error().text().empty());
    }

    void domainsAreSaidInWords()
    {
        QCOMPARE(parameterDomain(described(5.0, 0, 10)).text(), std::string("a number from 0 to 10, in %"));
        QCOMPARE(parameterDomain(described(true)).text(), std::string("true or false, in %"));
    }

    void typesHaveNames()
    {
        QCOMPARE(parameterTypeName(true), std::string("boolean"));
        QCOMPARE(parameterTypeName(std::int64_t(1)), std::string("integer"));
        QCOMPARE(parameterTypeName(1.0), std::string("number"));
        QCOMPARE(parameterTypeName(std::string()), std::string("text"));
        QCOMPARE(parameterTypeName(std::vector<Isovalue>()), std::string("isovalues"));
        QCOMPARE(parameterTypeName(TransferFunction()), std::string("transfer-function"));
        QCOMPARE(parameterTypeName(Colour()), std::string("colour"));
        QCOMPARE(parameterTypeName(Eigen::Vector3d(0, 0, 0)), std::string("vector"));
        QCOMPARE(parameterTypeName(OwnValue{"example.band", ""}), std::string("example.band"));
        QVERIFY(haveOneType(1.0, 2.0) && !haveOneType(1.0, true));
        QVERIFY(haveOneType(OwnValue{"a", "1"}, OwnValue{"a", "2"}));
        QVERIFY(!haveOneType(OwnValue{"a", "1"}, OwnValue{"b", "1"}));
    }

    /// Several without a colour are told apart; one that is given stays.
    void isovaluesHaveColoursOfTheirOwn()
    {
        const auto parsed = parseParameter(described(std::vector<Isovalue>{}), "1,2,3:#ff0000,4");
        QVERIFY(parsed);
        const auto& values = std::get<std::vector<Isovalue>>(*parsed);
        QCOMPARE(values.size(), std::size_t(4));
        QCOMPARE(values[0].blue, materials.front().colour.blue);
        QCOMPARE(values[1].blue, distinctColour(1).blue);
        QCOMPARE(values[2].red, 1.0f);
        QCOMPARE(values[2].blue, 0.0f);
        QCOMPARE(values[3].green, distinctColour(3).green);
    }

    void isovaluesKeepDefaults()
    {
        const auto plain = parseIsovalue("128");
        QVERIFY(plain);
        QVERIFY(*plain == Isovalue{.value = 128});
        const auto full = parseIsovalue("1e2:#f80:0.5");
        QVERIFY(full);
        QCOMPARE(full->value, 100.0);
        QCOMPARE(full->red, 1.0f);
        QCOMPARE(full->green, 136.0f / 255.0f);
        QCOMPARE(full->opacity, 0.5f);
    }

    void coloursRoundTrip()
    {
        for (const char* text : {"#000000", "#ffffff", "#123456", "#fedcba"})
            QCOMPARE(colourText(*parseColour(text)), std::string(text));
        QCOMPARE(colourText(*parseColour("#fa0")), std::string("#ffaa00"));
        QCOMPARE(colourText(*parseColour("white")), std::string("#ffffff"));
        for (const char* text : {"", "#", "#12", "#1234", "#12345z", "Red", "123456"})
            QVERIFY2(!parseColour(text), text);
    }

    void valuesAreCheckedAgainstTheirDescriptions()
    {
        const std::vector<Parameter> parameters = {described(5.0)};
        QVERIFY(checkParameterValues("builder 'x'", parameters, {}));
        QVERIFY(checkParameterValues("builder 'x'", parameters, {{"it", 3.0}}));
        QVERIFY(!checkParameterValues("builder 'x'", parameters, {{"it", true}}));
        const Status unknown = checkParameterValues("builder 'x'", parameters, {{"other", 3.0}});
        QVERIFY(!unknown);
        QVERIFY(unknown.error().text().find("Available: it.") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(ParameterTextTest)
#include "parameter_text_test.moc"
