// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/vtk/written_files.h"

#include <QFile>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::array<int, 3> gridSize{4, 5, 6};
constexpr int gridPoints = 4 * 5 * 6;
constexpr int gridCells = 3 * 4 * 5;

/// Where point n of the grid is, with some bend so that it is no lattice.
std::array<double, 3> bentPoint(int n, double shift = 0)
{
    const int i = n % gridSize[0], j = n / gridSize[0] % gridSize[1], k = n / (gridSize[0] * gridSize[1]);
    return {i + 0.125 * j + shift, j + 0.0625 * k * k, k + 0.25 * i};
}

/// The eight points of each cell, from 0.
std::vector<std::array<int, 8>> gridHexahedra()
{
    std::vector<std::array<int, 8>> cells;
    const int row = gridSize[0], slice = gridSize[0] * gridSize[1];
    for (int k = 0; k + 1 < gridSize[2]; ++k)
        for (int j = 0; j + 1 < gridSize[1]; ++j)
            for (int i = 0; i + 1 < gridSize[0]; ++i) {
                const int p = k * slice + j * row + i;
                cells.push_back(
                    {p, p + 1, p + row + 1, p + row, p + slice, p + slice + 1, p + slice + row + 1, p + slice + row});
            }
    return cells;
}

template <class T> QByteArray littleEndian(T value)
{
    QByteArray bytes(sizeof(T), '\0');
    qToLittleEndian(value, bytes.data());
    return bytes;
}

template <class T> QByteArray bigEndian(T value)
{
    QByteArray bytes(sizeof(T), '\0');
    qToBigEndian(value, bytes.data());
    return bytes;
}

/// 0, 1, 2 ... each by `one`.
template <class One> QByteArray counted(int count, const One& one)
{
    QByteArray bytes;
    for (int n = 0; n < count; ++n)
        bytes += one(n);
    return bytes;
}

/// "%12.5e" as writers of EnSight have it.
QByteArray value12(double value)
{
    return QByteArray::number(value, 'e', 5).rightJustified(12);
}

QByteArray index10(qint64 number)
{
    return QByteArray::number(number).rightJustified(10);
}

class FormatWriter {
public:
    explicit FormatWriter(fs::path folder) : folder_(std::move(folder)) {}

    fs::path path(const std::string& name) const { return folder_ / name; }
    fs::path write(const std::string& name, const QByteArray& content) const
    {
        fs::create_directories(path(name).parent_path());
        writeContent(path(name), content);
        return path(name);
    }

private:
    fs::path folder_;
};

/// The classic formats of NetCDF: 1, 64-bit offset (2), CDF-5.
class NetCdfWriter {
public:
    enum Type { Char = 2, Int = 4, Float = 5, Double = 6 };

    explicit NetCdfWriter(int version) : version_(version) {}

    int dimension(const QByteArray& name, qint64 length)
    {
        dimensions_ += name_(name) + count(length);
        lengths_.push_back(length);
        return static_cast<int>(lengths_.size()) - 1;
    }
    void attribute(const QByteArray& name, const QByteArray& text)
    {
        attributes_ += attributeOf(name, text);
        ++attributeCount_;
    }
    void attribute(const QByteArray& name, Type type, const QByteArray& value)
    {
        attributes_ += name_(name) + bigEndian(qint32(type)) + count(1) + padded(value);
        ++attributeCount_;
    }
    /// `data` of one with records: of each record.
    void variable(const QByteArray& name, const std::vector<int>& dimensions, Type type,
                  const std::vector<QByteArray>& data, const QByteArray& attribute = {}, const QByteArray& text = {})
    {
        Variable v{.head = name_(name) + count(qint64(dimensions.size())), .data = data};
        for (const int d : dimensions)
            v.head += count(d);
        v.head += attribute.isEmpty() ? bigEndian(qint32(0)) + count(0)
                                      : bigEndian(qint32(12)) + count(1) + attributeOf(attribute, text);
        v.head += bigEndian(qint32(type));
        v.hasRecords = !dimensions.empty() && lengths_[static_cast<std::size_t>(dimensions[0])] == 0;
        variables_.push_back(v);
    }

