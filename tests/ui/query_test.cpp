// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/accuracy_scale.h"
#include "plugins/samples/samples.h"
#include "tests/ui/sample_files.h"
#include "ui/session/session.h"
#include "ui/session/shown_mesh_text.h"

#include <tan/view.h>

#include <QLocale>
#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace tetra;

/// Which mesh is asked for, as a value (R14, R25, R26): edits, undo, bad numbers, and the model's query.
class QueryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void aModelIsOpenedWithoutRegions();
    void everyEditIsOneStepAndUndoRestoresIt();
    void aDragIsOneStep();
    void whatHoldsIsWhatWasTouchedLast();
    void badNumbersAreNotTaken();
    void aWindowIsOrderedAndNotFlat();
    void theQuerySaysTheSame();
    void theAccuracyVariesWithThePicture();
    void aFocusHasSeveralRegions();
    void aRangeTakesThePlaceOfAMesh();
    void aBudgetKeepsTheProportion();
    void theErrorOfABudgetIsTheBestThatFits();
    void budgetsGoInRoundSteps();
    void theMeshIsToldInWords();
    void theWarpingIsLimitedByItself();
    void aShownMeshBelongsToItsQuery();

private:
    const QueryState& query() const { return session_->view().query; }
    FocusState sphereAt(const Eigen::Vector3d& centre) const;

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    std::shared_ptr<const Model> model_;
    std::unique_ptr<Session> session_;
};

void QueryTest::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    host_ = hostOfThisBuild();
    const auto model = Model::open(buildSampleModel(*host_, sampleDataset(24), folder_.path().toStdString()));
    QVERIFY2(model.ok(), model ? "" : model.error().text().c_str());
    model_ = *model;
}

void QueryTest::init()
{
    session_ = std::make_unique<Session>();
    session_->open(model_, {});
}

FocusState QueryTest::sphereAt(const Eigen::Vector3d& centre) const
{
    FocusState focus = query().focus;
    focus.shape = FocusState::Shape::Sphere;
    focus.centre = centre;
    return focus;
}

void QueryTest::aModelIsOpenedWithoutRegions()
{
    QVERIFY(query().isUniform() && !query().byBudget);
    QCOMPARE(query().focus.centre, model_->description().bounds.center());
    QVERIFY(query().focus.radius > 0 && query().focus.size.minCoeff() > 0);
    QVERIFY(query().focus.error < query().error);
    QVERIFY(model_->description().bounds.contains(query().window.window.box.least));
    QCOMPARE(query().values.largest, session_->range().maximum);
}

void QueryTest::everyEditIsOneStepAndUndoRestoresIt()
{
    std::vector<QueryState> states{query()};
    const auto edited = [&](const char* name) {
        states.push_back(query());
        QCOMPARE(session_->undoStack().count(), static_cast<int>(states.size()) - 1);
        QCOMPARE(session_->undoStack().undoText(), QString(name));
    };
    session_->setError(2);
    edited("Change Accuracy");
    session_->setBudget(5000);
    edited("Change Budget");
    session_->setFocus(sphereAt({3, 4, 5}));
    edited("Change Focus");
    session_->setWindow({true, {{{1, 2, 3}, {4, 5, 6}}, WindowBorder::Contained}});
    edited("Change Crop Box");
    session_->setValueFilter({true, 10, 20});
    edited("Change Values");
    session_->setByBudget(false);
    edited("Change Accuracy");
    session_->setWarping({WarpingLimit::Own, 3}); // C1
    edited("Change Warping");
    session_->setWarping({WarpingLimit::None, 3});
    edited("Change Warping");
    for (auto state = states.rbegin(); state != states.rend(); ++state) {
        QCOMPARE(query(), *state);
        session_->undoStack().undo();
    }
    for (const QueryState& state : states) {
        QCOMPARE(query(), state);
        session_->undoStack().redo();
    }
}

