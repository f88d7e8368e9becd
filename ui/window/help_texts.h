// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace tetra {

/// "What's this?" for every control: its own text if it has one, else its tool tip, else that of the panel around it;
/// and from there to the manual. F1 does it in dialogs, too, where no menu of the window is within reach.
class HelpTexts : public QObject {
    Q_OBJECT
public:
    /// Listens to the whole application.
    explicit HelpTexts(QObject* parent);

    /// The text for a control; empty if neither it nor anything around it has one.
    static QString textFor(const QWidget* widget);
    /// Where the manual tells of a control: the page and the heading of the panel or dialog that it is in, or of the
    /// picture.
    static QString manualPlaceOf(const QWidget* widget);
    /// Shows the text of what has the keys, below it, until a key or a click; F1 once more leads to the manual. What
    /// has no text leads there at once.
    void showForFocus();

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void manualWanted(const QString& place); ///< "manual.html#focus"

private:
    void showText(QPoint place, const QString& text, QWidget* of);
};

} // namespace tetra
