// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_actions.h"

#include "ui/session/language.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/mnemonics.h"
#include "ui/widgets/motion.h"
#include "ui/window/actions.h"
#include "ui/window/command_palette.h"
#include "ui/window/help_texts.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QUrl>
#include <QWhatsThis>

namespace tetra {
namespace {

class HelpMenuTexts {
    Q_DECLARE_TR_FUNCTIONS(HelpActions)
};

void fillLanguages(QMenu& menu, MessageBar& messages)
{
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& text, const QString& code) {
        QAction* action = menu.addAction(text);
        action->setObjectName("action.language." + (code.isEmpty() ? "system" : code));
        action->setCheckable(true);
        action->setChecked(chosenLanguage() == code);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &messages, [&messages, code] {
            chooseLanguage(code);
            messages.add(HelpMenuTexts::tr("Restart TAn to change the language."), MessageSubject::Program);
        });
    };
    add(HelpMenuTexts::tr("&As the System"), {});
    for (const Language& language : languages())
        add(QString::fromUtf8(language.name), language.code);
    giveMnemonics(menu);
}

class ManualTexts {
    Q_DECLARE_TR_FUNCTIONS(Manual)
};

} // namespace

void connectHelp(QMainWindow& window, const Actions& actions, Workbench& workbench, MessageBar& messages)
{
    auto* palette = new CommandPalette(window, workbench);
    QObject::connect(actions.palette, &QAction::triggered, palette, &CommandPalette::open);
    auto* help = new HelpTexts(&window);
    QObject::connect(actions.help, &QAction::triggered, help, &HelpTexts::showForFocus);
    const auto showManual = [&messages](const QString& place) {
        if (const QString problem = openManual(QCoreApplication::applicationDirPath(), place); !problem.isEmpty())
            messages.add(problem);
    };
    QObject::connect(help, &HelpTexts::manualWanted, &messages, showManual);
    QObject::connect(actions.manual, &QAction::triggered, &messages, [showManual] { showManual("index.html"); });
    QObject::connect(actions.whatsThis, &QAction::triggered, &window, [] { QWhatsThis::enterWhatsThisMode(); });
    actions.reducedMotion->setChecked(motionReduced());
    QObject::connect(actions.reducedMotion, &QAction::toggled, &window, &setMotionReduced);
    fillLanguages(*actions.languages, messages);
}

QString manualPage(const QString& programFolder)
{
    const QString page = QDir::cleanPath(programFolder + "/../share/doc/tan/manual/index.html");
    return QFileInfo(page).isFile() ? page : QString();
}

QString openManual(const QString& programFolder, const QString& place)
{
    const QString page = manualPage(programFolder);
    if (page.isEmpty())
        return ManualTexts::tr("The manual is not installed. Reinstall the package tan with its documentation, or "
                               "build TAn on a system that has Sphinx (python3-sphinx, python3-myst-parser, furo); the "
                               "same texts are in the folder docs of the source code.");
    QUrl url = QUrl::fromLocalFile(QFileInfo(page).path() + '/' + place.section('#', 0, 0));
    if (const QString heading = place.section('#', 1); !heading.isEmpty())
        url.setFragment(heading);
    if (!QDesktopServices::openUrl(url))
        return ManualTexts::tr("No web browser was found on this computer. Install one, or read %1.").arg(page);
    return {};
}

} // namespace tetra
