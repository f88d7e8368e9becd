// SPDX-License-Identifier: GPL-3.0-or-later
// The volume renderer: its parameters become a scene; what is costly is made once.
#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/plugins/renderers/renderer_fixture.h"

#include <tan/mesh.h>
#include <tan/render.h>

using namespace tetra;
using namespace tetra::testing;

namespace {

const TransferFunction step = transferFunctionFromPoints({{0.2, {1, 0, 0}, 0}, {0.2, {0, 1, 0}, 0.5f}}, 0.1);

} // namespace

class VolumeRendererTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsFitTheField()
    {
        const auto parameters = rendererNamed("volume").parameters({{-10, 30}, unitBox});
        for (const auto& parameter : parameters)
            QVERIFY(!parameter.id.empty() && !parameter.label.empty() && !parameter.explanation.empty());
        const auto function = parameterValue<TransferFunction>(parameters, {}, "transfer");
        QVERIFY(checkTransferFunction(function).ok());
        QCOMPARE(function.opacities.front().value, -10.0);
        QCOMPARE(function.opacities.back().value, 30.0);
        QCOMPARE(function.unitDistance, unitBox.diagonal().norm() / 40);
        QVERIFY(!parameterValue<bool>(parameters, {}, "shaded"));
        QVERIFY(parameterValue<bool>(parameters, {}, "outline"));
        QCOMPARE(parameterValue<std::string>(parameters, {}, "clip"), std::string());
    }

    /// As for --help, before there is a model.
    void defaultsOfNothingAreUsable()
    {
        const auto function = parameterValue<TransferFunction>(rendererNamed("volume").parameters({}), {}, "transfer");
        QVERIFY(checkTransferFunction(function).ok());
    }

    void missingValuesAreDefaults()
    {
        const auto mesh = cone(6);
        const auto scene = prepared(*open("volume", mesh), {});
        QVERIFY(partsOf(*scene).volume.has_value());
        QVERIFY(partsOf(*scene).volume->mesh->mesh->tetrahedra == inSpatialOrder(*mesh)->tetrahedra);
        QCOMPARE(partsOf(*scene).volume->transfer->classes.size(), mesh->tetrahedra.size());
        QVERIFY(!partsOf(*scene).volume->shaded);
        QVERIFY(partsOf(*scene).surfaces.empty() && scene->clipPlanes.empty());
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
        QVERIFY(scene->bounds.isApprox(unitBox));
    }

    void valuesBecomeTheScene()
    {
        const auto session = open("volume", cone(6));
        const auto scene = prepared(
            *session, {{"transfer", step}, {"shaded", true}, {"clip", std::string("0,1,0,0.5")}, {"outline", false}});
        QVERIFY(partsOf(*scene).volume->shaded);
        QCOMPARE(partsOf(*scene).volume->transfer->segments.size(), std::size_t(2));
        QVERIFY(partsOf(*scene).lines.empty());
        QCOMPARE(scene->clipPlanes.size(), std::size_t(1));
        QCOMPARE(scene->clipPlanes[0].offset, 0.5);
    }

    void onlyAnotherFunctionIsMadeReady()
    {
        const auto session = open("volume", cone(6));
        const auto first = prepared(*session, {{"transfer", step}});
        const auto lit = prepared(*session, {{"transfer", step}, {"shaded", true}});
        QCOMPARE(partsOf(*lit).volume->mesh, partsOf(*first).volume->mesh);
        QCOMPARE(partsOf(*lit).volume->transfer, partsOf(*first).volume->transfer);
        const auto other = prepared(*session, {});
        QCOMPARE(partsOf(*other).volume->mesh, partsOf(*first).volume->mesh);
        QVERIFY(partsOf(*other).volume->transfer != partsOf(*first).volume->transfer);
    }

    void badValuesAreErrors()
    {
        const auto session = open("volume", cone(6));
        TransferFunction wrong = step;
        wrong.unitDistance = 0;
        QVERIFY(!session->prepare({{{"transfer", wrong}}}, {}).ok());
        QCOMPARE(session->prepare({{{"clip", std::string("0,0,0,0")}}}, {}).error().kind, ErrorKind::WrongUsage);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(session->prepare({}, Progress(stop.get_token(), {})).error().kind, ErrorKind::Cancelled);
        QVERIFY(session->prepare({}, {}).ok());
    }

    void emptyMeshShowsTheOutline()
    {
        const auto scene = prepared(*open("volume", std::make_shared<TetrahedralMesh>()), {});
        QVERIFY(partsOf(*scene).volume->mesh->mesh->tetrahedra.empty());
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
    }

    void showsTheBoundary() { checkBoundary("volume", 0); }
};

QTEST_GUILESS_MAIN(VolumeRendererTest)
#include "volume_renderer_test.moc"
