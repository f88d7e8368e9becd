// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/actions.h"

#include "plugins/widgets/icons.h"
#include "ui/opening/sample_models.h"
#include "ui/viewport/camera_controls.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/palette_commands.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QUndoStack>

namespace tetra {
namespace {

class ActionTexts {
    Q_DECLARE_TR_FUNCTIONS(Actions)
};

QMenu* addMenu(QMainWindow& window, const char* name, const QString& text)
{
    QMenu* menu = window.menuBar()->addMenu(text);
    menu->setObjectName(QString("menu.") + name);
    return menu;
}

void addSamples(QMenu* menu)
{
    menu->setObjectName("menu.samples");
    menu->setToolTipsVisible(true);
    for (const SampleCard& card : sampleCards()) {
        QAction* action = menu->addAction(QString(card.title).replace('&', "&&"));
        action->setObjectName("action.sample." + QString::fromStdString(card.name));
        action->setData(QString::fromStdString(card.name));
        action->setToolTip(card.description);
        action->setStatusTip(card.description);
    }
    giveMnemonics(*menu);
}

void addFileMenu(QMainWindow& window, Actions& actions)
{
    QMenu* menu = addMenu(window, "file", ActionTexts::tr("&File"));
    actions.open = addAction(*menu, "open", ActionTexts::tr("&Open…"), QKeySequence::Open,
                             ActionTexts::tr("Open a dataset or a model"));
    actions.open->setIcon(glyphIcon(Glyph::Open));
    actions.openWithOptions =
        addAction(*menu, "openWithOptions", ActionTexts::tr("Import with Op&tions…"), QKeySequence("Ctrl+Shift+O"),
                  ActionTexts::tr("Open a part of a dataset, or choose how its file is read"));
    actions.openAddress = addAction(*menu, "openAddress", ActionTexts::tr("Ope&n URL…"), QKeySequence("Ctrl+Alt+O"),
                                    ActionTexts::tr("Open a model on a server"));
    actions.recent = menu->addMenu(ActionTexts::tr("Open &Recent"));
    actions.recent->setObjectName("menu.recent");
    actions.samples = menu->addMenu(ActionTexts::tr("Open Samp&le"));
    addSamples(actions.samples);
    menu->addSeparator();
    actions.saveSession = addAction(*menu, "saveSession", ActionTexts::tr("&Save Session"), QKeySequence::Save,
                                    ActionTexts::tr("Save the open model and its view, to continue later"));
    actions.saveSessionAs = addAction(*menu, "saveSessionAs", ActionTexts::tr("Save Session &As…"), {},
                                      ActionTexts::tr("Save the session under another name"));
    actions.applyLook = addAction(
        *menu, "applyLook", ActionTexts::tr("Appl&y Look From…"), {},
        ActionTexts::tr(
            "Apply the colours, isovalues, camera and settings of another session or picture to the open model"));
    menu->addSeparator();
    actions.savePicture = addAction(*menu, "savePicture", ActionTexts::tr("Save &Picture…"),
                                    QKeySequence("Ctrl+Shift+S"), ActionTexts::tr("Save the view as a PNG picture"));
    actions.savePicture->setIcon(glyphIcon(Glyph::Picture));
    actions.saveFilm = addAction(*menu, "saveFilm", ActionTexts::tr("Save &Film…"), QKeySequence("Ctrl+Alt+S"),
                                 ActionTexts::tr("Save the animation as pictures or a video"));
    actions.saveMesh = addAction(*menu, "saveMesh", ActionTexts::tr("Save &Mesh…"), QKeySequence("Ctrl+M"),
                                 ActionTexts::tr("Save the displayed mesh for VTK, ParaView and other programs"));
    actions.saveMesh->setIcon(glyphIcon(Glyph::Mesh));
    actions.saveSurfaces = addAction(
        *menu, "saveSurfaces", ActionTexts::tr("Save S&urfaces…"), QKeySequence("Ctrl+Shift+M"),
        ActionTexts::tr("Save the displayed isosurfaces for 3D printing, Blender, ParaView and other programs"));
    actions.saveSolids =
        addAction(*menu, "saveSolids", ActionTexts::tr("Save Soli&ds…"), {},
                  ActionTexts::tr("Save the displayed isosurfaces as closed surfaces of solids, for 3D printing"));
    actions.saveStatistics = addAction(*menu, "saveStatistics", ActionTexts::tr("Save Stat&istics…"), {},
                                       ActionTexts::tr("Save the mesh size at each accuracy as a table"));
    actions.savePacked =
        addAction(*menu, "savePacked", ActionTexts::tr("Save Pac&ked Model…"), {},
                  ActionTexts::tr("Save the model at a fraction of its size, for archiving or for a server"));
    menu->addSeparator();
    actions.modelCache = addAction(*menu, "modelCache", ActionTexts::tr("Model Cac&he…"), {},
                                   ActionTexts::tr("Manage the cache of downloaded and unpacked models"));
    menu->addSeparator();
    actions.close = addAction(*menu, "close", ActionTexts::tr("&Close"), QKeySequence::Close,
                              ActionTexts::tr("Close the model and its dataset"));
    actions.quit =
        addAction(*menu, "quit", ActionTexts::tr("&Quit"), QKeySequence("Ctrl+Q"), ActionTexts::tr("Quit TAn"));
}

/// "Undo Move Camera" in some languages is "Undo: Move Camera"; what has nothing to name needs no colon.
void endWithoutColon(QAction* action)
{
    if (action->text().endsWith(':'))
        action->setText(action->text().chopped(1));
}

void addEditMenu(QMainWindow& window, QUndoStack& undoStack, Actions& actions)
{
    QMenu* menu = addMenu(window, "edit", ActionTexts::tr("&Edit"));
    actions.undo = undoStack.createUndoAction(&window, ActionTexts::tr("&Undo"));
    actions.redo = undoStack.createRedoAction(&window, ActionTexts::tr("&Redo"));
    QObject::connect(&undoStack, &QUndoStack::undoTextChanged, actions.undo,
                     [undo = actions.undo] { endWithoutColon(undo); });
    QObject::connect(&undoStack, &QUndoStack::redoTextChanged, actions.redo,
                     [redo = actions.redo] { endWithoutColon(redo); });
    for (QAction* action : {actions.undo, actions.redo})
        endWithoutColon(action);
    actions.undo->setObjectName("action.undo");
    actions.redo->setObjectName("action.redo");
    actions.undo->setShortcut(QKeySequence::Undo);
    actions.redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    actions.undo->setIcon(glyphIcon(Glyph::Undo));
    actions.redo->setIcon(glyphIcon(Glyph::Redo));
    menu->addAction(actions.undo);
    menu->addAction(actions.redo);
    menu->addSeparator();
    actions.copyPicture = addAction(*menu, "copyPicture", ActionTexts::tr("&Copy Picture"),
                                    QKeySequence("Ctrl+Shift+C"), ActionTexts::tr("Copy the view to the clipboard"));
    menu->addSeparator();
    actions.addIsovalue = addAction(*menu, "addIsovalue", ActionTexts::tr("&Add Isovalue"), QKeySequence("Ctrl+I"),
                                    ActionTexts::tr("Add an isosurface at another value"));
    actions.addIsovalue->setIcon(glyphIcon(Glyph::Add));
    actions.picked = menu->addMenu(ActionTexts::tr("Picked &Value"));
    actions.picked->setObjectName("menu.picked");
    menu->addSeparator();
    actions.palette = addAction(*menu, "palette", ActionTexts::tr("&Find Command…"), QKeySequence("Ctrl+Shift+P"),
                                ActionTexts::tr("Search all commands"));
}

void addNamedViews(QMenu* menu, Actions& actions)
{
    struct Entry {
        const char* name;
        QString text;
    };
    const Entry entries[] = {
        {"front", ActionTexts::tr("&Front")},   {"back", ActionTexts::tr("&Back")},
        {"left", ActionTexts::tr("&Left")},     {"right", ActionTexts::tr("&Right")},
        {"top", ActionTexts::tr("&Top")},       {"bottom", ActionTexts::tr("B&ottom")},
        {"corner", ActionTexts::tr("&Corner")},
    };
    int key = 1;
    for (const Entry& entry : entries) {
        const QString name = QString("view.") + entry.name;
        QAction* action =
            addAction(*menu, name.toUtf8().constData(), entry.text, QKeySequence(QString("Ctrl+%1").arg(key++)),
                      ActionTexts::tr("Look from this side"));
        actions.namedViews.append(action);
    }
}

void addViewMenu(QMainWindow& window, Actions& actions)
{
    QMenu* menu = addMenu(window, "view", ActionTexts::tr("&View"));
    actions.fit = addAction(*menu, "fit", ActionTexts::tr("&Fit"), QKeySequence(Qt::Key_Home),
                            ActionTexts::tr("Frame what is shown, or the focus; press again for the whole domain"));
    actions.fit->setIcon(glyphIcon(Glyph::Fit));
    actions.fitWhole = addAction(*menu, "fitWhole", ActionTexts::tr("Fit &Whole Domain"),
                                 QKeySequence(Qt::SHIFT | Qt::Key_Home), ActionTexts::tr("Frame the whole domain"));
    actions.lookFrom = menu->addMenu(ActionTexts::tr("&Look From"));
    actions.lookFrom->setObjectName("menu.namedViews");
    addNamedViews(actions.lookFrom, actions);
    actions.orientation = menu->addMenu(ActionTexts::tr("&Orientation"));
    actions.orientation->setObjectName("menu.orientation");
    actions.bookmarks = menu->addMenu(ActionTexts::tr("&Bookmarks"));
    actions.bookmarks->setObjectName("menu.bookmarks");
    actions.perspective = addAction(*menu, "perspective", ActionTexts::tr("&Perspective"), QKeySequence("Ctrl+P"),
                                    ActionTexts::tr("Perspective, or parallel projection"));
    actions.perspective->setCheckable(true);
    actions.perspective->setChecked(true);
    actions.resetView = addAction(*menu, "resetView", ActionTexts::tr("Reset &View"), {},
                                  ActionTexts::tr("Restore the default accuracy, colours, isovalues and camera"));
    menu->addSeparator();
    actions.modes = menu->addMenu(ActionTexts::tr("&Show"));
    actions.modes->setObjectName("menu.modes");
    actions.annotations = menu->addMenu(ActionTexts::tr("&Annotations"));
    actions.annotations->setObjectName("menu.annotations");
    menu->addSeparator();
    actions.panels = menu->addMenu(ActionTexts::tr("Pa&nels"));
    actions.panels->setObjectName("menu.panels");
    actions.resetLayout = addAction(*menu, "resetLayout", ActionTexts::tr("Reset La&yout"), {},
                                    ActionTexts::tr("Restore the default layout"));
    actions.fullScreen = addAction(*menu, "fullScreen", ActionTexts::tr("F&ull Screen"), QKeySequence(Qt::Key_F11),
                                   ActionTexts::tr("Use the whole screen"));
    actions.fullScreen->setCheckable(true);
    menu->addSeparator();
    actions.reducedMotion = addAction(*menu, "reducedMotion", ActionTexts::tr("Reduced &Motion"), {},
                                      ActionTexts::tr("Disable camera animation"));
    actions.reducedMotion->setCheckable(true);
    actions.languages = menu->addMenu(ActionTexts::tr("Lan&guage"));
    actions.languages->setObjectName("menu.languages");
}

void addHelpMenu(QMainWindow& window, Actions& actions)
{
    QMenu* menu = addMenu(window, "help", ActionTexts::tr("&Help"));
    actions.manual = addAction(*menu, "manual", ActionTexts::tr("&Manual"), QKeySequence("Ctrl+F1"),
                               ActionTexts::tr("Open the manual in the browser"));
    actions.help = addAction(*menu, "help", ActionTexts::tr("&Help on This Control"), QKeySequence(Qt::Key_F1),
                             ActionTexts::tr("Explain the control that has the focus"));
    actions.whatsThis = addAction(*menu, "whatsThis", ActionTexts::tr("&What Is This?"), QKeySequence("Shift+F1"),
                                  ActionTexts::tr("Click a control to read what it does"));
    menu->addSeparator();
    actions.plugins =
        addAction(*menu, "plugins", ActionTexts::tr("&Plugins…"), {}, ActionTexts::tr("Installed plugins"));
    actions.about =
        addAction(*menu, "about", ActionTexts::tr("&About TAn"), {}, ActionTexts::tr("Version and licence"));
}

void addToolBar(QMainWindow& window, Actions& actions)
{
    QToolBar* bar = window.addToolBar(ActionTexts::tr("Tool Bar"));
    bar->setObjectName("toolBar");
    bar->toggleViewAction()->setObjectName("action.toolBar");
    actions.panels->addAction(bar->toggleViewAction());
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->setIconSize({20, 20});
    bar->addAction(actions.open);
    bar->addAction(actions.savePicture);
    bar->addAction(actions.saveMesh);
    bar->addSeparator();
    bar->addAction(actions.undo);
    bar->addAction(actions.redo);
    bar->addSeparator();
    bar->addAction(actions.addIsovalue);
    bar->addAction(actions.fit);
    bar->addSeparator();
    actions.toolBar = bar;
}

void addNeeds(const Actions& actions)
{
    for (QAction* action :
         QList<QAction*>{actions.saveSession, actions.saveSessionAs, actions.applyLook, actions.savePicture,
                         actions.saveMesh, actions.saveSurfaces, actions.saveSolids, actions.saveStatistics,
                         actions.addIsovalue, actions.fit, actions.fitWhole, actions.resetView} +
             actions.namedViews)
        setNeed(*action, ActionTexts::tr("Open a model first"));
    setNeed(*actions.savePacked, ActionTexts::tr("Open a whole model first"));
    setNeed(*actions.close, ActionTexts::tr("There is nothing to close"));
    setNeed(*actions.undo, ActionTexts::tr("There is nothing to undo"));
    setNeed(*actions.redo, ActionTexts::tr("There is nothing to redo"));
}

} // namespace

QAction* addAction(QMenu& menu, const char* name, const QString& text, const QKeySequence& shortcut,
                   const QString& toolTip)
{
    QAction* action = menu.addAction(text);
    action->setObjectName(QString("action.") + name);
    action->setShortcut(shortcut);
    const QString keys = shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? toolTip : ActionTexts::tr("%1 (%2)").arg(toolTip, keys));
    return action;
}

Actions makeActions(QMainWindow& window, QUndoStack& undoStack)
{
    Actions actions;
    addFileMenu(window, actions);
    addEditMenu(window, undoStack, actions);
    addViewMenu(window, actions);
    actions.region = addMenu(window, "region", ActionTexts::tr("&Region"));
    actions.tools = addMenu(window, "tools", ActionTexts::tr("&Tools"));
    addHelpMenu(window, actions);
    addToolBar(window, actions);
    addNeeds(actions);
    return actions;
}

} // namespace tetra
