// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

/// A number of the type; fractions of whole ones are cut off.
template <class T> std::optional<T> numberOf(std::string_view word)
{
    if (const auto exact = parseNumber<T>(word))
        return exact;
    const auto number = parseNumber<double>(word);
    if (!number)
        return std::nullopt;
    if constexpr (std::is_same_v<T, float>)
        return std::abs(*number) < 1 ? std::optional(static_cast<float>(*number)) : std::nullopt; // too small for one
    constexpr double least = static_cast<double>(std::numeric_limits<T>::lowest());
    const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
    return *number >= least && *number < beyond ? std::optional(static_cast<T>(*number)) : std::nullopt;
}

template <class T> Status readNumbers(std::string_view text, std::uint64_t numbers, std::uint64_t skip,
                                      std::span<std::byte> kept, const Progress& progress)
{
    constexpr std::uint64_t betweenLooks = 1 << 16;
    for (std::uint64_t number = 0; number < numbers; ++number) {
        if (number % betweenLooks == 0 && progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        const std::size_t end = text.find_first_of(blanks);
        if (end == std::string_view::npos)
            return Error{ErrorKind::BadInput,
                         Message::say("it has not the %1 numbers that its header asks for, each with a blank or an end "
                                      "of line behind it. It is cut short: copy the file again.",
                                      numbers)};
        const std::optional<T> value = numberOf<T>(text.substr(0, end));
        if (!value)
            return Error{ErrorKind::BadInput,
                         Message::say("number %1 of its text, '%2', is no number of the type. Correct it, or the type.",
                                      number + 1, printable(text.substr(0, end)))};
        if (number >= skip && number - skip < kept.size() / sizeof(T))
            std::memcpy(kept.data() + (number - skip) * sizeof(T), &*value, sizeof(T));
        text.remove_prefix(end);
    }
    return {};
}

} // namespace

Status readStoredText(std::string_view text, StoredType type, std::uint64_t numbers, std::uint64_t skip,
                      std::span<std::byte> kept, const Progress& progress)
{
    const auto read = [&]<class T>() { return readNumbers<T>(text, numbers, skip, kept, progress); };
    switch (type) {
    case StoredType::Int64: return read.template operator()<std::int64_t>();
    case StoredType::UInt64: return read.template operator()<std::uint64_t>();
    default: return visitSampleType(plainSampleType(type).value_or(SampleType::Float32), read);
    }
}

} // namespace tetra
