// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/build_panel.h"

#include "plugins/widgets/icons.h"
#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/opening/import_texts.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/files.h"
#include "ui/session/logarithm_text.h"
#include "ui/session/message_text.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QStackedWidget>

#include <cmath>
#include <utility>

namespace tetra {
namespace {

constexpr int barSteps = 1000;
constexpr const char* resumeKey = "build/resume";

/// How much of the data a model keeps: the errors of its finest mesh in percent of the range.
constexpr std::array detailErrors{1.0, 0.1, 0.0};
constexpr int goodDetail = 1;
constexpr int everyDetail = 2;
constexpr std::uint64_t mostPointsForEverything = 1'000'000;

int firstDetail(const Dataset& dataset)
{
    return dataset.pointCount() > mostPointsForEverything ? goodDetail : everyDetail;
}

/// `values` with those of `others` in place.
ParameterValues withValues(ParameterValues values, const ParameterValues& others)
{
    for (const auto& [id, value] : others)
        values[id] = value;
    return values;
}

QLabel* wrappedLabel(const char* name, const QString& text = {})
{
    auto* label = new QLabel(text);
    label->setObjectName(name);
    label->setWordWrap(true);
    return label;
}

QLabel* titleLabel(const char* name)
{
    QLabel* label = wrappedLabel(name);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

/// Points, cells and kind.
QString shapeOf(const Dataset& dataset)
{
    const auto& size = dataset.lattice.size;
    const QString sizes = QString("%1 × %2 × %3").arg(size[0]).arg(size[1]).arg(size[2]);
    if (dataset.domain == DomainClass::Scattered)
        return BuildPanel::tr("%1 scattered points").arg(countText(dataset.pointCount()));
    if (dataset.domain == DomainClass::Irregular)
        return BuildPanel::tr("irregular mesh of %1 points, %2 tetrahedra")
            .arg(countText(dataset.pointCount()), countText(dataset.tetrahedra ? dataset.tetrahedra->size() : 0));
    if (dataset.domain == DomainClass::Curvilinear && dataset.convex)
        return BuildPanel::tr("rectilinear grid of %1 points, %2 cells")
            .arg(sizes, countText(dataset.lattice.cellCount()));
    if (dataset.domain == DomainClass::Curvilinear)
        return BuildPanel::tr("curvilinear grid of %1 points, %2 cells")
            .arg(sizes, countText(dataset.lattice.cellCount()));
    return BuildPanel::tr("%1 samples").arg(sizes);
}

/// How far the points of a lattice are apart, with the unit where it is known.
QString spacingOf(const Dataset& dataset)
{
    QStringList steps;
    for (const double step : dataset.lattice.spacing)
        steps << QLocale().toString(step, 'g', 6);
    const QString text = BuildPanel::tr("spacing %1").arg(steps.join(QString::fromUtf8(" × ")));
    return dataset.lengthUnit.empty() ? text : text + ' ' + shownText(dataset.lengthUnit);
}

/// Values are told as the data have them, also where they were read as their logarithms.
QString factsOf(const Dataset& dataset, const ValueScale& scale)
{
    const ValueRange range = dataset.values.range();
    const auto value = [&](double number) {
        return scale.logarithmic ? antilogarithmText(number, range)
                                 : numberInRange(number, range.minimum, range.maximum);
    };
    const QString shape =
        dataset.domain == DomainClass::RegularLattice ? shapeOf(dataset) + ", " + spacingOf(dataset) : shapeOf(dataset);
    return BuildPanel::tr("%1, %2, values %3 to %4")
        .arg(shape, QString::fromUtf8(sampleTypeName(dataset.values.type())), value(range.minimum),
             value(range.maximum));
}

/// What is to be said of the scale that the values were read with; nothing where it makes no difference.
QString scaleTextOf(const Dataset& dataset, const ValueScale& scale)
{
    constexpr double manyTimes = 1000; // an error of 1 % hides two thirds of three powers of ten
    const ValueRange range = dataset.values.range();
    if (scale.logarithmic)
        return BuildPanel::tr("Scale: logarithmic; an error of 1 % is %1").arg(factorWords(1, range));
    if (range.minimum > 0 && range.maximum >= manyTimes * range.minimum)
        return BuildPanel::tr("Scale: linear. The values span several powers of ten: with the logarithmic scale in "
                              "Import Options, errors are factors.");
    return {};
}

} // namespace

BuildOutlook outlookOf(const BuildQuestion& question)
{
    const unsigned threads = usableThreads();
    const auto estimateOf = [&](const ParameterValues& values) {
        return question.builder->estimate(question.size, values, threads);
    };
    BuildOutlook outlook{.estimate = estimateOf(question.values)};
    for (const ParameterValues& values : question.others)
        outlook.others.push_back(estimateOf(values));
    outlook.resumes = question.builder->abilities(*question.dataset, question.values).resumes;
    return outlook;
}

BuildPanel::BuildPanel(Workbench& workbench, TargetLook::Look look, Ask ask, QWidget* parent)
    : QWidget(parent), workbench_(workbench), look_(new TargetLook(std::move(look), this)), ask_(std::move(ask)),
      pages_(new QStackedWidget)
{
    setObjectName("build");
    nothingPage_ = makeNothingPage();
    buildPage_ = makeBuildPage();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages_);
    for (QWidget* page : {nothingPage_, buildPage_})
        pages_->addWidget(page);
    setFocusProxy(build_);
    connectWorkbench();
    showRunning(false);
}

QWidget* BuildPanel::makeNothingPage()
{
    QLabel* label = wrappedLabel("build.nothing", tr("Open a dataset to build a model of it."));
    label->setAlignment(Qt::AlignTop);
    return label;
}

QWidget* BuildPanel::makeBuildPage()
{
    name_ = titleLabel("build.name");
    facts_ = wrappedLabel("build.facts");
    differently_ = new QPushButton(tr("&Import Options…"));
    differently_->setObjectName("build.differently");
    differently_->setToolTip(
        tr("Read the file again with other options: other values, another scale, a part of it, or fewer points"));
    connect(differently_, &QPushButton::clicked, this, [this] { workbench_.opening().datasets().readDifferently(); });
    builder_ = new QComboBox;
    builder_->setObjectName("build.builder");
    builder_->setAccessibleName(tr("Builder"));
    builder_->setToolTip(tr("How the model is built"));
    builder_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    reason_ = wrappedLabel("build.reason");
    reason_->setForegroundRole(QPalette::PlaceholderText);
    options_ = new ParameterForm("build.option");
    build_ = new QPushButton(tr("&Build"));
    build_->setObjectName("build.start");
    build_->setIcon(glyphIcon(Glyph::Build));
    openExisting_ = new QPushButton(tr("&Open the Existing Model"));
    openExisting_->setObjectName("build.openExisting");
    openExisting_->setIcon(glyphIcon(Glyph::Open));
    openExisting_->setToolTip(tr("Open the existing model; nothing is built or replaced"));
    connect(openExisting_, &QPushButton::clicked, this, [this] { emit openWanted(target_->text()); });
    for (QPushButton* button : {openExisting_, build_})
        button->setAutoDefault(true); // Enter presses the one with the focus

    inputs_ = new QWidget;
    auto* inputs = new QVBoxLayout(inputs_);
    inputs->setContentsMargins({});
    auto* builderLabel = new QLabel(tr("B&uilder"));
    builderLabel->setBuddy(builder_);
    inputs->addWidget(builderLabel);
    inputs->addWidget(builder_);
    inputs->addWidget(reason_);
    inputs->addSpacing(6);
    inputs->addWidget(makeDetails());
    inputs->addSpacing(6);
    inputs->addWidget(options_);
    inputs->addSpacing(6);
    inputs->addLayout(makeTargetRow());
    inputs->addWidget(makeResume());
    estimate_ = wrappedLabel("build.estimate");
    estimate_->setForegroundRole(QPalette::PlaceholderText);
    estimate_->setToolTip(tr("Estimated from a few thousand samples of the dataset; it may be off by a factor of two"));
    inputs->addWidget(estimate_);
    inputs->addWidget(makeInterrupted());

    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins({});
    layout->addWidget(name_);
    layout->addWidget(facts_);
    layout->addWidget(differently_, 0, Qt::AlignLeft);
    layout->addSpacing(8);
    layout->addWidget(inputs_);
    layout->addSpacing(6);
    layout->addWidget(openExisting_);
    layout->addWidget(build_);
    layout->addWidget(makeProgress());
    layout->addStretch();
    connect(builder_, &QComboBox::currentIndexChanged, this, [this] { showBuilder(detail_->checkedId()); });
    connect(options_, &ParameterForm::edited, this, &BuildPanel::showDetail);
    connect(build_, &QPushButton::clicked, this, &BuildPanel::build);
    return new ScrolledColumn(page); // large letters need more height than a small screen has
}

QWidget* BuildPanel::makeDetails()
{
    struct Entry {
        const char* name;
        QString text;
        QString toolTip;
    };
    const std::array<Entry, detailErrors.size()> entries{{
        {"quick", tr("Qui&ck look, error 1 %"),
         tr("Keeps enough for an error of 1 % of the value range: enough for a first look")},
        {"good", tr("&Good, error 0.1 %"),
         tr("Keeps enough for an error of 0.1 % of the value range: pictures can hardly be told from those of the full "
            "data")},
        {"everything", tr("&Everything"),
         tr("Keeps every value of the dataset, so that any accuracy can be shown later")},
    }};
    details_ = new QWidget;
    details_->setObjectName("build.detail");
    details_->setAccessibleName(tr("Detail"));
    detail_ = new QButtonGroup(details_);
    auto* grid = new QGridLayout(details_);
    grid->setContentsMargins({});
    grid->setVerticalSpacing(2);
    grid->addWidget(new QLabel(tr("Detail (model size, build time)")), 0, 0, 1, 2);
    for (std::size_t index = 0; index < entries.size(); ++index) {
        const int row = static_cast<int>(index) + 1;
        auto* button = new QRadioButton(entries[index].text);
        button->setObjectName(QString("build.detail.") + entries[index].name);
        button->setToolTip(entries[index].toolTip);
        detail_->addButton(button, static_cast<int>(index));
        grid->addWidget(button, row, 0);
        QLabel*& size = detailSizes_[index];
        size = new QLabel;
        size->setObjectName(button->objectName() + ".size");
        grid->addWidget(size, row, 1, Qt::AlignRight | Qt::AlignVCenter);
    }
    grid->setColumnStretch(0, 1);
    connect(detail_, &QButtonGroup::idClicked, this, &BuildPanel::chooseDetail);
    return details_;
}

QLayout* BuildPanel::makeTargetRow()
{
    target_ = new QLineEdit;
    target_->setObjectName("build.target");
    target_->setAccessibleName(tr("Model file"));
    target_->setToolTip(tr("Model file to write"));
    browse_ = new QPushButton(tr("Browse…"));
    browse_->setObjectName("build.browse");
    targetHint_ = wrappedLabel("build.targetHint");
    targetHint_->hide();
    auto* label = new QLabel(tr("&Model file"));
    label->setBuddy(target_);
    auto* row = new QHBoxLayout;
    row->addWidget(target_, 1);
    row->addWidget(browse_);
    auto* column = new QVBoxLayout;
    column->addWidget(label);
    column->addLayout(row);
    column->addWidget(targetHint_);
    connect(target_, &QLineEdit::textChanged, this, [this] { beginLook(true); });
    connect(browse_, &QPushButton::clicked, this, &BuildPanel::browse);
    return column;
}

QWidget* BuildPanel::makeResume()
{
    resume_ = new QCheckBox(tr("Re&sume if interrupted"));
    resume_->setObjectName("build.resume");
    resume_->setToolTip(
        tr("Save checkpoints so that the build can be paused and resumed, even after a crash. Short builds take up to "
           "20 % longer, and until the build ends it needs up to three times the model's size on disk"));
    connect(resume_, &QCheckBox::clicked, this, [](bool resumes) { QSettings().setValue(resumeKey, resumes); });
    return resume_;
}

QWidget* BuildPanel::makeInterrupted()
{
    interrupted_ = new QWidget;
    interrupted_->setObjectName("build.interrupted");
    interruptedText_ = wrappedLabel("build.interrupted.text");
    beginAnew_ = new QPushButton(tr("St&art Over"));
    beginAnew_->setObjectName("build.beginAnew");
    beginAnew_->setToolTip(tr("Delete the interrupted build"));
    connect(beginAnew_, &QPushButton::clicked, this, &BuildPanel::beginAnew);
    auto* layout = new QVBoxLayout(interrupted_);
    layout->setContentsMargins({});
    layout->addSpacing(6);
    layout->addWidget(interruptedText_);
    layout->addWidget(beginAnew_, 0, Qt::AlignLeft);
    return interrupted_;
}

QWidget* BuildPanel::makeProgress()
{
    bar_ = new QProgressBar;
    bar_->setObjectName("build.progress");
    bar_->setRange(0, barSteps);
    bar_->setAccessibleName(tr("Progress of the build"));
    activity_ = wrappedLabel("build.activity");
    cancel_ = new QPushButton(tr("&Cancel"));
    cancel_->setObjectName("build.cancel");
    cancel_->setToolTip(tr("Stop the build and discard the result"));
    connect(cancel_, &QPushButton::clicked, this, [this] { workbench_.building().stopBuild(BuildEnd::Discard); });
    pause_ = new QPushButton(tr("&Pause"));
    pause_->setObjectName("build.pause");
    pause_->setToolTip(tr("Stop the build; it can be resumed later, even after TAn has been closed"));
    connect(pause_, &QPushButton::clicked, this, [this] { workbench_.building().stopBuild(BuildEnd::Pause); });
    keep_ = new QPushButton(tr("Stop and &Keep"));
    keep_->setObjectName("build.keep");
    keep_->setToolTip(tr("Stop the build and keep what is finished as a model, with the accuracy reached so far. A "
                         "finished model of the same name is not changed."));
    connect(keep_, &QPushButton::clicked, this, &BuildPanel::keepWanted);
    progress_ = new QWidget;
    auto* layout = new QVBoxLayout(progress_);
    layout->setContentsMargins({});
    layout->addWidget(bar_);
    layout->addWidget(activity_);
    layout->addWidget(pause_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(keep_);
    buttons->addWidget(cancel_);
    layout->addLayout(buttons);
    return progress_;
}

void BuildPanel::connectWorkbench()
{
    connect(&workbench_.opening().datasets(), &DatasetOpening::datasetOpened, this, &BuildPanel::showDataset);
    connect(&workbench_.opening().datasets(), &DatasetOpening::datasetClosed, this,
            [this] { pages_->setCurrentWidget(nothingPage_); });
    connect(&workbench_.building(), &Building::buildStopping, this, &BuildPanel::showStopping);
    connect(look_, &TargetLook::found, this, [this] {
        if (std::exchange(takesUp_, false))
            takeUpInterrupted();
        showTarget();
        goOn();
    });
    connect(&workbench_.building(), &Building::interruptedDiscarded, this, [this] {
        beginLook(false);
        then_ = [this] { build_->setFocus(); }; // the button that had it is gone
    });
    LongTask& building = workbench_.building().task();
    connect(&building, &LongTask::started, this, [this] { showRunning(true); });
    connect(&building, &LongTask::progressed, this, &BuildPanel::showProgress);
    connect(&building, &LongTask::finished, this, [this] {
        showRunning(false);
        beginLook(true); // other data may have been opened meanwhile
    });
}

void BuildPanel::showDataset()
{
    const Dataset& dataset = *workbench_.opening().datasets().dataset();
    name_->setText(shownText(dataset.source.name));
    const ValueScale& scale = workbench_.opening().datasets().importOptions().scale;
    QStringList facts = {factsOf(dataset, scale)};
    if (const QString text = scaleTextOf(dataset, scale); !text.isEmpty())
        facts << text;
    facts << provenanceLines(dataset.source.taken, dataset.source.leftOut);
    for (const Message& remark : dataset.remarks)
        facts << translatedMessage(remark);
    facts_->setText(facts.join('\n'));
    differently_->setVisible(!dataset.source.path.empty());
    const QSignalBlocker blocker(builder_);
    builder_->clear();
    double best = 0;
    const std::vector<Acceptance>& acceptances = workbench_.opening().datasets().acceptances();
    for (const Provided<Builder>& provided : workbench_.host().builders()) {
        const auto number = static_cast<std::size_t>(builder_->count());
        const Acceptance acceptance = number < acceptances.size() ? acceptances[number] : Acceptance();
        builder_->addItem(inUsersLanguage(provided.name, provided.names), QString::fromStdString(provided.id));
        const int index = builder_->count() - 1;
        builder_->setItemData(index, translatedMessage(acceptance.reason), Qt::ToolTipRole);
        if (acceptance.score > best) {
            best = acceptance.score;
            builder_->setCurrentIndex(index);
        }
    }
    {
        const QSignalBlocker withoutBuilder(target_);
        const ParameterValues& imported = workbench_.opening().datasets().importOptions().values;
        const auto array = imported.find("array"); // a model of another array gets a name of its own
        const std::string* const name = array != imported.end() ? std::get_if<std::string>(&array->second) : nullptr;
        target_->setText(proposedModelPath(dataset.source.path, name != nullptr ? *name : std::string()));
    }
    showBuilder(firstDetail(dataset));
    beginLook(true);
    pages_->setCurrentWidget(buildPage_);
}

void BuildPanel::showBuilder(int detail)
{
    reason_->setText(builder_->currentData(Qt::ToolTipRole).toString());
    const auto builder = workbench_.host().builder(builder_->currentData().toString().toStdString());
    const auto& dataset = workbench_.opening().datasets().dataset();
    options_->setParameters(builder ? builder->plugin->parameters() : std::vector<Parameter>{});
    if (dataset)
        options_->setSurroundings({{domainId, domainNameOf(*dataset)}});
    details_->setVisible(builder && dataset && !builder->plugin->detail(0, dataset->domain).empty());
    if (!details_->isHidden())
        chooseDetail(detail >= 0 ? detail : firstDetail(*dataset));
    else
        showDetail();
}

void BuildPanel::chooseDetail(int index)
{
    const auto builder = workbench_.host().builder(builder_->currentData().toString().toStdString());
    const auto& dataset = workbench_.opening().datasets().dataset();
    if (!builder || !dataset)
        return;
    const double error = detailErrors[static_cast<std::size_t>(index)];
    options_->setValues(withValues(options_->values(), builder->plugin->detail(error, dataset->domain)));
    showDetail();
}

/// Which choice the options are; what each takes, the builder tells.
void BuildPanel::showDetail()
{
    showTarget();
    const auto builder = workbench_.host().builder(builder_->currentData().toString().toStdString());
    const auto& dataset = workbench_.opening().datasets().dataset();
    if (!builder || !dataset)
        return;
    const ParameterValues values = options_->values();
    detail_->setExclusive(false); // so that none may be checked
    for (std::size_t index = 0; index < detailErrors.size(); ++index) {
        const ParameterValues detail = builder->plugin->detail(detailErrors[index], dataset->domain);
        detail_->button(static_cast<int>(index))->setChecked(withValues(values, detail) == values);
    }
    detail_->setExclusive(true);
    askBuilder(*builder->plugin, dataset);
}

void BuildPanel::askBuilder(const Builder& builder, const std::shared_ptr<const Dataset>& dataset)
{
    BuildQuestion question{&builder, dataset, workbench_.opening().datasets().buildSize(), options_->matteringValues()};
    for (const double error : detailErrors)
        question.others.push_back(withValues(question.values, builder.detail(error, dataset->domain)));
    outlook_.ask(
        *this, [ask = ask_, question = std::move(question)](const std::stop_token&) { return ask(question); },
        [this](const BuildOutlook& outlook) {
            showOutlook(outlook);
            goOn();
        });
}

void BuildPanel::showOutlook(const BuildOutlook& outlook)
{
    estimate_->setVisible(outlook.estimate.has_value());
    if (outlook.estimate)
        estimate_->setText(estimateText(workbench_.opening().datasets().buildSize(), *outlook.estimate));
    resume_->setVisible(outlook.resumes);
    for (std::size_t index = 0; index < detailErrors.size(); ++index) {
        const auto& needed = outlook.others[index];
        QAbstractButton* button = detail_->button(static_cast<int>(index));
        detailSizes_[index]->setText(needed ? modelSizeText(*needed) : QString());
        button->setAccessibleDescription(button->toolTip() + ". " + detailSizes_[index]->text());
    }
}

/// While a build runs that is where it works, and what was known before remains.
void BuildPanel::beginLook(bool takesUp)
{
    if (workbench_.building().running())
        return;
    takesUp_ = takesUp_ || takesUp;
    then_ = {}; // that was about another file
    look_->begin(filePath(target_->text()));
}

/// At once, or when it is known what is there; but not if what the user reads is then not what they have agreed to.
void BuildPanel::whenLooked(const std::function<void()>& then)
{
    if (!looking())
        return then();
    then_ = [this, then, agreed = build_->text()] {
        const TargetFacts& there = *look_->facts();
        const bool isNothingThere = !there.exists && there.note.empty();
        if (isNothingThere || build_->text() == agreed)
            then();
    };
}

/// With what the user has asked for, once all is known.
void BuildPanel::goOn()
{
    if (looking())
        return;
    if (const auto then = std::exchange(then_, {}))
        then();
}

/// As far as it is known.
void BuildPanel::showTarget()
{
    if (!look_->facts())
        return;
    const bool exists = look_->facts()->exists;
    build_->setText(exists ? tr("&Build and Replace") : tr("&Build"));
    targetHint_->setText(
        look_->facts()->isModel
            ? tr("This file exists. You can open it; if you build, it is replaced when the build is complete.")
        : exists ? tr("This exists and is not a model. Choose another name.")
                 : QString());
    targetHint_->setVisible(exists);
    showInterrupted();
    offerExisting(look_->facts()->isModel && !workbench_.building().running());
}

/// Enter opens the model that is there, also if what had the keys until that was known would have built another one.
void BuildPanel::offerExisting(bool offers)
{
    QPushButton* const first = offers ? openExisting_ : build_;
    QPushButton* const other = offers ? build_ : openExisting_;
    const bool hasKeys = window()->focusWidget() == other;
    const bool isNew = focusProxy() != first;
    setFocusProxy(first);
    openExisting_->setVisible(offers);
    if (hasKeys && isNew)
        first->setFocus();
}

void BuildPanel::takeUpInterrupted()
{
    const auto& dataset = workbench_.opening().datasets().dataset();
    if (!dataset || workbench_.building().running())
        return;
    const auto left = interruptedBuild(workbench_.host(), *dataset, look_->facts()->note);
    if (!left)
        return;
    const QSignalBlocker blocker(builder_);
    builder_->setCurrentIndex(builder_->findData(QString::fromStdString(left->builder)));
    showBuilder(detail_->checkedId());
    options_->setValues(withValues(options_->values(), left->values));
    showDetail();
}

void BuildPanel::showInterrupted()
{
    if (workbench_.building().running())
        return;
    const auto& dataset = workbench_.opening().datasets().dataset();
    const std::string builder = builder_->currentData().toString().toStdString();
    const LeftBuild left =
        dataset ? leftBuild(workbench_.host(), *dataset, builder, options_->matteringValues(), look_->facts()->note)
                : LeftBuild::None;
    if (left == LeftBuild::Same)
        build_->setText(tr("Resume &Build"));
    build_->setEnabled(left != LeftBuild::Other && workbench_.host().builder(builder));
    interrupted_->setVisible(left != LeftBuild::None);
    interruptedText_->setText(
        left == LeftBuild::Same ? tr("An interrupted build of these data was found: it will continue where it stopped.")
                                : tr("Found an interrupted build of different data or with different options. Restore "
                                     "those options, or start over."));
    build_->setAccessibleDescription(left == LeftBuild::Same ? interruptedText_->text() : QString());
    beginAnew_->setAccessibleDescription(interruptedText_->text());
    beginAnew_->setEnabled(true);
    resume_->setEnabled(left == LeftBuild::None);
    resume_->setChecked(left != LeftBuild::None || QSettings().value(resumeKey, false).toBool());
}

/// Until nothing is left there is nothing to do here.
void BuildPanel::beginAnew()
{
    whenLooked([this] {
        build_->setEnabled(false);
        beginAnew_->setEnabled(false);
        workbench_.building().discardInterrupted(filePath(target_->text()));
    });
}

void BuildPanel::showRunning(bool running)
{
    inputs_->setEnabled(!running);
    differently_->setEnabled(!running);
    build_->setVisible(!running);
    interrupted_->hide(); // showTarget() tells
    offerExisting(false); // likewise
    progress_->setVisible(running);
    cancel_->setEnabled(true);
    keep_->setEnabled(true);
    pause_->setEnabled(true);
    pause_->setVisible(workbench_.building().canPauseBuild());
    bar_->setValue(0);
    activity_->setText(running ? tr("Starting…") : QString());
    showTarget();
}

void BuildPanel::showProgress(const TaskProgress& progress)
{
    bar_->setValue(static_cast<int>(std::lround(progress.fraction * barSteps)));
    if (!cancel_->isEnabled() || progress.activity.empty())
        return;
    const QString present = translatedMessage(progress.activity);
    const QString activity =
        progress.remainingSeconds ? tr("%1, %2 left").arg(present, durationText(*progress.remainingSeconds)) : present;
    const bool isOfOther = workbench_.building().buildName() != name_->text(); // another dataset was opened since
    activity_->setText(isOfOther ? tr("%1: %2").arg(workbench_.building().buildName(), activity) : activity);
}

void BuildPanel::browse()
{
    auto* dialog = new QFileDialog(window(), tr("Model File"), target_->text(), tr("Models (*.tan)"));
    dialog->setObjectName("build.targetDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix("tan");
    dialog->setOption(QFileDialog::DontConfirmOverwrite); // the Build button says so
    dialog->selectFile(target_->text());
    connect(dialog, &QFileDialog::fileSelected, target_, &QLineEdit::setText);
    dialog->open();
}

void BuildPanel::showStopping(BuildEnd end)
{
    for (QPushButton* button : {cancel_, pause_, keep_})
        button->setEnabled(false);
    activity_->setText(end == BuildEnd::Keep    ? tr("Keeping what is finished…")
                       : end == BuildEnd::Pause ? tr("Pausing…")
                                                : tr("Cancelling…"));
}

void BuildPanel::build()
{
    whenLooked([this] {
        if (build_->isEnabled())
            workbench_.building().build({.builder = builder_->currentData().toString().toStdString(),
                                         .values = options_->matteringValues(),
                                         .target = filePath(target_->text()),
                                         .resume = resume_->isChecked() && !resume_->isHidden()});
    });
}

} // namespace tetra
