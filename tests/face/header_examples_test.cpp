// SPDX-License-Identifier: GPL-3.0-or-later
// The examples in the headers do what they say, on data that go from an array to a picture by the face alone (R29).
#include "tests/face/header_examples.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace tetra;

class HeaderExamplesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const auto made = ball();
        QVERIFY(made.ok());
        dataset_ = *made;
        const auto report = built(dataset_, path("ball.tan"));
        QVERIFY2(report.ok(), report ? "" : report.error().text().c_str());
        QVERIFY(report->find(" sites, ") != std::string::npos);
        const auto model = Model::open(path("ball.tan"));
        QVERIFY(model.ok());
        model_ = *model;
    }

    void errorsAreValues()
    {
        QCOMPARE(*halfOf(8), 4);
        QCOMPARE(halfOf(7).error().text(), std::string("7 is odd. Give an even number."));
    }

    void theVersionIsThatOfTheBuild()
    {
        QCOMPARE(versions(),
                 std::string("compiled with TAn " TAN_PROJECT_VERSION ", running with " TAN_PROJECT_VERSION));
        const LibraryVersion there = libraryVersion();
        QCOMPARE(there, (LibraryVersion{TAN_VERSION_MAJOR, TAN_VERSION_MINOR, TAN_VERSION_PATCH}));
        QVERIFY(TAN_VERSION_NUMBER_OF(0, 2, 0) < TAN_VERSION_NUMBER_OF(0, 10, 0));
        QVERIFY(TAN_VERSION_NUMBER_OF(0, 999, 999) < TAN_VERSION_NUMBER_OF(1, 0, 0));
        QVERIFY(TAN_VERSION_NUMBER > TAN_VERSION_NUMBER_OF(0, 1, 0));
    }

    void progressIsToldAndStopped()
    {
        std::ostringstream told;
        QVERIFY(countToHundred({}, told).ok());
        QVERIFY(told.str().ends_with("Counting 100 %\n"));
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(countToHundred(stop.get_token(), told).error().kind, ErrorKind::Cancelled);
    }

    void aModelDescribesItself()
    {
        const auto text = describe(path("ball.tan"));
        QVERIFY(text.ok());
        QVERIFY2(text->starts_with("ball: " + std::to_string(model_->siteCount()) + " sites"), text->c_str());
        QVERIFY(text->ends_with("built by refinement"));
        QVERIFY(!describe(path("none.tan")).ok());
    }

    /// R16.
    void modelsArePackedAndLookedAt()
    {
        const auto text = packed(path("ball.tan"), path("ball.packed.tan"));
        QVERIFY2(text.ok(), text ? "" : text.error().text().c_str());
        QVERIFY(text->ends_with(" bytes in place of " + std::to_string(model_->fileSize())));
        QVERIFY(preview(path("ball.packed.tan"), 10, path("coarse.tan")).ok());
        const auto coarse = Model::open(path("coarse.tan"));
        QVERIFY(coarse.ok() && (*coarse)->siteCount() < model_->siteCount());
    }

    void aMeshFillsTheBox()
    {
        const auto mesh = meshOfOnePercent(model_);
        QVERIFY(mesh.ok());
        QVERIFY(std::abs(volumeOf((*mesh)->mesh) - 3.2 * 3.2 * 3.2) < 1e-3);
        QVERIFY((*mesh)->mesh.tetrahedra.size() < model_->tetrahedronCount());
    }

    void aModelIsFoundByItsPath()
    {
        const auto coarse = meshFrom(path("ball.tan").string(), 50), fine = meshFrom(path("ball.tan").string(), 1);
        QVERIFY(coarse.ok() && fine.ok());
        QVERIFY(coarse->tetrahedra.size() < fine->tetrahedra.size());
        QVERIFY(!meshFrom(path("none.tan").string(), 1).ok());
    }

    void aMeshIsCountedWithoutBeingMade()
    {
        const auto size = sizeOfOnePercent(path("ball.tan").string());
        QVERIFY(size.ok());
        QCOMPARE(*size, (*meshOfOnePercent(model_))->mesh.tetrahedra.size());
        const auto coarse = meshFrom(path("ball.tan").string(), anyError);
        const auto count = tetrahedraAtFirstSite(*model_);
        QVERIFY(coarse.ok() && count.ok());
        QCOMPARE(std::ptrdiff_t(*count), std::ranges::count_if(coarse->tetrahedra, [](const auto& sites) {
                     return std::ranges::count(sites, 0u) > 0;
                 }));
    }

    void aFocusIsFinerWithinItsBudget()
    {
        const auto mesh = MeshExtractor(model_).extract(ballInFocus({1.6, 1.6, 1.6}, 0.4));
        QVERIFY2(mesh.ok(), mesh ? "" : mesh.error().text().c_str());
        QVERIFY((*mesh)->mesh.tetrahedra.size() <= 100000);
        QVERIFY(std::abs(volumeOf((*mesh)->mesh) - 3.2 * 3.2 * 3.2) < 1e-3);
    }

    void modelsAreProved()
    {
        const auto faults = proved(*model_, dataset_);
        QVERIFY(faults.ok());
        QCOMPARE(*faults, std::string());
    }

    void decimationLeavesOutWhatIsFine()
    {
        const auto report = builtSmall(dataset_, path("small.tan"));
        QVERIFY2(report.ok(), report ? "" : report.error().text().c_str());
        QVERIFY(report->sites < model_->siteCount());
        const auto model = Model::open(path("small.tan"));
        QVERIFY(model.ok());
        QCOMPARE((*model)->description().builder, std::string("decimation"));
        const auto checked = verify(**model, dataset_, {{.error = 0.5}, {.error = 5}});
        QVERIFY(checked.ok() && checked->ok());
    }

    void aPictureShowsTheBall()
    {
        const auto text = blueToYellow(0, 2.8, 0.5);
        QVERIFY(text.ok());
        const auto function = transferFunctionFromText(*text);
        QVERIFY(function.ok());
        const auto mesh = meshOfOnePercent(model_);
        const auto picture = look(meshOf(*mesh), 1, *function);
        QVERIFY2(picture.ok(), picture ? "" : picture.error().text().c_str());
        const auto at = [&](int x, int y) { return picture->pixels[std::size_t(y) * 320 + std::size_t(x)]; };
        const std::array<std::uint8_t, 4> white{255, 255, 255, 255};
        QVERIFY(at(160, 160) != white);
        QCOMPARE(at(0, 0), white);
    }

    void parametersHaveDefaults()
    {
        QVERIFY(!hasThickLines({}));
        QVERIFY(hasThickLines({{"line-width", 3.0}}));
        QVERIFY(!hasThickLines({{"line-width", std::int64_t(3)}})); // of another type: the default
    }

    /// The view's mesh is finer in the ball: as many tetrahedra as the query of the view asks for by hand.
    void aViewIsATextAndAMesh()
    {
        const Sphere ball{{1.6, 1.6, 1.6}, 0.4};
        const std::string text = viewOfBall(*model_, ball, 1);
        const auto view = viewFromText(text);
        QVERIFY2(view.ok(), view ? "" : view.error().text().c_str());
        QCOMPARE(view->camera.elevation, 60.0);
        QCOMPARE(view->isovalues.size(), std::size_t(1));
        const auto mesh = meshInView(text, model_);
        QVERIFY2(mesh.ok(), mesh ? "" : mesh.error().text().c_str());
        MeshQuery asked;
        asked.error = SpaceRamp{ball, 0.5, 2, 0};
        const auto byHand = MeshExtractor(model_).extract(asked);
        QVERIFY(byHand.ok());
        QCOMPARE((*mesh)->mesh.tetrahedra.size(), (*byHand)->mesh.tetrahedra.size());
        asked.error = 2;
        QVERIFY((*mesh)->mesh.tetrahedra.size() > (*MeshExtractor(model_).extract(asked))->mesh.tetrahedra.size());
        QCOMPARE(meshInView("{", model_).error().kind, ErrorKind::BadInput);
    }

    void viewsBecomePicturesAndFilms()
    {
        const Status drawn = pictureFromAbove(path("ball.tan"), "volume", path("above.png"));
        QVERIFY2(drawn.ok(), drawn ? "" : drawn.error().text().c_str());
        QVERIFY(std::filesystem::file_size(path("above.png")) > 1000);
        QCOMPARE(pictureFromAbove(path("ball.tan"), "none", path("none.png")).error().kind, ErrorKind::WrongUsage);
        auto maker = PictureMaker::of(model_);
        QVERIFY2(maker.ok(), maker ? "" : maker.error().text().c_str());
        const auto again = maker->keptView(path("above.png"));
        QVERIFY(again.ok());
        QCOMPARE(again->view.camera.elevation, 90.0);
        ViewValue film = maker->startingView();
        film.animation.turntable.frames = 3;
        QVERIFY(framesOf(*maker, film, path(".")).ok());
        QVERIFY(std::filesystem::exists(path("2.png")) && !std::filesystem::exists(path("3.png")));
    }

    /// A user's file is no model, and stays; options that make no sense are refused before anything is written.
    void nothingIsLost()
    {
        const std::filesystem::path notes = path("notes.tan");
        std::ofstream(notes) << "all of it";
        QCOMPARE(buildModel(dataset_, notes).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(std::filesystem::file_size(notes), std::uintmax_t(9));
        QCOMPARE(buildModel(dataset_, path("bad.tan"), Refinement{.error = -1}).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(buildModel(dataset_, path("bad.tan"), Decimation{.finest = std::nan("")}).error().kind,
                 ErrorKind::WrongUsage);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(buildModel(dataset_, path("bad.tan"), Refinement{}, Progress(stop.get_token(), {})).error().kind,
                 ErrorKind::Cancelled);
        QVERIFY(!std::filesystem::exists(path("bad.tan")));
        QVERIFY(!std::filesystem::exists(path("bad.tan.work")));
    }

    /// A builder of one's own: two tetrahedra, and nothing more.
    void aHistoryOfOnesOwnIsWritten()
    {
        const std::vector<Eigen::Vector3d> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
        const auto points = scatteredDataset(places, {0, 1, 2, 3, 4}, "five points");
        QVERIFY(points.ok());
        const auto report = writeModel(*points, path("own.tan"), "by hand", [](HistorySink& history) -> Status {
            const HistoryTetrahedron first{{2, 1, 0}, 0, 0}, second{{2, 1, 3}, 0, 0};
            const float infinity = std::numeric_limits<float>::infinity();
            for (std::uint64_t point = 0; point < 5; ++point) {
                HistoryStep step{.point = point, .keyBefore = infinity, .star = {}, .destroyed = {}};
                if (point >= 3)
                    step.star = {point == 3 ? &first : &second, 1};
                if (const Status added = history.add(step); !added)
                    return added;
            }
            return history.finish(0);
        });
        QVERIFY2(report.ok(), report ? "" : report.error().text().c_str());
        QCOMPARE(report->sites, std::uint64_t(5));
        QCOMPARE(report->tetrahedra, std::uint64_t(2));
        const auto model = Model::open(path("own.tan"));
        QVERIFY(model.ok());
        QCOMPARE((*model)->description().builder, std::string("by hand"));
        const auto checked = verify(**model, *points, {{.error = 0}});
        QVERIFY(checked.ok());
        QVERIFY2(checked->ok(), checked->failures.empty() ? "a level" : checked->failures.front().c_str());
        const Error own{ErrorKind::OutOfResource, "No more."};
        const auto failed = writeModel(*points, path("none.tan"), "by hand", [&](HistorySink&) { return Status(own); });
        QCOMPARE(failed.error().text(), own.text());
        QVERIFY(!std::filesystem::exists(path("none.tan")));
    }

    void arraysAreChecked_data();
    void arraysAreChecked();

private:
    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }

    QTemporaryDir folder_;
    Dataset dataset_;
    std::shared_ptr<const Model> model_;
};

