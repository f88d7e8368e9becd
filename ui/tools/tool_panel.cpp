// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_panel.h"

#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/message_text.h"

#include <QAbstractSpinBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

/// What a form must be made anew for: which parameters there are, between what, and of which choices.
std::vector<std::string> formKeys(const std::vector<Parameter>& parameters)
{
    std::vector<std::string> keys;
    for (const Parameter& parameter : parameters) {
        std::string key = parameter.id + "|" + parameterTypeName(parameter.defaultValue) + "|" + parameter.unit + "|" +
                          formatNumber(parameter.minimum) + "|" + formatNumber(parameter.maximum);
        for (const std::string& choice : parameter.choices)
            key += "|" + choice;
        keys.push_back(std::move(key));
    }
    return keys;
}

std::vector<std::string> idsOf(const std::vector<ToolCommand>& commands)
{
    std::vector<std::string> ids;
    for (const ToolCommand& command : commands)
        ids.push_back(command.id);
    return ids;
}

} // namespace

ToolPanel::ToolPanel(ToolDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk)
{
    setObjectName("tool");
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    connect(&desk, &ToolDesk::chosenChanged, this, &ToolPanel::makeContent);
    connect(&desk, &ToolDesk::changed, this, &ToolPanel::show);
    makeContent();
}

void ToolPanel::makeContent()
{
    delete content_;
    form_ = nullptr;
    readings_ = nullptr;
    copy_ = nullptr;
    buttons_ = nullptr;
    shownParameters_.clear();
    shownCommands_.clear();
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    about_ = new QLabel;
    about_->setObjectName("tool.about");
    about_->setWordWrap(true);
    about_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(about_);
    const std::string& id = desk_.chosen();
    const auto& tools = desk_.tools();
    const auto tool = std::ranges::find(tools, id, &Provided<Tool>::id);
    if (tool == tools.end()) {
        about_->setText(tools.empty() ? tr("No tool plugin could be loaded.")
                                      : tr("Choose a tool in the menu Tools: to measure, say, or to cut."));
    } else {
        about_->setText(inUsersLanguage(tool->name, tool->names));
        form_ = new ParameterForm("tool." + QString::fromStdString(id));
        connect(form_, &ParameterForm::edited, this, [this](const QString& parameter) {
            desk_.setParameter(parameter.toStdString(), form_->value(parameter.toStdString()));
        });
        column->addWidget(form_);
        readings_ = new QLabel;
        readings_->setObjectName("tool.readings");
        readings_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        readings_->setAccessibleName(tr("Readings"));
        readings_->setToolTip(tr("What the tool tells of the places in the picture"));
        column->addWidget(readings_);
        copy_ = new QPushButton(tr("Copy"));
        copy_->setObjectName("tool.copy");
        copy_->setToolTip(tr("Copy the readings as text, for a table"));
        connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(readingsText()); });
        column->addWidget(copy_);
        buttons_ = new QVBoxLayout;
        column->addLayout(buttons_);
    }
    column->addStretch();
    content_ = new ScrolledColumn(inside);
    layout()->addWidget(content_);
    makeControls();
}

void ToolPanel::makeControls()
{
    if (form_ == nullptr)
        return;
    const std::vector<Parameter> parameters = desk_.parameters();
    if (auto keys = formKeys(parameters); keys != shownParameters_) {
        shownParameters_ = std::move(keys);
        form_->setParameters(parameters);
        // A number takes effect when it is typed: each digit would be a step, and the answer to it would replace the
        // rest.
        for (auto* box : form_->findChildren<QAbstractSpinBox*>())
            box->setKeyboardTracking(false);
    }
    const std::vector<ToolCommand> commands = desk_.commands();
    if (auto ids = idsOf(commands); ids != shownCommands_) {
        shownCommands_ = std::move(ids);
        makeButtons(commands);
    }
    fill(parameters, commands);
}

void ToolPanel::makeButtons(const std::vector<ToolCommand>& commands)
{
    while (QLayoutItem* item = buttons_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const ToolCommand& command : commands) {
        auto* button = new QPushButton(translatedText(command.text));
        button->setObjectName("tool." + QString::fromStdString(desk_.chosen() + ".command." + command.id));
        const QString key = QKeySequence(QString::fromStdString(command.key)).toString(QKeySequence::NativeText);
        const QString explanation = translatedText(command.explanation);
        button->setToolTip(key.isEmpty() ? explanation : tr("%1 (%2)").arg(explanation, key));
        connect(button, &QPushButton::clicked, this, [this, id = command.id] { desk_.command(id); });
        buttons_->addWidget(button);
    }
}

/// New controls only where there are others: those that somebody is using stay.
void ToolPanel::show()
{
    if (form_ == nullptr)
        return;
    const std::vector<Parameter> parameters = desk_.parameters();
    const std::vector<ToolCommand> commands = desk_.commands();
    if (formKeys(parameters) != shownParameters_ || idsOf(commands) != shownCommands_) {
        // Not now: a control of the form may be what has been used.
        QMetaObject::invokeMethod(this, &ToolPanel::makeControls, Qt::QueuedConnection);
        return;
    }
    fill(parameters, commands);
}

void ToolPanel::fill(const std::vector<Parameter>& parameters, const std::vector<ToolCommand>& commands)
{
    ParameterValues values;
    for (const Parameter& parameter : parameters)
        values[parameter.id] = parameter.defaultValue;
    form_->setValues(values);
    const QString text = readingsText();
    readings_->setText(text);
    readings_->setVisible(!text.isEmpty());
    copy_->setVisible(!text.isEmpty());
    for (int i = 0; i < buttons_->count(); ++i)
        buttons_->itemAt(i)->widget()->setEnabled(commands[static_cast<std::size_t>(i)].enabled);
}

QString ToolPanel::readingsText() const
{
    QStringList lines;
    for (const ToolReading& reading : desk_.readings())
        lines << translatedMessage(reading.label) + "\t" + translatedMessage(reading.text);
    return lines.join('\n');
}

} // namespace tetra
