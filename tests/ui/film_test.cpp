// SPDX-License-Identifier: GPL-3.0-or-later
// Films of what the window shows: key frames, the preview, and what is written.
#include "tests/ui/sample_window.h"
#include "ui/dialogs/film_dialog.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/workbench/film_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>

#include <algorithm>
#include <limits>

using namespace tetra;

class FilmTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void keyFramesAreEdited();
    void aPreviewLeavesTheViewAlone();
    void aPreviewEndsWithItsModel();
    void aFilmIsWrittenAsPictures();
    void aVideoIsProposedWhereItCanBeMade();
    void aFilmThatIsCancelledLeavesNothing();
    void filesInTheWayAreFoundAtOnce();
    void aSlowFolderStopsNobody();
    void aFilmBlendsItsKeys();
    void aVideoIsMadeOfAllFrames();
    void aVideoIsMadeWhereThereIsFfmpeg();
    void whatTheEncoderSaysIsTold();

private:
    PictureSettings settings(QSize size) const;
    /// Of the shell, which can be run. Returns its path.
    QString writeScript(const QString& text) const;
    FilmOrder orderOf(int frames, QSize size, const char* target) const;
    Session& session() const { return window_->workbench.session(); }

    std::unique_ptr<WindowFixture> window_;
};

void FilmTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("film");
    QCoreApplication::setApplicationVersion("1.2.3");
    QLocale::setDefault(QLocale::c());
}

void FilmTest::init()
{
    window_ = windowOnSample();
}

void FilmTest::cleanup()
{
    window_.reset();
}

PictureSettings FilmTest::settings(QSize size) const
{
    return {size, 0, false, session().view().annotations};
}

