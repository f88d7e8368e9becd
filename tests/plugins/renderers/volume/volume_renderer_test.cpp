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
        QVERIFY(parameterValue<bool>(parameters, {}, "shaded"));
        QVERIFY(parameterValue<bool>(parameters, {}, "outline"));
        QCOMPARE(parameterValue<std::string>(parameters, {}, "clip"), std::string());
    }

    /// However flat the data are, what is seen through their thinnest side is as opaque as that of a slab of 5:5:1: the
    /// share of light that the largest value lets through there does not go to 1.
    void flatDataAreSeen_data()
    {
        QTest::addColumn<Eigen::Vector3d>("size");
        QTest::addColumn<double>("unit");
        QTest::newRow("a cube") << Eigen::Vector3d(31, 31, 31) << 31 * std::sqrt(3.0) / 40;
        QTest::newRow("4:4:1") << Eigen::Vector3d(4, 4, 1) << std::sqrt(33.0) / 40;
        for (const double thickness : {1.0, 0.1, 1e-3, 1e-6})
            QTest::addRow("a slab, %g thick", thickness) << Eigen::Vector3d(31, 31, thickness) << thickness / 6;
        QTest::newRow("a rod") << Eigen::Vector3d(2, 400, 2) << 2.0 / 6;
        QTest::newRow("without thickness") << Eigen::Vector3d(3, 4, 0) << 5.0 / 40;
    }
    void flatDataAreSeen()
    {
        QFETCH(Eigen::Vector3d, size);
        QFETCH(double, unit);
        const Eigen::Vector3d corner(100, -3, 5);
        const auto parameters = rendererNamed("volume").parameters({{0, 1}, {corner, corner + size}});
        const auto function = parameterValue<TransferFunction>(parameters, {}, "transfer");
        QVERIFY2(std::abs(function.unitDistance / unit - 1) < 1e-6, qPrintable(QString::number(function.unitDistance)));
        const double least = size.minCoeff();
        const double opacity = -std::expm1(-evaluate(function, 1).extinction * least);
        QVERIFY2(least == 0 || opacity > 0.5, qPrintable(QString::number(opacity)));
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
        QVERIFY(partsOf(*scene).volume->shaded);
        QVERIFY(partsOf(*scene).surfaces.empty() && scene->clipPlanes.empty());
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
        QVERIFY(scene->bounds.isApprox(unitBox));
    }

    void valuesBecomeTheScene()
    {
        const auto session = open("volume", cone(6));
        const auto scene = prepared(
            *session, {{"transfer", step}, {"shaded", false}, {"clip", std::string("0,1,0,0.5")}, {"outline", false}});
        QVERIFY(!partsOf(*scene).volume->shaded);
        QCOMPARE(partsOf(*scene).volume->transfer->segments.size(), std::size_t(2));
        QVERIFY(partsOf(*scene).lines.empty());
        QCOMPARE(scene->clipPlanes.size(), std::size_t(1));
        QCOMPARE(scene->clipPlanes[0].offset, 0.5);
    }

    void onlyAnotherFunctionIsMadeReady()
    {
        const auto session = open("volume", cone(6));
        const auto first = prepared(*session, {{"transfer", step}});
        const auto unlit = prepared(*session, {{"transfer", step}, {"shaded", false}});
        QCOMPARE(partsOf(*unlit).volume->mesh, partsOf(*first).volume->mesh);
        QCOMPARE(partsOf(*unlit).volume->transfer, partsOf(*first).volume->transfer);
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
