// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/desktop.h"

#include "core/base/file_writer.h"
#include "plugins/widgets/icons.h"
#include "ui/session/language.h"
#include "ui/widgets/legible_style.h"
#include "ui/widgets/plain_texts.h"
#include "ui/window/main_window.h"
#include "ui/work/end_signals.h"
#include "ui/work/steady_heap.h"
#include "ui/workbench/plugin_choice.h"

#include <tan/version.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QProcess>
#include <QTranslator>

#include <algorithm>
#include <clocale>
#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace tetra {
namespace {

class Desktop {
    Q_DECLARE_TR_FUNCTIONS(Desktop)
};

void loadTranslations(QApplication& application, QTranslator& ours, QTranslator& ofQt)
{
    const QLocale locale = textLocale();
    if (ofQt.load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&ofQt);
    if (ours.load(locale, "tan", "_", ":/i18n"))
        application.installTranslator(&ours);
}

std::optional<BackendChoice> backendNamed(const QString& name)
{
    static const std::map<QString, BackendChoice> names{
        {"auto", BackendChoice::Automatic}, {"cpu", BackendChoice::Cpu}, {"gl", BackendChoice::Gl}};
    const auto found = names.find(name);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

/// Whether a window can come up: there is a display, or the user names what Qt draws to. Qt ends a program without one
/// by an abort.
bool hasDisplay([[maybe_unused]] std::span<char*> arguments)
{
#ifdef Q_OS_LINUX
    const auto isSet = [](const char* variable) { return !qEnvironmentVariableIsEmpty(variable); };
    const auto namesPlatform = [](std::string_view argument) {
        return argument == "-platform" || argument == "--platform";
    };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY") || isSet("QT_QPA_PLATFORM") ||
           std::ranges::any_of(arguments, namesPlatform);
#else
    return true;
#endif
}

int refuseWithoutDisplay()
{
    const QString text =
        Desktop::tr("There is no display for the window: neither DISPLAY nor WAYLAND_DISPLAY is set. “tan render” "
                    "draws pictures into files instead; “tan --help” lists what else works without a window.");
    fputs(qPrintable(text + '\n'), stderr);
    return 4;
}

} // namespace

int runDesktop(int argc, char** argv)
{
    reportFailedWrites();
    keepHeapSteady();
    const bool isShown = hasDisplay({argv, static_cast<std::size_t>(argc)});
    if (!isShown)
        qputenv("QT_QPA_PLATFORM", "offscreen"); // enough for the help, and for saying so
    QApplication application(argc, argv);
    // QApplication takes over the user's locale; libraries that read or write numbers must not see its decimal comma.
    std::setlocale(LC_NUMERIC, "C");
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("TAn");
    QCoreApplication::setApplicationVersion(TAN_VERSION);
    QGuiApplication::setDesktopFileName("org.tan.tan"); // how Wayland finds the icon
    QApplication::setWindowIcon(programIcon());
    useLegibleStyle();
    showTextsPlainly(application);
    QTranslator ours;
    QTranslator ofQt;
    loadTranslations(application, ours, ofQt);

    QCommandLineParser parser;
    parser.setApplicationDescription(Desktop::tr("Shows volume data at any accuracy."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOption({"backend", Desktop::tr("Rendering back end: auto, cpu or gl."), "name", "auto"});
    parser.addPositionalArgument(
        "file", Desktop::tr("A dataset, a .tan model or a session to open; each opens in its own window."),
        "[file...]");
    parser.process(application);
    const auto backend = backendNamed(parser.value("backend"));
    if (!backend) {
        fputs(qPrintable(parser.helpText()), stderr);
        return 2;
    }

    const std::unique_ptr<PluginHost> host = wantedPlugins();
    const auto ofPlugins = pluginTranslators(*host, textLocale());
    installBehind(ofPlugins, ours);
    if (!isShown)
        return refuseWithoutDisplay();
    Workbench workbench(*host);
    MainWindow window(workbench, *backend);
    const QStringList files = parser.positionalArguments();
    if (!files.isEmpty())
        window.open(files[0]); // before the start page is seen, whose pictures wait while a file is read
    for (const QString& file : files.mid(1))
        QProcess::startDetached(QCoreApplication::applicationFilePath(),
                                {"--backend", parser.value("backend"), "--", file});
    EndSignals endSignals;
    QObject::connect(&endSignals, &EndSignals::endWanted, &window, [&window] {
        window.keepAll();
        QCoreApplication::exit();
    });
    QObject::connect(&application, &QGuiApplication::commitDataRequest, &window, &MainWindow::keepAll,
                     Qt::DirectConnection); // with the end of the desktop's session
    window.show();
    return QApplication::exec();
}

} // namespace tetra
