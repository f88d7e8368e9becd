// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/accuracy_panel.h"

#include "core/history/whole_elsewhere.h"
#include "core/view/accuracy_scale.h"
#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/accuracy_curve.h"
#include "ui/panels/accuracy_inputs.h"
#include "ui/session/logarithm_text.h"
#include "ui/session/message_text.h"
#include "ui/session/shown_mesh_text.h"
#include "ui/widgets/checked_button.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QRadioButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

QLabel* numberLabel(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

/// Whether there is more to say than the error that was asked for.
bool saysMore(const ShownMesh& mesh, const Model& model)
{
    return mesh.query.budget || mesh.query.window || !mesh.query.values.empty() || !mesh.query.error.isConstant() ||
           (model.description().warpingWeight > 0 && mesh.query.warping != mesh.query.error) || mesh.scale > 1.001;
}

QString shareText(double part, double whole)
{
    return whole > 0 ? AccuracyPanel::tr("%1 of all").arg(percentText(100 * part / whole)) : QString();
}

/// What an error in percent is in the data: "± 0.12", or of logarithms "a factor of 1.26".
QString inUnitsText(double percent, const ModelDescription& model)
{
    if (const auto logarithms = logarithmsOf(model))
        return factorWords(percent, *logarithms);
    return AccuracyPanel::tr("± %1").arg(QLocale().toString(percent / 100 * model.range.extent(), 'g', 3));
}

} // namespace

AccuracyPanel::AccuracyPanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), curve_(new AccuracyCurve), slider_(new AccuracySlider),
      byError_(new QRadioButton(tr("Err&or"))), box_(new AccuracyBox), byBudget_(new QRadioButton(tr("Bu&dget"))),
      budget_(new BudgetBox), inUnits_(new QLabel), errorPlace_(new QLabel), warpingLabel_(new QLabel(tr("War&ping"))),
      warpingLimit_(new QComboBox), warping_(new AccuracyBox), sites_(numberLabel("accuracy.sites")),
      siteShare_(numberLabel("accuracy.siteShare")), tetrahedra_(numberLabel("accuracy.tetrahedra")),
      tetrahedronShare_(numberLabel("accuracy.tetrahedronShare")), outcome_(new QLabel), limit_(new QLabel)
{
    setObjectName("accuracy");
    inUnits_->setObjectName("accuracy.inUnits");
    inUnits_->setToolTip(
        tr("The percentages in data units. The warping of curvilinear and irregular data is the distance of the mesh "
           "from the data, in percent of the diagonal of the data's bounding box. Samples just outside the mesh, of "
           "irregular data and of grids decimated as a mesh, are compared with a place on its boundary within the "
           "warping; at the nearest place the error may be larger, and 'tan verify' measures it."));
    errorPlace_->setObjectName("accuracy.errorPlace");
    errorPlace_->setWordWrap(true);
    errorPlace_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    limit_->setObjectName("accuracy.limit");
    limit_->setWordWrap(true);
    outcome_->setObjectName("accuracy.outcome");
    outcome_->setWordWrap(true);
    outcome_->setTextInteractionFlags(Qt::TextSelectableByMouse);

    auto* alongAxis = new QHBoxLayout;
    alongAxis->setContentsMargins(curve_->leftMargin() - slider_->handleInset(), 0,
                                  curve_->rightMargin() - slider_->handleInset(), 0);
    alongAxis->addWidget(slider_);

    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->addWidget(curve_, 1);
    layout->addLayout(alongAxis);
    layout->addLayout(makePresets());
    layout->addLayout(makeModes());
    layout->addLayout(makeNumbers());
    layout->addWidget(outcome_);
    layout->addWidget(limit_);
    layout->addStretch();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(content));
    connectInputs();
    showModel();
}

void AccuracyPanel::connectInputs()
{
    const auto choose = [this](double percent) { session_.setError(percent); };
    const auto chooseBudget = [this](quint64 tetrahedra) { session_.setBudget(tetrahedra); };
    connect(curve_, &AccuracyCurve::chosen, this, choose);
    connect(curve_, &AccuracyCurve::budgetChosen, this, chooseBudget);
    connect(slider_, &AccuracySlider::chosen, this, choose);
    connect(box_, &AccuracyBox::chosen, this, choose);
    connect(budget_, &BudgetBox::chosen, this, chooseBudget);
    connect(byError_, &QRadioButton::clicked, this, [this] { session_.setByBudget(false); });
    connect(byBudget_, &QRadioButton::clicked, this, [this] { session_.setByBudget(true); });
    const auto limitWarping = [this](WarpingLimit limit, double percent) { session_.setWarping({limit, percent}); };
    connect(warpingLimit_, &QComboBox::activated, this, [this, limitWarping](int chosen) {
        // Its own begins with what holds: the number of the error.
        const QueryState& query = session_.view().query;
        const bool begins = query.warping.limit == WarpingLimit::AsError;
        limitWarping(static_cast<WarpingLimit>(chosen), begins ? query.error : query.warping.percent);
    });
    connect(warping_, &AccuracyBox::chosen, this,
            [limitWarping](double percent) { limitWarping(WarpingLimit::Own, percent); });
    for (QWidget* input : std::initializer_list<QWidget*>{curve_, slider_, box_, warping_, budget_})
        new GestureWatcher(input, session_);
    connect(&session_, &Session::modelChanged, this, &AccuracyPanel::showModel);
    connect(&session_, &Session::modelGrown, this, &AccuracyPanel::showModel);
    connect(&session_, &Session::shownChanged, this, &AccuracyPanel::showSize);
    session_.whenChanged(ViewPart::Query, this, &AccuracyPanel::showQuery);
}

