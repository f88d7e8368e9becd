// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nifti/nifti_header.h"

#include "plugins/readers/lattice/headers/header_numbers.h"
#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace tetra {

namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t firstSize = 348, secondSize = 540; ///< of the headers, with which they begin

struct Beginning {
    NiftiVersion version = NiftiVersion::One;
    std::endian order = std::endian::little;
    bool isPair = false;
};

bool hasAt(Bytes bytes, std::size_t place, std::string_view text)
{
    return bytes.size() >= place + text.size() &&
           std::ranges::equal(bytes.subspan(place, text.size()), std::as_bytes(std::span(text)));
}

/// By the size that the header begins with, in either byte order, and the letters that NIfTI has; of Analyze by its
/// number of dimensions.
std::optional<Beginning> beginningOf(Bytes bytes)
{
    constexpr std::size_t firstMagic = 344, secondMagic = 4, dimensionsPlace = 40;
    if (bytes.size() < firstSize)
        return std::nullopt;
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const auto size = numberAt<std::int32_t>(bytes, 0, order);
        using namespace std::string_view_literals;
        if (size == static_cast<std::int32_t>(secondSize))
            for (const auto& [magic, isPair] : {std::pair{"n+2\0"sv, false}, {"ni2\0"sv, true}})
                if (hasAt(bytes, secondMagic, magic))
                    return Beginning{NiftiVersion::Two, order, isPair};
        if (size != static_cast<std::int32_t>(firstSize))
            continue;
        for (const auto& [magic, isPair] : {std::pair{"n+1\0"sv, false}, {"ni1\0"sv, true}})
            if (hasAt(bytes, firstMagic, magic))
                return Beginning{NiftiVersion::One, order, isPair};
        if (const auto dimensions = numberAt<std::int16_t>(bytes, dimensionsPlace, order);
            dimensions >= 1 && dimensions <= 7)
            return Beginning{NiftiVersion::Analyze, order, true};
    }
    return std::nullopt;
}

/// Reads numbers one after the other.
class HeaderNumbers {
public:
    HeaderNumbers(Bytes bytes, std::endian order) : bytes_(bytes), order_(order) {}

    template <class T> T at(std::size_t place) const { return numberAt<T>(bytes_, place, order_); }
    template <class T> double real(std::size_t place) const { return static_cast<double>(at<T>(place)); }
    template <class T, class To, std::size_t Count> void all(std::size_t place, std::array<To, Count>& to) const
    {
        for (std::size_t i = 0; i < Count; ++i)
            to[i] = static_cast<To>(at<T>(place + i * sizeof(T)));
    }
    template <class T> Eigen::Vector3d vector(std::size_t place) const
    {
        return {real<T>(place), real<T>(place + sizeof(T)), real<T>(place + 2 * sizeof(T))};
    }
    template <class T> Eigen::Matrix<double, 3, 4> rows(std::size_t place) const
    {
        Eigen::Matrix<double, 3, 4> rows;
        for (Eigen::Index row = 0; row < 3; ++row)
            for (Eigen::Index column = 0; column < 4; ++column)
                rows(row, column) = real<T>(place + static_cast<std::size_t>(4 * row + column) * sizeof(T));
        return rows;
    }

private:
    Bytes bytes_;
    std::endian order_;
};

void readCommon(const HeaderNumbers& numbers, NiftiHeader& header)
{
    numbers.all<std::int16_t>(40, header.dim);
    header.datatype = numbers.at<std::int16_t>(70);
    numbers.all<float>(76, header.pixdim);
    header.dataOffset = numbers.real<float>(108);
    header.slope = numbers.real<float>(112);
}

void readFirst(const HeaderNumbers& numbers, NiftiHeader& header)
{
    readCommon(numbers, header);
    header.intent = numbers.at<std::int16_t>(68);
    header.intercept = numbers.real<float>(116);
    header.units = numbers.at<std::uint8_t>(123);
    header.timeOffset = numbers.real<float>(136);
    header.qformCode = numbers.at<std::int16_t>(252);
    header.sformCode = numbers.at<std::int16_t>(254);
    header.quaternion = numbers.vector<float>(256);
    header.qOffset = numbers.vector<float>(268);
    header.sRows = numbers.rows<float>(280);
}

void readSecond(const HeaderNumbers& numbers, NiftiHeader& header)
{
    header.datatype = numbers.at<std::int16_t>(12);
    numbers.all<std::int64_t>(16, header.dim);
    numbers.all<double>(104, header.pixdim);
    header.dataOffset = static_cast<double>(numbers.at<std::int64_t>(168));
    header.slope = numbers.at<double>(176);
    header.intercept = numbers.at<double>(184);
    header.timeOffset = numbers.at<double>(216);
    header.qformCode = numbers.at<std::int32_t>(344);
    header.sformCode = numbers.at<std::int32_t>(348);
    header.quaternion = numbers.vector<double>(352);
    header.qOffset = numbers.vector<double>(376);
    header.sRows = numbers.rows<double>(400);
    header.units = numbers.at<std::int32_t>(500);
    header.intent = numbers.at<std::int32_t>(504);
}

void readAnalyze(const HeaderNumbers& numbers, Bytes bytes, NiftiHeader& header)
{
    constexpr std::size_t unitPlace = 56, unitLength = 4;
    readCommon(numbers, header);
    const std::string_view unit(reinterpret_cast<const char*>(bytes.data()) + unitPlace, unitLength);
    header.unitName = trimmed(unit.substr(0, unit.find('\0')));
    header.orientation = numbers.at<std::uint8_t>(252);
    numbers.all<std::int16_t>(253, header.originator);
}

} // namespace

bool looksLikeNifti(std::span<const std::byte> firstBytes)
{
    const auto beginning = beginningOf(firstBytes);
    return beginning && beginning->version != NiftiVersion::Analyze;
}

bool looksLikeAnalyze(std::span<const std::byte> firstBytes)
{
    const auto beginning = beginningOf(firstBytes);
    return beginning && beginning->version == NiftiVersion::Analyze;
}

Result<NiftiHeader> parseNiftiHeader(std::span<const std::byte> file)
{
    const auto beginning = beginningOf(file);
    const std::size_t size = beginning && beginning->version == NiftiVersion::Two ? secondSize : firstSize;
    if (!beginning && file.size() >= firstSize)
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "it does not begin like a header of NIfTI or Analyze 7.5. It is of another format, or damaged.")};
    if (file.size() < size)
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 bytes, and a header of NIfTI has %2. It is cut short, or of another "
                                  "format: copy the file again.",
                                  file.size(), size)};
    NiftiHeader header{.version = beginning->version, .order = beginning->order, .isPair = beginning->isPair};
    const HeaderNumbers numbers(file, beginning->order);
    switch (beginning->version) {
    case NiftiVersion::Analyze: readAnalyze(numbers, file, header); break;
    case NiftiVersion::One: readFirst(numbers, header); break;
    case NiftiVersion::Two: readSecond(numbers, header); break;
    }
    return header;
}

std::vector<std::filesystem::path> niftiPartners(const std::filesystem::path& path)
{
    const std::string ending = path.extension().string();
    const bool isHeader = lowerCase(ending) != ".img";
    const bool isUpper = ending != lowerCase(ending);
    std::vector<std::filesystem::path> partners;
    for (const bool upper : {isUpper, !isUpper})
        partners.push_back(std::filesystem::path(path).replace_extension(isHeader ? (upper ? ".IMG" : ".img")
                                                                                  : (upper ? ".HDR" : ".hdr")));
    return partners;
}

} // namespace tetra
