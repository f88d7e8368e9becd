// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/actions.h"

#include "plugins/widgets/icons.h"
#include "ui/viewport/camera_controls.h"
#include "ui/window/palette_commands.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QUndoStack>

namespace tetra {
namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(Actions)
};

QAction* add(QMenu* menu, const char* name, const QString& text, const QKeySequence& shortcut, const QString& toolTip)
{
    QAction* action = menu->addAction(text);
    action->setObjectName(QString("action.") + name);
    action->setShortcut(shortcut);
    const QString keys = shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? toolTip : Texts::tr("%1 (%2)").arg(toolTip, keys));
    return action;
}

QMenu* addMenu(QMainWindow& window, const char* name, const QString& text)
{
    QMenu* menu = window.menuBar()->addMenu(text);
    menu->setObjectName(QString("menu.") + name);
    return menu;
}

void addFileMenu(QMainWindow& window, Actions& actions)
{
    QMenu* menu = addMenu(window, "file", Texts::tr("&File"));
    actions.open = add(menu, "open", Texts::tr("&Open…"), QKeySequence::Open, Texts::tr("Open a dataset or a model"));
    actions.open->setIcon(glyphIcon(Glyph::Open));
    actions.openWithOptions =
        add(menu, "openWithOptions", Texts::tr("Import with Op&tions…"), QKeySequence("Ctrl+Shift+O"),
            Texts::tr("Open a part of a dataset, or say how its file is to be read"));
    actions.recent = menu->addMenu(Texts::tr("Open &Recent"));
    actions.recent->setObjectName("menu.recent");
    menu->addSeparator();
    actions.saveSession = add(menu, "saveSession", Texts::tr("&Save Session"), QKeySequence::Save,
                              Texts::tr("Save what is open and how it is seen, to go on with later"));
    actions.saveSessionAs =
        add(menu, "saveSessionAs", Texts::tr("Save Session &As…"), {}, Texts::tr("Save the session in another file"));
    menu->addSeparator();
    actions.savePicture = add(menu, "savePicture", Texts::tr("Save &Picture…"), QKeySequence("Ctrl+Shift+S"),
                              Texts::tr("Save what is seen as a PNG picture"));
    actions.savePicture->setIcon(glyphIcon(Glyph::Picture));
    actions.saveFilm = add(menu, "saveFilm", Texts::tr("Save &Film…"), QKeySequence("Ctrl+Alt+S"),
                           Texts::tr("Save the animation as pictures or a video"));
    actions.saveMesh = add(menu, "saveMesh", Texts::tr("Save &Mesh…"), QKeySequence("Ctrl+M"),
                           Texts::tr("Save the mesh that is seen, for VTK, ParaView and others"));
    actions.saveMesh->setIcon(glyphIcon(Glyph::Mesh));
    actions.saveSurfaces =
        add(menu, "saveSurfaces", Texts::tr("Save S&urfaces…"), QKeySequence("Ctrl+Shift+M"),
            Texts::tr("Save the isosurfaces that are seen, for 3D printers, Blender, ParaView and others"));
    actions.saveStatistics = add(menu, "saveStatistics", Texts::tr("Save Stat&istics…"), {},
                                 Texts::tr("Save how large the mesh of each accuracy is, as a table"));
    menu->addSeparator();
    actions.close =
        add(menu, "close", Texts::tr("&Close"), QKeySequence::Close, Texts::tr("Close the model and its dataset"));
    actions.quit = add(menu, "quit", Texts::tr("&Quit"), QKeySequence("Ctrl+Q"), Texts::tr("Leave the program"));
}

/// "Undo change of view" in some languages is "Undo: change of view"; what has nothing to name needs no colon.
void endWithoutColon(QAction* action)
{
    if (action->text().endsWith(':'))
        action->setText(action->text().chopped(1));
}

void addEditMenu(QMainWindow& window, QUndoStack& undoStack, Actions& actions)
{
    QMenu* menu = addMenu(window, "edit", Texts::tr("&Edit"));
    actions.undo = undoStack.createUndoAction(&window, Texts::tr("&Undo"));
    actions.redo = undoStack.createRedoAction(&window, Texts::tr("&Redo"));
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
    actions.copyPicture = add(menu, "copyPicture", Texts::tr("&Copy Picture"), QKeySequence("Ctrl+Shift+C"),
                              Texts::tr("Put what is seen on the clipboard, in the size that it is seen in"));
    menu->addSeparator();
    actions.addIsovalue = add(menu, "addIsovalue", Texts::tr("&Add Isovalue"), QKeySequence("Ctrl+I"),
                              Texts::tr("Add an isosurface at another value"));
    actions.addIsovalue->setIcon(glyphIcon(Glyph::Add));
    actions.picked = menu->addMenu(Texts::tr("Picked &Value"));
    actions.picked->setObjectName("menu.picked");
    menu->addSeparator();
    actions.palette = add(menu, "palette", Texts::tr("&Find Command…"), QKeySequence("Ctrl+Shift+P"),
                          Texts::tr("Find whatever the program can do by a few letters of its name"));
}

