// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/address_dialog.h"

#include <tan/open.h>

#include <QClipboard>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace tetra {
namespace {

class AddressTexts {
    Q_DECLARE_TR_FUNCTIONS(AddressDialog)
};

} // namespace

void askForAddress(QWidget* parent, const QString& name, const FileChosen& chosen)
{
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(AddressTexts::tr("Open URL"));
    auto* label = new QLabel(AddressTexts::tr("&Address of a model on a server:"));
    auto* address = new QLineEdit;
    address->setObjectName(name + ".address");
    address->setMinimumWidth(address->fontMetrics().averageCharWidth() * 60);
    address->setPlaceholderText("https://example.org/model.tan");
    address->setToolTip(AddressTexts::tr("Where the model lies, packed or not: http:// or https://"));
    label->setBuddy(address);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    QPushButton* open = buttons->button(QDialogButtonBox::Open);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(label);
    layout->addWidget(address);
    layout->addWidget(buttons);
    const auto given = [address] { return address->text().trimmed(); };
    const auto check = [open, given] { open->setEnabled(isAddress(given().toStdString())); };
    QObject::connect(address, &QLineEdit::textChanged, dialog, check);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(dialog, &QDialog::accepted, parent, [chosen, given] { chosen(given()); });
    // Who has just copied an address wants that one.
    if (const QString copied = QGuiApplication::clipboard()->text().trimmed(); isAddress(copied.toStdString()))
        address->setText(copied);
    address->selectAll();
    check();
    dialog->open();
}

} // namespace tetra
