// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/point_table.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QScopedValueRollback>

#include <algorithm>

namespace tetra {
namespace {

constexpr int shownRows = 6;

} // namespace

PointTable::PointTable(EditorState& state, QWidget* parent)
    : QTableView(parent), state_(state), model_(new PointTableModel(state, this))
{
    setObjectName("transfer.table");
    setModel(model_);
    setAccessibleName(tr("Points of the transfer function"));
    setToolTip(tr("Double click or F2 edits a cell; Del removes the selected points"));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                    QAbstractItemView::AnyKeyPressed);
    setAlternatingRowColors(true);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(PointTableModel::Colour, QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(PointTableModel::Group, QHeaderView::ResizeToContents);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    verticalHeader()->setHighlightSections(false);
    setMinimumHeight(horizontalHeader()->sizeHint().height() + shownRows * verticalHeader()->defaultSectionSize());
    setTabKeyNavigation(false);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &PointTable::takeSelection);
    connect(&state, &EditorState::selectionChanged, this, &PointTable::showSelection);
    refresh();
}

void PointTable::refresh()
{
    {
        const QScopedValueRollback guard(showing_, true); // rows that go away are no choice of the user's
        model_->refresh();
    }
    showSelection();
}

QSize PointTable::sizeHint() const
{
    const int rows = std::clamp(model_->rowCount(), 2, shownRows);
    return {200, horizontalHeader()->sizeHint().height() + rows * verticalHeader()->defaultSectionSize() + 4};
}

void PointTable::takeSelection()
{
    if (showing_)
        return;
    TransferSelection selection;
    for (const QModelIndex& row : selectionModel()->selectedRows())
        selection.push_back(static_cast<std::size_t>(row.row()));
    state_.select(std::move(selection));
}

void PointTable::showSelection()
{
    const QScopedValueRollback guard(showing_, true);
    QItemSelection rows;
    for (const std::size_t point : state_.selection())
        if (const QModelIndex row = model_->index(static_cast<int>(point), 0); row.isValid())
            rows.select(row, row);
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    const auto point = state_.currentPoint();
    if (point && !hasFocus() && static_cast<int>(*point) < model_->rowCount())
        scrollTo(model_->index(static_cast<int>(*point), 0));
}

void PointTable::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete)
        state_.removeCurrent();
    else
        QTableView::keyPressEvent(event);
}

} // namespace tetra
