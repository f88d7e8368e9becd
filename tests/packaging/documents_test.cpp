// SPDX-License-Identifier: GPL-3.0-or-later
/// The manual pages and the completions of the shells say what `tan --help` and `tan-desktop --help` say.
#include "app/documents/completions.h"
#include "app/documents/manual_page.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

using namespace tetra;

namespace {

QString outputOf(const QString& program, const QStringList& words)
{
    QProcess process;
    process.start(program, words);
    return process.waitForFinished() && process.exitStatus() == QProcess::NormalExit
               ? QString::fromUtf8(process.readAllStandardOutput())
               : QString();
}

QString tanHelp(const QString& subcommand = {})
{
    return outputOf(TAN_BINARY_DIR "/bin/tan",
                    subcommand.isEmpty() ? QStringList("--help") : QStringList{subcommand, "--help"});
}

QStringList captures(const QString& text, const char* pattern)
{
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    QStringList all;
    for (auto matches = expression.globalMatch(text); matches.hasNext();)
        all.append(matches.next().captured(1));
    return all;
}

/// The names below "Subcommands:".
QStringList subcommandsInHelp()
{
    return captures(tanHelp().section("Subcommands:\n", 1).section("\n\n", 0, 0), "^  ([a-z-]+) ");
}

/// "--output" and so on, as the lines of the options begin.
QStringList optionsInHelp(const QString& help)
{
    return captures(help.section("Options:\n", 1).section("\n\n", 0, 0), "^  (?:-\\w, )?(--[a-z-]+)");
}

QString contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString written(const char* name)
{
    return contentOf(QString(TAN_BINARY_DIR "/share/tan-documents/") + name);
}

} // namespace

class DocumentsTest : public QObject {
    Q_OBJECT

private slots:
    void theHelpIsUnderstood()
    {
        QVERIFY(subcommandsInHelp().contains("build"));
        QVERIFY(optionsInHelp(tanHelp("build")).contains("--stride"));
        QVERIFY(optionsInHelp(tanHelp("build")).contains("--output"));
    }

    void theManualPageHasEveryOption()
    {
        const QString page = written("tan.1").replace("\\-", "-");
        QVERIFY(!subcommandsInHelp().empty());
        for (const QString& subcommand : subcommandsInHelp()) {
            const QString chapter = page.section(".SS tan " + subcommand + "\n", 1).section("\n.SS", 0, 0);
            QVERIFY2(!chapter.isEmpty(), qPrintable(subcommand));
            for (const QString& option : optionsInHelp(tanHelp(subcommand)))
                QVERIFY2(chapter.contains("\\fB" + option + "\\fR"), qPrintable(subcommand + " " + option));
        }
    }

    void theManualPageOfTheWindowHasEveryOption()
    {
        const QString page = contentOf(TAN_SOURCE_DIR "/packaging/man/tan-desktop.1").replace("\\-", "-");
        const QStringList options = captures(outputOf(TAN_BINARY_DIR "/bin/tan-desktop", {"--help"}), "(--[a-z-]+)");
        QVERIFY(options.contains("--backend"));
        for (const QString& option : options)
            QVERIFY2(page.contains(option), qPrintable(option));
        for (const char* backend : {"auto", "cpu", "gl"})
            QVERIFY2(QRegularExpression(QString("\\b%1\\b").arg(backend)).match(page).hasMatch(), backend);
    }

    /// What bash offers behind `words`, of which the last one is being typed.
    QStringList offeredByBash(const QStringList& words)
    {
        const QString script = "source '" TAN_BINARY_DIR "/share/tan-documents/tan.bash'; COMP_WORDS=(\"$@\"); "
                               "COMP_CWORD=$(($# - 1)); _tan; printf '%s\\n' \"${COMPREPLY[@]}\"";
        return outputOf("bash", QStringList{"-c", script, "bash"} + words).split('\n', Qt::SkipEmptyParts);
    }

    void bashOffersWhatTheHelpHas()
    {
        QStringList names = subcommandsInHelp();
        QCOMPARE(offeredByBash({"tan", ""}), names + QStringList({"--help", "--version"}));
        QCOMPARE(offeredByBash({"tan", "re"}), QStringList({"render", "reproduce"}));
        for (const QString& subcommand : names)
            QCOMPARE(offeredByBash({"tan", subcommand, "--"}), optionsInHelp(tanHelp(subcommand)));
        QCOMPARE(offeredByBash({"tan", "render", "a.tan", "--backend", ""}), QStringList({"cpu", "gl"}));
        QCOMPARE(offeredByBash({"tan", "render", "a.tan", "-o", ""}), QStringList()); // files, by the shell itself
    }

    void fishOffersWhatTheHelpHas()
    {
        if (QStandardPaths::findExecutable("fish").isEmpty())
            QSKIP("skipped: no fish here");
        const auto offered = [](const QString& line) {
            const QString script = "complete -e -c tan; source '" TAN_BINARY_DIR
                                   "/share/tan-documents/tan.fish'; complete -C '" +
                                   line + "'";
            return captures(outputOf("fish", {"--no-config", "-c", script}), "^([^\\t\\n]+)");
        };
        for (const QString& subcommand : subcommandsInHelp()) {
            QStringList expected = optionsInHelp(tanHelp(subcommand));
            QStringList found = offered("tan " + subcommand + " --");
            expected.sort();
            found.sort();
            QCOMPARE(found, expected);
        }
        QCOMPARE(offered("tan render --backend "), QStringList({"cpu", "gl"}));
    }

    void zshKnowsEveryOption()
    {
        const QString text = written("_tan");
        for (const QString& subcommand : subcommandsInHelp()) {
            const QString part = text.section("\n    " + subcommand + ")\n", 1).section(";;", 0, 0);
            for (const QString& option : optionsInHelp(tanHelp(subcommand)))
                QVERIFY2(part.contains(option + "["), qPrintable(subcommand + " " + option));
        }
        if (QStandardPaths::findExecutable("zsh").isEmpty())
            QSKIP("skipped: no zsh here to read it");
        QCOMPARE(QProcess::execute("zsh", {"-n", TAN_BINARY_DIR "/share/tan-documents/_tan"}), 0);
    }

    void whatRoffAndShellsReadOtherwiseIsEscaped()
    {
        const Option option{
            .name = "odd-one", .placeholder = "a|b", .explanation = "It's [odd]: \\ really. More.", .letter = 'x'};
        const std::vector<DocumentedSubcommand> program = {{"go",
                                                            {.purpose = "go's",
                                                             .explanation = ".begins like a request",
                                                             .positionals = {},
                                                             .options = {option},
                                                             .examples = {}}}};
        const std::string page = manualPage(program);
        QVERIFY(page.find("\\&.begins like a request") != std::string::npos);
        QVERIFY(page.find("\\fB\\-x\\fR, \\fB\\-\\-odd\\-one\\fR") != std::string::npos);
        QVERIFY(page.find("It\\(aqs [odd]: \\e really. More.") != std::string::npos);
        QVERIFY(zshCompletion(program).find("[It'\\''s \\[odd\\]\\: \\\\ really]:choice:(a b)") != std::string::npos);
        QVERIFY(fishCompletion(program).find("-s x -l odd-one -x -a 'a b' -d 'It\\'s [odd]: \\\\ really'") !=
                std::string::npos);
        QVERIFY(choices({.name = "n", .placeholder = "N|none", .explanation = ""}).empty());
    }
};

QTEST_GUILESS_MAIN(DocumentsTest)
#include "documents_test.moc"
