// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/relocation.h"

#include <QTest>

#include <random>

using namespace tetra;

namespace {

using Whole = __int128;

struct Offset {
    std::int64_t x, y, z;
};

Whole determinant(const Offset& a, const Offset& b, const Offset& c)
{
    return Whole(a.x) * (b.y * c.z - b.z * c.y) + Whole(a.y) * (b.z * c.x - b.x * c.z) +
           Whole(a.z) * (b.x * c.y - b.y * c.x);
}

} // namespace

/// S8, S9: points go to a tetrahedron that contains them, with their exact error, near and far from the apex.
class RelocationTest : public QObject {
    Q_OBJECT
private slots:
    void agreesWithExactArithmetic_data()
    {
        QTest::addColumn<quint32>("n");
        QTest::newRow("small, in floats") << 9u;
        QTest::newRow("large, in doubles") << 601u;
    }
    void agreesWithExactArithmetic()
    {
        QFETCH(quint32, n);
        const PackedLattice lattice({n, n, n});
        std::mt19937 random(11);
        std::vector<std::uint8_t> values(std::size_t(n) * n * n);
        for (std::uint8_t& value : values)
            value = static_cast<std::uint8_t>(random());
        // The star of an inner point over the twelve triangles of the whole box.
        const PackedPoint apex = lattice.pack(n / 2 - 1, n / 2, n / 2 + 1);
        std::array<PackedPoint, 8> corners{};
        for (std::uint32_t i = 0; i < 8; ++i)
            corners[i] = lattice.pack((i & 1) * (n - 1), (i >> 1 & 1) * (n - 1), (i >> 2 & 1) * (n - 1));
        const auto offset = [&](PackedPoint p) {
            return Offset{lattice.x(p) - lattice.x(apex), lattice.y(p) - lattice.y(apex),
                          lattice.z(p) - lattice.z(apex)};
        };
        Star star;
        QVERIFY(star.attach(lattice).ok());
        star.clear(apex);
        constexpr int quads[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
        for (const auto& quad : quads)
            for (int half = 0; half < 2; ++half) {
                const PackedPoint a = corners[static_cast<std::size_t>(quad[0])];
                PackedPoint b = corners[static_cast<std::size_t>(quad[1 + half])];
                PackedPoint c = corners[static_cast<std::size_t>(quad[2 + half])];
                if (determinant(offset(a), offset(b), offset(c)) < 0)
                    std::swap(b, c);
                star.addFace(a, b, c);
            }
        star.finish({1, 1, 1});
        QCOMPARE(star.faceCount(), std::size_t(12));

        std::vector<PackedPoint> points{apex};
        for (int i = 0; i < 3000; ++i)
            points.push_back(lattice.pack(random() % n, random() % n, random() % n));
        Relocation relocation;
        relocation.run(lattice, LatticeSamples(std::span<const std::uint8_t>(values)), star, points);

        std::size_t placed = 0;
        for (std::size_t face = 0; face < star.faceCount(); ++face) {
            const auto& rim = star.corners()[face];
            const PackedPoint a = star.rim()[rim[0]], b = star.rim()[rim[1]], c = star.rim()[rim[2]];
            const Whole whole = determinant(offset(a), offset(b), offset(c));
            QVERIFY(whole > 0);
            QVERIFY(star.faces()[face].determinant() == static_cast<double>(whole));
            for (std::uint32_t i = relocation.offsets()[face]; i < relocation.offsets()[face + 1]; ++i) {
                const PackedPoint p = relocation.placed()[i];
                const Whole wa = determinant(offset(p), offset(b), offset(c));
                const Whole wb = determinant(offset(a), offset(p), offset(c));
                const Whole wc = determinant(offset(a), offset(b), offset(p));
                QVERIFY(wa >= 0 && wb >= 0 && wc >= 0 && wa + wb + wc <= whole);
                const auto value = [&](PackedPoint q) { return Whole(values[lattice.index(q)]); };
                const Whole error = whole * (value(p) - value(apex)) - wa * (value(a) - value(apex)) -
                                    wb * (value(b) - value(apex)) - wc * (value(c) - value(apex));
                QVERIFY(relocation.scaledErrors()[i] == static_cast<double>(error < 0 ? -error : error));
                ++placed;
            }
        }
        QCOMPARE(placed, static_cast<std::size_t>(
                             std::ranges::count_if(points, [&](PackedPoint point) { return point != apex; })));
    }

    /// S3: what the queue cannot tell apart goes to the first point, or blocks would disagree about a shared one.
    void worstAmongEqualFloatsIsTheFirst()
    {
        const std::array<PackedPoint, 4> points{9, 7, 3, 1};
        const std::array<double, 4> errors{1e9 + 2, 1e9 + 1, 1e9 + 1, 1e9 - 500};
        const PlacedError worst = worstError(points, errors, 3);
        QCOMPARE(worst.point, PackedPoint(3));
        QVERIFY(worst.error >= (1e9 + 2) / 3);
        QCOMPARE(worstError(std::span(points).first(2), std::array{5.0, 6.0}, 2).point, PackedPoint(7));
        QCOMPARE(worstError(std::span(points).first(2), std::array{0.0, 0.0}, 2).point, PackedPoint(7));
    }
};

QTEST_APPLESS_MAIN(RelocationTest)
#include "relocation_test.moc"
