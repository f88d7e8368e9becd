// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace tetra {

class Viewport;

/// A word across the top of the picture, which is not what somebody may take it for: of another model than the dataset
/// that was opened, or of other settings. Dims the picture until that is used. Takes no input.
class PictureNotice : public QWidget {
    Q_OBJECT
public:
    explicit PictureNotice(Viewport& viewport);

    /// Empty: there is nothing to say.
    void tell(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Viewport& viewport_;
    bool dims_ = true;
};

} // namespace tetra
