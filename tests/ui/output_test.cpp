// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and films of what the window shows: dialogs, files and what they say of themselves.
#include "core/picture/session_document.h"
#include "tests/ui/sample_window.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/scenes/picture_image.h"

#include <tan/version.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QImage>
#include <QImageReader>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using namespace tetra;

class OutputTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void annotationsAreUndoable();
    void thePictureShowsItsAnnotations();
    void aPictureIsSavedAsAskedFor();
    void aPictureKeepsItsProportions();
    void aPictureHasASizeInCentimetres();
    void aPictureIsSavedInManyFormats();
    void aPictureSaysHowItWasMade();
    void aPictureRestoresItsView();
    void aPictureOfAPreviewIsOfOneView();
    void backgroundsCanBeTransparent();
    void picturesWaitForEachOther();
    void thePictureIsCopied();

private:
    PictureSettings settings(QSize size) const;
    template <class Object> Object& dialog(const QString& name) const { return window_->find<Object>(name); }
    void savePictureTo(const QString& path) const;
    Session& session() const { return window_->workbench.session(); }

    std::unique_ptr<WindowFixture> window_;
};

void OutputTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("output");
    QLocale::setDefault(QLocale::c());
}

void OutputTest::init()
{
    window_ = windowOnSample();
}

void OutputTest::cleanup()
{
    window_.reset();
}

PictureSettings OutputTest::settings(QSize size) const
{
    return {size, 0, false, session().view().annotations};
}

/// As the user does, by the dialogs.
void OutputTest::savePictureTo(const QString& path) const
{
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
    window_->find<QPushButton>("picture.save").click();
    auto& file = window_->find<QFileDialog>("pictureDialog");
    file.selectFile(path);
    QMetaObject::invokeMethod(&file, "accept");
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(saved.first().first().toString(), path);
}

void OutputTest::annotationsAreUndoable()
{
    const AnnotationState before = session().view().annotations;
    window_->find<QCheckBox>("view.annotation.scaleBar").click();
    QVERIFY(session().view().annotations[AnnotationKind::ScaleBar].shown);
    QVERIFY(window_->find<QAction>("action.annotation.scaleBar").isChecked());
    window_->find<QAction>("action.annotation.axes").trigger();
    QVERIFY(!window_->find<QCheckBox>("view.annotation.axes").isChecked());
    auto& corner = window_->find<QComboBox>("view.annotation.scaleBar.corner");
    corner.setCurrentIndex(static_cast<int>(Corner::TopLeft));
    emit corner.activated(corner.currentIndex());
    QCOMPARE(session().view().annotations[AnnotationKind::ScaleBar].corner, Corner::TopLeft);
    for (int i = 0; i < 3; ++i)
        session().undoStack().undo();
    QVERIFY(session().view().annotations == before);
    QVERIFY(window_->find<QAction>("action.annotation.axes").isChecked());
}

void OutputTest::thePictureShowsItsAnnotations()
{
    QWidget& viewport = window_->viewport();
    const QImage with = viewport.grab().toImage();
    session().setAnnotations({});
    AnnotationState none = session().view().annotations;
    for (AnnotationPlace& place : none.places)
        place.shown = false;
    session().setAnnotations(none);
    const QImage without = viewport.grab().toImage();
    QCOMPARE(with.size(), without.size());
    const QRect corner(0, with.height() - 110, 110, 110); // axes
    QVERIFY(with.copy(corner) != without.copy(corner));
    const QRect middle(with.width() / 2 - 10, with.height() / 2 - 10, 20, 20);
    QVERIFY(with.copy(middle) == without.copy(middle));
}

