// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/lattice_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/nrrd_fields.h"
#include "plugins/readers/lattice/nrrd_layout.h"
#include "plugins/readers/lattice/raw_description.h"
#include "plugins/readers/lattice/raw_guess.h"
#include "plugins/readers/lattice/sample_reading.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <vector>

namespace tetra {

namespace {

namespace fs = std::filesystem;
using File = std::shared_ptr<const MappedFile>;

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string extension(const fs::path& path)
{
    return lowerCase(path.extension().string());
}

bool isNrrdName(const fs::path& path)
{
    return extension(path) == ".nrrd" || extension(path) == ".nhdr";
}

/// Of the header or its data file: which of the two is not known to the program.
Error inFile(const fs::path& path, const Error& error)
{
    if (error.kind == ErrorKind::Cancelled || error.kind == ErrorKind::OutOfResource)
        return error;
    return {error.kind, Message::say("Cannot read '%1': %2", path.string(), error.message), path};
}

/// An error in a data file, with the header whose description it does not fit.
Error withHeader(const fs::path& header, Error error)
{
    if (error.kind == ErrorKind::BadInput)
        error.message = Message::say("%1 The header '%2' names it as its data file.", error.message, header.string());
    return error;
}

/// What the bytes of one or more files are, once it is known how they are to be taken.
struct VolumeFiles {
    std::vector<fs::path> paths; ///< equally many of the samples in each, in their order
    SampleLayout layout;
    File first; ///< is open
    std::size_t headerBytes = 0;
};

Result<File> openFile(const fs::path& path)
{
    Result<File> file = MappedFile::open(path);
    if (file && (*file)->bytes().empty())
        return inFile(path, {ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")});
    return file;
}

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
    const Result<File> first = openFile(volume.paths.front());
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

Result<VolumeFiles> openVolume(const fs::path& path, const File& file, const ParameterValues& values)
{
    if (!isNrrd(path, file))
        return openRaw(path, file, values);
    const std::vector<Parameter> ofAll = placementParameters();
    for (const auto& [id, value] : values)
        if (std::ranges::find(ofAll, id, &Parameter::id) == ofAll.end())
            return Error{ErrorKind::WrongUsage,
                         Message::say("'--%1' describes raw files, and the header of '%2' tells it. Leave it out.", id,
                                      path.string()),
                         path};
    return openNrrd(path, file, values);
}

bool isWithin(std::span<const std::byte> bytes, std::span<const std::byte> whole)
{
    return std::less_equal{}(whole.data(), bytes.data()) &&
           std::less_equal{}(bytes.data() + bytes.size(), whole.data() + whole.size());
}

/// An error in a data file of the volume that is opened as `path`.
Error inVolume(const fs::path& path, const fs::path& dataFile, const Error& error)
{
    const Error named = inFile(dataFile, error);
    return dataFile == path ? named : withHeader(path, named);
}

/// Calls `use(bytes)` with the samples of each file as it is opened; the first error ends it.
template <class Use> Status forEachFile(const fs::path& path, const VolumeFiles& volume, const Use& use)
{
    for (const fs::path& name : volume.paths) {
        const Result<File> file = &name == &volume.paths.front() ? Result<File>(volume.first) : openFile(name);
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
    FileContents contents{.domain = DomainClass::RegularLattice};
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
                        .taken = volume.layout.taken,
                        .leftOut = volume.layout.leftOut,
                        .untold = volume.layout.untold};
}

} // namespace

std::vector<std::string> LatticeReader::nameFilters() const
{
    return {Message::marked("NRRD volume (*.nrrd *.nhdr)"),
            Message::marked("Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)")};
}

double LatticeReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr std::array<std::string_view, 6> rawNames = {".raw", ".bin", ".binary", ".dat", ".img", ".vol"};
    if (looksLikeNrrd(asText(firstBytes)))
        return 1;
    if (isNrrdName(path))
        return 0.9; // to say what is wrong with it
    return std::ranges::find(rawNames, extension(path)) != rawNames.end() ? 0.3 : 0;
}

std::vector<Parameter> LatticeReader::parameters() const
{
    return rawParameters();
}

Result<Dataset> LatticeReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    const Result<File> file = openFile(path);
    if (!file)
        return file.error();
    const Result<VolumeFiles> volume = openVolume(path, *file, values);
    if (!volume)
        return volume.error();
    return readDataset(path, *volume, progress);
}

std::vector<fs::path> LatticeReader::companions(const fs::path& path, const ParameterValues& /*values*/) const
{
    const Result<File> file = MappedFile::open(path);
    if (!file || !isNrrd(path, *file))
        return {};
    const Result<NrrdFields> fields = parseNrrdFields(asText((*file)->bytes()));
    const Result<NrrdLayout> layout = fields ? nrrdLayout(*fields) : fields.error();
    if (!layout || layout->dataFiles.size() != 1)
        return {};
    return {path.parent_path() / layout->dataFiles.front()};
}

Result<FileContents> LatticeReader::probe(const fs::path& path, const ParameterValues& values,
                                          const Progress& /*progress*/) const
{
    const Result<File> file = openFile(path);
    if (!file)
        return file.error();
    if (!isNrrd(path, *file) && !describesSize(values))
        return guessedContents(path, (*file)->bytes().size());
    const Result<VolumeFiles> volume = openVolume(path, *file, values);
    if (!volume)
        return volume.error();
    return contentsOf(path, *volume);
}

} // namespace tetra
