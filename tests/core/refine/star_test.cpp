// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/memory.h"
#include "core/refine/lattice/star.h"
#include "tests/waiting.h"

#include <QTest>

#include <limits>
#include <vector>

using namespace tetra;

namespace {

/// The star of a point in the middle of an octahedron of the lattice at `origin`.
void setOctahedron(Star& star, const PackedLattice& lattice, std::uint32_t origin)
{
    const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return lattice.pack(origin + x, origin + y, origin + z);
    };
    const PackedPoint left = at(0, 1, 1), right = at(2, 1, 1), front = at(1, 0, 1), back = at(1, 2, 1),
                      below = at(1, 1, 0), above = at(1, 1, 2);
    const std::vector<std::array<PackedPoint, 3>> faces{
        {right, back, above}, {back, left, above}, {left, front, above}, {front, right, above},
        {back, right, below}, {left, back, below}, {front, left, below}, {right, front, below}};
    star.set(at(1, 1, 1), faces, {1, 1, 1});
}

} // namespace

class StarTest : public QObject {
    Q_OBJECT

private slots:
    /// Two thousand million vertices of rims later all stamps are used. Where the lattice was never touched, beginning
    /// anew takes no memory either, and what was touched is forgotten.
    void stampsBeginAnew()
    {
        const PackedLattice lattice({1024, 512, 512}); // marks of 2 GiB
        Star star(std::numeric_limits<std::uint32_t>::max() / 2 - 8);
        QVERIFY(star.attach(lattice).ok());
        const std::uint64_t before = residentBytes();
        for (std::uint32_t place = 0; place < 50; ++place) {
            setOctahedron(star, lattice, place % 3);
            QCOMPARE(star.link().size(), std::size_t(6));
            for (const auto& corners : star.corners())
                QVERIFY(corners[0] < 6 && corners[1] < 6 && corners[2] < 6);
            for (const Star::Face& face : star.faces())
                QCOMPARE(face.determinant(), 1.0);
        }
        if (isInstrumented)
            return; // what a sanitizer notes of the places is memory, too
        const std::uint64_t taken = residentBytes() - std::min(before, residentBytes());
        QVERIFY2(taken < 256 << 20, qPrintable(QString("%1 MiB").arg(taken >> 20)));
    }
};

QTEST_APPLESS_MAIN(StarTest)
#include "star_test.moc"
