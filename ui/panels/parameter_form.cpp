// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_form.h"

#include "plugins/widgets/colour_button.h"
#include "ui/session/message_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

/// A control, how to read it and how to show a value in it; no widget for a type that a form cannot hold.
struct Control {
    QWidget* widget = nullptr;
    std::function<ParameterValue()> read{};
    std::function<void(const ParameterValue&)> show{};
};

bool isBounded(const Parameter& parameter)
{
    return parameter.maximum > parameter.minimum;
}

Control controlFor(const Parameter& parameter, bool value)
{
    auto* box = new QCheckBox(translatedText(parameter.label));
    box->setChecked(value);
    return {box, [box] { return box->isChecked(); },
            [box](const ParameterValue& shown) { box->setChecked(std::get<bool>(shown)); }};
}

/// QDoubleSpinBox rounds its value to its decimals; this many keep any double.
constexpr int allDecimals = 323;

/// Takes and keeps any number, plain or with an exponent, and shows no more digits than it has. Its steps are a tenth
/// of the number's magnitude, but `least` from 0 to ten times that.
class NumberBox : public QDoubleSpinBox {
public:
    explicit NumberBox(double least) : least_(least) {}

    /// In the fewest digits that are this number again, from 15 on, so that 0.1 is not 0.10000000000000001.
    QString textFromValue(double value) const override
    {
        QString text;
        for (int digits = 15; digits <= 17; ++digits)
            if (text = locale().toString(value, 'g', digits); locale().toDouble(text) == value)
                break;
        return text;
    }

    double valueFromText(const QString& text) const override { return locale().toDouble(text.trimmed()); }

    QValidator::State validate(QString& text, int& position) const override
    {
        Q_UNUSED(position);
        bool isNumber = false;
        const double value = locale().toDouble(text.trimmed(), &isNumber);
        const bool fits =
            isNumber && value >= minimum() && value <= maximum() && (decimals() > 0 || value == std::trunc(value));
        return fits ? QValidator::Acceptable : QValidator::Intermediate;
    }

    void stepBy(int steps) override
    {
        const int direction = steps > 0 ? 1 : -1;
        for (int step = 0; step != steps; step += direction) {
            const double next = value() + direction * stepTowards(direction);
            setValue(QString::number(next, 'g', stepDigits).toDouble()); // 0.3, not 0.30000000000000004
        }
        selectAll();
    }

private:
    static constexpr int stepDigits = 12;

    double stepTowards(int direction) const
    {
        const double size = std::abs(value());
        const bool towardsZero = value() * direction < 0;
        if (size == 0 || (size >= least_ && (towardsZero ? size <= 10 * least_ : size < 10 * least_)))
            return least_;
        // From 10 down as below it, not as above.
        const double step = std::pow(10, std::floor(std::log10(towardsZero ? size / 1.01 : size)) - 1);
        return decimals() > 0 ? step : std::max(step, 1.0);
    }

    double least_;
};

/// The step from 0: no more than about a tenth of what may be chosen (0.1 from 0.01 to 1).
double leastStep(const Parameter& parameter)
{
    constexpr double usual = 0.1, about = 1.02;
    const double tenth = about * (parameter.maximum - parameter.minimum) / 10;
    return isBounded(parameter) && tenth < usual ? std::pow(10, std::floor(std::log10(tenth))) : usual;
}

/// For whole numbers, or any.
QDoubleSpinBox* numberBox(const Parameter& parameter, bool isWhole, double value)
{
    constexpr double unbounded = 1e15; // whole numbers up to here are exact
    constexpr double any = 1e300;      // short to write: boxes have room for their limits
    const double largest = isWhole ? unbounded : any;
    auto* box = new NumberBox(isWhole ? 1 : leastStep(parameter));
    box->setDecimals(isWhole ? 0 : allDecimals);
    box->setRange(isBounded(parameter) ? parameter.minimum : -largest,
                  isBounded(parameter) ? parameter.maximum : largest);
    box->setValue(value);
    return box;
}

Control controlFor(const Parameter& parameter, std::int64_t value)
{
    auto* box = numberBox(parameter, true, static_cast<double>(value));
    return {box, [box] { return static_cast<std::int64_t>(box->value()); },
            [box](const ParameterValue& shown) { box->setValue(static_cast<double>(std::get<std::int64_t>(shown))); }};
}

Control controlFor(const Parameter& parameter, double value)
{
    auto* box = numberBox(parameter, false, value);
    return {box, [box] { return box->value(); },
            [box](const ParameterValue& shown) { box->setValue(std::get<double>(shown)); }};
}

/// A word of the parameter as the user reads it; any other text as it is.
QString wordShown(const std::string& text, const std::vector<std::string>& words)
{
    return std::ranges::find(words, text) != words.end() ? translatedText(text) : QString::fromStdString(text);
}

