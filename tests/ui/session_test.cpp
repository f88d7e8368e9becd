// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/view_value.h"
#include "tests/ui/sample_files.h"
#include "ui/session/session.h"

#include <tan/render.h>

#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace tetra;

/// What the window's logic says without any window: accuracy (R14, R26), isovalues (R19), undo.
class SessionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void sizeFollowsTheAccuracyAndNeedsNoExtraction();
    void opensAtAnAccuracyThatIsQuickToDraw();
    void everyEditIsOneStepAndUndoRestoresIt();
    void aDragIsOneStep();
    void aDragThatEndsWhereItBeganIsNoStep();
    void twoDragsAreTwoSteps();
    void aDragOfSeveralPartsIsOneStep();
    void changesTellTheirParts();
    void aCameraThatNobodyMovedFollowsTheShape();
    void fittingFramesWhatIsShown();
    void aNewModelHasACameraOfItsOwn();
    void nothingIsAcceptedOutsideTheRange();
    void newIsovaluesFillTheWidestGapInFreeColours();
    void openingAnotherModelForgetsTheEdits();
    void withoutAModelNothingCanBeEdited();
    void aFunctionThatNobodyChoseFollowsTheAccuracy();

private:
    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    std::shared_ptr<const Model> model_;
    std::unique_ptr<Session> session_;
};

void SessionTest::initTestCase()
{
    host_ = hostOfThisBuild();
    const auto path = buildSampleModel(*host_, sampleDataset(24), folder_.path().toStdString());
    const auto model = Model::open(path);
    QVERIFY2(model.ok(), model ? "" : model.error().text().c_str());
    model_ = *model;
}

void SessionTest::init()
{
    session_ = std::make_unique<Session>();
    session_->open(model_, {Isovalue{100}});
}

void SessionTest::sizeFollowsTheAccuracyAndNeedsNoExtraction()
{
    for (const double percent : {4.0, 1.0, 0.1, 0.0}) {
        session_->setError(percent);
        const auto mesh = extractPrefix(*model_, session_->meshSize().sites);
        QVERIFY(mesh.ok());
        QCOMPARE(mesh->tetrahedra.size(), session_->meshSize().tetrahedra);
        QVERIFY(session_->meshSize().error <= percent);
    }
    QCOMPARE(session_->meshSize().sites, model_->siteCount());
}

void SessionTest::opensAtAnAccuracyThatIsQuickToDraw()
{
    QCOMPARE(session_->view().query.error, 1.0);
    QVERIFY(session_->meshSize().tetrahedra <= 1'000'000);
}

void SessionTest::everyEditIsOneStepAndUndoRestoresIt()
{
    QUndoStack& stack = session_->undoStack();
    session_->setError(2);
    session_->addIsovalue(50);
    Isovalue changed = session_->view().isovalues[1];
    changed.opacity = 0.25F;
    session_->setIsovalue(1, changed);
    session_->removeIsovalue(0);
    QCOMPARE(stack.count(), 4);
    QCOMPARE(session_->view().isovalues, std::vector<Isovalue>{changed});

    stack.undo();
    QCOMPARE(session_->view().isovalues.size(), std::size_t(2));
    QCOMPARE(session_->view().isovalues[0], Isovalue{100});
    stack.undo();
    QCOMPARE(session_->view().isovalues[1].opacity, 0.5F);
    stack.undo();
    QCOMPARE(session_->view().isovalues.size(), std::size_t(1));
    stack.undo();
    QCOMPARE(session_->view().query.error, 1.0);
    for (int i = 0; i < 4; ++i)
        stack.redo();
    QCOMPARE(session_->view().query.error, 2.0);
    QCOMPARE(session_->view().isovalues, std::vector<Isovalue>{changed});
}

void SessionTest::aDragIsOneStep()
{
    session_->beginGesture();
    for (const double percent : {0.9, 0.8, 0.7})
        session_->setError(percent);
    session_->endGesture();
    QCOMPARE(session_->undoStack().count(), 1);
    QCOMPARE(session_->view().query.error, 0.7);
    session_->undoStack().undo();
    QCOMPARE(session_->view().query.error, 1.0);

    session_->beginGesture();
    for (const double value : {101, 102, 103})
        session_->setIsovalue(0, Isovalue{value});
    session_->endGesture();
    QCOMPARE(session_->undoStack().count(), 1);
    session_->undoStack().undo();
    QCOMPARE(session_->view().isovalues[0].value, 100.0);
}

void SessionTest::aDragThatEndsWhereItBeganIsNoStep()
{
    session_->beginGesture();
    session_->setError(0.5);
    session_->setError(1);
    session_->endGesture();
    QCOMPARE(session_->undoStack().count(), 0);
    QVERIFY(!session_->undoStack().canUndo());
}

void SessionTest::twoDragsAreTwoSteps()
{
    for (const double percent : {0.5, 2.0}) {
        session_->beginGesture();
        session_->setError(percent);
        session_->endGesture();
    }
    session_->setError(3);
    session_->setError(4);
    QCOMPARE(session_->undoStack().count(), 4);
}