void QueryTest::aDragIsOneStep()
{
    session_->setFocus(sphereAt({3, 4, 5}));
    session_->beginGesture();
    for (double x = 4; x < 10; ++x)
        session_->setFocus(sphereAt({x, 4, 5}));
    session_->endGesture();
    QCOMPARE(session_->undoStack().count(), 2);
    session_->undoStack().undo();
    QCOMPARE(query().focus.centre.x(), 3.0);
    session_->beginGesture();
    session_->setFocus(sphereAt({9, 4, 5}));
    session_->setFocus(sphereAt({3, 4, 5})); // as Escape does
    session_->endGesture();
    QCOMPARE(session_->undoStack().count(), 1);
}

void QueryTest::whatHoldsIsWhatWasTouchedLast()
{
    session_->setBudget(5000);
    QVERIFY(query().byBudget);
    session_->setError(3);
    QVERIFY(!query().byBudget);
    QCOMPARE(query().budget, std::uint64_t{5000});
}

void QueryTest::badNumbersAreNotTaken()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const QueryState before = query();
    FocusState focus = before.focus;
    focus.centre = {nan, infinity, -infinity};
    focus.size = {nan, nan, nan};
    focus.radius = infinity;
    focus.error = nan;
    focus.falloff = -infinity;
    session_->setFocus(focus);
    session_->setWindow({false, {{{nan, nan, nan}, {nan, infinity, nan}}, before.window.window.border}});
    session_->setValueFilter({false, nan, infinity});
    session_->setError(nan);
    QCOMPARE(query(), before);
    QCOMPARE(session_->undoStack().count(), 0);

    focus = before.focus;
    focus.centre = {1e9, -1e9, 0};
    focus.radius = -1;
    focus.size.setConstant(-1);
    focus.error = 1000;
    focus.falloff = -1;
    session_->setFocus(focus);
    const Eigen::AlignedBox3d& bounds = model_->description().bounds;
    QVERIFY(bounds.contains(query().focus.centre));
    QVERIFY(query().focus.radius > 0 && query().focus.size.minCoeff() > 0);
    QCOMPARE(query().focus.error, 100.0);
    QCOMPARE(query().focus.falloff, 0.0);
    session_->setBudget(0);
    QVERIFY(query().budget >= 5); // the coarsest mesh of a lattice
}

void QueryTest::aWindowIsOrderedAndNotFlat()
{
    session_->setWindow({true, {{{9, 5, 100}, {2, 5, 200}}, WindowBorder::Clipped}});
    const Box box = query().window.window.box;
    QCOMPARE(box.least.x(), 2.0);
    QCOMPARE(box.largest.x(), 9.0);
    QVERIFY((box.largest - box.least).minCoeff() > 0);
    const Eigen::AlignedBox3d& bounds = model_->description().bounds;
    QVERIFY(bounds.contains(box.least) && bounds.contains(box.largest));
    session_->setValueFilter({true, 100, 50});
    QCOMPARE(query().values.least, 50.0);
}

void QueryTest::theQuerySaysTheSame()
{
    session_->setError(2);
    MeshQuery asked = meshQuery(query(), *model_);
    QVERIFY(asked.error.isConstant());
    QCOMPARE(asked.error.bounds().maximum, 2.0);
    QVERIFY(!asked.budget && !asked.window && asked.values.empty());
    FocusState focus = sphereAt({3, 4, 5});
    focus.error = 0.25;
    focus.falloff = 2;
    session_->setFocus(focus);
    session_->setWindow({true, {{{1, 2, 3}, {4, 5, 6}}, WindowBorder::Contained}});
    session_->setValueFilter({true, 10, 20});
    asked = meshQuery(query(), *model_);
    const SpaceRamp* ramp = asked.error.asSpaceRamp();
    QVERIFY(ramp != nullptr);
    QCOMPARE(*ramp, (SpaceRamp{Sphere{{3, 4, 5}, focus.radius}, 0.25, 2, 2}));
    QCOMPARE(asked.window, std::optional(Window{{{1, 2, 3}, {4, 5, 6}}, WindowBorder::Contained}));
    QCOMPARE(asked.values.size(), std::size_t{1});
    QCOMPARE(asked.values[0].maximum, 20.0);
    focus.shape = FocusState::Shape::Box;
    session_->setFocus(focus);
    asked = meshQuery(query(), *model_);
    const Box wanted{focus.centre - focus.size / 2, focus.centre + focus.size / 2};
    QCOMPARE(std::get<Box>(asked.error.asSpaceRamp()->region), wanted);
}

