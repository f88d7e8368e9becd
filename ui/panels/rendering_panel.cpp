// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/rendering_panel.h"

#include "core/view/appearance.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/api/slice_parameters.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/message_text.h"
#include "ui/viewport/viewport.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>

#include <algorithm>
#include <chrono>
#include <initializer_list>

namespace tetra {
namespace {

constexpr const char* frameRateKey = "rendering/frameRate";
constexpr int automatic = 0;
constexpr int highestRate = 120;

constexpr const char* movingKey = "rendering/moving";
constexpr const char* movingErrorKey = "rendering/movingError";
constexpr const char* movingShareKey = "rendering/movingShare";
constexpr const char* idleTimeKey = "rendering/idleTime";
constexpr double usualError = 4; // percent
constexpr int usualShare = 10;   // percent
constexpr int longestIdleTime = 5000;
using Kind = MovingQuality::Kind;

QString explanationOf(const PluginHost& host, const std::string& id)
{
    for (const PluginStatus& plugin : host.plugins())
        if (plugin.metadata.id == id)
            return inUsersLanguage(plugin.metadata.description, plugin.metadata.descriptions);
    return {};
}

ParameterValues defaultsOf(const std::vector<Parameter>& parameters)
{
    ParameterValues defaults;
    for (const Parameter& parameter : parameters)
        defaults[parameter.id] = parameter.defaultValue;
    return defaults;
}

} // namespace

RenderingPanel::RenderingPanel(Workbench& workbench, Viewport& viewport, QWidget* parent)
    : QWidget(parent), workbench_(workbench), viewport_(viewport), mode_(new QComboBox), explanation_(new QLabel),
      settings_(new ParameterForm("rendering.setting")), moving_(new QComboBox), frameRate_(new QSpinBox),
      movingError_(new QDoubleSpinBox), movingShare_(new QSpinBox), idleTime_(new QSpinBox)
{
    setObjectName("rendering");
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(makeContent()));

    connect(mode_, &QComboBox::activated, this, [this](int index) { chooseMode(mode_->itemData(index).toString()); });
    connect(settings_, &ParameterForm::edited, this, [this](const QString& id) { setSetting(id.toStdString()); });
    connect(frameRate_, &QSpinBox::valueChanged, this, &RenderingPanel::setFrameRate);
    connect(&workbench_.session(), &Session::modelChanged, this, &RenderingPanel::showModel);
    connect(&workbench_.session(), &Session::modelGrown, this, &RenderingPanel::showAppearance);
    workbench_.session().whenChanged(ViewPart::Mode | ViewPart::Settings, this, &RenderingPanel::showAppearance);
    frameRate_->setValue(QSettings().value(frameRateKey, automatic).toInt());
    setFrameRate(frameRate_->value());
    readMotion();
    setMotion();
    connect(moving_, &QComboBox::currentIndexChanged, this, &RenderingPanel::setMotion);
    connect(movingError_, &QDoubleSpinBox::valueChanged, this, &RenderingPanel::setMotion);
    connect(movingShare_, &QSpinBox::valueChanged, this, &RenderingPanel::setMotion);
    connect(idleTime_, &QSpinBox::valueChanged, this, &RenderingPanel::setMotion);
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
    column->addLayout(makeMotion());
    column->addStretch();
    return content;
}

