// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/pictures.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/widgets/message_bar.h"

using namespace tetra;

/// The viewport draws with OpenGL where there is a display, and shows what the CPU back end shows (B4).
class GlViewportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void showsThePictureOfTheCpu();
    void onePictureThatIsRefusedIsDrawnByTheCpu();

private:
    static QImage pictureOf(BackendChoice backend, const QString& backendName);
};

QImage GlViewportTest::pictureOf(BackendChoice backend, const QString& backendName)
{
    WindowFixture window(backend);
    const auto model = buildSampleModel(*window.host, sampleDataset(24), window.folderPath());
    window.window.show();
    if (!QTest::qWaitForWindowExposed(&window.window, patiently(5000)))
        qFatal("the window does not appear");
    window.window.open(QString::fromStdString(model));
    const auto settled = [&] { return window.workbench.session().model() && window.settled(); };
    if (!waitFor(settled, 60000))
        qFatal("the picture does not come");
    if (window.viewport().backendName() != backendName)
        qFatal("drawn with %s", qPrintable(window.viewport().backendName()));
    return window.viewport().picture();
}

void GlViewportTest::initTestCase()
{
    if (QGuiApplication::platformName() != "xcb")
        QSKIP("skipped: needs an X display");
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("gl_viewport");
    QSettings().clear();
}

void GlViewportTest::showsThePictureOfTheCpu()
{
    const QImage gl = pictureOf(BackendChoice::Gl, "OpenGL");
    const QImage cpu = pictureOf(BackendChoice::Cpu, "CPU");
    QCOMPARE(gl.size(), cpu.size());
    const PictureDifference found = difference(gl, cpu);
    gl.save(TAN_BINARY_DIR "/tests/gl-viewport.png");
    QVERIFY2(found.meanChannel < 0.5, qPrintable(QString::number(found.meanChannel)));
    QVERIFY2(found.strikingPixels < 0.005, qPrintable(QString::number(found.strikingPixels)));
    // And there is something to see: the surface, which is of bone.
    int bone = 0;
    for (int y = 0; y < gl.height(); ++y)
        for (int x = 0; x < gl.width(); ++x)
            bone += qRed(gl.pixel(x, y)) > qBlue(gl.pixel(x, y)) + 12;
    QVERIFY(bone > gl.width() * gl.height() / 20);
}

/// More clip planes than OpenGL takes: nothing is wrong with it, and it draws what comes next.
void GlViewportTest::onePictureThatIsRefusedIsDrawnByTheCpu()
{
    WindowFixture window(BackendChoice::Gl);
    window.window.resize(800, 500);
    const auto model = buildSampleModel(*window.host, sampleDataset(10), window.folderPath());
    window.window.show();
    window.window.open(QString::fromStdString(model));
    Session& session = window.workbench.session();
    QTRY_VERIFY(session.model() && window.settled());
    const QImage before = window.viewport().picture();

    QStringList planes;
    for (int plane = 0; plane < 17; ++plane)
        planes << "1,0,0,4";
    session.setSetting("clip", planes.join(';').toStdString());
    QTRY_COMPARE(window.messages().size(), 1);
    QVERIFY2(window.messages().first().startsWith("OpenGL cannot draw this picture; the CPU draws it instead."),
             qPrintable(window.messages().first()));
    QTRY_VERIFY(window.settled());
    QCOMPARE(window.viewport().backendName(), QString("OpenGL"));
    const QImage refused = window.viewport().picture();
    QVERIFY(difference(refused, before).strikingPixels > 0.01);          // it is cut
    session.setCamera(seenFrom(session.view().camera, NamedView::Left)); // again, and nothing more is said
    QTRY_VERIFY(window.settled());
    QVERIFY(window.viewport().picture() != refused);
    QCOMPARE(window.messages().size(), 1);

    session.undoStack().undo();
    session.undoStack().undo();
    window.find<MessageBar>("messages").clear(); // it takes height from the picture
    QTRY_VERIFY(window.settled() && window.viewport().picture().size() == before.size());
    QCOMPARE(window.viewport().backendName(), QString("OpenGL"));
    QCOMPARE(window.viewport().picture(), before);
}

QTEST_MAIN(GlViewportTest)
#include "gl_viewport_test.moc"