/// Whichever is touched holds from then on.
QLayout* AccuracyPanel::makeModes()
{
    byError_->setObjectName("accuracy.byError");
    byError_->setToolTip(tr("The smallest mesh with this error"));
    byBudget_->setObjectName("accuracy.byBudget");
    byBudget_->setToolTip(
        tr("The best mesh with at most this number of tetrahedra. A focus keeps its ratio to the rest."));
    auto* grid = new QGridLayout;
    grid->setColumnStretch(2, 1);
    grid->addWidget(byError_, 0, 0);
    grid->addWidget(box_, 0, 1);
    grid->addWidget(inUnits_, 0, 2);
    grid->addWidget(errorPlace_, 1, 1, 1, 2);
    addWarping(*grid, 2);
    grid->addWidget(byBudget_, 3, 0);
    grid->addWidget(budget_, 3, 1);
    grid->addWidget(new QLabel(tr("tetrahedra")), 3, 2);
    return grid;
}

void AccuracyPanel::addWarping(QGridLayout& grid, int row)
{
    warpingLimit_->setObjectName("accuracy.warpingLimit");
    warpingLimit_->addItems({tr("Same as the error"), tr("Custom"), tr("None")}); // as WarpingLimit
    warpingLimit_->setAccessibleName(tr("Limit of the warping"));
    warpingLimit_->setToolTip(
        tr("Limit on the warping, the distance of the mesh from the data: the same percentage as the error, but of the "
           "diagonal; a percentage of its own; or none, for the smallest mesh whose values are within the error"));
    warping_->setObjectName("accuracy.warping");
    warping_->setAccessibleName(tr("Warping in percent of the diagonal"));
    warping_->setToolTip(tr("Warping in percent of the diagonal of the data's bounding box"));
    warpingLabel_->setBuddy(warpingLimit_);
    grid.addWidget(warpingLabel_, row, 0);
    grid.addWidget(warpingLimit_, row, 1);
    grid.addWidget(warping_, row, 2);
}

QLayout* AccuracyPanel::makePresets()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (const double percent : accuracyPresets) {
        auto* button = new QToolButton;
        button->setObjectName("accuracy.preset." + QString::number(percent));
        button->setText(percentText(percent));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        const QString name =
            percent > 0 ? tr("Error of %1 of the value range").arg(percentText(percent)) : tr("Every sample exact");
        button->setToolTip(name);
        button->setAccessibleName(name);
        connect(button, &QToolButton::clicked, this, [this, percent] {
            session_.setError(percent);
            showQuery();
        });
        row->addWidget(button);
        presets_.push_back(button);
    }
    return row;
}

QLayout* AccuracyPanel::makeNumbers()
{
    auto* grid = new QGridLayout;
    grid->setColumnStretch(2, 1);
    grid->setHorizontalSpacing(12);
    grid->addWidget(new QLabel(tr("Vertices")), 0, 0);
    grid->addWidget(sites_, 0, 1);
    grid->addWidget(siteShare_, 0, 2);
    grid->addWidget(new QLabel(tr("Tetrahedra")), 1, 0);
    grid->addWidget(tetrahedra_, 1, 1);
    grid->addWidget(tetrahedronShare_, 1, 2);
    return grid;
}

void AccuracyPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showQuery();
}

void AccuracyPanel::showModel()
{
    const auto& model = session_.model();
    setEnabled(model != nullptr);
    showCurve();
    const double end = model ? 100 * model->finalKey() / session_.range().extent() : 0;
    limit_->setText(
        end > 0 ? tr("This model was built down to an %1 of %2; it contains nothing finer.")
                      .arg(translatedText(textFor(errorNames, errorMeaning(model->description()))), percentText(end))
                : QString());
    limit_->setVisible(end > 0);
    showQuery();
}

void AccuracyPanel::showCurve()
{
    curveWarping_ = session_.view().query.warping;
    const auto& model = session_.model();
    curve_->setCurve(model ? sizeAgainstError(*model, curveWarping_) : std::vector<CurvePoint>{});
    curve_->setErrorMeaning(model ? errorMeaning(model->description()) : ErrorMeaning::Only);
}

