// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/camera_controls.h"
#include "ui/viewport/make_canvas.h"
#include "ui/viewport/picture_projection.h"

#include <QTimer>
#include <QWidget>

namespace tetra {

/// Shows a scene and moves the camera by mouse and keyboard. Draws with OpenGL where that works, else with the CPU.
class Viewport : public QWidget {
    Q_OBJECT
public:
    explicit Viewport(BackendChoice choice = BackendChoice::Automatic, QWidget* parent = nullptr);

    void setScene(std::shared_ptr<const Scene> scene);
    /// Without the outlines.
    const std::shared_ptr<const Scene>& scene() const noexcept { return scene_; }
    /// Lines that belong to a tool, not to what is looked at: drawn with the scene, and not saved with a picture.
    void setOutlines(std::vector<LineSet> outlines);
    const Camera& camera() const noexcept { return view_.camera; }
    const Colour& background() const noexcept { return view_.background; }
    /// From places to this widget's coordinates.
    PictureProjection projection() const { return {view_.camera, size()}; }

    /// Shows all of these bounds, from the present direction.
    void fit(const Eigen::AlignedBox3d& bounds);
    void seeFrom(NamedView view);
    void setPerspective(bool perspective);

    QString backendName() const;
    /// True once the fine picture of the present scene and camera is on the screen.
    bool settled() const;
    QImage picture() const;

signals:
    void cameraChanged();
    void framePainted(double seconds);
    void failed(const QString& text);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void useCanvas(Canvas* canvas);
    void followPalette();
    void moveCamera(const Camera& camera);
    void show();
    void rest();

    std::shared_ptr<const Scene> scene_;
    std::vector<LineSet> outlines_;
    View view_;                ///< its scene has the outlines, too
    Canvas* canvas_ = nullptr; ///< a child widget
    QPointF lastPosition_;
    QTimer resting_;
};

} // namespace tetra