void FilmTest::keyFramesAreEdited()
{
    QVERIFY(!window_->find<QWidget>("dock.animation").isVisible());
    window_->find<QAction>("action.dock.animation").trigger();
    auto& kind = window_->find<QComboBox>("animation.kind");
    kind.setCurrentIndex(1);
    emit kind.activated(1);
    QVERIFY(!window_->find<QPushButton>("animation.play").isEnabled());
    auto& table = window_->find<QTableWidget>("animation.keys");
    for (const double azimuth : {10.0, 20.0, 30.0}) {
        Camera camera = window_->viewport().camera();
        camera.azimuth = azimuth;
        window_->viewport().setCamera(camera);
        window_->find<QToolButton>("animation.keys.add").click();
    }
    const auto azimuths = [&] {
        QList<double> result;
        for (const KeyFrame& key : session().view().animation.keys)
            result.append(key.frame.camera.azimuth);
        return result;
    };
    QCOMPARE(table.rowCount(), 3);
    QCOMPARE(session().view().animation.keys[2].time, 4.0);
    QVERIFY(window_->find<QLabel>("animation.summary").text().contains("121"));
    table.setCurrentCell(2, 1);
    QTest::keyClick(&table, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(azimuths(), (QList<double>{10, 30, 20}));
    table.item(0, 0)->setText("3");
    QTRY_COMPARE(azimuths(), (QList<double>{30, 10, 20}));
    table.setCurrentCell(1, 1);
    QTest::keyClick(&table, Qt::Key_Delete);
    QCOMPARE(azimuths(), (QList<double>{30, 20}));
    table.setCurrentCell(0, 1);
    QTest::keyClick(&table, Qt::Key_Return);
    QCOMPARE(window_->viewport().camera().azimuth, 30.0);
    for (int i = 0; i < 20 && session().undoStack().canUndo(); ++i)
        session().undoStack().undo();
    QVERIFY(session().view().animation == Animation());
    QCOMPARE(table.rowCount(), 0);
}

void FilmTest::aPreviewLeavesTheViewAlone()
{
    const Camera camera = window_->viewport().camera();
    const int steps = session().undoStack().count();
    auto& play = window_->find<QPushButton>("animation.play");
    play.click();
    QTRY_VERIFY(window_->viewport().shownCamera() != camera);
    QVERIFY(window_->viewport().camera() == camera);
    play.click();
    QVERIFY(window_->viewport().shownCamera() == camera && !window_->viewport().previewing());
    window_->find<QSlider>("animation.position").setValue(30);
    QVERIFY(window_->viewport().shownCamera() != camera);
    QCOMPARE(session().undoStack().count(), steps);
    Camera moved = camera;
    moved.elevation = 5;
    window_->viewport().setCamera(moved); // the user takes over
    QVERIFY(window_->viewport().shownCamera() == moved && !window_->viewport().previewing());
    QCOMPARE(session().undoStack().count(), steps + 1);
}

void FilmTest::aPreviewEndsWithItsModel()
{
    Workbench alone(*window_->host, filePath(window_->folder.filePath("views of another")));
    alone.opening().open(pathText(session().model()->path()));
    QTRY_VERIFY(alone.session().model() != nullptr);
    ViewValue frame = alone.session().view();
    frame.query.error = 6;
    alone.scenes().previewView(frame);
    QVERIFY(alone.scenes().previewedView());
    alone.opening().models().close();
    QVERIFY(!alone.scenes().previewedView());
}

void FilmTest::aFilmIsWrittenAsPictures()
{
    Animation animation;
    animation.turntable.frames = 4;
    session().setAnimation(animation);
    window_->find<QAction>("action.saveFilm").trigger();
    QVERIFY(window_->find<QWidget>("filmOptions").isVisible());
    QTRY_VERIFY(window_->find<QLabel>("film.summary").text().contains("takes about"));
    auto& format = window_->find<QComboBox>("film.format");
    format.setCurrentIndex(format.findData("png"));
    window_->find<QCheckBox>("film.keepProportions").setChecked(false);
    window_->find<QSpinBox>("film.width").setValue(160);
    window_->find<QSpinBox>("film.height").setValue(120);
    auto& target = window_->find<QLineEdit>("film.target");
    target.setText(window_->folder.filePath("round.png"));
    QTRY_VERIFY(window_->find<QPushButton>("film.save").isEnabled());
    QCOMPARE(window_->find<QPushButton>("film.save").text(), QString("&Save"));
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::filmSaved);
    window_->find<QPushButton>("film.save").click();
    QVERIFY(!target.isEnabled());
    QTRY_COMPARE(saved.count(), 1);
    const QDir folder(window_->folder.path());
    const QStringList files = folder.entryList({"round*"}, QDir::AllEntries | QDir::Hidden, QDir::Name);
    QCOMPARE(files, (QStringList{"round_0001.png", "round_0002.png", "round_0003.png", "round_0004.png"}));
    QVERIFY(QImage(folder.filePath(files[0])) != QImage(folder.filePath(files[1])));
    QCOMPARE(QImage(folder.filePath(files[3])).size(), QSize(160, 120));
    QTRY_COMPARE(window_->find<QPushButton>("film.save").text(), QString("&Replace and Save"));
    auto& hint = window_->find<QLabel>("film.hint");
    QVERIFY(hint.text().contains('4'));
    QTRY_VERIFY(hint.height() >= hint.heightForWidth(hint.width())); // none of its lines is cut off
}

/// What shows films needs no resolution for print, and takes videos rather than many pictures.
void FilmTest::aVideoIsProposedWhereItCanBeMade()
{
    QVERIFY(QFile::rename(writeScript("exit 0"), window_->folder.filePath("ffmpeg")));
    const QByteArray path = qgetenv("PATH");
    for (const bool isThere : {true, false}) {
        qputenv("PATH", isThere ? window_->folder.path().toUtf8() : QByteArray("/none"));
        QSettings().remove("film/format");
        FilmDialog dialog(window_->workbench, window_->viewport(), nullptr);
        qputenv("PATH", path);
        QCOMPARE(dialog.findChild<QComboBox*>("film.format")->currentData().toString(), isThere ? "mp4" : "png");
        QVERIFY(dialog.findChild<QWidget*>("film.dpi") == nullptr);
        QVERIFY(dialog.findChild<QWidget*>("film.printSize") == nullptr);
    }
}

