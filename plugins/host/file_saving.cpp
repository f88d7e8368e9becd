// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/file_saving.h"

#include "core/base/text.h"
#include "core/mesh/boundary.h"
#include "core/mesh/face_adjacency.h"
#include "plugins/host/parameter_values.h"
#include "plugins/host/safe_output.h"
#include "plugins/host/stream_output.h"

#include <algorithm>
#include <set>

namespace tetra {
namespace {

constexpr MarkedText writingDataset = Message::marked("Writing the dataset");
constexpr MarkedText writingMesh = Message::marked("Writing the mesh");
constexpr MarkedText writingSurfaces = Message::marked("Writing the surfaces");

bool isOfFormat(const FileFormat& format, WrittenContent content, const std::string& ending)
{
    return format.content == content && std::ranges::find(format.endings, ending) != format.endings.end();
}

/// The first writer of such files; none if no plugin is set.
Provided<Writer> findWriter(PluginHost& host, WrittenContent content, const std::filesystem::path& path)
{
    const std::string ending = fileEnding(path);
    for (const auto& writer : host.writers())
        for (const FileFormat& format : writer.plugin->formats())
            if (isOfFormat(format, content, ending))
                return writer;
    return {};
}

/// A mesh goes into formats for surfaces, too.
Provided<Writer> findWriterOrBoundary(PluginHost& host, WrittenContent content, const std::filesystem::path& path)
{
    const auto writer = findWriter(host, content, path);
    return writer.plugin == nullptr && content == WrittenContent::Mesh ? findWriter(host, WrittenContent::Surface, path)
                                                                       : writer;
}

std::set<std::string> endingsOf(PluginHost& host, WrittenContent content)
{
    std::set<std::string> endings;
    for (const auto& writer : host.writers())
        for (const FileFormat& format : writer.plugin->formats())
            if (format.content == content)
                endings.insert(format.endings.begin(), format.endings.end());
    return endings;
}

std::string listed(const std::set<std::string>& endings)
{
    std::string text;
    for (const std::string& ending : endings)
        text += (text.empty() ? "" : ", ") + ending;
    return text;
}

Message whatIsWritable(PluginHost& host, WrittenContent content)
{
    const auto endings = endingsOf(host, content);
    auto ofBoundaries =
        content == WrittenContent::Mesh ? endingsOf(host, WrittenContent::Surface) : std::set<std::string>();
    std::erase_if(ofBoundaries, [&](const std::string& ending) { return endings.contains(ending); });
    if (endings.empty() && ofBoundaries.empty())
        return Message::say("No writer is installed.");
    if (ofBoundaries.empty())
        return Message::say("Choose one of these endings: %1.", listed(endings));
    return Message::say("Choose one of these endings: %1; or, for the mesh's boundary alone, %2.", listed(endings),
                        listed(ofBoundaries));
}

Error noneWrites(PluginHost& host, WrittenContent content, const std::filesystem::path& path)
{
    Message reason = whatIsWritable(host, content);
    if (const Message missing = host.explainMissing(PluginKind::Writer); !missing.empty())
        reason = Message::say("%1%2", reason, missing);
    const std::string name = path.string();
    switch (content) {
    case WrittenContent::Dataset:
        return {ErrorKind::WrongUsage, Message::say("A dataset cannot be written as '%1'. %2", name, reason)};
    case WrittenContent::Mesh:
        return {ErrorKind::WrongUsage, Message::say("A mesh cannot be written as '%1'. %2", name, reason)};
    case WrittenContent::Surface: break;
    }
    return {ErrorKind::WrongUsage, Message::say("Surfaces cannot be written as '%1'. %2", name, reason)};
}

Result<Provided<Writer>> chooseWriter(PluginHost& host, WrittenContent content, const std::filesystem::path& path,
                                      const ParameterValues& values)
{
    auto writer = findWriterOrBoundary(host, content, path);
    if (writer.plugin == nullptr)
        return noneWrites(host, content, path);
    const Status known =
        checkParameterValues(Message::say("writer '%1'", writer.id), writer.plugin->parameters(), values);
    if (!known)
        return known.error();
    return writer;
}

/// Opens the file, has it written and puts it into its place.
template <class Write>
Result<FileRemarks> saveWith(const Destination& to, MarkedText activity, const Progress& progress, Write&& write)
{
    progress.report(0, activity);
    if (to.stream >= 0) {
        StreamOutput out(to.stream, to.path, activity, progress);
        if (const Status written = write(out); !written)
            return written.error();
        if (const Status finished = out.finish(); !finished)
            return finished.error();
        return out.remarks();
    }
    const auto file = SafeOutput::create(to.path, activity, progress);
    if (!file)
        return file.error();
    if (const Status written = write(**file); !written)
        return written.error();
    if (progress.cancelled())
        return cancelledError(activity);
    if (const Status committed = (*file)->commit(); !committed)
        return committed.error();
    return (*file)->remarks();
}

Status checkArrays(const std::vector<NamedArray>& arrays, std::size_t count, const Message& of)
{
    for (const NamedArray& array : arrays)
        if (array.name.empty() || array.size() != count)
            return Error{
                ErrorKind::WrongUsage,
                Message::say("The array '%1' has %2 values for %3 %4: an array needs a name, and one value for each.",
                             array.name, array.size(), count, of)};
    return {};
}

Status misfit(const SurfacePart& part, const Message& what)
{
    return Error{ErrorKind::WrongUsage,
                 Message::say("The surface '%1' has %2, so it cannot be written.", part.name, what)};
}

Status checkPart(const SurfacePart& part, bool normals)
{
    const std::size_t count = part.positions.size();
    const auto* each = std::get_if<std::span<const float>>(&part.values);
    if (part.normals.size() != (normals ? count : 0))
        return misfit(part, Message::say("not one normal for each vertex"));
    if (each != nullptr && each->size() != count)
        return misfit(part, Message::say("not one value for each vertex"));
    if (!part.colours.empty() && part.colours.size() != count)
        return misfit(part, Message::say("not one colour for each vertex"));
    const auto outside = [count](const auto& triangle) { return *std::ranges::max_element(triangle) >= count; };
    if (std::ranges::any_of(part.triangles, outside))
        return misfit(part, Message::say("triangles with vertices that it does not have"));
    return {};
}

// Names of files, of arrays and of what plugins draw can have any bytes. Readers refuse files that are not UTF-8
// (meshio), or hold characters that XML does not know (VTK), so that no writer gets such texts.

MeshFacts visible(MeshFacts facts)
{
    for (auto& [name, fact] : facts) {
        name = visibleText(name);
        if (auto* text = std::get_if<std::string>(&fact))
            *text = visibleText(*text);
    }
    return facts;
}

std::vector<NamedArray> visible(std::vector<NamedArray> arrays)
{
    for (NamedArray& array : arrays)
        array.name = visibleText(array.name);
    return arrays;
}

MeshContent visible(const MeshContent& mesh)
{
    return {mesh.positions, mesh.tetrahedra, visible(mesh.pointArrays), visible(mesh.cellArrays), visible(mesh.facts)};
}

SurfaceContent visible(SurfaceContent surface)
{
    surface.title = visibleText(surface.title);
    surface.valueName = visibleText(surface.valueName);
    for (SurfacePart& part : surface.parts)
        part.name = visibleText(part.name);
    surface.facts = visible(std::move(surface.facts));
    surface.cellArrays = visible(std::move(surface.cellArrays));
    return surface;
}

/// The vertices' first array of floats.
const NamedArray* valuesOf(const MeshContent& content)
{
    for (const NamedArray& array : content.pointArrays)
        if (std::holds_alternative<std::span<const float>>(array.values))
            return &array;
    return nullptr;
}

Result<FileRemarks> saveBoundary(PluginHost& host, const MeshContent& mesh, const Destination& to,
                                 const ParameterValues& values, const Progress& progress)
{
    constexpr double found = 0.4;
    if (mesh.tetrahedra.size() > largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource, Message::say("'%1' would be the boundary of more than 1073741824 "
                                                            "tetrahedra, too many to find it. Write a .vtu file.",
                                                            to.path.string())};
    progress.report(0, writingMesh);
    const BoundaryFaces boundary = boundaryFaces(mesh.positions.size(), mesh.tetrahedra);
    if (progress.cancelled())
        return cancelledError(writingMesh);
    std::vector<Eigen::Vector3d> positions;
    std::vector<float> vertexValues;
    const NamedArray* const array = valuesOf(mesh);
    for (const std::uint32_t vertex : boundary.vertices) {
        positions.push_back(mesh.positions[vertex]);
        if (array != nullptr)
            vertexValues.push_back(std::get<std::span<const float>>(array->values)[vertex]);
    }
    SurfacePart part{.name = "boundary", .positions = positions, .normals = {}, .triangles = boundary.triangles};
    if (array != nullptr)
        part.values = std::span<const float>(vertexValues);
    return saveSurface(host,
                       {"boundary of a tetrahedral mesh", array != nullptr ? array->name : "value", {part}, mesh.facts},
                       to, values, progress.part(found, 1));
}

} // namespace

Result<FileRemarks> saveDataset(PluginHost& host, const Dataset& dataset, const std::filesystem::path& path,
                                const ParameterValues& values, const Progress& progress)
{
    const auto writer = chooseWriter(host, WrittenContent::Dataset, path, values);
    if (!writer)
        return writer.error();
    return saveWith(path, writingDataset, progress, [&](OutputFile& file) {
        const Status written = writer->plugin->writeDataset(dataset, file, values);
        return written ? dataset.checkIntact() : written;
    });
}

Result<FileRemarks> saveMesh(PluginHost& host, const MeshContent& mesh, const Destination& to,
                             const ParameterValues& values, const Progress& progress)
try {
    const auto writer = chooseWriter(host, WrittenContent::Mesh, to.path, values);
    if (!writer)
        return writer.error();
    if (const Status fit = checkArrays(mesh.pointArrays, mesh.positions.size(), Message::marked("vertices")); !fit)
        return fit.error();
    if (const Status fit = checkArrays(mesh.cellArrays, mesh.tetrahedra.size(), Message::marked("tetrahedra")); !fit)
        return fit.error();
    if (isSurfaceFileOnly(host, to.path))
        return saveBoundary(host, mesh, to, values, progress);
    const MeshContent shown = visible(mesh);
    return saveWith(to, writingMesh, progress,
                    [&](OutputFile& file) { return writer->plugin->writeMesh(shown, file, values); });
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 Message::say("Not enough memory to write '%1'. Close other programs.", to.path.string())};
}