    QByteArray file(qint64 records) const
    {
        qint64 begin = header(records, 0).size();
        const QByteArray head = header(records, begin);
        QByteArray bytes = head;
        for (const Variable& v : variables_)
            if (!v.hasRecords)
                bytes += padded(v.data[0]);
        for (qint64 record = 0; record < records; ++record)
            for (const Variable& v : variables_)
                if (v.hasRecords)
                    bytes += padded(v.data[static_cast<std::size_t>(record)]);
        return bytes;
    }

private:
    struct Variable {
        QByteArray head;
        std::vector<QByteArray> data;
        bool hasRecords = false;
    };

    static QByteArray padded(QByteArray bytes)
    {
        while (bytes.size() % 4 != 0)
            bytes += '\0';
        return bytes;
    }
    QByteArray count(qint64 number) const { return version_ == 5 ? bigEndian(number) : bigEndian(qint32(number)); }
    QByteArray offset(qint64 number) const { return version_ == 1 ? bigEndian(qint32(number)) : bigEndian(number); }
    QByteArray name_(const QByteArray& name) const { return count(name.size()) + padded(name); }
    QByteArray attributeOf(const QByteArray& name, const QByteArray& text) const
    {
        return name_(name) + bigEndian(qint32(Char)) + count(text.size()) + padded(text);
    }

    QByteArray header(qint64 records, qint64 dataBegin) const
    {
        QByteArray bytes = QByteArray("CDF") + static_cast<char>(version_) + count(records);
        bytes += bigEndian(qint32(10)) + count(qint64(lengths_.size())) + dimensions_;
        bytes += bigEndian(qint32(attributeCount_ > 0 ? 12 : 0)) + count(attributeCount_) + attributes_;
        bytes += bigEndian(qint32(11)) + count(qint64(variables_.size()));
        qint64 place = dataBegin;
        for (const bool withRecords : {false, true})
            for (const Variable& v : variables_)
                if (v.hasRecords == withRecords) {
                    places_[&v] = place;
                    place += padded(v.data[0]).size();
                }
        for (const Variable& v : variables_)
            bytes += v.head + count(padded(v.data[0]).size()) + offset(places_[&v]);
        return bytes;
    }

    int version_;
    std::vector<qint64> lengths_;
    QByteArray dimensions_;
    QByteArray attributes_;
    qint64 attributeCount_ = 0;
    std::vector<Variable> variables_;
    mutable std::map<const Variable*, qint64> places_;
};

QByteArray bigDoubles(int count, const std::function<double(int)>& value)
{
    return counted(count, [&](int n) { return bigEndian(value(n)); });
}

void addNetCdf(const fs::path& folder, std::vector<WrittenFiles>& all)
{
    for (const int version : {1, 2, 5})
        for (const bool inTime : {false, true}) {
            NetCdfWriter file(version);
            const int time = inTime ? file.dimension("time", 0) : -1;
            std::vector<int> axes = inTime ? std::vector<int>{time} : std::vector<int>{};
            for (int axis = 2; axis >= 0; --axis)
                axes.push_back(
                    file.dimension(QByteArray(1, static_cast<char>('x' + axis)), gridSize[std::size_t(axis)]));
            for (int axis = 2; axis >= 0; --axis)
                file.variable(QByteArray(1, static_cast<char>('x' + axis)), {axes[axes.size() - 1 - std::size_t(axis)]},
                              NetCdfWriter::Double,
                              {bigDoubles(gridSize[std::size_t(axis)], [&](int n) { return 0.5 * n * (axis + 1); })},
                              "units", "m");
            const QByteArray samples = counted(gridPoints, [](int n) { return bigEndian(static_cast<float>(n)); });
            if (inTime)
                file.variable("time", {time}, NetCdfWriter::Double, {bigEndian(0.), bigEndian(1.)}, "units",
                              "seconds since 2000-01-01");
            file.variable("q", axes, NetCdfWriter::Float, {samples, samples});
            const FormatWriter writer(folder / ("netcdf" + std::to_string(version) + (inTime ? "-time" : "")));
            const fs::path path = writer.write("grid.nc", file.file(inTime ? 2 : 0));
            all.push_back(
                {"NetCDF " + std::to_string(version) + (inTime ? ", records" : ""), path, {path}, gridPoints});
        }
}

