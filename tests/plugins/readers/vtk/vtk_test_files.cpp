// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include "plugins/host/plugin_guards.h"
#include "plugins/process/reading_process.h"
#include "plugins/readers/cells/cells_reader.h"
#include "plugins/readers/lattice/lattice_reader.h"
#include "plugins/readers/netcdf/netcdf_reader.h"
#include "plugins/readers/plot3d/plot3d_reader.h"
#include "plugins/readers/vtk/vtk_findings.h"
#include "tests/plugins/as_loaded.h"

#include <QFile>

#include <random>

namespace tetra {
namespace {

QByteArray numbers(int count)
{
    QByteArray text;
    for (int n = 0; n < count; ++n)
        text += QByteArray::number(n) + " ";
    return text;
}

QByteArray gridCoordinates()
{
    QByteArray text;
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                text += QByteArray::number(i + 0.1 * j) + " " + QByteArray::number(j) + " " +
                        QByteArray::number(k + 0.1 * i) + "\n";
    return text;
}

const QByteArray fivePoints = "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1";

QByteArray xml(const QByteArray& type, const QByteArray& attributes, const QByteArray& piece, const QByteArray& content)
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
           "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + type + attributes +
           ">\n<Piece " + piece + ">\n" + content + "</Piece>\n</" + type + ">\n</VTKFile>\n";
}

QByteArray array(const QByteArray& type, const QByteArray& name, int components, const QByteArray& values)
{
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           QByteArray::number(components) + "\" format=\"ascii\">" + values + "</DataArray>\n";
}

QByteArray pointData(int count)
{
    return "<PointData Scalars=\"value\">" + array("Float32", "value", 1, numbers(count)) + "</PointData>\n";
}

} // namespace

std::filesystem::path builtVtkHelper()
{
    return std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-vtk";
}

Result<FileFindings> foundByHelper(VtkFormat format, const std::filesystem::path& path)
{
    VtkRequest request;
    request.format = format;
    request.path = path.string();
    auto answer = askReadingProgram(vtkReadingProgram(builtVtkHelper()), requestText(request), request.path, {});
    return answer ? Result<FileFindings>(std::get<FileFindings>(*std::move(answer))) : answer.error();
}

const Reader& builtVtkReader()
{
    static const VtkReader reader(builtVtkHelper());
    static const auto guard = guarded(reader, {"vtk", [](const Error&) {}});
    return *guard;
}

QString takenOf(const std::vector<Taken>& taken)
{
    QString text;
    for (const Taken& one : taken)
        text += (text.isEmpty() ? "" : "; ") + QString::fromStdString(takenText(one).text());
    return text;
}

QString leftOutOf(const std::vector<Message>& leftOut)
{
    QString text;
    for (const Message& one : leftOut)
        text += (text.isEmpty() ? "" : " ") + QString::fromStdString(one.text());
    return text;
}

namespace {

const Reader& builtNetCdfReader()
{
    static const NetCdfReader reader(std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-netcdf");
    static const auto guard = guarded(reader, {"netcdf", [](const Error&) {}});
    return *guard;
}

} // namespace

const Reader& readerOf(const std::filesystem::path& path)
{
    const std::string ending = fileEnding(path);
    if (ending == ".nc" || ending == ".ex2")
        return builtNetCdfReader();
    if (ending == ".vtu")
        return asLoaded<CellsReader>();
    if (ending == ".mha" || ending == ".mhd" || ending == ".nii" || ending == ".mrc")
        return asLoaded<LatticeReader>();
    return ending == ".xyz" ? asLoaded<Plot3dReader>() : builtVtkReader();
}

QByteArray vtiText()
{
    return xml("ImageData", " WholeExtent=\"0 2 0 2 0 2\" Origin=\"1 2 3\" Spacing=\"0.5 1 2\"",
               "Extent=\"0 2 0 2 0 2\"",
               pointData(27) + "<CellData>" + array("Float64", "cells", 1, numbers(8)) + "</CellData>\n");
}

QByteArray vtsText()
{
    return xml("StructuredGrid", " WholeExtent=\"0 2 0 2 0 2\"", "Extent=\"0 2 0 2 0 2\"",
               pointData(27) + "<Points>" + array("Float32", "Points", 3, gridCoordinates()) + "</Points>\n");
}

QByteArray vtuText()
{
    return xml("UnstructuredGrid", "", "NumberOfPoints=\"5\" NumberOfCells=\"2\"",
               pointData(5) + "<Points>" + array("Float32", "Points", 3, fivePoints) + "</Points>\n<Cells>" +
                   array("Int64", "connectivity", 1, "0 1 2 3 4 1 2 3") + array("Int64", "offsets", 1, "4 8") +
                   array("UInt8", "types", 1, "10 10") + "</Cells>\n");
}

QByteArray vtpText()
{
    return xml("PolyData", "",
               "NumberOfPoints=\"5\" NumberOfVerts=\"5\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"",
               pointData(5) + "<Points>" + array("Float32", "Points", 3, fivePoints) + "</Points>\n<Verts>" +
                   array("Int64", "connectivity", 1, "0 1 2 3 4") + array("Int64", "offsets", 1, "1 2 3 4 5") +
                   "</Verts>\n");
}

QByteArray legacyText()
{
    return "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 3\nSPACING 0.5 1 2\n"
           "ORIGIN 1 2 3\nPOINT_DATA 27\nSCALARS value float 1\nLOOKUP_TABLE default\n" +
           numbers(27) + "\n";
}

QByteArray legacyMeshText()
{
    return "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n" + fivePoints +
           "\nCELLS 2 10\n4 0 1 2 3\n4 4 1 2 3\nCELL_TYPES 2\n10\n10\nPOINT_DATA 5\nSCALARS value double 1\n"
           "LOOKUP_TABLE default\n" +
           numbers(5) + "\n";
}

QByteArray with(QByteArray text, const QByteArray& from, const QByteArray& to)
{
    const auto place = text.indexOf(from);
    if (place < 0)
        qFatal("'%s' is not in the text", from.constData());
    return text.replace(place, from.size(), to);
}

std::filesystem::path VtkFolder::write(const QByteArray& name, const QByteArray& content) const
{
    QFile file(folder_.filePath(QString::fromUtf8(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write a test file");
    return file.fileName().toStdString();
}

std::vector<BadFile> damaged(const QByteArray& name, const QByteArray& content)
{
    constexpr int parts = 12;
    std::vector<BadFile> files;
    for (int part = 1; part < parts; ++part)
        files.push_back(
            {"cut at " + QByteArray::number(part) + "/12", name, content.left(content.size() * part / parts)});
    std::mt19937 random(42);
    constexpr qsizetype head = 4096;
    std::uniform_int_distribution<int> place(0, static_cast<int>(std::min(content.size(), head)) - 17);
    for (int change = 0; change < 6; ++change) {
        QByteArray changed = content;
        for (int byte = 0; byte < 4; ++byte)
            changed[place(random)] = static_cast<char>(random());
        files.push_back({"bytes changed, " + QByteArray::number(change), name, changed});
    }
    for (int change = 0; change < 4; ++change) {
        QByteArray changed = content;
        changed.replace(place(random), 16, QByteArray(16, change % 2 == 0 ? '\0' : '9'));
        files.push_back({"a piece overwritten, " + QByteArray::number(change), name, changed});
    }
    return files;
}

} // namespace tetra
