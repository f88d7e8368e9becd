// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool_desk.h"

#include <QWidget>

namespace tetra {

/// Paints the tools of plugins over the viewport and hands them its events, before the camera and what is below it get
/// them.
class ToolOverlay : public QWidget {
    Q_OBJECT
public:
    /// A child of the viewport, made after all that lies below it; the others outlive it.
    ToolOverlay(ToolDesk& desk, Workbench& workbench, Viewport& viewport);

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ToolDesk& desk_;
    Workbench& workbench_;
    Viewport& viewport_;
};

} // namespace tetra
