// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/docks.h"

#include "ui/panels/accuracy_panel.h"
#include "ui/panels/animation_panel.h"
#include "ui/panels/build_panel.h"
#include "ui/panels/focus_panel.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/panels/region_panel.h"
#include "ui/panels/rendering_panel.h"
#include "ui/panels/transfer_panel.h"
#include "ui/panels/view_panel.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

namespace tetra {
namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(Docks)
};

constexpr int dockWidth = 372;
constexpr int upperHeight = 400;
constexpr int lowerHeight = 360;

} // namespace

Docks makeDocks(QMainWindow& window, QMenu& menu, Workbench& workbench, Viewport& viewport)
{
    const auto add = [&](const char* name, const QString& title, QWidget* content) {
        auto* dock = new QDockWidget(title);
        dock->setObjectName(QString("dock.") + name);
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
    docks.build = add("build", Texts::tr("Build"), new BuildPanel(workbench));
    docks.accuracy = add("accuracy", Texts::tr("Accuracy"), new AccuracyPanel(session));
    docks.rendering = add("rendering", Texts::tr("Rendering"), docks.renderingPanel);
    docks.view = add("view", Texts::tr("View"), new ViewPanel(workbench, viewport));
    docks.isovalues = add("isovalues", Texts::tr("Isovalues"), new IsovaluePanel(session));
    docks.transfer = add("transfer", Texts::tr("Transfer"), new TransferPanel(workbench));
    docks.focus = add("focus", Texts::tr("Focus"), docks.focusPanel);
    docks.region = add("region", Texts::tr("Region"), new RegionPanel(session));
    docks.animation = add("animation", Texts::tr("Animation"), docks.animationPanel);
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
    window.tabifyDockWidget(docks.isovalues, docks.transfer);
    window.tabifyDockWidget(docks.transfer, docks.focus);
    window.tabifyDockWidget(docks.focus, docks.region);
    window.tabifyDockWidget(docks.region, docks.animation);
    for (QDockWidget* dock : {docks.build, docks.accuracy, docks.rendering, docks.view, docks.isovalues, docks.transfer,
                              docks.focus, docks.region, docks.animation}) {
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
