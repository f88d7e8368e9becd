// SPDX-License-Identifier: GPL-3.0-or-later
// The isosurface renderer: its parameters become a scene.
#include "tests/core/render/scene_parts.h"
#include "tests/plugins/renderers/renderer_fixture.h"

using namespace tetra;
using namespace tetra::testing;

class IsosurfaceRendererTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsFitTheRange()
    {
        const auto parameters = rendererNamed("isosurface").parameters({{-10, 30}});
        QCOMPARE(parameters.size(), std::size_t(8));
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
        const auto session = open("isosurface", cone(12));
        const auto scene = prepared(*session, {});
        QCOMPARE(partsOf(*scene).surfaces.size(), std::size_t(1));
        QVERIFY(!partsOf(*scene).surfaces[0].mesh->triangles.empty());
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
        QCOMPARE(partsOf(*scene).lines[0].segments.size(), std::size_t(12));
        QVERIFY(scene->bounds.isApprox(unitBox));
    }

    void valuesBecomeTheScene()
    {
        const auto session = open("isosurface", cone(12));
        const std::vector<Isovalue> isovalues = {{0.2, 1, 0, 0, 0.25f, true}, {0.4, 0, 1, 0, 1, true}};
        const auto scene = prepared(
            *session, {{"isovalues", isovalues}, {"clip", std::string("1,0,0,0.5;0,0,-1,-0.25")}, {"outline", false}});
        QCOMPARE(partsOf(*scene).surfaces.size(), std::size_t(2));
        QCOMPARE(partsOf(*scene).surfaces[0].opacity, 0.25f);
        QVERIFY(partsOf(*scene).surfaces[1].mesh->triangles.size() >
                partsOf(*scene).surfaces[0].mesh->triangles.size());
        QVERIFY(partsOf(*scene).lines.empty() && !partsOf(*scene).volume);
        QCOMPARE(scene->clipPlanes.size(), std::size_t(2));
        QCOMPARE(scene->clipPlanes[1].normal, Eigen::Vector3d(0, 0, -1));
        QCOMPARE(scene->clipPlanes[1].offset, -0.25);
        const auto again = prepared(*session, {{"isovalues", isovalues}});
        QCOMPARE(partsOf(*again).surfaces[0].mesh, partsOf(*scene).surfaces[0].mesh);
    }

    void badValuesAreErrors()
    {
        const auto session = open("isosurface", cone(12));
        const std::vector<Isovalue> opaque = {{0.2, 1, 0, 0, 1.5f, true}};
        QCOMPARE(session->prepare({{{"isovalues", opaque}}}, {}).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(session->prepare({{{"clip", std::string("up")}}}, {}).error().kind, ErrorKind::WrongUsage);
    }

    void emptyMeshShowsTheOutline()
    {
        const auto session = open("isosurface", std::make_shared<TetrahedralMesh>());
        const auto scene = prepared(*session, {});
        QCOMPARE(partsOf(*scene).surfaces.size(), std::size_t(1));
        QVERIFY(partsOf(*scene).surfaces[0].mesh->triangles.empty());
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
    }

    void showsTheBoundary() { checkBoundary("isosurface", 1); }
};

QTEST_GUILESS_MAIN(IsosurfaceRendererTest)
#include "isosurface_renderer_test.moc"
