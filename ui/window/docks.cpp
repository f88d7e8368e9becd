// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/docks.h"

#include "core/view/appearance.h"
#include "plugins/api/scene_parameters.h"
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
#include "ui/session/message_text.h"
#include "ui/tools/tool_panel.h"
#include "ui/widgets/mnemonics.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>

#include <algorithm>
#include <ranges>
#include <utility>

namespace tetra {
namespace {

class DockTexts {
    Q_DECLARE_TR_FUNCTIONS(Docks)
};

const std::string transferType = parameterTypeName(TransferFunction());

/// An editor plugin's dock, whether the plugin can be used or not.
struct EditorDock {
    std::string id;
    std::string type; ///< of the parameters that it edits
    QString title;
    QString help;
};

/// One for each editor that was found, that of transfer functions first. If there is none for these, its dock says so.
std::vector<EditorDock> editorDocks(const PluginHost& host)
{
    std::vector<EditorDock> docks;
    for (const PluginStatus& plugin : host.plugins())
        if (const PluginMetadata& data = plugin.metadata;
            plugin.hasMetadata && data.kind == PluginKind::Editor &&
            std::ranges::find(docks, data.id, &EditorDock::id) == docks.end())
            docks.push_back({data.id, data.edits, inUsersLanguage(data.title, data.titles),
                             inUsersLanguage(data.description, data.descriptions)});
    std::ranges::stable_partition(docks, [](const EditorDock& dock) { return dock.type == transferType; });
    if (docks.empty() || docks.front().type != transferType)
        docks.insert(docks.begin(), {"transfer", transferType, DockTexts::tr("Transfer"), {}});
    return docks;
}

/// What the mode's values are edited in comes to the front of its tabs, unless the user has closed it; the last one
/// over the others. Isovalues only where there is no transfer function, which says more of the picture.
void raiseEditors(const std::vector<Parameter>& parameters, const Docks& docks,
                  const std::vector<std::pair<std::string, QDockWidget*>>& editors)
{
    const auto hasType = [&](const std::string& type) {
        return std::ranges::any_of(parameters,
                                   [&](const Parameter& each) { return parameterTypeName(each.defaultValue) == type; });
    };
    const auto raise = [](QDockWidget& dock) {
        if (!dock.isHidden())
            dock.raise();
    };
    if (hasParameter(parameters, isovaluesId) && !hasType(transferType))
        raise(*docks.isovalues);
    for (const auto& [type, dock] : editors | std::views::reverse)
        if (hasType(type))
            raise(*dock);
}

constexpr int dockWidth = 372;
constexpr int upperHeight = 400;
constexpr int lowerHeight = 360;
/// A screen with less room has all panels in one place: one of 1366 x 768 pixels with letters of twice their size, say.
constexpr QSize leastForColumns(760, 420);

bool isSmall(const QSize& screen)
{
    return screen.width() < leastForColumns.width() || screen.height() < leastForColumns.height();
}

/// Docks are moved one by one, and for a moment stand below each other; the window has grown by that.
void takeBackSize(QMainWindow& window, const QSize& size)
{
    window.layout()->activate(); // what it needs at least
    if (window.size() != size && !window.isMaximized() && !window.isFullScreen())
        window.resize(size);
}

} // namespace

Docks makeDocks(QMainWindow& window, QMenu& menu, Workbench& workbench, Viewport& viewport, ValuePick& pick,
                ToolDesk& tools)
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
    docks.buildPanel = new BuildPanel(workbench);
    docks.focusPanel = new FocusPanel(session);
    docks.renderingPanel = new RenderingPanel(workbench, viewport);
    docks.build = add("build", DockTexts::tr("Build"),
                      DockTexts::tr("Build a model from a dataset once; a mesh is then available at any accuracy. "
                                    "Choose a builder and a file, and press Build."),
                      docks.buildPanel);
    docks.accuracy = add("accuracy", DockTexts::tr("Accuracy"),
                         DockTexts::tr("How far the mesh may deviate from the data, in percent of the value range; or "
                                       "how many tetrahedra it may have. The curve shows what each error costs."),
                         new AccuracyPanel(session));
    docks.rendering =
        add("rendering", DockTexts::tr("Rendering"),
            DockTexts::tr("Rendering mode and its settings: surfaces, volume or both."), docks.renderingPanel);
    docks.view = add(
        "view", DockTexts::tr("View"),
        DockTexts::tr(
            "The camera settings as numbers. In the picture: drag to turn, Shift+drag to move, use the wheel to zoom."),
        new ViewPanel(workbench, viewport));
    docks.statisticsPanel = new StatisticsPanel(workbench, viewport);
    docks.statistics = add("statistics", DockTexts::tr("Statistics"),
                           DockTexts::tr("What each accuracy costs in vertices, tetrahedra, time and memory, and the "
                                         "figures of the displayed mesh."),
                           docks.statisticsPanel);
    docks.isovalues =
        add("isovalues", DockTexts::tr("Isovalues"),
            DockTexts::tr("Surfaces on which the field has a given value, in data units."), new IsovaluePanel(session));
    std::vector<std::pair<std::string, QDockWidget*>> usable; // with what they edit
    for (const EditorDock& editor : editorDocks(workbench.host())) {
        QDockWidget* dock =
            add(editor.id.c_str(), editor.title, editor.help, makeEditorPage(workbench, pick, editor.id, editor.type));
        docks.editors.push_back(dock);
        if (docks.transfer == nullptr && editor.type == transferType)
            docks.transfer = dock;
        if (dock->findChild<QLabel*>(QString::fromStdString(editor.id) + ".missing") == nullptr)
            usable.emplace_back(editor.type, dock);
    }
    docks.focus =
        add("focus", DockTexts::tr("Focus"),
            DockTexts::tr("A sphere or a box in which the mesh is more accurate than outside."), docks.focusPanel);
    docks.region = add("region", DockTexts::tr("Region"),
                       DockTexts::tr("Which part of the domain is shown: a crop box, and a range of values."),
                       new RegionPanel(session));
    docks.animation =
        add("animation", DockTexts::tr("Animation"),
            DockTexts::tr("Films of the model: a turntable, or a path through key frames of your choice."),
            docks.animationPanel);
    docks.tools = add("tools", DockTexts::tr("Tools"),
                      DockTexts::tr("What the chosen tool can do and what it measures. In the picture: click a place, "
                                    "drag a handle; Return selects the next handle, and arrow keys move it."),
                      new ToolPanel(tools));
    giveMnemonics(menu);
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        separateMnemonics(*dock->widget(), *window.menuBar());
    QObject::connect(docks.renderingPanel, &RenderingPanel::modeChosen, docks.isovalues, [&workbench, docks, usable] {
        raiseEditors(workbench.scenes().matteringParameters(), docks, usable);
    });
    return docks;
}