void FilmTest::aFilmThatIsCancelledLeavesNothing()
{
    Animation animation;
    animation.turntable.frames = 5000;
    session().setAnimation(animation);
    FilmOrder order = filmOrder(window_->workbench, window_->viewport(), settings({320, 240}));
    order.target = window_->folder.filePath("long.png").toStdString();
    LongTask& task = window_->workbench.exporting().savingFilm();
    double done = 0;
    connect(&task, &LongTask::progressed, this, [&done](const TaskProgress& progress) { done = progress.fraction; });
    QElapsedTimer clock;
    clock.start();
    window_->workbench.exporting().saveFilm(order);
    QTRY_VERIFY(done > 0);
    const double whole = static_cast<double>(clock.restart()) / done;
    task.cancel();
    QTRY_VERIFY(!task.running());
    const auto ending = static_cast<double>(clock.elapsed());
    QVERIFY2(ending < whole / 10, qPrintable(QString("%1 ms of a film of %2 ms").arg(ending).arg(whole)));
    QVERIFY(QDir(window_->folder.path()).entryList({"long*"}, QDir::AllEntries | QDir::Hidden).isEmpty());
    QCOMPARE(window_->messages(), QStringList());
}

/// However many frames the film has (D2): the folder is read once.
void FilmTest::filesInTheWayAreFoundAtOnce()
{
    const QDir folder(window_->folder.path());
    const auto make = [&folder](const QString& name) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
    };
    for (const char* name : {"a_0001.png", "a_0017.png", "a_0200.png", "a_0201.png", "a_1.png", "a_00017.png", "a_.png",
                             "a_-001.png", "ab_0001.png", "a_0001.jpg", "a.png", "a_000001.png", "a_100000.png"})
        make(name);
    const auto found = [&folder](const char* name, int count) {
        QStringList names;
        for (const auto& path : filesInTheWay(folder.filePath(name).toStdString(), count))
            names.append(QString::fromStdString(path.filename().string()));
        return names;
    };
    QCOMPARE(found("a.png", 200), (QStringList{"a_0001.png", "a_0017.png", "a_0200.png"}));
    QCOMPARE(found("a.png", 100'000), (QStringList{"a_000001.png", "a_100000.png"}));
    QCOMPARE(found("b.png", 200), QStringList());
    QCOMPARE(found("no/such/folder/a.png", 200), QStringList());
    const auto best = [&](int count) {
        qint64 least = std::numeric_limits<qint64>::max();
        for (int time = 0; time < 7; ++time) {
            QElapsedTimer clock;
            clock.start();
            found("a.png", count);
            least = std::min(least, clock.nsecsElapsed());
        }
        return static_cast<double>(least);
    };
    const double ratio = best(100'000) / best(10);
    QVERIFY2(ratio < 100, qPrintable(QString::number(ratio)));
}

/// The dialog looks for them in a worker, and saves nothing before it knows.
void FilmTest::aSlowFolderStopsNobody()
{
    window_->find<QAction>("action.saveFilm").trigger();
    auto& save = window_->find<QPushButton>("film.save");
    QTRY_VERIFY(save.isEnabled());
    QFile file(window_->folder.filePath("there_0001.png"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    window_->find<QLineEdit>("film.target").setText(window_->folder.filePath("there.png"));
    QCOMPARE(save.text(), QString("&Save"));
    QVERIFY(!save.isEnabled());
    QTRY_COMPARE(save.text(), QString("&Replace and Save"));
    QVERIFY(save.isEnabled());
}

/// Frames of a film follow isovalues and accuracy, too, not only the camera.
void FilmTest::aFilmBlendsItsKeys()
{
    Animation animation;
    animation.kind = Animation::Kind::KeyFrames;
    animation.framesPerSecond = 1;
    FilmFrame first = frameOf(session().view());
    FilmFrame last = first;
    first.error = 4;
    last.error = 1;
    last.isovalues.front().value += 20;
    animation = withKey(withKey(animation, first), last);
    session().setAnimation(animation);
    QCOMPARE(frameCount(session().view().animation), 3);
    const FilmFrame middle = frameOf(session().view().animation, first, 1);
    QCOMPARE(middle.error, 2.5);
    QCOMPARE(middle.isovalues.front().value, first.isovalues.front().value + 10);
    QVERIFY(frameOf(session().view().animation, {}, 0) == first);
    QVERIFY(frameOf(session().view().animation, {}, 2) == last);
    FilmOrder order = filmOrder(window_->workbench, window_->viewport(), settings({120, 90}));
    order.target = window_->folder.filePath("keys.png").toStdString();
    const Status written = writeFilm(order, {});
    QVERIFY2(written, written ? "" : written.error().text().c_str());
    QVERIFY(QImage(window_->folder.filePath("keys_0001.png")) != QImage(window_->folder.filePath("keys_0003.png")));
    animation.keys.pop_back();
    order.view.animation = animation;
    QVERIFY(!writeFilm(order, {}));
}

QString FilmTest::writeScript(const QString& text) const
{
    const QString path = window_->folder.filePath("encoder");
    QFile script(path);
    if (!script.open(QIODevice::WriteOnly) || script.write("#!/bin/sh\n" + text.toUtf8()) < 0 ||
        !script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner))
        qFatal("the script could not be written");
    return path;
}

FilmOrder FilmTest::orderOf(int frames, QSize size, const char* target) const
{
    Animation animation;
    animation.turntable.frames = frames;
    session().setAnimation(animation);
    FilmOrder order = filmOrder(window_->workbench, window_->viewport(), settings(size));
    order.target = window_->folder.filePath(target).toStdString();
    return order;
}

/// An encoder that keeps the frames it is given, and makes a video of their names: all frames in their order, the same
/// as those of a film of pictures.
void FilmTest::aVideoIsMadeOfAllFrames()
{
    FilmOrder order = orderOf(3, {120, 90}, "pictures.png");
    Status written = writeFilm(order, {});
    QVERIFY2(written, written ? "" : written.error().text().c_str());
    const QDir kept(window_->folder.filePath("kept"));
    QVERIFY(QDir().mkpath(kept.path()));
    order.encoder = writeScript(QString("cp *.png '%1'\nfor last; do :; done\nls *.png >\"$last\"\n").arg(kept.path()));
    order.target = window_->folder.filePath("film.webm").toStdString();
    written = writeFilm(order, {});
    QVERIFY2(written, written ? "" : written.error().text().c_str());
    const QStringList frames = kept.entryList({"*.png"}, QDir::Files, QDir::Name);
    QCOMPARE(frames.size(), 3);
    for (int frame = 0; frame < 3; ++frame)
        QCOMPARE(QImage(kept.filePath(frames[frame])),
                 QImage(window_->folder.filePath(QString("pictures_000%1.png").arg(frame + 1))));
    QFile video(window_->folder.filePath("film.webm"));
    QVERIFY(video.open(QIODevice::ReadOnly));
    QCOMPARE(QString::fromUtf8(video.readAll()).trimmed(), frames.join('\n'));
    QCOMPARE(QDir(window_->folder.path()).entryList({"film*"}, QDir::AllEntries | QDir::Hidden),
             QStringList("film.webm"));
}

/// What ffmpeg reads of its own video are all the frames, of even sides.
void FilmTest::aVideoIsMadeWhereThereIsFfmpeg()
{
    const QString encoder = findVideoEncoder();
    if (encoder.isEmpty())
        QSKIP("skipped: no ffmpeg");
    for (const char* name : {"film.mp4", "film.webm"}) {
        FilmOrder order = orderOf(3, {121, 91}, name);
        order.encoder = encoder;
        const Status written = writeFilm(order, {});
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        const QDir decoded(window_->folder.filePath(QString("decoded ") + name));
        QVERIFY(QDir().mkpath(decoded.path()));
        QCOMPARE(QProcess::execute(
                     encoder, {"-loglevel", "error", "-i", window_->folder.filePath(name), decoded.filePath("%d.png")}),
                 0);
        QCOMPARE(decoded.entryList(QDir::Files), (QStringList{"1.png", "2.png", "3.png"}));
        QCOMPARE(QImage(decoded.filePath("1.png")).size(), QSize(122, 92));
    }
}

void FilmTest::whatTheEncoderSaysIsTold()
{
    const QString encoder = writeScript("echo 'no such codec' >&2\nexit 3\n");
    const Status refused = encodeVideo(encoder, {}, window_->folderPath(), {});
    QVERIFY(!refused && refused.error().text().find("no such codec") != std::string::npos);
    const Status missing = encodeVideo("/no/such/program", {}, window_->folderPath(), {});
    QVERIFY(!missing && missing.error().text().find("/no/such/program") != std::string::npos);
    QCOMPARE(encoderArguments("%06d.png", 25, "film.mp4").last(), QString("film.mp4"));
    QVERIFY(encoderArguments("%06d.png", 25, "film.mp4").contains("yuv420p"));
}

QTEST_MAIN(FilmTest)
#include "film_test.moc"
