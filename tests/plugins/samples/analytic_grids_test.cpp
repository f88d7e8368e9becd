// SPDX-License-Identifier: GPL-3.0-or-later
// The curvilinear samples have the troubles that they promise: collapsed axes, seams, a left hand (R1, S6).
#include "core/data/dataset_checks.h"
#include "plugins/samples/samples.h"

#include <QTest>

#include <set>

using namespace tetra;

namespace {

Dataset sample(std::string_view name, std::uint32_t size)
{
    SampleRequest request;
    request.name = name;
    request.size = size;
    auto made = makeSample(request);
    if (!made)
        qFatal("%s", made.error().text().c_str());
    return *std::move(made);
}

std::size_t distinctPlaces(const Dataset& dataset)
{
    std::set<std::array<double, 3>> places;
    for (const Eigen::Vector3d& p : *dataset.positions)
        places.insert({p[0], p[1], p[2]});
    return places.size();
}

} // namespace

class AnalyticGridsTest : public QObject {
    Q_OBJECT

private slots:
    void everyGridIsAGrid_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("lostPlaces"); // of 12^3 points, those that fall on others
        QTest::addColumn<bool>("leftHanded");
        QTest::newRow("blunt-body") << QByteArray("blunt-body") << 12 * 11 << false;
        QTest::newRow("o-grid") << QByteArray("o-grid") << 12 * 12 << true;
        QTest::newRow("bent-duct") << QByteArray("bent-duct") << 0 << true;
        QTest::newRow("stretched") << QByteArray("stretched") << 0 << false;
    }
    void everyGridIsAGrid()
    {
        QFETCH(QByteArray, name);
        QFETCH(int, lostPlaces);
        QFETCH(bool, leftHanded);
        const Dataset dataset = sample(name.toStdString(), 12);
        QCOMPARE(dataset.domain, DomainClass::Curvilinear);
        QCOMPARE(dataset.positions->size(), std::size_t(12 * 12 * 12));
        QCOMPARE(dataset.source.hash, contentHash(dataset.values, dataset.positions));
        QVERIFY(fitFloats(*dataset.positions));
        QCOMPARE(12 * 12 * 12 - int(distinctPlaces(dataset)), lostPlaces);
        const CellCornerSigns signs = cellCornerSigns(dataset);
        QCOMPARE(isLeftHanded(dataset), leftHanded);
        QCOMPARE(leftHanded ? signs.positive : signs.negative, std::uint64_t(0)); // none is turned over
    }

    /// Planes of equal k of the blunt body hold the axis exactly.
    void theCollapsedAxisIsFlat()
    {
        const Dataset dataset = sample("blunt-body", 16);
        for (std::uint32_t k = 0; k < 16; ++k)
            for (std::uint32_t j = 1; j < 15; ++j)
                for (std::uint32_t i = 0; i < 16; ++i) {
                    const Eigen::Vector3d first = dataset.position(dataset.lattice.index(0, 15, k));
                    const Eigen::Vector3d other = dataset.position(dataset.lattice.index(i, j, k));
                    QCOMPARE(first[1] * other[2], first[2] * other[1]); // products of floats are exact in doubles
                    QCOMPARE(dataset.position(dataset.lattice.index(i, 0, k)).tail<2>().norm(), 0.);
                }
    }

    void neverChange_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<quint64>("hash");
        QTest::newRow("blunt-body") << QByteArray("blunt-body") << quint64(12647162044507811754u);
        QTest::newRow("o-grid") << QByteArray("o-grid") << quint64(3470462160101477918u);
        QTest::newRow("bent-duct") << QByteArray("bent-duct") << quint64(9303068965260393936u);
        QTest::newRow("stretched") << QByteArray("stretched") << quint64(17139346608025770640u);
    }
    /// The same bits on every machine.
    void neverChange()
    {
        QFETCH(QByteArray, name);
        QFETCH(quint64, hash);
        QCOMPARE(quint64(sample(name.toStdString(), 20).source.hash), hash);
    }
};

QTEST_GUILESS_MAIN(AnalyticGridsTest)
#include "analytic_grids_test.moc"
