// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QProxyStyle>

namespace tetra {

/// The contrast of two colours, 1 (none) to 21 (black and white), as WCAG 2.1 defines it; opaque ones.
double contrast(const QColor& one, const QColor& other);

/// Qt's style Fusion with what must be seen in any palette: the outlines of check boxes and radio buttons, and of
/// buttons that are pressed in, stand out from the window and from their own ground by a contrast of 3 at least (WCAG
/// 2.1, 1.4.11), hints from the window by 4.5 (1.4.3). Fusion's own outlines are darker than the window, which hardly
/// shows on a dark one.
class LegibleStyle : public QProxyStyle {
    Q_OBJECT
public:
    LegibleStyle();

    using QProxyStyle::polish;
    void polish(QPalette& palette) override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
};

/// Takes it where the desktop's style is Fusion, as it is where the desktop brings none of its own; colours stay the
/// desktop's.
void useLegibleStyle();

} // namespace tetra
