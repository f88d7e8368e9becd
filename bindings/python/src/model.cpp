// SPDX-License-Identifier: GPL-3.0-or-later
// Models: opening them, what they say of themselves, the curve of their sizes, and meshes out of them.
#include "binding.h"
#include "opened_model.h"

#include <tan/packed.h>
#include <tan/version.h>
#include <tan/view.h>

#include <dlfcn.h>

namespace tetra::python {

namespace {

/// A row of Model.levels.
struct LevelRow {
    double error;
    double warping;
    std::uint32_t sites;
    std::uint64_t tetrahedra;
};

std::shared_ptr<OpenedModel> openPlace(const std::string& place, std::optional<double> error, const std::string& token,
                                       const std::string& cacheFolder, const py::object& progress)
{
    OpenOptions options;
    if (error)
        options.accuracy = Accuracy{.error = *error, .warping = anyWarping};
    options.token = token;
    options.cacheFolder = cacheFolder;
    return std::make_shared<OpenedModel>(
        finished(progress, [&](const Progress& told) { return openModel(place, options, told); }));
}

std::array<std::array<double, 3>, 2> cornersOf(const Eigen::AlignedBox3d& box)
{
    return {{{box.min().x(), box.min().y(), box.min().z()}, {box.max().x(), box.max().y(), box.max().z()}}};
}

std::array<double, 3> numbersOf(const Eigen::Vector3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

py::dict latticeOf(const Lattice& lattice)
{
    py::dict facts;
    facts["size"] = lattice.size;
    facts["spacing"] = numbersOf(lattice.spacing);
    facts["origin"] = numbersOf(lattice.origin);
    std::array<std::array<double, 3>, 3> rows{};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            rows[row][column] = lattice.directions(row, column);
    facts["directions"] = rows;
    return facts;
}

/// What the data's reader, or whoever made the arrays, and the builder said.
py::dict provenanceOf(const ModelDescription& about)
{
    py::dict facts;
    facts["source"] = about.sourceName;
    facts["hash"] = about.sourceHash;
    facts["builder"] = about.builder;
    py::dict parameters;
    for (const auto& [name, value] : about.parameters)
        parameters[py::str(name)] = value;
    facts["parameters"] = parameters;
    py::dict taken;
    py::list guesses, unused;
    for (const Taken& choice : about.taken) {
        taken[py::str(std::string(takenPartName(choice.part)))] = visibleText(choice.what);
        if (choice.guessed)
            guesses.append(std::string(takenPartName(choice.part)));
    }
    for (const Message& sentence : about.leftOut)
        unused.append(visibleText(sentence));
    facts["taken"] = taken;
    facts["guesses"] = guesses;
    facts["unused"] = unused;
    return facts;
}

py::dict descriptionOf(const OpenedModel& opened)
{
    const Model& model = *opened.model();
    const ModelDescription& about = model.description();
    py::dict facts;
    facts["path"] = model.path().string();
    facts["kind"] = std::string(domainClassName(about.domain));
    facts["bounds"] = cornersOf(about.bounds);
    facts["range"] = std::array{about.range.minimum, about.range.maximum};
    facts["type"] = std::string(sampleTypeName(about.sampleType));
    facts["value_name"] = about.valueName;
    facts["length_unit"] = about.lengthUnit;
    facts["space"] = about.space;
    facts["sites"] = opened.found.isWhole ? model.siteCount() : opened.found.sitesOfWhole;
    facts["tetrahedra"] = model.tetrahedronCount();
    facts["file_size"] = model.fileSize();
    facts["is_whole"] = opened.found.isWhole;
    facts["warps"] = about.warpingWeight > 0;
    facts["provenance"] = provenanceOf(about);
    if (isOnLattice(about.domain))
        facts["lattice"] = latticeOf(about.lattice);
    return facts;
}

/// The last sites of all meshes of a prefix that the model tells apart; of older files those where the key falls.
std::vector<std::uint32_t> sizesOfMeshes(const Model& model)
{
    std::vector<std::uint32_t> sizes;
    if (!model.batchEnds().empty()) {
        for (const std::uint32_t last : model.batchEnds())
            sizes.push_back(last + 1);
        return sizes;
    }
    const auto keys = model.runningKeys();
    for (std::uint32_t next = 1; next < model.siteCount(); ++next)
        if (keys[next] < keys[next - 1])
            sizes.push_back(next);
    sizes.push_back(model.siteCount());
    return sizes;
}

/// Those of a step of sites in which something changes: as many rows as batches, coarse first.
Result<Buffer<LevelRow>> levelsOf(const Model& model, const Progress& progress)
{
    Buffer<LevelRow> rows;
    if (const Status sound = model.checkPrefix(model.siteCount(), Model::Batches, progress); !sound)
        return sound.error();
    for (const std::uint32_t sites : sizesOfMeshes(model)) {
        if (rows.size() % 65536 == 0 && progress.cancelled())
            return cancelledError("Listing levels");
        const MeshSize size = meshSizeOf(model, sites);
        rows.push_back({size.error, size.warping, size.sites, size.tetrahedra});
    }
    if (const Status intact = model.confirm(progress); !intact)
        return intact.error();
    return rows;
}

py::array levelArray(const OpenedModel& opened, const py::object& progress)
{
    const auto rows = std::make_shared<const Buffer<LevelRow>>(
        finished(progress, [&](const Progress& told) { return levelsOf(*opened.model(), told); }));
    return viewOf<LevelRow>(rows->data(), {static_cast<py::ssize_t>(rows->size())}, rows);
}

/// A query as Python gives it: fields as texts, everything else as numbers.
struct QueryOptions {
    std::string error;
    std::string warping;
    std::optional<std::uint64_t> budget;
    std::vector<std::array<double, 2>> values;
    std::optional<std::array<std::array<double, 3>, 2>> window;
    std::string border;
    std::string method;
};

MeshQuery queryOf(const QueryOptions& options)
{
    using enum WindowBorder;
    using enum VariableMethod;
    constexpr std::array<std::pair<std::string_view, WindowBorder>, 3> borders{
        {{"intersecting", Intersecting}, {"contained", Contained}, {"clipped", Clipped}}};
    constexpr std::array<std::pair<std::string_view, VariableMethod>, 3> methods{
        {{"automatic", Automatic}, {"closed-set", ClosedSet}, {"insertion", Insertion}}};
    MeshQuery query;
    query.error = valueOf(parseErrorField(options.error));
    query.warping = valueOf(parseErrorField(options.warping));
    query.budget = options.budget;
    for (const auto& [least, largest] : options.values)
        query.values.push_back({least, largest});
    const WindowBorder border = choice("border", options.border, borders);
    if (options.window)
        query.window = Window{{Eigen::Vector3d((*options.window)[0].data()), //
                               Eigen::Vector3d((*options.window)[1].data())},
                              border};
    query.method = choice("method", options.method, methods);
    return query;
}

std::shared_ptr<MeshOfModel> extract(OpenedModel& opened, const QueryOptions& options, const py::object& progress)
{
    const MeshQuery query = queryOf(options);
    auto mesh = std::make_shared<MeshOfModel>();
    mesh->extracted = finished(progress, [&](const Progress& told) -> Result<std::shared_ptr<const ExtractedMesh>> {
        const auto lock = locked(opened.extracting, told);
        if (!lock)
            return cancelledError("Extracting");
        auto extracted = opened.extractor.extract(query, told);
        if (!extracted)
            return extracted;
        if (const Status intact = opened.model()->confirm(told); !intact)
            return intact.error();
        return extracted;
    });
    return mesh;
}

/// How large a mesh is: sites, tetrahedra, error, warping.
py::tuple sizeTuple(const MeshSize& size)
{
    return py::make_tuple(size.sites, size.tetrahedra, size.error, size.warping);
}

py::tuple sizeAt(const OpenedModel& opened, double error, double warping, std::optional<std::uint64_t> budget)
{
    const Accuracy asked{.error = error, .warping = warping};
    const MeshSize size =
        budget ? valueOf(meshSizeWithin(*opened.model(), asked, *budget)) : meshSizeAt(*opened.model(), asked);
    valueOf(opened.model()->checkIntact());
    return sizeTuple(size);
}

/// Writes a copy of a model that lies anywhere. How many sites and bytes it has.
py::tuple copy(const std::string& place, std::optional<double> error, const std::string& output,
               const std::string& token, const py::object& progress)
{
    const auto accuracy = error ? std::optional(Accuracy{.error = *error, .warping = anyWarping}) : std::nullopt;
    const CopyReport report =
        finished(progress, [&](const Progress& told) { return copyModel(place, accuracy, output, told, token); });
    return py::make_tuple(report.sites, report.fileBytes);
}

py::dict pack(const OpenedModel& opened, const std::string& output, const py::object& progress)
{
    const PackReport report =
        finished(progress, [&](const Progress& told) { return packModel(*opened.model(), output, told); });
    py::dict facts;
    facts["method"] = report.method == PackMethod::Replayed ? "replayed" : "stored-by-parts";
    facts["bytes"] = report.fileBytes;
    return facts;
}

std::string versionText()
{
    const LibraryVersion version = libraryVersion();
    return std::to_string(version.major) + '.' + std::to_string(version.minor) + '.' + std::to_string(version.patch);
}

/// The file of the library that is loaded.
std::string libraryFile()
{
    Dl_info found{};
    if (dladdr(reinterpret_cast<const void*>(&libraryVersion), &found) == 0 || found.dli_fname == nullptr) // NOLINT
        return {};
    return found.dli_fname;
}

} // namespace

void bindModels(py::module_& module)
{
    PYBIND11_NUMPY_DTYPE(LevelRow, error, warping, sites, tetrahedra);
    py::class_<QueryOptions>(module, "Query")
        .def(py::init<>())
        .def_readwrite("error", &QueryOptions::error)
        .def_readwrite("warping", &QueryOptions::warping)
        .def_readwrite("budget", &QueryOptions::budget)
        .def_readwrite("values", &QueryOptions::values)
        .def_readwrite("window", &QueryOptions::window)
        .def_readwrite("border", &QueryOptions::border)
        .def_readwrite("method", &QueryOptions::method);
    py::class_<OpenedModel, std::shared_ptr<OpenedModel>>(module, "Model")
        .def("description", &descriptionOf)
        .def("levels", &levelArray)
        .def("size_at", &sizeAt)
        .def("starting_error", [](const OpenedModel& opened) { return startingError(*opened.model()); })
        .def("extract", &extract)
        // With an extractor of its own.
        .def("again", [](const OpenedModel& opened) { return std::make_shared<OpenedModel>(opened.found); })
        .def("pack", &pack);
    module.def("open", &openPlace);
    module.def("copy", &copy);
    module.def("library", &libraryFile);
    module.def("version", &versionText);
}

} // namespace tetra::python
