// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored/stored_text.h"

#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::string_view betweenNumbers = " \t\r\n\v\f,";

/// A number of the type; whole ones may be written with a fraction of 0, or of any if that is to be cut off.
template <class T> std::optional<T> numberOfWord(std::string_view word, bool cutsFractions)
{
    if (const auto exact = parseNumber<T>(word))
        return exact;
    const auto number = parseHeaderNumber(word);
    if (!number)
        return std::nullopt;
    if constexpr (std::is_floating_point_v<T>) // it may be so small that the type keeps nothing of it
        return std::abs(*number) <= static_cast<double>(std::numeric_limits<T>::max())
                   ? std::optional(static_cast<T>(*number))
                   : std::nullopt;
    constexpr double least = static_cast<double>(std::numeric_limits<T>::lowest());
    const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
    const bool fits = *number >= least && *number < beyond && (cutsFractions || std::trunc(*number) == *number);
    return fits ? std::optional(static_cast<T>(*number)) : std::nullopt;
}

Error tooFewNumbers(std::uint64_t found, std::uint64_t wanted)
{
    return {ErrorKind::BadInput, Message::say("its text holds only %1 numbers where the description requires %2. It is "
                                              "cut short, or the sizes are wrong.",
                                              found, wanted)};
}

template <class T> Status readNumbers(std::string_view text, const StoredVolume& volume, std::uint64_t skip,
                                      std::uint64_t step, std::span<std::byte> kept, const Progress& progress)
{
    constexpr std::uint64_t betweenLooks = 1 << 16;
    const std::uint64_t numbers = volume.numbersOfFile();
    std::byte* to = kept.data();
    for (std::uint64_t number = 0; number < numbers; ++number) {
        if (number % betweenLooks == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            progress.report(static_cast<double>(number) / static_cast<double>(numbers), Message::marked("Reading"));
        }
        text.remove_prefix(std::min(text.find_first_not_of(betweenNumbers), text.size()));
        const std::size_t end = text.find_first_of(betweenNumbers);
        if (text.empty() || (end == std::string_view::npos && volume.isTextOfMetaIo))
            return tooFewNumbers(number, numbers);
        const std::string_view word = text.substr(0, end);
        const std::optional<T> value = numberOfWord<T>(word, volume.isTextOfMetaIo);
        if (!value)
            return Error{
                ErrorKind::BadInput,
                Message::say("number %1 of its text, '%2', is not a number of this type. Correct it, or the type.",
                             number + 1, printable(word))};
        if (number >= skip && (number - skip) % step == 0 && to != kept.data() + kept.size()) {
            std::memcpy(to, &*value, sizeof(T));
            to += sizeof(T);
        }
        text.remove_prefix(word.size());
    }
    if (volume.rest == StoredRest::Refused && text.find_first_not_of(betweenNumbers) != std::string_view::npos)
        return Error{
            ErrorKind::BadInput,
            Message::say("its text holds more than the %1 numbers that the description requires. Check the sizes.",
                         numbers)};
    return {};
}

} // namespace

Status readStoredText(std::string_view text, const StoredVolume& volume, std::uint64_t skip, std::uint64_t step,
                      std::span<std::byte> kept, const Progress& progress)
{
    const auto read = [&]<class T>() { return readNumbers<T>(text, volume, skip, step, kept, progress); };
    switch (volume.type) {
    case StoredType::Int64: return read.template operator()<std::int64_t>();
    case StoredType::UInt64: return read.template operator()<std::uint64_t>();
    default: return visitSampleType(plainSampleType(volume.type).value_or(SampleType::Float32), read);
    }
}

} // namespace tetra
