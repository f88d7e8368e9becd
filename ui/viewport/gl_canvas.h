// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/canvas.h"
#include "ui/viewport/frame_clock.h"

#include <tan/render.h>

#include <QOpenGLWidget>

namespace tetra {

class ScenePainter;

/// Draws with OpenGL into the window.
class GlCanvas : public QOpenGLWidget, public Canvas {
    Q_OBJECT
public:
    explicit GlCanvas(QWidget* parent = nullptr);
    ~GlCanvas() override;

    QWidget* widget() override { return this; }
    QString backendName() const override;
    void show(const View& view) override;
    void setFrameRate(double perSecond) override { pacer_.setFrameRate(perSecond); }
    double usualFrameRate() const override { return 30; }
    bool settled() const override { return settled_; }
    QImage picture() override { return grabFramebuffer(); }

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;

private:
    Status draw(const SceneLevel& level, const PictureOptions& options);
    int smoothSamples() const;
    void giveUp(const QString& text);
    void release();

    View view_;
    bool settled_ = false;
    bool smoothing_ = false;   ///< the fine picture of the view was drawn: now the smooth one
    bool isTooSmooth_ = false; ///< the graphics card has no room for that
    bool givenUp_ = false;
    FramePacer pacer_;
    FrameClock clock_;
    std::unique_ptr<ScenePainter> painter_;
};

/// How well OpenGL works here.
enum class GlSupport { None, Software, Hardware };

/// Tries a context off the screen; where showing a QOpenGLWidget would crash, it is none.
GlSupport glSupport();

} // namespace tetra
