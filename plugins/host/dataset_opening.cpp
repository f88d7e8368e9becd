// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dataset_opening.h"

#include "plugins/host/input_file.h"
#include "plugins/host/packed_file.h"
#include "plugins/host/parameter_values.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace tetra {
namespace {

/// What others make and people try to open; each is told by its beginning or by its ending.
struct OtherKind {
    std::string_view begins;
    std::string_view ending;
    bool isSurface; ///< else a picture
};
constexpr std::array otherKinds{OtherKind{"\x89PNG", ".png", false}, OtherKind{"\xff\xd8\xff", ".jpg", false},
                                OtherKind{"GIF8", ".gif", false},    OtherKind{"BM", ".bmp", false},
                                OtherKind{"solid ", ".stl", true},   OtherKind{"ply\n", ".ply", true},
                                OtherKind{"ply\r\n", ".ply", true},  OtherKind{"glTF", ".glb", true},
                                OtherKind{"OFF\n", ".off", true},    OtherKind{"", ".obj", true}};

const OtherKind* otherKind(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const auto isIt = [&](const OtherKind& kind) {
        return ending == kind.ending || (kind.begins.size() > 2 && text.starts_with(kind.begins));
    };
    const auto* found = std::ranges::find_if(otherKinds, isIt);
    return found == otherKinds.end() ? nullptr : found;
}

/// Its meshes and fields have names without an ending, and a head behind comments.
bool isOfOpenFoam(std::span<const std::byte> bytes)
{
    constexpr std::size_t looked = 4096;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min(looked, bytes.size()));
    const std::size_t head = text.find("FoamFile");
    return head != std::string_view::npos && text.find('{', head) != std::string_view::npos &&
           text.find("object", head) != std::string_view::npos;
}

/// What volumes are kept in that no reader here knows, by the ending, and the way to a format that is read.
struct OtherVolume {
    std::string_view ending;
    MarkedText what;
    MarkedText way;
};
constexpr std::array otherVolumes{
    OtherVolume{".mnc", Message::marked("a MINC volume"),
                Message::marked("Convert it to NIfTI, with 'mnc2nii' of the MINC tools.")},
    OtherVolume{".mgz", Message::marked("a volume of FreeSurfer"),
                Message::marked("Convert it to NIfTI, with 'mri_convert' of FreeSurfer.")},
    OtherVolume{".mgh", Message::marked("a volume of FreeSurfer"),
                Message::marked("Convert it to NIfTI, with 'mri_convert' of FreeSurfer.")},
    OtherVolume{".fld", Message::marked("an AVS field"),
                Message::marked("Save it as VTK or NRRD in a program that reads it, or write an NRRD header (.nhdr) "
                                "that names the numbers of a uniform one as its data file.")},
    OtherVolume{".vdb", Message::marked("an OpenVDB volume"),
                Message::marked("Sample it on a regular grid, and save that as VTK, NRRD or a NumPy array.")},
    OtherVolume{".am", Message::marked("an Amira file"), Message::marked("Export it from Amira as NRRD or VTK.")},
    OtherVolume{".mat", Message::marked("a MATLAB file older than version 7.3"),
                Message::marked("Save the array with the option '-v7.3', or as NIfTI, by niftiwrite().")},
    OtherVolume{".czi", Message::marked("a microscope's own file"),
                Message::marked("Export it as OME-TIFF, with Fiji or the microscope's program.")},
    OtherVolume{".lif", Message::marked("a microscope's own file"),
                Message::marked("Export it as OME-TIFF, with Fiji or the microscope's program.")},
    OtherVolume{".nd2", Message::marked("a microscope's own file"),
                Message::marked("Export it as OME-TIFF, with Fiji or the microscope's program.")},
    OtherVolume{".oib", Message::marked("a microscope's own file"),
                Message::marked("Export it as OME-TIFF, with Fiji or the microscope's program.")},
};

