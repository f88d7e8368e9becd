// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON text of a transfer function (R18): the same bits back, and errors that say where.
#include "core/base/json_writer.h"

#include <tan/transfer.h>

#include <QTest>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace tetra;

namespace {

const QByteArray start = "{\"format\": \"tan-transfer-function\", \"version\": 1,\n";

} // namespace

class TransferTextTest : public QObject {
    Q_OBJECT

private slots:
    void comesBackToTheBit()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<float> unit(0, 1);
        for (int round = 0; round < 100; ++round) {
            TransferFunction function;
            function.unitDistance = std::ldexp(1 + double(random() % 1000000007) / 1e9, int(random() % 400) - 200);
            double value = -std::ldexp(1 + unit(random), int(random() % 40) - 20);
            for (auto i = random() % 12; i > 0; --i, value += unit(random) / 3)
                function.colours.push_back({value, {unit(random), unit(random), unit(random)}});
            for (auto i = random() % 12; i > 0; --i, value += unit(random) / 3)
                function.opacities.push_back({value, unit(random)});
            const auto back = transferFunctionFromText(transferFunctionToText(function));
            QVERIFY2(back.ok(), back.ok() ? "" : back.error().text().c_str());
            QVERIFY(*back == function);
        }
    }

    void stepsComeBack()
    {
        const TransferFunction function = transferFunctionFromPoints({{1, {0, 0, 0}, 0}, {1, {1, 1, 1}, 1}}, 1);
        QVERIFY(transferFunctionFromText(transferFunctionToText(function)).value() == function);
    }

    void theFirstVersionHadPointsOfBothCurves()
    {
        const auto function =
            transferFunctionFromText((start + "\"unitDistance\": 3, \"mask\": {\"least\": 1, \"largest\": 2},"
                                              "\"points\": [{\"value\": 1, \"colour\": [0, 0.5, 1], \"opacity\": 0.25},"
                                              "{\"value\": 2, \"colour\": [1, 1, 1], \"opacity\": 1, \"group\": 4}]}")
                                         .toStdString());
        QVERIFY2(function.ok(), function.ok() ? "" : function.error().text().c_str());
        TransferFunction expected = transferFunctionFromPoints({{1, {0, 0.5f, 1}, 0.25f}, {2, {1, 1, 1}, 1, 4}}, 3);
        expected.mask = {1, 2};
        QCOMPARE(*function, expected);
    }

    void unitDistanceMayBeLeftOut()
    {
        const auto function = transferFunctionFromText((start + "\"points\": []}").toStdString());
        QVERIFY(function.ok());
        QVERIFY(*function == TransferFunction());
    }

    void errorsSayWhere_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("part");
        const QByteArray point = "{\"value\": 1, \"colour\": [0, 0, 1], \"opacity\": ";
        const auto row = [](const char* name, const QByteArray& text, const QByteArray& part) {
            QTest::newRow(name) << text << part;
        };
        row("empty", "", "line 1, column 1");
        row("no JSON", "<xml/>", "line 1, column 1");
        row("cut short", start + "\"points\": [", "line 2, column 12");
        row("trailing comma", start + "\"points\": [],}", "line 2, column 14");
        row("after the end", start + "\"points\": []}\n!", "line 3, column 1");
        row("twice", start + "\"points\": [], \"points\": []}", "twice");
        row("other format", "{\"format\": \"x\", \"version\": 1, \"points\": []}", "\"format\" is not");
        const QByteArray second = "{\"format\": \"tan-transfer-function\", \"version\": 2,\n";
        row("points in the second version", second + "\"points\": []}", "no \"colours\"");
        row("no opacities", second + "\"colours\": []}", "no \"opacities\"");
        row("a colour with an opacity", second + "\"opacities\": [], \"colours\": [" + point + "0}]}", "\"opacity\"");
        row("an opacity without", second + "\"colours\": [], \"opacities\": [{\"value\": 1}]}", "no \"opacity\"");
        row("colours are no list", second + "\"colours\": 3, \"opacities\": []}", "line 2, column 12");
        row("no list at all", "[]", "in braces");
        row("other version", "{\"format\": \"tan-transfer-function\", \"version\": 3, \"points\": []}",
            "line 1, column 48");
        row("no points", start + "\"unitDistance\": 1}", "no \"points\"");
        row("points are no list", start + "\"points\": {}}", "line 2, column 11");
        row("unknown member", start + "\"colours\": 1, \"points\": []}", "\"colours\"");
        row("opacity is a string", start + "\"points\": [" + point + "\"1\"}]}", "line 2, column 57");
        row("number too large", start + "\"points\": [" + point + "1e999}]}", "a number within range");
        row("opacity out of range", start + "\"points\": [" + point + "1.5}]}",
            "Opacity 1 of the transfer function is outside 0 to 1");
        row("two channels", start + "\"points\": [{\"value\": 1, \"colour\": [0, 0], \"opacity\": 0}]}",
            "three numbers");
        row("not in order", start + "\"points\": [" + point + "0}, " + QByteArray(point).replace("1,", "0,") + "0}]}",
            "ascending");
        row("an unknown member that controls terminals", start + "\"\\u001b[2J\": 1, \"points\": []}", "\"\\x1b[2J\"");
        row("twice, and long", start + "\"" + QByteArray(90, 'a') + "\": 1, \"" + QByteArray(90, 'a') + "\": 1}",
            "\"" + QByteArray(80, 'a') + "...\"");
        row("too deep", QByteArray(100000, '['), "levels");
    }

    void errorsSayWhere()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, part);
        const auto function = transferFunctionFromText(text.toStdString());
        QVERIFY(!function.ok());
        QVERIFY2(QByteArray::fromStdString(function.error().text()).contains(part), function.error().text().c_str());
    }

    void jsonStringsComeBack()
    {
        std::string text;
        for (int character = 1; character < 128; ++character)
            text.push_back(static_cast<char>(character));
        text += "\u00fc\u20ac\U0001f600";
        QCOMPARE(*parseJson(jsonString(text)).value().string(), text);
        QCOMPARE(*parseJson("\"\\u00fc\\u20AC\\ud83d\\ude00\\n\"").value().string(), "\u00fc\u20ac\U0001f600\n");
        for (const char* bad : {"\"\\ud83d\"", "\"\\ude00\"", "\"\\x\"", "\"\\u12g4\"", "\"abc", "01", "+1", ".5", "1.",
                                "1e", "nul", "[1 2]", "{1: 2}", "{\"a\" 1}", "\"a\nb\""})
            QVERIFY2(!parseJson(bad).ok(), bad);
        QVERIFY(std::get<bool>(parseJson(" true ").value().content));
        QVERIFY(!std::get<bool>(parseJson("false").value().content));
        QCOMPARE(parseJson("{\"a\": [-1.5e3, null]}").value().find("a")->array()->front().number()->text, "-1.5e3");
    }

    void anyDamageIsAnError()
    {
        std::mt19937 random(11);
        const TransferFunction function = transferFunctionFromPoints({{1, {0, .5f, 0}, 0}, {2, {1, 1, 1}, 1}}, 3);
        const std::string good = transferFunctionToText(function);
        for (int round = 0; round < 2000; ++round) {
            std::string text = good;
            text[random() % text.size()] = static_cast<char>(random() % 256);
            text.resize(text.size() - random() % 2 * (random() % text.size()));
            const auto read = transferFunctionFromText(text);
            QVERIFY(read.ok() ? checkTransferFunction(*read).ok() : !read.error().text().empty());
        }
    }
};

QTEST_GUILESS_MAIN(TransferTextTest)
#include "transfer_text_test.moc"
