// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

#include <QWidget>

#include <memory>

namespace tetra {

/// How often the values of the mesh that is shown occur, on a logarithmic scale, with the ends of their range.
class HistogramView : public QWidget {
    Q_OBJECT
public:
    explicit HistogramView(QWidget* parent = nullptr);

    /// None: an empty frame.
    void setHistogram(std::shared_ptr<const ValueHistogram> histogram);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::shared_ptr<const ValueHistogram> histogram_;
};

} // namespace tetra
