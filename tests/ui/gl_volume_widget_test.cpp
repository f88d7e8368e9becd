// SPDX-License-Identifier: GPL-3.0-or-later
// A volume in a widget's own OpenGL context and framebuffer, as the window's canvas draws it. Needs an X display.
#include "core/render/gl/scene_painter.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/gl_volume_scenes.h"
#include "tests/render/same_picture.h"

#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QTest>

using namespace tetra;
using namespace tetra::testing;

namespace {

class SceneWidget final : public QOpenGLWidget {
public:
    SceneWidget(Scene scene, const Camera& camera) : scene_(std::move(scene)), camera_(camera)
    {
        QSurfaceFormat format;
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        format.setAlphaBufferSize(0);
        setFormat(format);
    }
    ~SceneWidget() override
    {
        makeCurrent();
        painter_.reset();
        doneCurrent();
    }

    PictureOptions options() const
    {
        const QSize pixels = size() * devicePixelRatioF();
        return {.width = pixels.width(), .height = pixels.height(), .background = {0.9f, 0.9f, 0.8f}};
    }
    int painted() const { return painted_; }
    QString error() const { return error_; }

protected:
    void initializeGL() override
    {
        auto painter = ScenePainter::make([](const char* name) {
            return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
        });
        if (painter)
            painter_ = std::move(*painter);
        else
            error_ = QString::fromStdString(painter.error().text());
    }
    void paintGL() override
    {
        if (!painter_)
            return;
        const Status status = painter_->draw(scene_, camera_, options(), defaultFramebufferObject());
        if (!status)
            error_ = QString::fromStdString(status.error().text());
        else if (const unsigned code = context()->functions()->glGetError(); code != 0)
            error_ = QString("OpenGL error %1").arg(code, 0, 16);
        ++painted_;
    }

private:
    Scene scene_;
    Camera camera_;
    std::unique_ptr<ScenePainter> painter_;
    int painted_ = 0;
    QString error_;
};

Picture pictureOf(QImage image)
{
    image = image.convertToFormat(QImage::Format_RGBA8888);
    Picture picture{image.width(), image.height(), {}};
    picture.pixels.resize(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y)
        std::memcpy(&picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width())],
                    image.constScanLine(y), static_cast<std::size_t>(image.width()) * 4);
    return picture;
}

} // namespace

class GlVolumeWidgetTest : public QObject {
    Q_OBJECT
private slots:
    void showsThePictureOfTheCpu_data()
    {
        QTest::addColumn<QString>("surfaces");
        QTest::newRow("volume") << "none";
        QTest::newRow("hybrid") << "translucent";
    }
    void showsThePictureOfTheCpu()
    {
        if (QGuiApplication::platformName() != "xcb")
            QSKIP("skipped: needs an X display");
        QFETCH(QString, surfaces);
        SceneParts scene = sceneNamed("refined lattice", "ramps");
        addSurfaces(scene, surfaces);
        const Camera camera = cameraFor(scene, true);
        SceneWidget widget(scene, camera);
        widget.resize(160, 120);
        widget.show();
        QVERIFY(QTest::qWaitForWindowExposed(&widget, tetra::patiently(5000)));
        QTRY_VERIFY(widget.painted() > 0);
        const Picture gl = pictureOf(widget.grabFramebuffer());
        const Picture again = pictureOf(widget.grabFramebuffer());
        QCOMPARE(widget.error(), QString());
        const auto cpu = makeCpuBackend()->render(scene, camera, widget.options());
        QVERIFY(cpu.ok());
        QVERIFY(shareOfOther(*cpu, cpu->pixels.front()) > 0.1);
        QVERIFY(samePicture(*cpu, gl, again, "gl_volume_widget_" + surfaces));
    }
};

QTEST_MAIN(GlVolumeWidgetTest)
#include "gl_volume_widget_test.moc"