void addExodus(const fs::path& folder, std::vector<WrittenFiles>& all)
{
    for (const int version : {1, 2, 5}) {
        NetCdfWriter file(version);
        using enum NetCdfWriter::Type;
        file.attribute("api_version", Float, bigEndian(4.98F));
        file.attribute("version", Float, bigEndian(4.98F));
        file.attribute("floating_point_word_size", Int, bigEndian(qint32(8)));
        file.attribute("file_size", Int, bigEndian(qint32(1)));
        file.attribute("title", "a test");
        const int text = file.dimension("len_string", 33);
        file.dimension("len_line", 81);
        file.dimension("four", 4);
        const int time = file.dimension("time_step", 0);
        const int axes = file.dimension("num_dim", 3);
        const int nodes = file.dimension("num_nodes", gridPoints);
        file.dimension("num_elem", gridCells);
        const int blocks = file.dimension("num_el_blk", 1);
        const int elements = file.dimension("num_el_in_blk1", gridCells);
        const int corners = file.dimension("num_nod_per_el1", 8);
        const int variables = file.dimension("num_nod_var", 1);
        file.variable("time_whole", {time}, Double, {bigEndian(0.), bigEndian(1.)});
        file.variable("eb_status", {blocks}, Int, {bigEndian(qint32(1))});
        file.variable("eb_prop1", {blocks}, Int, {bigEndian(qint32(1))}, "name", "ID");
        for (int axis = 0; axis < 3; ++axis)
            file.variable("coord" + QByteArray(1, static_cast<char>('x' + axis)), {nodes}, Double,
                          {bigDoubles(gridPoints, [&](int n) { return bentPoint(n)[std::size_t(axis)]; })});
        QByteArray names;
        for (int axis = 0; axis < 3; ++axis)
            names += QByteArray(1, static_cast<char>('x' + axis)).leftJustified(33, '\0');
        file.variable("coor_names", {axes, text}, Char, {names});
        QByteArray connectivity;
        for (const auto& cell : gridHexahedra())
            for (const int corner : cell)
                connectivity += bigEndian(qint32(corner + 1));
        file.variable("connect1", {elements, corners}, Int, {connectivity}, "elem_type", "HEX8");
        file.variable("name_nod_var", {variables, text}, Char, {QByteArray("q").leftJustified(33, '\0')});
        const QByteArray samples = bigDoubles(gridPoints, [](int n) { return n; });
        file.variable("vals_nod_var1", {time, nodes}, Double, {samples, samples});
        const FormatWriter writer(folder / ("exodus" + std::to_string(version)));
        const fs::path path = writer.write("mesh.ex2", file.file(2));
        all.push_back({"Exodus " + std::to_string(version), path, {path}, gridPoints});
    }
}

QByteArray enSightPart(int number, double shift)
{
    QByteArray text = "part\n" + index10(number) + "\nthe part\ncoordinates\n" + index10(gridPoints) + "\n";
    for (std::size_t axis = 0; axis < 3; ++axis)
        text += counted(gridPoints, [&](int n) { return value12(bentPoint(n, shift)[axis]) + "\n"; });
    text += "hexa8\n" + index10(gridCells) + "\n";
    for (const auto& cell : gridHexahedra()) {
        for (const int corner : cell)
            text += index10(corner + 1);
        text += "\n";
    }
    return text;
}

