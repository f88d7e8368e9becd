// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/rescale_dialog.h"

#include "plugins/widgets/curves/whole_function.h"
#include "plugins/widgets/value_box.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include <limits>

namespace tetra {
namespace {

class RescaleDialog {
    Q_DECLARE_TR_FUNCTIONS(RescaleDialog)
};

/// Any number may be typed; its decimals and steps are those of what there is.
ValueBox* numberBox(const EditorState& state, double value)
{
    constexpr double logarithms = 300;
    auto* box = new ValueBox;
    const double most = state.ofLogarithms() ? logarithms : std::numeric_limits<float>::max();
    const TransferLimits limits = state.limits();
    box->setOfLogarithms(state.ofLogarithms());
    box->setValueRange(limits.least, limits.largest);
    box->setRange(-most, most);
    box->setValue(value);
    return box;
}

} // namespace

void askForRange(EditorState& state, QWidget* parent)
{
    const auto extent = extentOf(state.function());
    if (!extent)
        return;
    auto* dialog = new QDialog(parent);
    dialog->setObjectName("transfer.rescale");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(RescaleDialog::tr("Rescale Transfer Function"));
    ValueBox* least = numberBox(state, extent->least);
    ValueBox* largest = numberBox(state, extent->largest);
    least->setObjectName("transfer.rescale.least");
    least->setToolTip(RescaleDialog::tr("Value of the first point, in data units"));
    largest->setObjectName("transfer.rescale.largest");
    largest->setToolTip(RescaleDialog::tr("Value of the last point, in data units"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* form = new QFormLayout(dialog);
    form->addRow(RescaleDialog::tr("&From"), least);
    form->addRow(RescaleDialog::tr("&To"), largest);
    form->addRow(buttons);
    const auto check = [=] { buttons->button(QDialogButtonBox::Ok)->setEnabled(least->value() < largest->value()); };
    for (ValueBox* box : {least, largest})
        QObject::connect(box, &QDoubleSpinBox::valueChanged, dialog, check);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(dialog, &QDialog::accepted, parent, [&state, least, largest] {
        if (least->value() < largest->value())
            state.setFunction(spreadOver(state.function(), {least->value(), largest->value()}));
    });
    dialog->open();
}

} // namespace tetra
