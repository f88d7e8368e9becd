// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/point_table_model.h"

#include <QTableView>

namespace tetra {

/// The points in numbers; what is selected here is selected in the plot and the other way round.
class PointTable : public QTableView {
    Q_OBJECT
public:
    /// `state` outlives it.
    explicit PointTable(EditorState& state, QWidget* parent = nullptr);
    /// After the function has changed.
    void refresh();
    QSize sizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void takeSelection();
    void showSelection();

    EditorState& state_;
    PointTableModel* model_;
    bool showing_ = false; ///< what comes from the plot does not go back there
};

} // namespace tetra