void addEnSight(const fs::path& folder, std::vector<WrittenFiles>& all)
{
    const auto caseText = [](const QByteArray& type, const QByteArray& variable, const QByteArray& rest = {}) {
        return "FORMAT\ntype: " + type + "\nGEOMETRY\nmodel: run.geo\nVARIABLE\n" + variable + " heat run.heat\n" +
               rest;
    };
    const auto add = [&](const char* what, const char* name, const QByteArray& head, const QByteArray& geometry,
                         const QByteArray& values, std::size_t points, bool perCell = false) {
        const FormatWriter writer(folder / name);
        WrittenFiles files{.what = std::string("EnSight, ") + what,
                           .opened = writer.write("run.case", head),
                           .points = points,
                           .perCell = perCell};
        files.data = {writer.write("run.geo", geometry), writer.write("run.heat", values)};
        all.push_back(std::move(files));
    };
    const QByteArray goldHead = "one\ntwo\nnode id assign\nelement id assign\n";
    const auto lines = [](int first, int count) {
        return counted(count, [&](int n) { return value12(first + n) + "\n"; });
    };
    add("Gold", "gold", caseText("ensight gold", "scalar per node:"), goldHead + enSightPart(1, 0) + enSightPart(2, 50),
        "heat\npart\n" + index10(1) + "\ncoordinates\n" + lines(0, gridPoints) + "part\n" + index10(2) +
            "\ncoordinates\n" + lines(gridPoints, gridPoints),
        2 * gridPoints);
    add("Gold, values of elements", "gold-elements", caseText("ensight gold", "scalar per element:"),
        goldHead + enSightPart(1, 0), "heat\npart\n" + index10(1) + "\nhexa8\n" + lines(0, gridCells), gridPoints,
        true);
    QByteArray block = "part\n" + index10(1) + "\nthe part\nblock\n" + index10(4) + index10(5) + index10(6) + "\n";
    for (std::size_t axis = 0; axis < 3; ++axis)
        block += counted(gridPoints, [&](int n) { return value12(bentPoint(n)[axis]) + "\n"; });
    add("Gold, block", "gold-block", caseText("ensight gold", "scalar per node:"), goldHead + block,
        "heat\npart\n" + index10(1) + "\nblock\n" + lines(0, gridPoints), gridPoints);
    QByteArray uniform =
        "part\n" + index10(1) + "\nthe part\nblock uniform\n" + index10(4) + index10(5) + index10(6) + "\n";
    for (const double number : {1., 2., 3., .5, .25, 1.5})
        uniform += value12(number) + "\n";
    add("Gold, uniform block, two times in a file", "gold-times",
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: run.geo\nVARIABLE\nscalar per node: 1 1 heat run.heat\nTIME\n"
        "time set: 1\nnumber of steps: 2\ntime values:\n0.5 1.5\nFILE\nfile set: 1\nnumber of steps: 2\n",
        "BEGIN TIME STEP\n" + goldHead + uniform + "END TIME STEP\nBEGIN TIME STEP\n" + goldHead + uniform +
            "END TIME STEP\n",
        "BEGIN TIME STEP\nheat\npart\n" + index10(1) + "\nblock\n" + lines(0, gridPoints) + "END TIME STEP\n" +
            "BEGIN TIME STEP\nheat\npart\n" + index10(1) + "\nblock\n" + lines(0, gridPoints) + "END TIME STEP\n",
        gridPoints);

    QByteArray old = "one\ntwo\nnode id given\nelement id given\ncoordinates\n" +
                     QByteArray::number(gridPoints).rightJustified(8) + "\n";
    for (int n = 0; n < gridPoints; ++n) {
        old += QByteArray::number(n + 1).rightJustified(8);
        for (const double coordinate : bentPoint(n))
            old += value12(coordinate);
        old += "\n";
    }
    old += "part 1\nthe part\nhexa8\n" + QByteArray::number(gridCells).rightJustified(8) + "\n";
    int number = 0;
    for (const auto& cell : gridHexahedra()) {
        old += QByteArray::number(++number).rightJustified(8);
        for (const int corner : cell)
            old += QByteArray::number(corner + 1).rightJustified(8);
        old += "\n";
    }
    const auto sixes = [](int count) {
        return counted(count, [&](int n) { return value12(n) + (n % 6 == 5 || n == count - 1 ? "\n" : ""); });
    };
    add("6", "ensight6", caseText("ensight", "scalar per node:"), old, "heat\n" + sixes(gridPoints), gridPoints);
    add("6, values of elements", "ensight6-elements", caseText("ensight", "scalar per element:"), old,
        "heat\npart 1\nhexa8\n" + sixes(gridCells), gridPoints, true);
}