void SessionTest::aDragOfSeveralPartsIsOneStep()
{
    const ViewValue before = session_->view();
    session_->beginGesture();
    for (const double value : {101, 102, 103}) {
        session_->setError(value / 100);
        session_->setIsovalue(0, Isovalue{value});
        session_->setCamera(turned(session_->view().camera, 3, 0));
    }
    session_->endGesture();
    const ViewValue after = session_->view();
    QCOMPARE(session_->undoStack().count(), 1);
    session_->undoStack().undo();
    QVERIFY(session_->view() == before);
    session_->undoStack().redo();
    QVERIFY(session_->view() == after);
}

void SessionTest::changesTellTheirParts()
{
    std::vector<ViewParts> told;
    connect(session_.get(), &Session::viewChanged, this, [&](ViewParts parts) { told.push_back(parts); });
    session_->setError(0.5);
    session_->setSetting("shaded", true);
    ViewValue both = session_->view();
    both.background = Colour{1, 0, 0};
    both.annotations[AnnotationKind::Title].shown = true;
    session_->setView(both, "Both");
    QCOMPARE(session_->undoStack().undoText(), QString("Both"));
    session_->setView(both);
    Camera none = both.camera;
    none.azimuth = std::numeric_limits<double>::quiet_NaN();
    session_->setCamera(none);
    session_->undoStack().undo();
    const ViewParts pair = ViewPart::Annotations | ViewPart::Background;
    QCOMPARE(told, (std::vector<ViewParts>{ViewPart::Query, ViewPart::Settings, pair, pair}));
}

void SessionTest::aCameraThatNobodyMovedFollowsTheShape()
{
    const Eigen::AlignedBox3d bounds = model_->description().bounds;
    session_->setShape(3);
    QVERIFY(session_->view().camera == fitted(session_->view().camera, bounds, 3));
    session_->setCamera(turned(session_->view().camera, 50, 0));
    const Camera moved = session_->view().camera;
    session_->setShape(0.2);
    QVERIFY(session_->view().camera == moved);
    QCOMPARE(session_->undoStack().count(), 1);
    session_->fitCamera();
    QVERIFY(session_->view().camera == fitted(moved, bounds, 0.2));
}

void SessionTest::fittingFramesWhatIsShown()
{
    const Eigen::AlignedBox3d whole = model_->description().bounds;
    const auto fits = [&](const Eigen::AlignedBox3d& bounds) {
        return session_->view().camera == fitted(session_->view().camera, bounds, session_->shape());
    };
    const auto framesFirst = [&](const Eigen::AlignedBox3d& part) {
        session_->setCamera(turned(session_->view().camera, 40, 10));
        session_->fitCamera();
        const bool isPart = fits(part) && session_->view().camera.target == part.center(); // it is turned about
        session_->fitCamera();
        const bool isWhole = fits(whole);
        session_->fitCamera();
        const bool isPartAgain = fits(part);
        session_->fitCameraToWhole();
        return isPart && isWhole && isPartAgain && fits(whole);
    };
    const Eigen::AlignedBox3d box(Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(6, 5, 9));
    QueryState query = session_->view().query;
    const QueryState none = query;
    query.window = {true, {{box.min(), box.max()}, WindowBorder::Clipped}};
    session_->setQuery(query);
    QVERIFY(framesFirst(box));

    query = none;
    query.focus.shape = FocusState::Shape::Sphere;
    query.focus.centre = {1, 10, 10};
    query.focus.radius = 3;
    session_->setQuery(query);
    QVERIFY(framesFirst({Eigen::Vector3d(0, 7, 7), Eigen::Vector3d(4, 13, 13)})); // without what is outside

    query = none;
    query.values = {true, 50, 100};
    session_->setQuery(query);
    session_->setCamera(turned(session_->view().camera, 1, 1));
    session_->fitCamera();
    QVERIFY(fits(whole)); // where these values lie is not known before the picture is there
    ShownMesh shown;
    shown.query = meshQuery(session_->view().query, *model_, presentView(session_->view()));
    shown.bounds = box;
    session_->setShown(shown);
    QVERIFY(framesFirst(box));
}