Result<FileRemarks> saveSurface(PluginHost& host, const SurfaceContent& surface, const Destination& to,
                                const ParameterValues& values, const Progress& progress)
{
    const auto writer = chooseWriter(host, WrittenContent::Surface, to.path, values);
    if (!writer)
        return writer.error();
    const bool normals = surface.hasNormals();
    for (const SurfacePart& part : surface.parts)
        if (const Status fits = checkPart(part, normals); !fits)
            return fits.error();
    const SurfaceContent shown = visible(surface);
    return saveWith(to, writingSurfaces, progress,
                    [&](OutputFile& file) { return writer->plugin->writeSurface(shown, file, values); });
}

Status checkWritable(PluginHost& host, WrittenContent content, const std::filesystem::path& path,
                     const ParameterValues& values)
{
    const auto writer = chooseWriter(host, content, path, values);
    return writer ? Status() : writer.error();
}

bool isSurfaceFileOnly(PluginHost& host, const std::filesystem::path& path)
{
    return findWriter(host, WrittenContent::Mesh, path).plugin == nullptr &&
           findWriter(host, WrittenContent::Surface, path).plugin != nullptr;
}

std::vector<FileFormat> writableFormats(PluginHost& host, WrittenContent content)
{
    std::vector<FileFormat> formats;
    for (const auto& writer : host.writers())
        for (FileFormat& format : writer.plugin->formats())
            if (format.content == content && !format.endings.empty() &&
                std::ranges::none_of(formats, [&](const FileFormat& other) { return other.endings == format.endings; }))
                formats.push_back(std::move(format));
    std::ranges::sort(formats, {}, &FileFormat::name);
    return formats;
}

std::vector<std::string> writableEndings(PluginHost& host, WrittenContent content)
{
    auto endings = endingsOf(host, content);
    if (content == WrittenContent::Mesh)
        endings.merge(endingsOf(host, WrittenContent::Surface));
    return {endings.begin(), endings.end()};
}

std::vector<Parameter> writerParameters(PluginHost& host, WrittenContent content)
{
    std::vector<Parameter> parameters;
    for (const auto& writer : host.writers()) {
        const auto writes = [&](const FileFormat& format) {
            return format.content == content ||
                   (content == WrittenContent::Mesh && format.content == WrittenContent::Surface);
        };
        if (std::ranges::any_of(writer.plugin->formats(), writes))
            std::ranges::move(writer.plugin->parameters(), std::back_inserter(parameters));
    }
    return parameters;
}

} // namespace tetra