/// C3: distance from the viewer, isovalues and opacity, of what is seen.
void QueryTest::theAccuracyVariesWithThePicture()
{
    session_->setError(4);
    FocusState focus = query().focus;
    focus.error = 0.5;
    focus.shape = FocusState::Shape::View;
    focus.distance = 3;
    session_->setFocus(focus);
    const PresentView present{Eigen::Vector3d(-10, 0, 0), {50, 90}, {{0, 0}, {100, 1}}};
    QVERIFY(meshQuery(query(), *model_).error == ErrorField(4)); // nobody looks
    const MeshQuery near = meshQuery(query(), *model_, present);
    QVERIFY(near.error.asSpaceRamp() != nullptr);
    QCOMPARE(*near.error.asSpaceRamp(), (SpaceRamp{Sphere{{-10, 0, 0}, 10}, 0.5, 4, 3})); // the domain begins at 0
    focus.shape = FocusState::Shape::Isovalues;
    focus.valueFalloff = 20;
    session_->setFocus(focus);
    QVERIFY(meshQuery(query(), *model_, present).error == ErrorField::nearValues(std::array{50.0, 90.0}, 0.5, 4, 20));
    focus.shape = FocusState::Shape::Opacity;
    session_->setFocus(focus);
    QVERIFY(meshQuery(query(), *model_, present).error ==
            ErrorField::byOpacity(std::vector<std::array<double, 2>>{{0, 0}, {100, 1}}, 0.5, 4));
    QVERIFY(!query().has(RegionKind::Focus)); // there is nothing to drag

    ViewValue view;
    view.isovalues = {{50}, {70, 1, 1, 1, 1, false}};
    view.appearance.transfer.opacities = {{0, 0}, {10, 0.5F}};
    const PresentView seen = presentView(view);
    QCOMPARE(seen.isovalues, std::vector<double>{50});
    QVERIFY(seen.eye == eyePosition(view.camera) && seen.opacity == opacityKnots(view.appearance.transfer));
    ShownMesh mesh;
    mesh.query.error = ErrorField::nearValues(std::array{50.0}, 0.5, 4, 20);
    QCOMPARE(errorText(mesh), QString("error 0.5 % to 4 %"));
}

/// C3: all have the error and the fall-off of the focus; which one is edited changes nothing of the mesh.
void QueryTest::aFocusHasSeveralRegions()
{
    session_->setError(4);
    FocusState focus = sphereAt({3, 4, 5});
    focus.error = 0.5;
    focus.radius = 2;
    session_->setFocus(focus);
    session_->setFocus(query().focus.added());
    FocusState second = query().focus;
    QCOMPARE(second.number, 1U);
    second.shape = FocusState::Shape::Box;
    second.centre = {8, 8, 8};
    second.size = {2, 4, 6};
    session_->setFocus(second);
    const ErrorField both = smallerOf(ErrorField(SpaceRamp{Sphere{{3, 4, 5}, 2}, 0.5, 4, focus.falloff}),
                                      ErrorField(SpaceRamp{Box{{7, 6, 5}, {9, 10, 11}}, 0.5, 4, focus.falloff}));
    QVERIFY(meshQuery(query(), *model_).error == both);
    session_->setFocus(query().focus.selected(0));
    QCOMPARE(query().focus.shape, FocusState::Shape::Sphere);
    QCOMPARE(query().focus.radius, 2.0);
    QVERIFY(meshQuery(query(), *model_).error == both);
    session_->setQuery(query().without(RegionKind::Focus));
    QCOMPARE(query().focus.regions(), std::vector<MovableRegion>{(Box{{7, 6, 5}, {9, 10, 11}})});
    session_->setQuery(query().without(RegionKind::Focus));
    QVERIFY(!query().focus.isOn());
    session_->undoStack().undo();
    session_->undoStack().undo();
    QVERIFY(meshQuery(query(), *model_).error == both);
    for (int i = 0; i < 20; ++i)
        session_->setFocus(query().focus.added());
    QCOMPARE(query().focus.regions().size(), mostFocusRegions);
}

