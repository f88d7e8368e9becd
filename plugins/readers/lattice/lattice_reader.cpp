// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/lattice_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/header_formats.h"
#include "plugins/readers/lattice/nrrd_fields.h"
#include "plugins/readers/lattice/nrrd_layout.h"
#include "plugins/readers/lattice/raw_description.h"
#include "plugins/readers/lattice/raw_guess.h"
#include "plugins/readers/lattice/sample_reading.h"
#include "plugins/readers/lattice/stored_reading.h"
#include "plugins/readers/lattice/stored_volume.h"
#include "plugins/readers/lattice/volume_errors.h"
#include "plugins/readers/lattice/volume_formats.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <optional>
#include <vector>

namespace tetra {

namespace {

namespace fs = std::filesystem;
using File = std::shared_ptr<const MappedFile>;

bool isNrrdName(const fs::path& path)
{
    return extension(path) == ".nrrd" || extension(path) == ".nhdr";
}

/// What the bytes of one or more files are, once it is known how they are to be taken.
struct VolumeFiles {
    std::vector<fs::path> paths; ///< equally many of the samples in each, in their order
    SampleLayout layout;
    File first; ///< is open
    std::size_t headerBytes = 0;
};

/// What the file leaves to the user.
Status placeLayout(const ParameterValues& values, SampleLayout& layout)
{
    const Eigen::Vector3d assumed = layout.lattice.spacing;
    if (const Status placed = placeByUser(values, layout.untold, layout.lattice, layout.lengthUnit); !placed)
        return placed;
    layout.lattice.origin += layout.stepsToOrigin.cwiseProduct(layout.lattice.spacing - assumed);
    std::ranges::move(remarkOnSpacing(values, layout.untold, layout.lattice), std::back_inserter(layout.remarks));
    return checkLatticePlacement(layout.lattice);
}

/// The data files of a detached header, else the header's own file.
Result<VolumeFiles> openNrrd(const fs::path& path, const File& headerFile, const ParameterValues& values)
{
    const Result<NrrdFields> fields = parseNrrdFields(asText(headerFile->bytes()));
    if (!fields)
        return inFile(path, fields.error());
    Result<NrrdLayout> layout = nrrdLayout(*fields);
    if (!layout)
        return inFile(path, layout.error());
    if (const Status placed = placeLayout(values, layout->samples); !placed)
        return inFile(path, placed.error());
    if (layout->dataFiles.empty())
        return VolumeFiles{{path}, layout->samples, headerFile, fields->headerBytes};
    VolumeFiles volume{{}, layout->samples, nullptr, 0};
    for (const std::string& name : layout->dataFiles)
        volume.paths.push_back(path.parent_path() / name);
    const Result<File> first = openVolumeFile(volume.paths.front());
    if (!first)
        return withHeader(path, first.error());
    volume.first = *first;
    return volume;
}

Result<VolumeFiles> openRaw(const fs::path& path, const File& file, const ParameterValues& values)
{
    Result<SampleLayout> layout = rawLayout(values, path.filename().string(), file->bytes().size());
    if (!layout)
        return inFile(path, layout.error());
    if (const Status placed = placeLayout(values, *layout); !placed)
        return inFile(path, placed.error());
    return VolumeFiles{{path}, *layout, file, 0};
}

bool isNrrd(const fs::path& path, const File& file)
{
    return isNrrdName(path) || looksLikeNrrd(asText(file->bytes()));
}

/// The choices among what a file of any format with a header holds.
std::vector<Parameter> allChoices()
{
    std::vector<Parameter> all = choiceParameters();
    for (Parameter& one : volumeParameters())
        if (std::ranges::find(all, one.id, &Parameter::id) == all.end())
            all.push_back(std::move(one));
    return all;
}

/// Of all parameters only those of placement, and of `also`, say something of a file with a header.
Status checkChoices(const fs::path& path, const ParameterValues& values, const std::vector<Parameter>& also)
{
    const std::vector<Parameter> placement = placementParameters(), ofVolumes = allChoices();
    const auto has = [](const std::vector<Parameter>& parameters, const std::string& id) {
        return std::ranges::find(parameters, id, &Parameter::id) != parameters.end();
    };
    for (const auto& [id, value] : values) {
        if (has(placement, id) || has(also, id))
            continue;
        return Error{ErrorKind::WrongUsage,
                     has(ofVolumes, id)
                         ? Message::say("'--%1' chooses among several volumes or components, and '%2' has one number "
                                        "for each point. Leave it out.",
                                        id, path.string())
                         : Message::say("'--%1' describes raw files, and the header of '%2' tells it. Leave it out.",
                                        id, path.string()),
                     path};
    }
    return {};
}

Result<VolumeFiles> openVolume(const fs::path& path, const File& file, const ParameterValues& values)
{
    const bool hasHeader = isNrrd(path, file);
    if (const Status fits = checkChoices(path, values, hasHeader ? std::vector<Parameter>() : rawParameters()); !fits)
        return fits.error();
    return hasHeader ? openNrrd(path, file, values) : openRaw(path, file, values);
}

/// The format of a file that a VolumeDescription describes; null: NRRD, raw, or what a StoredVolume does.
const VolumeFormat* formatOf(const fs::path& path, const File& file)
{
    constexpr std::size_t beginningBytes = 4096;
    double score = 0;
    return isNrrd(path, file) ? nullptr : volumeFormatOf(path, asText(file->bytes()).substr(0, beginningBytes), score);
}

/// Calls `use(request, volume)` with what the header of a file of such a format says.
template <class Value, class Use> Result<Value> withDescription(const VolumeFormat& format, const fs::path& path,
                                                                const File& file, const ParameterValues& values,
                                                                const Use& use)
{
    if (const Status fits = checkChoices(path, values, choiceParameters()); !fits)
        return fits.error();
    const VolumeRequest request{path, file, values};
    auto volume = format.describe(request);
    const Result<Value> made = volume ? use(request, *std::move(volume)) : Result<Value>(volume.error());
    return made || !made.error().file.empty() ? made : inFile(path, made.error());
}

bool isWithin(std::span<const std::byte> bytes, std::span<const std::byte> whole)
{
    return std::less_equal{}(whole.data(), bytes.data()) &&
           std::less_equal{}(bytes.data() + bytes.size(), whole.data() + whole.size());
}

/// Calls `use(bytes)` with the samples of each file as it is opened; the first error ends it.
template <class Use> Status forEachFile(const fs::path& path, const VolumeFiles& volume, const Use& use)
{
    for (const fs::path& name : volume.paths) {
        const Result<File> file = &name == &volume.paths.front() ? Result<File>(volume.first) : openVolumeFile(name);
        if (!file)
            return withHeader(path, file.error());
        const Status used = use((*file)->bytes().subspan(volume.headerBytes));
        if ((*file)->damaged())
            return inFile(name, {ErrorKind::BadInput, Message::say("it changed while it was read. Read it again.")});
        if (!used)
            return inVolume(path, name, used.error());
    }
    return {};
}

Result<ScalarField> samplesOf(const fs::path& path, const VolumeFiles& volume, const Progress& progress)
{
    const SampleLayout& layout = volume.layout;
    if (volume.paths.size() == 1) {
        Result<ScalarField> values = Error{};
        const Status read = forEachFile(path, volume, [&](std::span<const std::byte> bytes) -> Status {
            values = readSamples(bytes, layout, progress, volume.first);
            return values ? Status() : values.error();
        });
        return read ? values : read.error();
    }
    const SampleLayout each = layoutOfEach(layout, volume.paths.size());
    if (const Status whole =
            forEachFile(path, volume, [&](std::span<const std::byte> bytes) { return checkSampleBytes(bytes, each); });
        !whole)
        return whole.error();
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(layout.type, layout.lattice.pointCount());
    if (!samples)
        return inFile(path, samples.error());
    std::span<std::byte> room(samples->get(), layout.sampleBytes());
    std::size_t done = 0;
    const Status read = forEachFile(path, volume, [&](std::span<const std::byte> bytes) {
        const auto files = static_cast<double>(volume.paths.size());
        const Progress part = progress.part(static_cast<double>(done) / files, static_cast<double>(done + 1) / files);
        ++done;
        const auto own = room.first(each.sampleBytes());
        room = room.subspan(own.size());
        return readSamplesInto(own, bytes, each, part);
    });
    return read ? Result<ScalarField>(ScalarField(layout.type, layout.lattice.pointCount(), *std::move(samples)))
                : read.error();
}

Result<Dataset> readDataset(const fs::path& path, const VolumeFiles& volume, const Progress& progress)
{
    const Result<ScalarField> values = samplesOf(path, volume, progress);
    if (!values)
        return values.error();
    Dataset dataset;
    dataset.lattice = volume.layout.lattice;
    dataset.values = *values;
    dataset.space = volume.layout.space;
    dataset.lengthUnit = volume.layout.lengthUnit;
    dataset.remarks = volume.layout.remarks;
    dataset.source = {path.filename().string(), path, 0};
    dataset.source.taken = volume.layout.taken;
    dataset.source.leftOut = volume.layout.leftOut;
    if (isWithin(values->bytes(), volume.first->bytes()))
        dataset.mappedFile = volume.first;
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

/// What a raw file could be that nobody has described yet.
FileContents guessedContents(const fs::path& path, std::uint64_t bytes)
{
    FileContents contents{.domain = DomainClass::RegularLattice, .arrays = {{}}};
    for (const RawGuess& guess : guessRawLayouts(path.filename().string(), bytes))
        contents.suggestions.push_back({{"size", std::to_string(guess.size[0]) + "x" + std::to_string(guess.size[1]) +
                                                     "x" + std::to_string(guess.size[2])},
                                        {"type", std::string(sampleTypeName(guess.type))}});
    return contents;
}

Result<FileContents> contentsOf(const fs::path& path, const VolumeFiles& volume)
{
    const SampleLayout each = layoutOfEach(volume.layout, volume.paths.size());
    if (const Status whole =
            forEachFile(path, volume, [&](std::span<const std::byte> bytes) { return checkSampleBytes(bytes, each); });
        !whole)
        return whole.error();
    return FileContents{.domain = DomainClass::RegularLattice,
                        .lattice = volume.layout.lattice,
                        .points = volume.layout.lattice.pointCount(),
                        .type = volume.layout.type,
                        .arrays = {{}},
                        .taken = volume.layout.taken,
                        .leftOut = volume.layout.leftOut,
                        .untold = volume.layout.untold};
}

constexpr std::array<std::string_view, 6> rawNames = {".raw", ".bin", ".binary", ".dat", ".img", ".vol"};

/// A file of another format with a header; nothing of NRRD and raw files.
Result<std::optional<HeaderFile>> headerOf(const fs::path& path, const File& file)
{
    return isNrrd(path, file) ? Result<std::optional<HeaderFile>>(std::optional<HeaderFile>())
                              : headerFileOf(path, file);
}

/// A volume whose header is of one of those formats, held against its files.
Result<StoredVolume> openStored(const HeaderFile& header, const ParameterValues& values)
{
    if (const Status fits = checkChoices(header.path, values, volumeParameters()); !fits)
        return fits.error();
    auto volume = describedVolume(header, volumeChoice(values));
    if (!volume)
        return inFile(header.path, volume.error());
    if (const Status placed = placeStored(values, *volume); !placed)
        return inFile(header.path, placed.error());
    if (const Status whole = checkStoredFiles(header.path, *volume); !whole)
        return whole.error();
    return volume;
}

Result<Dataset> readStoredFile(const fs::path& path, const HeaderFile& header, const ParameterValues& values,
                               const Progress& progress)
{
    const auto volume = openStored(header, values);
    if (!volume)
        return volume.error();
    auto dataset = readStored(header.path, *volume, progress);
    if (dataset) {
        dataset->source.name = path.filename().string();
        dataset->source.path = path;
    }
    return dataset;
}

} // namespace

std::vector<std::string> LatticeReader::nameFilters() const
{
    std::vector<std::string> filters = {
        Message::marked("NRRD volume (*.nrrd *.nhdr)"), Message::marked("MetaImage (*.mhd *.mha)"),
        Message::marked("NIfTI (*.nii *.hdr)"), Message::marked("MRC and CCP4 maps (*.mrc *.ccp4 *.map)")};
    for (const VolumeFormat& format : volumeFormats())
        filters.emplace_back(format.filter);
    filters.emplace_back(Message::marked("Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)"));
    return filters;
}

double LatticeReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double bySign = 0.95, byNameAlone = 0.8, ofUnknownHeader = 0.2, ofRaw = 0.3;
    if (looksLikeNrrd(asText(firstBytes)))
        return 1;
    if (isNrrdName(path))
        return 0.9; // to say what is wrong with it
    if (formatBySignature(path, firstBytes) != HeaderFormat::None || !pairedHeader(path).empty())
        return bySign;
    if (formatByName(path) != HeaderFormat::None)
        return extension(path) == ".hdr" ? ofUnknownHeader : byNameAlone; // the same
    if (double score = 0; volumeFormatOf(path, asText(firstBytes), score) != nullptr)
        return score;
    return std::ranges::find(rawNames, extension(path)) != rawNames.end() ? ofRaw : 0;
}

std::vector<Parameter> LatticeReader::parameters() const
{
    std::vector<Parameter> parameters = rawParameters();
    std::ranges::move(allChoices(), std::back_inserter(parameters));
    return parameters;
}

Result<Dataset> LatticeReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    const Result<File> file = openVolumeFile(path);
    if (!file)
        return file.error();
    const auto header = headerOf(path, *file);
    if (!header)
        return header.error();
    if (*header)
        return readStoredFile(path, **header, values, progress);
    if (const VolumeFormat* format = formatOf(path, *file))
        return withDescription<Dataset>(*format, path, *file, values,
                                        [&](const VolumeRequest& request, VolumeDescription volume) {
                                            return readVolume(request, std::move(volume), progress);
                                        });
    const Result<VolumeFiles> volume = openVolume(path, *file, values);
    if (!volume)
        return volume.error();
    return readDataset(path, *volume, progress);
}