void addTecplot(const fs::path& folder, std::vector<WrittenFiles>& all)
{
    const auto add = [&](const char* what, const char* name, const QByteArray& zone, bool perCell = false) {
        const fs::path path =
            FormatWriter(folder / name)
                .write("flow.tec", "TITLE = \"a test\"\nVARIABLES = \"X\", \"Y\", \"Z\", \"P (Pa)\"\n" + zone);
        all.push_back({std::string("Tecplot, ") + what, path, {path}, gridPoints, perCell});
    };
    QByteArray byPoints, byBlocks, corners;
    for (int n = 0; n < gridPoints; ++n) {
        for (const double coordinate : bentPoint(n))
            byPoints += QByteArray::number(coordinate) + " ";
        byPoints += QByteArray::number(n) + "\n";
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        byBlocks += counted(gridPoints,
                            [&](int n) { return QByteArray::number(bentPoint(n)[axis]) + (n % 8 == 7 ? "\n" : " "); });
    const auto values = [](int count) {
        return counted(count, [](int n) { return QByteArray::number(n) + (n % 8 == 7 ? "\n" : " "); });
    };
    for (const auto& cell : gridHexahedra()) {
        for (const int corner : cell)
            corners += QByteArray::number(corner + 1) + " ";
        corners += "\n";
    }
    const QByteArray elements = "NODES=120, ELEMENTS=60, ";
    add("points", "tecplot-point", "ZONE T=\"one\", I=4, J=5, K=6, F=POINT\n" + byPoints);
    add("blocks", "tecplot-block",
        "ZONE I=4, J=5, K=6, ZONETYPE=ORDERED, DATAPACKING=BLOCK\n" + byBlocks + values(gridPoints));
    add("elements by points", "tecplot-fepoint", "ZONE N=120, E=60, F=FEPOINT, ET=BRICK\n" + byPoints + corners);
    add("elements by blocks", "tecplot-feblock",
        "ZONE " + elements + "ZONETYPE=FEBRICK, DATAPACKING=BLOCK, VARLOCATION=([4]=CELLCENTERED)\n" + byBlocks +
            values(gridCells) + "\n" + corners,
        true);
}

/// A face of the grid: its corners, the cell whose outside it shows, and the one behind it or -1.
struct GridFace {
    std::array<int, 4> corners;
    int owner;
    int neighbour;
};

/// First those between cells, then those of the boundary, each by owner.
std::vector<GridFace> gridFaces()
{
    constexpr std::array<std::array<int, 4>, 6> sides = {
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}}};
    std::map<std::array<int, 4>, GridFace> faces;
    const auto cells = gridHexahedra();
    for (int cell = 0; cell < int(cells.size()); ++cell)
        for (const auto& side : sides) {
            std::array<int, 4> corners{};
            for (std::size_t i = 0; i < 4; ++i)
                corners[i] = cells[std::size_t(cell)][std::size_t(side[i])];
            std::array<int, 4> key = corners;
            std::ranges::sort(key);
            const auto [face, isNew] = faces.emplace(key, GridFace{corners, cell, -1});
            if (!isNew)
                face->second.neighbour = cell;
        }
    std::vector<GridFace> all;
    for (const auto& [key, face] : faces)
        all.push_back(face);
    std::ranges::stable_sort(all, {}, [](const GridFace& face) {
        return std::array{face.neighbour < 0 ? 1 : 0, face.owner, face.neighbour};
    });
    return all;
}

QByteArray foamFile(const QByteArray& kind, const QByteArray& object, const QByteArray& content)
{
    return "FoamFile\n{\n version 2.0;\n format ascii;\n class " + kind + ";\n object " + object + ";\n}\n" + content;
}

template <class One> QByteArray foamList(int count, const One& one)
{
    return QByteArray::number(count) + "\n(\n" + counted(count, one) + ")\n";
}

