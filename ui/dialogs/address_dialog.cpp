// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/address_dialog.h"

#include "ui/opening/model_cache.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <tan/open.h>

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace tetra {
namespace {

constexpr int askedAfter = 400; // milliseconds without a key

QLineEdit* makeTokenField(const QString& name)
{
    auto* token = new QLineEdit;
    token->setObjectName(name);
    token->setEchoMode(QLineEdit::Password);
    token->setToolTip(AddressDialog::tr("Access token issued by the server's operator; forgotten when TAn quits"));
    return token;
}

/// Below a radio button, as wide as its text.
QLabel* makeExplanation(const QString& text, const QRadioButton& above)
{
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setIndent(above.iconSize().width() + label->fontMetrics().averageCharWidth());
    return label;
}

/// Without the way to a file on it.
QUrl serverIn(const QString& address)
{
    return QUrl(address).adjusted(QUrl::RemovePath | QUrl::RemoveQuery | QUrl::RemoveFragment);
}

/// An address, or what may become one while it is typed.
bool mayBeAddress(const QString& text)
{
    constexpr std::array starts = {"http://", "https://", "tan+http://", "tan+https://"};
    return isAddress(text.toStdString()) || std::ranges::any_of(starts, [&](const char* start) {
               return QString(start).startsWith(text, Qt::CaseInsensitive);
           });
}

} // namespace

AddressDialog::AddressDialog(const QString& name, TokenOf tokenOf, QWidget* parent)
    : QDialog(parent), tokenOf_(std::move(tokenOf)), address_(new QLineEdit), tokenLabel_(new QLabel(tr("&Token:"))),
      token_(makeTokenField(name + ".token")), fetch_(new QRadioButton(tr("&Fetch the model"))),
      leave_(new QRadioButton(tr("&Leave the model at the server"))), offer_(new QLabel)
{
    constexpr int letters = 60;
    setObjectName(name);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Open URL"));
    auto* label = new QLabel(tr("&Address of a model on a server:"));
    address_->setObjectName(name + ".address");
    address_->setMinimumWidth(address_->fontMetrics().averageCharWidth() * letters);
    address_->setPlaceholderText("https://example.org/model.tan");
    address_->setToolTip(tr("Address of the model, packed or not: http:// or https://"));
    label->setBuddy(address_);
    tokenLabel_->setBuddy(token_);
    tokenLabel_->hide();
    token_->hide();
    fetch_->setObjectName(name + ".fetch");
    fetch_->setChecked(true);
    leave_->setObjectName(name + ".leave");
    offer_->setObjectName(name + ".offer");
    offer_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    open_ = buttons->button(QDialogButtonBox::Open);
    auto* layout = new QVBoxLayout(this);
    const int gap = layout->spacing();
    layout->addWidget(label);
    layout->addWidget(address_);
    layout->addWidget(tokenLabel_);
    layout->addWidget(token_);
    layout->addSpacing(gap);
    layout->addWidget(fetch_);
    layout->addWidget(makeExplanation(tr("Downloads only what is needed; cached afterwards."), *fetch_));
    layout->addWidget(leave_);
    layout->addWidget(makeExplanation(tr("The server extracts each mesh and sends only that: for models too large for "
                                         "this computer. Every change waits for the network."),
                                      *leave_));
    layout->addSpacing(gap);
    layout->addWidget(offer_);
    layout->addStretch();
    layout->addWidget(buttons);

    soon_.setSingleShot(true);
    soon_.setInterval(askedAfter);
    connect(&soon_, &QTimer::timeout, this, &AddressDialog::ask);
    connect(address_, &QLineEdit::textChanged, this, &AddressDialog::askSoon);
    connect(token_, &QLineEdit::textChanged, this, [this] { soon_.start(); });
    for (QRadioButton* button : {fetch_, leave_})
        connect(button, &QRadioButton::clicked, this, [this] { hasChosen_ = true; });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(this, &QDialog::accepted, this, [this] {
        emit chosen(QString::fromStdString(placeOf(address().toStdString(), leave_->isChecked())), token());
    });
    // Who has just copied an address wants that one.
    if (const QString copied = QGuiApplication::clipboard()->text().trimmed(); isAddress(copied.toStdString()))
        address_->setText(copied);
    address_->selectAll();
    askSoon();
}

QString AddressDialog::address() const
{
    return address_->text().trimmed();
}

QString AddressDialog::token() const
{
    return token_->isVisibleTo(this) ? token_->text().trimmed() : QString();
}

/// Not of each letter, and of no host whose address is not all there: what can be left at a server ends in .tan.
void AddressDialog::askSoon()
{
    const std::string place = address().toStdString();
    open_->setEnabled(isAddress(place));
    asking_.forget();
    if (serverIn(address()) != tokensServer_)
        showTokenField(false);
    showState(mayBeAddress(address()) ? QString() : tr("An address begins with http:// or https://."));
    hasChosen_ = false;
    const bool isLeft = isLeftAtServer(place);
    leave_->setEnabled(isLeft);
    leave_->setToolTip(tr("Requires a TAn server: 'tan serve'"));
    (isLeft ? leave_ : fetch_)->setChecked(true);
    if (isAddress(place) && QUrl(address()).path().endsWith(".tan"))
        soon_.start();
    else
        soon_.stop();
}

/// What the server says, and that all of it is seen: a dialog does not grow with its wrapped texts by itself.
void AddressDialog::showState(const QString& text)
{
    offer_->setText(text);
    layout()->activate();
    resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

/// The token of one server is not sent to another one.
void AddressDialog::showTokenField(bool shows)
{
    const QSignalBlocker asksNothing(token_);
    const QUrl server = serverIn(address());
    if (!shows || server != tokensServer_)
        token_->clear();
    tokensServer_ = shows ? server : QUrl();
    tokenLabel_->setVisible(shows);
    token_->setVisible(shows);
}

void AddressDialog::ask()
{
    showState(tr("Asking the server…"));
    const QString given = token();
    asking_.ask(
        *this,
        [address = address().toStdString(), token = (given.isEmpty() ? tokenOf_(address()) : given).toStdString()](
            const std::stop_token& stop) { return askServer(address, token, Progress(stop, {})); },
        [this](const Result<ServerOffer>& offer) { showOffer(offer); });
}

void AddressDialog::showOffer(const Result<ServerOffer>& offer)
{
    if (!offer)
        return showState(translatedMessage(offer.error().message));
    if (offer->wantsToken) {
        showTokenField(true);
        showState(token().isEmpty() ? tr("This server requires a token.") : tr("Wrong token."));
        return;
    }
    leave_->setEnabled(offer->findsMeshes);
    if (!offer->findsMeshes) {
        fetch_->setChecked(true);
        return showState(tr("This server only delivers files, so the model must be downloaded."));
    }
    leave_->setToolTip({});
    const QString size =
        tr("%L1 vertices, %2.")
            .arg(offer->sites)
            .arg(offer->form == ModelForm::Packed
                     ? tr("%1 packed, %2 unpacked").arg(sizeText(offer->fileBytes), sizeText(offer->unpackedBytes))
                     : sizeText(offer->fileBytes));
    if (fitsHere(*offer))
        return showState(size);
    showState(tr("%1 That is more than this computer has room for: leave it at the server.").arg(size));
    if (!hasChosen_)
        leave_->setChecked(true);
}

void askForToken(QWidget* parent, const QString& name, const QString& place,
                 const std::function<void(const QString& token)>& given)
{
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(AddressDialog::tr("Token"));
    auto* label = new QLabel(
        AddressDialog::tr("The server of %1 requires its &token:").arg(shownPlace(filePath(place)).replace('&', "&&")));
    label->setWordWrap(true);
    QLineEdit* token = makeTokenField(name + ".token");
    label->setBuddy(token);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    ok->setEnabled(false);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(label);
    layout->addWidget(token);
    layout->addWidget(buttons);
    QObject::connect(token, &QLineEdit::textChanged, ok,
                     [ok](const QString& text) { ok->setEnabled(!text.trimmed().isEmpty()); });
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(dialog, &QDialog::accepted, parent, [token, given] { given(token->text().trimmed()); });
    dialog->open();
}

} // namespace tetra
