// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/editor.h"
#include "plugins/editors/transferfunction/transfer_plot.h"

#include <QWidget>

#include <memory>

namespace tetra {

/// The picture of the transfer function, with the values of the mesh behind it, and its points to be moved by
/// mouse and keys (R18): double click adds one, Delete takes the selected one away, arrows move it (finer with Ctrl),
/// Tab and Shift+Tab go from point to point. A drag and a held key are one step of the window's undo stack each.
class TransferCanvas : public QWidget {
    Q_OBJECT
public:
    explicit TransferCanvas(EditorHost& host, QWidget* parent = nullptr);

    /// The point that keys and number boxes are about; none if nothing is selected.
    std::optional<std::size_t> selected() const noexcept { return selected_; }
    void select(std::optional<std::size_t> point);
    /// Whether rare values are to be seen, too.
    void setLogarithmic(bool logarithmic);
    /// The model or its transfer function has changed.
    void refresh();
    TransferPlot plot() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void selectionChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    const TransferFunction& function() const;
    TransferLimits limits() const;
    void move(double value, double opacity);
    void moveByKey(int right, int up, bool fine);
    void describeSelected();
    void paintHistogram(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintColours(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;

    EditorHost& host_;
    std::optional<std::size_t> selected_;
    bool logarithmic_ = true;
    bool dragging_ = false;
    QPointF grabbedBeside_; ///< from the pointer to the point
};

} // namespace tetra
