// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/file_dialogs.h"

#include "core/picture/picture_file.h"
#include "ui/opening/recent_files.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>

namespace tetra {
namespace {

class FileDialogs {
    Q_DECLARE_TR_FUNCTIONS(FileDialogs)
};

QFileDialog* makeDialog(QWidget* parent, const QString& name, const QString& title, const FileChosen& chosen)
{
    auto* dialog = new QFileDialog(parent, title);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, chosen);
    return dialog;
}

/// The name's ending is added where it is missing.
void askForTarget(QFileDialog& dialog, const QString& proposed)
{
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QFileInfo(proposed).suffix());
    dialog.setDirectory(QFileInfo(proposed).absolutePath());
    dialog.selectFile(QFileInfo(proposed).fileName());
    dialog.open();
}

/// The ending that is added is that of the kind of file that is chosen.
void askForTargetOf(QFileDialog& dialog, const QString& proposed, const QStringList& filters)
{
    dialog.setNameFilters(filters);
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
        dialog.setDefaultSuffix(filter.section("*.", 1, 1).remove(')').trimmed());
    });
    askForTarget(dialog, proposed);
}

} // namespace

void askForFile(QWidget* parent, const QString& name, const QStringList& filters, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, FileDialogs::tr("Open a Dataset or a Model"), chosen);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(filters);
    if (const QStringList recent = recentFiles(); !recent.isEmpty())
        dialog->setDirectory(QFileInfo(recent.first()).absolutePath());
    dialog->open();
}

void askForPictureFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, FileDialogs::tr("Save Picture"), chosen);
    QStringList filters{FileDialogs::tr("PNG pictures (*.png)")};
    if (writesTiff())
        filters << FileDialogs::tr("TIFF pictures (*.tif *.tiff)");
    if (writesJpeg())
        filters << FileDialogs::tr("JPEG pictures (*.jpg *.jpeg)");
    if (writesPdf())
        filters << FileDialogs::tr("PDF files (*.pdf)");
    askForTargetOf(*dialog, proposed, filters);
}

void askForTargetFile(QWidget* parent, const QString& name, const QString& title, const QStringList& filters,
                      const QString& proposed, const FileChosen& chosen)
{
    const QString pattern = "*." + QFileInfo(proposed).suffix();
    QStringList usualFirst = filters;
    std::ranges::stable_partition(usualFirst, [&](const QString& filter) { return filter.contains(pattern); });
    askForTargetOf(*makeDialog(parent, name, title, chosen), proposed, usualFirst);
}

void askForStatisticsFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, FileDialogs::tr("Save Statistics"), chosen);
    askForTargetOf(*dialog, proposed,
                   {FileDialogs::tr("Tables of comma-separated values (*.csv)"), FileDialogs::tr("JSON (*.json)")});
}

void askForTextFile(QWidget* parent, const QString& name, const QString& title, const QString& filter,
                    const FileChosen& chosen, const QString& folder)
{
    QFileDialog* dialog = makeDialog(parent, name, title, chosen);
    if (!folder.isEmpty())
        dialog->setDirectory(folder);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({filter, FileDialogs::tr("All files (*)")});
    dialog->open();
}

void askForTextTarget(QWidget* parent, const QString& name, const QString& title, const QString& filter,
                      const QString& proposed, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, title, chosen);
    dialog->setNameFilter(filter);
    askForTarget(*dialog, proposed);
}

} // namespace tetra