/// What is no part of a model stays.
void SessionTest::aNewModelHasACameraOfItsOwn()
{
    Camera camera = session_->view().camera;
    camera.azimuth = 200;
    camera.roll = 30;
    camera.up = UpAxis::MinusZ;
    camera.perspective = false;
    camera.trackball = true;
    session_->setCamera(camera);
    AnnotationState annotations;
    annotations[AnnotationKind::ScaleBar] = {true, Corner::TopLeft};
    annotations.numbers = {NumberFormat::Style::Plain, 1};
    AnnotationState ofThisModel = annotations; // what is said of its data is not said of others
    ofThisModel.barEnds = BarEnds{1, 2};
    ofThisModel.title = "Skull";
    ofThisModel.quantity = "Density";
    ofThisModel.unit = "HU";
    session_->setAnnotations(ofThisModel);
    Camera usual = fitted(usualCamera(model_->description()), model_->description().bounds, session_->shape());
    usual.trackball = true;
    for (const bool closes : {true, false}) {
        if (closes)
            session_->close();
        session_->open(model_, {});
        QVERIFY(session_->view().camera == usual);
        QVERIFY(session_->view().annotations == annotations);
        session_->setCamera(turned(session_->view().camera, 90, 0));
    }
    // Fit leaves room for numbers around the box, as long as they are shown, and more for larger ones.
    AnnotationState withNumbers = annotations;
    withNumbers[AnnotationKind::BoxAxes].shown = true;
    session_->setAnnotations(withNumbers);
    session_->open(model_, {});
    const double room = session_->view().camera.distance;
    QVERIFY(room > 1.1 * usual.distance && room < 1.4 * usual.distance);
    withNumbers.textSize = 24;
    session_->setAnnotations(withNumbers);
    session_->fitCamera();
    QVERIFY(session_->view().camera.distance > 1.1 * room);
    session_->setAnnotations(annotations);
    session_->fitCamera();
    QVERIFY(session_->view().camera == usual);
}

void SessionTest::nothingIsAcceptedOutsideTheRange()
{
    session_->setError(-1);
    QCOMPARE(session_->view().query.error, 0.0);
    session_->setError(1000);
    QCOMPARE(session_->view().query.error, 100.0);
    Isovalue isovalue;
    isovalue.value = 1e9;
    isovalue.opacity = 0;
    session_->setIsovalue(0, isovalue);
    QCOMPARE(session_->view().isovalues[0].value, session_->range().maximum);
    QCOMPARE(session_->view().isovalues[0].opacity, 0.01F);
    session_->removeIsovalue(7);
    session_->setIsovalue(-1, isovalue);
    QCOMPARE(session_->view().isovalues.size(), std::size_t(1));
}

void SessionTest::newIsovaluesFillTheWidestGapInFreeColours()
{
    session_->open(model_, {});
    const ValueRange range = session_->range();
    for (int i = 0; i < 9; ++i)
        session_->addIsovalue();
    const auto& isovalues = session_->view().isovalues;
    QCOMPARE(isovalues[0].value, (range.minimum + range.maximum) / 2);
    for (std::size_t i = 0; i < isovalues.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            QVERIFY(isovalues[i].value != isovalues[j].value);
            if (i < 7)
                QVERIFY(isovalues[i].red != isovalues[j].red || isovalues[i].green != isovalues[j].green ||
                        isovalues[i].blue != isovalues[j].blue);
        }
    // A colour that becomes free is taken again.
    session_->removeIsovalue(0);
    while (session_->view().isovalues.size() > 3)
        session_->removeIsovalue(3);
    session_->addIsovalue();
    QCOMPARE(session_->view().isovalues[3].red, materials.front().colour.red);
}

void SessionTest::openingAnotherModelForgetsTheEdits()
{
    session_->setError(2);
    session_->open(model_, {});
    QCOMPARE(session_->undoStack().count(), 0);
    QCOMPARE(session_->view().isovalues.size(), std::size_t(0));
}

void SessionTest::withoutAModelNothingCanBeEdited()
{
    session_->close();
    session_->setError(2);
    session_->addIsovalue();
    QCOMPARE(session_->undoStack().count(), 0);
    QCOMPARE(session_->meshSize().sites, 0U);
}

void SessionTest::aFunctionThatNobodyChoseFollowsTheAccuracy()
{
    const auto usual = [](const QueryState& query) {
        return transferFunctionFromPoints({{query.error, {1, 1, 1}, 0}, {query.error + 10, {1, 0, 0}, 0.5F}});
    };
    const auto transfer = [this] { return session_->view().appearance.transfer; };
    session_->setUsualTransfer(usual);
    const QueryState first = session_->view().query;
    session_->setTransfer(usual(first));
    session_->undoStack().clear();

    session_->setError(3);
    session_->setError(4);
    QCOMPARE(session_->undoStack().count(), 2);
    QVERIFY(transfer() == usual(session_->view().query));
    session_->undoStack().undo();
    QCOMPARE(session_->view().query.error, 3.0);
    QVERIFY(transfer() == usual(session_->view().query));

    TransferFunction chosen = transfer();
    chosen.opacities.back().opacity = 0.7F;
    session_->setTransfer(chosen);
    session_->setError(2);
    QVERIFY(transfer() == chosen);
    while (session_->undoStack().canUndo())
        session_->undoStack().undo();
    QVERIFY(session_->view().query == first && transfer() == usual(first));

    // A model that grows has one of its own, of the accuracy that somebody has chosen.
    session_->setError(5);
    session_->grow(model_, session_->view().isovalues, {"isosurface", chosen, {}});
    QCOMPARE(session_->view().query.error, 5.0);
    QVERIFY(transfer() == usual(session_->view().query));
}

QTEST_GUILESS_MAIN(SessionTest)
#include "session_test.moc"
