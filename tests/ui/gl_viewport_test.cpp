// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/pictures.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

using namespace tetra;

/// The viewport draws with OpenGL where there is a display, and shows what the CPU back end shows (B4).
class GlViewportTest : public QObject {
    Q_OBJECT
private slots:
    void showsThePictureOfTheCpu();

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

void GlViewportTest::showsThePictureOfTheCpu()
{
    if (QGuiApplication::platformName() != "xcb")
        QSKIP("skipped: needs an X display");
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("gl_viewport");
    QSettings().clear();
    const QImage gl = pictureOf(BackendChoice::Gl, "OpenGL");
    const QImage cpu = pictureOf(BackendChoice::Cpu, "CPU");
    QCOMPARE(gl.size(), cpu.size());
    const PictureDifference found = difference(gl, cpu);
    gl.save(TAN_BINARY_DIR "/tests/gl-viewport.png");
    QVERIFY2(found.meanChannel < 0.5, qPrintable(QString::number(found.meanChannel)));
    QVERIFY2(found.strikingPixels < 0.005, qPrintable(QString::number(found.strikingPixels)));
    // And there is something to see: the surface's orange.
    int orange = 0;
    for (int y = 0; y < gl.height(); ++y)
        for (int x = 0; x < gl.width(); ++x)
            orange += qRed(gl.pixel(x, y)) > qBlue(gl.pixel(x, y)) + 60;
    QVERIFY(orange > gl.width() * gl.height() / 20);
}

QTEST_MAIN(GlViewportTest)
#include "gl_viewport_test.moc"
