// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/value_statistics.h"
#include "ui/session/session.h"

#include <QWidget>

#include <functional>
#include <optional>

class QCheckBox;
class QGridLayout;
class QToolButton;

namespace tetra {

class ColourButton;
class ValueBox;
class ValueSlider;

/// The controls of one isovalue. Its parts are named isovalue.N.visible, .colour, .value, .opacity and .remove, where N
/// is its place in the list; of density maps also .deviations, the same value in standard deviations above the mean.
class IsovalueRow : public QWidget {
    Q_OBJECT
public:
    IsovalueRow(Session& session, int index, QWidget* parent = nullptr);

    /// Shows what the session has.
    void refresh();
    void focusValue();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    const Isovalue& isovalue() const;
    void layOut();
    void connectControls();
    void addDeviations(QGridLayout& grid);
    void edit(const std::function<void(Isovalue&)>& change);

    Session& session_;
    int index_; ///< in the list
    QCheckBox* visible_;
    ColourButton* colour_;
    ValueSlider* value_;
    ValueSlider* opacity_;
    std::optional<ValueStatistics> statistics_; ///< of density maps
    ValueBox* deviations_ = nullptr;            ///< null without them
    QToolButton* remove_;
};

} // namespace tetra
