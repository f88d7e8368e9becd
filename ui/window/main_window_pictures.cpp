// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and films of what the window shows.
#include "ui/panels/animation_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/film_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/picture_dialog.h"
#include "ui/window/picture_orders.h"
#include "ui/window/task_line.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QStatusBar>

namespace tetra {
namespace {

constexpr int pictureMessageTime = 5000; // milliseconds

} // namespace

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
                                 pictureMessageTime);
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

} // namespace tetra