void OutputTest::aPictureIsSavedAsAskedFor()
{
    window_->find<QAction>("action.savePicture").trigger();
    QVERIFY(window_->find<QWidget>("pictureOptions").isVisible());
    QVERIFY(window_->window.isEnabled());
    auto& preset = window_->find<QComboBox>("picture.preset");
    preset.setCurrentIndex(2);
    emit preset.activated(2);
    QCOMPARE(window_->find<QSpinBox>("picture.width").value(), 1280);
    window_->find<QCheckBox>("picture.keepProportions").click();
    window_->find<QSpinBox>("picture.width").setValue(300);
    window_->find<QSpinBox>("picture.height").setValue(200);
    window_->find<QSpinBox>("picture.dpi").setValue(254);
    QCOMPARE(window_->find<QDoubleSpinBox>("picture.printWidth").value(), 3.0);
    QCOMPARE(window_->find<QDoubleSpinBox>("picture.printHeight").value(), 2.0);
    QCOMPARE(preset.currentText(), QString("Custom"));
    const QString path = window_->folder.filePath("picture.png");
    savePictureTo(path);
    const QImage picture(path);
    QCOMPARE(picture.size(), QSize(300, 200));
    QCOMPARE(picture.dotsPerMeterX(), 10000);
    QVERIFY(!window_->find<QWidget>("pictureOptions").isVisible());
    window_ = std::make_unique<WindowFixture>(); // what was chosen is remembered
    const auto form = std::make_unique<PictureForm>("picture");
    QCOMPARE(form->settings().size, QSize(300, 200));
    QCOMPARE(form->settings().dotsPerInch, 254);
    QVERIFY(!form->findChild<QCheckBox*>("picture.keepProportions")->isChecked());
}

/// Of the view, of a size that was chosen, and of one that was let go: no picture is wider than what is seen by
/// accident.
void OutputTest::aPictureKeepsItsProportions()
{
    PictureForm form("proportions");
    form.setView({1200, 800}, {});
    auto& width = *form.findChild<QSpinBox*>("proportions.width");
    auto& height = *form.findChild<QSpinBox*>("proportions.height");
    auto& preset = *form.findChild<QComboBox*>("proportions.preset");
    auto& keeps = *form.findChild<QCheckBox*>("proportions.keepProportions");
    QVERIFY(keeps.isChecked());
    width.setValue(2400);
    QCOMPARE(height.value(), 1600);
    height.setValue(400);
    QCOMPARE(width.value(), 600);
    width.selectAll();
    QTest::keyClicks(&width, "1");
    QTest::keyClicks(&width, "500"); // by digits, of which the first one alone is a very small picture
    QCOMPARE(form.settings().size, QSize(1500, 1000));
    height.setValue(height.maximum()); // what is too wide then is not cut off
    QCOMPARE(width.value(), width.maximum());
    QVERIFY(std::abs(1.5 * height.value() - width.value()) <= 1);
    preset.setCurrentIndex(preset.findText("Full HD"));
    emit preset.activated(preset.currentIndex());
    width.setValue(960);
    QCOMPARE(height.value(), 540);
    keeps.click();
    height.setValue(960);
    QCOMPARE(width.value(), 960);
    keeps.click();
    width.setValue(500);
    QCOMPARE(height.value(), 500);
}

/// By centimetres and resolution, of which the pixels follow; a resolution alone changes none of them.
void OutputTest::aPictureHasASizeInCentimetres()
{
    PictureForm form("print");
    form.setView({1200, 800}, {});
    auto& width = *form.findChild<QDoubleSpinBox*>("print.printWidth");
    auto& height = *form.findChild<QDoubleSpinBox*>("print.printHeight");
    auto& dpi = *form.findChild<QSpinBox*>("print.dpi");
    dpi.setValue(254);
    QCOMPARE(form.settings().size, QSize(1200, 800));
    QCOMPARE(width.value(), 12.0);
    QCOMPARE(height.value(), 8.0);
    width.setValue(6);
    QCOMPARE(form.settings().size, QSize(600, 400));
    QCOMPARE(height.value(), 4.0);
    dpi.setValue(508); // of a print that large
    QCOMPARE(form.settings().size, QSize(1200, 800));
    QCOMPARE(width.value(), 6.0);
    height.setValue(8);
    QCOMPARE(form.settings().size, QSize(2400, 1600));
    QCOMPARE(form.findChild<QComboBox*>("print.preset")->currentText(), QString("Custom"));
    width.setValue(12);
    dpi.selectAll();
    QTest::keyClicks(&dpi, "300"); // 3 and 30 are no resolutions that anybody wants
    QTest::keyClick(&dpi, Qt::Key_Return);
    QCOMPARE(form.settings().size, QSize(1417, 945));
    QCOMPARE(width.value(), 12.0);
    form.findChild<QSpinBox*>("print.width")->setValue(300); // from here on it is a number of pixels
    dpi.setValue(254);
    QCOMPARE(form.settings().size, QSize(300, 200));
    QCOMPARE(width.value(), 3.0);
}

