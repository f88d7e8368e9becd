// SPDX-License-Identifier: GPL-3.0-or-later
// What files, servers and plugins say is shown so that it can do nothing but be read.
#include "core/base/text.h"

#include <QTest>

#include <string>

using namespace tetra;

class VisibleTextTest : public QObject {
    Q_OBJECT

private slots:
    void isShown_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char* name, const QByteArray& text, const QByteArray& shown) {
            QTest::newRow(name) << text << shown;
        };
        row("nothing", "", "");
        row("plain text", "a 50 % 'b' \\n ~", "a 50 % 'b' \\n ~");
        row("other scripts", "Körper 体 مرحبا 🧊", "Körper 体 مرحبا 🧊");
        row("a joiner that Persian is written with", "\u0645\u06cc\u200c\u062e\u0648\u0627\u0647\u0645",
            "\u0645\u06cc\u200c\u062e\u0648\u0627\u0647\u0645");
        row("an escape sequence", "\x1b[31mred", "\\x1b[31mred");
        row("a clipboard sequence", "\x1b]52;c;ZXZpbA==\a", "\\x1b]52;c;ZXZpbA==\\x07");
        row("line ends and tabulators", "a\nb\r\nc\td", "a\\nb\\r\\nc\\td");
        row("a zero byte", QByteArray("a\0b", 3), "a\\x00b");
        row("delete", "a\x7f", "a\\x7f");
        row("a control sequence of one character (C1)", "\u009b31m", "\\u009b31m");
        row("another next line", "a\u0085b\u2028c\u2029d", "a\\u0085b\\u2028c\\u2029d");
        row("an override of direction", "gpj.\u202etxt", "gpj.\\u202etxt");
        row("isolates", "\u2066a\u2069", "\\u2066a\\u2069");
        row("marks of direction", "\u200ea\u200f\u061c", "\\u200ea\\u200f\\u061c");
        row("what has no width", "a\u200bb\u2060c\ufeffd\u00ade", "a\\u200bb\\u2060c\\ufeffd\\u00ade");
        row("tags", "a\U000e0041b", "a\\U000e0041b");
        row("bytes that are no UTF-8", "caf\xe9 \x9b\x33", "caf\\xe9 \\x9b3");
        row("half a character", "a\xe2\x80", "a\\xe2\\x80");
        row("a longer form than needed", "\xc0\x9b", "\\xc0\\x9b");
        row("half of a pair", "\xed\xa0\x80", "\\xed\\xa0\\x80");
    }

    void isShown()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        const std::string once = visibleText(text.toStdString());
        QCOMPARE(QByteArray::fromStdString(once), shown);
        QCOMPARE(QByteArray::fromStdString(visibleText(once)), shown);
        QCOMPARE(QByteArray::fromStdString(visibleLines(once)), shown);
        // Wherever it stands in a message.
        QCOMPARE(QByteArray::fromStdString(visibleText(Message(text.toStdString()))), shown);
        QCOMPARE(QByteArray::fromStdString(visibleText(Message::say("In\n'%1'.", text.toStdString()))),
                 "In\n'" + shown + "'.");
    }

    void linesStayLines() { QCOMPARE(visibleLines("a\n\x1b[2Jb\r\n"), std::string("a\n\\x1b[2Jb\\r\n")); }

    void ofALongTextAPieceIsShown()
    {
        QCOMPARE(printable(std::string(90, 'a')), std::string(80, 'a') + "...");
        QCOMPARE(printable(std::string(79, 'a') + "\u202e"), std::string(79, 'a') + "...");
        QCOMPARE(printable("\u202e\x1b"), std::string("\\u202e\\x1b"));
    }
};

QTEST_GUILESS_MAIN(VisibleTextTest)
#include "visible_text_test.moc"