void layOutDocks(QMainWindow& window, const Docks& docks, bool showBuild)
{
    const QSize size = window.size();
    const bool inOnePlace = isSmall(window.screen()->availableSize());
    window.addDockWidget(inOnePlace ? Qt::RightDockWidgetArea : Qt::LeftDockWidgetArea, docks.build);
    window.addDockWidget(Qt::RightDockWidgetArea, docks.accuracy);
    window.addDockWidget(Qt::RightDockWidgetArea, docks.isovalues);
    if (inOnePlace)
        window.tabifyDockWidget(docks.build, docks.accuracy);
    window.tabifyDockWidget(docks.accuracy, docks.rendering);
    window.tabifyDockWidget(docks.rendering, docks.view);
    window.tabifyDockWidget(docks.view, docks.statistics);
    if (inOnePlace)
        window.tabifyDockWidget(docks.statistics, docks.isovalues);
    QDockWidget* before = docks.isovalues;
    for (QDockWidget* editor : docks.editors) {
        window.tabifyDockWidget(before, editor);
        before = editor;
    }
    window.tabifyDockWidget(before, docks.focus);
    window.tabifyDockWidget(docks.focus, docks.region);
    window.tabifyDockWidget(docks.region, docks.animation);
    window.tabifyDockWidget(docks.animation, docks.tools);
    std::vector<QDockWidget*> all = docks.editors;
    all.insert(all.end(), {docks.build, docks.accuracy, docks.rendering, docks.view, docks.statistics, docks.isovalues,
                           docks.focus, docks.region, docks.animation, docks.tools});
    for (QDockWidget* dock : all) {
        dock->setFloating(false);
        dock->show();
    }
    docks.build->setVisible(showBuild);
    docks.animation->hide();
    docks.tools->hide();
    docks.isovalues->raise();
    docks.accuracy->raise();
    takeBackSize(window, size);
    window.resizeDocks({docks.build, docks.accuracy, docks.isovalues}, {dockWidth, dockWidth, dockWidth},
                       Qt::Horizontal);
    if (!inOnePlace)
        window.resizeDocks({docks.accuracy, docks.isovalues}, {upperHeight, lowerHeight}, Qt::Vertical);
}

void raiseDock(QDockWidget& dock)
{
    dock.show();
    dock.raise();
}

} // namespace tetra
