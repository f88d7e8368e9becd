// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/rendering_panel.h"

#include "plugins/api/scene_parameters.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/message_text.h"
#include "ui/viewport/viewport.h"

#include <QComboBox>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>

#include <algorithm>

namespace tetra {
namespace {

constexpr const char* frameRateKey = "rendering/frameRate";
constexpr int automatic = 0;
constexpr int highestRate = 120;

QString explanationOf(const PluginHost& host, const std::string& id)
{
    for (const PluginStatus& plugin : host.plugins())
        if (plugin.metadata.id == id)
            return inUsersLanguage(plugin.metadata.description, plugin.metadata.descriptions);
    return {};
}

} // namespace

RenderingPanel::RenderingPanel(Workbench& workbench, Viewport& viewport, QWidget* parent)
    : QWidget(parent), workbench_(workbench), viewport_(viewport), mode_(new QComboBox), explanation_(new QLabel),
      settings_(new ParameterForm("rendering.setting")), frameRate_(new QSpinBox)
{
    setObjectName("rendering");
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(makeContent()));

    connect(mode_, &QComboBox::activated, this, [this](int index) { chooseMode(mode_->itemData(index).toString()); });
    connect(settings_, &ParameterForm::edited, this, [this](const QString& id) { setSetting(id.toStdString()); });
    connect(frameRate_, &QSpinBox::valueChanged, this, &RenderingPanel::setFrameRate);
    connect(&workbench_.session(), &Session::modelChanged, this, &RenderingPanel::showModel);
    workbench_.session().whenChanged(ViewPart::Mode | ViewPart::Settings, this, &RenderingPanel::showAppearance);
    frameRate_->setValue(QSettings().value(frameRateKey, automatic).toInt());
    setFrameRate(frameRate_->value());
    showModel();
}

QWidget* RenderingPanel::makeContent()
{
    mode_->setObjectName("rendering.mode");
    mode_->setToolTip(tr("Rendering mode"));
    mode_->setAccessibleName(tr("Rendering mode"));
    explanation_->setObjectName("rendering.explanation");
    explanation_->setWordWrap(true);
    explanation_->setForegroundRole(QPalette::PlaceholderText);
    frameRate_->setObjectName("rendering.frameRate");
    frameRate_->setRange(automatic, highestRate);
    frameRate_->setSpecialValueText(tr("Automatic (%1 frames/s)").arg(static_cast<int>(viewport_.usualFrameRate())));
    frameRate_->setSuffix(tr(" frames/s"));
    frameRate_->setKeyboardTracking(false);
    frameRate_->setToolTip(tr("The frame rate to keep while something moves. If the machine is too slow, frames are "
                              "drawn smaller and with fewer tetrahedra; the picture at rest is always complete."));
    frameRate_->setAccessibleName(tr("Frame rate while moving"));

    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    auto* head = new QFormLayout;
    head->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    head->addRow(tr("Sh&ow"), mode_);
    column->addLayout(head);
    column->addWidget(explanation_);
    column->addSpacing(6);
    column->addWidget(settings_);
    column->addSpacing(6);
    auto* motion = new QFormLayout;
    motion->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    motion->addRow(tr("Frame r&ate"), frameRate_);
    column->addLayout(motion);
    column->addStretch();
    return content;
}

void RenderingPanel::chooseMode(const QString& id)
{
    workbench_.session().setMode(id.toStdString());
    emit modeChosen();
}

/// A default that is confirmed, as by Enter in a line, is no edit.
void RenderingPanel::setSetting(const std::string& id)
{
    const auto parameters = workbench_.scenes().renderingParameters();
    const auto parameter = std::ranges::find(parameters, id, &Parameter::id);
    const ParameterValue value = settings_->value(id);
    const bool isSet = workbench_.session().view().appearance.settings.contains(id);
    if (isSet || parameter == parameters.end() || parameter->defaultValue != value)
        workbench_.session().setSetting(id, value);
}

void RenderingPanel::showModel()
{
    setEnabled(workbench_.session().model() != nullptr);
    mode_->clear();
    for (const Provided<Renderer>& mode : workbench_.scenes().modes())
        mode_->addItem(inUsersLanguage(mode.name, mode.names), QString::fromStdString(mode.id));
    shownMode_.clear();
    showAppearance();
}

void RenderingPanel::showAppearance()
{
    const Appearance& appearance = workbench_.session().view().appearance;
    mode_->setCurrentIndex(mode_->findData(QString::fromStdString(appearance.mode)));
    explanation_->setText(explanationOf(workbench_.host(), appearance.mode));
    if (appearance.mode != shownMode_ || appearance.mode.empty()) {
        settings_->setParameters(settingParameters(workbench_.scenes().renderingParameters()));
        showExample();
    }
    shownMode_ = appearance.mode;
    settings_->setValues(appearance.settings);
}

/// How a clip plane is written: one that cuts the domain in two.
void RenderingPanel::showExample()
{
    if (const auto& model = workbench_.session().model())
        settings_->setExample(clipId, "1,0,0," + QString::number(model->description().bounds.center().x(), 'g', 3));
}

void RenderingPanel::setFrameRate(int perSecond)
{
    QSettings().setValue(frameRateKey, perSecond);
    viewport_.setFrameRate(perSecond == automatic ? std::nullopt : std::optional<double>(perSecond));
}

} // namespace tetra
