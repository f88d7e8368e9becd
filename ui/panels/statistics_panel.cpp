// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/statistics_panel.h"

#include "core/view/accuracy_scale.h"
#include "core/view/appearance.h"
#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/accuracy_curve.h"
#include "ui/panels/histogram_view.h"
#include "ui/session/logarithm_text.h"
#include "ui/viewport/viewport.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

namespace tetra {
namespace {

/// Of what the model guarantees at each accuracy.
ErrorMeaning meaningOf(const Session& session)
{
    return session.model() ? errorMeaning(session.model()->description()) : ErrorMeaning::Only;
}

constexpr int errorRole = Qt::UserRole;

QTreeWidget* makeTable()
{
    auto* table = new QTreeWidget;
    table->setObjectName("statistics.table");
    table->setAccessibleName(StatisticsPanel::tr("Mesh sizes"));
    table->setToolTip(
        StatisticsPanel::tr("What the mesh of each error costs: its error in percent of the value range and in units "
                            "of the values or as a factor, its size, the time to extract it, measured on this "
                            "computer, and the memory that it occupies. Choose a row to see that mesh."));
    table->setRootIsDecorated(false);
    table->setUniformRowHeights(true);
    table->setAlternatingRowColors(true);
    table->setHeaderLabels(levelColumns(ErrorMeaning::Only, false));
    table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->header()->setStretchLastSection(false);
    table->header()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return table;
}

/// All lines without scrolling, and the bar below them.
void fitHeight(QTreeWidget& table)
{
    const int line = table.sizeHintForRow(0);
    const int bar = table.style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    table.setFixedHeight(table.header()->sizeHint().height() + table.topLevelItemCount() * line + bar +
                         2 * table.frameWidth() + 2);
}

} // namespace

StatisticsPanel::StatisticsPanel(Workbench& workbench, Viewport& viewport, QWidget* parent)
    : QWidget(parent), session_(workbench.session()), scenes_(workbench.scenes().sceneBuilder()),
      curve_(new AccuracyCurve), table_(makeTable()), factGrid_(new QGridLayout),
      faultyCells_(new QCheckBox(tr("Show &faulty cells"))), histogram_(new HistogramView),
      copy_(new QPushButton(tr("Cop&y"))), save_(new QPushButton(tr("&Save…")))
{
    setObjectName("statistics");
    curve_->setObjectName("statistics.curve");
    factGrid_->setColumnStretch(1, 1);
    faultyCells_->setObjectName("statistics.faultyCells");
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->addWidget(table_);
    column->addWidget(curve_, 1);
    column->addLayout(factGrid_);
    column->addWidget(faultyCells_);
    column->addWidget(histogram_);
    column->addLayout(makeButtons());
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(content));
    connectSources(viewport);
    showModel();
}

QLayout* StatisticsPanel::makeButtons()
{
    copy_->setObjectName("statistics.copy");
    copy_->setToolTip(tr("Copy as text, with tabs between the columns"));
    save_->setObjectName("statistics.save");
    save_->setToolTip(tr("Save the table as CSV or JSON (percent, decimal point)"));
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(copy_);
    row->addWidget(save_);
    connect(copy_, &QPushButton::clicked, this, &StatisticsPanel::copy);
    connect(save_, &QPushButton::clicked, this, &StatisticsPanel::saveWanted);
    return row;
}

void StatisticsPanel::connectSources(Viewport& viewport)
{
    connect(table_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        if (item != nullptr)
            session_.setError(item->data(0, errorRole).toDouble());
    });
    connect(curve_, &AccuracyCurve::chosen, this, [this](double percent) { session_.setError(percent); });
    connect(curve_, &AccuracyCurve::budgetChosen, this, [this](quint64 budget) { session_.setBudget(budget); });
    connect(faultyCells_, &QCheckBox::clicked, this, [this](bool shown) { session_.setSetting(faultyCellsId, shown); });
    new GestureWatcher(curve_, session_);
    new GestureWatcher(table_, session_);
    connect(&session_, &Session::modelChanged, this, &StatisticsPanel::showModel);
    connect(&session_, &Session::modelGrown, this, &StatisticsPanel::showLevels);
    connect(&session_, &Session::modelGrown, this, &StatisticsPanel::showFaultyCells);
    session_.whenChanged(ViewPart::Query, this, &StatisticsPanel::showQuery);
    session_.whenChanged(ViewPart::Settings, this, &StatisticsPanel::showFaultyCells);
    connect(&scenes_, &SceneBuilder::sceneReady, this, &StatisticsPanel::showScene);
    connect(&session_, &Session::shownChanged, this, [this] {
        if (!scene_ || !session_.shown() || scene_->mesh.errorInSpace == session_.shown()->errorInSpace)
            return;
        scene_->mesh.errorInSpace = session_.shown()->errorInSpace;
        showFacts();
    });
    connect(&viewport, &Viewport::framePainted, this, [this](const FrameReport& report) {
        const auto faults =
            report.cells > 0 ? std::optional(OrderFaults{report.cutCells, report.brokenCycles}) : std::nullopt;
        if (report.moving || (report.seconds == frameSeconds_ && faults == orderFaults_))
            return;
        frameSeconds_ = report.seconds;
        orderFaults_ = faults;
        showFacts();
    });
}

