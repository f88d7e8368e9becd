// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/mesh_saving.h"
#include "core/picture/png_file.h"
#include "plugins/host/plugin_guards.h"
#include "tests/core/render/scene_parts.h"
#include "tests/ui/sample_files.h"
#include "ui/scenes/picture_image.h"
#include "ui/scenes/scene_builder.h"
#include "ui/workbench/film_file.h"

#include <tan/query.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>
#include <stop_token>

using namespace tetra;

/// From the session's wishes to a scene, in a worker (R17, R19).
class SceneBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theNewestRequestIsTheLastToArrive();
    void theMeshIsExtractedOnlyWhenItChanges();
    void aRangeIsFilteredAsItIs();
    void nothingArrivesAfterClear();
    void aFailureIsTold();
    void onlyScenesThatDependOnTheViewAreMadeAnewForIt();
    void whatARendererThrowsIsTold();
    void theSurfacesOfAnotherRendererAreSaved();
    void aFormatThatNobodyWritesIsRefusedFirst();
    void theShapeOfASurfaceMayTakeLong();
    void aPictureThatCannotBeHeldIsNone();

private:
    SceneRequest request(double percent, std::vector<Isovalue> isovalues) const;

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    std::shared_ptr<const Model> model_;
};

void SceneBuilderTest::initTestCase()
{
    host_ = hostOfThisBuild();
    const auto model = Model::open(buildSampleModel(*host_, sampleDataset(32), folder_.path().toStdString()));
    QVERIFY(model.ok());
    model_ = *model;
}

SceneRequest SceneBuilderTest::request(double percent, std::vector<Isovalue> isovalues) const
{
    SceneRequest request;
    request.model = model_;
    request.renderer = host_->renderer("isosurface")->plugin;
    request.query.error = percent;
    request.values["isovalues"] = std::move(isovalues);
    return request;
}

void SceneBuilderTest::theNewestRequestIsTheLastToArrive()
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    for (const double percent : {4.0, 2.0, 1.0, 0.5, 0.1})
        builder.request(request(percent, {Isovalue{100}}));
    QVERIFY(builder.busy());
    QTRY_VERIFY(!builder.busy());
    const auto last = ready.last()[0].value<BuiltScene>();
    const MeshSize wanted = meshSizeAt(*model_, {0.1});
    QCOMPARE(last.mesh.vertices, std::uint64_t{wanted.sites});
    QCOMPARE(last.mesh.tetrahedra, wanted.tetrahedra);
    QCOMPARE(last.mesh.wholeTetrahedra, wanted.tetrahedra);
    QVERIFY(last.triangles > 0);
    QCOMPARE(testing::partsOf(*last.scene).surfaces.size(), std::size_t{1});
    // The first had begun when the others came, of which only the last is of interest still.
    QVERIFY2(ready.count() <= 2, qPrintable(QString::number(ready.count())));
}

void SceneBuilderTest::theMeshIsExtractedOnlyWhenItChanges()
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    builder.request(request(1, {Isovalue{100}}));
    QTRY_COMPARE(ready.count(), 1);
    QVERIFY(ready.last()[0].value<BuiltScene>().extractionSeconds > 0);
    builder.request(request(1, {Isovalue{100}, Isovalue{150}}));
    QTRY_COMPARE(ready.count(), 2);
    QCOMPARE(ready.last()[0].value<BuiltScene>().extractionSeconds, 0.0);
    QCOMPARE(testing::partsOf(*ready.last()[0].value<BuiltScene>().scene).surfaces.size(), std::size_t{2});
}

/// What is loaded of a range is filtered by births and deaths (R17, C2): of what is alive at an error the surface is
/// that of its mesh, and nothing is extracted for it. A volume of tetrahedra over each other is refused.
void SceneBuilderTest::aRangeIsFilteredAsItIs()
{
    ScenePipeline pipeline;
    SceneRequest ofRange = request(0, {{120}});
    ofRange.query.range = LifeRange{{8}, {1}};
    const auto all = pipeline.make(ofRange, {});
    QVERIFY(all.ok());
    QVERIFY(pipeline.mesh()->overlaps);
    bool extracts = false;
    const Progress progress({}, [&](double, const Message& activity) {
        extracts = extracts || activity.text() == "Extracting a range of meshes";
    });
    ofRange.query.range->births.minimum = 2;
    ofRange.query.range->deaths.maximum = 2;
    const auto alive = pipeline.make(ofRange, progress);
    QVERIFY(alive.ok() && !extracts);
    const auto uniform = ScenePipeline().make(request(2, {{120}}), {});
    QVERIFY(uniform.ok());
    QCOMPARE(alive->mesh.tetrahedra, uniform->mesh.tetrahedra);
    QCOMPARE(alive->triangles, uniform->triangles);
    QVERIFY(alive->triangles < all->triangles);
    ofRange.renderer = host_->renderer("volume")->plugin;
    ofRange.values = {};
    QVERIFY(pipeline.make(ofRange, progress).ok() && !extracts); // one mesh
    ofRange.query.range->deaths.maximum = 8;
    const auto refused = pipeline.make(ofRange, progress);
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().kind, ErrorKind::WrongUsage);
}

