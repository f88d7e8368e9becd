// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/lattice_reader.h"

#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/nrrd_fields.h"
#include "plugins/readers/lattice/nrrd_layout.h"
#include "plugins/readers/lattice/raw_description.h"
#include "plugins/readers/lattice/raw_guess.h"
#include "plugins/readers/lattice/sample_reading.h"

#include <algorithm>
#include <array>
#include <functional>

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

/// What a file's bytes are, once it is known how they are to be taken.
struct VolumeFile {
    File file;
    std::size_t headerBytes = 0;
    SampleLayout layout;
};

Result<File> openFile(const fs::path& path)
{
    Result<File> file = MappedFile::open(path);
    if (file && (*file)->bytes().empty())
        return inFile(path, {ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")});
    return file;
}

/// The data file of a detached header, else the header's own file.
Result<VolumeFile> openNrrd(const fs::path& path, const File& headerFile)
{
    const Result<NrrdFields> fields = parseNrrdFields(asText(headerFile->bytes()));
    if (!fields)
        return inFile(path, fields.error());
    const Result<NrrdLayout> layout = nrrdLayout(*fields);
    if (!layout)
        return inFile(path, layout.error());
    if (layout->dataFile.empty())
        return VolumeFile{headerFile, fields->headerBytes, layout->samples};
    const Result<File> dataFile = openFile(path.parent_path() / layout->dataFile);
    if (!dataFile)
        return withHeader(path, dataFile.error());
    return VolumeFile{*dataFile, 0, layout->samples};
}

Result<VolumeFile> openRaw(const fs::path& path, const File& file, const ParameterValues& values)
{
    const Result<SampleLayout> layout = rawLayout(values, path.filename().string(), file->bytes().size());
    if (!layout)
        return inFile(path, layout.error());
    return VolumeFile{file, 0, *layout};
}

bool isNrrd(const fs::path& path, const File& file)
{
    return isNrrdName(path) || looksLikeNrrd(asText(file->bytes()));
}

Result<VolumeFile> openVolume(const fs::path& path, const File& file, const ParameterValues& values)
{
    if (!isNrrd(path, file))
        return openRaw(path, file, values);
    if (!values.empty())
        return Error{ErrorKind::WrongUsage,
                     Message::say("'--%1' describes raw files, and the header of '%2' tells it. Leave it out.",
                                  values.begin()->first, path.string()),
                     path};
    return openNrrd(path, file);
}

bool isWithin(std::span<const std::byte> bytes, std::span<const std::byte> whole)
{
    return std::less_equal{}(whole.data(), bytes.data()) &&
           std::less_equal{}(bytes.data() + bytes.size(), whole.data() + whole.size());
}

Result<Dataset> readDataset(const fs::path& path, const VolumeFile& volume, const Progress& progress)
{
    const std::span<const std::byte> content = volume.file->bytes();
    const Result<ScalarField> values =
        readSamples(content.subspan(volume.headerBytes), volume.layout, progress, volume.file);
    if (volume.file->damaged())
        return inFile(volume.file->path(),
                      {ErrorKind::BadInput, Message::say("it changed while it was read. Read it again.")});
    if (!values) {
        const Error error = inFile(volume.file->path(), values.error());
        return volume.file->path() == path ? error : withHeader(path, error);
    }
    Dataset dataset;
    dataset.lattice = volume.layout.lattice;
    dataset.values = *values;
    dataset.source = {path.filename().string(), path, 0};
    if (isWithin(values->bytes(), content))
        dataset.mappedFile = volume.file;
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

Result<FileContents> contentsOf(const fs::path& path, const VolumeFile& volume)
{
    const Status whole = checkSampleBytes(volume.file->bytes().subspan(volume.headerBytes), volume.layout);
    if (!whole) {
        const Error error = inFile(volume.file->path(), whole.error());
        return volume.file->path() == path ? error : withHeader(path, error);
    }
    return FileContents{.domain = DomainClass::RegularLattice,
                        .lattice = volume.layout.lattice,
                        .points = volume.layout.lattice.pointCount(),
                        .type = volume.layout.type};
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
    const Result<VolumeFile> volume = openVolume(path, *file, values);
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
    if (!layout || layout->dataFile.empty())
        return {};
    return {path.parent_path() / layout->dataFile};
}

Result<FileContents> LatticeReader::probe(const fs::path& path, const ParameterValues& values,
                                          const Progress& /*progress*/) const
{
    const Result<File> file = openFile(path);
    if (!file)
        return file.error();
    if (!isNrrd(path, *file) && !describesSize(values))
        return guessedContents(path, (*file)->bytes().size());
    const Result<VolumeFile> volume = openVolume(path, *file, values);
    if (!volume)
        return volume.error();
    return contentsOf(path, *volume);
}

} // namespace tetra
