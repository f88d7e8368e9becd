// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/canvas.h"
#include "ui/window/actions.h"
#include "ui/window/docks.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>
#include <QTimer>

class QStackedWidget;

namespace tetra {

class EmptyPage;
class KeepSession;
class FilmDialog;
class SolidDialog;
class ImportDialog;
class Leaving;
class MessageBar;
class PictureDialog;
class LensTool;
class RegionActions;
class StatusLine;
class TaskLine;
class ToolDesk;
class ValuePick;
class PictureNotice;
class Viewport;

/// The program's window: puts panels, viewport and menus around the workbench.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `workbench` outlives it.
    explicit MainWindow(Workbench& workbench, BackendChoice backend = BackendChoice::Automatic);
    ~MainWindow() override;

    Viewport& viewport() noexcept { return *viewport_; }
    /// A file, or an address.
    void open(const QString& path);
    /// The program is being ended by a signal or with the user's desktop session: keeps all that it can without asking
    /// anybody.
    void keepAll();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* makeCentre();
    void restoreLayout();
    void keepLayout();
    void connectActions();
    void connectWorkbench();
    void connectMessages();
    void connectRegions();
    void connectTools();
    void connectPictures();
    void savePicture();
    void copyPicture();
    void saveFilm();
    void saveMesh();
    void savePacked();
    void showBackend();
    void saveSurfaces();
    void saveSolids();
    void saveStatistics();
    void fillRecent();
    void resetView();
    void offerBuilt(const QString& path, bool isShown, const QString& finished);
    void showFile();
    void showPart();
    void offerRest(const OpenedModel& part);
    void showWhatCanBeClosed();
    void showWhatCanBePacked();
    void showModel();
    void showScene(const BuiltScene& scene);
    void forgetFailures();
    void showNotice();
    void connectFollowing();
    void showDataset();
    void showNothing();
    void showAbout();

    Workbench& workbench_;
    Actions actions_;
    MessageBar* messages_;
    EmptyPage* empty_;
    Viewport* viewport_;
    PictureNotice* notice_ = nullptr;
    bool isBesideDataset_ = false;            ///< the model was open when the dataset was opened
    std::filesystem::path insteadOfBuilding_; ///< the model that is to be opened
    QStringList sceneFailures_;               ///< that were told and are still so
    bool isOutdated_ = false;                 ///< the picture is that of earlier settings
    ValuePick* pick_ = nullptr;
    ToolDesk* tools_ = nullptr;
    QStackedWidget* pages_;
    ImportDialog* import_ = nullptr;   ///< once a file needed it
    PictureDialog* picture_ = nullptr; ///< once it was asked for
    FilmDialog* film_ = nullptr;       ///< likewise
    SolidDialog* solids_ = nullptr;    ///< likewise
    StatusLine* status_;
    TaskLine* readingLine_ = nullptr;
    RegionActions* regions_;
    LensTool* lens_ = nullptr;
    KeepSession* keptSession_ = nullptr;
    Leaving* leaving_ = nullptr;
    bool mayClose_ = false; ///< all questions are answered
    QTimer keepingLayout_;  ///< from a change until it is kept
    Docks docks_;
};

} // namespace tetra
