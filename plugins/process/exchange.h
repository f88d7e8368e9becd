// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/findings.h"

#include <functional>
#include <type_traits>

namespace tetra {

/// How a reader and its program talk: a request goes in through the program's input, messages come out of its output,
/// in the machine's own byte order. Both are built together, so that no version is needed. The same function
/// `exchange(archive, value)` writes and reads a value, so that the two sides cannot differ.

/// The first byte of each message. Error, Findings and Contents are the last one.
enum class ProcessMessage : std::uint8_t { Progress = 'p', Error = 'e', Findings = 'f', Contents = 'c' };

/// Writes values; good() is false after the first failure.
class ExchangeOutput {
public:
    using Write = std::function<bool(const void* data, std::size_t bytes)>;
    explicit ExchangeOutput(Write write) : write_(std::move(write)) {}
    bool good() const noexcept { return good_; }

    void bytes(const void* data, std::size_t count) { good_ = good_ && (count == 0 || write_(data, count)); }
    template <class List> void list(const List& values)
    {
        static_assert(std::is_trivially_destructible_v<typename List::value_type>); // else its bytes are not all of it
        const std::uint64_t count = values.size();
        bytes(&count, sizeof count);
        bytes(values.data(), count * sizeof(typename List::value_type));
    }
    template <class T, class Each> void each(const std::vector<T>& values, const Each& one)
    {
        const std::uint64_t count = values.size();
        bytes(&count, sizeof count);
        for (const T& value : values)
            one(const_cast<T&>(value)); // an archive that writes only looks
    }

private:
    Write write_;
    bool good_ = true;
};

/// Reads them again; after the first failure all values are zero or empty, and good() is false. Throws std::bad_alloc
/// and std::length_error if a list is longer than memory.
class ExchangeInput {
public:
    using Read = std::function<bool(void* data, std::size_t bytes)>;
    explicit ExchangeInput(Read read) : read_(std::move(read)) {}
    bool good() const noexcept { return good_; }

    void bytes(void* data, std::size_t count) { good_ = good_ && (count == 0 || read_(data, count)); }
    template <class List> void list(List& values)
    {
        static_assert(std::is_trivially_destructible_v<typename List::value_type>); // else its bytes are not all of it
        values.resize(count());
        bytes(values.data(), values.size() * sizeof(typename List::value_type));
        if (!good_)
            values.clear();
    }
    template <class T, class Each> void each(std::vector<T>& values, const Each& one)
    {
        for (std::uint64_t left = count(); left > 0 && good_; --left)
            one(values.emplace_back());
    }

private:
    std::uint64_t count()
    {
        std::uint64_t number = 0;
        bytes(&number, sizeof number);
        return good_ ? number : 0;
    }

    Read read_;
    bool good_ = true;
};

template <class T>
concept PlainValue = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class Archive, PlainValue T> void exchange(Archive& archive, T& value)
{
    archive.bytes(&value, sizeof value);
}

template <class Archive> void exchange(Archive& archive, std::string& text)
{
    archive.list(text);
}

template <class Archive, class... T> void exchangeAll(Archive& archive, T&... values)
{
    (exchange(archive, values), ...);
}

template <class Archive> void exchange(Archive& archive, Message& message)
{
    std::string text = message.text(), sentence = message.sentence();
    std::vector<Message> arguments = message.arguments();
    exchangeAll(archive, text, sentence, arguments);
    message = sentence.empty() ? Message(text) : Message::of(sentence, std::move(arguments));
}

template <class Archive> void exchange(Archive& archive, std::vector<Message>& messages)
{
    archive.each(messages, [&](Message& message) { exchange(archive, message); });
}

template <class Archive> void exchange(Archive& archive, Error& error)
{
    std::string file = error.file.string();
    exchangeAll(archive, error.kind, error.message, file);
    error.file = file;
}

template <class Archive> void exchange(Archive& archive, Eigen::Vector3d& vector)
{
    archive.bytes(vector.data(), 3 * sizeof(double));
}

template <class Archive> void exchange(Archive& archive, std::array<std::uint32_t, 3>& size)
{
    archive.bytes(size.data(), sizeof size);
}

template <class Archive> void exchange(Archive& archive, std::vector<std::string>& texts)
{
    archive.each(texts, [&](std::string& text) { exchange(archive, text); });
}

template <class Archive, class T> void exchange(Archive& archive, std::optional<T>& value)
{
    bool present = value.has_value();
    exchange(archive, present);
    if (present && !value)
        value.emplace();
    if (present)
        exchange(archive, *value);
}

template <class Archive> void exchange(Archive& archive, ValueRange& range)
{
    exchangeAll(archive, range.minimum, range.maximum);
}

template <class Archive> void exchange(Archive& archive, Lattice& lattice)
{
    exchangeAll(archive, lattice.size, lattice.spacing, lattice.origin);
    archive.bytes(lattice.directions.data(), 9 * sizeof(double));
}

template <class Archive> void exchange(Archive& archive, std::vector<Taken>& all)
{
    archive.each(all, [&](Taken& taken) { exchangeAll(archive, taken.part, taken.what, taken.guessed); });
}

template <class Archive> void exchange(Archive& archive, FileFindings& found)
{
    exchangeAll(archive, found.kind, found.lattice, found.space, found.lengthUnit, found.untold, found.type,
                found.perCell, found.arrayName, found.remarks, found.taken, found.leftOut);
    archive.list(found.positions);
    archive.list(found.samples);
    archive.list(found.shapes);
    archive.list(found.offsets);
    archive.list(found.corners);
    archive.list(found.blanked);
}

template <class Archive> void exchange(Archive& archive, FileArray& array)
{
    exchangeAll(archive, array.name, array.components, array.perCell, array.range, array.unit);
}

template <class Archive> void exchange(Archive& archive, FileContents& contents)
{
    exchangeAll(archive, contents.domain, contents.lattice, contents.points, contents.cells, contents.type,
                contents.blocks, contents.untold, contents.series, contents.channels, contents.taken, contents.leftOut);
    archive.list(contents.timeSteps);
    archive.each(contents.arrays, [&](FileArray& array) { exchange(archive, array); });
}

} // namespace tetra
