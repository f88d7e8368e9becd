// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/command_palette.h"

#include <QRandomGenerator>
#include <QTest>

using namespace tetra;

/// What is found by a few letters, and what comes first.
class FuzzyMatchTest : public QObject {
    Q_OBJECT
private slots:
    void lettersInOrderMatchAndOthersDoNot();
    void betterMatchesEarnMore();
    void caseAndAccentsDoNotMatter();
    void everySubsequenceIsFound();
};

void FuzzyMatchTest::lettersInOrderMatchAndOthersDoNot()
{
    QVERIFY(fuzzyMatch("", "anything"));
    QVERIFY(fuzzyMatch("svp", "Save Picture"));
    QVERIFY(fuzzyMatch("pic save", "Save Picture")); // words in any order
    QVERIFY(!fuzzyMatch("vsp", "Save Picture"));
    QVERIFY(!fuzzyMatch("savee", "Save"));
    QVERIFY(!fuzzyMatch("x", ""));
}

void FuzzyMatchTest::betterMatchesEarnMore()
{
    const auto better = [](const char* query, const char* first, const char* second) {
        return fuzzyMatch(query, first).value() > fuzzyMatch(query, second).value();
    };
    QVERIFY(better("save", "File: Save Session", "Shaded average"));
    QVERIFY(better("sp", "Save Picture", "Transparent"));
    QVERIFY(better("top", "View: Top", "Set origin to parent"));
}

void FuzzyMatchTest::caseAndAccentsDoNotMatter()
{
    QVERIFY(fuzzyMatch("OFFNEN", QString::fromUtf8("Öffnen…")));
    QVERIFY(fuzzyMatch(QString::fromUtf8("qualità"), "Qualita"));
}

void FuzzyMatchTest::everySubsequenceIsFound()
{
    QRandomGenerator random(5);
    for (int round = 0; round < 500; ++round) {
        QString text, query;
        for (int letter = 0; letter < 30; ++letter) {
            text.append(QChar('a' + random.bounded(6)));
            if (random.bounded(4) == 0)
                query.append(text.back());
        }
        QVERIFY2(fuzzyMatch(query, text), qPrintable(query + " in " + text));
        QVERIFY(!fuzzyMatch(query + "z", text));
    }
}

QTEST_GUILESS_MAIN(FuzzyMatchTest)
#include "fuzzy_match_test.moc"
