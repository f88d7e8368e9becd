// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>
#include <tan/transfer.h>

#include <QWidget>

#include <memory>
#include <optional>

namespace tetra {

/// How often the values of the mesh that is shown occur, on a logarithmic scale, with the ends of their range.
class HistogramView : public QWidget {
    Q_OBJECT
public:
    explicit HistogramView(QWidget* parent = nullptr);

    /// None: an empty frame. With `logarithms` the values are logarithms in this range, and the ends are told as what
    /// they are of.
    void setHistogram(std::shared_ptr<const ValueHistogram> histogram, const std::optional<ValueRange>& logarithms);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::shared_ptr<const ValueHistogram> histogram_;
    std::optional<ValueRange> logarithms_;
};

} // namespace tetra
