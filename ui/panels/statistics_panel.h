// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/model_statistics.h"
#include "ui/workbench/workbench.h"

#include <QWidget>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace tetra {

class AccuracyCurve;
class HistogramView;
class Viewport;

/// What each accuracy costs, as a table and as a curve, and what is shown now in numbers (R26), with how often which
/// values occur in it. Choosing a line of the table chooses its accuracy.
class StatisticsPanel : public QWidget {
    Q_OBJECT
public:
    StatisticsPanel(Workbench& workbench, Viewport& viewport, QWidget* parent = nullptr);

signals:
    /// By the user: the table is to be saved.
    void saveWanted();

private:
    QLayout* makeButtons();
    void connectSources(Viewport& viewport);
    void showModel();
    void showLevels();
    void showQuery();
    void showScene(const BuiltScene& scene);
    void showFacts();
    void showFaultyCells();
    void copy() const;

    Session& session_;
    SceneBuilder& scenes_;
    AccuracyCurve* curve_;
    QTreeWidget* table_;
    QGridLayout* factGrid_;
    QCheckBox* faultyCells_;
    HistogramView* histogram_;
    QPushButton* copy_;
    QPushButton* save_;
    std::vector<LevelStatistics> levels_;
    WarpingChoice warping_; ///< of these
    std::vector<StatisticsFact> facts_;
    std::optional<BuiltScene> scene_;
    std::optional<double> pace_; ///< seconds for a tetrahedron, as last measured
    double frameSeconds_ = 0;
    std::optional<OrderFaults> orderFaults_; ///< of the last picture
};

} // namespace tetra
