// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_writer.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace tetra;

namespace {

/// A value, and what another library makes of the same.
struct Twins {
    JsonValue ours;
    QJsonValue theirs;
};

/// Values of all kinds, of a given depth at most.
class RandomValues {
public:
    explicit RandomValues(unsigned seed) : random_(seed) {}

    Twins value(int depth)
    {
        switch (random_() % (depth > 0 ? 8 : 6)) {
        case 0: return {nullptr, QJsonValue::Null};
        case 1: return {true, true};
        case 2: {
            const auto whole = static_cast<std::int64_t>(random_()) >> random_() % 64;
            return {whole, static_cast<qint64>(whole)};
        }
        case 3:
        case 4: {
            const double number = floating();
            return {number, number};
        }
        case 5: {
            const std::string text = string();
            return {text, QString::fromStdString(text)};
        }
        case 6: return array(depth - 1);
        default: return object(depth - 1);
        }
    }

    Twins array(int depth)
    {
        JsonArray ours;
        QJsonArray theirs;
        for (auto count = random_() % 5; count > 0; --count) {
            Twins element = value(depth);
            ours.push_back(std::move(element.ours));
            theirs.append(element.theirs);
        }
        return {std::move(ours), theirs};
    }

    Twins object(int depth)
    {
        JsonObject ours;
        QJsonObject theirs;
        for (auto count = random_() % 5; count > 0; --count) {
            const std::string name = string(false);
            Twins member = value(depth);
            ours[name] = std::move(member.ours);
            theirs[QString::fromStdString(name)] = member.theirs;
        }
        return {std::move(ours), theirs};
    }

    /// Any bits, or few digits with any exponent.
    double floating()
    {
        if (random_() % 2 == 0)
            return std::bit_cast<double>(random_());
        const auto digits = static_cast<double>(static_cast<std::int64_t>(random_()) >> random_() % 64);
        return digits * std::pow(10.0, static_cast<int>(random_() % 50) - 25);
    }

    /// Also with bytes that are no text, which names with an order cannot have.
    std::string string(bool mayBeBroken = true)
    {
        static const std::vector<std::string> pieces = {
            "a",      "B",      "\"",     "\\",   "/",      "\n", "\t",       "\x7f",    "",       " ",
            "\u00e4", "\u0416", "\u20ac", "\x01", "\r",     "0",  "\b",       "\u202e",  "\u00ad", "\U0001f600",
            "\f",     "\x1b",   "z",      "-",    "\u200d", "{}", "\xed\x9f", "\xff\xfe"};
        const std::size_t usable = pieces.size() - (mayBeBroken ? 0 : 2);
        std::string text;
        for (auto count = random_() % 6; count > 0; --count)
            text += pieces[random_() % usable];
        return text;
    }

private:
    std::mt19937_64 random_;
};

} // namespace

class JsonWriterTest : public QObject {
    Q_OBJECT

private slots:
    void textsAreThoseOfAnotherLibrary()
    {
        RandomValues values(7);
        for (int round = 0; round < 3000; ++round) {
            const Twins twins = round % 2 == 0 ? values.array(4) : values.object(4);
            const QJsonDocument theirs =
                twins.theirs.isArray() ? QJsonDocument(twins.theirs.toArray()) : QJsonDocument(twins.theirs.toObject());
            QCOMPARE(QByteArray::fromStdString(indentedJson(byName(twins.ours))),
                     theirs.toJson(QJsonDocument::Indented));
            QCOMPARE(QByteArray::fromStdString(compactJson(byName(twins.ours))), theirs.toJson(QJsonDocument::Compact));
        }
    }

    void numbersAreThoseOfAnotherLibrary()
    {
        RandomValues values(11);
        for (int round = 0; round < 100'000; ++round) {
            const double number = values.floating();
            QCOMPARE(QByteArray::fromStdString(compactJson(JsonArray{number})),
                     QJsonDocument(QJsonArray{number}).toJson(QJsonDocument::Compact));
        }
    }

