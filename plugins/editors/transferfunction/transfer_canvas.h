// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/editors/transferfunction/editor_state.h"

#include <QWidget>

namespace tetra {

/// The picture of the transfer function (R18), with the values of the mesh behind it and the isovalues and the mask
/// before it, to be edited by mouse and keys; canvas_input.cpp and canvas_keys.cpp say which. A drag and a held key are
/// one step of the window's undo stack each.
class TransferCanvas : public QWidget {
    Q_OBJECT
public:
    /// `state` outlives it.
    explicit TransferCanvas(EditorState& state, QWidget* parent = nullptr);

    EditorState& state() const noexcept { return state_; }
    /// The point that keys and number boxes are about; none if nothing is selected.
    std::optional<std::size_t> selected() const { return state_.currentPoint(); }
    void select(std::optional<std::size_t> point);
    TransferPlot plot() const;
    /// What is under the pointer: a point, the handle of an isovalue, the handle or the line of an end of the mask.
    EditorItem itemAt(QPointF place) const;
    /// The value under the pointer; none if it is elsewhere.
    std::optional<double> pointed() const { return pointed_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The pointer is over another value, or has left.
    void pointedChanged();
    /// A point was double clicked, or the key for it pressed.
    void colourWanted();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    /// What a pressed button holds, and how everything was when it was pressed.
    struct Grab {
        enum class What { Nothing, Points, Item, Band, View };
        What what = What::Nothing;
        QPointF from;
        QPointF to;
        TransferPlot plot;
        TransferLimits limits;
        JoinedFunction function;
        TransferSelection selection;
        EditorView view;
        bool moved = false;
    };

    const JoinedFunction& function() const { return state_.joinedFunction(); }
    CanvasScene scene() const;
    void describeCurrent();
    void point(std::optional<double> value);
    void beginDrag(Grab::What what, QPointF from);
    void pressPoint(std::size_t point, QPointF place, Qt::KeyboardModifiers modifiers);
    void pressMenu(QPointF place);
    bool addOnCurve(QPointF place);
    void dragPoints(QPointF to, bool oneWay);
    void dragItem(QPointF to);
    void dragBand(QPointF to);
    void dragView(QPointF to);
    void showCursorFor(QPointF place);
    QString tipFor(const EditorItem& item) const;
    QString wholeTextOf(double value) const;
    bool editByKey(const QKeyEvent& event);
    bool moveByKey(const QKeyEvent& event);
    bool lookByKey(const QKeyEvent& event);
    bool groupByKey(const QKeyEvent& event);
    void moveCurrent(int right, int up, double step);

    EditorState& state_;
    Grab grab_;
    std::optional<double> pointed_;
};

/// The keys of which the canvas takes what the window's shortcuts would take otherwise.
bool isCanvasKey(const QKeyEvent& event);

} // namespace tetra
