// SPDX-License-Identifier: GPL-3.0-or-later
// Every file is read in the same steps: its format is found, which describes what it holds and where; the user places
// it, if it does not say where it lies; the description is held against the files; and the samples are read.
#include "plugins/readers/lattice/lattice_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/arrays/npy_file.h"
#include "plugins/readers/lattice/raw/raw_guess.h"
#include "plugins/readers/lattice/raw/raw_volume.h"
#include "plugins/readers/lattice/stored/stored_reading.h"
#include "plugins/readers/lattice/stored/volume_errors.h"
#include "plugins/readers/lattice/volume_formats.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

namespace tetra {

namespace {

namespace fs = std::filesystem;
using Bytes = std::span<const std::byte>;

/// A file whose format is known, and the one with its header: mostly the same.
struct FormatRequest {
    const VolumeFormat* format;
    VolumeRequest request;
};

Bytes firstBytesOf(Bytes file)
{
    constexpr std::size_t most = 4096; // what score() is given
    return file.first(std::min(most, file.size()));
}

const VolumeFormat* formatOrRaw(const fs::path& path, Bytes file)
{
    double score = 0;
    const VolumeFormat* format = volumeFormatOf(path, firstBytesOf(file), score);
    return format != nullptr ? format : &volumeFormats().back();
}

Result<FormatRequest> openRequest(const fs::path& path, const ParameterValues& values)
{
    const auto file = openVolumeFile(path);
    if (!file)
        return file.error();
    const Bytes bytes = (*file)->bytes();
    const VolumeFormat* format = formatOrRaw(path, bytes);
    const fs::path header = format->header != nullptr ? format->header(path, firstBytesOf(bytes)) : fs::path();
    if (header.empty())
        return FormatRequest{format, {path, *file, values}};
    const auto other = openVolumeFile(header);
    return other ? Result<FormatRequest>(FormatRequest{format, {header, *other, values}}) : other.error();
}

bool hasParameter(const std::vector<Parameter>& parameters, const std::string& id)
{
    return std::ranges::find(parameters, id, &Parameter::id) != parameters.end();
}

/// Of all parameters only those of placement, and of the format, say something of such a file.
Status checkChoices(const fs::path& path, const FormatRequest& file)
{
    for (const auto& [id, value] : file.request.values) {
        if (hasParameter(placementParameters(), id) ||
            std::ranges::find(file.format->choices, id) != file.format->choices.end())
            continue;
        return Error{ErrorKind::WrongUsage,
                     id == npyAxesId
                         ? Message::say("'--%1' says how a NumPy array is indexed, and '%2' is not one. Leave it out.",
                                        id, path.string())
                     : hasParameter(volumeChoices(), id)
                         ? Message::say("'--%1' selects among several volumes or components, and '%2' has one number "
                                        "for each point. Leave it out.",
                                        id, path.string())
                         : Message::say("'--%1' describes raw files, but the header of '%2' states it. Leave it out.",
                                        id, path.string()),
                     path};
    }
    return {};
}

/// What the file holds, placed and held against its files.
Result<StoredVolume> openVolume(const fs::path& path, const FormatRequest& file)
{
    if (const Status fits = checkChoices(path, file); !fits)
        return fits.error();
    const auto& [header, opened, values] = file.request;
    auto volume = file.format->describe(file.request);
    if (!volume)
        return volume.error().file.empty() ? inFile(header, volume.error()) : volume.error();
    if (const Status placed = placeStored(*volume, values); !placed)
        return inFile(header, placed.error());
    if (const Status whole = checkStoredFiles(header, *volume); !whole)
        return whole.error();
    return volume;
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

} // namespace

std::vector<std::string> LatticeReader::nameFilters() const
{
    std::vector<std::string> filters;
    for (const VolumeFormat& format : volumeFormats())
        filters.emplace_back(format.filter);
    return filters;
}

double LatticeReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    double score = 0;
    volumeFormatOf(path, firstBytes, score);
    return score;
}

std::vector<Parameter> LatticeReader::parameters() const
{
    std::vector<Parameter> parameters = rawParameters();
    std::ranges::move(volumeChoices(), std::back_inserter(parameters));
    parameters.push_back(npyAxesParameter());
    return parameters;
}

Result<Dataset> LatticeReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    const auto file = openRequest(path, values);
    const auto volume = file ? openVolume(path, *file) : file.error();
    if (!volume)
        return volume.error();
    auto dataset = readStored(file->request.path, *volume, progress);
    if (dataset) {
        dataset->source.name = path.filename().string();
        dataset->source.path = path;
    }
    return dataset;
}

std::vector<fs::path> LatticeReader::companions(const fs::path& path, const ParameterValues& values) const
{
    const auto file = MappedFile::open(path);
    if (!file)
        return {};
    const VolumeFormat* format = formatOrRaw(path, (*file)->bytes());
    return format->companions != nullptr ? format->companions({path, *file, values}) : std::vector<fs::path>();
}

Result<FileContents> LatticeReader::probe(const fs::path& path, const ParameterValues& values,
                                          const Progress& /*progress*/) const
{
    const auto file = openRequest(path, values);
    if (!file)
        return file.error();
    if (file->format->describe == rawVolume && !describesSize(values))
        return guessedContents(path, file->request.file->bytes().size());
    const auto volume = openVolume(path, *file);
    return volume ? Result<FileContents>(storedContents(*volume)) : volume.error();
}

} // namespace tetra
