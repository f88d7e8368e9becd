// SPDX-License-Identifier: GPL-3.0-or-later
// The way from a model and a view to a picture as programs of others go it (tan/picture.h): it is that of `tan render`,
// what has not changed is used again, and sessions and pictures that say how they were made give their view back.
#include "plugins/samples/samples.h"
#include "tests/app/program.h"

#include <tan/build.h>
#include <tan/picture.h>

#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

namespace {

constexpr PictureRequest small{.width = 160, .height = 120, .samplesPerAxis = 1};

} // namespace

class PictureMakerTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const auto dataset = makeSample({.name = "c60", .size = 16, .type = {}, .seed = 1}, {});
        QVERIFY(dataset.ok());
        QVERIFY(buildModel(*dataset, path("c60.tan")).ok());
        const auto model = Model::open(path("c60.tan"));
        QVERIFY2(model.ok(), model ? "" : model.error().text().c_str());
        auto maker = PictureMaker::of(*model);
        QVERIFY2(maker.ok(), maker ? "" : maker.error().text().c_str());
        maker_.emplace(*std::move(maker));
    }

    void itIsThePictureOfTheCommandLine_data()
    {
        QTest::addColumn<QString>("mode");
        for (const RenderingMode& mode : maker_->modes())
            QTest::newRow(mode.id.c_str()) << QString::fromStdString(mode.id);
    }
    void itIsThePictureOfTheCommandLine()
    {
        QFETCH(QString, mode);
        ViewValue view = maker_->startingView();
        view.appearance.mode = mode.toStdString();
        view.camera.azimuth = 70;
        view.background = Colour{0.2F, 0.1F, 0.3F};
        if (mode == "focus") {
            view.query.focus.shape = FocusState::Shape::Sphere;
            view.query.error = 5;
        }
        if (mode == "volume") {
            view.lens.shape = LensState::Shape::Circle;
            for (AnnotationPlace& place : view.annotations.places)
                place.shown = true;
        }
        PictureRequest request = small;
        request.samplesPerAxis = 2;
        const auto picture = maker_->draw(view, request);
        QVERIFY2(picture.ok(), picture ? "" : picture.error().text().c_str());
        QVERIFY(writePicture(*picture, path("ours.png")));
        QVERIFY(maker_->writeSession(view, path("view.tansession")));
        const Run run = runTan({"render", "view.tansession", "--size", "160x120", "--samples", "2", "-o", "theirs.png"},
                               folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        QCOMPARE(contentOf("ours.png"), contentOf("theirs.png"));
    }

    void whatHasNotChangedIsUsedAgain()
    {
        ViewValue view = maker_->startingView();
        const auto first = maker_->scene(view, small);
        QVERIFY(first.ok());
        view.camera.azimuth += 10;
        QCOMPARE(*maker_->scene(view, small), *first);
        view.query.error *= 2;
        QVERIFY(*maker_->scene(view, small) != *first);
    }

    void viewsComeBackFromFiles()
    {
        ViewValue view = maker_->startingView();
        view.query.error = 3;
        view.camera.elevation = -20;
        QVERIFY(maker_->writeSession(view, path("kept.tansession")));
        const auto picture = maker_->draw(view, small);
        QVERIFY(picture.ok());
        QVERIFY(writePicture(*picture, path("kept.png"), {.texts = maker_->pictureTexts(view, path("kept.png"))}));
        for (const char* file : {"kept.tansession", "kept.png"}) {
            const auto kept = maker_->keptView(path(file));
            QVERIFY2(kept.ok(), kept ? "" : kept.error().text().c_str());
            QVERIFY(kept->view == view);
            QVERIFY(kept->differences.empty());
        }
        QVERIFY(writePicture(*picture, path("silent.png")));
        QCOMPARE(maker_->keptView(path("silent.png")).error().kind, ErrorKind::BadInput);
    }

    /// Of a ball in a corner of a room the ball is framed, unless more than that is shown.
    void whatIsShownIsFramed()
    {
        Lattice lattice;
        lattice.size = {33, 33, 33};
        std::vector<float> samples(lattice.pointCount());
        for (std::uint32_t k = 0; k < 33; ++k)
            for (std::uint32_t j = 0; j < 33; ++j)
                for (std::uint32_t i = 0; i < 33; ++i)
                    samples[lattice.index(i, j, k)] = static_cast<float>(
                        std::clamp(8 - (lattice.position(i, j, k) - Eigen::Vector3d(22, 21, 10)).norm(), 0.0, 3.0));
        const auto room = latticeDataset(lattice, ScalarField::of(std::move(samples)), "room");
        QVERIFY(room.ok() && buildModel(*room, path("room.tan")).ok());
        auto maker = PictureMaker::of(*Model::open(path("room.tan")));
        QVERIFY(maker.ok());
        ViewValue view = maker->startingView();
        const auto distance = [&] { return maker->framed(view).distance; };
        const auto whole = [&] { return fitted(view.camera, maker->model()->description().bounds, 4.0 / 3).distance; };
        const double near = distance();
        QVERIFY(near < 0.8 * whole());
        const ValueRange range = maker->model()->description().range;
        view.isovalues.front().value = range.minimum + 0.01 * range.extent();
        QCOMPARE(distance(), whole());
        view.isovalues.front().visible = false;
        QCOMPARE(distance(), near);
        view.appearance.settings["boundary"] = std::string("translucent");
        QCOMPARE(distance(), whole());
        view.appearance.settings.clear();
        view.appearance.mode = "volume"; // whatever the isovalues are
        view.isovalues.front().visible = true;
        QCOMPARE(distance(), near);
        view.appearance.transfer =
            transferFunctionFromPoints({{range.minimum, {1, 1, 1}, 0.5F}, {range.maximum, {1, 1, 1}, 0.5F}}, 1);
        QCOMPARE(distance(), whole());
        view.appearance.mode = "slice";
        QCOMPARE(distance(), whole());
    }

    void framesAreThoseOfTheFilm()
    {
        ViewValue film = maker_->startingView();
        film.animation.turntable.frames = 4;
        for (const int number : {0, 3}) {
            const auto frame = maker_->drawFrame(film, number, small),
                       alone = maker_->draw(viewAtFrame(film, number), small);
            QVERIFY(frame.ok() && alone.ok());
            QVERIFY(frame->pixels == alone->pixels);
        }
        QVERIFY(maker_->drawFrame(film, 1, small)->pixels != maker_->drawFrame(film, 2, small)->pixels);
        for (const int number : {-1, 4})
            QCOMPARE(maker_->drawFrame(film, number, small).error().kind, ErrorKind::WrongUsage);
    }

    void whatCannotBeIsSaid()
    {
        ViewValue view = maker_->startingView();
        std::stop_source stop;
        stop.request_stop();
        view.query.error = 7;
        QCOMPARE(maker_->draw(view, small, Progress(stop.get_token(), {})).error().kind, ErrorKind::Cancelled);
        view.appearance.mode = "no such mode";
        QCOMPARE(maker_->draw(view, small).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(maker_->parameters(view).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(maker_->scene(view, small).error().kind, ErrorKind::WrongUsage);
    }

private:
    std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }
    QByteArray contentOf(const char* name) const
    {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir folder_;
    std::optional<PictureMaker> maker_;
};

QTEST_GUILESS_MAIN(PictureMakerTest)
#include "picture_maker_test.moc"