    void numbers_data()
    {
        QTest::addColumn<double>("number");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* text, double number) { QTest::newRow(text) << number << text; };
        row("0", 0);
        row("-1", -1);
        row("100000", 1e5);
        row("9007199254740992", 9007199254740992);
        row("-9007199254740991", -9007199254740991);
        row("1e+16", 1e16);
        row("18014398509481984", 18014398509481984); // 2^54, 17 digits with an exponent are longer
        row("12345678901234567000", 12345678901234567000.0);
        row("0.1", .1);
        row("0.001", 1e-3);
        row("1e-04", 1e-4);
        row("1e-05", 1e-5);
        row("0.00015", 1.5e-4);
        row("1.25e-05", 1.25e-5);
        row("123.5", 123.5);
        row("-1234.0625", -1234.0625);
        row("5e-324", std::numeric_limits<double>::denorm_min());
        row("1.7976931348623157e+308", std::numeric_limits<double>::max());
        row("0.30000000000000004", .1 + .2);
        QTest::newRow("minus zero") << -0.0 << "0";
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << "null";
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << "null";
    }
    void numbers()
    {
        QFETCH(double, number);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(compactJson(number)), text);
    }

    void wholeNumbersKeepAllTheirDigits()
    {
        QCOMPARE(compactJson(JsonArray{std::numeric_limits<std::uint64_t>::max(),
                                       std::numeric_limits<std::int64_t>::min(), 1.0F, 0.1F}),
                 std::string("[18446744073709551615,-9223372036854775808,1,0.10000000149011612]"));
    }

    void objectsKeepTheOrderInWhichTheyAreMade()
    {
        JsonObject object{{"z", 1}, {"a", JsonObject{{"d", true}, {"c", nullptr}}}, {"z", 2}};
        object["m"] = "text";
        object["a"].object()->append("b", JsonArray{});
        QCOMPARE(compactJson(object), std::string(R"({"z":2,"a":{"d":true,"c":null,"b":[]},"m":"text"})"));
        QCOMPARE(compactJson(byName(object)), std::string(R"({"a":{"b":[],"c":null,"d":true},"m":"text","z":2})"));
        QVERIFY(object.contains("m") && !object.contains("c"));
        QCOMPARE(object.find("z")->numberAs<int>(), std::optional(2));
        QVERIFY(!object.find("m")->numberAs<int>() && !JsonValue(1.5).numberAs<int>());
    }

    void whatIsWrittenReadsBack()
    {
        RandomValues values(13);
        for (int round = 0; round < 300; ++round) {
            const std::string text = compactJson(values.object(4).ours);
            const auto read = parseJson(text);
            QVERIFY2(read, read ? "" : read.error().text().c_str());
            QCOMPARE(compactJson(*read), text);
            const std::string visible = visibleJson(indentedJson(*read));
            const auto again = parseJson(visible);
            QVERIFY2(again, again ? "" : again.error().text().c_str());
            QCOMPARE(compactJson(*again), text);
        }
    }

    void noTerminalObeysAVisibleText()
    {
        QCOMPARE(visibleJson("[\n\"\x7f\u009b\u202e\u200d\U000e0000\U000e0001\U0001d173\u0600\"]\n"), std::string(R"([
"\u007f\u009b\u202e\u200d\udb40\udc00\udb40\udc01\ud834\udd73\u0600"]
)"));
        const std::string seen = "{\n    \"\u00e4\u0416\u20ac\U0001f600\": \"\\n\"\n}\n";
        QCOMPARE(visibleJson(seen), seen);
    }

    /// Of every character of Unicode: by the categories of another library, whose edition may be another one.
    void everyCharacterOfControlOrFormatIsEscaped()
    {
        for (char32_t code = 0x80; code < 0x20000; ++code) {
            if (code >= 0xd800 && code < 0xe000)
                continue;
            const QChar::Category category = QChar::category(code);
            const bool isControl = category == QChar::Other_Control || category == QChar::Other_Format ||
                                   category == QChar::Separator_Line || category == QChar::Separator_Paragraph;
            const std::string text = QStringView(QChar::fromUcs4(code)).toUtf8().toStdString();
            QVERIFY2(!isControl || visibleJson(text) != text, QByteArray::number(static_cast<unsigned>(code), 16));
        }
    }
};

QTEST_APPLESS_MAIN(JsonWriterTest)
#include "json_writer_test.moc"
