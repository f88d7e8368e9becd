// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader never wrote is found by reading twice.
#include "plugins/readers/vtk/unwritten_memory.h"
#include "tests/waiting.h"

#include <QTest>

#include <cstdlib>
#include <cstring>
#include <span>

using namespace tetra;

namespace {

/// Samples out of new memory, of which `written` bytes of 64 KB were written.
Result<VtkFindings> samplesWith(std::size_t written)
{
    constexpr std::size_t bytes = 65536;
    auto* memory = static_cast<std::byte*>(std::malloc(bytes));
    std::memset(memory, 1, written);
    VtkFindings found;
    found.samples.assign(memory, memory + bytes);
    std::free(memory);
    return found;
}

} // namespace

class UnwrittenMemoryTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsTaken()
    {
        int readings = 0;
        const auto found = readTwice([&] {
            ++readings;
            return samplesWith(65536);
        });
        QVERIFY(found.ok());
        QCOMPARE(readings, 2);
        QVERIFY(std::ranges::all_of(found->samples, [](std::byte byte) { return byte == std::byte(1); }));
    }

    void whatWasNeverWrittenIsRefused()
    {
        if (isInstrumented)
            QSKIP("skipped: sanitizers have a malloc of their own");
        for (const std::size_t written : {std::size_t(0), std::size_t(65535)}) {
            const auto found = readTwice([&] { return samplesWith(written); });
            QVERIFY(!found.ok());
            QVERIFY2(found.error().text().find("what was in memory") != std::string::npos,
                     found.error().text().c_str());
        }
    }

    /// Points at which there is no cell, and cells that are hidden, may hold anything: nobody looks at them.
    void whatNobodyUsesDoesNotMatter()
    {
        double number = 0; // another one in each reading
        for (const bool perCell : {false, true})
            for (const bool isUsed : {false, true}) {
                const auto found = readTwice([&]() -> Result<VtkFindings> {
                    number += 1;
                    VtkFindings cells;
                    cells.kind = VtkDataKind::Cells;
                    cells.perCell = perCell;
                    cells.shapes = {CellShape::Polyhedron, CellShape::Tetrahedron};
                    cells.blanked = {0, std::uint8_t(isUsed ? 0 : 1)};
                    cells.offsets = {0, 16, 20};
                    cells.corners = {3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3, 0, 1, 2, 4};
                    cells.positions.assign(5, Eigen::Vector3d(1, 2, 3));
                    std::vector<double> values(perCell ? 2 : 5, 1);
                    values.back() = number;
                    if (!perCell)
                        cells.positions[4][0] = number;
                    const auto bytes = std::as_bytes(std::span(values));
                    cells.samples.assign(bytes.begin(), bytes.end());
                    return cells;
                });
                QCOMPARE(found.ok(), !isUsed);
            }
    }

    void errorsAreThoseOfTheReading()
    {
        int readings = 0;
        const auto found = readTwice([&]() -> Result<VtkFindings> {
            ++readings;
            return Error{ErrorKind::BadInput, Message("bad")};
        });
        QVERIFY(!found.ok() && found.error().text() == "bad");
        QCOMPARE(readings, 1);
    }
};

QTEST_GUILESS_MAIN(UnwrittenMemoryTest)
#include "unwritten_memory_test.moc"