/// C2: with values, and a window that keeps tetrahedra whole; births and deaths only choose.
void QueryTest::aRangeTakesThePlaceOfAMesh()
{
    session_->setBudget(5000);
    session_->setFocus(sphereAt({3, 4, 5}));
    session_->setWindow({true, {{{1, 2, 3}, {4, 5, 6}}, WindowBorder::Clipped}});
    session_->setValueFilter({true, 10, 20});
    session_->setRange({.enabled = true, .fine = 0.5, .coarse = 4, .bornAbove = 1, .diedTo = 2});
    const MeshQuery asked = meshQuery(query(), *model_);
    QVERIFY(checkQuery(*model_, asked).ok());
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    QVERIFY((asked.range == LifeRange{{0.5, 0.5}, {4, 4}, {1, unlimited}, {-unlimited, 2}}));
    QVERIFY(!asked.budget && asked.error.isConstant() && asked.values.size() == 1);
    QCOMPARE(asked.window->border, WindowBorder::Intersecting);
    QVERIFY(!query().isUniform());
    session_->setRange({.enabled = true, .fine = 9, .coarse = 4, .bornAbove = 1});
    QCOMPARE(query().range.coarse, 9.0); // pushed
    ShownMesh mesh;
    mesh.query = asked;
    mesh.keptTetrahedra = 30;
    mesh.wholeTetrahedra = 2000;
    QCOMPARE(meshText(mesh, *model_),
             QString("Shown: tetrahedra of the meshes of errors from 0.5 % to 4 %. 30 of 2000 are selected."));
    session_->undoStack().undo();
    session_->undoStack().undo();
    QVERIFY(meshQuery(query(), *model_).budget.has_value());
}

void QueryTest::aBudgetKeepsTheProportion()
{
    session_->setError(4);
    FocusState focus = sphereAt({3, 4, 5});
    focus.error = 0.5;
    session_->setFocus(focus);
    session_->setBudget(5000);
    const MeshQuery asked = meshQuery(query(), *model_);
    QCOMPARE(asked.budget, std::optional<std::uint64_t>(5000));
    const SpaceRamp* ramp = asked.error.asSpaceRamp();
    QVERIFY(ramp != nullptr);
    QVERIFY(std::abs(ramp->outer / ramp->inner - 8) < 1e-9);
    QVERIFY(ramp->outer < errorWithin(*model_, 5000)); // so that the budget, not the error, ends the mesh
    QVERIFY(ramp->inner > 0);
}

