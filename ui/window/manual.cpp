// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/manual.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

namespace tetra {
namespace {

class ManualTexts {
    Q_DECLARE_TR_FUNCTIONS(Manual)
};

} // namespace

QString manualPage(const QString& programFolder)
{
    const QString page = QDir::cleanPath(programFolder + "/../share/doc/tan/manual/index.html");
    return QFileInfo(page).isFile() ? page : QString();
}

QString openManual(const QString& programFolder)
{
    const QString page = manualPage(programFolder);
    if (page.isEmpty())
        return ManualTexts::tr(
            "The manual is not installed. Install the package tan again with its documentation, or build TAn where "
            "Sphinx "
            "is installed (python3-sphinx, python3-myst-parser, furo); the same texts are in the folder docs of its "
            "sources.");
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
        return ManualTexts::tr("No program opens web pages here. Install a web browser, or read %1.").arg(page);
    return {};
}

} // namespace tetra
