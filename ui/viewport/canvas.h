// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/animation/frame_clock.h"
#include "ui/animation/frame_pacer.h"
#include "ui/work/latest_job.h"

#include <tan/render.h>

#include <QImage>
#include <QString>
#include <QVariantAnimation>
#include <QWidget>

#include <memory>
#include <vector>

namespace tetra {

/// A scene, and of how many tetrahedra it was made.
struct SceneLevel {
    std::shared_ptr<const Scene> scene;
    std::uint64_t tetrahedra = 0;
};

/// What a canvas shows.
struct View {
    std::vector<SceneLevel> levels; ///< what is to be seen, then coarser ones for moving pictures; none: the background
    Camera camera;
    Colour background;
    bool moving = false; ///< camera or scene are on their way: quick pictures count more than fine ones
};

/// How the picture on the screen was drawn.
struct FrameReport {
    double seconds = 0; ///< that drawing took
    bool moving = false;
    double framesPerSecond = 0; ///< while moving; 0 if there were too few to tell
    double reduction = 1;       ///< of width and height
    std::uint64_t tetrahedra = 0;
    std::size_t cells = 0;        ///< of volumes that were drawn
    std::size_t cutCells = 0;     ///< of their visibility order (RenderStatistics)
    std::size_t brokenCycles = 0; ///< the same
};

/// Which back end the viewport draws with. Automatic takes OpenGL where a graphics card does the work; OpenGL that is
/// computed by the processor would only be slower than our own CPU back end. Gl takes it there, too. Where there is
/// none at all, all take the CPU.
enum class BackendChoice { Automatic, Cpu, Gl };

/// The part of the viewport that draws, with a back end in a worker, so that the window never waits for a picture:
/// while the camera moves pictures that keep up, of a coarser mesh or smaller; when it rests finer ones up to the best
/// (R23), which fade in (C4). It takes no input: that goes on to the viewport around it.
class Canvas : public QWidget {
    Q_OBJECT
public:
    explicit Canvas(BackendChoice choice = BackendChoice::Cpu, QWidget* parent = nullptr);
    ~Canvas() override;

    QString backendName() const;
    bool usesGl() const noexcept { return usesGl_; }
    void setView(const View& view);
    /// Pictures a second to hold while something moves.
    void setFrameRate(double perSecond) { pacer_.setFrameRate(perSecond); }
    double frameRate() const { return pacer_.frameRate(); }
    /// The rate to hold unless the user says otherwise.
    double usualFrameRate() const { return usesGl_ ? 30 : 15; }
    /// What is drawn while something moves.
    void setMovingKind(MovingQuality::Kind kind);
    /// True once the fine picture of the last view is on the screen.
    bool settled() const { return settled_ && fade_.state() != QAbstractAnimation::Running; }
    /// The picture that is on the screen, in its own pixels.
    QImage picture() const { return shown_; }

signals:
    void framePainted(const tetra::FrameReport& report);
    /// A picture could not be drawn; or OpenGL refused it, and the processor has drawn it.
    void failed(const QString& text);
    /// OpenGL does not work here after all: it draws nothing.
    void unusable(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A picture to draw.
    struct Order {
        SceneLevel level; ///< without a scene: the background
        std::size_t levelIndex = 0;
        Camera camera;
        PictureOptions options;
        double reduction = 1;
        bool moving = false;
        std::size_t step = 0; ///< of the refinement, if it does not move
        bool isLast = false;  ///< of the refinement: this is the fine picture
        quint64 view = 0;     ///< the number of the view
    };
    /// What the worker made.
    struct Drawn {
        QImage image{};
        QString error{};
        QString refusal{};       ///< why OpenGL does not draw this picture, which the processor has drawn
        bool isUnusable = false; ///< with an error: the back end draws nothing at all
        bool cancelled = false;
        double seconds = 0;
        RenderStatistics statistics{};
    };
    struct Backends;

    /// Width times height times those of a pixel.
    static double samplesOf(const Order& order);
    static Drawn draw(Backends& backends, const Order& order, const std::stop_token& stop);
    static Drawn drawWith(RenderBackend& backend, const Order& order, const std::stop_token& stop);
    QSize pixels() const { return size() * devicePixelRatioF(); }
    double pixelCount() const;
    int smoothSamples() const;
    bool bringsNothing(const View& before);
    void render();
    void drawMoving();
    void drawFull();
    void refine(std::size_t step);
    void submit(Order order);
    void arrived(const Order& order, const Drawn& drawn);
    void tellError(const Order& order, const Drawn& drawn);
    void tellRefusal(const QString& refusal);
    void showPicture(const Order& order, const QImage& image);
    void paint(QPainter& painter, const QRect& area) const;

    const bool usesGl_;
    View view_;
    QImage shown_;
    Camera shownCamera_;         ///< of that picture
    bool isShownCoarse_ = false; ///< it is not the fine one
    QImage fadedFrom_;           ///< what was seen before it, on its way to it
    QVariantAnimation fade_;
    bool settled_ = false;
    bool isTooSmooth_ = false; ///< the graphics card has no room for the smoothest pictures
    QString toldRefusal_;      ///< why the last picture was not drawn by OpenGL; empty if it was
    quint64 newest_ = 0;       ///< the number of the last view
    quint64 emptied_ = 0;      ///< pictures of views up to this number are not shown any more
    FramePacer pacer_;
    std::vector<RefinementStep> steps_; ///< of the view, while it rests
    FrameClock clock_;
    std::shared_ptr<Backends> backends_; ///< the worker's
    LatestJob job_;
};

} // namespace tetra
