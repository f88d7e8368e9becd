// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nifti/nifti_volume.h"

#include "plugins/readers/lattice/nifti/nifti_header.h"
#include "plugins/readers/lattice/nifti/nifti_place.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {

namespace {

namespace fs = std::filesystem;

struct NiftiType {
    std::int32_t code;
    StoredType type;
    std::uint32_t components;
};

constexpr std::array<NiftiType, 14> niftiTypes = {{{2, StoredType::UInt8, 1},
                                                   {4, StoredType::Int16, 1},
                                                   {8, StoredType::Int32, 1},
                                                   {16, StoredType::Float32, 1},
                                                   {32, StoredType::Float32, 2}, // complex
                                                   {64, StoredType::Float64, 1},
                                                   {128, StoredType::UInt8, 3}, // red, green, blue
                                                   {256, StoredType::Int8, 1},
                                                   {512, StoredType::UInt16, 1},
                                                   {768, StoredType::UInt32, 1},
                                                   {1024, StoredType::Int64, 1},
                                                   {1280, StoredType::UInt64, 1},
                                                   {1792, StoredType::Float64, 2}, // complex
                                                   {2304, StoredType::UInt8, 4}}};

Status setType(const NiftiHeader& header, StoredVolume& volume)
{
    constexpr std::int32_t bits = 1, floats128 = 1536, complex256 = 2048;
    if (const auto* const found = std::ranges::find(niftiTypes, header.datatype, &NiftiType::code);
        found != niftiTypes.end()) {
        volume.type = found->type;
        volume.components = found->components;
        return {};
    }
    if (header.datatype == floats128 || header.datatype == complex256)
        return Error{ErrorKind::BadInput,
                     Message::say("its samples are floating-point numbers of 128 bits, which are not read: their "
                                  "layout differs from machine to machine. Write them with 64 bits.")};
    if (header.datatype == bits)
        return Error{ErrorKind::BadInput,
                     Message::say("its samples are single bits, which are not read. Write them as bytes.")};
    return Error{ErrorKind::BadInput, Message::say("its samples are of the type %1, which NIfTI does not define. The "
                                                   "file is damaged: copy or export it again.",
                                                   header.datatype)};
}

/// One for those that the header does not have.
Result<std::array<std::uint64_t, 7>> sizesOf(const NiftiHeader& header)
{
    std::array<std::uint64_t, 7> sizes{1, 1, 1, 1, 1, 1, 1};
    const std::int64_t dimensions = header.dim[0];
    if (dimensions < 1 || dimensions > 7)
        return Error{
            ErrorKind::BadInput,
            Message::say("its header claims %1 dimensions. It is damaged: copy or export it again.", dimensions)};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
        const std::int64_t points = header.dim[axis + 1];
        if (points < 0 || (points == 0 && axis < 3))
            return Error{
                ErrorKind::BadInput,
                Message::say(
                    "its header claims %1 points along its dimension %2. It is damaged: copy or export it again.",
                    points, axis + 1)};
        sizes[axis] = static_cast<std::uint64_t>(std::max<std::int64_t>(1, points));
    }
    return sizes;
}

/// Whether the fifth dimension holds the components of vectors or colours.
bool holdsComponents(const NiftiHeader& header)
{
    constexpr std::array<std::int32_t, 4> intents = {1006, 1007, 2003, 2004}; // displacement, vector, RGB, RGBA
    return std::ranges::find(intents, header.intent) != intents.end();
}

/// Where the samples that are wanted stand among all.
Status setLayout(const NiftiHeader& header, const ParameterValues& values, StoredVolume& volume)
{
    const auto sizes = sizesOf(header);
    if (!sizes)
        return sizes.error();
    const auto& [x, y, z, t, fifth, sixth, seventh] = *sizes;
    const bool hasVectors = holdsComponents(header) && fifth > 1 && fifth <= 1'000'000 && volume.components == 1;
    std::uint64_t steps = cappedProduct(cappedProduct(t, hasVectors ? 1 : fifth), cappedProduct(sixth, seventh));
    if (hasVectors)
        volume.components = static_cast<std::uint32_t>(fifth);
    if (const Status fits = setStoredSize(volume, {x, y, z}, steps); !fits)
        return fits;
    const std::uint64_t points = volume.lattice.pointCount();
    setStrides(volume, hasVectors ? 1 : volume.components, false);
    volume.componentStride = hasVectors ? points * t : 1;
    if (hasVectors && sixth * seventh > 1) {
        volume.leftOut.push_back(Message::say("It holds %1 times as many samples along its last dimensions; the first "
                                              "were read.",
                                              sixth * seventh));
        steps = t;
    }
    if (const Status taken = takeComponent(volume, values); !taken)
        return taken;
    const double between = header.pixdim[4];
    const bool tellsTimes = between > 0 && std::isfinite(between) && std::isfinite(header.timeOffset);
    for (std::uint64_t step = 0; tellsTimes && steps > 1 && steps <= mostTimes && step < steps; ++step)
        volume.timeSteps.push_back(header.timeOffset + static_cast<double>(step) * between);
    return takeTimeStep(volume, values, steps, points * volume.strides[0]);
}

