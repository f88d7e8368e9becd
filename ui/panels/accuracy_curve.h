// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/error_meaning.h"
#include "core/view/accuracy_scale.h"

#include <QWidget>

#include <optional>

namespace tetra {

/// The curve of the paper's Fig. 10, of tetrahedra: mesh size against error, both logarithmic, with the chosen accuracy
/// and the budget marked. Clicking, dragging, the wheel and the arrow keys choose another accuracy; the line of the
/// budget can be dragged. Its error axis is that of accuracy_scale.h.
class AccuracyCurve : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyCurve(QWidget* parent = nullptr);

    /// `points` from coarse to fine, as sizeAgainstError() gives them; empty shows the axes only.
    void setCurve(std::vector<CurvePoint> points);
    void setMarked(const CurvePoint& chosen);
    /// Tetrahedra; none: there is no budget.
    void setBudget(std::optional<std::uint64_t> budget);
    /// Which error it is that the axis is of.
    void setErrorMeaning(ErrorMeaning meaning);

    /// The distances of the error axis from the left and the right edge, so that a slider can be laid out along it.
    int leftMargin() const;
    int rightMargin() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// By the user, in %.
    void chosen(double percent);
    /// By the user, in tetrahedra.
    void budgetChosen(quint64 budget);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF plot() const;
    double xOf(double percent) const;
    double yOf(double tetrahedra) const;
    void chooseAt(QPointF place);
    bool isOnBudget(double y) const;
    void paintAxes(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintBudget(QPainter& painter) const;
    void paintMark(QPainter& painter) const;

    std::vector<CurvePoint> points_;
    CurvePoint marked_;
    std::optional<std::uint64_t> budget_;
    ErrorMeaning errorMeaning_ = ErrorMeaning::Only;
    bool draggingBudget_ = false;
};

} // namespace tetra
