// SPDX-License-Identifier: GPL-3.0-or-later
// The window and `tan render` draw the same picture of the same state, pixel for pixel.
#include "core/view/view_value.h"
#include "tests/app/program.h"
#include "tests/ui/sample_window.h"
#include "tests/waiting.h"
#include "ui/dialogs/picture_orders.h"

#include <tan/render.h>

#include <QFileDialog>
#include <QSignalSpy>

using namespace tetra;

class RenderedSessionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { window_ = windowOnSample(16, {600, 400}); }
    void cleanup() { window_.reset(); }
    void asTheWindowDrawsIt_data();
    void asTheWindowDrawsIt();
    void aMovingCameraExtractsNothing();
    void aModelIsSeenAsAtFirst_data();
    void aModelIsSeenAsAtFirst();
    void aPresetOfParaviewIsStretchedAlike_data();
    void aPresetOfParaviewIsStretchedAlike();
    void aPictureHoldsItsSession();
    void whatDoesNotGoTogether_data();
    void whatDoesNotGoTogether();

private:
    Session& session() const { return window_->workbench.session(); }
    QString path(const QString& name) const { return window_->folder.filePath(name); }
    Run tan(const QStringList& words) const { return runTan(words, window_->folder.path()); }
    bool upToDate() const { return window_->settled() && session().showsQuery(); }
    void saveSession(const QString& name) const;
    QImage savedPicture(const PictureSettings& settings) const;
    /// How the pictures differ that the window and the program make of the model, the program with these options.
    QByteArray differenceOfBoth(const QString& mode, const QStringList& options = {}) const;

    std::unique_ptr<WindowFixture> window_;
};

namespace {

constexpr QSize sizeOfPictures(201, 145); // neither that of the view nor of its shape

QByteArray differenceOf(const QImage& one, const QImage& other)
{
    if (one.size() != other.size())
        return "sizes differ";
    int count = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            count += one.pixel(x, y) != other.pixel(x, y) ? 1 : 0;
    return count == 0 ? QByteArray() : QByteArray::number(count) + " pixels differ";
}

AnnotationState allAnnotations()
{
    AnnotationState state;
    for (AnnotationPlace& place : state.places)
        place.shown = true;
    return state;
}

} // namespace

void RenderedSessionTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("rendered session");
    QLocale::setDefault(QLocale::c());
}

void RenderedSessionTest::saveSession(const QString& name) const
{
    QSignalSpy saved(&window_->workbench.opening().sessionFile(), &SessionFile::saved);
    window_->find<QAction>("action.saveSessionAs").trigger();
    auto& dialog = window_->find<QFileDialog>("sessionDialog");
    emit dialog.fileSelected(path(name));
    dialog.reject();
    QTRY_COMPARE(saved.count(), 1);
}

QImage RenderedSessionTest::savedPicture(const PictureSettings& settings) const
{
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
    PictureOrder order = pictureOrder(window_->workbench, window_->viewport(), settings);
    order.target = path("window.png").toStdString();
    window_->workbench.exporting().savePicture(order);
    return waitFor([&] { return saved.count() == 1; }) ? QImage(path("window.png")) : QImage();
}

void RenderedSessionTest::asTheWindowDrawsIt_data()
{
    QTest::addColumn<QString>("mode");
    QTest::addColumn<bool>("changed"); // from how it is seen at first
    QTest::addColumn<QString>("region");
    for (const char* mode : {"isosurface", "volume", "hybrid", "focus", "projection", "slice"}) {
        QTest::addRow("%s at first", mode) << QString(mode) << false << QString();
        QTest::addRow("%s", mode) << QString(mode) << true << QString();
        QTest::addRow("%s, focus", mode) << QString(mode) << true << QString("focus");
        QTest::addRow("%s, window", mode) << QString(mode) << true << QString("window");
    }
    for (const char* region : {"foci", "view", "isovalues", "opacity"}) // C3
        QTest::addRow("volume, %s", region) << QString("volume") << true << QString(region);
    for (const char* mode : {"isosurface", "volume", "focus"}) // C5
        QTest::addRow("%s, lens", mode) << QString(mode) << true << QString("lens");
    QTest::addRow("isosurface, range") << QString("isosurface") << true << QString("range"); // C2
    for (const char* mode : {"isosurface", "slice"})
        QTest::addRow("%s, tools", mode) << QString(mode) << true << QString("tools");
}