void addOpenFoam(const fs::path& folder, std::vector<WrittenFiles>& all)
{
    const FormatWriter writer(folder / "foam");
    const auto faces = gridFaces();
    const auto inner =
        static_cast<int>(std::ranges::count_if(faces, [](const GridFace& face) { return face.neighbour >= 0; }));
    const auto face = [&](int n) -> const GridFace& { return faces[std::size_t(n)]; };
    const std::string mesh = "constant/polyMesh/";
    writer.write(mesh + "points", foamFile("vectorField", "points", foamList(gridPoints, [](int n) {
                                               const auto [x, y, z] = bentPoint(n);
                                               return "(" + QByteArray::number(x) + " " + QByteArray::number(y) + " " +
                                                      QByteArray::number(z) + ")\n";
                                           })));
    writer.write(mesh + "faces", foamFile("faceList", "faces", foamList(int(faces.size()), [&](int n) {
                                              QByteArray text = "4(";
                                              for (const int corner : face(n).corners)
                                                  text += QByteArray::number(corner) + " ";
                                              return text + ")\n";
                                          })));
    writer.write(mesh + "owner", foamFile("labelList", "owner", foamList(int(faces.size()), [&](int n) {
                                              return QByteArray::number(face(n).owner) + "\n";
                                          })));
    writer.write(mesh + "neighbour", foamFile("labelList", "neighbour", foamList(inner, [&](int n) {
                                                  return QByteArray::number(face(n).neighbour) + "\n";
                                              })));
    writer.write(mesh + "boundary",
                 foamFile("polyBoundaryMesh", "boundary",
                          "1\n(\nwalls\n{\n type wall;\n nFaces " + QByteArray::number(int(faces.size()) - inner) +
                              ";\n startFace " + QByteArray::number(inner) + ";\n}\n)\n"));
    writer.write("system/controlDict",
                 foamFile("dictionary", "controlDict",
                          "startTime 0;\nendTime 0;\ndeltaT 1;\nwriteControl timeStep;\nwriteInterval 1;\n"));
    const fs::path field =
        writer.write("0/T", foamFile("volScalarField", "T",
                                     "dimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar>\n" +
                                         foamList(gridCells, [](int n) { return QByteArray::number(n) + "\n"; }) +
                                         ";\nboundaryField\n{\n walls\n {\n type zeroGradient;\n }\n}\n"));
    WrittenFiles files{.what = "OpenFOAM", .points = gridPoints, .perCell = true};
    files.opened = writer.write("run.foam", " ");
    files.data = {writer.path(mesh + "points"), writer.path(mesh + "faces"), writer.path(mesh + "owner"),
                  writer.path(mesh + "neighbour"), field};
    all.push_back(std::move(files));
}

void addFluent(const fs::path& folder, std::vector<WrittenFiles>& all)
{
    const FormatWriter writer(folder / "fluent");
    const auto hex = [](qint64 number) { return QByteArray::number(number, 16); };
    const auto faces = gridFaces();
    const auto inner = std::ranges::count_if(faces, [](const GridFace& face) { return face.neighbour >= 0; });
    QByteArray text =
        "(0 \"a test\")\n(2 3)\n(10 (0 1 " + hex(gridPoints) + " 0 3))\n(10 (1 1 " + hex(gridPoints) + " 1 3)(\n";
    for (int n = 0; n < gridPoints; ++n) {
        const auto [x, y, z] = bentPoint(n);
        text += QByteArray::number(x) + " " + QByteArray::number(y) + " " + QByteArray::number(z) + "\n";
    }
    text += "))\n(12 (0 1 " + hex(gridCells) + " 0 0))\n(12 (2 1 " + hex(gridCells) + " 1 4))\n(13 (0 1 " +
            hex(qint64(faces.size())) + " 0 0))\n";
    for (const auto& [zone, kind, first, end] :
         {std::array<qint64, 4>{3, 2, 0, inner}, std::array<qint64, 4>{4, 3, inner, qint64(faces.size())}}) {
        text += "(13 (" + hex(zone) + " " + hex(first + 1) + " " + hex(end) + " " + hex(kind) + " 4)(\n";
        for (qint64 n = first; n < end; ++n) {
            const GridFace& face = faces[std::size_t(n)];
            for (auto corner = face.corners.rbegin(); corner != face.corners.rend(); ++corner)
                text += hex(*corner + 1) + " ";
            text += hex(face.owner + 1) + " " + hex(face.neighbour + 1) + "\n";
        }
        text += "))\n";
    }
    WrittenFiles files{.what = "Fluent", .points = gridPoints, .perCell = true};
    files.opened = writer.write("flow.cas", text);
    files.data = {files.opened,
                  writer.write("flow.dat", "(0 \"a test\")\n(33 (60 " + QByteArray::number(int(faces.size())) +
                                               " 120))\n(300 (1 2 1 0 0 1 60)(\n" +
                                               counted(gridCells, [](int n) { return QByteArray::number(n) + "\n"; }) +
                                               "))\n")};
    all.push_back(std::move(files));
}

} // namespace

std::vector<WrittenFiles> writeFormats(const fs::path& folder)
{
    std::vector<WrittenFiles> all;
    addNetCdf(folder, all);
    addExodus(folder, all);
    addEnSight(folder, all);
    addTecplot(folder, all);
    addOpenFoam(folder, all);
    addFluent(folder, all);
    return all;
}

QByteArray contentOf(const fs::path& path)
{
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read a test file");
    return file.readAll();
}

void writeContent(const fs::path& path, const QByteArray& content)
{
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write a test file");
}

} // namespace tetra