/// What the user wrote: the parameter's word that it is, in either language, else the text.
std::string wordMeant(const QString& text, const std::vector<std::string>& words)
{
    const auto isMeant = [&](const std::string& word) {
        return text.compare(translatedText(word), Qt::CaseInsensitive) == 0;
    };
    const auto found = std::ranges::find_if(words, isMeant);
    return found != words.end() ? *found : text.toStdString();
}

Control lineFor(const Parameter& parameter, const std::string& value)
{
    auto* line = new QLineEdit(wordShown(value, parameter.words));
    line->setClearButtonEnabled(true);
    return {line, [line, words = parameter.words] { return wordMeant(line->text(), words); },
            [line, words = parameter.words](const ParameterValue& shown) {
                if (const auto text = wordShown(std::get<std::string>(shown), words); line->text() != text)
                    line->setText(text);
            }};
}

Control controlFor(const Parameter& parameter, const std::string& value)
{
    if (parameter.choices.empty())
        return lineFor(parameter, value);
    auto* box = new QComboBox;
    for (const std::string& choice : parameter.choices)
        box->addItem(translatedText(choice), QString::fromStdString(choice));
    box->setCurrentIndex(box->findData(QString::fromStdString(value)));
    return {box, [box] { return box->currentData().toString().toStdString(); },
            [box](const ParameterValue& shown) {
                box->setCurrentIndex(box->findData(QString::fromStdString(std::get<std::string>(shown))));
            }};
}

Control controlFor(const Parameter& /*parameter*/, const Colour& value)
{
    auto* button = new ColourButton;
    button->setColour(qtColour(value));
    return {button, [button] { return colourOf(button->colour()); },
            [button](const ParameterValue& shown) { button->setColour(qtColour(std::get<Colour>(shown))); }};
}

Control controlFor(const Parameter& parameter, const Eigen::Vector3d& value)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    std::array<QDoubleSpinBox*, 3> boxes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes[axis] = numberBox(parameter, false, value[static_cast<Eigen::Index>(axis)]);
        boxes[axis]->setMinimumWidth(48);
        layout->addWidget(boxes[axis]);
    }
    return {row, [boxes] { return Eigen::Vector3d(boxes[0]->value(), boxes[1]->value(), boxes[2]->value()); },
            [boxes](const ParameterValue& shown) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const QSignalBlocker blocker(boxes[axis]);
                    boxes[axis]->setValue(std::get<Eigen::Vector3d>(shown)[static_cast<Eigen::Index>(axis)]);
                }
            }};
}

/// What has a panel or an editor of its own is not in forms.
template <class Value> Control controlFor(const Parameter& /*parameter*/, const Value& /*value*/)
{
    return {};
}

/// The boxes of a vector: PREFIX.ID.x, .y and .z.
void nameAxes(QWidget& row, const QString& label)
{
    if (qobject_cast<QDoubleSpinBox*>(&row) != nullptr)
        return;
    const QStringList axes{"x", "y", "z"};
    qsizetype axis = 0;
    for (auto* box : row.findChildren<QDoubleSpinBox*>()) {
        box->setObjectName(row.objectName() + "." + axes[axis]);
        box->setToolTip(row.toolTip());
        box->setAccessibleName(label + " " + axes[axis]);
        ++axis;
    }
}

/// What is shown that is none of the choices is the first one.
Control choiceControl(const Parameter& parameter, const std::vector<ParameterChoice>& choices)
{
    auto* box = new QComboBox;
    for (const ParameterChoice& choice : choices)
        box->addItem(choice.label);
    const auto show = [box, choices](const ParameterValue& shown) {
        const auto found = std::ranges::find(choices, shown, &ParameterChoice::value);
        box->setCurrentIndex(found == choices.end() ? 0 : static_cast<int>(found - choices.begin()));
    };
    show(parameter.defaultValue);
    return {box, [box, choices] { return choices[static_cast<std::size_t>(box->currentIndex())].value; }, show};
}

} // namespace

ParameterForm::ParameterForm(const QString& prefix, QWidget* parent)
    : QWidget(parent), prefix_(prefix), layout_(new QFormLayout(this))
{
    setObjectName(prefix);
    layout_->setContentsMargins({});
    layout_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    layout_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    connect(this, &ParameterForm::edited, this, &ParameterForm::showMattering);
}

void ParameterForm::setParameters(const std::vector<Parameter>& parameters, const ParameterChoices& choices)
{
    while (layout_->rowCount() > 0)
        layout_->removeRow(0);
    fields_.clear();
    for (const Parameter& parameter : parameters) {
        const auto known = choices.find(parameter.id);
        add(parameter, known != choices.end() ? known->second : std::vector<ParameterChoice>());
    }
    setVisible(!isEmpty());
    showMattering();
}