/// One of each kind of files, as many as a sentence holds: ".nrrd, .vti, .csv".
std::string readEndings(PluginHost& host)
{
    constexpr std::size_t mostEndings = 22;
    std::string text;
    std::set<std::string> told;
    for (const std::string& filter : readableFiles(host))
        if (const auto start = filter.find("*."); start != std::string::npos) {
            const std::string ending = filter.substr(start + 1, filter.find_first_of(" )", start) - start - 1);
            if (told.size() < mostEndings && told.insert(ending).second)
                text += (text.empty() ? "" : ", ") + ending;
        }
    return text;
}

Error noneReads(PluginHost& host, const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    if (const OtherKind* kind = otherKind(path, bytes))
        return {ErrorKind::BadInput,
                kind->isSurface
                    ? Message::say(
                          "'%1' holds a surface. TAn reads volumes: values throughout a body, not only on its surface.",
                          path.string())
                    : Message::say("'%1' is a picture. TAn reads volumes, including stacks of TIFF pictures, and opens "
                                   "pictures that it has saved with their session.",
                                   path.string()),
                path};
    if (const std::string program = unpackingProgram(bytes); !program.empty())
        return {ErrorKind::BadInput,
                Message::say("'%1' is an archive. Unpack it first, with '%2', and open what is in it.", path.string(),
                             program),
                path};
    if (const auto* other = std::ranges::find(otherVolumes, fileEnding(path), &OtherVolume::ending);
        other != otherVolumes.end())
        return {
            ErrorKind::BadInput,
            Message::say("By its name '%1' is %2, which TAn does not read. %3", path.string(), other->what, other->way),
            path};
    if (isOfOpenFoam(bytes))
        return {ErrorKind::BadInput,
                Message::say("'%1' is a file of an OpenFOAM case, which is opened as a whole: open "
                             "'system/controlDict' in its folder, or an empty file there whose name ends in '.foam'.%2",
                             path.string(), host.explainMissing(PluginKind::Reader)),
                path};
    return {ErrorKind::BadInput,
            Message::say("'%1' has an unknown format. %2%3", path.string(),
                         host.readers().empty()
                             ? Message::say("No reader is installed.")
                             : Message::say("TAn reads files such as %1; the manual lists all of them. "
                                            "Samples alone, without a header, are read as a raw file.",
                                            readEndings(host)),
                         host.explainMissing(PluginKind::Reader)),
            path};
}

/// The reader with the highest score for a file of this name that begins so; none if no plugin is set.
Provided<Reader> bestReader(PluginHost& host, const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    Provided<Reader> best;
    double bestScore = 0;
    for (auto& reader : host.readers())
        if (const double score = reader.plugin->score(path, bytes); score > bestScore) {
            bestScore = score;
            best = std::move(reader);
        }
    return best;
}

/// Whether what has no bytes of its own is one of the reader's all the same, which then is certain of it: an empty file
/// whose name stands for files beside it, a folder in which it knows files.
bool takesWithoutBytes(const Reader& reader, const std::filesystem::path& path)
{
    constexpr double certain = 1;
    return reader.score(path, {}) >= certain;
}

bool isFolder(const std::filesystem::path& path)
{
    std::error_code problem;
    return std::filesystem::is_directory(path, problem);
}

/// The first bytes of a file; none of a folder that the reader takes as a whole.
Result<Buffer<std::byte>> bytesFor(const Reader& reader, const std::filesystem::path& path)
{
    return isFolder(path) && takesWithoutBytes(reader, path) ? Buffer<std::byte>() : firstBytesOf(path);
}

/// What a reader is given: the file and its parameters, or others where it or its companion had to be unpacked.
struct ReadableFile {
    std::filesystem::path path;
    ParameterValues values;
    std::optional<UnpackedFiles> unpacked;
    std::vector<std::pair<std::filesystem::path, std::filesystem::path>> names; ///< of unpacked files, and the user's
};

bool isFile(const std::filesystem::path& path)
{
    std::error_code problem;
    return std::filesystem::is_regular_file(path, problem);
}

