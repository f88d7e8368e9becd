// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/samples.h"

#include <tan/build.h>

#include <QTest>

using namespace tetra;

/// What a few thousand points tell of how many a mesh needs.
class SiteDensityTest : public QObject {
    Q_OBJECT
private slots:
    void nothingKnownIsTheWorstCase();
    void linearFieldsNeedNearlyNothing();
    void thinSlabsKeepTheirLayers();
    void aCancelledLookKnowsNothing();
    void aLargerErrorNeedsLess_data();
    void aLargerErrorNeedsLess();
    void smallDataAreNoTrouble();
};

namespace {

Dataset densitySampleOf(const char* name, std::uint32_t size)
{
    return *makeSample({.name = name, .size = size, .type = std::nullopt, .seed = 1});
}

/// x + 2 y - z on a lattice.
Dataset linearDataset(const std::array<std::uint32_t, 3>& size)
{
    Dataset dataset;
    dataset.lattice.size = size;
    const auto values = std::make_shared<std::vector<float>>();
    for (std::uint64_t point = 0; point < dataset.lattice.pointCount(); ++point) {
        const auto at = dataset.lattice.coordinates(point);
        values->push_back(static_cast<float>(at[0]) + 2 * static_cast<float>(at[1]) - static_cast<float>(at[2]));
    }
    const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
    dataset.values = ScalarField(SampleType::Float32, values->size(), bytes);
    return dataset;
}

} // namespace

void SiteDensityTest::nothingKnownIsTheWorstCase()
{
    QVERIFY(!SiteDensity().known());
    QCOMPARE(SiteDensity().share(0), 1.0);
    QCOMPARE(SiteDensity().share(0.5), 1.0);
}

void SiteDensityTest::linearFieldsNeedNearlyNothing()
{
    const SiteDensity density = SiteDensity::of(linearDataset({40, 40, 40}));
    QVERIFY(density.known());
    QVERIFY2(density.share(0) < 1e-4, qPrintable(QString::number(density.share(0))));
}

/// What is one cell thick cannot be thinned across.
void SiteDensityTest::thinSlabsKeepTheirLayers()
{
    const double cube = SiteDensity::of(linearDataset({64, 64, 64})).share(0);
    const double slab = SiteDensity::of(linearDataset({64, 64, 2})).share(0);
    QVERIFY2(std::abs(slab / std::pow(cube, 2.0 / 3) - 1) < 0.01, qPrintable(QString("%1 %2").arg(cube).arg(slab)));
}

/// Nothing is claimed of what was not looked at.
void SiteDensityTest::aCancelledLookKnowsNothing()
{
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!SiteDensity::of(densitySampleOf("scattered", 16), Progress(stop.get_token(), {})).known());
}

void SiteDensityTest::aLargerErrorNeedsLess_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("everything"); ///< the least share at an error of 0
    QTest::newRow("lattice") << "c60" << 0.5;
    QTest::newRow("noise") << "noise" << 0.95;
    QTest::newRow("grid") << "blunt-body" << 0.95;
    QTest::newRow("points") << "scattered" << 0.95;
    QTest::newRow("mesh") << "part" << 0.3;
}

void SiteDensityTest::aLargerErrorNeedsLess()
{
    QFETCH(QString, name);
    QFETCH(double, everything);
    const Dataset dataset = densitySampleOf(qPrintable(name), 16);
    const SiteDensity density = SiteDensity::of(dataset);
    QVERIFY2(density.share(0) >= everything, qPrintable(QString::number(density.share(0))));
    double last = 1;
    for (const double error : {0.0, 0.0001, 0.001, 0.01, 0.1, 1.0, 10.0}) {
        const double share = density.share(error);
        QVERIFY2(share > 0 && share <= last, qPrintable(QString::number(error)));
        QCOMPARE(SiteDensity::of(dataset).share(error), share);
        last = share;
    }
    QVERIFY(density.share(0.3) < (name == "noise" ? 0.95 : 0.1));
}

void SiteDensityTest::smallDataAreNoTrouble()
{
    for (const std::uint32_t size : {2u, 3u, 4u}) {
        QVERIFY(SiteDensity::of(linearDataset({size, size, size})).share(0.01) <= 1);
        QVERIFY(SiteDensity::of(densitySampleOf("scattered", size)).share(0.01) <= 1);
        QVERIFY(SiteDensity::of(densitySampleOf("blunt-body", size)).share(0.01) <= 1);
    }
}

QTEST_APPLESS_MAIN(SiteDensityTest)
#include "site_density_test.moc"
