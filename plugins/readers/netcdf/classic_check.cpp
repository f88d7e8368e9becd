// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html
#include "plugins/readers/netcdf/classic_check.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {
namespace {

constexpr std::uint64_t noNumber = ~std::uint64_t(0);

/// A product that stays noNumber where it would be larger than any file: what headers ask for may overflow.
std::uint64_t boundedProduct(std::uint64_t a, std::uint64_t b)
{
    constexpr std::uint64_t most = std::uint64_t(1) << 62;
    return b != 0 && a > most / b ? noNumber : a * b;
}

std::uint64_t boundedSum(std::uint64_t a, std::uint64_t b)
{
    return a > noNumber - b ? noNumber : a + b;
}

/// A header that cannot be right; `what` is a sentence.
Error wrongHeader(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("%1 The file is damaged: copy or export it again.", what)};
}

/// Bytes of a value of the external type; 0 for what is no type.
std::uint64_t netCdfTypeSize(std::uint64_t type)
{
    constexpr std::array<std::uint64_t, 12> sizes = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < sizes.size() ? sizes[type] : 0;
}

std::uint64_t padded(std::uint64_t bytes)
{
    return bytes > noNumber - 3 ? noNumber : (bytes + 3) / 4 * 4;
}

struct ClassicVariable {
    std::string name;
    bool hasRecords = false;
    std::uint64_t bytes = 0; ///< of all of it, or of one record; not padded
    std::uint64_t begin = 0;
    std::uint64_t typeSize = 0;
};

class NetCdfHeader {
public:
    NetCdfHeader(std::span<const std::byte> bytes) : bytes_(bytes), wideCounts_(bytes[3] == std::byte(5)) {}

    Status check()
    {
        at_ = 4;
        const std::uint64_t records = count();
        if (const Status read = dimensions(); !read)
            return read;
        if (const Status read = attributes(); !read)
            return read;
        if (const Status read = variables(); !read)
            return read;
        return endOfAll(records);
    }

private:
    std::uint64_t number(std::size_t size)
    {
        if (size > bytes_.size() - at_) {
            at_ = bytes_.size();
            ended_ = true;
            return 0;
        }
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value = value << 8U | std::to_integer<std::uint64_t>(bytes_[at_++]);
        return value;
    }
    std::uint64_t count() { return number(wideCounts_ ? 8 : 4); }
    std::uint64_t offset() { return number(bytes_[3] == std::byte(1) ? 4 : 8); }

    void skip(std::uint64_t size)
    {
        if (size > bytes_.size() - at_) {
            at_ = bytes_.size();
            ended_ = true;
        } else {
            at_ += size;
        }
    }

    std::string name()
    {
        const std::uint64_t length = count();
        const std::size_t begin = at_;
        skip(padded(length));
        return ended_ ? std::string() : std::string(reinterpret_cast<const char*>(bytes_.data()) + begin, length);
    }

    /// The length of a list whose entries take at least `smallest` bytes each; nothing if there cannot be so many.
    std::optional<std::uint64_t> listLength(std::uint64_t wantedTag, std::uint64_t smallest)
    {
        const std::uint64_t tag = number(4);
        const std::uint64_t length = count();
        const bool fits = boundedProduct(length, smallest) <= bytes_.size() - at_;
        return !ended_ && fits && (tag == wantedTag || (tag == 0 && length == 0)) ? std::optional(length)
                                                                                  : std::nullopt;
    }

    Error noHeader() const
    {
        return ended_ || at_ == bytes_.size()
                   ? Error{ErrorKind::BadInput,
                           Message::say("it ends within its header. It is cut short: copy the file again.")}
                   : wrongHeader(Message::say(
                         "its NetCDF header has lists that are longer than the file, or lacks required ones."));
    }

    Status dimensions()
    {
        const auto length = listLength(10, 8);
        if (!length)
            return noHeader();
        for (std::uint64_t i = 0; i < *length; ++i) {
            const std::string dimension = name();
            const std::uint64_t points = count();
            if (ended_)
                return noHeader();
            // Programs take memory for as many, used or not.
            if (points > bytes_.size())
                return wrongHeader(Message::say("its dimension '%1' is %2 long, more than the file has bytes.",
                                                printable(dimension), points));
            lengths_.push_back(points);
        }
        return {};
    }

    Status attributes()
    {
        const auto length = listLength(12, 12);
        if (!length)
            return noHeader();
        for (std::uint64_t i = 0; i < *length; ++i) {
            name();
            const std::uint64_t type = number(4);
            skip(padded(boundedProduct(count(), netCdfTypeSize(type))));
            if (ended_)
                return noHeader();
            if (netCdfTypeSize(type) == 0)
                return wrongHeader(Message::say("its NetCDF header has an attribute of unknown type."));
        }
        return {};
    }