QFormLayout* RenderingPanel::makeMotion()
{
    const auto describe = [](QWidget& control, const char* name, const QString& label, const QString& explanation) {
        control.setObjectName(name);
        control.setAccessibleName(label);
        control.setToolTip(explanation);
    };
    describe(*moving_, "rendering.moving", tr("What to draw while moving"),
             tr("What to draw while something moves. The still picture is always complete."));
    moving_->addItem(tr("As the frame rate allows"), QStringLiteral("frameRate"));
    moving_->addItem(tr("A mesh of a fixed error"), QStringLiteral("error"));
    moving_->addItem(tr("A share of the tetrahedra"), QStringLiteral("share"));
    moving_->addItem(tr("Always full quality"), QStringLiteral("full"));
    describe(*frameRate_, "rendering.frameRate", tr("Frame rate while moving"),
             tr("The frame rate to keep while something moves. If the machine is too slow, frames are drawn smaller "
                "and with fewer tetrahedra; the still picture is always complete."));
    frameRate_->setRange(automatic, highestRate);
    frameRate_->setSpecialValueText(tr("Automatic (%1 frames/s)").arg(static_cast<int>(viewport_.usualFrameRate())));
    frameRate_->setSuffix(tr(" frames/s"));
    describe(*movingError_, "rendering.movingError", tr("Error while moving"),
             tr("The error of the mesh that is drawn while something moves, in percent of the value range."));
    movingError_->setRange(0.01, 100);
    movingError_->setSuffix(tr(" %"));
    describe(*movingShare_, "rendering.movingShare", tr("Share of the tetrahedra while moving"),
             tr("How many of the tetrahedra are drawn while something moves, in percent."));
    movingShare_->setRange(1, 100);
    movingShare_->setSuffix(tr(" %"));
    describe(*idleTime_, "rendering.idleTime", tr("Time until the full picture"),
             tr("The full picture is drawn when nothing has moved for this long, in milliseconds."));
    idleTime_->setRange(0, longestIdleTime);
    idleTime_->setSingleStep(50);
    idleTime_->setSuffix(tr(" ms"));
    for (QAbstractSpinBox* box :
         std::initializer_list<QAbstractSpinBox*>{frameRate_, movingError_, movingShare_, idleTime_})
        box->setKeyboardTracking(false);

    motion_ = new QFormLayout;
    motion_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    motion_->addRow(tr("While &moving"), moving_);
    motion_->addRow(tr("Frame r&ate"), frameRate_);
    motion_->addRow(tr("&Error"), movingError_);
    motion_->addRow(tr("&Tetrahedra"), movingShare_);
    motion_->addRow(tr("&Full picture after"), idleTime_);
    return motion_;
}

void RenderingPanel::readMotion()
{
    const QSettings settings;
    moving_->setCurrentIndex(std::max(0, moving_->findData(settings.value(movingKey))));
    movingError_->setValue(settings.value(movingErrorKey, usualError).toDouble());
    movingShare_->setValue(settings.value(movingShareKey, usualShare).toInt());
    idleTime_->setValue(settings.value(idleTimeKey, static_cast<int>(Viewport::usualIdleTime.count())).toInt());
}

/// What is chosen is used, and kept.
void RenderingPanel::setMotion()
{
    QSettings settings;
    settings.setValue(movingKey, moving_->currentData());
    settings.setValue(movingErrorKey, movingError_->value());
    settings.setValue(movingShareKey, movingShare_->value());
    settings.setValue(idleTimeKey, idleTime_->value());
    const auto kind = static_cast<Kind>(moving_->currentIndex());
    motion_->setRowVisible(frameRate_, kind == Kind::FrameRate);
    motion_->setRowVisible(movingError_, kind == Kind::Error);
    motion_->setRowVisible(movingShare_, kind == Kind::Share);
    motion_->setRowVisible(idleTime_, kind != Kind::Full);
    viewport_.setMovingKind(kind);
    viewport_.setIdleTime(std::chrono::milliseconds(idleTime_->value()));
    workbench_.scenes().draftBuilder().setQuality({kind, kind == Kind::Error   ? movingError_->value()
                                                         : kind == Kind::Share ? movingShare_->value()
                                                                               : 0});
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
    auto parameters = settingParameters(workbench_.scenes().renderingParameters());
    const auto defaults = defaultsOf(parameters);
    if (appearance.mode != shownMode_ || appearance.mode.empty() || defaults != shownDefaults_) {
        settings_->setParameters(std::move(parameters));
        showExamples();
    }
    shownDefaults_ = defaults; // which follow the model, and that may grow
    shownMode_ = appearance.mode;
    settings_->setValues(appearance.settings);
}

/// How planes are written: those that cut the domain in two.
void RenderingPanel::showExamples()
{
    const auto& model = workbench_.session().model();
    if (model == nullptr)
        return;
    const Eigen::Vector3d middle = model->description().bounds.center();
    settings_->setExample(clipId, "1,0,0," + QString::number(middle.x(), 'g', 3));
    settings_->setExample(slicesId, "z=" + QString::number(middle.z(), 'g', 3));
}

void RenderingPanel::setFrameRate(int perSecond)
{
    QSettings().setValue(frameRateKey, perSecond);
    viewport_.setFrameRate(perSecond == automatic ? std::nullopt : std::optional<double>(perSecond));
}

} // namespace tetra
