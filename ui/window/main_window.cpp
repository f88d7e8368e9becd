// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "core/picture/view_picture.h"
#include "plugins/widgets/icons.h"
#include "ui/dialogs/address_dialog.h"
#include "ui/dialogs/cache_dialog.h"
#include "ui/dialogs/film_dialog.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/dialogs/plugin_window.h"
#include "ui/dialogs/solid_dialog.h"
#include "ui/opening/recent_files.h"
#include "ui/panels/animation_panel.h"
#include "ui/panels/build_panel.h"
#include "ui/panels/focus_panel.h"
#include "ui/panels/rendering_panel.h"
#include "ui/panels/statistics_panel.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/tools/tool_actions.h"
#include "ui/tools/tool_overlay.h"
#include "ui/viewport/annotation_overlay.h"
#include "ui/viewport/lens_tool.h"
#include "ui/viewport/picture_notice.h"
#include "ui/viewport/region_tools.h"
#include "ui/viewport/scene_showing.h"
#include "ui/viewport/transfer_drag.h"
#include "ui/viewport/value_pick.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/mnemonics.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/window/annotation_actions.h"
#include "ui/window/bookmark_actions.h"
#include "ui/window/empty_page.h"
#include "ui/window/help_actions.h"
#include "ui/window/keep_session.h"
#include "ui/window/leaving.h"
#include "ui/window/mode_actions.h"
#include "ui/window/orientation_actions.h"
#include "ui/window/palette_commands.h"
#include "ui/window/pick_actions.h"
#include "ui/window/picture_dialog.h"
#include "ui/window/region_actions.h"
#include "ui/window/status_line.h"
#include "ui/window/task_line.h"
#include "ui/workbench/plugin_choice.h"

#include <tan/open.h>

#include <QClipboard>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace tetra {
namespace {

constexpr QSize firstSize(1280, 800);
constexpr QSize frameOfWindows(8, 40); ///< what a window manager may add
constexpr const char* geometryKey = "window/geometry";
constexpr const char* layoutKey = "window/layout";
/// Of what saveState() writes; layouts of other versions are not restored.
constexpr int layoutVersion = 4;
constexpr int statusMessageTime = 5000; // milliseconds
constexpr int hintTime = 10'000;        // likewise
constexpr int keepLayoutAfter = 300;    // likewise

/// The local files of a drag, and addresses on servers: a browser gives these as URLs or as text.
QStringList filesOf(const QMimeData* data)
{
    QStringList files;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile())
            files.append(url.toLocalFile());
        else if (const QString address = url.toString(QUrl::FullyEncoded); isAddress(address.toStdString()))
            files.append(address);
    if (const QString text = data->text().trimmed(); files.isEmpty() && isAddress(text.toStdString()))
        files.append(text);
    return files;
}

/// A right click in the picture picks the value there and opens menu.picture: what can be made of the value, where to
/// look from, and what becomes of the picture. The actions are those of the window's menus.
void givePictureMenu(Viewport& viewport, ValuePick& pick, const Actions& actions)
{
    auto* menu = new QMenu(&viewport);
    menu->setObjectName("menu.picture");
    for (QAction* action : actions.picked->actions())
        if (action->objectName() != "action.pickValue") // the click has done that
            menu->addAction(action);
    menu->addSeparator();
    menu->addAction(actions.fit);
    menu->addMenu(actions.lookFrom);
    menu->addSeparator();
    menu->addActions({actions.copyPicture, actions.savePicture});
    viewport.setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(&viewport, &QWidget::customContextMenuRequested, menu,
                     [&viewport, &pick, menu](const QPoint& place) {
                         if (!viewport.scene())
                             return;
                         pick.pickAt(place);
                         menu->popup(viewport.mapToGlobal(place));
                     });
}

} // namespace

MainWindow::MainWindow(Workbench& workbench, BackendChoice backend)
    : workbench_(workbench), actions_(makeActions(*this, workbench_.session().undoStack())), messages_(new MessageBar),
      empty_(new EmptyPage(workbench_.opening().samples().making())),
      viewport_(new Viewport(workbench.session(), backend)), pages_(new QStackedWidget),
      status_(new StatusLine(statusBar())),
      regions_(new RegionActions(workbench_.session(), *viewport_, *actions_.region, *actions_.toolBar))
{
    setObjectName("window");
    setAcceptDrops(true);
    new WheelGuard(*viewport_, this);
    resize(firstSize.boundedTo(screen()->availableSize() - frameOfWindows));
    setCentralWidget(makeCentre());
    docks_ = makeDocks(*this, *actions_.panels, workbench_, *viewport_, *pick_, *tools_);
    layOutDocks(*this, docks_, workbench_.opening().datasets().dataset() != nullptr);
    connectActions();
    connectRegions();
    connectTools();
    connectWorkbench();
    connectMessages();
    connectFollowing();
    connectHelp(*this, actions_, workbench_, *messages_);
    showBackend();
    showModel();
    restoreLayout();
}

