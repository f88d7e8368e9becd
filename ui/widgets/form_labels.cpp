// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/form_labels.h"

#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace tetra {
namespace {

/// Pixels: a letter that is underlined is not drawn as close to its neighbours as the text's width says.
constexpr int roomForMark = 2;

} // namespace

void alignFormLabels(const QWidget& parent)
{
    QList<QWidget*> labels;
    int widest = 0;
    for (const QFormLayout* form : parent.findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            if (item == nullptr || item->widget() == nullptr)
                continue;
            labels.append(item->widget());
            widest = std::max(widest, item->widget()->sizeHint().width());
        }
    for (QWidget* label : labels)
        label->setMinimumWidth(widest + roomForMark);
}

} // namespace tetra