void RenderedSessionTest::asTheWindowDrawsIt()
{
    QFETCH(QString, mode);
    QFETCH(bool, changed);
    QFETCH(QString, region);
    window_->find<QAction>("action.mode." + mode).trigger();
    if (changed) {
        session().setError(3);
        session().addIsovalue();
        TransferFunction transfer = session().view().appearance.transfer;
        transfer.opacities.back().opacity = 0.5F;
        session().setTransfer(transfer);
        session().setSetting("shaded", false);
        session().setAnnotations(allAnnotations());
        Camera camera = window_->viewport().camera();
        camera.azimuth = 77;
        camera.distance *= 0.7;
        window_->viewport().setCamera(camera);
        session().setBackground(Colour{0.1F, 0.2F, 0.4F});
    }
    if (region == "focus") {
        FocusState focus = session().view().query.focus;
        focus.shape = FocusState::Shape::Sphere;
        focus.falloff = 1;
        session().setFocus(focus);
    } else if (region == "foci") {
        FocusState focus = session().view().query.focus;
        focus.shape = FocusState::Shape::Sphere;
        session().setFocus(focus.added());
    } else if (region == "view" || region == "isovalues" || region == "opacity") {
        FocusState focus = session().view().query.focus;
        focus.shape = region == "view"        ? FocusState::Shape::View
                      : region == "isovalues" ? FocusState::Shape::Isovalues
                                              : FocusState::Shape::Opacity;
        session().setFocus(focus);
    } else if (region == "lens") {
        session().setLens({.shape = LensState::Shape::Circle, .x = 0.45, .y = 0.6, .magnification = 2.5});
    } else if (region == "tools") {
        const Eigen::AlignedBox3d& bounds = session().model()->description().bounds;
        std::string places;
        for (const Eigen::Vector3d& place : {bounds.min(), bounds.max(), Eigen::Vector3d(bounds.center())})
            places += formatNumber(place.x()) + "," + formatNumber(place.y()) + "," + formatNumber(place.z()) + " ";
        ViewValue view = session().view();
        view.tools["ruler"] = places;
        session().setView(view);
    } else if (region == "range") {
        session().setRange({.enabled = true, .fine = 2, .coarse = 10, .bornAbove = 3});
    } else if (region == "window") {
        WindowState part = session().view().query.window;
        part.enabled = true;
        session().setWindow(part);
    }
    QTRY_VERIFY(upToDate());
    saveSession("state.tansession");
    const QImage drawn =
        savedPicture({sizeOfPictures, 0, false, session().view().annotations}).convertToFormat(QImage::Format_ARGB32);
    const Run run = tan({"render", "state.tansession", "--size", "201x145", "-o", "program.png"});
    QVERIFY2(run.exitCode == 0, run.messages);
    const QByteArray difference =
        differenceOf(drawn, QImage(path("program.png")).convertToFormat(QImage::Format_ARGB32));
    QVERIFY2(difference.isEmpty(), difference);
    QVERIFY(differenceOf(drawn, QImage(path("program.png")).mirrored()) != QByteArray()); // there is something
}

/// C3: a mesh that is finer near the viewer is extracted again once the camera rests.
void RenderedSessionTest::aMovingCameraExtractsNothing()
{
    FocusState focus = session().view().query.focus;
    focus.shape = FocusState::Shape::View;
    session().setFocus(focus);
    QTRY_VERIFY(upToDate());
    SceneBuilder& builder = window_->workbench.scenes().sceneBuilder();
    const std::shared_ptr<const ExtractedMesh> before = builder.mesh();
    Camera camera = window_->viewport().camera();
    for (int step = 0; step < 3; ++step) {
        camera.azimuth += 20;
        window_->viewport().setCamera(camera);
        QCoreApplication::processEvents();
        QVERIFY(!builder.busy());
    }
    QVERIFY(!session().showsQuery() && builder.mesh() == before);
    QTRY_VERIFY(upToDate());
    QVERIFY(builder.mesh() != before);
}

void RenderedSessionTest::aModelIsSeenAsAtFirst_data()
{
    QTest::addColumn<QString>("mode");
    for (const char* mode : {"isosurface", "volume", "hybrid"})
        QTest::addRow("%s", mode) << QString(mode);
}

QByteArray RenderedSessionTest::differenceOfBoth(const QString& mode, const QStringList& options) const
{
    session().setError(4);
    session().setBackground(Colour{1, 1, 1});
    const FieldExtent& field = window_->workbench.scenes().extent();
    window_->viewport().setCamera(
        framed(session().view(), field.bounds, field.object, double(sizeOfPictures.width()) / sizeOfPictures.height()));
    if (!waitFor([this] { return upToDate(); }))
        return "the window draws on and on";
    AnnotationState none;
    for (AnnotationPlace& place : none.places)
        place.shown = false;
    const QImage drawn = savedPicture({sizeOfPictures, 0, false, none}).convertToFormat(QImage::Format_ARGB32);
    const Run run = tan(QStringList{"render", "c60.tan", "--mode", mode, "--error", "4", "--size", "201x145",
                                    "--samples", "4", "--background", "white", "-o", "program.png"} +
                        options);
    return run.exitCode != 0 ? run.messages
                             : differenceOf(drawn, QImage(path("program.png")).convertToFormat(QImage::Format_ARGB32));
}

