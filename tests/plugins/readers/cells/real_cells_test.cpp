// SPDX-License-Identifier: GPL-3.0-or-later
// The real irregular datasets are read as their description says (R1, S6). Skipped without them.
#include "core/mesh/topology.h"
#include "plugins/readers/cells/cells_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"

#include <QElapsedTimer>
#include <QTest>

#include <Eigen/Geometry>

#include <set>

using namespace tetra;

namespace {

const std::filesystem::path data = std::filesystem::path(TAN_SOURCE_DIR) / "../shared/data";

/// Vertices - edges + faces of the boundary, by sets.
int boundaryEuler(const Dataset& dataset)
{
    std::set<Triangle> faces;
    for (const auto& t : *dataset.tetrahedra)
        for (std::size_t left = 0; left < 4; ++left) {
            Triangle face = {t[(left + 1) % 4], t[(left + 2) % 4], t[(left + 3) % 4]};
            std::ranges::sort(face);
            if (!faces.insert(face).second)
                faces.erase(face);
        }
    std::set<std::uint32_t> vertices;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& [a, b, c] : faces) {
        vertices.insert({a, b, c});
        edges.insert({{a, b}, {a, c}, {b, c}});
    }
    return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size());
}

double volumeOf(const Dataset& dataset)
{
    double volume = 0;
    for (const auto& [a, b, c, d] : *dataset.tetrahedra) {
        const auto& p = *dataset.positions;
        volume += (p[b] - p[a]).dot((p[c] - p[a]).cross(p[d] - p[a])) / 6;
    }
    return volume;
}

} // namespace

class RealCellsTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreThoseOfTheDescription_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("tetrahedra");
        QTest::addColumn<double>("smallest");
        QTest::addColumn<double>("largest");
        QTest::addColumn<double>("volume");
        QTest::addColumn<int>("euler");
        QTest::newRow("spx.inp") << "irregular/spx.inp" << 2896 << 12935 << 0.2 << 1.0 << 118.379 << 0;
        QTest::newRow("spx") << "irregular/spx.vtu" << 2896 << 12935 << 0.2 << 1.0 << 118.379 << 0;
        QTest::newRow("bracket 57k") << "irregular/bracket_57k.vtu" << 16468 << 56786 << 0.014369 << 20.8720 << 7.41372
                                     << -16;
        QTest::newRow("bracket 454k") << "irregular/bracket_454k.vtu" << 102578 << 454288 << 0.014369 << 23.2680
                                      << 7.40810 << -16;
        QTest::newRow("disk") << "irregular/disk_out_ref_tet.vtu" << 8499 << 44832 << 293.15 << 913.15 << 1629.657 << 2;
        QTest::newRow("fin") << "bluntfin/bluntfin_tet.vtu" << 40921 << 187318 << 0.1926 << 4.9775 << 931.163 << 2;
        QTest::newRow("post") << "post/post_tet.vtu" << 108300 << 616050 << -0.2166 << 1.7583 << 3399.662 << 0;
    }
    void numbersAreThoseOfTheDescription()
    {
        QFETCH(const QString, file);
        QFETCH(const int, points);
        QFETCH(const int, tetrahedra);
        QFETCH(const double, smallest);
        QFETCH(const double, largest);
        QFETCH(const double, volume);
        QFETCH(const int, euler);
        const std::filesystem::path path = data / file.toStdString();
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("data");
        QElapsedTimer timer;
        timer.start();
        const auto dataset = asLoaded<CellsReader>().read(path, {}, {});
        qInfo("read in %lld ms", timer.elapsed());
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), points);
        QCOMPARE(dataset->tetrahedra->size(), tetrahedra);
        const auto near = [](double value, double expected, double relative) {
            return std::abs(value - expected) <= relative * std::max(1.0, std::abs(expected));
        };
        QVERIFY(near(dataset->values.range().minimum, smallest, 1e-4));
        QVERIFY(near(dataset->values.range().maximum, largest, 1e-4));
        QVERIFY2(near(volumeOf(*dataset), volume, 5e-6), qPrintable(QString::number(volumeOf(*dataset), 'g', 9)));
        QCOMPARE(boundaryEuler(*dataset), euler);
    }

    /// S6: note 7 of the description.
    void superPhoenixIsMended()
    {
        const std::filesystem::path path = data / "irregular/spx.inp";
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("data");
        const auto dataset = asLoaded<CellsReader>().read(path, {}, {});
        QVERIFY(dataset.ok());
        QCOMPARE(dataset->remarks.size(), 2);
        QVERIFY(dataset->remarks[0].text().starts_with("1 cell uses a corner twice"));
        QVERIFY(dataset->remarks[1].text().starts_with("12924 cells had inverted orientation and were corrected"));
    }
};

QTEST_GUILESS_MAIN(RealCellsTest)
#include "real_cells_test.moc"