void ParameterForm::setSurroundings(const ParameterValues& surroundings)
{
    surroundings_ = surroundings;
    showMattering();
}

void ParameterForm::showMattering()
{
    const ParameterValues mattering = matteringValues();
    for (const Field& field : fields_)
        layout_->setRowVisible(field.widget, mattering.contains(field.parameter.id));
}

void ParameterForm::add(const Parameter& parameter, const std::vector<ParameterChoice>& choices)
{
    const Control control =
        choices.empty()
            ? std::visit([&](const auto& value) { return controlFor(parameter, value); }, parameter.defaultValue)
            : choiceControl(parameter, choices);
    QWidget* widget = control.widget;
    if (widget == nullptr)
        return;
    const QString label = translatedText(parameter.label);
    const QString unit = translatedText(parameter.unit);
    widget->setObjectName(prefix_ + "." + QString::fromStdString(parameter.id));
    widget->setToolTip(translatedText(parameter.explanation));
    widget->setAccessibleName(label);
    nameAxes(*widget, label);
    if (std::holds_alternative<bool>(parameter.defaultValue))
        layout_->addRow(widget);
    else
        layout_->addRow(unit.isEmpty() ? label : tr("%1 (%2)").arg(label, unit), widget);
    if (auto* line = qobject_cast<QLineEdit*>(widget); line != nullptr && parameter.mistake)
        tellMistakes(*line, parameter);
    fields_.push_back({parameter, widget, control.read, control.show});
    tellEdits(parameter, widget);
}

/// Text when it is finished and can be used, all else at once.
void ParameterForm::tellEdits(const Parameter& parameter, QWidget* widget)
{
    const QString id = QString::fromStdString(parameter.id);
    const auto tell = [this, id] { emit edited(id); };
    if (auto* check = qobject_cast<QCheckBox*>(widget))
        connect(check, &QCheckBox::clicked, this, tell);
    else if (auto* number = qobject_cast<QDoubleSpinBox*>(widget))
        connect(number, &QDoubleSpinBox::valueChanged, this, tell);
    else if (auto* choice = qobject_cast<QComboBox*>(widget))
        connect(choice, &QComboBox::activated, this, tell);
    else if (auto* colour = qobject_cast<ColourButton*>(widget))
        connect(colour, &ColourButton::colourChosen, this, tell);
    else if (std::holds_alternative<Eigen::Vector3d>(parameter.defaultValue))
        for (auto* box : widget->findChildren<QDoubleSpinBox*>())
            connect(box, &QDoubleSpinBox::valueChanged, this, tell);
    else if (auto* line = qobject_cast<QLineEdit*>(widget))
        connect(line, &QLineEdit::editingFinished, this, [line, tell, mistake = parameter.mistake] {
            if (!mistake || mistake(line->text().toStdString()).empty())
                tell();
        });
}

void ParameterForm::setValues(const ParameterValues& values)
{
    for (const Field& field : fields_) {
        const ParameterValue& byDefault = field.parameter.defaultValue;
        const auto found = values.find(field.parameter.id);
        const bool fits = found != values.end() && haveOneType(found->second, byDefault);
        const QSignalBlocker blocker(qobject_cast<QLineEdit*>(field.widget) == nullptr ? field.widget : nullptr);
        field.show(fits ? found->second : byDefault);
    }
    showMattering();
}

void ParameterForm::setExample(const std::string& id, const QString& example)
{
    for (const Field& field : fields_)
        if (auto* line = qobject_cast<QLineEdit*>(field.widget); line != nullptr && field.parameter.id == id)
            line->setPlaceholderText(tr("for example %1").arg(example));
}

ParameterValue ParameterForm::value(const std::string& id) const
{
    for (const Field& field : fields_)
        if (field.parameter.id == id)
            return field.value();
    return {};
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
        message->setText(translatedMessage(mistake(text.toStdString())));
        layout_->setRowVisible(message, !message->text().isEmpty());
    };
    show(line.text());
    connect(&line, &QLineEdit::textChanged, message, show);
}

ParameterValues ParameterForm::values() const
{
    ParameterValues result;
    for (const Field& field : fields_)
        result[field.parameter.id] = field.value();
    return result;
}

ParameterValues ParameterForm::matteringValues() const
{
    ParameterValues result = values();
    ParameterValues known = result;
    known.insert(surroundings_.begin(), surroundings_.end());
    for (const Field& field : fields_)
        if (!matters(field.parameter, {}, known))
            result.erase(field.parameter.id);
    return result;
}

} // namespace tetra
