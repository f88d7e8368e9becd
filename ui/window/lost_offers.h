// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QVBoxLayout;

namespace tetra {

/// What a session that was lost says of itself.
struct LostOffer {
    QString text;   ///< a sentence: how it was lost
    QString model;  ///< its file's name
    QString detail; ///< when it was kept, and where the model lies
    bool operator==(const LostOffer&) const = default;
};

/// The sessions of programs that ended unexpectedly, on the start page: each with a button to restore and one to
/// discard it. Stops nobody from opening something else. Takes no room while there is none. Its controls are named
/// lost.text, .restore and .discard; there may be several of each.
class LostOffers : public QFrame {
    Q_OBJECT
public:
    explicit LostOffers(QWidget* parent = nullptr);

    /// The newest first; those that have no room come up when others are answered.
    void setOffers(const QList<LostOffer>& offers);

signals:
    void restoreClicked(int offer);
    void discardClicked(int offer);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget* makeRow(const LostOffer& offer, int index);

    QVBoxLayout* rows_;
};

} // namespace tetra
