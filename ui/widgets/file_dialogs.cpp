// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/file_dialogs.h"

#include "ui/session/recent_files.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>

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
        dialog.setDefaultSuffix(filter.section("*.", 1).remove(')'));
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
    dialog->setNameFilter(FileDialogs::tr("PNG pictures (*.png)"));
    askForTarget(*dialog, proposed);
}

void askForMeshFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, FileDialogs::tr("Save Mesh"), chosen);
    askForTargetOf(*dialog, proposed,
                   {FileDialogs::tr("VTK XML unstructured grids (*.vtu)"), FileDialogs::tr("VTK legacy files (*.vtk)"),
                    FileDialogs::tr("PLY files (*.ply)"), FileDialogs::tr("Boundary as VTK XML polydata (*.vtp)"),
                    FileDialogs::tr("Boundary as STL (*.stl)"), FileDialogs::tr("Boundary as Wavefront OBJ (*.obj)"),
                    FileDialogs::tr("Boundary as binary glTF (*.glb)")});
}

void askForSurfaceFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, FileDialogs::tr("Save Surfaces"), chosen);
    askForTargetOf(*dialog, proposed,
                   {FileDialogs::tr("STL files (*.stl)"), FileDialogs::tr("Wavefront OBJ files (*.obj)"),
                    FileDialogs::tr("Binary glTF files (*.glb)"), FileDialogs::tr("PLY files (*.ply)"),
                    FileDialogs::tr("VTK XML polydata (*.vtp)"), FileDialogs::tr("VTK legacy files (*.vtk)"),
                    FileDialogs::tr("VTK XML unstructured grids (*.vtu)")});
}

void askForStatisticsFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, FileDialogs::tr("Save Statistics"), chosen);
    askForTargetOf(*dialog, proposed,
                   {FileDialogs::tr("Tables of comma-separated values (*.csv)"), FileDialogs::tr("JSON (*.json)")});
}

void askForTextFile(QWidget* parent, const QString& name, const QString& title, const QString& filter,
                    const FileChosen& chosen)
{
    QFileDialog* dialog = makeDialog(parent, name, title, chosen);
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
