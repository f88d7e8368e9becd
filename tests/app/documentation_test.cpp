// SPDX-License-Identifier: GPL-3.0-or-later
/// docs/user/command-line.md says the truth about `tan`, and `--help` gives examples that are accepted. Those of the
/// pages are run: tests/docs/run_commands.py.
#include "app/command_line/arguments.h"
#include "app/command_line/subcommand.h"

#include <tan/transfer.h>

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using namespace tetra;

namespace {

QString contentOf(const QString& name)
{
    QFile file(TAN_SOURCE_DIR "/" + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The lines "    tan ..." of a text, without their comments and what stands behind "&&".
std::vector<QStringList> examplesIn(const QString& text)
{
    static const QRegularExpression line("^ {2,}(?:\\S*/)?tan ([a-z].*)$", QRegularExpression::MultilineOption);
    static const QRegularExpression comment("\\s+(#\\s|&&).*$");
    std::vector<QStringList> examples;
    for (auto matches = line.globalMatch(text); matches.hasNext();)
        examples.push_back(matches.next().captured(1).remove(comment).split(' ', Qt::SkipEmptyParts));
    return examples;
}

} // namespace

class DocumentationTest : public QObject {
    Q_OBJECT

private:
    /// Why `example` is none, or nothing.
    QString mistakeIn(const QStringList& example)
    {
        const auto subcommand = std::ranges::find(subcommands(), example[0].toStdString(), &Subcommand::name);
        if (subcommand == subcommands().end())
            return "there is no such subcommand";
        Syntax syntax = subcommand->syntax(*host_);
        syntax.options.push_back({.name = "json", .placeholder = "", .explanation = ""});
        std::vector<std::string> words;
        for (const QString& word : example.mid(1))
            words.push_back(word.toStdString());
        const auto parsed = parseArguments(syntax, words);
        return parsed ? QString() : QString::fromStdString(parsed.error().text());
    }

    std::unique_ptr<PluginHost> host_;

private slots:
    void initTestCase() { host_ = PluginHost::standard(); }

    void examplesAreAccepted_data()
    {
        QTest::addColumn<QStringList>("example");
        for (const Subcommand& subcommand : subcommands())
            for (const Example& example : subcommand.syntax(*host_).examples)
                for (const QStringList& words : examplesIn("  " + QString::fromStdString(example.command)))
                    QTest::addRow("--help: %s", example.command.c_str()) << words;
    }
    void examplesAreAccepted()
    {
        QFETCH(QStringList, example);
        const QString mistake = mistakeIn(example);
        QVERIFY2(mistake.isEmpty(), qPrintable(mistake));
    }

    /// There is an example of each subcommand, and with a letter too many anywhere where names stand it is none.
    void mistakesAreFound()
    {
        for (const Subcommand& subcommand : subcommands()) {
            std::vector<QStringList> examples;
            for (const Example& example : subcommand.syntax(*host_).examples)
                for (const QStringList& words : examplesIn("  " + QString::fromStdString(example.command)))
                    examples.push_back(words);
            QVERIFY2(!examples.empty(), std::string(subcommand.name).c_str());
            for (const QStringList& example : examples) {
                QStringList other = example;
                other[0] += 'x';
                QVERIFY(!mistakeIn(other).isEmpty());
                QVERIFY2(!mistakeIn(example + QStringList{"--no-such-option"}).isEmpty(),
                         qPrintable(example.join(' ')));
                for (qsizetype i = 1; i < example.size(); ++i)
                    if (example[i].startsWith("--")) {
                        other = example;
                        other[i].insert(2, 'x');
                        QVERIFY2(!mistakeIn(other).isEmpty(), qPrintable(other.join(' ')));
                    }
            }
        }
    }

    /// What can be said to `tan render` stands in its chapter, each mode and each option.
    void theChapterOfRenderIsComplete()
    {
        const QString chapter =
            contentOf("docs/user/command-line.md").section("## tan render\n", 1).section("\n## ", 0, 0);
        const auto render = std::ranges::find(subcommands(), "render", &Subcommand::name);
        const auto syntax = render->syntax(*host_);
        QVERIFY(!syntax.options.empty());
        for (const Option& option : syntax.options) {
            const QString name = "--" + QString::fromStdString(option.name);
            const bool ofTheFocus = name.startsWith("--focus-") || name == "--falloff"; // explained with `tan extract`
            QVERIFY2(ofTheFocus || name == "--output" || chapter.contains(name), qPrintable(name));
        }
        QVERIFY(!host_->renderers().empty());
        for (const auto& renderer : host_->renderers())
            QVERIFY2(chapter.contains("`" + QString::fromStdString(renderer.id) + "`"), renderer.id.c_str());
    }

    /// The transfer functions that the documentation shows are some.
    void transferFunctionsOfTheDocumentationAreRead()
    {
        static const QRegularExpression indented("^    \\{\\n.*?^    \\}$",
                                                 QRegularExpression::MultilineOption |
                                                     QRegularExpression::DotMatchesEverythingOption);
        const QString chapter =
            contentOf("docs/user/formats.md").section("## Transfer functions\n", 1).section("\n## ", 0, 0);
        const QString shown = indented.match(chapter).captured();
        QVERIFY(!shown.isEmpty());
        for (const QString& text : {shown, contentOf("docs/user/pictures/bluntfin-transfer.json"),
                                    contentOf("docs/user/pictures/buckyball-transfer.json")}) {
            const auto function = transferFunctionFromText(text.toStdString());
            QVERIFY2(function.ok(), function.ok() ? "" : function.error().text().c_str());
            QVERIFY(transferPoints(*function).size() >= 3);
        }
    }

    void everySubcommandHasAChapterWithExamples()
    {
        const QString text = contentOf("docs/user/command-line.md");
        QVERIFY(!text.isEmpty());
        for (const Subcommand& subcommand : subcommands()) {
            const QString name = QString::fromStdString(std::string(subcommand.name));
            const QString chapter = text.section("## tan " + name + "\n", 1).section("\n## ", 0, 0);
            QVERIFY2(chapter.contains("    tan " + name), qPrintable(name));
            QVERIFY2(chapter.contains("JSON: `"), qPrintable(name));
        }
    }
};

QTEST_GUILESS_MAIN(DocumentationTest)
#include "documentation_test.moc"
