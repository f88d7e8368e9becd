// SPDX-License-Identifier: GPL-3.0-or-later
// The hybrid renderer: surfaces and volume of one mesh in one scene.
#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/scene_parts.h"
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
        const auto parameters = rendererNamed("hybrid").parameters({{-10, 30}, unitBox});
        for (const char* id : {"transfer", "isovalues", "shaded", "full-gradient", "order", "boundary",
                               "boundary-opacity", "boundary-far-side", "lit", "clip", "outline", "show"})
            QVERIFY2(std::ranges::count(parameters, id, &Parameter::id) == 1, id);
        QCOMPARE(parameters.size(), std::size_t(12));
        QCOMPARE(rendererNamed("hybrid").parameters({.hasSamples = false}).size(), std::size_t(11));
        const auto order = std::ranges::find(parameters, "order", &Parameter::id);
        QCOMPARE(order->choices, (std::vector<std::string>{"exact", "with-cell"}));
        QCOMPARE(std::get<std::string>(order->defaultValue), std::string("exact"));
    }

    void surfacesLieInTheVolume()
    {
        const auto mesh = cone(8);
        const auto session = open("hybrid", mesh);
        const auto scene = prepared(*session, {});
        QCOMPARE(partsOf(*scene).surfaces.size(), std::size_t(1));
        QVERIFY(!partsOf(*scene).surfaces[0].mesh->triangles.empty());
        QVERIFY(partsOf(*scene).volume->mesh->mesh->tetrahedra == inSpatialOrder(*mesh)->tetrahedra);
        QVERIFY(!partsOf(*scene).wholeCells);
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
    }

    void valuesBecomeTheScene()
    {
        const auto session = open("hybrid", cone(8));
        const std::vector<Isovalue> isovalues = {{0.2, 1, 0, 0, 0.25f, true}, {0.4, 0, 1, 0, 1, true}};
        const ParameterValues values = {{"isovalues", isovalues},
                                        {"shaded", true},
                                        {"order", std::string("with-cell")},
                                        {"clip", std::string("0,1,0,0.5")},
                                        {"outline", false}};
        const auto scene = prepared(*session, values);
        QCOMPARE(partsOf(*scene).surfaces.size(), std::size_t(2));
        QCOMPARE(partsOf(*scene).surfaces[0].opacity, 0.25f);
        QVERIFY(partsOf(*scene).volume->shaded);
        QVERIFY(partsOf(*scene).wholeCells);
        QCOMPARE(scene->clipPlanes.size(), std::size_t(1));
        QVERIFY(partsOf(*scene).lines.empty());

        const auto again = prepared(*session, {{"isovalues", isovalues}});
        QCOMPARE(partsOf(*again).surfaces[1].mesh, partsOf(*scene).surfaces[1].mesh);
        QCOMPARE(partsOf(*again).volume->mesh, partsOf(*scene).volume->mesh);
        QCOMPARE(partsOf(*again).volume->transfer, partsOf(*scene).volume->transfer);
    }

    void badValuesAreErrors()
    {
        const auto session = open("hybrid", cone(8));
        const auto order = session->prepare({{{"order", std::string("random")}}}, {});
        QCOMPARE(order.error().kind, ErrorKind::WrongUsage);
        QVERIFY(order.error().text().find("'random'") != std::string::npos);
        QCOMPARE(session->prepare({{{"clip", std::string("0,0,0,0")}}}, {}).error().kind, ErrorKind::WrongUsage);
        QVERIFY(!session->prepare({{{"transfer", TransferFunction{{}, {}, -1}}}}, {}).ok());
    }

    void reportsBothParts()
    {
        double last = 0;
        bool falls = false;
        const Progress progress({}, [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(open("hybrid", cone(8))->prepare({}, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
    }

    void showsTheBoundary() { checkBoundary("hybrid", 1); }
};

QTEST_GUILESS_MAIN(HybridRendererTest)
#include "hybrid_renderer_test.moc"