/// The isovalue and the transfer function that nobody has chosen are the window's.
void RenderedSessionTest::aModelIsSeenAsAtFirst()
{
    QFETCH(QString, mode);
    window_->find<QAction>("action.mode." + mode).trigger();
    const QByteArray difference = differenceOfBoth(mode);
    QVERIFY2(difference.isEmpty(), difference);
}

void RenderedSessionTest::aPresetOfParaviewIsStretchedAlike_data()
{
    QTest::addColumn<QByteArray>("preset");
    QTest::newRow("colours") << QByteArray(R"([{"Name": "fire", "RGBPoints": [0, 0, 0, 0.5, 1, 1, 0.8, 0]}])");
    QTest::newRow("both") << QByteArray(R"([{"Name": "fire", "RGBPoints": [0, 0, 0, 0.5, 1, 1, 0.8, 0],
                                             "Points": [0, 0, 0.5, 0, 0.4, 0.05, 0.5, 0, 1, 0.9, 0.5, 0]}])");
}

/// In the file there are values from 0 to 1, and those of the data end elsewhere.
void RenderedSessionTest::aPresetOfParaviewIsStretchedAlike()
{
    QFETCH(QByteArray, preset);
    QVERIFY(session().range().maximum > 2);
    QFile file(path("preset.json"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(preset) == preset.size());
    file.close();
    window_->find<QAction>("action.mode.volume").trigger();
    session().setError(4); // of which the opacities are that a preset of colours keeps
    const TransferFunction before = session().view().appearance.transfer;
    window_->find<QAbstractButton>("transfer.load").click();
    auto& dialog = window_->find<QFileDialog>("transferDialog");
    emit dialog.fileSelected(file.fileName());
    dialog.reject();
    QTRY_VERIFY(session().view().appearance.transfer != before);
    const QByteArray difference = differenceOfBoth("volume", {"--transfer", "preset.json"});
    QVERIFY2(difference.isEmpty(), difference);
}

/// A picture that the window has saved is made again, by the session that it holds.
void RenderedSessionTest::aPictureHoldsItsSession()
{
    session().setMode("volume");
    QTRY_VERIFY(upToDate());
    window_->find<QAction>("action.savePicture").trigger();
    window_->find<QAbstractButton>("picture.save").click();
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
    auto& dialog = window_->find<QFileDialog>("pictureDialog");
    emit dialog.fileSelected(path("shown.png"));
    dialog.reject();
    QTRY_COMPARE(saved.count(), 1);
    const QImage shown(path("shown.png"));
    const Run run = tan(
        {"render", "shown.png", "--size", QString("%1x%2").arg(shown.width()).arg(shown.height()), "-o", "again.png"});
    QVERIFY2(run.exitCode == 0, run.messages);
    const QByteArray difference = differenceOf(shown.convertToFormat(QImage::Format_ARGB32),
                                               QImage(path("again.png")).convertToFormat(QImage::Format_ARGB32));
    QVERIFY2(difference.isEmpty(), difference);
}

void RenderedSessionTest::whatDoesNotGoTogether_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("part");
    QTest::newRow("mode") << QStringList{"--mode", "volume"} << 2 << "'--mode'";
    QTest::newRow("error") << QStringList{"--error", "1"} << 2 << "'--error'";
    QTest::newRow("isovalue") << QStringList{"--isovalue", "1"} << 2 << "'--isovalue'";
    QTest::newRow("title") << QStringList{"--title", "X"} << 2 << "'--title'";
    QTest::newRow("its own") << QStringList{"--camera", "top", "--background", "black", "--samples", "1"} << 0 << "";
}

/// What a session says cannot be said otherwise beside it, but for camera and background.
void RenderedSessionTest::whatDoesNotGoTogether()
{
    QFETCH(QStringList, options);
    QFETCH(int, exitCode);
    QFETCH(QString, part);
    saveSession("state.tansession");
    const Run run = tan(QStringList{"render", "state.tansession", "--size", "40x30", "-o", "program.png"} + options);
    QVERIFY2(run.exitCode == exitCode, run.messages);
    QVERIFY2(QString::fromUtf8(run.messages).contains(part), run.messages);
    QCOMPARE(QFile::exists(path("program.png")), exitCode == 0);
}

QTEST_MAIN(RenderedSessionTest)
#include "rendered_session_test.moc"
