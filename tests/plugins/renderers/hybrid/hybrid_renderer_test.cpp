// SPDX-License-Identifier: GPL-3.0-or-later
// The hybrid renderer: surfaces and volume of one mesh in one scene.
#include "core/render/volume/volume_mesh.h"
#include "plugins/renderers/hybrid/hybrid_renderer.h"
#include "tests/plugins/renderers/renderer_fixture.h"

#include <tan/mesh.h>
#include <tan/render.h>

#include <algorithm>

using namespace tetra;
using namespace tetra::testing;

class HybridRendererTest : public QObject {
    Q_OBJECT

private slots:
    void parametersAreThoseOfBothAndTheOrder()
    {
        const auto parameters = HybridRenderer().parameters({{-10, 30}, unitBox});
        for (const char* id : {"transfer", "isovalues", "shaded", "order", "boundary", "boundary-opacity",
                               "boundary-far-side", "clip", "outline"})
            QVERIFY2(std::ranges::count(parameters, id, &Parameter::id) == 1, id);
        QCOMPARE(parameters.size(), std::size_t(9));
        const auto order = std::ranges::find(parameters, "order", &Parameter::id);
        QCOMPARE(order->choices, (std::vector<std::string>{"exact", "with-cell"}));
        QCOMPARE(std::get<std::string>(order->defaultValue), std::string("exact"));
    }

    void surfacesLieInTheVolume()
    {
        const auto mesh = cone(8);
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
        const auto session = HybridRenderer().open(cone(8), unitBox);
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
        const auto session = HybridRenderer().open(cone(8), unitBox);
        const auto order = session->prepare({{"order", std::string("random")}}, {}, {});
        QCOMPARE(order.error().kind, ErrorKind::WrongUsage);
        QVERIFY(order.error().text().find("'random'") != std::string::npos);
        QCOMPARE(session->prepare({{"clip", std::string("0,0,0,0")}}, {}, {}).error().kind, ErrorKind::WrongUsage);
        QVERIFY(!session->prepare({{"transfer", TransferFunction{{}, {}, -1}}}, {}, {}).ok());
    }

    void reportsBothParts()
    {
        double last = 0;
        bool falls = false;
        const Progress progress({}, [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(HybridRenderer().open(cone(8), unitBox)->prepare({}, {}, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
    }

    void showsTheBoundary() { checkBoundary(HybridRenderer(), 1); }

    void pluginLoads() { checkRendererPlugin(TAN_PLUGIN_FILE, "hybrid"); }
};

QTEST_GUILESS_MAIN(HybridRendererTest)
#include "hybrid_renderer_test.moc"
