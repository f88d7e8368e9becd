// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/scrolled_column.h"

#include <QEvent>
#include <QStyle>

#include <algorithm>

namespace tetra {
namespace {

constexpr int leastHeight = 80;

} // namespace

ScrolledColumn::ScrolledColumn(QWidget* content, QWidget* parent) : QScrollArea(parent)
{
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    content->installEventFilter(this);
}

QSize ScrolledColumn::sizeHint() const
{
    return widget()->sizeHint().expandedTo(minimumSizeHint());
}

/// A style may need room for a scroll bar beside the content.
QSize ScrolledColumn::minimumSizeHint() const
{
    const QSize content = widget()->minimumSizeHint();
    const bool overlaps = style()->styleHint(QStyle::SH_ScrollBar_Transient, nullptr, this) != 0;
    const int bar = overlaps ? 0 : style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    return {content.width() + bar, std::min(content.height(), leastHeight)};
}

bool ScrolledColumn::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

} // namespace tetra