void SceneBuilderTest::nothingArrivesAfterClear()
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    builder.request(request(0.1, {Isovalue{100}}));
    builder.clear();
    QVERIFY(!builder.busy());
    builder.request(request(1, {Isovalue{100}}));
    QTRY_VERIFY(!builder.busy());
    QCOMPARE(ready.count(), 1);
    QCOMPARE(ready.last()[0].value<BuiltScene>().mesh.wholeSites, meshSizeAt(*model_, {1}).sites);
}

void SceneBuilderTest::aFailureIsTold()
{
    SceneBuilder builder;
    QSignalSpy failed(&builder, &SceneBuilder::failed);
    Isovalue wrong;
    wrong.opacity = 7;
    builder.request(request(1, {wrong}));
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(!builder.busy());
    QVERIFY(!failed.last()[0].value<Error>().text().empty());
}

namespace {

/// Shows a line towards the eye, whatever the mesh, if it asks for the view.
class LineToEye : public Renderer {
public:
    explicit LineToEye(bool asks) : asks_(asks) {}
    std::vector<Parameter> parameters(const FieldExtent&) const override { return {}; }
    RendererNeeds needs() const override { return {.view = asks_}; }
    std::unique_ptr<RendererSession> open(const RendererMeshes&) const override
    {
        class Session : public RendererSession {
            Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress&) override
            {
                const Eigen::Vector3d eye = eyePosition(view.camera);
                const LineSet line{{{0, 0, 0}, eye}, {{0, 1}}, {}, float(view.width)};
                return std::make_shared<const Scene>(Scene{.drawables = {{.id = "line", .shape = line}}});
            }
        };
        return std::make_unique<Session>();
    }

private:
    bool asks_;
};

} // namespace

void SceneBuilderTest::onlyScenesThatDependOnTheViewAreMadeAnewForIt()
{
    for (const bool asks : {false, true}) {
        const LineToEye renderer(asks);
        ScenePipeline maker;
        SceneRequest request{model_, &renderer, {}, {}, {.azimuth = 10}, 300, 200};
        request.query.error = 1;
        const auto lineOf = [&] { return *shapesOf<LineSet>(*maker.make(request, {})->scene).front(); };
        const auto first = maker.make(request, {})->scene;
        QCOMPARE(lineOf().width, 300.0f);
        QCOMPARE(lineOf().points.back(), eyePosition(request.camera));
        QCOMPARE(maker.make(request, {})->scene, first); // nothing has changed
        request.camera.azimuth = 50;
        QCOMPARE(maker.make(request, {})->scene != first, asks);
        request.width = 400;
        QCOMPARE(lineOf().width, asks ? 400.0f : 300.0f);
        request.values["any"] = true;
        QVERIFY(maker.make(request, {})->scene != first);
        QCOMPARE(maker.make(request, {})->extractionSeconds, 0.0);
    }
}

namespace {

using Prepare = std::function<std::shared_ptr<const Scene>()>;

/// A renderer of somebody else, as the host hands it on.
class OutsideRenderer : public Renderer {
public:
    explicit OutsideRenderer(Prepare prepare) : prepare_(std::move(prepare)) {}
    std::vector<Parameter> parameters(const FieldExtent&) const override { return {}; }
    std::unique_ptr<RendererSession> open(const RendererMeshes&) const override
    {
        class Session : public RendererSession {
        public:
            explicit Session(Prepare prepare) : prepare_(std::move(prepare)) {}
            Result<std::shared_ptr<const Scene>> prepare(const RendererView&, const Progress&) override
            {
                return prepare_();
            }

        private:
            Prepare prepare_;
        };
        return std::make_unique<Session>(prepare_);
    }

private:
    Prepare prepare_;
};

} // namespace

/// In the window's scene, in drafts, and in a film.
void SceneBuilderTest::whatARendererThrowsIsTold()
{
    const OutsideRenderer outside([]() -> std::shared_ptr<const Scene> { throw std::runtime_error("a pity"); });
    const auto renderer = guarded(outside, {"outside", [](const Error&) {}});
    SceneRequest wanted = request(2, {});
    wanted.renderer = renderer.get();
    SceneBuilder builder;
    QSignalSpy failed(&builder, &SceneBuilder::failed);
    builder.request(wanted);
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(failed.last()[0].value<Error>().text().find("'outside' failed: a pity") != std::string::npos);
    QVERIFY(!builder.last());

    ShownMesh shown;
    shown.tetrahedra = shown.wholeTetrahedra = 100'000;
    {
        DraftBuilder drafts;
        drafts.request(wanted, shown);
    } // waits for its worker, which the plugin's mistake does not end

    FilmOrder order;
    order.model = model_;
    order.renderer = renderer.get();
    order.view.query = startingQuery(*model_, 2);
    order.view.animation.turntable.frames = 2;
    order.picture.width = order.picture.height = 16;
    order.target = folder_.filePath("film.png").toStdString();
    const Status written = writeFilm(order, {});
    QVERIFY(!written && written.error().text().find("a pity") != std::string::npos);
}

