// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/render_backend.h"
#include "ui/viewport/canvas.h"
#include "ui/work/latest_job.h"

#include <QWidget>

namespace tetra {

/// Draws with the CPU back end in a worker: coarse pictures that keep up while the camera moves, the fine one when it
/// rests.
class CpuCanvas : public QWidget, public Canvas {
    Q_OBJECT
public:
    explicit CpuCanvas(QWidget* parent = nullptr);
    ~CpuCanvas() override;

    QWidget* widget() override { return this; }
    QString backendName() const override;
    void show(const View& view) override;
    bool settled() const override { return settled_; }
    QImage picture() override { return shown_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// What the worker made.
    struct Drawn {
        QImage image;
        QString error;
        bool cancelled = false;
        double seconds = 0;
        quint64 number = 0;
        bool fine = false;
    };
    static Drawn draw(RenderBackend& backend, const View& view, const PictureOptions& options,
                      const std::stop_token& stop);
    void render();
    int reduction(QSize pixels) const;
    void arrived(const Drawn& drawn);

    View view_;
    QImage shown_;
    bool settled_ = false;
    quint64 newest_ = 0;
    double secondsPerPixel_ = 0; ///< of the last coarse pictures
    std::shared_ptr<RenderBackend> backend_;
    LatestJob job_;
};

} // namespace tetra
