// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/point_table_model.h"

#include <QColor>
#include <QLocale>

#include <array>
#include <cmath>

namespace tetra {
namespace {

QColor colourOf(const TransferPoint& point)
{
    return QColor::fromRgbF(point.colour[0], point.colour[1], point.colour[2]);
}

/// In the user's locale, with or without a percent sign.
std::optional<double> numberIn(const QString& text)
{
    bool isNumber = false;
    const double number = QLocale().toDouble(QString(text).remove(QLocale().percent()).trimmed(), &isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

} // namespace

PointTableModel::PointTableModel(EditorState& state, QObject* parent) : QAbstractTableModel(parent), state_(state) {}

void PointTableModel::refresh()
{
    const int rows = state_.host().hasModel() ? static_cast<int>(state_.joinedFunction().points.size()) : 0;
    if (rows > rows_) {
        beginInsertRows({}, rows_, rows - 1);
        rows_ = rows;
        endInsertRows();
    } else if (rows < rows_) {
        beginRemoveRows({}, rows, rows_ - 1);
        rows_ = rows;
        endRemoveRows();
    }
    if (rows > 0)
        emit dataChanged(index(0, 0), index(rows - 1, ColumnCount - 1));
}

int PointTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : rows_;
}

int PointTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int{ColumnCount};
}

double PointTableModel::shownValue(const TransferPoint& point) const
{
    return state_.ofLogarithms() ? std::pow(10.0, point.value) : point.value;
}

QString PointTableModel::textOf(const TransferPoint& point, int column) const
{
    switch (column) {
    case Value: return QLocale().toString(shownValue(point), 'g', QLocale::FloatingPointShortest);
    case Opacity: return QLocale().toString(100.0 * point.opacity, 'g', 4);
    case Colour: return colourOf(point).name();
    case Group: return point.group ? QString::number(*point.group) : QString();
    default: return {};
    }
}

QVariant PointTableModel::data(const QModelIndex& index, int role) const
{
    const auto row = static_cast<std::size_t>(index.row());
    if (!index.isValid() || row >= state_.joinedFunction().points.size())
        return {};
    const TransferPoint& point = state_.joinedFunction().points[row];
    switch (role) {
    case Qt::DisplayRole:
        if (index.column() == Value)
            return QLocale().toString(shownValue(point), 'g', 7);
        [[fallthrough]];
    case Qt::EditRole: return textOf(point, index.column());
    case Qt::DecorationRole: return index.column() == Colour ? QVariant(colourOf(point)) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant(index.column() == Colour ? Qt::AlignLeft | Qt::AlignVCenter
                                                 : Qt::AlignRight | Qt::AlignVCenter);
    default: return {};
    }
}

QVariant PointTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    if (role == Qt::DisplayRole) {
        const std::array names{tr("Value"), tr("Opacity, %"), tr("Colour"), tr("Group")};
        return names.at(static_cast<std::size_t>(section));
    }
    if (role == Qt::ToolTipRole) {
        const std::array tips{tr("In data units"), tr("Fraction absorbed per unit distance"),
                              tr("As a name or as #rrggbb"), tr("0 to 9, or empty")};
        return tips.at(static_cast<std::size_t>(section));
    }
    return {};
}

Qt::ItemFlags PointTableModel::flags(const QModelIndex& index) const
{
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

bool PointTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const auto point = static_cast<std::size_t>(index.row());
    if (role != Qt::EditRole || !index.isValid() || point >= state_.joinedFunction().points.size() ||
        value.toString() == textOf(state_.joinedFunction().points[point], index.column()))
        return false;
    return edit(point, index.column(), value.toString());
}

bool PointTableModel::edit(std::size_t point, int column, const QString& text)
{
    const JoinedFunction& before = state_.joinedFunction();
    EditedSelection edited{before, {point}};
    if (column == Value) {
        const bool ofLogarithms = state_.ofLogarithms();
        if (const auto number = numberIn(text); number && (!ofLogarithms || *number > 0))
            edited = withValue(before, {point}, ofLogarithms ? std::log10(*number) : *number, state_.rule(),
                               state_.limits());
    } else if (column == Opacity) {
        if (const auto percent = numberIn(text))
            edited = withOpacity(before, {point}, *percent / 100);
    } else if (column == Colour) {
        if (const QColor colour(text.trimmed()); colour.isValid())
            edited = withColour(before, TransferSelection{point},
                                {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                                 static_cast<float>(colour.blueF())});
    } else if (text.trimmed().isEmpty()) {
        edited = withGroup(before, {point}, std::nullopt);
    } else if (const auto group = numberIn(text); group && *group == static_cast<int>(*group)) {
        edited = withGroup(before, {point}, static_cast<int>(*group));
    }
    const bool changes = edited.function != before;
    if (changes)
        state_.apply(edited);
    return changes;
}

} // namespace tetra