void HeaderExamplesTest::arraysAreChecked_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<bool>("taken");
    for (const auto& [what, taken] : std::initializer_list<std::pair<const char*, bool>>{{"lattice", true},
                                                                                         {"too few values", false},
                                                                                         {"one layer", false},
                                                                                         {"no spacing", false},
                                                                                         {"not finite", false},
                                                                                         {"grid", true},
                                                                                         {"flat grid", false},
                                                                                         {"grid of less", false},
                                                                                         {"points", true},
                                                                                         {"no points", false},
                                                                                         {"points astray", false}})
        QTest::newRow(what) << what << taken;
}

void HeaderExamplesTest::arraysAreChecked()
{
    QFETCH(QString, what);
    QFETCH(bool, taken);
    Lattice lattice;
    lattice.size = {3, 2, 2};
    std::vector<double> values(12, 1.0);
    values[5] = 7;
    std::vector<Eigen::Vector3d> places;
    for (std::uint64_t point = 0; point < 12; ++point) {
        const auto [i, j, k] = lattice.coordinates(point);
        places.emplace_back(i + 0.1 * j, j, what == "flat grid" ? 0 : k);
    }
    if (what == "too few values")
        values.pop_back();
    if (what == "one layer")
        lattice.size = {12, 1, 1};
    if (what == "no spacing")
        lattice.spacing.y() = 0;
    if (what == "not finite")
        values[3] = std::nan("");
    if (what == "grid of less" || what == "no points")
        places.clear();
    if (what == "no points")
        values.clear();
    if (what == "points astray")
        places[2].x() = std::numeric_limits<double>::infinity();
    const Result<Dataset> dataset =
        what.contains("grid") ? curvilinearDataset(lattice.size, places, ScalarField::of(values), "it")
        : what.contains("points")
            ? scatteredDataset(places, values, "it")
            : latticeDataset(lattice, ScalarField::copyOf(std::span(std::as_const(values))), "it");
    QCOMPARE(dataset.ok(), taken);
    if (!taken) {
        QCOMPARE(dataset.error().kind, ErrorKind::BadInput);
        QVERIFY2(dataset.error().text().starts_with("Cannot use 'it': "), dataset.error().text().c_str());
        return;
    }
    QCOMPARE(dataset->pointCount(), std::uint64_t(12));
    QCOMPARE(dataset->values.range().maximum, 7.0);
    QVERIFY(dataset->source.hash != 0);
    const auto report = buildModel(*dataset, path("made.tan"));
    QVERIFY2(report.ok(), report ? "" : report.error().text().c_str());
    const auto model = Model::open(path("made.tan"));
    const auto checked = verify(**model, *dataset, {{.error = 0}});
    QVERIFY(checked.ok() && checked->ok());
}

QTEST_GUILESS_MAIN(HeaderExamplesTest)
#include "header_examples_test.moc"