void addNamedViews(QMenu* menu, Actions& actions)
{
    struct Entry {
        const char* name;
        QString text;
    };
    const Entry entries[] = {
        {"front", Texts::tr("&Front")},   {"back", Texts::tr("&Back")}, {"left", Texts::tr("&Left")},
        {"right", Texts::tr("&Right")},   {"top", Texts::tr("&Top")},   {"bottom", Texts::tr("B&ottom")},
        {"corner", Texts::tr("&Corner")},
    };
    int key = 1;
    for (const Entry& entry : entries) {
        const QString name = QString("view.") + entry.name;
        QAction* action = add(menu, name.toUtf8().constData(), entry.text, QKeySequence(QString("Ctrl+%1").arg(key++)),
                              Texts::tr("Look from this side"));
        actions.namedViews.append(action);
    }
}

void addViewMenu(QMainWindow& window, Actions& actions)
{
    QMenu* menu = addMenu(window, "view", Texts::tr("&View"));
    actions.fit = add(menu, "fit", Texts::tr("&Fit"), QKeySequence(Qt::Key_Home), Texts::tr("Show the whole domain"));
    actions.fit->setIcon(glyphIcon(Glyph::Fit));
    actions.lookFrom = menu->addMenu(Texts::tr("&Look From"));
    actions.lookFrom->setObjectName("menu.namedViews");
    addNamedViews(actions.lookFrom, actions);
    actions.perspective = add(menu, "perspective", Texts::tr("&Perspective"), QKeySequence("Ctrl+P"),
                              Texts::tr("Perspective, or parallel projection"));
    actions.perspective->setCheckable(true);
    actions.perspective->setChecked(true);
    actions.resetView = add(menu, "resetView", Texts::tr("Reset &View"), {},
                            Texts::tr("Go back to the default accuracy, colours, isovalues and camera"));
    menu->addSeparator();
    actions.modes = menu->addMenu(Texts::tr("&Show"));
    actions.modes->setObjectName("menu.modes");
    actions.annotations = menu->addMenu(Texts::tr("&Annotations"));
    actions.annotations->setObjectName("menu.annotations");
    menu->addSeparator();
    actions.panels = menu->addMenu(Texts::tr("Pa&nels"));
    actions.panels->setObjectName("menu.panels");
    actions.resetLayout = add(menu, "resetLayout", Texts::tr("Reset La&yout"), {},
                              Texts::tr("Put all panels back to where they were at first"));
    actions.fullScreen = add(menu, "fullScreen", Texts::tr("F&ull Screen"), QKeySequence(Qt::Key_F11),
                             Texts::tr("Use the whole screen"));
    actions.fullScreen->setCheckable(true);
    menu->addSeparator();
    actions.reducedMotion = add(menu, "reducedMotion", Texts::tr("Reduced &Motion"), {},
                                Texts::tr("Change the view at once instead of gliding to it"));
    actions.reducedMotion->setCheckable(true);
    actions.languages = menu->addMenu(Texts::tr("Lan&guage"));
    actions.languages->setObjectName("menu.languages");
}

void addHelpMenu(QMainWindow& window, Actions& actions)
{
    QMenu* menu = addMenu(window, "help", Texts::tr("&Help"));
    actions.manual =
        add(menu, "manual", Texts::tr("&Manual"), {}, Texts::tr("Read how everything works, in the web browser"));
    actions.help = add(menu, "help", Texts::tr("&Help on This Control"), QKeySequence(Qt::Key_F1),
                       Texts::tr("Say what the control does that has the keys"));
    actions.whatsThis = add(menu, "whatsThis", Texts::tr("&What Is This?"), QKeySequence("Shift+F1"),
                            Texts::tr("Click on a control to read what it does"));
    menu->addSeparator();
    actions.plugins = add(menu, "plugins", Texts::tr("&Plugins…"), {}, Texts::tr("The plugins that were found"));
    actions.about = add(menu, "about", Texts::tr("&About TAn"), {}, Texts::tr("Version and licence"));
}

void addToolBar(QMainWindow& window, Actions& actions)
{
    QToolBar* bar = window.addToolBar(Texts::tr("Tools"));
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
    for (QAction* action : QList<QAction*>{actions.saveSession, actions.saveSessionAs, actions.savePicture,
                                           actions.saveMesh, actions.saveSurfaces, actions.saveStatistics,
                                           actions.addIsovalue, actions.fit, actions.resetView} +
                               actions.namedViews)
        setNeed(*action, Texts::tr("Open a model first"));
    setNeed(*actions.close, Texts::tr("There is nothing to close"));
    setNeed(*actions.undo, Texts::tr("There is nothing to undo"));
    setNeed(*actions.redo, Texts::tr("There is nothing to redo"));
}

} // namespace

Actions makeActions(QMainWindow& window, QUndoStack& undoStack)
{
    Actions actions;
    addFileMenu(window, actions);
    addEditMenu(window, undoStack, actions);
    addViewMenu(window, actions);
    actions.region = addMenu(window, "region", Texts::tr("&Region"));
    addHelpMenu(window, actions);
    addToolBar(window, actions);
    addNeeds(actions);
    return actions;
}

} // namespace tetra
