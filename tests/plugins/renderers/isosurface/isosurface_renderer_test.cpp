// SPDX-License-Identifier: GPL-3.0-or-later
// The isosurface renderer: several isovalues at once, each with its colour and opacity (R19), extracted only once.
#include "core/graphics/isosurface.h"
#include "core/graphics/palette.h"
#include "plugins/renderers/isosurface/isosurface_renderer.h"
#include "tests/core/graphics/lattice_mesh.h"

#include <QJsonObject>
#include <QPluginLoader>
#include <QTest>

#include <cmath>
#include <set>
#include <tuple>

using namespace tetra;
using testing::latticeMesh;
using testing::Split;

namespace {

std::shared_ptr<const TetrahedralMesh> cone()
{
    return std::make_shared<const TetrahedralMesh>(
        latticeMesh(12, 1, Split::Six, [](const Eigen::Vector3d& p) { return (p.array() - 0.5).matrix().norm(); }));
}

const Eigen::AlignedBox3d unitBox(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));

ParameterValues valuesOf(std::vector<Isovalue> isovalues, bool outline = false)
{
    return {{"isovalues", std::move(isovalues)}, {"outline", outline}};
}

Isovalue at(double value)
{
    Isovalue isovalue;
    isovalue.value = value;
    return isovalue;
}

std::shared_ptr<const Scene> prepared(RendererSession& session, const ParameterValues& values)
{
    auto scene = session.prepare(values, {}, {});
    if (!scene)
        qFatal("%s", scene.error().text.c_str());
    return *scene;
}

} // namespace

class IsosurfaceRendererTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsFitTheRange()
    {
        const auto parameters = IsosurfaceRenderer().parameters({{-10, 30}});
        QCOMPARE(parameters.size(), std::size_t(2));
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
        const auto session = IsosurfaceRenderer().open(cone(), unitBox);
        const auto scene = prepared(*session, {});
        QCOMPARE(scene->surfaces.size(), std::size_t(1));
        QVERIFY(!scene->surfaces[0].mesh->triangles.empty());
        QCOMPARE(scene->lines.size(), std::size_t(1));
        QCOMPARE(scene->lines[0].segments.size(), std::size_t(12));
        QVERIFY(scene->bounds.isApprox(unitBox));
    }

    /// Each of several surfaces is just what the extraction gives for its value alone.
    void severalIsovaluesAtOnce()
    {
        const auto mesh = cone();
        const auto gradients = vertexGradients(*mesh);
        const auto session = IsosurfaceRenderer().open(mesh, unitBox);
        const std::vector<Isovalue> isovalues = {at(0.3), {0.2, 1, 0, 0, 0.25f, true}, at(0.4), at(0.3)};
        const auto scene = prepared(*session, valuesOf(isovalues));
        QCOMPARE(scene->surfaces.size(), isovalues.size());
        for (std::size_t i = 0; i < isovalues.size(); ++i) {
            const auto alone = extractIsosurface(*mesh, gradients, isovalues[i].value);
            QVERIFY(alone->positions == scene->surfaces[i].mesh->positions);
            QVERIFY(alone->triangles == scene->surfaces[i].mesh->triangles);
        }
        QCOMPARE(scene->surfaces[1].opacity, 0.25f);
        QCOMPARE(scene->surfaces[1].colour.red, 1.0f);
        QVERIFY(scene->lines.empty());
    }

    void appearanceChangesExtractNothing()
    {
        const auto session = IsosurfaceRenderer().open(cone(), unitBox);
        std::vector<Isovalue> isovalues = {at(0.3), at(0.4)};
        const auto before = prepared(*session, valuesOf(isovalues));
        isovalues[0].opacity = 0.5f;
        isovalues[1].red = 0;
        isovalues.push_back(at(0.2));
        const auto after = prepared(*session, valuesOf(isovalues, true));
        QCOMPARE(after->surfaces[0].mesh, before->surfaces[0].mesh);
        QCOMPARE(after->surfaces[1].mesh, before->surfaces[1].mesh);
        QCOMPARE(after->surfaces[0].opacity, 0.5f);

        isovalues[0].visible = false;
        QCOMPARE(prepared(*session, valuesOf(isovalues))->surfaces.size(), std::size_t(2));
        isovalues[0].visible = true;
        QCOMPARE(prepared(*session, valuesOf(isovalues))->surfaces[0].mesh, before->surfaces[0].mesh);
    }

    void surfacesOfRemovedValuesAreFreed()
    {
        const auto session = IsosurfaceRenderer().open(cone(), unitBox);
        auto scene = prepared(*session, valuesOf({at(0.3), at(0.4)}));
        const std::weak_ptr<const TriangleMesh> removed = scene->surfaces[0].mesh;
        scene = prepared(*session, valuesOf({at(0.4)}));
        QVERIFY(removed.expired());
    }

    void unseenSurfacesAreNotExtracted()
    {
        const auto session = IsosurfaceRenderer().open(cone(), unitBox);
        std::vector<Isovalue> isovalues = {at(0.3), at(0.4)};
        isovalues[0].visible = false;
        isovalues[1].opacity = 0;
        const auto scene = session->prepare(valuesOf(isovalues), {}, {});
        QVERIFY(scene.ok() && (*scene)->surfaces.empty());
    }

    void badValuesAreErrors()
    {
        const auto session = IsosurfaceRenderer().open(cone(), unitBox);
        std::vector<Isovalue> bad(3, at(0.3));
        bad[0].value = std::nan("");
        bad[1].opacity = 1.5f;
        bad[2].opacity = std::nanf("");
        for (const Isovalue& isovalue : bad) {
            const auto scene = session->prepare(valuesOf({at(0.4), isovalue}), {}, {});
            QVERIFY(!scene.ok());
            QCOMPARE(scene.error().kind, ErrorKind::WrongUsage);
        }
    }

    void emptyMeshShowsTheOutline()
    {
        const auto session = IsosurfaceRenderer().open(std::make_shared<TetrahedralMesh>(), unitBox);
        const auto scene = prepared(*session, {});
        QCOMPARE(scene->surfaces.size(), std::size_t(1));
        QVERIFY(scene->surfaces[0].mesh->triangles.empty());
        QCOMPARE(scene->lines.size(), std::size_t(1));
    }

    void reportsAndCancels()
    {
        const auto session = IsosurfaceRenderer().open(cone(), unitBox);
        std::stop_source stop;
        double last = 0;
        bool falls = false;
        const Progress progress(stop.get_token(), [&](double fraction, std::string_view) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(session->prepare(valuesOf({at(0.2), at(0.3), at(0.4)}), {}, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
        stop.request_stop();
        QCOMPARE(session->prepare(valuesOf({at(0.25)}), {}, progress).error().kind, ErrorKind::Cancelled);
        QVERIFY(session->prepare(valuesOf({at(0.25)}), {}, {}).ok());
    }

    void furtherColoursAreDistinct()
    {
        std::set<std::tuple<float, float, float>> seen;
        for (std::size_t i = 0; i < 7; ++i) {
            const Colour colour = distinctColour(i);
            QVERIFY(seen.insert({colour.red, colour.green, colour.blue}).second);
        }
        QCOMPARE(distinctColour(7).red, distinctColour(0).red);
    }

    void pluginLoads()
    {
        QPluginLoader loader(TAN_PLUGIN_FILE);
        const QJsonObject metadata = loader.metaData().value("MetaData").toObject();
        QCOMPARE(metadata.value("id").toString(), "isosurface");
        QCOMPARE(metadata.value("kind").toString(), "renderer");
        QVERIFY2(loader.instance() != nullptr, qPrintable(loader.errorString()));
        QVERIFY(qobject_cast<Renderer*>(loader.instance()) != nullptr);
    }
};

QTEST_GUILESS_MAIN(IsosurfaceRendererTest)
#include "isosurface_renderer_test.moc"
