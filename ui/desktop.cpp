// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/desktop.h"

#include "plugins/widgets/icons.h"
#include "ui/session/language.h"
#include "ui/session/plugin_choice.h"
#include "ui/widgets/legible_style.h"
#include "ui/window/main_window.h"
#include "ui/window/screenshots.h"
#include "ui/work/steady_heap.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QTranslator>

#include <clocale>
#include <map>
#include <optional>

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
    static const std::map<QString, BackendChoice> names{{"auto", BackendChoice::Automatic},
                                                        {"cpu", BackendChoice::Cpu},
                                                        {"gl", BackendChoice::Gl},
                                                        {"gl33", BackendChoice::Gl33}};
    const auto found = names.find(name);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

int runDesktop(int argc, char** argv)
{
    keepHeapSteady();
    QApplication application(argc, argv);
    // QApplication takes over the user's locale; libraries that read or write numbers must not see its decimal comma.
    std::setlocale(LC_NUMERIC, "C");
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("TAn");
    QCoreApplication::setApplicationVersion(TAN_VERSION);
    QGuiApplication::setDesktopFileName("org.tan.TAn"); // how Wayland finds the icon
    QApplication::setWindowIcon(programIcon());
    useLegibleStyle();
    QTranslator ours;
    QTranslator ofQt;
    loadTranslations(application, ours, ofQt);

    QCommandLineParser parser;
    parser.setApplicationDescription(Desktop::tr("Shows volume data at any accuracy."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOption({"backend",
                      Desktop::tr("What draws the picture: auto, cpu, gl or gl33 (no newer OpenGL than 3.3)."), "name",
                      "auto"});
    QCommandLineOption screenshots("screenshots", "Makes pictures of all panels and dialogs in a folder.", "folder");
    screenshots.setFlags(QCommandLineOption::HiddenFromHelp); // for those who write the manual
    parser.addOption(screenshots);
    parser.addPositionalArgument("file", Desktop::tr("A dataset or a .tan model to open."), "[file]");
    parser.process(application);
    const auto backend = backendNamed(parser.value("backend"));
    if (!backend || parser.positionalArguments().size() > 1) {
        fputs(qPrintable(parser.helpText()), stderr);
        return 2;
    }

    const std::unique_ptr<PluginHost> host = wantedPlugins();
    if (parser.isSet(screenshots))
        return makeScreenshots(*host, parser.value(screenshots));
    Workbench workbench(*host);
    MainWindow window(workbench, *backend);
    window.show();
    for (const QString& file : parser.positionalArguments())
        window.open(file);
    return QApplication::exec();
}

} // namespace tetra
