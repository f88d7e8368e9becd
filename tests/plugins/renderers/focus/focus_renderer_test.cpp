// SPDX-License-Identifier: GPL-3.0-or-later
// The focus renderer: two meshes become two volumes of one transfer function (R24).
#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/plugins/renderers/renderer_fixture.h"

#include <tan/render.h>

using namespace tetra;
using namespace tetra::testing;

namespace {

const Sphere ball{{0.5, 0.5, 0.5}, 0.25};
const TransferFunction step = transferFunctionFromPoints({{0.2, {1, 0, 0}, 0}, {0.2, {0, 1, 0}, 0.5f}}, 0.1);

std::size_t cellsOf(const Volume& volume)
{
    return volume.mesh->mesh->tetrahedra.size();
}

} // namespace

class FocusRendererTest : public QObject {
    Q_OBJECT

private slots:
    void withoutAFocusItIsAVolume()
    {
        const auto mesh = cone(4);
        QVERIFY(rendererNamed("focus").needs().focusMesh);
        const auto scene = prepared(*open("focus", mesh), {});
        QCOMPARE(cellsOf(*partsOf(*scene).volume), mesh->tetrahedra.size());
        QVERIFY(!partsOf(*scene).focus);
    }

    void bothMeshesAreInTheScene()
    {
        const auto coarse = cone(3), fine = cone(6);
        const auto session = open("focus", coarse, FocusMesh{fine, {{ball, 0.1}}});
        const auto scene = prepared(*session, {{"transfer", step}, {"shaded", true}});
        QCOMPARE(cellsOf(*partsOf(*scene).volume), coarse->tetrahedra.size());
        QCOMPARE(cellsOf(partsOf(*scene).focus->fine), fine->tetrahedra.size());
        QVERIFY(partsOf(*scene).volume->shaded && partsOf(*scene).focus->fine.shaded);
        QCOMPARE(partsOf(*scene).focus->fine.transfer->classes.size(), fine->tetrahedra.size());
        QCOMPARE(partsOf(*scene).focus->border, 0.1);
        QVERIFY(std::get<Sphere>(partsOf(*scene).focus->region) == ball);
    }

    /// C5: both meshes' isosurfaces, each with its share, alone or in the volumes.
    void surfacesOfBothMeshes()
    {
        const std::vector<FocusRegion> regions{{ball, 0.1}, {Box{{0.8, 0.8, 0.8}, {1, 1, 1}}, 0.05}};
        const auto session = open("focus", cone(3), FocusMesh{cone(6), regions});
        const std::vector<Isovalue> isovalues{{.value = 0.3}, {.value = 0.4, .visible = false}, {.value = 0.5}};
        QVERIFY(partsOf(*prepared(*session, {{"isovalues", isovalues}})).surfaces.empty());
        for (const bool both : {true, false}) {
            const auto scene =
                prepared(*session, {{"shows", std::string(both ? "both" : "surfaces")}, {"isovalues", isovalues}});
            const SceneParts parts = partsOf(*scene);
            QCOMPARE(parts.focus.has_value(), both);
            QCOMPARE(parts.surfaces.size(), std::size_t(4));
            for (std::size_t i = 0; i < 4; ++i) {
                QVERIFY(parts.surfaces[i].share && parts.surfaces[i].share->regions == regions);
                QCOMPARE(parts.surfaces[i].share->fine, i >= 2);
            }
            QVERIFY(parts.surfaces[2].mesh->triangles.size() > parts.surfaces[0].mesh->triangles.size());
            QVERIFY(drawableOf(*scene, "isosurface-1") && drawableOf(*scene, "focus-isosurface-3"));
        }
        const auto alone = open("focus", cone(3));
        const auto scene = prepared(*alone, {{"shows", std::string("surfaces")}, {"isovalues", isovalues}});
        QCOMPARE(partsOf(*scene).surfaces.size(), std::size_t(2));
        QVERIFY(!partsOf(*scene).surfaces[0].share);
    }

    void meshesAreMadeReadyOnce()
    {
        const auto session = open("focus", cone(3), FocusMesh{cone(6), {{ball, 0.1}}});
        const auto first = prepared(*session, {});
        const auto second = prepared(*session, {{"transfer", step}});
        QCOMPARE(partsOf(*first).volume->mesh, partsOf(*second).volume->mesh);
        QCOMPARE(partsOf(*first).focus->fine.mesh, partsOf(*second).focus->fine.mesh);
        QVERIFY(partsOf(*first).focus->fine.transfer != partsOf(*second).focus->fine.transfer);
    }

    void wrongClipPlanesAreAnError()
    {
        const auto session = open("focus", cone(3), FocusMesh{cone(6), {{ball, 0.1}}});
        const auto scene = session->prepare({{{"clip", std::string("1,2")}}}, {});
        QVERIFY(!scene && !scene.error().text().empty());
    }

    void showsTheBoundary() { checkBoundary("focus", 0); }
};

QTEST_GUILESS_MAIN(FocusRendererTest)
#include "focus_renderer_test.moc"