/// As it stands there: in single precision but in the second version.
std::string numberText(const NiftiHeader& header, double number)
{
    return header.version == NiftiVersion::Two ? formatNumber(number) : formatNumber(static_cast<float>(number));
}

/// Numbers are what the header makes of them: slope and intercept, unless the slope is 0 or either is no number.
void setScale(const NiftiHeader& header, StoredVolume& volume)
{
    const bool isColour = volume.type == StoredType::UInt8 && volume.strides[0] > 1;
    if (header.slope == 0 || !std::isfinite(header.slope) || isColour)
        return;
    volume.slope = header.slope;
    volume.intercept = std::isfinite(header.intercept) ? header.intercept : 0;
    if (volume.isScaled())
        volume.remarks.push_back(
            header.version == NiftiVersion::Analyze
                ? Message::say(
                      "The samples were multiplied by %1, which SPM stores in the header's first unused field.",
                      numberText(header, volume.slope))
                : Message::say(
                      "The samples were multiplied by %1, and %2 was added, as the header of the file requires.",
                      numberText(header, volume.slope), numberText(header, volume.intercept)));
}

/// Behind the header and its extensions, or in the file of samples.
Status setPlaceInFile(const NiftiHeader& header, const std::filesystem::path& path, StoredVolume& volume)
{
    constexpr double most = 9e15;
    const double leastBehindHeader = header.version == NiftiVersion::Two ? 544 : 352;
    const double least =
        header.isPair ? 0 : leastBehindHeader - 4; // the four bytes that say whether there are extensions
    double offset = header.dataOffset;
    if (offset == 0 && !header.isPair)
        offset = leastBehindHeader;
    if (!(offset >= least && offset <= most) || offset != std::floor(offset))
        return Error{ErrorKind::BadInput, Message::say("its header states that its samples begin at byte %1, which is "
                                                       "impossible. It is damaged: copy or export it again.",
                                                       formatNumber(offset))};
    volume.offset = static_cast<std::uint64_t>(offset);
    volume.files = {{path}};
    if (!header.isPair)
        return {};
    const auto partners = niftiPartners(path);
    std::error_code ignored;
    const auto found = std::ranges::find_if(
        partners, [&](const std::filesystem::path& name) { return std::filesystem::exists(name, ignored); });
    if (found == partners.end())
        return Error{ErrorKind::BadInput, Message::say("its samples are in a file '%1', which is missing. Copy it into "
                                                       "the same folder: the two belong together.",
                                                       printable(partners.front().filename().string()))};
    volume.files = {{*found}};
    return {};
}

} // namespace

bool isNiftiHeader(const fs::path& path, std::span<const std::byte> firstBytes)
{
    return looksLikeNifti(firstBytes) || (fileEnding(path) == ".hdr" && looksLikeAnalyze(firstBytes));
}

fs::path niftiHeaderBeside(const fs::path& path, std::span<const std::byte> firstBytes)
{
    if (fileEnding(path) != ".img" || isNiftiHeader(path, firstBytes))
        return {};
    for (const fs::path& name : niftiPartners(path)) {
        std::error_code ignored;
        if (!fs::is_regular_file(name, ignored))
            continue;
        const auto file = MappedFile::open(name);
        if (file && isNiftiHeader(name, (*file)->bytes()))
            return name;
    }
    return {};
}

Result<StoredVolume> niftiVolume(const VolumeRequest& request)
{
    const auto header = parseNiftiHeader(request.file->bytes());
    if (!header)
        return header.error();
    StoredVolume volume;
    volume.order = header->order;
    if (const Status known = setType(*header, volume); !known)
        return known.error();
    if (const Status known = setLayout(*header, request.values, volume); !known)
        return known.error();
    setScale(*header, volume);
    placeNifti(*header, volume);
    if (const Status known = setPlaceInFile(*header, request.path, volume); !known)
        return known.error();
    return volume;
}

std::vector<fs::path> niftiCompanions(const VolumeRequest& request)
{
    const bool isSamples = fileEnding(request.path) == ".img";
    const auto header = parseNiftiHeader(request.file->bytes());
    return isSamples || (header && header->isPair) ? niftiPartners(request.path) : std::vector<fs::path>();
}

} // namespace tetra
