// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/opening/served_model.h"
#include "ui/work/latest_answer.h"

#include <QDialog>
#include <QTimer>
#include <QUrl>

#include <cstdint>
#include <functional>

class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace tetra {

/// The address of a model on a server, and whether it is to be fetched or left there, where the server finds meshes
/// (R28): which is proposed where this machine has no room for the model. Lets the window work on. Its controls are
/// NAME.address, .token (where the server wants one), .fetch, .leave and .offer (what the server says).
class AddressDialog : public QDialog {
    Q_OBJECT
public:
    /// The token that is known of an address, if any.
    using TokenOf = std::function<QString(const QString& address)>;

    AddressDialog(const QString& name, TokenOf tokenOf, QWidget* parent);

signals:
    /// The user has chosen a place (isAddress()); the token is empty unless it was given here.
    void chosen(const QString& place, const QString& token);

private:
    QString address() const;
    QString token() const;
    void askSoon();
    void ask();
    void showOffer(const Result<ServerOffer>& offer);
    void showTokenField(bool shows);
    void showState(const QString& text);

    const TokenOf tokenOf_;
    QLineEdit* address_;
    QLabel* tokenLabel_;
    QLineEdit* token_;
    QRadioButton* fetch_;
    QRadioButton* leave_;
    QLabel* offer_;
    QPushButton* open_ = nullptr;
    QTimer soon_;
    QUrl tokensServer_;                        ///< the one that the token is for
    bool hasChosen_ = false;                   ///< between the two
    LatestAnswer<Result<ServerOffer>> asking_; ///< last: ends before what it uses
};

/// Asks for the token of the server of `place`; `given` is called with it.
void askForToken(QWidget* parent, const QString& name, const QString& place,
                 const std::function<void(const QString& token)>& given);

} // namespace tetra
