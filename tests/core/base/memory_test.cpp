// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"

#include <QTest>

#include <vector>

using namespace tetra;

/// What the process occupies.
class MemoryTest : public QObject {
    Q_OBJECT

private slots:
    void residentMemoryCountsWhatIsTouched()
    {
        const std::uint64_t before = residentBytes();
        QVERIFY(before > pageSize());
        const std::vector<char> memory(64 << 20, 1);
        const std::uint64_t after = residentBytes();
        QVERIFY(after >= before + (60 << 20));
        QVERIFY(peakResidentBytes() >= after);
        QVERIFY(memory.back() == 1);
    }
};

QTEST_GUILESS_MAIN(MemoryTest)
#include "memory_test.moc"
