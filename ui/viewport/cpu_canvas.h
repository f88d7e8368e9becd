// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/canvas.h"
#include "ui/viewport/frame_clock.h"
#include "ui/work/latest_job.h"

#include <tan/render.h>

#include <QWidget>

namespace tetra {

/// Draws with the CPU back end in a worker: while the camera moves pictures that keep up, of a coarser mesh or smaller;
/// when it rests finer ones up to the best (R23).
class CpuCanvas : public QWidget, public Canvas {
    Q_OBJECT
public:
    explicit CpuCanvas(QWidget* parent = nullptr);
    ~CpuCanvas() override;

    QWidget* widget() override { return this; }
    QString backendName() const override;
    void show(const View& view) override;
    void setFrameRate(double perSecond) override { pacer_.setFrameRate(perSecond); }
    double usualFrameRate() const override { return 15; }
    bool settled() const override { return settled_; }
    QImage picture() override { return shown_; }

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
        QImage image;
        QString error;
        bool cancelled = false;
        double seconds = 0;
        RenderStatistics statistics;
    };
    static Drawn draw(RenderBackend& backend, const Order& order, const std::stop_token& stop);
    QSize pixels() const { return size() * devicePixelRatioF(); }
    double pixelCount() const;
    bool bringsNothing(const View& before);
    void render();
    void drawMoving();
    void refine(std::size_t step);
    void submit(Order order);
    void arrived(const Order& order, const Drawn& drawn);

    View view_;
    QImage shown_;
    bool settled_ = false;
    quint64 newest_ = 0;  ///< the number of the last view
    quint64 emptied_ = 0; ///< pictures of views up to this number are not shown any more
    FramePacer pacer_;
    std::vector<RefinementStep> steps_; ///< of the view, while it rests
    FrameClock clock_;
    /// Of moving pictures and of fine ones: each keeps what its own mesh needs.
    std::shared_ptr<RenderBackend> movingBackend_;
    std::shared_ptr<RenderBackend> fineBackend_;
    LatestJob job_;
};

} // namespace tetra
