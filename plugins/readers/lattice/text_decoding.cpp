// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/text_decoding.h"

#include "plugins/readers/lattice/field_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::string_view separators = " \t\r\n\v\f,";

template <class T> std::optional<T> parseSample(std::string_view word)
{
    const std::optional<T> sample = parseNumber<T>(word);
    if constexpr (std::is_same_v<T, float>)
        if (!sample) // a number so small that a float keeps nothing of it is no error
            if (const auto number = parseNumber<double>(word); number && std::abs(*number) < 1)
                return static_cast<float>(*number);
    return sample;
}

template <class T> Status readSamples(std::string_view text, std::span<T> samples, const Progress& progress)
{
    std::size_t done = 0;
    std::size_t first = text.find_first_not_of(separators);
    while (first != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(separators, first), text.size());
        const std::string_view word = text.substr(first, end - first);
        if (done == samples.size())
            return Error{
                ErrorKind::BadInput,
                Message::say("its text holds more than the %1 numbers that the description asks for. Check the sizes.",
                             done)};
        const std::optional<T> sample = parseSample<T>(word);
        if (!sample)
            return Error{ErrorKind::BadInput,
                         Message::say("number %1 of its text, '%2', is no number of the type. Correct it, or the type.",
                                      done + 1, printable(word))};
        samples[done++] = *sample;
        if (done % 65536 == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            progress.report(static_cast<double>(done) / static_cast<double>(samples.size()),
                            Message::marked("Reading"));
        }
        first = text.find_first_not_of(separators, end);
    }
    if (done < samples.size())
        return Error{ErrorKind::BadInput, Message::say("its text holds only %1 numbers where the description asks for "
                                                       "%2. It is cut short, or the sizes are wrong.",
                                                       done, samples.size())};
    return {};
}

} // namespace

Status readTextSamples(std::string_view text, SampleType type, std::span<std::byte> samples, const Progress& progress)
{
    return visitSampleType(type, [&]<class T>() {
        return readSamples<T>(text, {reinterpret_cast<T*>(samples.data()), samples.size() / sizeof(T)}, progress);
    });
}

} // namespace tetra
