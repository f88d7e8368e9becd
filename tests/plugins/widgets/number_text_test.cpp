// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/number_text.h"

#include <QLocale>
#include <QTest>

using namespace tetra;

/// Numbers for people, in their locale.
class NumberTextTest : public QObject {
    Q_OBJECT
private slots:
    void durations_data();
    void durations();
    void countsAndPercentages();
    void decimalsResolveTheRange();
};

void NumberTextTest::durations_data()
{
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("text");
    QTest::newRow("under ten milliseconds") << 0.0008 << "0.8 ms";
    QTest::newRow("milliseconds") << 0.0123 << "12 ms";
    QTest::newRow("just under a second") << 0.9994 << "999 ms";
    QTest::newRow("a second") << 0.9996 << "1.0 s";
    QTest::newRow("seconds") << 12.4 << "12 s";
    QTest::newRow("a minute") << 59.6 << "1 min 0 s";
    QTest::newRow("minutes") << 200.0 << "3 min 20 s";
    QTest::newRow("hours") << 3600.0 * 2 + 60 * 5 << "2 h 5 min";
}

void NumberTextTest::durations()
{
    QFETCH(double, seconds);
    QFETCH(QString, text);
    QLocale::setDefault(QLocale::c());
    QCOMPARE(durationText(seconds), text);
}

void NumberTextTest::countsAndPercentages()
{
    QLocale::setDefault(QLocale(QLocale::German));
    QCOMPARE(countText(1234567), QString("1.234.567"));
    QCOMPARE(percentText(0.5), QString("0,5 %"));
    QLocale::setDefault(QLocale(QLocale::English));
    QCOMPARE(countText(1234567), QString("1,234,567"));
    QCOMPARE(percentText(12.345), QString("12.3 %"));
}

void NumberTextTest::decimalsResolveTheRange()
{
    QCOMPARE(decimalsFor(255), 1);
    QCOMPARE(decimalsFor(1), 3);
    QCOMPARE(decimalsFor(65535), 0);
    QCOMPARE(decimalsFor(0), 2);
}

QTEST_GUILESS_MAIN(NumberTextTest)
#include "number_text_test.moc"
