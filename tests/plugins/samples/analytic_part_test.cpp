// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/samples.h"

#include "core/data/cells/irregular_check.h"

#include <QTest>

#include <set>

using namespace tetra;

namespace {

/// Vertices - edges + faces of the boundary.
int boundaryEuler(const std::vector<std::array<std::uint32_t, 4>>& tetrahedra)
{
    std::set<std::array<std::uint32_t, 3>> faces;
    for (const auto& t : tetrahedra)
        for (std::size_t left = 0; left < 4; ++left) {
            std::array<std::uint32_t, 3> face = {t[(left + 1) % 4], t[(left + 2) % 4], t[(left + 3) % 4]};
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

} // namespace

class AnalyticPartTest : public QObject {
    Q_OBJECT
private slots:
    /// R1: a sound mesh at any size: a surface with five handles, and the sphere of the cavity.
    void soundAtEachSize()
    {
        for (const std::uint32_t size : {2, 16, 24, 32, 40, 64, 100}) {
            const auto dataset = makeSample({.name = "part", .size = size, .type = {}, .seed = 1});
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->domain, DomainClass::Irregular);
            const Status sound = checkIrregular(*dataset);
            QVERIFY2(sound.ok(), sound ? "" : sound.error().text().c_str());
            QCOMPARE(boundaryEuler(*dataset->tetrahedra), 2 - 2 * 5 + 2);
            QVERIFY(dataset->values.range().minimum >= 0 && dataset->values.range().maximum <= 1);
        }
    }

    /// Kirsch: a hole triples the stress beside it; the others of the plate change that somewhat.
    void stressIsLargestBesideHoles()
    {
        const AnalyticMesh mesh = analyticPart(64);
        const auto largest = static_cast<std::size_t>(std::ranges::max_element(mesh.values) - mesh.values.begin());
        QVERIFY(mesh.values[largest] > 0.9 && mesh.values[largest] < 1);
        const Eigen::Vector3d& place = mesh.positions[largest];
        const Eigen::Vector2d fromCentre(std::fmod(place[0], 2.0) - 1, std::fmod(place[1], 2.0) - 1);
        QVERIFY(std::abs(fromCentre.norm() - 0.5) < 1e-6);
        QVERIFY(std::abs(fromCentre[1]) > 0.45);
    }
};

QTEST_GUILESS_MAIN(AnalyticPartTest)
#include "analytic_part_test.moc"
