// SPDX-License-Identifier: GPL-3.0-or-later
// The isosurface renderer: its parameters become a scene.
#include "plugins/renderers/isosurface/isosurface_renderer.h"
#include "tests/plugins/renderers/renderer_fixture.h"

using namespace tetra;
using namespace tetra::testing;

class IsosurfaceRendererTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsFitTheRange()
    {
        const auto parameters = IsosurfaceRenderer().parameters({{-10, 30}});
        QCOMPARE(parameters.size(), std::size_t(7));
        QCOMPARE(parameters[0].id, std::string("isovalues"));
        const auto isovalues = parameterValue<std::vector<Isovalue>>(parameters, {}, "isovalues");
        QCOMPARE(isovalues.size(), std::size_t(1));
        QCOMPARE(isovalues[0].value, 10.0);
        QCOMPARE(parameters[0].minimum, -10.0);
        QCOMPARE(parameters[0].maximum, 30.0);
        QVERIFY(parameterValue<bool>(parameters, {}, "outline"));
        for (const auto& parameter : parameters)
            QVERIFY(!parameter.label.empty() && !parameter.explanation.empty());
    }

    void missingValuesAreDefaults()
    {
        const auto session = IsosurfaceRenderer().open(cone(12), unitBox);
        const auto scene = prepared(*session, {});
        QCOMPARE(scene->surfaces.size(), std::size_t(1));
        QVERIFY(!scene->surfaces[0].mesh->triangles.empty());
        QCOMPARE(scene->lines.size(), std::size_t(1));
        QCOMPARE(scene->lines[0].segments.size(), std::size_t(12));
        QVERIFY(scene->bounds.isApprox(unitBox));
    }

    void valuesBecomeTheScene()
    {
        const auto session = IsosurfaceRenderer().open(cone(12), unitBox);
        const std::vector<Isovalue> isovalues = {{0.2, 1, 0, 0, 0.25f, true}, {0.4, 0, 1, 0, 1, true}};
        const auto scene = prepared(
            *session, {{"isovalues", isovalues}, {"clip", std::string("1,0,0,0.5;0,0,-1,-0.25")}, {"outline", false}});
        QCOMPARE(scene->surfaces.size(), std::size_t(2));
        QCOMPARE(scene->surfaces[0].opacity, 0.25f);
        QVERIFY(scene->surfaces[1].mesh->triangles.size() > scene->surfaces[0].mesh->triangles.size());
        QVERIFY(scene->lines.empty() && !scene->volume);
        QCOMPARE(scene->clipPlanes.size(), std::size_t(2));
        QCOMPARE(scene->clipPlanes[1].normal, Eigen::Vector3d(0, 0, -1));
        QCOMPARE(scene->clipPlanes[1].offset, -0.25);
        const auto again = prepared(*session, {{"isovalues", isovalues}});
        QCOMPARE(again->surfaces[0].mesh, scene->surfaces[0].mesh);
    }

    void badValuesAreErrors()
    {
        const auto session = IsosurfaceRenderer().open(cone(12), unitBox);
        const std::vector<Isovalue> opaque = {{0.2, 1, 0, 0, 1.5f, true}};
        QCOMPARE(session->prepare({{"isovalues", opaque}}, {}, {}).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(session->prepare({{"clip", std::string("up")}}, {}, {}).error().kind, ErrorKind::WrongUsage);
    }

    void emptyMeshShowsTheOutline()
    {
        const auto session = IsosurfaceRenderer().open(std::make_shared<TetrahedralMesh>(), unitBox);
        const auto scene = prepared(*session, {});
        QCOMPARE(scene->surfaces.size(), std::size_t(1));
        QVERIFY(scene->surfaces[0].mesh->triangles.empty());
        QCOMPARE(scene->lines.size(), std::size_t(1));
    }

    void showsTheBoundary() { checkBoundary(IsosurfaceRenderer(), 1); }

    void pluginLoads() { checkRendererPlugin(TAN_PLUGIN_FILE, "isosurface"); }
};

QTEST_GUILESS_MAIN(IsosurfaceRendererTest)
#include "isosurface_renderer_test.moc"
