// SPDX-License-Identifier: GPL-3.0-or-later
// The hybrid renderer: surfaces and volume of one mesh in one scene.
#include "core/graphics/volume/volume_mesh.h"
#include "core/mesh/spatial_order.h"
#include "plugins/renderers/hybrid/hybrid_renderer.h"
#include "tests/core/graphics/lattice_mesh.h"

#include <QJsonObject>
#include <QPluginLoader>
#include <QTest>

#include <algorithm>

using namespace tetra;
using testing::latticeMesh;
using testing::Split;

namespace {

std::shared_ptr<const TetrahedralMesh> cone()
{
    return std::make_shared<const TetrahedralMesh>(
        latticeMesh(8, 1, Split::Six, [](const Eigen::Vector3d& p) { return (p.array() - 0.5).matrix().norm(); }));
}

const Eigen::AlignedBox3d unitBox(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));

std::shared_ptr<const Scene> prepared(RendererSession& session, const ParameterValues& values)
{
    auto scene = session.prepare(values, {}, {});
    if (!scene)
        qFatal("%s", scene.error().text.c_str());
    return *scene;
}

} // namespace

class HybridRendererTest : public QObject {
    Q_OBJECT

private slots:
    void parametersAreThoseOfBothAndTheOrder()
    {
        const auto parameters = HybridRenderer().parameters({{-10, 30}, unitBox});
        for (const char* id : {"transfer", "isovalues", "shaded", "order", "clip", "outline"})
            QVERIFY2(std::ranges::count(parameters, id, &Parameter::id) == 1, id);
        QCOMPARE(parameters.size(), std::size_t(6));
        const auto order = std::ranges::find(parameters, "order", &Parameter::id);
        QCOMPARE(order->choices, (std::vector<std::string>{"exact", "with-cell"}));
        QCOMPARE(std::get<std::string>(order->defaultValue), std::string("exact"));
    }

    void surfacesLieInTheVolume()
    {
        const auto mesh = cone();
        const auto session = HybridRenderer().open(mesh, unitBox);
        const auto scene = prepared(*session, {});
        QCOMPARE(scene->surfaces.size(), std::size_t(1));
        QVERIFY(!scene->surfaces[0].mesh->triangles.empty());
        QVERIFY(scene->volume->mesh->mesh->tetrahedra == inSpatialOrder(*mesh)->tetrahedra);
        QVERIFY(scene->hybridOrder == HybridOrder::Exact);
        QCOMPARE(scene->lines.size(), std::size_t(1));
    }

    void valuesBecomeTheScene()
    {
        const auto session = HybridRenderer().open(cone(), unitBox);
        const std::vector<Isovalue> isovalues = {{0.2, 1, 0, 0, 0.25f, true}, {0.4, 0, 1, 0, 1, true}};
        const ParameterValues values = {{"isovalues", isovalues},
                                        {"shaded", true},
                                        {"order", std::string("with-cell")},
                                        {"clip", std::string("0,1,0,0.5")},
                                        {"outline", false}};
        const auto scene = prepared(*session, values);
        QCOMPARE(scene->surfaces.size(), std::size_t(2));
        QCOMPARE(scene->surfaces[0].opacity, 0.25f);
        QVERIFY(scene->volume->shaded);
        QVERIFY(scene->hybridOrder == HybridOrder::WithCell);
        QCOMPARE(scene->clipPlanes.size(), std::size_t(1));
        QVERIFY(scene->lines.empty());

        const auto again = prepared(*session, {{"isovalues", isovalues}});
        QCOMPARE(again->surfaces[1].mesh, scene->surfaces[1].mesh);
        QCOMPARE(again->volume->mesh, scene->volume->mesh);
        QCOMPARE(again->volume->transfer, scene->volume->transfer);
    }

    void badValuesAreErrors()
    {
        const auto session = HybridRenderer().open(cone(), unitBox);
        const auto order = session->prepare({{"order", std::string("random")}}, {}, {});
        QCOMPARE(order.error().kind, ErrorKind::WrongUsage);
        QVERIFY(order.error().text.find("'random'") != std::string::npos);
        QCOMPARE(session->prepare({{"clip", std::string("0,0,0,0")}}, {}, {}).error().kind, ErrorKind::WrongUsage);
        QVERIFY(!session->prepare({{"transfer", TransferFunction{{}, -1}}}, {}, {}).ok());
    }

    void reportsBothParts()
    {
        double last = 0;
        bool falls = false;
        const Progress progress({}, [&](double fraction, std::string_view) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(HybridRenderer().open(cone(), unitBox)->prepare({}, {}, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
    }

    void pluginLoads()
    {
        QPluginLoader loader(TAN_PLUGIN_FILE);
        const QJsonObject metadata = loader.metaData().value("MetaData").toObject();
        QCOMPARE(metadata.value("id").toString(), "hybrid");
        QCOMPARE(metadata.value("kind").toString(), "renderer");
        QVERIFY2(loader.instance() != nullptr, qPrintable(loader.errorString()));
        QVERIFY(qobject_cast<Renderer*>(loader.instance()) != nullptr);
    }
};

QTEST_GUILESS_MAIN(HybridRendererTest)
#include "hybrid_renderer_test.moc"
