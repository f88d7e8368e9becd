// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/vtu_data.h"

#include "plugins/readers/cells/encoded_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace tetra {

namespace {

constexpr std::string_view blanks = " \t\r\n";
/// No data packed by zlib unpack to more.
constexpr std::uint64_t mostPacking = 1032;

Error wrong(const VtuArray& array, const Message& what)
{
    return {ErrorKind::BadInput, Message::say("the array '%1' %2.", printable(array.name), what)};
}

struct NumberType {
    std::string_view name;
    std::size_t bytes;
};
constexpr NumberType numberTypes[] = {{"Int8", 1},   {"UInt8", 1}, {"Int16", 2},  {"UInt16", 2},  {"Int32", 4},
                                      {"UInt32", 4}, {"Int64", 8}, {"UInt64", 8}, {"Float32", 4}, {"Float64", 8}};

std::size_t bytesOf(const VtuArray& array)
{
    const auto found = std::ranges::find(numberTypes, array.type, &NumberType::name);
    return found == std::end(numberTypes) ? 0 : found->bytes;
}

class ArrayReading {
public:
    ArrayReading(const VtuHead& head, const VtuArray& array, std::uint64_t count)
        : head_(head), array_(array), count_(count), size_(bytesOf(array)),
          bytes_(array.content, array.format == "binary" || (array.format == "appended" && head.appendedBase64))
    {
    }

    /// How many numbers the header before them says that there are.
    Result<std::uint64_t> countTold()
    {
        std::uint64_t bytes = 0, blocks = 0, blockBytes = 0;
        if (!head_.packed)
            return takeHeader(bytes) ? Result<std::uint64_t>(bytes / size_) : tooShort();
        if (!takeHeader(blocks))
            return tooShort();
        if (blocks == 0)
            return std::uint64_t(0);
        if (!takeHeader(blockBytes) || !takeHeader(bytes))
            return tooShort();
        const std::uint64_t whole = bytes > 0 ? blocks - 1 : blocks, most = mostPacking * array_.content.size();
        if (bytes > most || (whole > 0 && blockBytes > (most - bytes) / whole))
            return tooShort();
        return (whole * blockBytes + bytes) / size_;
    }

    /// The numbers in the machine's byte order.
    Result<std::vector<std::byte>> run()
    {
        if (count_ > std::numeric_limits<std::uint64_t>::max() / 16 ||
            count_ * size_ / mostPacking > array_.content.size())
            return tooShort();
        auto values = head_.packed ? unpack() : copy();
        if (values && head_.bigEndian)
            for (std::size_t i = 0; i < values->size(); i += size_)
                std::reverse(values->begin() + std::ptrdiff_t(i), values->begin() + std::ptrdiff_t(i + size_));
        return values;
    }

private:
    Error tooShort() const { return wrong(array_, Message::say("is too short for %1 numbers, or cut short", count_)); }
    Error otherSize(std::uint64_t bytes) const
    {
        return wrong(array_, Message::say("has %1 bytes, not the %2 of %3 numbers", bytes, count_ * size_, count_));
    }

    bool takeHeader(std::uint64_t& number)
    {
        std::array<std::byte, 8> bytes{};
        const std::span header = std::span(bytes).first(head_.wideHeaders ? 8 : 4);
        if (!bytes_.take(header))
            return false;
        if (head_.bigEndian)
            std::ranges::reverse(header);
        std::memcpy(&number, bytes.data(), sizeof number);
        return true;
    }

    Result<std::vector<std::byte>> copy()
    {
        std::uint64_t bytes = 0;
        if (!takeHeader(bytes))
            return tooShort();
        if (bytes != count_ * size_)
            return otherSize(bytes);
        if (bytes > array_.content.size())
            return tooShort();
        std::vector<std::byte> values(bytes);
        if (!bytes_.take(values))
            return tooShort();
        return values;
    }

