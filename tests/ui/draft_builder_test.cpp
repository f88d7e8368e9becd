// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/scene_parts.h"
#include "tests/ui/sample_files.h"
#include "ui/scenes/scene_builder.h"
#include "ui/viewport/canvas.h"

#include <tan/query.h>

#include <QProxyStyle>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <semaphore>

using namespace tetra;

namespace {

/// A renderer that says what the worker is at, and waits where the test wants it to.
struct Watch {
    std::counting_semaphore<> begun{0}; ///< a scene is being prepared
    std::counting_semaphore<> go{0};    ///< and may be finished
    std::atomic<std::size_t> gone{0};   ///< meshes of which what was kept is given back: nothing more is told of them
};

class WatchedSession : public RendererSession {
public:
    WatchedSession(std::unique_ptr<RendererSession> inner, Watch& watch) : inner_(std::move(inner)), watch_(watch) {}
    ~WatchedSession() override { ++watch_.gone; }
    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        watch_.begun.release();
        watch_.go.acquire();
        return inner_->prepare(view, progress);
    }

private:
    std::unique_ptr<RendererSession> inner_;
    Watch& watch_;
};

class WatchedRenderer : public Renderer {
public:
    WatchedRenderer(const Renderer& inner, Watch& watch) : inner_(inner), watch_(watch) {}
    std::vector<Parameter> parameters(const FieldExtent& field) const override { return inner_.parameters(field); }
    RendererNeeds needs() const override { return inner_.needs(); }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<WatchedSession>(inner_.open(meshes), watch_);
    }

private:
    const Renderer& inner_;
    Watch& watch_;
};

} // namespace

/// Coarser meshes for moving pictures, and the pictures themselves (R23).
class DraftBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void meshesFallBelowTheShownOne();
    void aUsualFunctionIsThatOfTheDraft();
    void anotherLookKeepsTheMeshes();
    void nothingArrivesAfterClear();
    void nothingArrivesAfterAnotherMesh();
    void movingPicturesAreQuickAndRestingOnesFull();
    void draftsDoNotDisturbAFinePicture();
    void theChosenMeshIsPrepared();
    void theFirstPictureOfAMovementIsCoarse_data();
    void theFirstPictureOfAMovementIsCoarse();
    void fullQualityIsAlwaysFull();
    void finePicturesFadeIn();

private:
    struct Shown {
        SceneRequest request;
        BuiltScene scene;
    };
    SceneRequest request(const char* mode) const;
    Shown shown(const char* mode) const;
    std::vector<DraftScene> drafts(const Shown& shown) const;
    View viewOf(const Shown& shown) const;

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    std::shared_ptr<const Model> model_;
};

void DraftBuilderTest::initTestCase()
{
    host_ = hostOfThisBuild();
    const auto model = Model::open(buildSampleModel(*host_, sampleDataset(32), folder_.path().toStdString()));
    QVERIFY(model.ok());
    model_ = *model;
}

SceneRequest DraftBuilderTest::request(const char* mode) const
{
    SceneRequest request;
    request.model = model_;
    request.renderer = host_->renderer(mode)->plugin;
    request.query.error = 0.1;
    return request;
}