MainWindow::~MainWindow()
{
    workbench_.host().whenFailing({});
    workbench_.opening().reading().setGate({});
    keptSession_->leave();
    // A drag that is still under way ends when its panel is destroyed, and then this is no longer a MainWindow.
    Opening& opening = workbench_.opening();
    for (const QObject* source : std::initializer_list<const QObject*>{
             &workbench_, &workbench_.session(), &opening.reading(), &opening.models(), &opening.datasets(),
             &opening.samples(), &opening.sessionFile(), &workbench_.building(), &workbench_.exporting(),
             &workbench_.scenes()})
        source->disconnect(this);
}

QWidget* MainWindow::makeCentre()
{
    viewport_->setObjectName("viewport");
    viewport_->setAccessibleName(tr("Picture"));
    lens_ = new LensTool(workbench_, *viewport_);  // gets the events after all others
    new AnnotationOverlay(workbench_, *viewport_); // below the tools
    pick_ = new ValuePick(workbench_, *viewport_);
    new TransferDrag(workbench_, *viewport_);
    new RegionTools(workbench_.session(), *viewport_); // the last one comes first: its handles go before
    tools_ = new ToolDesk(workbench_, *viewport_, viewport_);
    new ToolOverlay(*tools_, workbench_, *viewport_);
    notice_ = new PictureNotice(*viewport_);
    pages_->setObjectName("pages");
    pages_->addWidget(empty_);
    pages_->addWidget(viewport_);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins({});
    layout->setSpacing(0);
    layout->addWidget(messages_);
    layout->addWidget(pages_, 1);
    return centre;
}

void MainWindow::restoreLayout()
{
    const QSettings settings;
    restoreGeometry(settings.value(geometryKey).toByteArray());
    restoreState(settings.value(layoutKey).toByteArray(), layoutVersion);
    docks_.build->hide(); // comes with a dataset
    keepingLayout_.setSingleShot(true);
    keepingLayout_.setInterval(keepLayoutAfter);
    connect(&keepingLayout_, &QTimer::timeout, this, &MainWindow::keepLayout);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    // What was set aside for the end of the desktop's session is offered the next time, so that nobody is asked then.
    if (!std::exchange(mayClose_, false) && !keptSession_->hasEnded() && !leaving_->isFree(LeavingWay::Quit)) {
        event->ignore();
        return leaving_->ask(LeavingWay::Quit, [this] {
            mayClose_ = true;
            close();
        });
    }
    keepLayout();
    keptSession_->leave();
    event->accept();
}

void MainWindow::keepLayout()
{
    keepingLayout_.stop();
    QSettings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(layoutKey, saveState(layoutVersion));
}

void MainWindow::keepAll()
{
    keepLayout();
    keptSession_->end();
}

/// A window that is maximised, moved or made larger is so the next time, however the program ends.
void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange)
        keepingLayout_.start();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    keepingLayout_.start();
}

void MainWindow::moveEvent(QMoveEvent* event)
{
    QMainWindow::moveEvent(event);
    keepingLayout_.start();
}

void MainWindow::open(const QString& path)
{
    const QUrl address(path); // desktops name a file that a user has chosen as file:///...
    workbench_.opening().open(address.isLocalFile() ? address.toLocalFile() : path);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!filesOf(event->mimeData()).isEmpty())
        event->acceptProposedAction();
    empty_->setDropping(event->isAccepted());
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*)
{
    empty_->setDropping(false);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    empty_->setDropping(false);
    const QStringList files = filesOf(event->mimeData());
    event->acceptProposedAction();
    open(files.first());
    if (files.size() > 1)
        messages_->add(
            tr("Only one file can be open at a time; of the files dropped, %1 was opened.").arg(files.first()));
}

