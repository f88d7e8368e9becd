// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/histogram_view.h"

#include "plugins/widgets/number_text.h"
#include "ui/session/logarithm_text.h"

#include <QPainter>

namespace tetra {

HistogramView::HistogramView(QWidget* parent) : QWidget(parent)
{
    setObjectName("statistics.histogram");
    setAccessibleName(tr("Histogram"));
    setToolTip(tr("How often the values of the displayed mesh occur, on a logarithmic scale; from the smallest to the "
                  "largest value, in data units"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void HistogramView::setHistogram(std::shared_ptr<const ValueHistogram> histogram,
                                 const std::optional<ValueRange>& logarithms)
{
    histogram_ = std::move(histogram);
    logarithms_ = logarithms;
    update();
}

QSize HistogramView::sizeHint() const
{
    return {240, 5 * fontMetrics().height()};
}

QSize HistogramView::minimumSizeHint() const
{
    return {120, 4 * fontMetrics().height()};
}

void HistogramView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const int line = fontMetrics().height();
    const QRectF plot = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -line - 0.5);
    if (histogram_ && !histogram_->counts.empty()) {
        const std::uint64_t highest = histogram_->highest();
        const double width = plot.width() / static_cast<double>(histogram_->counts.size());
        double left = plot.left();
        for (const std::uint64_t count : histogram_->counts) {
            const double height = barHeight(count, highest, true) * plot.height();
            painter.fillRect(QRectF(left, plot.bottom() - height, width, height), palette().highlight());
            left += width;
        }
        const auto end = [&](double value) {
            return logarithms_ ? antilogarithmText(value, *logarithms_)
                               : valueText(value, histogram_->largest - histogram_->least);
        };
        const QRect axis(0, height() - line, this->width(), line);
        painter.drawText(axis, Qt::AlignLeft, end(histogram_->least));
        painter.drawText(axis, Qt::AlignRight, end(histogram_->largest));
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(plot);
}

} // namespace tetra
