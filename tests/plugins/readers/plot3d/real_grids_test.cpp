// SPDX-License-Identifier: GPL-3.0-or-later
// The real PLOT3D datasets are read as their description says (R1, S6). Skipped without them.
#include "plugins/readers/plot3d/plot3d_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"

#include <QTest>

#include <set>

using namespace tetra;

namespace {

const std::filesystem::path data = std::filesystem::path(TAN_SOURCE_DIR) / "../shared/data";

std::size_t distinctPlaces(const Dataset& dataset)
{
    std::set<std::array<double, 3>> places;
    for (const Eigen::Vector3d& position : *dataset.positions)
        places.insert({position[0], position[1], position[2]});
    return places.size();
}

} // namespace

class RealGridsTest : public QObject {
    Q_OBJECT

private slots:
    void rangesAreThoseOfTheDescription_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("array");
        QTest::addColumn<double>("smallest");
        QTest::addColumn<double>("largest");
        QTest::newRow("fin, density") << "bluntfin/bluntfinxyz.bin"
                                      << "automatic" << 0.1926 << 4.9775;
        QTest::newRow("fin, energy") << "bluntfin/bluntfinxyz.bin"
                                     << "energy" << 0.76896 << 25.161;
        QTest::newRow("fin, pressure") << "bluntfin/bluntfinxyz.bin"
                                       << "pressure" << 0.2595 << 10.0127;
        QTest::newRow("fin, speed") << "bluntfin/bluntfinxyz.bin"
                                    << "velocity_magnitude" << 0. << 3.1229;
        QTest::newRow("fin, by its solution") << "bluntfin/bluntfinq.bin"
                                              << "density" << 0.1926 << 4.9775;
        QTest::newRow("post, pressure") << "post/postxyz.bin"
                                        << "automatic" << -0.2166 << 1.7583;
        QTest::newRow("post, speed") << "post/postxyz.bin"
                                     << "velocity_magnitude" << 0. << 1.3914;
        QTest::newRow("post, energy") << "post/postxyz.bin"
                                      << "energy" << -0.5415 << 4.3958;
        QTest::newRow("post, momentum") << "post/postxyz.bin"
                                        << "momentum_x" << -0.215 << 1.362;
    }
    void rangesAreThoseOfTheDescription()
    {
        QFETCH(QString, file);
        QFETCH(QString, array);
        QFETCH(double, smallest);
        QFETCH(double, largest);
        const std::filesystem::path path = data / file.toStdString();
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("data");
        const auto dataset = asLoaded<Plot3dReader>().read(path, {{"array", array.toStdString()}}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(std::abs(dataset->values.range().minimum - smallest) < 6e-4);
        QVERIFY(std::abs(dataset->values.range().maximum - largest) < 6e-4);
        QCOMPARE(dataset->values.type(), SampleType::Float32);
    }

    void placesAreThoseOfTheDescription()
    {
        if (!std::filesystem::exists(data / "bluntfin/bluntfinxyz.bin") ||
            !std::filesystem::exists(data / "post/postxyz.bin"))
            QSKIP_WITHOUT("data");
        const auto fin = asLoaded<Plot3dReader>().read(data / "bluntfin/bluntfinxyz.bin", {}, {});
        QVERIFY(fin.ok());
        QCOMPARE(fin->lattice.size, (std::array<std::uint32_t, 3>{40, 32, 32}));
        QCOMPARE(distinctPlaces(*fin), std::size_t(40921)); // a whole line on one place
        QVERIFY((fin->bounds().min() - Eigen::Vector3d(-7.816, 0, 0)).norm() < 1e-3);
        QVERIFY((fin->bounds().max() - Eigen::Vector3d(14.362, 8.328, 5.724)).norm() < 1e-3);
        const auto post = asLoaded<Plot3dReader>().read(data / "post/postxyz.bin", {}, {});
        QVERIFY(post.ok());
        QCOMPARE(post->lattice.size, (std::array<std::uint32_t, 3>{38, 76, 38}));
        QCOMPARE(distinctPlaces(*post), std::size_t(108300)); // wraps around
        QCOMPARE(QString::fromStdString(post->source.name), QString("postxyz.bin, pressure"));
    }

    void thePostHasNoUsableDensity()
    {
        if (!std::filesystem::exists(data / "post/postxyz.bin"))
            QSKIP_WITHOUT("data");
        const auto dataset =
            asLoaded<Plot3dReader>().read(data / "post/postxyz.bin", {{"array", std::string("density")}}, {});
        QVERIFY(!dataset.ok());
        QVERIFY(QString::fromStdString(dataset.error().text()).contains("pressure"));
    }
};

QTEST_GUILESS_MAIN(RealGridsTest)
#include "real_grids_test.moc"
