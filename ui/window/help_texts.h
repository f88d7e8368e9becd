// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace tetra {

/// "What's this?" for every control: its own text if it has one, else its tool tip, else that of the panel around it.
class HelpTexts : public QObject {
    Q_OBJECT
public:
    /// Listens to the whole application.
    explicit HelpTexts(QObject* parent);

    /// The text for a control; empty if neither it nor anything around it has one.
    static QString textFor(const QWidget* widget);
    /// Shows the text of what has the keys, below it, until a key or a click.
    static void showForFocus();

    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace tetra