void MainWindow::connectActions()
{
    connect(actions_.open, &QAction::triggered, this, [this] {
        askForFile(this, "openDialog", workbench_.opening().nameFilters(), [this](const QString& path) { open(path); });
    });
    connect(actions_.openWithOptions, &QAction::triggered, this, [this] {
        askForFile(this, "importFileDialog", workbench_.opening().nameFilters(),
                   [this](const QString& path) { workbench_.opening().openWithOptions(path); });
    });
    connect(actions_.openAddress, &QAction::triggered, this, [this] {
        auto* dialog = new AddressDialog(
            "addressDialog", [this](const QString& place) { return workbench_.opening().models().tokens().of(place); },
            this);
        connect(dialog, &AddressDialog::chosen, this, [this](const QString& place, const QString& token) {
            if (!token.isEmpty())
                workbench_.opening().models().tokens().set(place, token);
            open(place);
        });
        dialog->open();
    });
    connect(actions_.modelCache, &QAction::triggered, this, [this] {
        auto* dialog = new CacheDialog(this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    connect(actions_.recent, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
    keptSession_ = new KeepSession(workbench_, *viewport_, *messages_, empty_->lost(), this);
    leaving_ = new Leaving(workbench_, *keptSession_, this);
    connect(docks_.buildPanel, &BuildPanel::keepWanted, leaving_, &Leaving::keepBuild);
    connect(docks_.buildPanel, &BuildPanel::openWanted, this, [this](const QString& path) {
        insteadOfBuilding_ = filePath(path);
        open(path);
    });
    connect(actions_.saveSession, &QAction::triggered, keptSession_, [this] { keptSession_->save(); });
    connect(actions_.saveSessionAs, &QAction::triggered, keptSession_, [this] { keptSession_->saveAs(); });
    connect(actions_.applyLook, &QAction::triggered, this, [this] {
        askForTextFile(this, "lookDialog", tr("Apply Look From"),
                       tr("Sessions, and pictures saved by TAn (*.tansession *.png)"),
                       [this](const QString& path) { workbench_.opening().sessions().applyLook(filePath(path)); });
    });
    connectPictures();
    connect(actions_.saveMesh, &QAction::triggered, this, &MainWindow::saveMesh);
    connect(actions_.saveSurfaces, &QAction::triggered, this, &MainWindow::saveSurfaces);
    connect(actions_.saveSolids, &QAction::triggered, this, &MainWindow::saveSolids);
    connect(actions_.saveStatistics, &QAction::triggered, this, &MainWindow::saveStatistics);
    connect(actions_.savePacked, &QAction::triggered, this, &MainWindow::savePacked);
    connect(docks_.statisticsPanel, &StatisticsPanel::saveWanted, actions_.saveStatistics, &QAction::trigger);
    connect(actions_.close, &QAction::triggered, this, [this] {
        leaving_->ask(LeavingWay::Close, [this] {
            messages_->markOld();
            workbench_.opening().close();
        });
    });
    connect(actions_.quit, &QAction::triggered, this, &QWidget::close);
    connect(actions_.addIsovalue, &QAction::triggered, this, [this] { workbench_.session().addIsovalue(); });
    connect(actions_.fit, &QAction::triggered, &workbench_.session(), &Session::fitCamera);
    connect(actions_.fitWhole, &QAction::triggered, &workbench_.session(), &Session::fitCameraToWhole);
    connect(actions_.resetView, &QAction::triggered, this, &MainWindow::resetView);
    Session& session = workbench_.session();
    connect(actions_.perspective, &QAction::toggled, &session, [&session](bool on) {
        Camera camera = session.view().camera;
        camera.perspective = on;
        session.setCamera(camera);
    });
    for (int view = 0; view < actions_.namedViews.size(); ++view)
        connect(actions_.namedViews[view], &QAction::triggered, &session,
                [&session, view] { session.setCamera(seenFrom(session.view().camera, static_cast<NamedView>(view))); });
    connect(actions_.resetLayout, &QAction::triggered, this,
            [this] { layOutDocks(*this, docks_, workbench_.opening().datasets().dataset() != nullptr); });
    new OrientationActions(session, *actions_.orientation);
    auto* bookmarks = new BookmarkActions(session, *actions_.bookmarks, *this);
    connect(bookmarks, &BookmarkActions::added, this, [this](const QString& name) {
        statusBar()->showMessage(tr("Added bookmark %1").arg(name), statusMessageTime);
    });
    auto* modes = new ModeActions(workbench_, *actions_.modes, *actions_.toolBar, this);
    connect(modes, &ModeActions::chosen, docks_.renderingPanel, &RenderingPanel::chooseMode);
    new AnnotationActions(workbench_.session(), *actions_.annotations, this);
    new PickActions(workbench_, *pick_, *actions_.picked);
    givePictureMenu(*viewport_, *pick_, actions_);
    connect(pick_, &ValuePick::pickedChanged, status_, [this] { status_->setPicked(pick_->text()); });
    const auto showPerspective = [this] { actions_.perspective->setChecked(viewport_->camera().perspective); };
    connect(&session, &Session::modelChanged, actions_.perspective, showPerspective);
    session.whenChanged(ViewPart::Camera, actions_.perspective, showPerspective);
    connect(actions_.fullScreen, &QAction::toggled, this,
            [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
    connect(actions_.plugins, &QAction::triggered, this, [this] {
        auto* window = new PluginWindow(workbench_.host(), this);
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->show();
    });
    connect(actions_.about, &QAction::triggered, this, &MainWindow::showAbout);
    connect(empty_, &EmptyPage::openClicked, actions_.open, &QAction::trigger);
    connect(empty_, &EmptyPage::recentClicked, this, &MainWindow::open);
    connect(empty_, &EmptyPage::sampleClicked, &workbench_,
            [this](const QString& name) { workbench_.opening().samples().open(name.toStdString()); });
    connect(actions_.samples, &QMenu::triggered, this, [this](const QAction* sample) {
        workbench_.opening().samples().open(sample->data().toString().toStdString());
    });
    connect(empty_, &EmptyPage::samplesShown, &workbench_.opening().samples(), &Samples::drawThumbnails);
    connect(actions_.samples, &QMenu::aboutToShow, &workbench_.opening().samples(), &Samples::drawThumbnails);
    connect(&workbench_.opening().samples(), &Samples::thumbnailDrawn, this,
            [this](const std::string& sample, const QImage& picture) {
                empty_->setThumbnail(sample, picture);
                if (auto* action = findChild<QAction*>("action.sample." + QString::fromStdString(sample)))
                    action->setIcon(QIcon(QPixmap::fromImage(picture)));
            });
    connect(&workbench_.opening().samples().making(), &LongTask::started, actions_.samples,
            [this] { actions_.samples->setEnabled(false); });
    connect(&workbench_.opening().samples().making(), &LongTask::finished, actions_.samples,
            [this] { actions_.samples->setEnabled(true); });
}

void MainWindow::connectRegions()
{
    const auto raise = [](QDockWidget* dock) { return [dock] { raiseDock(*dock); }; };
    connect(docks_.focusPanel, &FocusPanel::centreWanted, regions_, &RegionActions::focusToView);
    connect(regions_, &RegionActions::focusSwitchedOn, docks_.focus, raise(docks_.focus));
    connect(regions_, &RegionActions::windowSwitchedOn, docks_.region, raise(docks_.region));
    connect(regions_, &RegionActions::lensSwitchedOn, docks_.focus, raise(docks_.focus));
    connect(lens_, &LensTool::failed, messages_, [this](const QString& text) { messages_->add(text); });
    const auto takeKeys = [this] { viewport_->setFocus(); };
    connect(regions_, &RegionActions::lensSwitchedOn, viewport_, takeKeys);
    connect(regions_, &RegionActions::focusSwitchedOn, viewport_, takeKeys);
    connect(regions_, &RegionActions::windowSwitchedOn, viewport_, takeKeys);
}

void MainWindow::connectTools()
{
    auto* actions = new ToolActions(*tools_, workbench_, *actions_.tools, *actions_.toolBar);
    for (QAction* action : actions->actions())
        setNeed(*action, tr("Open a model first"));
    actions_.tools->menuAction()->setVisible(!actions->actions().empty());
    connect(actions, &ToolActions::switchedOn, docks_.tools, [this] { raiseDock(*docks_.tools); });
    connect(actions, &ToolActions::switchedOn, viewport_, [this] { viewport_->setFocus(); });
    connect(tools_, &ToolDesk::chosenChanged, pick_, [this] { pick_->setClickable(tools_->chosen().empty()); });
}

void MainWindow::connectWorkbench()
{
    showScenes(workbench_.session(), workbench_.scenes(), *viewport_); // before what follows a picture
    connect(&workbench_.opening().datasets(), &DatasetOpening::datasetOpened, this, &MainWindow::showDataset);
    connect(&workbench_.opening().datasets(), &DatasetOpening::datasetClosed, this, &MainWindow::showDataset);
    connect(&workbench_.opening().datasets(), &DatasetOpening::choicesNeeded, this,
            [this](const ImportQuestion& question) {
                if (import_ == nullptr)
                    import_ = new ImportDialog(workbench_, this);
                import_->ask(question);
            });
    connect(&workbench_.building(), &Building::modelBuilt, this, &MainWindow::offerBuilt);
    const auto tellSaved = [this](const QString& path) {
        statusBar()->showMessage(tr("Saved %1").arg(path), statusMessageTime);
    };
    connect(&workbench_.exporting(), &Exporting::pictureSaved, this, tellSaved);
    connect(&workbench_.exporting(), &Exporting::filmSaved, this, tellSaved);
    connect(&workbench_.exporting(), &Exporting::meshSaved, this,
            [this, tellSaved](const QString& path, const QStringList& remarks) {
                tellSaved(path);
                for (const QString& remark : remarks)
                    messages_->tell(remark, MessageSubject::Program);
            });
    connect(&workbench_.exporting(), &Exporting::solidsSaved, this, [this](const QString& path, const QString& report) {
        messages_->tell(tr("Saved %1. %2").arg(path, report), MessageSubject::Program);
    });
    connect(&workbench_.exporting(), &Exporting::textSaved, this, tellSaved);
    connect(&workbench_.opening().sessionFile(), &SessionFile::saved, this, tellSaved);
    connect(&workbench_.exporting(), &Exporting::packedSaved, this,
            [this](const QString& path, quint64 bytes, quint64 unpackedBytes) {
                statusBar()->showMessage(
                    tr("Saved %1: %2 instead of %3").arg(path, sizeText(bytes), sizeText(unpackedBytes)),
                    statusMessageTime);
            });
    readingLine_ = new TaskLine("status.reading", tr("Reading"), workbench_.opening().reading().task());
    statusBar()->addPermanentWidget(readingLine_);
    connect(&workbench_.opening().reading(), &Reading::aboutToRead, this,
            [this] { readingLine_->setActivity(tr("Reading")); });
    connect(&workbench_.opening().models(), &ModelOpening::shownPartChanged, this, &MainWindow::showPart);
    connect(&workbench_.opening().models(), &ModelOpening::partRead, this, &MainWindow::offerRest);
    connect(&workbench_.opening().models(), &ModelOpening::tokenWanted, this,
            [this](const QString& place, const std::function<void()>& again) {
                askForToken(this, "tokenDialog", place, [this, place, again](const QString& token) {
                    workbench_.opening().models().tokens().set(place, token);
                    again();
                });
            });
    statusBar()->addPermanentWidget(
        new TaskLine("status.sampling", tr("Making the sample"), workbench_.opening().samples().making()));
    statusBar()->addPermanentWidget(new TaskLine("status.saving", tr("Saving"), workbench_.exporting().savingMesh()));
    statusBar()->addPermanentWidget(
        new TaskLine("status.packing", tr("Packing"), workbench_.exporting().savingPacked()));
    connect(&workbench_.opening().models(), &ModelOpening::shownPartChanged, this, &MainWindow::showWhatCanBePacked);
    connect(&workbench_.session(), &Session::modelChanged, this, &MainWindow::showModel);
    connect(&workbench_.session(), &Session::modelGrown, this, &MainWindow::showFile);
    connect(&workbench_.session(), &Session::modelGrown, this, &MainWindow::showWhatCanBePacked);
    connect(&workbench_.opening().sessionFile(), &SessionFile::changed, this, &MainWindow::showFile);
    connect(&workbench_.session().undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::showFile);
    connect(&workbench_.building().task(), &LongTask::started, this, &MainWindow::showWhatCanBeClosed);
    connect(&workbench_.building(), &Building::buildEnded, this, &MainWindow::showWhatCanBeClosed);
    workbench_.opening().reading().setGate([this](bool isModel, const auto& go, const auto& stay) {
        leaving_->ask(isModel ? LeavingWay::OpenModel : LeavingWay::OpenDataset, go, stay);
    });
    SceneBuilder& scenes = workbench_.scenes().sceneBuilder();
    connect(&scenes, &SceneBuilder::sceneReady, this, &MainWindow::showScene);
    connect(&workbench_.session(), &Session::shownChanged, this, [this] {
        if (const Session& session = workbench_.session(); session.shown() && session.model())
            status_->setErrors(*session.shown(), *session.model());
    });
    connect(&scenes, &SceneBuilder::failed, this, [this](const Error& error) {
        sceneFailures_.append(translatedMessage(error.message));
        isOutdated_ = viewport_->scene() != nullptr;
        showNotice();
    });
    connect(&scenes, &SceneBuilder::busyChanged, status_, &StatusLine::setBusy);
    connect(viewport_, &Viewport::framePainted, this, [this](const FrameReport& report) {
        showBackend();
        if (viewport_->scene())
            status_->setFrame(report);
    });
    connect(viewport_, &Viewport::failed, this, [this](const QString& text) {
        messages_->add(text);
        showBackend();
    });
}

/// What is said of a file goes when another one is open; what is not saved, or is about the program, stays.
void MainWindow::connectMessages()
{
    connect(&workbench_, &Workbench::failed, messages_, [this](const QString& text) { messages_->add(text); });
    connect(&workbench_, &Workbench::saveFailed, messages_,
            [this](const QString& text) { messages_->add(text, MessageSubject::Program); });
    connect(&workbench_.opening().reading(), &Reading::aboutToRead, messages_, &MessageBar::markOld);
    connect(&workbench_.opening().datasets(), &DatasetOpening::datasetOpened, messages_, &MessageBar::clearOld);
    connect(&workbench_.session(), &Session::modelChanged, messages_, &MessageBar::clearOld);
    for (const QString& error : pluginErrors(workbench_.host()))
        messages_->add(error, MessageSubject::Program);
    if (const Status complete = workbench_.host().complete(); !complete)
        messages_->add(translatedMessage(complete.error().message), MessageSubject::Program);
    workbench_.host().whenFailing([messages = messages_](const Error& error) {
        QMetaObject::invokeMethod(
            messages,
            [messages, text = error.message] { messages->add(translatedMessage(text), MessageSubject::Program); },
            Qt::QueuedConnection);
    });
}

void MainWindow::showBackend()
{
    status_->setBackend(viewport_->backendName());
}

void MainWindow::connectPictures()
{
    connect(actions_.savePicture, &QAction::triggered, this, &MainWindow::savePicture);
    connect(actions_.copyPicture, &QAction::triggered, this, &MainWindow::copyPicture);
    connect(actions_.saveFilm, &QAction::triggered, this, &MainWindow::saveFilm);
    connect(docks_.animationPanel, &AnimationPanel::filmWanted, this, &MainWindow::saveFilm);
    auto* pictureLine =
        new TaskLine("status.picture", tr("Drawing the picture"), workbench_.exporting().savingPicture());
    statusBar()->addPermanentWidget(pictureLine);
    statusBar()->addPermanentWidget(
        new TaskLine("status.film", tr("Drawing the film"), workbench_.exporting().savingFilm()));
    connect(&workbench_.exporting().savingPicture(), &LongTask::waitingChanged, pictureLine, [this, pictureLine] {
        const int waiting = workbench_.exporting().savingPicture().waiting();
        pictureLine->setActivity(waiting == 0 ? tr("Drawing the picture")
                                              : tr("Drawing the picture, %1 more waiting").arg(waiting));
    });
    connect(&workbench_.exporting(), &Exporting::pictureDrawn, this, [this](const QImage& picture) {
        QGuiApplication::clipboard()->setImage(picture);
        statusBar()->showMessage(tr("Picture copied, %1 × %2 pixels").arg(picture.width()).arg(picture.height()),
                                 statusMessageTime);
    });
}

void MainWindow::savePicture()
{
    if (picture_ == nullptr)
        picture_ = new PictureDialog(workbench_, *viewport_, *keptSession_, this);
    picture_->ask();
}

void MainWindow::copyPicture()
{
    if (workbench_.session().model())
        workbench_.exporting().savePicture(pictureOrder(
            workbench_, *viewport_, {pixelsOf(*viewport_), 0, false, workbench_.session().view().annotations}));
}

void MainWindow::saveFilm()
{
    if (film_ == nullptr)
        film_ = new FilmDialog(workbench_, *viewport_, this);
    film_->ask();
}

void MainWindow::saveMesh()
{
    askForTargetFile(this, "meshDialog", tr("Save Mesh"), fileFilters(workbench_.host(), WrittenContent::Mesh),
                     workbench_.opening().proposedPath(".vtu"),
                     [this](const QString& path) { workbench_.exporting().saveMesh(filePath(path)); });
}

void MainWindow::saveSurfaces()
{
    askForTargetFile(this, "surfaceDialog", tr("Save Surfaces"),
                     fileFilters(workbench_.host(), WrittenContent::Surface), workbench_.opening().proposedPath(".stl"),
                     [this](const QString& path) { workbench_.exporting().saveSurfaces(filePath(path)); });
}

void MainWindow::saveSolids()
{
    if (solids_ == nullptr) {
        solids_ = new SolidDialog(this);
        connect(solids_, &QDialog::accepted, this, [this] {
            askForTargetFile(
                this, "solidDialog", tr("Save Solids"), fileFilters(workbench_.host(), WrittenContent::Surface),
                workbench_.opening().proposedPath(".stl"), [this](const QString& path) {
                    workbench_.exporting().saveSolids(filePath(path), solids_->making(), solids_->measuresDeviation());
                });
        });
    }
    solids_->open();
}

void MainWindow::saveStatistics()
{
    askForStatisticsFile(this, "statisticsDialog", workbench_.opening().proposedPath(".csv"),
                         [this](const QString& path) { workbench_.exporting().saveStatistics(filePath(path)); });
}

void MainWindow::savePacked()
{
    askForTargetFile(this, "packedDialog", tr("Save Packed Model"), {tr("Packed models (*.tan)")},
                     workbench_.opening().proposedPath(".packed.tan"),
                     [this](const QString& path) { workbench_.exporting().savePacked(filePath(path)); });
}

void MainWindow::fillRecent()
{
    actions_.recent->clear();
    for (const QString& path : recentFiles()) {
        const QString shown = shownPlace(filePath(path));
        QAction* action = actions_.recent->addAction(shownName(filePath(path)).replace('&', "&&"));
        action->setObjectName(QString("action.recent.%1").arg(actions_.recent->actions().size() - 1));
        action->setToolTip(shown);
        connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
    actions_.recent->addSeparator();
    QAction* forget = actions_.recent->addAction(tr("&Clear List"));
    forget->setObjectName("action.clearRecent");
    forget->setEnabled(actions_.recent->actions().size() > 2);
    giveMnemonics(*actions_.recent);
    connect(forget, &QAction::triggered, this, [] { forgetRecentFiles(); });
}

void MainWindow::resetView()
{
    ViewValue view = workbench_.scenes().startingView();
    view.bookmarks = workbench_.session().view().bookmarks;
    workbench_.session().setView(std::move(view), tr("Reset View"));
}

/// Where the user has turned to something else the model does not push that away.
void MainWindow::offerBuilt(const QString& path, bool isShown, const QString& finished)
{
    if (isShown && workbench_.opening().datasets().isBuilt())
        docks_.build->hide();
    isBesideDataset_ = isBesideDataset_ && !workbench_.opening().datasets().isBuilt();
    showNotice();
    const QString name = shownName(filePath(path));
    const QString text = finished.isEmpty() ? tr("The model %1 has been built.").arg(name)
                                            : tr("What was finished has been kept as %1. The model %2 is unchanged.")
                                                  .arg(name, shownName(filePath(finished)));
    if (!isShown)
        messages_->ask(
            text, tr("&Open"), [this, path] { open(path); }, [] {}, MessageSubject::Program);
    else if (!finished.isEmpty())
        messages_->tell(text, MessageSubject::Program);
}

void MainWindow::showFile()
{
    const auto& model = workbench_.session().model();
    const QString place = model ? shownPlace(model->path()) : QString();
    const QFileInfo file(place);
    const std::filesystem::path& session = workbench_.opening().sessionFile().path();
    const QString name = session.empty() ? file.fileName() : shownText(session.filename().string());
    const bool isRemote = model && isAddress(model->path().string());
    status_->setFile(model ? shownName(model->path()) : QString(), isRemote ? place : file.absoluteFilePath(),
                     model && model->elsewhere() != nullptr);
    setWindowTitle(model ? tr("%1[*] – TAn").arg(name) : tr("TAn"));
    setWindowModified(workbench_.opening().sessionFile().isModified());
}

/// How much there is of what is shown, and that more is coming.
void MainWindow::showPart()
{
    const auto& model = workbench_.session().model();
    if (!model || !workbench_.opening().models().isComing())
        return readingLine_->setActivity(tr("Reading"));
    const std::uint32_t all = workbench_.opening().models().sitesOfWhole();
    const double share = all > 0 ? 100.0 * model->siteCount() / all : 0;
    readingLine_->setActivity(tr("%1 % shown, more is on the way").arg(static_cast<int>(share)),
                              tr("Showing %L1 of %L2 vertices, more are on the way").arg(model->siteCount()).arg(all));
}

/// Of a model on a server, of which so much was fetched that it takes no more than a moment.
void MainWindow::offerRest(const OpenedModel& part)
{
    messages_->ask(
        tr("%1 is shown with %L2 of its %L3 vertices: %4 of %5 were downloaded.")
            .arg(shownName(part.model->path()))
            .arg(part.model->siteCount())
            .arg(part.sitesOfWhole)
            .arg(sizeText(part.bytesRead), sizeText(part.bytesOfWhole)),
        tr("&Fetch All"), [this] { workbench_.opening().models().readWhole(); }, [] {});
}

void MainWindow::showWhatCanBePacked()
{
    actions_.savePacked->setEnabled(workbench_.opening().models().showsWhole());
}

void MainWindow::showWhatCanBeClosed()
{
    actions_.close->setEnabled(workbench_.opening().hasSomethingOpen());
    if (!workbench_.session().model())
        showNothing();
}

void MainWindow::showModel()
{
    const auto& model = workbench_.session().model();
    showFile();
    for (QAction* action :
         QList<QAction*>{actions_.saveSession, actions_.saveSessionAs, actions_.applyLook, actions_.savePicture,
                         actions_.copyPicture, actions_.saveFilm, actions_.saveMesh, actions_.saveSurfaces,
                         actions_.saveSolids, actions_.saveStatistics, actions_.addIsovalue, actions_.fit,
                         actions_.fitWhole, actions_.resetView} +
             actions_.namedViews)
        action->setEnabled(model != nullptr);
    showWhatCanBePacked();
    status_->clearScene();
    isOutdated_ = false;
    isBesideDataset_ = false;
    showNotice();
    if (model) {
        pages_->setCurrentWidget(viewport_);
        viewport_->setFocus();
        if (model->path() == insteadOfBuilding_)
            docks_.build->hide();
        const ModelDescription& data = model->description();
        if (data.domain == DomainClass::RegularLattice && data.space.empty() && workbench_.session().isFirstLook())
            statusBar()->showMessage(tr("The file does not say which way is up; Ctrl+U turns the model upside down"),
                                     hintTime);
    }
    insteadOfBuilding_.clear();
    showWhatCanBeClosed();
}

void MainWindow::showScene(const BuiltScene& scene)
{
    status_->setScene(scene);
    status_->setRemarks(workbench_.scenes().errorRemarks(scene), scene.model->description());
    isOutdated_ = false;
    forgetFailures();
    showNotice();
}

/// There is a picture again: a server that was lost answers, say. Damage of the model's file remains.
void MainWindow::forgetFailures()
{
    const auto& model = workbench_.session().model();
    if (model && model->foundDamage())
        for (const QString& text : std::as_const(sceneFailures_))
            messages_->remove(text);
    sceneFailures_.clear();
}

/// Says what the picture is not.
void MainWindow::showNotice()
{
    const auto& model = workbench_.session().model();
    const auto& dataset = workbench_.opening().datasets().dataset();
    if (model && dataset && isBesideDataset_)
        notice_->tell(tr("%1 has not been built yet. The picture still shows %2.")
                          .arg(shownText(dataset->source.name), shownName(model->path())));
    else
        notice_->tell(isOutdated_ ? tr("The picture does not show the current settings, which could not be drawn.")
                                  : QString());
}

/// While a control is dragged pictures follow quickly.
void MainWindow::connectFollowing()
{
    Session& session = workbench_.session();
    const auto follow = [this] { viewport_->setFollowing(workbench_.session().inGesture()); };
    session.whenChanged(ViewPart::Scene, this, follow);
    session.whenChanged(ViewPart::Appearance | ViewPart::Isovalues, viewport_, &Viewport::expectChange);
    const auto followLight = [this] {
        const Renderer* const mode = workbench_.scenes().renderer();
        const ParameterValues& settings = workbench_.session().view().appearance.settings;
        viewport_->setDarkGround(mode != nullptr && hasDarkGround(*mode, settings));
    };
    session.whenChanged(ViewPart::Appearance, viewport_, followLight);
    connect(&session, &Session::modelChanged, viewport_, followLight);
    connect(&session, &Session::gestureChanged, this, [this](bool on) {
        if (!on)
            viewport_->setFollowing(false);
    });
}

void MainWindow::showDataset()
{
    isBesideDataset_ =
        workbench_.opening().datasets().dataset() != nullptr && !workbench_.opening().datasets().isBuilt();
    showNotice();
    docks_.build->setVisible(workbench_.opening().datasets().dataset() != nullptr);
    if (workbench_.opening().datasets().dataset()) {
        docks_.build->raise();
        docks_.build->widget()->setFocus();
    }
    showWhatCanBeClosed();
}

void MainWindow::showNothing()
{
    pages_->setCurrentWidget(empty_);
    const auto& dataset = workbench_.opening().datasets().dataset();
    if (!dataset)
        return empty_->invite(recentFiles());
    docks_.build->show(); // it was away while the model was seen
    if (workbench_.building().running())
        empty_->tell(workbench_.building().buildName(),
                     tr("Its model is being built. The panel on the left shows the progress."));
    else
        empty_->tell(shownText(dataset->source.name),
                     tr("Dataset loaded. Choose options on the left and press Build to view it."));
}

void MainWindow::showAbout()
{
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About TAn"),
                                tr("<h3>TAn %1</h3><p>Tetrahedra Analyzer: multiresolution volume data with a known "
                                   "error.</p><p>Free software under the GNU General Public License, version 3 or "
                                   "later.</p>")
                                    .arg(QCoreApplication::applicationVersion()),
                                QMessageBox::Close, this);
    box->setObjectName("aboutBox");
    box->setTextFormat(Qt::RichText);
    box->setIconPixmap(programIcon().pixmap(64));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace tetra
