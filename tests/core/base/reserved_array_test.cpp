// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/reserved_array.h"

#include <tan/base.h>

#include <QtTest>

#include <cstdint>

using namespace tetra;

class ReservedArrayTest : public QObject {
    Q_OBJECT

private slots:
    void isZeroAndHoldsWhatIsWritten()
    {
        ReservedArray<std::uint32_t> array;
        QVERIFY(array.reserve(1'000'000, MarkedText{"a test"}).ok());
        QCOMPARE(array.capacity(), std::uint64_t(1'000'000));
        QCOMPARE(array[999'999], 0u);
        for (std::uint32_t i = 0; i < array.capacity(); ++i)
            array[i] = i * 7;
        for (std::uint32_t i = 0; i < array.capacity(); ++i)
            QVERIFY(array[i] == i * 7);
    }

    void whatTheMachineCannotGiveIsAnError()
    {
        ReservedArray<std::uint64_t> array;
        const Status refused = array.reserve(std::uint64_t(1) << 50, MarkedText{"the tetrahedra"});
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
        QVERIFY(QString::fromStdString(refused.error().text()).contains("for the tetrahedra"));
    }
};

QTEST_APPLESS_MAIN(ReservedArrayTest)
#include "reserved_array_test.moc"