/// The name with ".gz", if there is such a file and it is packed.
std::filesystem::path packedFileOf(std::filesystem::path path)
{
    path += ".gz";
    const auto bytes = isFile(path) ? firstBytesOf(path) : Buffer<std::byte>();
    return bytes && isPackedByGzip(*bytes) ? path : std::filesystem::path();
}

/// Unpacks the other file that a reader needs if that is packed; if the file itself was, links it beside that.
Status addCompanion(const Reader& reader, const std::filesystem::path& path, ReadableFile& file,
                    const Progress& progress)
{
    const auto names = reader.companions(file.path, file.values);
    // Beside the file that the user opened, under the name that the reader looks for.
    const auto original = [&](const std::filesystem::path& name) {
        return name.parent_path() == file.path.parent_path() ? path.parent_path() / name.filename() : name;
    };
    auto found = std::ranges::find_if(names, [&](const auto& name) { return isFile(original(name)); });
    const bool isPacked = found == names.end();
    if (isPacked)
        found = std::ranges::find_if(names, [&](const auto& name) { return !packedFileOf(original(name)).empty(); });
    if (found == names.end() || (!isPacked && (!file.unpacked || original(*found) == *found)))
        return {};
    if (!file.unpacked) {
        auto folder = UnpackedFiles::make(path);
        if (!folder)
            return folder.error();
        const auto link = folder->link(path, path.filename());
        if (!link)
            return link.error();
        file.unpacked = *std::move(folder);
        file.path = *link;
        file.names.emplace_back(*link, path);
    }
    const std::filesystem::path other = isPacked ? packedFileOf(original(*found)) : original(*found);
    const auto placed = isPacked ? file.unpacked->unpack(other, found->filename(), progress)
                                 : file.unpacked->link(other, found->filename());
    if (!placed)
        return placed.error();
    file.names.emplace_back(*placed, other);
    for (auto& [id, value] : file.values) // where the user named it
        if (auto* text = std::get_if<std::string>(&value); text != nullptr && path.parent_path() / *text == other)
            *text = placed->string();
    return {};
}

Result<ReadableFile> readableFile(const Reader& reader, const std::filesystem::path& path,
                                  const ParameterValues& values, const Progress& progress)
{
    const auto bytes = bytesFor(reader, path);
    if (!bytes)
        return bytes.error();
    ReadableFile file{path, values, {}, {}};
    if (isPackedByGzip(*bytes) && reader.score(path, *bytes) == 0) {
        auto folder = UnpackedFiles::make(path);
        if (!folder)
            return folder.error();
        const auto unpacked = folder->unpack(path, unpackedName(path).filename(), progress.part(0, 0.5));
        if (!unpacked)
            return unpacked.error();
        file.unpacked = *std::move(folder);
        file.path = *unpacked;
        file.names.emplace_back(*unpacked, path);
    }
    if (const Status added = addCompanion(reader, path, file, progress.part(0.5, 1)); !added)
        return added.error();
    return file;
}

/// The message with `to` wherever one of its arguments says `from`.
Message renamed(const Message& message, const std::string& from, const std::string& to)
{
    if (message.sentence().empty()) {
        std::string text = message.text();
        for (auto place = text.find(from); place != std::string::npos; place = text.find(from, place + to.size()))
            text.replace(place, from.size(), to);
        return text;
    }
    std::vector<Message> arguments;
    for (const Message& argument : message.arguments())
        arguments.push_back(renamed(argument, from, to));
    return Message::of(message.sentence(), std::move(arguments));
}

/// An error that names the files as the user does.
Error inPackedFile(Error error, const ReadableFile& file)
{
    if (!file.unpacked)
        return error;
    for (const auto& [unpacked, original] : file.names) {
        error.message = renamed(error.message, unpacked.string(), original.string());
        if (error.file == unpacked)
            error.file = original;
    }
    if (error.kind == ErrorKind::BadInput)
        error.message = Message::say(
            "%1 (It was unpacked on its own. If it refers to other files, unpack it next to them: gunzip.)",
            error.message);
    return error;
}

