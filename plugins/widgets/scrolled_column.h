// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace tetra {

/// Content that scrolls up and down where there is not enough height for it, and is never narrower than it needs to be.
/// As high as there is room for, if the content can use it.
class ScrolledColumn : public QScrollArea {
    Q_OBJECT
public:
    /// Takes over the content.
    explicit ScrolledColumn(QWidget* content, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace tetra