void AccuracyPanel::showWarping()
{
    const auto& model = session_.model();
    const QueryState& query = session_.view().query;
    const bool warps = model && model->description().warpingWeight > 0;
    warpingLabel_->setVisible(warps);
    warpingLimit_->setVisible(warps);
    warping_->setVisible(warps && query.warping.limit == WarpingLimit::Own);
    warpingLimit_->setCurrentIndex(static_cast<int>(query.warping.limit));
    warping_->setAccuracy(query.warping.percent);
    if (query.warping != curveWarping_)
        showCurve();
}

void AccuracyPanel::showQuery()
{
    const QueryState& query = session_.view().query;
    showWarping();
    budget_->setBudget(query.budget);
    (query.byBudget ? byBudget_ : byError_)->setChecked(true);
    curve_->setBudget(query.byBudget ? std::optional(query.budget) : std::nullopt);
    showSize();
}

/// The error that is asked for, or that the budget allows; outside the focus. Nothing as long as it is not known.
std::optional<double> AccuracyPanel::errorOfMesh() const
{
    const QueryState& query = session_.view().query;
    if (!query.byBudget || !session_.model())
        return query.error;
    if (session_.showsQuery()) {
        const ShownMesh& shown = *session_.shown();
        const SpaceRamp* ramp = shown.query.error.asSpaceRamp();
        return std::min(100.0, keptPercent(ramp ? ramp->outer : shown.query.error.bounds().maximum, shown.scale));
    }
    return query.focus.isOn() ? std::nullopt : std::optional(errorWithin(*session_.model(), query.budget));
}

void AccuracyPanel::showError(double error)
{
    slider_->setAccuracy(error);
    box_->setAccuracy(error);
    const bool isAskedFor = session_.model() && !session_.view().query.byBudget;
    for (std::size_t i = 0; i < presets_.size(); ++i)
        showChecked(*presets_[i], isAskedFor && accuracyPresets[i] == error);
    const auto& model = session_.model();
    if (!model)
        return inUnits_->clear();
    const QString byError = inUnitsText(error, model->description());
    const WarpingChoice& warping = session_.view().query.warping;
    if (model->description().warpingWeight > 0 && warping.limit == WarpingLimit::None)
        inUnits_->setText(tr("%1 in value\nany warping").arg(byError));
    else if (model->description().warpingWeight > 0)
        inUnits_->setText(
            tr("%1 in value\nwarping %2")
                .arg(byError, QLocale().toString(warping.with(error).warping / 100 * model->diagonal(), 'g', 3)));
    else
        inUnits_->setText(tr("of the range\n%1").arg(byError));
}

/// The error in space is that of the last picture until the next one comes, and may come later.
void AccuracyPanel::showErrorPlace()
{
    const auto& model = session_.model();
    const bool isSeen = session_.showsQuery();
    const ErrorMeaning meaning = !model   ? ErrorMeaning::Only
                                 : isSeen ? session_.shown()->errorMeaning
                                          : errorMeaning(model->description());
    const std::optional<double> inSpace = isSeen ? session_.shown()->errorInSpace : std::nullopt;
    QString text = errorPlaceText(meaning, inSpace);
    if (inSpace)
        text = tr("%1, %2").arg(text, inUnitsText(*inSpace, model->description()));
    errorPlace_->setText(text);
    errorPlace_->setToolTip(errorPromiseText(meaning, inSpace.has_value()));
    errorPlace_->setVisible(!text.isEmpty());
}

/// A uniform mesh is counted beforehand; of any other the numbers are those of the last picture until the next one
/// comes.
void AccuracyPanel::showSize()
{
    const auto& model = session_.model();
    const auto error = errorOfMesh();
    if (error)
        showError(*error);
    showErrorPlace();
    for (QLabel* label : {sites_, siteShare_, tetrahedra_, tetrahedronShare_, outcome_})
        label->clear();
    if (!model)
        return;
    const QueryState& query = session_.view().query;
    const auto& shown = session_.shown();
    const MeshSize planned = session_.meshSize();
    const bool isPlanned = !session_.showsQuery() && query.isUniform();
    if (isPlanned || shown) {
        const std::uint64_t sites = isPlanned ? planned.sites : shown->keptSites;
        const std::uint64_t tetrahedra = isPlanned ? planned.tetrahedra : shown->keptTetrahedra;
        sites_->setText(countText(sites));
        tetrahedra_->setText(countText(tetrahedra));
        if (isPlanned || !shown->isBlended) {
            siteShare_->setText(shareText(static_cast<double>(sites), wholeSites(*model)));
            tetrahedronShare_->setText(shareText(static_cast<double>(tetrahedra),
                                                 static_cast<double>(meshSizeAt(*model, bothWithin(0)).tetrahedra)));
        }
    }
    const bool usesPlanned = isPlanned || !shown;
    curve_->setMarked({error.value_or(query.error), usesPlanned ? planned.sites : shown->wholeSites,
                       usesPlanned ? planned.tetrahedra : shown->wholeTetrahedra});
    if (shown && saysMore(*shown, *model))
        outcome_->setText(meshText(*shown, *model));
    outcome_->setVisible(!outcome_->text().isEmpty());
}

} // namespace tetra