/// The reader, if the values are among its parameters.
Result<Provided<Reader>> readerFor(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options)
{
    auto reader = chooseReader(host, path, options.reader);
    if (!reader)
        return reader;
    const Status known =
        checkParameterValues(Message::say("reader '%1'", reader->id), reader->plugin->parameters(), options.values);
    return known ? reader : known.error();
}

} // namespace

std::vector<std::string> readableFiles(PluginHost& host)
{
    std::vector<std::string> filters;
    for (const auto& reader : host.readers())
        for (std::string& filter : reader.plugin->nameFilters())
            filters.push_back(std::move(filter));
    return filters;
}

Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path)
{
    if (isFolder(path))
        if (auto whole = bestReader(host, path, {}); whole.plugin != nullptr && takesWithoutBytes(*whole.plugin, path))
            return whole;
    const auto bytes = firstBytesOf(path);
    if (!bytes)
        return bytes.error();
    if (isModelFile(path))
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' is a TAn model, but a dataset is needed here: the file that the model was built from.",
                         path.string()),
            path};
    Provided<Reader> best = bestReader(host, path, *bytes);
    if (bytes->empty() && (best.plugin == nullptr || !takesWithoutBytes(*best.plugin, path)))
        return emptyFile(path);
    if (best.plugin == nullptr && isPackedByGzip(*bytes)) {
        const auto inside = firstUnpackedBytes(path);
        if (!inside)
            return inside.error();
        best = bestReader(host, unpackedName(path), *inside);
    }
    if (best.plugin == nullptr)
        return noneReads(host, path, *bytes);
    return best;
}

Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path,
                                      const std::optional<std::string>& id)
{
    if (!id)
        return chooseReader(host, path);
    auto reader = host.reader(*id);
    const auto bytes = reader ? bytesFor(*reader->plugin, path) : firstBytesOf(path);
    if (!bytes)
        return bytes.error();
    if (reader && bytes->empty() && !takesWithoutBytes(*reader->plugin, path))
        return emptyFile(path);
    return reader;
}

Result<Dataset> openDataset(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                            const Progress& progress)
{
    const auto reader = readerFor(host, path, options);
    if (!reader)
        return reader.error();
    constexpr double unpackEnd = 0.3;
    const auto file = readableFile(*reader->plugin, path, options.values, progress.part(0, unpackEnd));
    if (!file)
        return file.error();
    const double readBegin = file->unpacked ? unpackEnd : 0;
    constexpr double readEnd = 0.7, partEnd = 0.8, holesEnd = 0.9;
    const Progress reading = progress.part(readBegin, readEnd);
    auto whole = options.part.region
                     ? reader->plugin->readAround(*options.part.region, file->path, file->values, reading)
                     : reader->plugin->read(file->path, file->values, reading);
    if (!whole)
        return inPackedFile(whole.error(), *file);
    if (file->unpacked)
        whole->source.path = path;
    const auto part = takePart(*whole, options.part, progress.part(readEnd, partEnd));
    if (!part)
        return part.error();
    auto dataset = withHoles(*part, progress.part(partEnd, holesEnd));
    if (!dataset && dataset.error().kind != ErrorKind::Cancelled)
        return Error{dataset.error().kind, Message::say("Cannot read '%1': %2", path.string(), dataset.error().message),
                     path};
    if (dataset && dataset->domain == DomainClass::Curvilinear) // cells were looked at when they became a mesh
        dataset->convex = hasConvexDomain(*dataset);
    if (dataset) // what has no value has no logarithm either: it is a hole by now
        dataset = scaled(*dataset, options.scale, progress.part(holesEnd, 1));
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

Result<FileContents> probeDataset(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                                  const Progress& progress)
{
    const auto reader = readerFor(host, path, options);
    if (!reader)
        return reader.error();
    const auto file = readableFile(*reader->plugin, path, options.values, progress);
    if (!file)
        return file.error();
    const auto contents = reader->plugin->probe(file->path, file->values, progress);
    return contents ? contents : inPackedFile(contents.error(), *file);
}

} // namespace tetra
