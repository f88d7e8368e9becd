// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_form.h"

#include "ui/session/plugin_texts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include <utility>

namespace tetra {
namespace {

/// A control and how to read it; no control for a type that a form cannot hold.
using Control = std::pair<QWidget*, std::function<ParameterValue()>>;

bool isBounded(const Parameter& parameter)
{
    return parameter.maximum > parameter.minimum;
}

Control controlFor(const Parameter& parameter, bool value)
{
    auto* box = new QCheckBox(pluginText(parameter.label));
    box->setChecked(value);
    return {box, [box] { return box->isChecked(); }};
}

/// Shows no more digits than the number has.
class NumberBox : public QDoubleSpinBox {
public:
    QString textFromValue(double value) const override { return locale().toString(value, 'g', 15); }
};

QDoubleSpinBox* numberBox(const Parameter& parameter, int decimals, double value)
{
    constexpr double unbounded = 1e15; // whole numbers up to here are exact
    auto* box = new NumberBox;
    box->setDecimals(decimals);
    box->setRange(isBounded(parameter) ? parameter.minimum : -unbounded,
                  isBounded(parameter) ? parameter.maximum : unbounded);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setValue(value);
    return box;
}

Control controlFor(const Parameter& parameter, std::int64_t value)
{
    auto* box = numberBox(parameter, 0, static_cast<double>(value));
    return {box, [box] { return static_cast<std::int64_t>(box->value()); }};
}

Control controlFor(const Parameter& parameter, double value)
{
    auto* box = numberBox(parameter, 4, value);
    return {box, [box] { return box->value(); }};
}

Control controlFor(const Parameter& parameter, const std::string& value)
{
    if (parameter.choices.empty()) {
        auto* line = new QLineEdit(QString::fromStdString(value));
        line->setClearButtonEnabled(true);
        return {line, [line] { return line->text().toStdString(); }};
    }
    auto* box = new QComboBox;
    for (const std::string& choice : parameter.choices)
        box->addItem(pluginText(choice), QString::fromStdString(choice));
    box->setCurrentIndex(box->findData(QString::fromStdString(value)));
    return {box, [box] { return box->currentData().toString().toStdString(); }};
}

Control controlFor(const Parameter& parameter, const TransferFunction& value)
{
    Q_UNUSED(parameter);
    Q_UNUSED(value);
    return {nullptr, {}};
}

Control controlFor(const Parameter& parameter, const std::vector<Isovalue>& value)
{
    Q_UNUSED(parameter);
    Q_UNUSED(value);
    return {nullptr, {}};
}

} // namespace

ParameterForm::ParameterForm(const QString& prefix, QWidget* parent)
    : QWidget(parent), prefix_(prefix), layout_(new QFormLayout(this))
{
    setObjectName(prefix);
    layout_->setContentsMargins({});
    layout_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    layout_->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

void ParameterForm::setParameters(const std::vector<Parameter>& parameters)
{
    while (layout_->rowCount() > 0)
        layout_->removeRow(0);
    fields_.clear();
    for (const Parameter& parameter : parameters)
        add(parameter);
    setVisible(!isEmpty());
}

void ParameterForm::add(const Parameter& parameter)
{
    const auto [widget, read] =
        std::visit([&](const auto& value) { return controlFor(parameter, value); }, parameter.defaultValue);
    if (widget == nullptr)
        return;
    const QString label = pluginText(parameter.label);
    const QString unit = pluginText(parameter.unit);
    widget->setObjectName(prefix_ + "." + QString::fromStdString(parameter.id));
    widget->setToolTip(pluginText(parameter.explanation));
    widget->setAccessibleName(label);
    if (std::holds_alternative<bool>(parameter.defaultValue))
        layout_->addRow(widget);
    else
        layout_->addRow(unit.isEmpty() ? label : tr("%1 (%2)").arg(label, unit), widget);
    if (auto* line = qobject_cast<QLineEdit*>(widget); line != nullptr && parameter.mistake)
        tellMistakes(*line, parameter);
    fields_.push_back({parameter.id, read});
}

/// A row below `line` that says, while it is edited, why its text cannot be used.
void ParameterForm::tellMistakes(QLineEdit& line, const Parameter& parameter)
{
    auto* message = new QLabel;
    message->setObjectName(line.objectName() + ".mistake");
    message->setWordWrap(true);
    message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout_->addRow(message);
    const auto show = [this, message, mistake = parameter.mistake](const QString& text) {
        message->setText(QString::fromStdString(mistake(text.toStdString())));
        layout_->setRowVisible(message, !message->text().isEmpty());
    };
    show(line.text());
    connect(&line, &QLineEdit::textChanged, message, show);
}

ParameterValues ParameterForm::values() const
{
    ParameterValues result;
    for (const Field& field : fields_)
        result[field.id] = field.value();
    return result;
}

} // namespace tetra