DraftBuilderTest::Shown DraftBuilderTest::shown(const char* mode) const
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    builder.request(request(mode));
    if (!ready.wait(60'000))
        qFatal("no scene");
    return {request(mode), ready.last()[0].value<BuiltScene>()};
}

std::vector<DraftScene> DraftBuilderTest::drafts(const Shown& shown) const
{
    DraftBuilder builder;
    QSignalSpy ready(&builder, &DraftBuilder::draftsReady);
    builder.request(shown.request, shown.scene.mesh);
    const std::size_t expected = coarserMeshes(shown.scene.mesh.tetrahedra).size();
    while (ready.isEmpty() || ready.last()[0].value<std::vector<DraftScene>>().size() < expected)
        if (!ready.wait(60'000))
            qFatal("too few drafts");
    return ready.last()[0].value<std::vector<DraftScene>>();
}

void DraftBuilderTest::meshesFallBelowTheShownOne()
{
    const Shown full = shown("volume");
    const auto budgets = coarserMeshes(full.scene.mesh.tetrahedra);
    QVERIFY(budgets.size() >= 2);
    const auto made = drafts(full);
    QCOMPARE(made.size(), budgets.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
        QVERIFY(made[i].tetrahedra <= budgets[i]);
        QVERIFY(made[i].tetrahedra > budgets[i] / 2);
        QVERIFY(testing::partsOf(*made[i].scene).volume.has_value());
    }
}

/// A coarser mesh is off by more, which must not be painted into the background.
void DraftBuilderTest::aUsualFunctionIsThatOfTheDraft()
{
    Shown full = shown("volume");
    const TransferFunction ofFull = transferFunctionFromPoints({{0, {1, 1, 1}, 0.5F}, {255, {1, 1, 1}, 0.5F}}, 1);
    const TransferFunction ofDraft = transferFunctionFromPoints({{0, {1, 0, 0}, 0}, {255, {1, 0, 0}, 0.1F}}, 1);
    full.request.values["transfer"] = ofFull;
    MeshQuery coarser = full.request.query;
    coarser.budget = 100;
    QVERIFY(withQuery(full.request, coarser).values == full.request.values); // somebody has chosen it
    std::atomic<std::size_t> asked{0}, wrong{0};
    full.request.usualTransfer = [&](const MeshQuery& query) {
        ++asked;
        wrong += query.budget && *query.budget < full.scene.mesh.tetrahedra ? 0 : 1;
        return ofDraft;
    };
    const SceneRequest draft = withQuery(full.request, coarser);
    QVERIFY(draft.query == coarser && draft.values.at("transfer") == ParameterValue(ofDraft));
    asked = 0;
    wrong = 0;
    const auto made = drafts(full);
    QVERIFY(asked >= made.size() && wrong == 0);
}

void DraftBuilderTest::anotherLookKeepsTheMeshes()
{
    const Shown full = shown("volume");
    DraftBuilder builder;
    QSignalSpy ready(&builder, &DraftBuilder::draftsReady);
    const std::size_t expected = coarserMeshes(full.scene.mesh.tetrahedra).size();
    const auto newest = [&] {
        return ready.isEmpty() ? std::vector<DraftScene>() : ready.last()[0].value<std::vector<DraftScene>>();
    };
    builder.request(full.request, full.scene.mesh);
    QTRY_COMPARE(newest().size(), expected);
    const auto before = newest();
    SceneRequest other = full.request;
    other.values["shaded"] = false;
    builder.requestAppearance(other);
    QTRY_VERIFY(newest().size() == expected && !testing::partsOf(*newest().front().scene).volume->shaded);
    QCOMPARE(testing::partsOf(*newest().front().scene).volume->mesh,
             testing::partsOf(*before.front().scene).volume->mesh);
    SceneRequest elsewhere = full.request;
    elsewhere.query.error = 3.0;
    builder.requestAppearance(elsewhere); // of a mesh that is not known yet: as if it had not been asked for
    builder.requestAppearance(full.request);
    QTRY_VERIFY(newest().size() == expected && testing::partsOf(*newest().front().scene).volume->shaded);
    QCOMPARE(testing::partsOf(*newest().front().scene).volume->mesh,
             testing::partsOf(*before.front().scene).volume->mesh);
}

/// Cleared while a draft is being made, which is finished then.
void DraftBuilderTest::nothingArrivesAfterClear()
{
    Shown full = shown("isosurface");
    Watch watch;
    const WatchedRenderer watched(*full.request.renderer, watch);
    full.request.renderer = &watched;
    DraftBuilder builder;
    builder.request(full.request, full.scene.mesh);
    watch.begun.acquire();
    QSignalSpy ready(&builder, &DraftBuilder::draftsReady);
    builder.clear();
    watch.go.release(1000);
    QTRY_VERIFY(watch.gone > 0);
    QCoreApplication::processEvents();
    QCOMPARE(ready.count(), 0);
}

/// Drafts that are made already and wait to be heard of go with their mesh.
void DraftBuilderTest::nothingArrivesAfterAnotherMesh()
{
    Shown full = shown("isosurface");
    Watch watch;
    const WatchedRenderer watched(*full.request.renderer, watch);
    full.request.renderer = &watched;
    DraftBuilder builder;
    QSignalSpy ready(&builder, &DraftBuilder::draftsReady);
    builder.request(full.request, full.scene.mesh);
    watch.go.release(1000);
    const std::size_t drafts = coarserMeshes(full.scene.mesh.tetrahedra).size();
    QVERIFY(drafts >= 2);
    for (std::size_t draft = 0; draft < drafts; ++draft)
        watch.begun.acquire(); // when the last one begins, those before are told
    SceneRequest other = full.request;
    other.query.error = 50.0;
    ShownMesh small = full.scene.mesh;
    small.tetrahedra = 100; // too few for drafts
    ready.clear();
    builder.request(other, small);
    QTRY_VERIFY(watch.gone >= drafts);
    QCoreApplication::processEvents();
    QCOMPARE(ready.count(), 1); // that the others go
    QCOMPARE(ready.last()[0].value<std::vector<DraftScene>>().size(), std::size_t{0});
}

void DraftBuilderTest::movingPicturesAreQuickAndRestingOnesFull()
{
    const Shown full = shown("volume");
    View view;
    view.levels.push_back({full.scene.scene, full.scene.mesh.tetrahedra});
    for (const DraftScene& draft : drafts(full))
        view.levels.push_back({draft.scene, draft.tetrahedra});
    view.camera = fitted(Camera(), model_->description().bounds);
    Canvas canvas;
    canvas.resize(640, 480);
    std::vector<FrameReport> reports;
    connect(&canvas, &Canvas::framePainted, this, [&](const FrameReport& report) { reports.push_back(report); });
    connect(&canvas, &Canvas::failed, this, [](const QString& text) { qFatal("%s", qPrintable(text)); });
    canvas.setFrameRate(100); // more than can be: then as coarse as there is
    view.moving = true;
    canvas.setView(view);
    for (std::size_t count = 1; count <= 12; ++count) {
        QTRY_COMPARE(reports.size(), count);
        view.camera = turned(view.camera, 3, 0);
        canvas.setView(view);
        QVERIFY(!canvas.settled());
    }
    QVERIFY(reports.back().moving);
    QVERIFY(reports.back().tetrahedra < full.scene.mesh.tetrahedra || reports.back().reduction > 1);
    view.moving = false;
    canvas.setView(view);
    QTRY_VERIFY_WITH_TIMEOUT(canvas.settled(), 60'000);
    QVERIFY(!reports.back().moving);
    QCOMPARE(reports.back().tetrahedra, full.scene.mesh.tetrahedra);
    QCOMPARE(reports.back().reduction, 1.0);
    QCOMPARE(canvas.picture().size(), QSize(640, 480));
}

void DraftBuilderTest::draftsDoNotDisturbAFinePicture()
{
    const Shown full = shown("isosurface");
    View view;
    view.levels.push_back({full.scene.scene, full.scene.mesh.tetrahedra});
    view.camera = fitted(Camera(), model_->description().bounds);
    Canvas canvas;
    canvas.resize(320, 240);
    int pictures = 0;
    connect(&canvas, &Canvas::framePainted, this, [&] { ++pictures; });
    canvas.setView(view);
    QTRY_VERIFY(canvas.settled());
    pictures = 0;
    for (const DraftScene& draft : drafts(full))
        view.levels.push_back({draft.scene, draft.tetrahedra});
    canvas.setView(view);
    QVERIFY(canvas.settled());
    QCoreApplication::processEvents();
    QCOMPARE(pictures, 0);
}

/// C4: of an error or a share that the user chose, and none where there is no coarser one.
void DraftBuilderTest::theChosenMeshIsPrepared()
{
    const Shown full = shown("volume");
    const std::uint64_t whole = full.scene.mesh.tetrahedra;
    DraftBuilder builder;
    QSignalSpy ready(&builder, &DraftBuilder::draftsReady);
    const auto last = [&] { return ready.last()[0].value<std::vector<DraftScene>>(); };
    builder.setQuality({MovingQuality::Kind::Error, 5});
    builder.request(full.request, full.scene.mesh);
    QTRY_VERIFY_WITH_TIMEOUT(!ready.isEmpty() && last().size() == 1, 60'000);
    MeshQuery coarse = full.request.query;
    coarse.error = 5;
    const auto mesh = MeshExtractor(model_).extract(coarse);
    QVERIFY(mesh.ok());
    QCOMPARE(last()[0].tetrahedra, (*mesh)->wholeTetrahedra);

    builder.setQuality({MovingQuality::Kind::Share, 20});
    QVERIFY(last().empty()); // at once
    QTRY_VERIFY_WITH_TIMEOUT(last().size() == 1, 60'000);
    QVERIFY(last()[0].tetrahedra > whole / 10 && last()[0].tetrahedra <= whole / 5);

    builder.setQuality({MovingQuality::Kind::FrameRate, 0});
    QTRY_COMPARE_WITH_TIMEOUT(last().size(), coarserMeshes(whole).size(), 60'000);

    for (const MovingQuality& none :
         {MovingQuality{MovingQuality::Kind::Full, 0}, MovingQuality{MovingQuality::Kind::Error, 0.05}}) {
        builder.setQuality(none);
        QVERIFY(last().empty());
        const auto before = ready.size();
        QVERIFY(!ready.wait(300));
        QCOMPARE(ready.size(), before);
    }
}

View DraftBuilderTest::viewOf(const Shown& shown) const
{
    View view;
    view.levels.push_back({shown.scene.scene, shown.scene.mesh.tetrahedra});
    for (const DraftScene& draft : drafts(shown))
        view.levels.push_back({draft.scene, draft.tetrahedra});
    view.camera = fitted(Camera(), model_->description().bounds);
    return view;
}

void DraftBuilderTest::theFirstPictureOfAMovementIsCoarse_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("frame rate") << int(MovingQuality::Kind::FrameRate);
    QTest::newRow("chosen") << int(MovingQuality::Kind::Share);
}

/// C4: after a rest, whose fine picture is on the screen or on its way, no full one comes first.
void DraftBuilderTest::theFirstPictureOfAMovementIsCoarse()
{
    QFETCH(int, kind);
    const Shown full = shown("volume");
    View view = viewOf(full);
    Canvas canvas;
    canvas.resize(640, 480);
    canvas.setMovingKind(static_cast<MovingQuality::Kind>(kind));
    canvas.setFrameRate(100);
    std::vector<FrameReport> reports;
    connect(&canvas, &Canvas::framePainted, this, [&](const FrameReport& report) { reports.push_back(report); });
    for (const bool settled : {true, false}) {
        view.moving = false;
        view.camera = turned(view.camera, 5, 0);
        canvas.setView(view);
        if (settled)
            QTRY_VERIFY_WITH_TIMEOUT(canvas.settled(), 60'000);
        reports.clear();
        view.moving = true;
        view.camera = turned(view.camera, 5, 0);
        canvas.setView(view);
        QTRY_VERIFY_WITH_TIMEOUT(!reports.empty(), 60'000);
        QVERIFY(reports.front().moving);
        QVERIFY(reports.front().tetrahedra < full.scene.mesh.tetrahedra || reports.front().reduction > 1);
        if (kind == int(MovingQuality::Kind::Share)) {
            QCOMPARE(reports.front().tetrahedra, view.levels.back().tetrahedra);
            QCOMPARE(reports.front().reduction, 1.0);
        }
    }
}

/// C4: also while it moves, and what was drawn then is not drawn again at rest.
void DraftBuilderTest::fullQualityIsAlwaysFull()
{
    const Shown full = shown("volume");
    View view = viewOf(full);
    Canvas canvas;
    canvas.resize(320, 240);
    canvas.setMovingKind(MovingQuality::Kind::Full);
    canvas.setFrameRate(1000);
    std::vector<FrameReport> reports;
    connect(&canvas, &Canvas::framePainted, this, [&](const FrameReport& report) { reports.push_back(report); });
    canvas.setView(view);
    QTRY_VERIFY_WITH_TIMEOUT(canvas.settled(), 60'000);
    view.moving = true;
    view.camera = turned(view.camera, 5, 0);
    canvas.setView(view);
    QTRY_VERIFY_WITH_TIMEOUT(canvas.settled(), 60'000);
    QCOMPARE(reports.size(), std::size_t(2));
    for (const FrameReport& report : reports) {
        QCOMPARE(report.tetrahedra, full.scene.mesh.tetrahedra);
        QCOMPARE(report.reduction, 1.0);
    }
    const QImage moving = canvas.picture();
    view.moving = false;
    canvas.setView(view);
    QVERIFY(canvas.settled());
    QCOMPARE(reports.size(), std::size_t(2));

    Canvas resting;
    resting.resize(320, 240);
    resting.setView(view);
    QTRY_VERIFY_WITH_TIMEOUT(resting.settled(), 60'000);
    QCOMPARE(moving, resting.picture());
}

namespace {

/// A desktop where things glide, or one where nothing should.
class MotionStyle : public QProxyStyle {
public:
    explicit MotionStyle(bool moves) : moves_(moves) {}
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override
    {
        return hint == SH_Widget_Animation_Duration ? (moves_ ? 200 : 0)
                                                    : QProxyStyle::styleHint(hint, option, widget, data);
    }

private:
    bool moves_;
};

} // namespace

/// C4: from the coarse picture, unless nothing should move.
void DraftBuilderTest::finePicturesFadeIn()
{
    const Shown full = shown("volume");
    for (const bool moves : {true, false}) {
        MotionStyle style(moves);
        View view = viewOf(full);
        Canvas canvas;
        canvas.setStyle(&style);
        canvas.resize(320, 240);
        canvas.show();
        canvas.setFrameRate(1000);
        std::vector<QImage> seen; // as each fine picture arrives
        std::size_t coarse = 0;
        connect(&canvas, &Canvas::framePainted, this, [&](const FrameReport& report) {
            coarse += report.moving;
            if (!report.moving)
                seen.push_back(canvas.grab().toImage());
        });
        view.moving = true;
        canvas.setView(view);
        QTRY_VERIFY_WITH_TIMEOUT(coarse == 1, 60'000);
        const QImage before = canvas.grab().toImage();
        view.moving = false;
        canvas.setView(view);
        QTRY_VERIFY_WITH_TIMEOUT(canvas.settled(), 60'000);
        const QImage after = canvas.grab().toImage();
        QVERIFY(!seen.empty() && before != after);
        if (moves)
            QCOMPARE(seen.front(), before);
        else
            QCOMPARE(seen.back(), after);
    }
}

QTEST_MAIN(DraftBuilderTest)
#include "draft_builder_test.moc"