void StatisticsPanel::showModel()
{
    setEnabled(session_.model() != nullptr);
    scene_.reset();
    frameSeconds_ = 0;
    orderFaults_.reset();
    histogram_->setHistogram(nullptr, {});
    showLevels();
    showFacts();
    showFaultyCells();
}

void StatisticsPanel::showFaultyCells()
{
    const auto& model = session_.model();
    const bool hasSome = model && faultyCellCount(*model) > 0;
    faultyCells_->setEnabled(hasSome);
    faultyCells_->setChecked(hasSome && showsFaultyCells(session_.view().appearance));
    faultyCells_->setToolTip(
        hasSome ? tr("Outline, over the picture, the cells that were left out because something is wrong with them, "
                     "and the cells of a grid that are folded or have no volume")
                : tr("This model lists no faulty cells: its data have none, or an earlier version of TAn built it"));
}

void StatisticsPanel::showLevels()
{
    const QSignalBlocker blocker(table_);
    const auto& model = session_.model();
    warping_ = session_.view().query.warping;
    levels_ = model ? levelStatistics(*model, pace_, warping_) : std::vector<LevelStatistics>();
    curve_->setCurve(model ? sizeAgainstError(*model, warping_) : std::vector<CurvePoint>());
    curve_->setErrorMeaning(meaningOf(session_));
    const bool ofLogarithms = model && logarithmsOf(model->description());
    table_->setHeaderLabels(levelColumns(meaningOf(session_), ofLogarithms));
    table_->clear();
    for (const LevelStatistics& level : levels_) {
        auto* item = new QTreeWidgetItem(table_, levelTexts(level));
        item->setData(0, errorRole, level.error);
        for (int index = 0; index < table_->columnCount(); ++index)
            item->setTextAlignment(index, Qt::AlignRight | Qt::AlignVCenter);
    }
    if (!levels_.empty())
        fitHeight(*table_);
    showQuery();
}

/// The line of the accuracy that is asked for, if it has one.
void StatisticsPanel::showQuery()
{
    const QueryState& query = session_.view().query;
    if (query.warping != warping_)
        return showLevels();
    const QSignalBlocker blocker(table_);
    table_->setCurrentItem(nullptr);
    for (int index = 0; index < table_->topLevelItemCount(); ++index)
        if (!query.byBudget && table_->topLevelItem(index)->data(0, errorRole).toDouble() == query.error)
            table_->setCurrentItem(table_->topLevelItem(index));
    curve_->setBudget(query.byBudget ? std::optional(query.budget) : std::nullopt);
    if (session_.model()) {
        const MeshSize size = session_.meshSize();
        curve_->setMarked({query.byBudget ? size.error : query.error, size.sites, size.tetrahedra});
    }
}

void StatisticsPanel::showScene(const BuiltScene& scene)
{
    scene_ = scene;
    scene_->scene.reset(); // only its numbers are of interest here
    histogram_->setHistogram(scene.mesh.histogram, scene.mesh.logarithms);
    if (const auto pace = secondsPerTetrahedron(scene)) {
        const bool isFirst = !pace_;
        pace_ = pace;
        if (isFirst)
            showLevels(); // later ones change the estimates little
    }
    showFacts();
}

void StatisticsPanel::showFacts()
{
    while (QLayoutItem* item = factGrid_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    facts_ = session_.model() ? modelFacts(*session_.model()) : std::vector<StatisticsFact>();
    if (scene_)
        for (const StatisticsFact& fact : sceneFacts(*scene_, frameSeconds_, orderFaults_))
            facts_.push_back(fact);
    int row = 0;
    for (const auto& [name, value] : facts_) {
        auto* text = new QLabel(value);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        text->setWordWrap(true);
        factGrid_->addWidget(new QLabel(name), row, 0, Qt::AlignTop);
        factGrid_->addWidget(text, row++, 1);
    }
}

void StatisticsPanel::copy() const
{
    QGuiApplication::clipboard()->setText(statisticsText(facts_, levels_, meaningOf(session_)));
}

} // namespace tetra