    Status variables()
    {
        const auto length = listLength(11, 24);
        if (!length)
            return noHeader();
        for (std::uint64_t i = 0; i < *length; ++i)
            if (const Status read = variable(); !read)
                return read;
        return {};
    }

    Status variable()
    {
        ClassicVariable variable{.name = name()};
        const std::uint64_t rank = count();
        if (boundedProduct(rank, 4) > bytes_.size() - at_)
            return noHeader();
        std::uint64_t values = 1;
        for (std::uint64_t i = 0; i < rank; ++i) {
            const std::uint64_t dimension = count();
            if (ended_)
                return noHeader();
            if (dimension >= lengths_.size())
                return wrongHeader(
                    Message::say("its variable '%1' has dimensions that do not exist.", printable(variable.name)));
            const bool unlimited = lengths_[dimension] == 0;
            variable.hasRecords |= unlimited && i == 0;
            if (!unlimited || i > 0)
                values = boundedProduct(values, lengths_[dimension]);
        }
        if (const Status read = attributes(); !read)
            return read;
        variable.typeSize = netCdfTypeSize(number(4));
        count(); // what it says of its own size, which is not wide enough for large ones
        variable.begin = offset();
        if (ended_)
            return noHeader();
        if (variable.typeSize == 0)
            return wrongHeader(Message::say("its variable '%1' is of unknown type.", printable(variable.name)));
        variable.bytes = boundedProduct(values, variable.typeSize);
        variables_.push_back(std::move(variable));
        return {};
    }

    /// Bytes from a record to the next: each variable's padded, unless there is only one.
    std::uint64_t recordBytes() const
    {
        std::uint64_t sum = 0;
        std::size_t parts = 0;
        for (const ClassicVariable& variable : variables_)
            if (variable.hasRecords) {
                const std::uint64_t bytes = padded(variable.bytes);
                sum = boundedSum(sum, bytes);
                ++parts;
            }
        if (parts == 1)
            for (const ClassicVariable& variable : variables_)
                if (variable.hasRecords)
                    return variable.bytes;
        return sum;
    }

    Status endOfAll(std::uint64_t records) const
    {
        const std::uint64_t stride = recordBytes();
        for (const ClassicVariable& variable : variables_) {
            std::uint64_t bytes = variable.bytes;
            if (variable.hasRecords)
                bytes = records == 0 ? 0 : boundedProduct(records - 1, stride);
            if (variable.hasRecords && records > 0)
                bytes = boundedSum(bytes, variable.bytes);
            const std::uint64_t end = boundedSum(bytes, variable.begin);
            if (end > bytes_.size())
                return Error{
                    ErrorKind::BadInput,
                    end == noNumber
                        ? Message::say("it has %1 bytes, and its variable '%2' is larger than any file. It is cut "
                                       "short, or was not written completely: copy the file again, or export it again.",
                                       bytes_.size(), printable(variable.name))
                        : Message::say("it has %1 bytes, and its variable '%2' extends to byte %3. It is cut short, or "
                                       "was not written completely: copy the file again, or export it again.",
                                       bytes_.size(), printable(variable.name), end)};
            if (bytes > 0 && variable.begin < at_)
                return wrongHeader(
                    Message::say("its variable '%1' begins within the header.", printable(variable.name)));
        }
        return {};
    }

    std::span<const std::byte> bytes_;
    bool wideCounts_;
    std::size_t at_ = 0;
    bool ended_ = false;
    std::vector<std::uint64_t> lengths_; ///< of the dimensions; 0 for the one of the records
    std::vector<ClassicVariable> variables_;
};

} // namespace

bool isClassicNetCdf(std::span<const std::byte> firstBytes) noexcept
{
    return firstBytes.size() >= 4 && std::string_view(reinterpret_cast<const char*>(firstBytes.data()), 3) == "CDF" &&
           (firstBytes[3] == std::byte(1) || firstBytes[3] == std::byte(2) || firstBytes[3] == std::byte(5));
}

Result<std::uint64_t> checkClassicNetCdf(const std::filesystem::path& path)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const auto bytes = (*file)->bytes();
    if (isClassicNetCdf(bytes))
        if (const Status fits = NetCdfHeader(bytes).check(); !fits)
            return fits.error();
    return std::uint64_t(bytes.size());
}

} // namespace tetra
