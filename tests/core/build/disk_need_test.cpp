// SPDX-License-Identifier: GPL-3.0-or-later
// What a build in blocks takes on the disk is told in the units that people read, and refused where there is no room.
#include "core/build/disk_need.h"

#include <QTest>

using namespace tetra;

class DiskNeedTest : public QObject {
    Q_OBJECT

private slots:
    void tellsTheModelAndTheWorkFiles()
    {
        QCOMPARE(textOf({1'440'000'000, 2'000'000'000}), std::string("model about 1.5 GB, work files 2 GB"));
        QCOMPARE(textOf({999'100'000, 1}), std::string("model about 1000 MB, work files 1 MB"));
    }

    void growsWithWhatIsExpected()
    {
        const DiskNeed bytes = diskNeed({1000, 1000, 6000, 80'000}, SampleType::UInt8, DomainClass::RegularLattice);
        QVERIFY(bytes.model > 6000 * 12);
        QVERIFY(bytes.workFiles >= 80'000 + 1000 * sizeof(std::uint32_t));
        QCOMPARE(diskNeed({1000, 1000, 6000, 80'000}, SampleType::Float64, DomainClass::RegularLattice).model,
                 bytes.model + 2 * 1000 * 7);
        // Samples beyond an eighth of the rest are left out of a model.
        QCOMPARE(diskNeed({1'000'000, 1000, 6000, 80'000}, SampleType::Float64, DomainClass::RegularLattice).model,
                 bytes.model - 1000 + 1000 * 7);
        QVERIFY(diskNeed({1000, 1000, 12'000, 80'000}, SampleType::UInt8, DomainClass::RegularLattice).model >
                bytes.model);
        // More sites than a model can have are refused elsewhere; here the number must only not wrap around.
        const std::uint64_t most = 0xffffffff;
        QCOMPARE(diskNeed({0, most + 1, 0, 0}, SampleType::UInt8, DomainClass::RegularLattice).model,
                 diskNeed({0, most, 0, 0}, SampleType::UInt8, DomainClass::RegularLattice).model);
    }

    void refusesWhatHasNoRoom_data()
    {
        QTest::addColumn<quint64>("written");
        QTest::addColumn<quint64>("free");
        QTest::addColumn<bool>("fits");
        QTest::newRow("just enough") << quint64(0) << quint64(3'000'000'000) << true;
        QTest::newRow("one byte less") << quint64(0) << quint64(2'999'999'999) << false;
        QTest::newRow("what is written needs no room") << quint64(1'000'000'000) << quint64(2'000'000'000) << true;
        QTest::newRow("the rest has none") << quint64(1'000'000'000) << quint64(1'999'999'999) << false;
        QTest::newRow("all is written") << quint64(3'000'000'001) << quint64(0) << true;
    }
    void refusesWhatHasNoRoom()
    {
        QFETCH(quint64, written);
        QFETCH(quint64, free);
        QFETCH(bool, fits);
        const Status room = checkRoom({1'000'000'000, 2'000'000'000}, written, free, "/data");
        QCOMPARE(room.ok(), fits);
        if (fits)
            return;
        QCOMPARE(room.error().kind, ErrorKind::CannotWrite);
        for (const char* part : {"3 GB", "'/data'", "model about 1 GB", "work files 2 GB", "Free some space"})
            QVERIFY2(room.error().text().find(part) != std::string::npos, room.error().text().c_str());
    }
};

QTEST_APPLESS_MAIN(DiskNeedTest)
#include "disk_need_test.moc"