/// By the ending of the file's name; what cannot be is told, and leaves nothing behind.
void OutputTest::aPictureIsSavedInManyFormats()
{
    PictureSettings wanted = settings({200, 150});
    wanted.dotsPerInch = 127;
    const auto save = [&](const QString& name) {
        PictureOrder order = pictureOrder(window_->workbench, window_->viewport(), wanted);
        order.target = window_->folder.filePath(name).toStdString();
        QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
        QSignalSpy failed(&window_->workbench.exporting(), &Exporting::saveFailed);
        window_->workbench.exporting().savePicture(order);
        const bool isDone = QTest::qWaitFor([&] { return saved.count() + failed.count() > 0; }, 60'000);
        return isDone && failed.count() > 0 ? failed.first().first().toString() : QString();
    };
    QCOMPARE(save("a.png"), QString());
    QCOMPARE(save("a.jpg"), QString());
    const QImage png(window_->folder.filePath("a.png")), jpeg(window_->folder.filePath("a.jpg"));
    QCOMPARE(jpeg.size(), png.size());
    QCOMPARE(jpeg.dotsPerMeterX(), 5000);
    QCOMPARE(save("a.tif"), QString());
    QCOMPARE(save("a.pdf"), QString());
    for (const auto& [name, start] :
         {std::pair("a.tif", QByteArray("II*\0", 4)), std::pair("a.pdf", QByteArray("%PDF"))}) {
        QFile file(window_->folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.read(4) == start, name);
    }
    wanted.transparent = true;
    QVERIFY(save("b.jpg").contains("no transparency"));
    QVERIFY(save("b.bmp").contains(".pdf"));
    QVERIFY(!QFile::exists(window_->folder.filePath("b.jpg")) && !QFile::exists(window_->folder.filePath("b.bmp")));
}

void OutputTest::aPictureSaysHowItWasMade()
{
    session().addIsovalue();
    QTRY_VERIFY(window_->settled());
    window_->find<QAction>("action.savePicture").trigger();
    const QString path = window_->folder.filePath("told.png");
    savePictureTo(path);
    QImageReader reader(path);
    QCOMPARE(reader.text("Software"), QString("TAn " TAN_VERSION));
    QCOMPARE(reader.text("Title"), QString("c60"));
    QVERIFY(reader.text("Description").contains("error"));
    const auto document = sessionFromText(*sessionInPicture(path.toStdString()), window_->folderPath());
    QVERIFY(document);
    QCOMPARE(document->identity, modelIdentity(*session().model()));
    QVERIFY(document->view == session().view());
    SessionDocument blanks = *document; // such as a folder may have
    blanks.model = "/a   folder  of models/c60.tan";
    const Picture small{.width = 2, .height = 2, .pixels = std::vector<std::array<std::uint8_t, 4>>(4)};
    QVERIFY(writePicture(small, path.toStdString(), {.texts = pictureTexts(blanks, "error 1 %", "/elsewhere")}));
    const auto again = sessionFromText(*sessionInPicture(path.toStdString()), "/elsewhere");
    QVERIFY(again);
    QCOMPARE(again->model, blanks.model);

    window_->find<QAction>("action.savePicture").trigger();
    window_->find<QCheckBox>("picture.metadata").setChecked(false);
    const QString silent = window_->folder.filePath("silent.png");
    savePictureTo(silent);
    QVERIFY(sessionInPicture(silent.toStdString())->empty());
}

void OutputTest::aPictureRestoresItsView()
{
    session().setError(3);
    Camera camera = window_->viewport().camera();
    camera.azimuth = 77;
    window_->viewport().setCamera(camera);
    QTRY_VERIFY(window_->settled());
    window_->find<QAction>("action.savePicture").trigger();
    const QString path = window_->folder.filePath("view.png");
    savePictureTo(path);
    session().setError(1);
    window_->viewport().setCamera({});
    window_->window.open(path);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("view.png"));
    QSignalSpy opened(&window_->workbench.opening().models(), &ModelOpening::viewRestored);
    window_->find<QPushButton>("message.answer").click();
    QTRY_COMPARE(opened.count(), 1);
    QCOMPARE(session().view().query.error, 3.0);
    QCOMPARE(window_->viewport().camera().azimuth, 77.0);
}

