// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/camera_controls.h"
#include "ui/viewport/make_canvas.h"

#include <QTimer>
#include <QWidget>

namespace tetra {

/// Shows a scene and moves the camera by mouse and keyboard. Draws with OpenGL where that works, else with the CPU.
class Viewport : public QWidget {
    Q_OBJECT
public:
    explicit Viewport(BackendChoice choice = BackendChoice::Automatic, QWidget* parent = nullptr);

    void setScene(std::shared_ptr<const Scene> scene);
    const std::shared_ptr<const Scene>& scene() const noexcept { return view_.scene; }
    const Camera& camera() const noexcept { return view_.camera; }
    const Colour& background() const noexcept { return view_.background; }

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
    void rest();

    View view_;
    Canvas* canvas_ = nullptr; ///< a child widget
    QPointF lastPosition_;
    QTimer resting_;
};

} // namespace tetra
