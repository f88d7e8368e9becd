// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"
#include "ui/viewport/camera_controls.h"
#include "ui/viewport/canvas.h"
#include "ui/viewport/view_projection.h"

#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>

#include <chrono>
#include <optional>

namespace tetra {

/// Shows a scene from the session's camera, which it asks the session to move by mouse and keyboard: one step to undo
/// for each gesture. What else moves the camera, it glides there. Draws with OpenGL where that works, else with the
/// CPU.
class Viewport : public QWidget {
    Q_OBJECT
public:
    explicit Viewport(Session& session, BackendChoice choice = BackendChoice::Automatic, QWidget* parent = nullptr);

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
    const Camera& camera() const noexcept { return session_.view().camera; }
    /// The session's, or the one that fits the palette.
    const Colour& background() const noexcept { return view_.background; }
    /// Whether the background is dark if nobody has chosen one, and whatever the desktop's colours are.
    void setDarkGround(bool dark);
    /// Where in the picture that lies which is seen at a pixel: elsewhere if the lens is there.
    QPointF beneathLens(QPointF pixel) const;
    /// From places to this widget's coordinates.
    ViewProjection projection() const { return {view_.camera, size()}; }

    /// Of the user's: a drag, or a series of wheel turns or keys without a longer pause.
    Gesture gesture() const noexcept { return gesture_; }

    /// As if it were moved by hand.
    void setCamera(const Camera& camera);
    /// Shows what another camera sees, in place of its own, until there is none any more; moving the camera ends it.
    void setPreview(const std::optional<Camera>& camera);
    bool previewing() const noexcept { return previewing_; }
    /// The camera that is looked through.
    const Camera& shownCamera() const noexcept { return view_.camera; }
    /// What is seen is being dragged, by whatever control: pictures that follow count more than fine ones.
    void setFollowing(bool following);
    /// What is seen changes: a quick picture of it comes first, the fine one when nothing else changes for a moment.
    void expectChange();
    /// Pictures a second to hold while something moves; nothing: as many as fit the back end.
    void setFrameRate(std::optional<double> perSecond);
    /// That is held.
    double frameRate() const { return canvas_->frameRate(); }
    double usualFrameRate() const { return canvas_->usualFrameRate(); }
    /// What is drawn while something moves (C4).
    void setMovingKind(MovingQuality::Kind kind);
    /// So long after the last move the full picture is drawn.
    void setIdleTime(std::chrono::milliseconds time) { resting_.setInterval(time); }
    std::chrono::milliseconds idleTime() const { return resting_.intervalAsDuration(); }
    static constexpr auto usualIdleTime = std::chrono::milliseconds(150);

    QString backendName() const;
    bool usesGl() const { return canvas_->usesGl(); }
    /// True once the fine picture of the present scene and camera is on the screen.
    bool settled() const;
    QImage picture() const;

signals:
    /// The session's, or the one that is looked through while a picture glides there.
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
    void followBackground();
    void moveByHand(const Camera& camera);
    void followCamera();
    void showCamera();
    void glide();
    void showGlide(double part);
    void endPreview();
    SceneLevel withOutlines(const SceneLevel& level) const;
    void show();
    void rest();

    Session& session_;
    SceneLevel scene_;
    std::vector<SceneLevel> drafts_;
    std::vector<LineSet> outlines_;
    View view_;                       ///< its scene has the outlines, too; its camera may be on the way
    Canvas* canvas_ = nullptr;        ///< a child widget
    bool previewing_ = false;         ///< the view's camera is another one
    bool darkGround_ = false;         ///< that is wanted
    bool byHand_ = false;             ///< the session's camera is being moved from here: no glide
    std::optional<double> frameRate_; ///< else the usual one of the back end
    MovingQuality::Kind movingKind_ = MovingQuality::Kind::FrameRate;
    bool following_ = false;
    QPointF lastPosition_;
    QTimer resting_;
    QTimer pausing_; ///< from the last move until a series of moves has ended
    Gesture gesture_ = 0;
    Camera glideFrom_;
    QVariantAnimation glide_;
};

} // namespace tetra
