// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/findings.h"
#include "plugins/readers/vtk/vtk_format.h"
#include "plugins/readers/vtk/vtk_reader.h"

#include <tan/data.h>

#include <QByteArray>
#include <QString>
#include <QTemporaryDir>

#include <filesystem>
#include <vector>

namespace tetra {

/// The helper program of this build.
std::filesystem::path builtVtkHelper();

/// What it finds, before that becomes a dataset.
Result<FileFindings> foundByHelper(VtkFormat format, const std::filesystem::path& path);

/// The reader with that, as the program has it.
const Reader& builtVtkReader();

/// The reader that the program takes for a file of VTK's: builtVtkReader(), or for .vtu, PLOT3D, NetCDF and Exodus
/// files another one.
const Reader& readerOf(const std::filesystem::path& path);

/// "array: a (a guess); time step: 1 of 2, time 0": Source::taken in one text.
QString takenOf(const std::vector<Taken>& taken);

/// Source::leftOut in one text.
QString leftOutOf(const std::vector<Message>& leftOut);

/// Small VTK files in text, 3 x 3 x 3 points with the scalar "value" (n at point n), and for vtu and vtk of tetrahedra
/// two tetrahedra over five points.
QByteArray vtiText();
QByteArray vtsText();
QByteArray vtuText();
QByteArray vtpText();
QByteArray legacyText();
QByteArray legacyMeshText();

/// `text` with the first `from` replaced; must be in it.
QByteArray with(QByteArray text, const QByteArray& from, const QByteArray& to);

/// A folder for files that live as long as the test.
class VtkFolder {
public:
    std::filesystem::path path() const { return folder_.path().toStdString(); }
    std::filesystem::path write(const QByteArray& name, const QByteArray& content) const;

private:
    QTemporaryDir folder_;
};

/// A damaged file: how it was damaged, its name and its content.
struct BadFile {
    QByteArray what;
    QByteArray name;
    QByteArray content;
};

/// A file cut after 1/12, 2/12 ... of its length, and with bytes and stretches changed at places that a fixed seed
/// says.
std::vector<BadFile> damaged(const QByteArray& name, const QByteArray& content);

} // namespace tetra
