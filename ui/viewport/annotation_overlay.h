// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace tetra {

class Viewport;
class Workbench;

/// Paints the session's annotations over the viewport, whatever draws it; takes no input.
class AnnotationOverlay : public QWidget {
    Q_OBJECT
public:
    /// A child of the viewport, below what is made after it.
    AnnotationOverlay(Workbench& workbench, Viewport& viewport);

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Workbench& workbench_;
    Viewport& viewport_;
};

} // namespace tetra
