// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/packed_lattice.h"

#include <QTest>

using namespace tetra;

/// S8: the integer weights of the squared differences, and the packing of coordinates.
class LatticeMetricTest : public QObject {
    Q_OBJECT
private slots:
    void cubicCellsHaveEqualWeights()
    {
        QCOMPARE(*latticeMetric({32, 32, 32}, {1, 1, 1}), (LatticeMetric{1, 1, 1}));
        QCOMPARE(*latticeMetric({32, 40, 50}, {0.7, 0.7, 0.7}), (LatticeMetric{1, 1, 1}));
    }

    void decimalSpacingsAreExact()
    {
        const LatticeMetric metric = *latticeMetric({64, 64, 93}, {3.2, 3.2, 1.5});
        QCOMPARE(metric, (LatticeMetric{1024, 1024, 225}));
    }

    /// Their squares are 0, or infinite.
    void tinyAndHugeLengthsAreLikeOthers()
    {
        for (const double unit : {1e-170, 1e-300, 1e170, 1e300}) {
            const LatticeMetric metric = *latticeMetric({64, 64, 93}, Eigen::Vector3d(2, 2, 1) * unit);
            QCOMPARE(metric, (LatticeMetric{4, 4, 1}));
        }
    }

    void irrationalRatiosAreClose()
    {
        const Eigen::Vector3d spacing(1, 1.4142135623730951, 2.718281828459045);
        const LatticeMetric metric = *latticeMetric({50, 60, 70}, spacing);
        QVERIFY(std::abs(double(metric[1]) / metric[0] - 2) < 1e-3);
        QVERIFY(std::abs(double(metric[2]) / metric[0] - 7.38905609893065) < 1e-3 * 7.4);
    }

    void theLimitOfExactArithmeticIsRefused()
    {
        QVERIFY(latticeMetric({512, 512, 512}, {1, 1, 1}).ok());
        const auto refused = latticeMetric({2048, 2048, 2048}, {1, 1, 1});
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
        QVERIFY(refused.error().text().find("2048 x 2048 x 2048") != std::string::npos);
    }

    void packedPointsComeBack_data()
    {
        QTest::addColumn<quint32>("nx");
        QTest::addColumn<quint32>("ny");
        QTest::addColumn<quint32>("nz");
        QTest::newRow("smallest") << 2u << 2u << 2u;
        QTest::newRow("powers of two") << 32u << 64u << 16u;
        QTest::newRow("odd") << 97u << 33u << 5u;
        QTest::newRow("long") << 100000u << 3u << 4u;
    }
    void packedPointsComeBack()
    {
        QFETCH(quint32, nx);
        QFETCH(quint32, ny);
        QFETCH(quint32, nz);
        QVERIFY(PackedLattice::fits({nx, ny, nz}));
        const PackedLattice lattice({nx, ny, nz});
        quint32 expected = 0;
        for (quint32 z = 0; z < nz; ++z)
            for (quint32 y = 0; y < ny; ++y)
                for (quint32 x = 0; x < nx; ++x, ++expected) {
                    const PackedPoint point = lattice.pack(x, y, z);
                    if (lattice.index(point) != expected || quint32(lattice.x(point)) != x ||
                        quint32(lattice.y(point)) != y || quint32(lattice.z(point)) != z)
                        QFAIL("a point changed when it was packed");
                }
    }
    void tooManyPointsDoNotFit() { QVERIFY(!PackedLattice::fits({2000, 2000, 2000})); }
};

QTEST_APPLESS_MAIN(LatticeMetricTest)
#include "lattice_metric_test.moc"
