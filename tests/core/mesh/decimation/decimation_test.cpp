// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/decimation.h"

#include "tests/core/mesh/decimation/decimation_check.h"

#include <QTest>

using namespace tetra;

namespace {

QByteArray faultAt(const std::string& fault, std::size_t sites, std::uint32_t seed)
{
    return QByteArray::fromStdString(fault + ", at " + std::to_string(sites) + " sites, seed " + std::to_string(seed));
}

void compareSound(const TestMesh& mesh, const DecimationOptions& options, std::uint32_t seed, std::size_t step)
{
    RecordedHistory history;
    const auto result = decimate(mesh.view(), options, history);
    QVERIFY2(result, result ? "" : result.error().text.c_str());
    QVERIFY(!history.traits.delaunay);
    QCOMPARE(history.points.size(), mesh.positions.size());
    QCOMPARE(history.finalError, 0.0f);
    const TetrahedraTopology original = topologyOf(mesh.tetrahedra);
    for (std::size_t sites = result->initialSites; sites <= mesh.positions.size(); sites += step) {
        const std::string fault = prefixFault(mesh, history, sites, original);
        QVERIFY2(fault.empty(), faultAt(fault, sites, seed).constData());
    }
    const std::string last = prefixFault(mesh, history, mesh.positions.size(), original);
    QVERIFY2(last.empty(), last.c_str());
}

} // namespace

class DecimationTest : public QObject {
    Q_OBJECT

private slots:
    void latticesKeepTheirBox();
    void nonconvexMeshesStaySound();
};

void DecimationTest::latticesKeepTheirBox()
{
    for (std::uint32_t seed = 0; seed < 6; ++seed)
        compareSound(latticeMesh({5 + seed % 3, 6, 5}, seed % 2 == 0 ? LatticeCut::Five : LatticeCut::Six, seed), {},
                     seed, 7);
}

void DecimationTest::nonconvexMeshesStaySound()
{
    DecimationOptions options;
    options.warpingWeight = 1;
    for (std::uint32_t seed = 0; seed < 500; ++seed)
        compareSound(nonconvexMesh(seed, seed % 3 == 0 ? 0 : .15), options, seed, seed % 25 == 0 ? 5 : 45);
}

QTEST_GUILESS_MAIN(DecimationTest)
#include "decimation_test.moc"
