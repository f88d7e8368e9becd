// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/arguments.h"
#include "app/command_line/help.h"
#include "app/command_line/nearest.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/table.h"

#include <QTest>

using namespace tetra;

namespace {

using Words = std::vector<std::string>;

Syntax example()
{
    return {.purpose = "try",
            .explanation = "Tries.",
            .positionals = {{"IN", "What to try."}},
            .options =
                {{.name = "output", .placeholder = "FILE", .explanation = "Where to.", .letter = 'o', .required = true},
                 {.name = "error", .placeholder = "P", .explanation = "How well."},
                 {.name = "value", .placeholder = "V", .explanation = "Which.", .repeatable = true},
                 {.name = "quick", .placeholder = "", .explanation = "Hurry."}},
            .examples = {}};
}

std::string errorOf(const Words& words)
{
    const auto parsed = parseArguments(example(), words);
    return parsed ? "" : parsed.error().text();
}

Parameter number(const std::string& id, double byDefault, double least, double most)
{
    Parameter parameter;
    parameter.id = id;
    parameter.explanation = "A number.";
    parameter.defaultValue = byDefault;
    parameter.minimum = least;
    parameter.maximum = most;
    return parameter;
}

} // namespace

class ArgumentsTest : public QObject {
    Q_OBJECT

private slots:
    /// Whatever plugins are installed, the program's options mean what they meant.
    void pluginsTakeNoOptionFromTheProgram()
    {
        const std::vector<Parameter> parameters = {number("error", 1, 0, 9), number("depth", 2, 0, 9)};
        Syntax syntax = example();
        addPluginOptions(syntax, parameters);
        separatePluginOptions(syntax);
        const auto parsed =
            parseArguments(syntax, Words{"in", "-o", "out", "--error", "5", "--plugin-error", "3", "--depth", "4"});
        QVERIFY2(parsed, parsed ? "" : parsed.error().text().c_str());
        QCOMPARE(parsed->value("error").value(), std::string("5"));
        const auto values = pluginValues(*parsed, parameters);
        QVERIFY2(values, values ? "" : values.error().text().c_str());
        QCOMPARE(std::get<double>(values->at("error")), 3.0);
        QCOMPARE(std::get<double>(values->at("depth")), 4.0);

        const auto own = parseArguments(syntax, Words{"in", "-o", "out", "--error", "5"});
        QVERIFY(own);
        QVERIFY(pluginValues(*own, parameters)->empty());
        QVERIFY(checkPluginOptions(*own, parameters, {}, "mode 'x'"));
        const Status refused = checkPluginOptions(*parsed, parameters, {}, "mode 'x'");
        QCOMPARE(refused.error().text(), std::string("The mode 'x' has no option '--plugin-error'."));
    }

    void takesAllSpellings()
    {
        const auto parsed = parseArguments(
            example(), Words{"--error=2", "in.nrrd", "-o", "out", "--value", "-5", "--quick", "--value", "1e3"});
        QVERIFY2(parsed, parsed ? "" : parsed.error().text().c_str());
        QCOMPARE(parsed->positionals, Words{"in.nrrd"});
        QCOMPARE(parsed->value("error").value(), std::string("2"));
        QCOMPARE(parsed->value("output").value(), std::string("out"));
        QCOMPARE(parsed->values("value"), (Words{"-5", "1e3"}));
        QVERIFY(parsed->has("quick"));
    }

    void afterTwoDashesNothingIsAnOption()
    {
        const auto parsed = parseArguments(example(), Words{"-o", "out", "--", "--quick"});
        QVERIFY(parsed);
        QCOMPARE(parsed->positionals, Words{"--quick"});
        QVERIFY(!parsed->has("quick"));
    }

    void negativeNumbersAreNoOptions()
    {
        const auto parsed = parseArguments(example(), Words{"-o", "out", "-5"});
        QVERIFY(parsed);
        QCOMPARE(parsed->positionals, Words{"-5"});
    }

