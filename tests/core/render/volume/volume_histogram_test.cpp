// SPDX-License-Identifier: GPL-3.0-or-later
// Histograms of a field's volume against a slow double-precision sum over cells and parts.
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/volume/volume_meshes.h"

#include <tan/render.h>

#include <QTest>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace tetra;

namespace {

/// For each part the volume of its values, as a share of what lies in the range.
std::vector<double> slowShares(const TetrahedralMesh& mesh, double least, double largest, int parts)
{
    std::vector<double> shares(static_cast<std::size_t>(parts));
    const double width = (largest - least) / parts;
    for (const auto& cell : mesh.tetrahedra) {
        Eigen::Matrix3d edges;
        for (int edge = 0; edge < 3; ++edge)
            edges.col(edge) = (mesh.positions[cell[std::size_t(edge) + 1]] - mesh.positions[cell[0]]).cast<double>();
        double low = mesh.values[cell[0]], high = low;
        for (const std::uint32_t corner : cell) {
            low = std::min<double>(low, mesh.values[corner]);
            high = std::max<double>(high, mesh.values[corner]);
        }
        for (int part = 0; part < parts; ++part) {
            const double overlap = std::min(high, least + (part + 1) * width) - std::max(low, least + part * width);
            shares[std::size_t(part)] += std::abs(edges.determinant()) * std::max(overlap, 0.0) / (high - low);
        }
    }
    const double total = std::reduce(shares.begin(), shares.end());
    for (double& share : shares)
        share /= total;
    return shares;
}

double share(const ValueHistogram& histogram, std::size_t part)
{
    return static_cast<double>(histogram.counts[part]) / 0x1p32;
}

} // namespace

class VolumeHistogramTest : public QObject {
    Q_OBJECT

private slots:
    void isTheSlowSum_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("largest");
        QTest::addColumn<int>("parts");
        QTest::newRow("all values") << -1.0 << 2.0 << 100;
        QTest::newRow("a part of the values") << 0.31 << 0.57 << 37;
        QTest::newRow("one part") << 0.2 << 0.9 << 1;
    }
    void isTheSlowSum()
    {
        QFETCH(double, least);
        QFETCH(double, largest);
        QFETCH(int, parts);
        for (const auto& mesh : {testing::irregularWithHole(), testing::randomLattice(5), testing::refinedLattice()}) {
            const ValueHistogram histogram = volumeHistogram(mesh, least, largest, parts);
            QCOMPARE(histogram.least, least);
            QCOMPARE(histogram.largest, largest);
            const std::vector<double> expected = slowShares(mesh, least, largest, parts);
            QCOMPARE(histogram.counts.size(), expected.size());
            for (std::size_t part = 0; part < expected.size(); ++part)
                QVERIFY(std::abs(share(histogram, part) - expected[part]) < 1e-8);
        }
    }

    /// However fine the mesh is where: the values of x fill a cube evenly.
    void doesNotDependOnTheMesh()
    {
        for (const std::uint32_t cells : {4u, 8u}) {
            const auto mesh = testing::latticeMesh(cells, 3, testing::Split::Six,
                                                   [](const Eigen::Vector3d& point) { return 10 * point.x(); });
            const ValueHistogram histogram = volumeHistogram(mesh, 0, 30, static_cast<int>(cells));
            for (std::size_t part = 0; part < cells; ++part)
                QVERIFY(std::abs(share(histogram, part) - 1.0 / cells) < 1e-6);
        }
    }

    void cellsOfOneValueCount()
    {
        auto mesh = testing::oneCell();
        std::ranges::fill(mesh.values, 0.25f);
        const ValueHistogram histogram = volumeHistogram(mesh, 0, 1, 10);
        QCOMPARE(histogram.counts[2], std::uint64_t(1) << 32);
        std::ranges::fill(mesh.values, 1.0f);
        QCOMPARE(volumeHistogram(mesh, 0, 1, 10).counts[9], std::uint64_t(1) << 32);
    }

    void whatCannotBeCountedIsLeftOut()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        auto mesh = testing::oneCell();
        QVERIFY(volumeHistogram(mesh, 1, 1, 8).counts.empty());
        QVERIFY(volumeHistogram(mesh, 0, infinity, 8).counts.empty());
        QVERIFY(volumeHistogram(mesh, 0, 1, 0).counts.empty());
        QVERIFY(volumeHistogram({}, 0, 1, 8).counts.empty());
        QVERIFY(volumeHistogram(mesh, 100, 200, 8).counts.empty());
        mesh.values[0] = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(volumeHistogram(mesh, 0, 1, 8).counts.empty());
    }
};

QTEST_GUILESS_MAIN(VolumeHistogramTest)
#include "volume_histogram_test.moc"
