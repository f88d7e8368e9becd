// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

#include <QAbstractTableModel>

namespace tetra {

/// The points in numbers, in the user's locale: each cell that is edited is one undo step. What is no number, or out of
/// range, changes nothing.
class PointTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Value, Opacity, Colour, Group, ColumnCount };

    /// `state` outlives it.
    explicit PointTableModel(EditorState& state, QObject* parent = nullptr);
    /// After the function has changed.
    void refresh();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    QString textOf(const TransferPoint& point, int column) const;
    /// As the data have it.
    double shownValue(const TransferPoint& point) const;
    bool edit(std::size_t point, int column, const QString& text);

    EditorState& state_;
    int rows_ = 0;
};

} // namespace tetra