void SceneBuilderTest::theSurfacesOfAnotherRendererAreSaved()
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->normals.assign(3, Eigen::Vector3f(0, 0, 1));
    mesh->triangles = {{0, 1, 2}};
    mesh->values = {1, 2, 3};
    Scene scene;
    scene.drawables = {{.id = "kept", .label = "my slice", .shape = Surface{mesh, {}}, .saved = true},
                       {.id = "other", .label = "helper", .shape = Surface{mesh, {}}}};
    const OutsideRenderer renderer([&] { return std::make_shared<const Scene>(scene); });
    SceneRequest wanted = request(2, {});
    wanted.renderer = &renderer;
    const auto file = [&](const char* name) { return std::filesystem::path(folder_.filePath(name).toStdString()); };
    const auto host = hostOfThisBuild();
    QVERIFY(writeSurfaces(*host, {wanted, std::nullopt, file("surfaces.obj")}, {}).ok());
    QFile text(folder_.filePath("surfaces.obj"));
    QVERIFY(text.open(QIODevice::ReadOnly));
    const QByteArray content = text.readAll();
    QCOMPARE(content.count("\ng my_slice"), qsizetype(1));
    QCOMPARE(content.count("\nf "), qsizetype(1));
    QVERIFY(
        writeSurfaces(*host, {wanted, std::nullopt, file("surfaces.vtp")}, {}).ok()); // with the value of each vertex
    scene.drawables.pop_back();
    scene.drawables.front().saved = false;
    QCOMPARE(writeSurfaces(*host, {wanted, std::nullopt, file("none.obj")}, {}).error().kind, ErrorKind::WrongUsage);
}

/// Before a mesh is extracted, which may take long.
void SceneBuilderTest::aFormatThatNobodyWritesIsRefusedFirst()
{
    std::stop_source stopped;
    stopped.request_stop();
    const auto saved = writeMesh(*host_, {model_, nullptr, {}, folder_.filePath("mesh.nobody").toStdString()},
                                 Progress(stopped.get_token(), {}));
    QVERIFY(!saved);
    QVERIFY2(saved.error().kind == ErrorKind::WrongUsage, saved.error().text().c_str());
}

/// So it is looked for only where it is told, and can be cancelled; and a lack of memory is told.
void SceneBuilderTest::theShapeOfASurfaceMayTakeLong()
{
    const auto extracted = MeshExtractor(model_).extract({.error = 4.0}, {});
    QVERIFY(extracted.ok());
    const std::array values = {100.0};
    const auto shape = [&](Buffer<std::uint32_t>* cells) {
        const auto made = makeSurfaces((*extracted)->mesh, values, {}, {}, cells);
        return made.ok() ? made->front().shape : SurfaceShape();
    };
    Buffer<std::uint32_t> cells;
    QVERIFY(shape(nullptr).parts > 0 && shape(nullptr).area > 0);
    QCOMPARE(shape(&cells).parts, 0U);
    QVERIFY(!cells.empty());
    std::stop_source stop;
    const auto lookingForOpenings = [](const Message& activity) { return activity.text() == "Looking for openings"; };
    const auto cancelled =
        makeSurfaces((*extracted)->mesh, values, {}, Progress(stop.get_token(), [&](double, const Message& activity) {
                         if (lookingForOpenings(activity))
                             stop.request_stop();
                     }));
    QVERIFY(!cancelled.ok() && cancelled.error().kind == ErrorKind::Cancelled);
    const SolidOrder order{{model_, *extracted, {.error = 4.0}, folder_.filePath("solid.stl").toStdString()},
                           {Isovalue{100}},
                           {.solid = SolidSide::Above},
                           false};
    const auto withoutMemory = writeSolids(*host_, order, Progress({}, [&](double, const Message& activity) {
        if (lookingForOpenings(activity))
            throw std::bad_alloc();
    }));
    QVERIFY(!withoutMemory.ok() && withoutMemory.error().kind == ErrorKind::OutOfResource);
    QVERIFY(writeSolids(*host_, order, {}).ok());
}

/// Then writing it tells of the lack of memory.
void SceneBuilderTest::aPictureThatCannotBeHeldIsNone()
{
    Picture picture;
    picture.width = picture.height = std::numeric_limits<int>::max(); // more bytes than there are addresses
    QVERIFY(imageOf(picture).isNull());
    const Status written = writePicture(picture, folder_.filePath("none.png").toStdString());
    QVERIFY(!written.ok() && written.error().kind == ErrorKind::OutOfResource);
}

QTEST_GUILESS_MAIN(SceneBuilderTest)
#include "scene_builder_test.moc"