void QueryTest::theErrorOfABudgetIsTheBestThatFits()
{
    for (const std::uint64_t budget : {100U, 1000U, 10'000U, 40'000U}) {
        const double error = errorWithin(*model_, budget);
        QVERIFY(meshSizeAt(*model_, bothWithin(error)).tetrahedra <= budget);
        if (error > 1e-3)
            QVERIFY(meshSizeAt(*model_, bothWithin(error * 0.999)).tetrahedra > budget);
    }
    QCOMPARE(errorWithin(*model_, 1'000'000'000), 0.0);
    session_->setBudget(10'000);
    QCOMPARE(session_->meshSize().sites, meshSizeAt(*model_, bothWithin(errorWithin(*model_, 10'000))).sites);
}

void QueryTest::budgetsGoInRoundSteps()
{
    QCOMPARE(steppedBudget(300'000, 1), std::uint64_t{500'000});
    QCOMPARE(steppedBudget(300'000, -1), std::uint64_t{200'000});
    QCOMPARE(steppedBudget(310'000, 1), std::uint64_t{500'000});
    QCOMPARE(steppedBudget(310'000, -1), std::uint64_t{300'000});
    QCOMPARE(steppedBudget(700'000, 1), std::uint64_t{1'000'000});
    QCOMPARE(steppedBudget(7, -1), std::uint64_t{1000});
}

void QueryTest::theMeshIsToldInWords()
{
    ShownMesh mesh;
    mesh.query.error = 0.5;
    mesh.tetrahedra = mesh.wholeTetrahedra = 2000;
    QCOMPARE(meshText(mesh, *model_), QString("Shown: error 0.5 %."));
    mesh.scale = 2;
    QCOMPARE(meshText(mesh, *model_), QString("Shown: error 1 %. The model contains no finer level."));
    mesh.query.error = SpaceRamp{Sphere{{3, 4, 5}, 2}, 0.5, 4, 1};
    mesh.query.budget = 2000;
    QCOMPARE(meshText(mesh, *model_), QString("Shown: error 1 % in the focus, 8 % outside. Limited by the "
                                              "budget of 2000 tetrahedra."));
    mesh.scale = 1;
    mesh.query.budget.reset();
    mesh.query.values = {{1, 2}};
    mesh.tetrahedra = mesh.keptTetrahedra = 30;
    QCOMPARE(meshText(mesh, *model_),
             QString("Shown: error 0.5 % in the focus, 4 % outside. 30 of its 2000 tetrahedra are shown."));
    QVERIFY(piecesText(mesh).isEmpty());
    mesh.tetrahedra = 2300; // pieces
    QVERIFY(meshText(mesh, *model_).endsWith("30 of its 2000 tetrahedra are shown."));
    QCOMPARE(piecesText(mesh), QString("30 tetrahedra in 2300 pieces, cut by the crop box"));
    mesh.isBlended = true;
    QCOMPARE(meshText(mesh, *model_), QString("Shown: error 0.5 % in the focus, 4 % outside."));

    // Which error it is, where there are two.
    mesh = {};
    mesh.query.error = 0.5;
    mesh.errorMeaning = ErrorMeaning::InGrid;
    QCOMPARE(errorText(mesh), QString("error in the grid 0.5 %"));
    QCOMPARE(errorPlaceText(mesh.errorMeaning, {}), QString("in the grid; in space it may be larger"));
    QVERIFY(errorPromiseText(mesh.errorMeaning, false).endsWith("'tan verify' measures the error in space."));
    QVERIFY(errorPromiseText(mesh.errorMeaning, true).endsWith("may be larger."));
    mesh.errorInSpace = 7.5;
    QCOMPARE(meshText(mesh, *model_), QString("Shown: error in the grid 0.5 % (in space up to 7.5 %)."));
    QCOMPARE(errorPlaceText(mesh.errorMeaning, 7.5), QString("in the grid; in space up to 7.5 %"));
    mesh.errorInSpace.reset();
    mesh.query.error = SpaceRamp{Sphere{{3, 4, 5}, 2}, 0.5, 4, 1};
    QCOMPARE(errorText(mesh), QString("error in the grid 0.5 % in the focus, 4 % outside"));
    mesh.query.error = 0.5;
    mesh.errorMeaning = ErrorMeaning::InSpace;
    QCOMPARE(errorText(mesh), QString("error in space 0.5 %"));
    QCOMPARE(errorPlaceText(mesh.errorMeaning, {}), QString("in the grid and in space"));
    QVERIFY(errorPlaceText(ErrorMeaning::Only, {}).isEmpty() && errorPromiseText(ErrorMeaning::Only, false).isEmpty());

    // Of logarithms an error is a factor.
    mesh = {};
    mesh.logarithms = ValueRange{-8, 2};
    mesh.query.error = 1;
    QCOMPARE(errorText(mesh), QString("error 1 % (a factor of 1.26)"));
    mesh.query.error = 0;
    QCOMPARE(errorText(mesh), QString("error 0 %"));
    mesh.query.error = SpaceRamp{Sphere{{3, 4, 5}, 2}, 0.01, 10, 1};
    QCOMPARE(errorText(mesh), QString("error 0.01 % (a factor of 1.0023) in the focus, 10 % (a factor of 10) outside"));
    mesh.query.error = 1;
    mesh.errorMeaning = ErrorMeaning::InGrid;
    mesh.errorInSpace = 10;
    QCOMPARE(errorText(mesh),
             QString("error in the grid 1 % (a factor of 1.26), in space up to 10 % (a factor of 10)"));

    const auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
    QVERIFY(grid);
    const auto warped = Model::open(buildSampleModel(*host_, *grid, folder_.path().toStdString()));
    QVERIFY(warped && (*warped)->description().warpingWeight > 0);
    ShownMesh uniform;
    uniform.query.error = 0.5;
    uniform.query.warping = 0.5;
    QCOMPARE(meshText(uniform, **warped), QString("Shown: error 0.5 %, and the same warping."));
    uniform.query.warping = 3;
    QCOMPARE(meshText(uniform, **warped), QString("Shown: error 0.5 %, warping 3 %."));
    uniform.query.warping = anyWarping;
    QCOMPARE(meshText(uniform, **warped), QString("Shown: error 0.5 %, with any warping."));
}

/// C1: the warping has a limit of its own, or none; a focus asks for no more of it than outside, and a lattice for
/// nothing.
void QueryTest::theWarpingIsLimitedByItself()
{
    const auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
    QVERIFY(grid);
    const auto warped = Model::open(buildSampleModel(*host_, *grid, folder_.path().toStdString()));
    QVERIFY(warped.ok());
    QueryState state = startingQuery(**warped, 2);
    QVERIFY(meshQuery(state, **warped).warping == ErrorField(2));
    state.warping = {WarpingLimit::Own, 5};
    QVERIFY(meshQuery(state, **warped).error == ErrorField(2));
    QVERIFY(meshQuery(state, **warped).warping == ErrorField(5));
    QCOMPARE(plannedSize(state, **warped).sites, meshSizeAt(**warped, {2, 5}).sites);
    QVERIFY(meshQuery(state, *model_).warping == MeshQuery().warping);
    state.focus.shape = FocusState::Shape::Sphere;
    state.focus.error = 0.5;
    const ErrorField field = meshQuery(state, **warped).warping;
    QVERIFY(field.asSpaceRamp() != nullptr && field.asSpaceRamp()->inner == 0.5 && field.asSpaceRamp()->outer == 5);
    state.warping = {WarpingLimit::Own, 0.25};
    QVERIFY(meshQuery(state, **warped).warping == ErrorField(0.25));
    state.warping.limit = WarpingLimit::None;
    QVERIFY(meshQuery(state, **warped).warping == ErrorField(anyWarping));
    QueryState tooLarge = state;
    tooLarge.warping = {WarpingLimit::Own, 1000};
    QCOMPARE(corrected(tooLarge, state, **warped).warping.percent, anyWarping);
}

void QueryTest::aShownMeshBelongsToItsQuery()
{
    QVERIFY(!session_->showsQuery());
    ShownMesh mesh;
    mesh.query = meshQuery(query(), *model_);
    session_->setShown(mesh);
    QVERIFY(session_->showsQuery());
    session_->setFocus(sphereAt({3, 4, 5}));
    QVERIFY(!session_->showsQuery());
    session_->undoStack().undo();
    QVERIFY(session_->showsQuery());
    session_->close();
    QVERIFY(!session_->shown());
}

QTEST_GUILESS_MAIN(QueryTest)
#include "query_test.moc"