std::vector<fs::path> LatticeReader::companions(const fs::path& path, const ParameterValues& values) const
{
    const Result<File> file = MappedFile::open(path);
    if (!file)
        return {};
    if (const VolumeFormat* format = formatOf(path, *file))
        return format->companions != nullptr ? format->companions({path, *file, values}) : std::vector<fs::path>();
    if (!isNrrd(path, *file))
        return headerCompanions(path, (*file)->bytes());
    const Result<NrrdFields> fields = parseNrrdFields(asText((*file)->bytes()));
    const Result<NrrdLayout> layout = fields ? nrrdLayout(*fields) : fields.error();
    if (!layout || layout->dataFiles.size() != 1)
        return {};
    return {path.parent_path() / layout->dataFiles.front()};
}

Result<FileContents> LatticeReader::probe(const fs::path& path, const ParameterValues& values,
                                          const Progress& /*progress*/) const
{
    const Result<File> file = openVolumeFile(path);
    if (!file)
        return file.error();
    const auto header = headerOf(path, *file);
    if (!header)
        return header.error();
    if (*header) {
        const auto stored = openStored(**header, values);
        return stored ? Result<FileContents>(storedContents(*stored)) : stored.error();
    }
    if (const VolumeFormat* format = formatOf(path, *file))
        return withDescription<FileContents>(
            *format, path, *file, values,
            [](const VolumeRequest&, const VolumeDescription& volume) { return contentsOf(volume); });
    if (!isNrrd(path, *file) && !describesSize(values))
        return guessedContents(path, (*file)->bytes().size());
    const Result<VolumeFiles> volume = openVolume(path, *file, values);
    if (!volume)
        return volume.error();
    return contentsOf(path, *volume);
}

} // namespace tetra
