// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/redistribution.h"

#include <QTest>

#include <random>

using namespace tetra;

namespace {

using BigInteger = __int128;

struct Offset {
    std::int64_t x, y, z;
};

BigInteger determinant(const Offset& a, const Offset& b, const Offset& c)
{
    return BigInteger(a.x) * (b.y * c.z - b.z * c.y) + BigInteger(a.y) * (b.z * c.x - b.x * c.z) +
           BigInteger(a.z) * (b.x * c.y - b.y * c.x);
}

} // namespace

/// S8, S9: points go to a tetrahedron that contains them, with their exact error, near and far from the apex.
class RedistributionTest : public QObject {
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
        std::vector<std::array<PackedPoint, 3>> faces;
        constexpr int quads[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
        for (const auto& quad : quads)
            for (int half = 0; half < 2; ++half) {
                const PackedPoint a = corners[static_cast<std::size_t>(quad[0])];
                PackedPoint b = corners[static_cast<std::size_t>(quad[1 + half])];
                PackedPoint c = corners[static_cast<std::size_t>(quad[2 + half])];
                if (determinant(offset(a), offset(b), offset(c)) < 0)
                    std::swap(b, c);
                faces.push_back({a, b, c});
            }
        star.set(apex, faces, {1, 1, 1});
        QCOMPARE(star.faceCount(), std::size_t(12));

        std::vector<PackedPoint> points;
        for (int i = 0; i < 3000; ++i)
            points.push_back(lattice.pack(random() % n, random() % n, random() % n));
        Redistribution relocation;
        relocation.run(lattice, LatticeSamples(std::span<const std::uint8_t>(values)), star, points);

        QVERIFY(std::ranges::equal(relocation.points(), points));
        std::vector<std::uint32_t> counts(star.faceCount());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto owner = static_cast<std::size_t>(relocation.owners()[i]);
            const auto& link = star.corners()[owner];
            const PackedPoint a = star.link()[link[0]], b = star.link()[link[1]], c = star.link()[link[2]];
            const BigInteger whole = determinant(offset(a), offset(b), offset(c));
            QVERIFY(whole > 0);
            QVERIFY(star.faces()[owner].determinant() == static_cast<double>(whole));
            const PackedPoint p = points[i];
            const BigInteger wa = determinant(offset(p), offset(b), offset(c));
            const BigInteger wb = determinant(offset(a), offset(p), offset(c));
            const BigInteger wc = determinant(offset(a), offset(b), offset(p));
            QVERIFY(wa >= 0 && wb >= 0 && wc >= 0 && wa + wb + wc <= whole);
            const auto value = [&](PackedPoint q) { return BigInteger(values[lattice.index(q)]); };
            const BigInteger error = whole * (value(p) - value(apex)) - wa * (value(a) - value(apex)) -
                                     wb * (value(b) - value(apex)) - wc * (value(c) - value(apex));
            QCOMPARE(relocation.errors()[i],
                     static_cast<double>(error < 0 ? -error : error) / static_cast<double>(whole));
            QVERIFY(relocation.worstError(owner) >= relocation.errors()[i]);
            ++counts[owner];
        }
        for (std::size_t face = 0; face < star.faceCount(); ++face)
            QCOMPARE(relocation.count(face), counts[face]);
    }

    /// S3: what the queue cannot tell apart goes to the first point, or blocks would disagree about a shared one.
    void worstAmongEqualFloatsIsTheFirst()
    {
        const PackedLattice lattice({3, 3, 3});
        Star star;
        QVERIFY(star.attach(lattice).ok());
        const std::vector<std::array<PackedPoint, 3>> faces{
            {lattice.pack(2, 0, 0), lattice.pack(0, 2, 0), lattice.pack(0, 0, 2)}};
        star.set(0, faces, {1, 1, 1});
        std::vector<double> values(27, 0.0);
        const PackedPoint first = lattice.pack(1, 0, 0), later = lattice.pack(0, 1, 0), last = lattice.pack(0, 0, 1);
        values[lattice.index(first)] = 1e9 + 1;
        values[lattice.index(later)] = -1e9 - 2;
        values[lattice.index(last)] = 1e9 - 500;
        Redistribution relocation;
        relocation.run(lattice, LatticeSamples(std::span<const double>(values)), star, std::array{last, later, first});
        QCOMPARE(relocation.count(0), 3u);
        QCOMPARE(relocation.worstPoint(0), first);
        QVERIFY(relocation.worstError(0) >= 1e9 + 2);
        QVERIFY(relocation.worstError(0) <= (1e9 + 2) * (1 + 1e-6));
    }
};

QTEST_APPLESS_MAIN(RedistributionTest)
#include "redistribution_test.moc"
