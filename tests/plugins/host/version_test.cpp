// SPDX-License-Identifier: GPL-3.0-or-later
/// The version logic, exhaustively over a grid of versions, against its definition in words.
#include "plugins/api/metadata.h"

#include <QTest>

#include <array>
#include <vector>

using namespace tetra;

namespace {

std::vector<Version> grid()
{
    std::vector<Version> versions;
    for (const int major : {0, 1, 2, 10})
        for (const int minor : {0, 1, 2, 10})
            for (const int patch : {0, 1, 9})
                versions.push_back({major, minor, patch});
    return versions;
}

} // namespace

class VersionTest : public QObject {
    Q_OBJECT

private slots:
    void aVersionFitsItself()
    {
        for (const Version& version : grid())
            QVERIFY2(fits(version, version), toText(version).c_str());
        QVERIFY(fits(pluginInterfaceVersion, pluginInterfaceVersion));
    }

    void fitsOnlyTheSameMajorAndNoEarlierMinorAndBefore1TheSameMinor()
    {
        QVERIFY(!grid().empty());
        for (const Version& wanted : grid())
            for (const Version& offered : grid()) {
                bool expected = true;
                if (wanted.major < offered.major || wanted.major > offered.major)
                    expected = false; // another major version breaks, in both directions
                else if (wanted.minor > offered.minor)
                    expected = false; // wants what was added later
                else if (wanted.major == 0 && wanted.minor < offered.minor)
                    expected = false; // before 1.0 everything may have changed
                QVERIFY2(fits(wanted, offered) == expected, (toText(wanted) + " in " + toText(offered)).c_str());
            }
    }

    void fittingBothWaysMeansNoInterfaceBetween()
    {
        QVERIFY(!grid().empty());
        for (const Version& a : grid())
            for (const Version& b : grid())
                QCOMPARE(fits(a, b) && fits(b, a), a.major == b.major && a.minor == b.minor);
    }

    void fittingIsTransitive()
    {
        QVERIFY(!grid().empty());
        for (const Version& a : grid())
            for (const Version& b : grid())
                for (const Version& c : grid())
                    QVERIFY(!fits(a, b) || !fits(b, c) || fits(a, c));
    }

    void ordersByNumberAndNotByText()
    {
        QVERIFY((Version{1, 10, 0} > Version{1, 9, 9}));
        QVERIFY((Version{10, 0, 0} > Version{9, 99, 99}));
        QVERIFY((Version{1, 2, 3} == Version{1, 2, 3}));
    }

    void textsRoundTrip()
    {
        for (const Version& version : grid())
            QVERIFY(parseVersion(toText(version)) == version);
        QVERIFY((parseVersion("3") == Version{3, 0, 0}));
        QVERIFY((parseVersion("3.4") == Version{3, 4, 0}));
    }

    void refusesWhatIsNoVersion_data()
    {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"", ".", "1.", ".1", "1..2", "1.2.3.4", "1.2.3.", "a", "1a", "1.a", "-1", "+1", " 1",
                                 "1 ", "1,2", "1.-2", "99999999999", "0x1"})
            QTest::newRow(*text ? text : "empty") << QByteArray(text);
    }
    void refusesWhatIsNoVersion()
    {
        QFETCH(QByteArray, text);
        QVERIFY(!parseVersion(text.toStdString()));
    }
};

QTEST_APPLESS_MAIN(VersionTest)
#include "version_test.moc"
