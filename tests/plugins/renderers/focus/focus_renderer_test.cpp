// SPDX-License-Identifier: GPL-3.0-or-later
// The focus renderer: two meshes become two volumes of one transfer function (R24).
#include "core/render/volume/volume_mesh.h"
#include "plugins/renderers/focus/focus_renderer.h"
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
        QVERIFY(FocusRenderer().blendsFocus());
        const auto scene = prepared(*FocusRenderer().open(mesh, unitBox), {});
        QCOMPARE(cellsOf(*scene->volume), mesh->tetrahedra.size());
        QVERIFY(!scene->focus);
    }

    void bothMeshesAreInTheScene()
    {
        const auto coarse = cone(3), fine = cone(6);
        const auto session = FocusRenderer().openWithFocus(coarse, {fine, ball, 0.1}, unitBox);
        const auto scene = prepared(*session, {{"transfer", step}, {"shaded", true}});
        QCOMPARE(cellsOf(*scene->volume), coarse->tetrahedra.size());
        QCOMPARE(cellsOf(scene->focus->fine), fine->tetrahedra.size());
        QVERIFY(scene->volume->shaded && scene->focus->fine.shaded);
        QCOMPARE(scene->focus->fine.transfer->classes.size(), fine->tetrahedra.size());
        QCOMPARE(scene->focus->border, 0.1);
        QVERIFY(std::get<Sphere>(scene->focus->region) == ball);
    }

    void meshesAreMadeReadyOnce()
    {
        const auto session = FocusRenderer().openWithFocus(cone(3), {cone(6), ball, 0.1}, unitBox);
        const auto first = prepared(*session, {});
        const auto second = prepared(*session, {{"transfer", step}});
        QCOMPARE(first->volume->mesh, second->volume->mesh);
        QCOMPARE(first->focus->fine.mesh, second->focus->fine.mesh);
        QVERIFY(first->focus->fine.transfer != second->focus->fine.transfer);
    }

    void wrongClipPlanesAreAnError()
    {
        const auto session = FocusRenderer().openWithFocus(cone(3), {cone(6), ball, 0.1}, unitBox);
        const auto scene = session->prepare({{"clip", std::string("1,2")}}, {}, {});
        QVERIFY(!scene && !scene.error().text().empty());
    }

    void showsTheBoundary() { checkBoundary(FocusRenderer(), 0); }

    void pluginLoads() { checkRendererPlugin(TAN_PLUGIN_FILE, "focus"); }
};

QTEST_GUILESS_MAIN(FocusRendererTest)
#include "focus_renderer_test.moc"
