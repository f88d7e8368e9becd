// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include "tests/lacks.h"

#include <QTest>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace tetra;

class NumberTextTest : public QObject {
    Q_OBJECT

private slots:
    void parses_data();
    void parses();
    void refusesWholeNumbersThatDoNotFit();
    void knowsTheLocaleNot();
    void roundTripsAnyDouble();
};

void NumberTextTest::parses_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("valid");
    QTest::addColumn<double>("value");
    QTest::newRow("whole") << QByteArray("12") << true << 12.0;
    QTest::newRow("fraction") << QByteArray("1.5") << true << 1.5;
    QTest::newRow("exponent") << QByteArray("-2.5e-3") << true << -0.0025;
    QTest::newRow("plus") << QByteArray("+3") << true << 3.0;
    QTest::newRow("point first") << QByteArray(".5") << true << 0.5;
    QTest::newRow("empty") << QByteArray("") << false << 0.0;
    QTest::newRow("plus alone") << QByteArray("+") << false << 0.0;
    QTest::newRow("two signs") << QByteArray("+-1") << false << 0.0;
    QTest::newRow("comma") << QByteArray("1,5") << false << 0.0;
    QTest::newRow("blank before") << QByteArray(" 1") << false << 0.0;
    QTest::newRow("blank after") << QByteArray("1 ") << false << 0.0;
    QTest::newRow("unit") << QByteArray("1mm") << false << 0.0;
    QTest::newRow("too large") << QByteArray("1e999") << false << 0.0;
    QTest::newRow("zero byte") << QByteArray("1\0", 2) << false << 0.0;
}

void NumberTextTest::parses()
{
    QFETCH(QByteArray, text);
    QFETCH(bool, valid);
    QFETCH(double, value);
    const auto number = parseNumber<double>({text.data(), static_cast<std::size_t>(text.size())});
    QCOMPARE(number.has_value(), valid);
    if (valid)
        QCOMPARE(*number, value);
}

void NumberTextTest::refusesWholeNumbersThatDoNotFit()
{
    QCOMPARE(parseNumber<std::uint8_t>("255"), std::optional<std::uint8_t>(255));
    QVERIFY(!parseNumber<std::uint8_t>("256"));
    QVERIFY(!parseNumber<std::uint8_t>("-1"));
    QVERIFY(!parseNumber<std::uint64_t>("18446744073709551616"));
    QVERIFY(!parseNumber<int>("1.0"));
    QCOMPARE(parseNumber<std::int64_t>("-9223372036854775808"),
             std::optional<std::int64_t>(std::numeric_limits<std::int64_t>::min()));
}

void NumberTextTest::knowsTheLocaleNot()
{
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
        QSKIP_WITHOUT("locale de_DE.UTF-8");
    const auto number = parseNumber<double>("1.5");
    const std::string text = formatNumber(1234.5);
    std::setlocale(LC_ALL, "C");
    QCOMPARE(number, std::optional<double>(1.5));
    QCOMPARE(text, std::string("1234.5"));
}

void NumberTextTest::roundTripsAnyDouble()
{
    QCOMPARE(formatNumber(0.1), std::string("0.1"));
    QCOMPARE(formatNumber(0.1f), std::string("0.1"));
    std::uint64_t bits = 88172645463325252u;
    for (int i = 0; i < 20000; ++i) {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        const auto number = std::bit_cast<double>(bits);
        if (!std::isfinite(number))
            continue;
        const auto again = parseNumber<double>(formatNumber(number));
        QVERIFY(again && std::bit_cast<std::uint64_t>(*again) == bits);
    }
}

QTEST_GUILESS_MAIN(NumberTextTest)
#include "number_text_test.moc"
