// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/screenshots.h"

#include "ui/session/sample_models.h"
#include "ui/session/target_path.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/dark_palette.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QStyle>
#include <QStyleFactory>

namespace tetra {
namespace {

constexpr QSize windowSize(1366, 768);
constexpr int patience = 60'000; // milliseconds

/// Works on until `done`; false if that takes too long.
template <class Condition> bool waitFor(const Condition& done)
{
    QElapsedTimer clock;
    clock.start();
    while (!done() && clock.elapsed() < patience)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 50);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents();
    return done();
}

/// One window of one palette, and its pictures.
class Photographer {
public:
    Photographer(PluginHost& host, QDir folder, QString colours)
        : folder_(std::move(folder)), colours_(std::move(colours)), workbench_(host),
          window_(workbench_, BackendChoice::Cpu)
    {
        window_.resize(windowSize);
        window_.show();
    }

    bool takeAll()
    {
        take("start", window_);
        workbench_.openSample("c60");
        if (!waitFor([this] { return settled(); }))
            return false;
        take("window", window_);
        for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            waitFor([this] { return settled(); });
            take("panel-" + dock->objectName().section('.', 1), *dock);
        }
        takeDialog("plugins", "pluginWindow");
        takeDialog("about", "aboutBox");
        takeDialog("palette", "palette");
        workbench_.openWithOptions(pathText(sampleFolder() / "c60.nrrd"));
        if (waitFor([this] { return window_.findChild<QWidget*>("importDialog") != nullptr; }))
            take("import", *window_.findChild<QWidget*>("importDialog"));
        return isWhole_;
    }

private:
    bool settled() const
    {
        const auto* viewport = window_.findChild<Viewport*>();
        return workbench_.session().model() && !workbench_.sceneBuilder().busy() && viewport->scene() &&
               viewport->settled();
    }
    void takeDialog(const QString& action, const QString& dialog)
    {
        window_.findChild<QAction*>("action." + action)->trigger();
        QCoreApplication::processEvents();
        if (auto* widget = window_.findChild<QWidget*>(dialog)) {
            take(action, *widget);
            widget->close();
        }
    }
    void take(const QString& name, QWidget& widget)
    {
        QCoreApplication::processEvents();
        isWhole_ &= widget.grab().save(folder_.filePath(colours_ + "-" + name + ".png"));
    }

    QDir folder_;
    QString colours_;
    mutable Workbench workbench_;
    MainWindow window_;
    bool isWhole_ = true;
};

} // namespace

int makeScreenshots(PluginHost& host, const QString& folder)
{
    if (!QDir().mkpath(folder))
        return 4;
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    const QPalette light = QApplication::style()->standardPalette();
    bool isWhole = true;
    for (const bool dark : {false, true}) {
        QApplication::setPalette(dark ? darkPalette() : light);
        isWhole &= Photographer(host, QDir(folder), dark ? "dark" : "light").takeAll();
    }
    return isWhole ? 0 : 4;
}

} // namespace tetra
