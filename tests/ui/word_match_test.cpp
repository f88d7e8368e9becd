// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/word_match.h"

#include <QRandomGenerator>
#include <QTest>

using namespace tetra;

/// What is found by the beginnings of its words, and what comes first.
class WordMatchTest : public QObject {
    Q_OBJECT
private slots:
    void beginningsOfWordsMatchAndLettersWithinDoNot();
    void betterMatchesEarnMore();
    void caseAndAccentsDoNotMatter();
    void everyWordIsFoundByItsBeginning();
};

void WordMatchTest::beginningsOfWordsMatchAndLettersWithinDoNot()
{
    QVERIFY(wordMatch("", "anything"));
    QVERIFY(wordMatch("sav", "Save Picture"));
    QVERIFY(wordMatch("pic save", "Save Picture")); // words in any order
    QVERIFY(wordMatch("0.2 %", "Accuracy: 0.2 %"));
    QVERIFY(wordMatch("clip", "Rendering: Clip planes"));
    QVERIFY(!wordMatch("svp", "Save Picture"));
    QVERIFY(!wordMatch("ave", "Save Picture"));
    QVERIFY(!wordMatch("savee", "Save"));
    QVERIFY(!wordMatch("shad", "Change: Add a peak with shoulders and a dip"));
    QVERIFY(!wordMatch("clip", "Change: Duplicate points"));
    QVERIFY(!wordMatch("x", ""));
}

void WordMatchTest::betterMatchesEarnMore()
{
    const auto better = [](const char* query, const QString& first, const QString& second) {
        const auto earned = [&](const QString& text) {
            return wordMatch(query, text, text.lastIndexOf(": ") < 0 ? 0 : text.lastIndexOf(": ") + 2).value();
        };
        return earned(first) > earned(second);
    };
    QVERIFY(better("fit", "View: Fit", "View: Fitting of lines")); // whole words
    QVERIFY(better("view", "Panel: View", "View: Front"));         // what it is before what leads there
    QVERIFY(better("save", "File: Save Session", "File: Ask and save"));
    QVERIFY(better("accuracy 0 %", "Accuracy: 0 %", "Accuracy: 0.5 %"));
}

void WordMatchTest::caseAndAccentsDoNotMatter()
{
    QVERIFY(wordMatch("OFFNEN", QString::fromUtf8("Öffnen…")));
    QVERIFY(wordMatch(QString::fromUtf8("qualità"), "Qualita"));
}

void WordMatchTest::everyWordIsFoundByItsBeginning()
{
    QRandomGenerator random(5);
    for (int round = 0; round < 500; ++round) {
        QStringList words, query;
        for (int word = 0; word < 6; ++word) {
            QString& text = words.emplaceBack();
            for (int letter = 0; letter < 5; ++letter)
                text.append(QChar('a' + random.bounded(6)));
            if (random.bounded(2) == 0)
                query.prepend(text.left(1 + random.bounded(5)));
        }
        QVERIFY2(wordMatch(query.join(' '), words.join(' ')), qPrintable(query.join(' ') + " in " + words.join(' ')));
        QVERIFY(!wordMatch(query.join(' ') + " z", words.join(' ')));
    }
}

QTEST_GUILESS_MAIN(WordMatchTest)
#include "word_match_test.moc"