    void refusesInWords_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("part");
        QTest::newRow("misspelt") << QStringList{"in", "-o", "x", "--eror", "1"} << "'--error'";
        QTest::newRow("misspelt with =") << QStringList{"in", "-o", "x", "--qick=1"} << "'--quick'";
        QTest::newRow("unknown letter") << QStringList{"in", "-o", "x", "-z"} << "'-z'";
        QTest::newRow("missing word") << QStringList{"-o", "x"} << "IN is missing";
        QTest::newRow("missing option") << QStringList{"in"} << "--output";
        QTest::newRow("missing value at the end") << QStringList{"in", "-o"} << "needs a value: FILE";
        QTest::newRow("missing value before an option") << QStringList{"in", "-o", "--quick"} << "needs a value";
        QTest::newRow("a value too many") << QStringList{"in", "-o", "x", "--quick=yes"} << "takes no value";
        QTest::newRow("twice") << QStringList{"in", "-o", "x", "-o", "y"} << "twice";
        QTest::newRow("a word too many") << QStringList{"in", "more", "-o", "x"} << "'more'";
    }
    void refusesInWords()
    {
        QFETCH(QStringList, words);
        QFETCH(QString, part);
        Words given;
        for (const QString& word : words)
            given.push_back(word.toStdString());
        const QString error = QString::fromStdString(errorOf(given));
        QVERIFY2(error.contains(part), qPrintable(error));
    }

    void suggestsWhatIsNear()
    {
        const Words known = {"sample", "build", "info", "verify", "isosurface", "render", "plugins"};
        QCOMPARE(nearest("buidl", known).value(), std::string("build")); // one slip: two neighbours exchanged
        QCOMPARE(nearest("biuldd", known), std::nullopt);
        QCOMPARE(nearest("buil", known).value(), std::string("build"));
        QCOMPARE(nearest("isosurfcae", known).value(), std::string("isosurface"));
        QCOMPARE(nearest("plugin", known).value(), std::string("plugins"));
        QCOMPARE(nearest("xyzzy", known), std::nullopt);
        QCOMPARE(nearest("x", Words{}), std::nullopt);
    }

    void readsLevels()
    {
        Arguments arguments;
        arguments.options = {{"lod", "4,.5,1e-2,0"}};
        const auto levels = levelsOf(arguments);
        QVERIFY(levels);
        QCOMPARE(levels->size(), std::size_t(4));
        QCOMPARE(levels->at(1).error, 0.5);
        QCOMPARE(levels->at(2).error, 0.01);
        for (const char* wrong : {"", "1,,2", "1;2", "-1", "101", "nan", "inf", "1 ", "a"}) {
            arguments.options = {{"lod", wrong}};
            QVERIFY2(!levelsOf(arguments), wrong);
        }
    }

    void makesOptionsFromParameters()
    {
        Parameter on;
        on.id = "outline";
        on.explanation = "Shows the edges.";
        on.defaultValue = true;
        Parameter list;
        list.id = "isovalues";
        list.defaultValue = std::vector<Isovalue>{};
        const std::vector<Parameter> parameters = {number("error", 1, 0, 100), on, list};
        Syntax syntax;
        addPluginOptions(syntax, parameters);
        QCOMPARE(syntax.options.size(), std::size_t(3));
        const auto arguments =
            parseArguments(syntax, Words{"--no-outline", "--isovalue", "5:red", "--isovalue", "7::", "--error", "2"});
        QVERIFY(arguments);
        const auto wrong = pluginValues(*arguments, parameters); // "7::" has no colour
        QVERIFY(!wrong);
        QVERIFY2(wrong.error().text().starts_with("'--isovalue': "), wrong.error().text().c_str());
        QCOMPARE(syntax.options[1].explanation, std::string("Turns off what is done by default: shows the edges."));
        const auto good = parseArguments(syntax, Words{"--no-outline", "--isovalue", "5:red", "--isovalue=7"});
        const auto values = pluginValues(*good, parameters);
        QVERIFY(values);
        QCOMPARE(values->size(), std::size_t(2));
        QCOMPARE(std::get<bool>(values->at("outline")), false);
        QCOMPARE(std::get<std::vector<Isovalue>>(values->at("isovalues")).size(), std::size_t(2));
    }

    /// By the name that the user wrote, whatever is wrong.
    void mistakesNameTheOption()
    {
        Parameter text;
        text.id = "curve";
        text.defaultValue = std::string();
        text.mistake = [](const std::string&) { return Message("this is no curve."); };
        Parameter step;
        step.id = "time";
        step.defaultValue = std::int64_t(1);
        step.minimum = 1;
        step.maximum = 1e9;
        step.explanation = Message::marked("Files with several time steps: which one, from 1.");
        const std::vector<Parameter> parameters = {number("threshold", 1, 0, 100), text, step};
        Syntax syntax;
        addPluginOptions(syntax, parameters);
        const auto messageOf = [&](const Words& words) {
            const auto values = pluginValues(*parseArguments(syntax, words), parameters);
            return values ? std::string() : values.error().text();
        };
        QCOMPARE(messageOf({"--threshold", "many"}),
                 std::string("'many' does not fit '--threshold': it takes a number from 0 to 100. A number."));
        QCOMPARE(messageOf({"--curve", "x"}), std::string("'--curve': this is no curve."));
        QCOMPARE(messageOf({"--time", "0.5"}),
                 std::string("'0.5' does not fit '--time': it takes a whole number from 1 to 1000000000. Files with "
                             "several time steps: which one, from 1."));
    }

    void defaultsOfTheDataAreNoNumbers()
    {
        const std::vector<Parameter> parameters = {number("height", 0, 0, 0), number("steps", 5, 1, 9)};
        Syntax syntax;
        addPluginOptions(syntax, parameters);
        sayDefaultsFromData(syntax, parameters, {number("height", 3, 0, 0), number("steps", 5, 1, 9)});
        QCOMPARE(syntax.options[0].byDefault, std::string("from the data"));
        QCOMPARE(syntax.options[1].byDefault, std::string("5"));
    }

    void optionsOfOthersAreRefused()
    {
        Arguments arguments;
        arguments.options = {{"error", "1"}};
        const std::vector<Parameter> all = {number("error", 1, 0, 100)};
        QVERIFY(checkPluginOptions(arguments, all, all, "builder"));
        const Status refused = checkPluginOptions(arguments, all, {}, "builder 'other'");
        QVERIFY(!refused);
        QVERIFY(refused.error().text().find("builder 'other'") != std::string::npos);
    }

    void helpNamesEverything()
    {
        const QString text = QString::fromStdString(subcommandHelp("try", example()));
        for (const char* part :
             {"tan try", "IN", "What to try.", "-o, --output FILE", "--value V", "several times", "130"})
            QVERIFY2(text.contains(part), part);
        for (const QString& line : text.split('\n'))
            QVERIFY2(line.size() <= 110, qPrintable(line));
    }

    void tablesAlignToTheRight()
    {
        QCOMPARE(table({{"a", "long"}, {"123", "4"}}), std::string("    a  long\n  123     4\n"));
        QCOMPARE(rounded(0.1 + 0.2), std::string("0.3"));
        QCOMPARE(byteText(999), std::string("999 bytes"));
        QCOMPARE(byteText(1'500'000), std::string("1.5 MB"));
    }
};

QTEST_APPLESS_MAIN(ArgumentsTest)
#include "arguments_test.moc"
