// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/vtu_writer.h"

#include "core/mesh/mesh_output.h"

#include <algorithm>
#include <new>

namespace tetra {

namespace {

constexpr std::uint8_t vtkTetra = 10;

std::string_view vtkTypeName(SampleType type)
{
    constexpr std::string_view names[] = {"UInt8", "Int8", "UInt16", "Int16", "UInt32", "Int32", "Float32", "Float64"};
    return names[static_cast<std::size_t>(type)];
}

bool fitFloats(const std::vector<Eigen::Vector3d>& positions)
{
    return std::ranges::all_of(
        positions, [](const Eigen::Vector3d& position) { return position.cast<float>().cast<double>() == position; });
}

/// The XML part, and where each array will lie behind it.
std::string headOf(const Dataset& dataset, bool floats)
{
    const std::uint64_t points = dataset.pointCount(), cells = dataset.tetrahedra->size();
    std::uint64_t offset = 0;
    const auto array = [&](std::string_view type, std::string_view name, std::string_view more, std::uint64_t bytes) {
        std::string text = "<DataArray type=\"" + std::string(type) + "\" Name=\"" + std::string(name) + "\"" +
                           std::string(more) + " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
        offset += sizeof(std::uint64_t) + bytes;
        return text;
    };
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                       "<Piece NumberOfPoints=\"" +
                       std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(cells) +
                       "\">\n<PointData Scalars=\"value\">\n";
    const SampleType type = dataset.values.type();
    text += array(vtkTypeName(type), "value", "", points * sampleSize(type));
    text += "</PointData>\n<Points>\n";
    text += array(floats ? "Float32" : "Float64", "Points", " NumberOfComponents=\"3\"",
                  3 * points * (floats ? sizeof(float) : sizeof(double)));
    text += "</Points>\n<Cells>\n";
    text += array("Int64", "connectivity", "", 4 * cells * sizeof(std::int64_t));
    text += array("Int64", "offsets", "", cells * sizeof(std::int64_t));
    text += array("UInt8", "types", "", cells);
    return text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
}

template <class Value, class Make> Status writeArray(MeshOutput& out, std::uint64_t count, Make&& make)
{
    const std::uint64_t size = count * sizeof(Value);
    if (const Status written = out.bytes(std::as_bytes(std::span(&size, 1))); !written)
        return written;
    return out.records(count, sizeof(Value), [&](std::uint64_t index, std::byte* where) {
        putNumber(where, static_cast<Value>(make(index)));
    });
}

Status writeArrays(MeshOutput& out, const Dataset& dataset, bool floats)
{
    const std::uint64_t cells = dataset.tetrahedra->size(), coordinates = 3 * dataset.pointCount();
    const std::span<const std::byte> values = dataset.values.bytes();
    const std::uint64_t size = values.size();
    if (const Status written = out.bytes(std::as_bytes(std::span(&size, 1))); !written)
        return written;
    if (const Status written = out.bytes(values); !written)
        return written;
    const auto coordinate = [&](std::uint64_t i) { return (*dataset.positions)[i / 3][static_cast<int>(i % 3)]; };
    if (const Status written =
            floats ? writeArray<float>(out, coordinates, coordinate) : writeArray<double>(out, coordinates, coordinate);
        !written)
        return written;
    const auto corner = [&](std::uint64_t i) { return (*dataset.tetrahedra)[i / 4][i % 4]; };
    if (const Status written = writeArray<std::int64_t>(out, 4 * cells, corner); !written)
        return written;
    const auto end = [](std::uint64_t cell) { return 4 * (cell + 1); };
    if (const Status written = writeArray<std::int64_t>(out, cells, end); !written)
        return written;
    return writeArray<std::uint8_t>(out, cells, [](std::uint64_t) { return vtkTetra; });
}

} // namespace

std::vector<std::string> VtuWriter::nameFilters() const
{
    return {Message::marked("VTK unstructured grid (*.vtu)")};
}

double VtuWriter::score(const std::filesystem::path& path) const
{
    const std::string name = path.extension().string();
    return name == ".vtu" || name == ".VTU" ? 1 : 0;
}

std::vector<Parameter> VtuWriter::parameters() const
{
    return {};
}

Status VtuWriter::write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& /*values*/,
                        const Progress& progress) const
try {
    if (!dataset.tetrahedra || !dataset.positions)
        return Error{ErrorKind::WrongUsage,
                     Message::say("A .vtu file holds a mesh of tetrahedra, which this dataset is not. Write lattices "
                                  "as .nrrd, curvilinear grids as .xyz, points as .csv.")};
    const bool floats = fitFloats(*dataset.positions);
    constexpr std::uint64_t bytesOfPoint = 28, bytesOfCell = 41;
    auto out = MeshOutput::create(path, bytesOfPoint * dataset.pointCount() + bytesOfCell * dataset.tetrahedra->size(),
                                  "Writing", progress);
    if (!out)
        return out.error();
    if (const Status written = out->text(headOf(dataset, floats)); !written)
        return written;
    if (const Status written = writeArrays(*out, dataset, floats); !written)
        return written;
    if (const Status written = out->text("\n</AppendedData>\n</VTKFile>\n"); !written)
        return written;
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact;
    return out->commit();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, Message::say("Not enough memory to write the file. Close other programs.")};
}

} // namespace tetra
