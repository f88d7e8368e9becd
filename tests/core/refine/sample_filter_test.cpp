// SPDX-License-Identifier: GPL-3.0-or-later
// What the filter leaves out has no sample beyond its limit: with it the worst samples are the same as without it.
#include "core/refine/insertion/sample_scan.h"

#include "core/base/simd.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace tetra;

namespace {

/// `most` outside of a box, `least` in it or, if not two-valued, more towards its ends.
class BoxLimits final : public ErrorLimits {
public:
    double at(const std::array<std::uint32_t, 3>& point) const override
    {
        double share = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<std::int32_t>(point[axis]);
            if (place < first[axis] || place > last[axis])
                return most;
            share = std::max(share, std::abs(2.0 * place - first[axis] - last[axis]) / (last[axis] - first[axis] + 1));
        }
        return twoValued ? least : least + share * (most - least);
    }
};

struct Meshed {
    LocalDelaunay mesh;
    std::vector<std::uint32_t> alive; ///< slots
};

/// The Delaunay mesh of a box's corners and some of its points.
void makeMesh(const std::array<std::uint32_t, 3>& size, std::size_t count, std::mt19937& random, Meshed& made)
{
    const BlockDivision division(size, 0);
    LatticeDelaunay start;
    QVERIFY(start.start(size, {1, 1, 1}).ok());
    std::vector<PackedPoint> corners;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    for (const DelaunayTetrahedron& one : start.tetrahedra()) {
        std::array<std::uint32_t, 4> numbers{};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto known = std::ranges::find(corners, one.vertices[i]);
            numbers[i] = static_cast<std::uint32_t>(known - corners.begin());
            if (known == corners.end())
                corners.push_back(one.vertices[i]);
        }
        tetrahedra.push_back(numbers);
    }
    QVERIFY(made.mesh.prepare(division, {1, 1, 1}).ok());
    QCOMPARE(made.mesh.load(tetrahedra, corners), MeshLoading::Done);
    std::vector<std::uint32_t> points(count > 0 ? std::size_t(size[0]) * size[1] * size[2] : 0);
    std::iota(points.begin(), points.end(), 0u);
    std::ranges::shuffle(points, random);
    for (std::size_t i = 0; i < count; ++i) {
        const PackedPoint point = made.mesh.lattice().pointAt(points[i]);
        if (!made.mesh.isVertex(point))
            QVERIFY(made.mesh.add({&point, 1}));
    }
    for (std::uint32_t slot = 0; slot < made.mesh.mesh().slotCount(); ++slot)
        if (made.mesh.mesh()[slot].determinant() != 0)
            made.alive.push_back(slot);
}

/// Waves with noise, so that many errors are close to one another; of integers over their whole range.
template <class T> std::vector<T> samplesOf(const std::array<std::uint32_t, 3>& size, std::mt19937& random)
{
    const double reach = std::is_integral_v<T> ? static_cast<double>(std::numeric_limits<T>::max()) : 1e3;
    const double least = std::is_signed_v<T> ? -reach : 0;
    std::vector<T> samples;
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const double wave = 0.5 + 0.4 * std::sin(0.3 * x + 0.2 * y) * std::cos(0.25 * z);
                const double share = wave + 0.1 * static_cast<double>(random() % 1000) / 1000;
                samples.push_back(static_cast<T>(least + std::min(share, 1.0) * (reach - least)));
            }
    return samples;
}

bool same(const WorstSample& one, const WorstSample& other)
{
    return one.excess == other.excess && one.error == other.error && one.point == other.point &&
           one.slot == other.slot && one.tetrahedron == other.tetrahedron;
}

} // namespace

class SampleFilterTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsMissed_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 0; seed < 40; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void nothingIsMissed()
    {
        QFETCH(quint32, seed);
        std::mt19937 random(seed);
        std::array<std::uint32_t, 3> size{};
        for (std::uint32_t& along : size)
            along = 3 + random() % 20;
        Meshed made;
        makeMesh(size, 4 + random() % 120, random, made);
        const auto check = [&]<class T>(T) {
            const std::vector<T> values = samplesOf<T>(size, random);
            const LatticeSamples samples{std::span<const T>(values)};
            const auto [least, largest] = std::ranges::minmax(values);
            const double reach = std::max(std::abs(double(least)), std::abs(double(largest)));
            for (int i = 0; i < 6; ++i) {
                BoxLimits limits;
                const double extent = static_cast<double>(largest) - static_cast<double>(least);
                limits.least = std::array{0.0, 0.02, 0.1, 0.3}[random() % 4] * extent;
                limits.most = limits.least * std::array{1.0, 2.0, 8.0}[random() % 3];
                limits.twoValued = random() % 3 != 0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    limits.first[axis] = std::int32_t(random() % size[axis]);
                    limits.last[axis] =
                        std::min(limits.first[axis] + std::int32_t(random() % 12), std::int32_t(size[axis]) - 1);
                }
                for (const ScannedPart part : {ScannedPart::All, ScannedPart::Limited})
                    compare(made, samples, reach, limits, part);
            }
        };
        check(std::uint8_t());
        check(std::int8_t());
        check(std::uint16_t());
        check(std::int16_t());
        check(std::uint32_t());
        check(std::int32_t());
        check(float());
        check(double());
    }

    /// More rows than floats can number, as in a tetrahedron that fills a thin lattice.
    void noneOfManyRowsIsMissed()
    {
        const std::array<std::uint32_t, 3> size{2, 4100, 4100};
        std::mt19937 random(1);
        Meshed made;
        makeMesh(size, 0, random, made);
        std::vector<float> values(std::size_t(size[0]) * size[1] * size[2]);
        values[(std::size_t(4096) * size[1] + 2051) * size[0]] = 200;
        BoxLimits limits;
        limits.least = limits.most = 50;
        compare(made, LatticeSamples{std::span<const float>(values)}, 200, limits, ScannedPart::All);
    }

    /// Of two samples of one tetrahedron that are as far off the first in the lattice, whichever lanes of the vectors
    /// they are in.
    void ofEqualErrorsTheFirstIsTaken()
    {
        for (const std::uint32_t side : {12u, 6u}) { // in vectors, and in a lattice too narrow for them
            const std::array<std::uint32_t, 3> size{side, 12, 12};
            std::mt19937 random(1);
            Meshed made;
            makeMesh(size, 0, random, made);
            const auto last = static_cast<std::int32_t>(side) - 1;
            int ties = 0;
            for (const auto& [one, other] : {std::pair(1, last - 1), std::pair(last - 1, 1), std::pair(2, 3)}) {
                const auto index = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
                    return (std::size_t(z) * size[1] + std::size_t(y)) * size[0] + std::size_t(x);
                };
                const std::size_t first = index(one, 5, 5), second = index(other, 6, 5);
                std::vector<float> values(std::size_t(size[0]) * size[1] * size[2]);
                values[first] = values[second] = 10;
                BoxLimits limits;
                limits.least = limits.most = 1;
                const LatticeSamples samples{std::span<const float>(values)};
                const auto worstOf = [&](std::size_t alone) {
                    std::vector<float> single(values.size());
                    single[alone] = 10;
                    std::vector<WorstSample> found;
                    scanSamples(made.mesh, made.alive, LatticeSamples{std::span<const float>(single)}, limits,
                                ScannedPart::All, found);
                    return found;
                };
                const auto ofFirst = worstOf(first), ofSecond = worstOf(second);
                std::vector<WorstSample> found;
                scanSamples(made.mesh, made.alive, samples, limits, ScannedPart::All, found);
                const auto in = [](const std::vector<WorstSample>& some, std::uint32_t slot) {
                    return std::ranges::find(some, slot, &WorstSample::slot) != some.end();
                };
                for (const WorstSample& worst : found) {
                    const bool hasFirst = in(ofFirst, worst.slot);
                    ties += hasFirst && in(ofSecond, worst.slot) ? 1 : 0;
                    QCOMPARE(worst.point,
                             made.mesh.lattice().pointAt(static_cast<std::uint32_t>(hasFirst ? first : second)));
                }
            }
            QVERIFY(ties > 0);
        }
    }

    /// A tetrahedron that reaches one sample out of what is settled is looked at.
    void settledPartsEndWhereTheyDo()
    {
        const std::array<std::uint32_t, 3> size{20, 18, 16};
        std::mt19937 random(1);
        Meshed made;
        makeMesh(size, 0, random, made); // each tetrahedron reaches from side to side
        std::vector<float> values(std::size_t(size[0]) * size[1] * size[2]);
        values[(std::size_t(7) * size[1] + 8) * size[0] + 9] = 100;
        BoxLimits limits;
        limits.least = 1;
        limits.most = 1000;
        limits.twoValued = true;
        const std::array<std::int32_t, 3> last{19, 17, 15};
        limits.last = last;
        const auto findsWith = [&](const std::array<std::int32_t, 3>& from, const std::array<std::int32_t, 3>& to) {
            limits.settle(from, to);
            const LatticeSamples samples{std::span<const float>(values)};
            std::vector<WorstSample> found;
            scanSamples(made.mesh, made.alive, samples, limits, ScannedPart::Limited, found);
            FilteredTetrahedra filtered;
            filterTetrahedra(made.mesh, made.alive, samples, 100, limits, ScannedPart::Limited, filtered);
            return std::pair(!found.empty(), !filtered.suspects.empty());
        };
        QCOMPARE(findsWith({0, 0, 0}, {-1, -1, -1}), std::pair(true, true));
        const bool filters = simdLevel() == SimdLevel::Sixteen; // else all are suspects
        QCOMPARE(findsWith({0, 0, 0}, last), std::pair(false, !filters));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<std::int32_t, 3> from{0, 0, 0}, to = last;
            from[axis] = 1;
            QCOMPARE(findsWith(from, last), std::pair(true, true));
            --to[axis];
            QCOMPARE(findsWith({0, 0, 0}, to), std::pair(true, true));
        }
    }

    void whatIsGoodEnoughIsLeftOut()
    {
        if (simdLevel() != SimdLevel::Sixteen)
            QSKIP("skipped: no vectors of 16 floats");
        std::mt19937 random(1);
        Meshed made;
        makeMesh({30, 25, 20}, 300, random, made);
        const std::vector<std::uint8_t> values = samplesOf<std::uint8_t>({30, 25, 20}, random);
        BoxLimits limits;
        limits.least = limits.most = 1000;
        FilteredTetrahedra filtered;
        filterTetrahedra(made.mesh, made.alive, LatticeSamples{std::span<const std::uint8_t>(values)}, 255, limits,
                         ScannedPart::All, filtered);
        QVERIFY2(filtered.suspects.size() < 50, qPrintable(QString::number(filtered.suspects.size())));
        QVERIFY(filtered.fine.size() > 1000);
    }

private:
    static void compare(const Meshed& made, const LatticeSamples& samples, double reach, const ErrorLimits& limits,
                        ScannedPart part)
    {
        std::vector<WorstSample> all, found;
        scanSamples(made.mesh, made.alive, samples, limits, part, all);
        FilteredTetrahedra filtered;
        filterTetrahedra(made.mesh, made.alive, samples, reach, limits, part, filtered);
        scanSamples(made.mesh, filtered.suspects, samples, limits, part, found);
        QVERIFY(std::ranges::equal(all, found, same));
        BoxLimits least;
        least.least = least.most = limits.least;
        std::vector<WorstSample> none;
        scanSamples(made.mesh, filtered.fine, samples, least, ScannedPart::All, none);
        QVERIFY(none.empty());
    }
};

QTEST_GUILESS_MAIN(SampleFilterTest)
#include "sample_filter_test.moc"