    Result<std::vector<std::byte>> unpack()
    {
        std::uint64_t blocks = 0, blockBytes = 0, lastBytes = 0;
        if (!takeHeader(blocks))
            return tooShort();
        if (blocks == 0 && count_ == 0)
            return std::vector<std::byte>();
        if (!takeHeader(blockBytes) || !takeHeader(lastBytes) || blocks > array_.content.size())
            return tooShort();
        std::vector<std::uint64_t> packedSizes(blocks);
        for (std::uint64_t& size : packedSizes)
            if (!takeHeader(size) || size > array_.content.size())
                return tooShort();
        const std::uint64_t wanted = count_ * size_;
        const std::uint64_t whole = lastBytes > 0 ? blocks - std::min<std::uint64_t>(blocks, 1) : blocks;
        if (blockBytes > wanted || (blockBytes > 0 && whole > wanted / blockBytes) ||
            whole * blockBytes + lastBytes != wanted) {
            // One block may be given as larger than it is, with what it holds as the last one.
            if (blocks != 1 || lastBytes != wanted)
                return otherSize(whole * std::min(blockBytes, wanted + 1) + lastBytes);
        }
        std::vector<std::byte> values(wanted);
        std::vector<std::byte> packed;
        std::uint64_t at = 0;
        bytes_.startAnew();
        for (std::uint64_t block = 0; block < blocks; ++block) {
            packed.resize(packedSizes[block]);
            if (!bytes_.take(packed))
                return tooShort();
            const std::uint64_t room = block < whole ? blockBytes : lastBytes;
            uLongf unpacked = room;
            if (uncompress(reinterpret_cast<Bytef*>(values.data() + at), &unpacked,
                           reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
                unpacked != room)
                return wrong(array_, Message::say("is damaged: it cannot be unpacked"));
            at += room;
        }
        return values;
    }

    const VtuHead& head_;
    const VtuArray& array_;
    std::uint64_t count_;
    std::size_t size_;
    EncodedBytes bytes_;
};

template <class Number, class Stored> std::vector<Number> converted(const std::vector<std::byte>& bytes)
{
    std::vector<Number> numbers(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        Stored stored;
        std::memcpy(&stored, bytes.data() + i * sizeof stored, sizeof stored);
        numbers[i] = static_cast<Number>(stored);
    }
    return numbers;
}

template <class Number> Result<std::vector<Number>> readText(const VtuArray& array, std::uint64_t count)
{
    std::string_view text = array.content;
    if (count > text.size() / 2 + 1)
        return wrong(array, Message::say("is too short for %1 numbers", count));
    std::vector<Number> numbers;
    numbers.reserve(count);
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (text.empty())
            break;
        const std::string_view word = text.substr(0, text.find_first_of(blanks));
        text.remove_prefix(word.size());
        const auto number = parseNumber<Number>(word);
        if (!number)
            return wrong(array, Message::say("has '%1' among its numbers", printable(word.substr(0, 20))));
        if (numbers.size() == count)
            return wrong(array, Message::say("has more than %1 numbers", count));
        numbers.push_back(*number);
    }
    if (numbers.size() < count)
        return wrong(array, Message::say("has %1 numbers, not %2", numbers.size(), count));
    return numbers;
}

template <class Number>
Result<std::vector<Number>> readNumbers(const VtuHead& head, const VtuArray& array, std::uint64_t count)
{
    if (bytesOf(array) == 0)
        return wrong(array, Message::say("is of type '%1', which is not a number", printable(array.type)));
    if (array.format == "ascii")
        return readText<Number>(array, count);
    if (array.format != "binary" && array.format != "appended")
        return wrong(array, Message::say("has the unknown format '%1'", printable(array.format)));
    const auto bytes = ArrayReading(head, array, count).run();
    if (!bytes)
        return bytes.error();
    if (array.type == "Int8")
        return converted<Number, std::int8_t>(*bytes);
    if (array.type == "UInt8")
        return converted<Number, std::uint8_t>(*bytes);
    if (array.type == "Int16")
        return converted<Number, std::int16_t>(*bytes);
    if (array.type == "UInt16")
        return converted<Number, std::uint16_t>(*bytes);
    if (array.type == "Int32")
        return converted<Number, std::int32_t>(*bytes);
    if (array.type == "UInt32")
        return converted<Number, std::uint32_t>(*bytes);
    if (array.type == "Int64")
        return converted<Number, std::int64_t>(*bytes);
    if (array.type == "UInt64")
        return converted<Number, std::uint64_t>(*bytes);
    if constexpr (std::is_integral_v<Number>)
        return wrong(array, Message::say("is of type '%1', not of whole numbers", printable(array.type)));
    else if (array.type == "Float32")
        return converted<Number, float>(*bytes);
    else
        return converted<Number, double>(*bytes);
}

} // namespace

Result<std::vector<double>> readDoubles(const VtuHead& head, const VtuArray& array, std::uint64_t count)
{
    return readNumbers<double>(head, array, count);
}

Result<std::vector<std::uint64_t>> readIntegers(const VtuHead& head, const VtuArray& array, std::uint64_t count)
{
    return readNumbers<std::uint64_t>(head, array, count);
}

Result<std::vector<std::uint64_t>> readAllIntegers(const VtuHead& head, const VtuArray& array)
{
    if (array.format == "ascii") {
        std::uint64_t words = 0;
        for (auto at = array.content.find_first_not_of(blanks); at != std::string_view::npos;
             at = array.content.find_first_not_of(blanks, array.content.find_first_of(blanks, at)))
            ++words;
        return readIntegers(head, array, words);
    }
    if (bytesOf(array) == 0)
        return readIntegers(head, array, 0); // which says what is wrong
    const auto count = ArrayReading(head, array, 0).countTold();
    return count ? readIntegers(head, array, *count) : count.error();
}

std::optional<SampleType> sampleTypeOf(const VtuArray& array)
{
    constexpr std::pair<std::string_view, SampleType> types[] = {
        {"Int8", SampleType::Int8},      {"UInt8", SampleType::UInt8},    {"Int16", SampleType::Int16},
        {"UInt16", SampleType::UInt16},  {"Int32", SampleType::Int32},    {"UInt32", SampleType::UInt32},
        {"Int64", SampleType::Float64},  {"UInt64", SampleType::Float64}, {"Float32", SampleType::Float32},
        {"Float64", SampleType::Float64}};
    const auto found = std::ranges::find(types, array.type, [](const auto& type) { return type.first; });
    return found == std::end(types) ? std::nullopt : std::optional(found->second);
}

} // namespace tetra
