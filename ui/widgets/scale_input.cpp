// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/scale_input.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>

#include <cmath>

namespace tetra {

ScaleInput::ScaleInput(const QString& name, QWidget* parent)
    : QWidget(parent), kind_(new QComboBox), from_(new QLineEdit)
{
    kind_->setObjectName(name);
    kind_->setAccessibleName(tr("Scale"));
    kind_->setToolTip(tr("Linear uses the values as they are. Logarithmic uses their logarithms to base 10, for values "
                         "spanning many powers of ten: errors are then factors, the same for large and small values"));
    kind_->addItems({tr("Linear"), tr("Logarithmic")});
    from_->setObjectName(name + ".from");
    from_->setAccessibleName(tr("Smallest value"));
    from_->setPlaceholderText(tr("all values are positive"));
    from_->setToolTip(tr("Values smaller than this are replaced by it, including zero and negative ones, which have no "
                         "logarithm. Leave empty if all values are positive"));
    from_->setEnabled(false);
    auto* fromLabel = new QLabel(tr("Smallest value"));
    fromLabel->setBuddy(from_);
    auto* kindLabel = new QLabel(tr("Scale"));
    kindLabel->setBuddy(kind_);
    auto* layout = new QFormLayout(this);
    layout->setContentsMargins({});
    layout->addRow(kindLabel, kind_);
    layout->addRow(fromLabel, from_);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this](int index) {
        from_->setEnabled(index == 1);
        emit edited();
    });
    connect(from_, &QLineEdit::textChanged, this, &ScaleInput::edited);
}

void ScaleInput::setScale(const ValueScale& scale)
{
    const QSignalBlocker blocker(this);
    kind_->setCurrentIndex(scale.logarithmic ? 1 : 0);
    from_->setText(scale.from ? QLocale().toString(*scale.from, 'g', QLocale::FloatingPointShortest) : QString());
}

std::optional<ValueScale> ScaleInput::scale() const
{
    ValueScale scale{.logarithmic = kind_->currentIndex() == 1};
    const QString text = from_->text().trimmed();
    if (!scale.logarithmic || text.isEmpty())
        return scale;
    bool isNumber = false;
    const double from = QLocale().toDouble(text, &isNumber);
    if (!isNumber || !(from > 0) || !std::isfinite(from))
        return std::nullopt;
    scale.from = from;
    return scale;
}

} // namespace tetra
