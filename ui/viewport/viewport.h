// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/camera_controls.h"
#include "ui/viewport/canvas.h"
#include "ui/viewport/make_canvas.h"
#include "ui/viewport/picture_projection.h"

#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>

#include <optional>

namespace tetra {

/// Shows a scene and moves the camera by mouse and keyboard. Draws with OpenGL where that works, else with the CPU.
class Viewport : public QWidget {
    Q_OBJECT
public:
    explicit Viewport(BackendChoice choice = BackendChoice::Automatic, QWidget* parent = nullptr);

    /// What is to be seen, made of so many tetrahedra. Drafts of the last one go.
    void setScene(std::shared_ptr<const Scene> scene, std::uint64_t tetrahedra = 0);
    /// The scene of coarser meshes, falling in size, to be drawn while it moves; a new scene of the same mesh keeps
    /// them.
    void setDrafts(std::vector<SceneLevel> drafts);
    /// Without the outlines.
    const std::shared_ptr<const Scene>& scene() const noexcept { return scene_.scene; }
    /// Lines that belong to a tool, not to what is looked at: drawn with the scene, and not saved with a picture.
    void setOutlines(std::vector<LineSet> outlines);
    /// The one that was asked for; the picture may still be on its way there.
    const Camera& camera() const noexcept { return camera_; }
    const Colour& background() const noexcept { return view_.background; }
    /// Nothing: the one that fits the palette is used.
    const std::optional<Colour>& chosenBackground() const noexcept { return background_; }
    /// From places to this widget's coordinates.
    PictureProjection projection() const { return {view_.camera, size()}; }

    /// Which gesture of the user the present camera belongs to: a drag, a series of wheel turns or keys without a
    /// longer pause, or one jump. Changes when the next one begins.
    std::uint64_t gesture() const noexcept { return gesture_; }

    /// The view of something newly opened, at once: no choice of the user's. Told by started() first.
    void startFrom(const Camera& camera, const std::optional<Colour>& background);
    /// The same with a camera that looks from the direction of `camera` and shows all of `bounds`: also of a view of
    /// another shape, as long as nothing else moves the camera.
    void startFitted(const Camera& camera, const Eigen::AlignedBox3d& bounds);
    void setCamera(const Camera& camera);
    /// The same, by a short glide unless motion is reduced: camera() is the new one at once. A gesture of its own.
    void glideTo(const Camera& camera);
    /// Shows what another camera sees, in place of its own, until there is none any more; moving the camera ends it.
    void setPreview(const std::optional<Camera>& camera);
    bool previewing() const noexcept { return previewing_; }
    /// The camera that is looked through.
    const Camera& shownCamera() const noexcept { return view_.camera; }
    /// Nothing: the colour that fits the palette.
    void setBackground(const std::optional<Colour>& background);
    /// What is seen is being dragged, by whatever control: pictures that follow count more than fine ones.
    void setFollowing(bool following);
    /// What is seen changes: a quick picture of it comes first, the fine one when nothing else changes for a moment.
    void expectChange();
    /// Pictures a second to hold while something moves; nothing: as many as fit the back end.
    void setFrameRate(std::optional<double> perSecond);
    double usualFrameRate() const { return canvas_->usualFrameRate(); }

    /// Shows all of these bounds, from the present direction.
    void fit(const Eigen::AlignedBox3d& bounds);
    /// Width / height.
    double aspectRatio() const;
    void seeFrom(NamedView view);
    void setPerspective(bool perspective);

    QString backendName() const;
    /// True once the fine picture of the present scene and camera is on the screen.
    bool settled() const;
    QImage picture() const;

signals:
    /// A view that no choice of the user led to.
    void started();
    /// Also while a picture glides to it.
    void cameraChanged();
    void previewChanged(bool on);
    void resized();
    void backgroundChanged();
    void framePainted(const tetra::FrameReport& report);
    void failed(const QString& text);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void useCanvas(Canvas* canvas);
    void followPalette();
    void moveCamera(const Camera& camera);
    void showGlide(double part);
    void endPreview();
    SceneLevel withOutlines(const SceneLevel& level) const;
    void show();
    void rest();

    SceneLevel scene_;
    std::vector<SceneLevel> drafts_;
    std::vector<LineSet> outlines_;
    View view_; ///< its scene has the outlines, too; its camera may be on the way
    Camera camera_;
    std::optional<Camera> startFit_; ///< startFitted() with these
    Eigen::AlignedBox3d startBounds_;
    Canvas* canvas_ = nullptr;         ///< a child widget
    bool previewing_ = false;          ///< the view's camera is another one
    std::optional<Colour> background_; ///< else that of the palette
    std::optional<double> frameRate_;  ///< else the usual one of the back end
    bool following_ = false;
    QPointF lastPosition_;
    QTimer resting_;
    QTimer pausing_; ///< from the last move until a series of moves has ended
    std::uint64_t gesture_ = 1;
    Camera glideFrom_;
    QVariantAnimation glide_;
};

} // namespace tetra
