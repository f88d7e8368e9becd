// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_writer.h"

#include <QJsonDocument>
#include <QTest>

#include <algorithm>
#include <ctime>
#include <limits>
#include <string>

using namespace tetra;

namespace {

/// The least of three, by the processor's time, which other programs do not change.
double secondsToParse(const std::string& text)
{
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 3; ++round) {
        const std::clock_t before = std::clock();
        if (!parseJson(text))
            return std::numeric_limits<double>::infinity();
        least = std::min(least, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
    return least;
}

/// A list of `objects` objects of `members` members each, of different names.
std::string objectsOf(int objects, int members)
{
    std::string text = "[";
    for (int object = 0; object < objects; ++object) {
        text += object == 0 ? "{" : ",{";
        for (int member = 0; member < members; ++member)
            text += (member == 0 ? "\"a" : ",\"a") + std::to_string(member) + "\":1";
        text += "}";
    }
    return text + "]";
}

} // namespace

/// What JSON texts of others may bring: any bytes, any size.
class JsonTest : public QObject {
    Q_OBJECT

private slots:
    void aLargeObjectTakesNoLongerThanManySmallOnes()
    {
        const double small = secondsToParse(objectsOf(10'000, 10)), large = secondsToParse(objectsOf(1, 100'000));
        QVERIFY2(large < 8 * small, qPrintable(QString("%1 s and %2 s").arg(large).arg(small)));
    }

    void whatIsWrittenIsUtf8_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("read");
        QTest::newRow("text") << QByteArray("k\xc3\xa4se \"1\"\n") << QByteArray("k\xc3\xa4se \"1\"\n");
        QTest::newRow("an old name") << QByteArray("non\xff.tan") << QByteArray("non\xef\xbf\xbd.tan");
        QTest::newRow("cut short") << QByteArray("ca\xc3") << QByteArray("ca\xef\xbf\xbd");
        QTest::newRow("all wrong") << QByteArray("\xff\xfe") << QByteArray("\xef\xbf\xbd\xef\xbf\xbd");
    }
    void whatIsWrittenIsUtf8()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, read);
        const auto value = parseJson(jsonString(bytes.toStdString()));
        QVERIFY2(value, value ? "" : value.error().text().c_str());
        QVERIFY(value->string() != nullptr);
        QCOMPARE(QByteArray::fromStdString(*value->string()), read);
    }

    void aMemberTwiceIsAnError_data()
    {
        QTest::addColumn<int>("members");
        for (const int members : {1, 15, 16, 17, 18, 1000})
            QTest::addRow("after %d", members) << members;
    }
    void aMemberTwiceIsAnError()
    {
        QFETCH(int, members);
        std::string text = objectsOf(1, members);
        QVERIFY(parseJson(text).ok());
        text.resize(text.size() - 2);
        for (const int again : {0, members - 1}) {
            const auto parsed = parseJson(text + ",\"a" + std::to_string(again) + "\":2}]");
            QVERIFY(!parsed.ok());
            const std::string says = "the member \"a" + std::to_string(again) + "\" appears twice (line 1, column " +
                                     std::to_string(text.size() + 4 + std::to_string(again).size() + 1) + ")";
            QVERIFY2(parsed.error().text().find(says) != std::string::npos, parsed.error().text().c_str());
        }
    }

    void membersKeepTheirOrder()
    {
        const auto parsed = parseJson("{\"b\": 1, \"a\": 2, \"\\u0062b\": 3}");
        QVERIFY(parsed.ok());
        QCOMPARE(parsed->object()->size(), std::size_t(3));
        QCOMPARE(parsed->object()->begin()->first, std::string("b"));
        QCOMPARE(parsed->find("bb")->number()->text, std::string("3"));
    }

    /// RFC 3629: no stray or missing bytes, no longer forms than needed, no halves of surrogate pairs, nothing above
    /// U+10FFFF.
    void onlyUtf8IsRead_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<bool>("right");
        const auto row = [](const char* name, const char* bytes, bool right) {
            QTest::newRow(name) << QByteArray(bytes) << right;
        };
        row("nothing", "", true);
        row("two bytes", "\xc3\xbc", true);
        row("the first of two bytes", "\xc2\x80", true);
        row("three bytes", "\xe2\x82\xac", true);
        row("the first of three bytes", "\xe0\xa0\x80", true);
        row("before the surrogates", "\xed\x9f\xbf", true);
        row("after the surrogates", "\xee\x80\x80", true);
        row("four bytes", "\xf0\x9f\x98\x80", true);
        row("the first of four bytes", "\xf0\x90\x80\x80", true);
        row("the last character", "\xf4\x8f\xbf\xbf", true);
        row("a byte of Latin 1", "M\xfcller", false);
        row("a byte alone", "\x80", false);
        row("the start alone", "\xc3", false);
        row("two of three", "\xe2\x82", false);
        row("three of four", "\xf0\x9f\x98", false);
        row("another in between", "\xe2\x82z", false);
        row("two starts", "\xc3\xc3\xbc", false);
        row("two bytes for one", "\xc1\xbf", false);
        row("three bytes for two", "\xe0\x9f\xbf", false);
        row("four bytes for three", "\xf0\x8f\xbf\xbf", false);
        row("the first surrogate", "\xed\xa0\x80", false);
        row("the last surrogate", "\xed\xbf\xbf", false);
        row("beyond the last character", "\xf4\x90\x80\x80", false);
        row("five bytes", "\xf8\x88\x80\x80\x80", false);
        row("no byte of any character", "\xff", false);
    }
    void onlyUtf8IsRead()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(bool, right);
        const std::string text = bytes.toStdString();
        const auto value = parseJson("\"" + text + "\"");
        QCOMPARE(value.ok(), right);
        if (right)
            QCOMPARE(*value->string(), text);
        QCOMPARE(parseJson("{\"" + text + "\": 1}").ok(), right);
    }

    void theErrorSaysWhereTheTextIsNotUtf8()
    {
        const auto parsed = parseJson("{\"name\":\n  \"M\xfcller\"}");
        QVERIFY(!parsed.ok());
        QCOMPARE(parsed.error().kind, ErrorKind::BadInput);
        QCOMPARE(parsed.error().text(),
                 std::string("Not valid JSON: a byte that is not valid UTF-8 (line 2, column 5)."));
    }
};

QTEST_APPLESS_MAIN(JsonTest)
#include "json_test.moc"
