// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/docks.h"

#include "ui/panels/accuracy_panel.h"
#include "ui/panels/animation_panel.h"
#include "ui/panels/build_panel.h"
#include "ui/panels/editor_page.h"
#include "ui/panels/focus_panel.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/panels/region_panel.h"
#include "ui/panels/rendering_panel.h"
#include "ui/panels/statistics_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/widgets/mnemonics.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace tetra {
namespace {

class DockTexts {
    Q_DECLARE_TR_FUNCTIONS(Docks)
};

constexpr int dockWidth = 372;
constexpr int upperHeight = 400;
constexpr int lowerHeight = 360;

} // namespace

Docks makeDocks(QMainWindow& window, QMenu& menu, Workbench& workbench, Viewport& viewport, ValuePick& pick)
{
    const auto add = [&](const char* name, const QString& title, const QString& help, QWidget* content) {
        auto* dock = new QDockWidget(title);
        dock->setObjectName(QString("dock.") + name);
        dock->setWhatsThis(help);
        dock->setWidget(content);
        window.addDockWidget(Qt::RightDockWidgetArea, dock);
        dock->toggleViewAction()->setObjectName(QString("action.dock.") + name);
        menu.addAction(dock->toggleViewAction());
        return dock;
    };
    Session& session = workbench.session();
    Docks docks;
    docks.animationPanel = new AnimationPanel(workbench, viewport);
    docks.focusPanel = new FocusPanel(session);
    docks.renderingPanel = new RenderingPanel(workbench, viewport);
    docks.build =
        add("build", DockTexts::tr("Build"),
            DockTexts::tr("A dataset is turned into a model once: a mesh of tetrahedra that can be had at any "
                          "accuracy from then on. Choose a method and a file, and start."),
            new BuildPanel(workbench));
    docks.accuracy =
        add("accuracy", DockTexts::tr("Accuracy"),
            DockTexts::tr("How far the mesh may deviate from the data, in percent of the range of values; or "
                          "how many tetrahedra it may have. The curve shows what each error costs."),
            new AccuracyPanel(session));
    docks.rendering =
        add("rendering", DockTexts::tr("Rendering"),
            DockTexts::tr("Rendering mode and its settings: surfaces, volume or both."), docks.renderingPanel);
    docks.view =
        add("view", DockTexts::tr("View"),
            DockTexts::tr("From where the model is seen, in numbers. In the picture: drag to turn, Shift and drag "
                          "to move, the wheel zooms."),
            new ViewPanel(workbench, viewport));
    docks.statisticsPanel = new StatisticsPanel(workbench, viewport);
    docks.statistics = add(
        "statistics", DockTexts::tr("Statistics"),
        DockTexts::tr(
            "What each accuracy costs in vertices, tetrahedra, time and memory, and the mesh shown now in numbers."),
        docks.statisticsPanel);
    docks.isovalues = add("isovalues", DockTexts::tr("Isovalues"),
                          DockTexts::tr("Surfaces on which the field has one value each, in the units of the data."),
                          new IsovaluePanel(session));
    docks.transfer =
        add("transfer", DockTexts::tr("Transfer"),
            DockTexts::tr("The transfer function gives each value a colour and an opacity for the volume."),
            makeEditorPage(workbench, pick, "transferfunction"));
    docks.focus =
        add("focus", DockTexts::tr("Focus"),
            DockTexts::tr("A sphere or a box in which the mesh is more accurate than outside."), docks.focusPanel);
    docks.region = add("region", DockTexts::tr("Region"),
                       DockTexts::tr("Which part of the domain is shown at all: a box, and a range of values."),
                       new RegionPanel(session));
    docks.animation =
        add("animation", DockTexts::tr("Animation"),
            DockTexts::tr("Films of the model: a turntable, or a path through key frames that you choose."),
            docks.animationPanel);
    giveMnemonics(menu);
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        separateMnemonics(*dock->widget(), *window.menuBar());
    QObject::connect(docks.renderingPanel, &RenderingPanel::transferWanted, docks.transfer,
                     [dock = docks.transfer] { raiseDock(*dock); });
    QObject::connect(docks.renderingPanel, &RenderingPanel::isovaluesWanted, docks.isovalues,
                     [dock = docks.isovalues] { raiseDock(*dock); });
    return docks;
}

void layOutDocks(QMainWindow& window, const Docks& docks, bool showBuild)
{
    window.addDockWidget(Qt::LeftDockWidgetArea, docks.build);
    window.addDockWidget(Qt::RightDockWidgetArea, docks.accuracy);
    window.addDockWidget(Qt::RightDockWidgetArea, docks.isovalues);
    window.tabifyDockWidget(docks.accuracy, docks.rendering);
    window.tabifyDockWidget(docks.rendering, docks.view);
    window.tabifyDockWidget(docks.view, docks.statistics);
    window.tabifyDockWidget(docks.isovalues, docks.transfer);
    window.tabifyDockWidget(docks.transfer, docks.focus);
    window.tabifyDockWidget(docks.focus, docks.region);
    window.tabifyDockWidget(docks.region, docks.animation);
    for (QDockWidget* dock : {docks.build, docks.accuracy, docks.rendering, docks.view, docks.statistics,
                              docks.isovalues, docks.transfer, docks.focus, docks.region, docks.animation}) {
        dock->setFloating(false);
        dock->show();
    }
    docks.build->setVisible(showBuild);
    docks.animation->hide();
    docks.accuracy->raise();
    docks.isovalues->raise();
    window.resizeDocks({docks.build, docks.accuracy, docks.isovalues}, {dockWidth, dockWidth, dockWidth},
                       Qt::Horizontal);
    window.resizeDocks({docks.accuracy, docks.isovalues}, {upperHeight, lowerHeight}, Qt::Vertical);
}

void raiseDock(QDockWidget& dock)
{
    dock.show();
    dock.raise();
}

} // namespace tetra
