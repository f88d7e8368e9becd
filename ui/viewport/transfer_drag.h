// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QPointF>
#include <QSizeF>

class QMouseEvent;

namespace tetra {

class Viewport;

/// What a drag by `pixels` in a picture of `size` does to a transfer function: to the right and left it is shifted, by
/// all of `range` over the picture's width; upwards it is widened about its middle, downwards narrowed.
TransferFunction draggedTransfer(const TransferFunction& function, QPointF pixels, QSizeF size, ValueRange range);

/// Ctrl and the left button in the picture drag the transfer function, where the rendering mode has one; of several the
/// one that is chosen in the editor: one undo step a drag. Takes the viewport's events before the camera gets them.
class TransferDrag : public QObject {
    Q_OBJECT
public:
    /// A child of the viewport; the workbench outlives it.
    TransferDrag(Workbench& workbench, Viewport& viewport);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool press(const QMouseEvent& event);

    Workbench& workbench_;
    Viewport& viewport_;
    std::optional<QPointF> from_; ///< of the drag
    EditedTransfer edited_;       ///< when it began
};

} // namespace tetra