/// As it is seen, and what it says of itself is that, too; not the session's camera with another mesh.
void OutputTest::aPictureOfAPreviewIsOfOneView()
{
    const Camera before = session().view().camera;
    ViewValue frame = session().view();
    frame.query.error = 6;
    frame.camera.azimuth = 123;
    window_->workbench.scenes().previewView(frame);
    window_->viewport().setPreview(frame.camera);
    QTRY_VERIFY(window_->settled());
    QCOMPARE(pictureOrder(window_->workbench, window_->viewport(), settings({200, 150})).camera.azimuth, 123.0);
    window_->find<QAction>("action.savePicture").trigger();
    const QString path = window_->folder.filePath("preview.png");
    savePictureTo(path);
    const auto document = sessionFromText(*sessionInPicture(path.toStdString()), window_->folderPath());
    QVERIFY(document);
    QCOMPARE(document->view.query.error, 6.0);
    QCOMPARE(document->view.camera.azimuth, 123.0);
    QVERIFY(session().view().camera == before);
}

void OutputTest::backgroundsCanBeTransparent()
{
    PictureSettings wanted = settings({200, 150});
    wanted.transparent = true;
    PictureOrder order = pictureOrder(window_->workbench, window_->viewport(), wanted);
    const auto picture = drawPicture(order, {});
    QVERIFY(picture);
    QCOMPARE(imageOf(*picture).pixelColor(100, 2).alpha(), 0);
    QCOMPARE(imageOf(*picture).pixelColor(100, 75).alpha(), 255);
    order.transparent = false;
    QCOMPARE(imageOf(*drawPicture(order, {})).pixelColor(100, 2).alpha(), 255);
}

void OutputTest::picturesWaitForEachOther()
{
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
    for (int i = 0; i < 4; ++i) {
        PictureOrder order = pictureOrder(window_->workbench, window_->viewport(), settings({400, 300}));
        order.target = window_->folder.filePath(QString("p%1.png").arg(i)).toStdString();
        window_->workbench.exporting().savePicture(order);
    }
    QCOMPARE(window_->workbench.exporting().savingPicture().waiting(), 3);
    QTRY_COMPARE(saved.count(), 4);
    for (int i = 0; i < 4; ++i)
        QVERIFY(saved[i].first().toString().endsWith(QString("p%1.png").arg(i)));
}

void OutputTest::thePictureIsCopied()
{
    QGuiApplication::clipboard()->clear();
    QCOMPARE(window_->find<QAction>("action.copyPicture").shortcut(), QKeySequence("Ctrl+Shift+C"));
    window_->find<QAction>("action.copyPicture").trigger();
    QTRY_VERIFY(!QGuiApplication::clipboard()->image().isNull());
    const QImage copied = QGuiApplication::clipboard()->image();
    QCOMPARE(copied.size(), pixelsOf(window_->viewport()));
    PictureOrder order = pictureOrder(window_->workbench, window_->viewport(), settings(copied.size()));
    order.target = window_->folder.filePath("saved.png").toStdString();
    const QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
    window_->workbench.exporting().savePicture(order);
    QTRY_COMPARE(saved.count(), 1);
    const QImage expected(window_->folder.filePath("saved.png"));
    QVERIFY(copied.convertToFormat(QImage::Format_RGB32) == expected.convertToFormat(QImage::Format_RGB32));
}

QTEST_MAIN(OutputTest)
#include "output_test.moc"
