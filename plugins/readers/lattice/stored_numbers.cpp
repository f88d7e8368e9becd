// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored_numbers.h"

#include "plugins/readers/lattice/header_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::uint64_t mostBytes = std::numeric_limits<std::uint64_t>::max();

std::uint64_t pointsOf(const StoredNumbers& numbers)
{
    return std::uint64_t(numbers.size[0]) * numbers.size[1] * numbers.size[2];
}

/// The product, or 2^64 - 1 if it is larger.
std::uint64_t boundedProduct(std::uint64_t one, std::uint64_t other)
{
    return other != 0 && one > mostBytes / other ? mostBytes : one * other;
}

std::uint64_t countOf(const StoredNumbers& numbers)
{
    return boundedProduct(pointsOf(numbers), numbers.components);
}

bool isLong(StoredType type)
{
    return type == StoredType::Int64 || type == StoredType::UInt64;
}

bool isScaled(const StoredNumbers& numbers)
{
    return numbers.factor != 1 || numbers.summand != 0;
}

double halfAsDouble(std::uint16_t bits)
{
    constexpr int fractionBits = 10, least = -14, bias = 15, largestExponent = 31;
    const int exponent = bits >> fractionBits & largestExponent;
    const double fraction = std::ldexp(bits & ((1 << fractionBits) - 1), -fractionBits);
    double value = std::ldexp(1 + fraction, exponent - bias);
    if (exponent == 0)
        value = std::ldexp(fraction, least);
    if (exponent == largestExponent)
        value = fraction == 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    return (bits & 0x8000) != 0 ? -value : value;
}

/// A number of a file, in native byte order.
template <class T> T storedAt(const std::byte* place, bool isTurned)
{
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), place, sizeof(T));
    if (isTurned)
        std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

/// Numbers of a binary file, one after the other.
class BinaryNumbers {
public:
    BinaryNumbers(std::span<const std::byte> data, const StoredNumbers& numbers)
        : next_(data.data()), type_(numbers.type), isTurned_(numbers.order != std::endian::native)
    {
    }

    bool take(double& number)
    {
        number = value();
        next_ += storedSize(type_);
        return true;
    }
    Status problem() const { return {}; }

private:
    double value() const
    {
        switch (type_) {
        case StoredType::UInt8: return storedAt<std::uint8_t>(next_, false);
        case StoredType::Int8: return storedAt<std::int8_t>(next_, false);
        case StoredType::UInt16: return storedAt<std::uint16_t>(next_, isTurned_);
        case StoredType::Int16: return storedAt<std::int16_t>(next_, isTurned_);
        case StoredType::UInt32: return storedAt<std::uint32_t>(next_, isTurned_);
        case StoredType::Int32: return storedAt<std::int32_t>(next_, isTurned_);
        case StoredType::Float32: return storedAt<float>(next_, isTurned_);
        case StoredType::Float64: return storedAt<double>(next_, isTurned_);
        case StoredType::Float16: return halfAsDouble(storedAt<std::uint16_t>(next_, isTurned_));
        case StoredType::Int64: return static_cast<double>(storedAt<std::int64_t>(next_, isTurned_));
        case StoredType::UInt64: break;
        }
        return static_cast<double>(storedAt<std::uint64_t>(next_, isTurned_));
    }

    const std::byte* next_;
    StoredType type_;
    bool isTurned_;
};

/// The least and the largest number that a sample of the type holds.
std::array<double, 2> rangeOfType(SampleType type)
{
    return visitSampleType(type, []<class T>() {
        return std::array<double, 2>{static_cast<double>(std::numeric_limits<T>::lowest()),
                                     static_cast<double>(std::numeric_limits<T>::max())};
    });
}

/// Numbers of a text, one after the other.
class TextNumbers {
public:
    TextNumbers(std::span<const std::byte> data, const StoredNumbers& numbers)
        : rest_(reinterpret_cast<const char*>(data.data()), data.size()), count_(countOf(numbers)),
          moreMayFollow_(numbers.moreMayFollow)
    {
        const auto type =
            numbers.type <= StoredType::Float64 ? static_cast<SampleType>(numbers.type) : SampleType::Float64;
        isWhole_ = isInteger(type);
        range_ = rangeOfType(type);
    }

    bool take(double& number)
    {
        const std::string_view word = takeWord();
        const auto parsed = parseHeaderNumber(word);
        if (word.empty())
            problem_ = Error{ErrorKind::BadInput, Message::say("its text holds only %1 numbers where the header asks "
                                                               "for %2. It is cut short, or the header is wrong.",
                                                               taken_, count_)};
        else if (!parsed || !fitsType(*parsed))
            problem_ =
                Error{ErrorKind::BadInput,
                      Message::say("number %1 of its text, '%2', is no number of the type. Correct it, or the type.",
                                   taken_ + 1, printable(word))};
        number = parsed.value_or(0);
        ++taken_;
        return problem_.ok();
    }
    Status problem()
    {
        if (problem_ && !moreMayFollow_ && taken_ == count_ && !takeWord().empty())
            problem_ =
                Error{ErrorKind::BadInput,
                      Message::say("its text holds more than the %1 numbers that the header asks for. Check the sizes.",
                                   count_)};
        return problem_;
    }

private:
    bool fitsType(double number) const
    {
        if (isWhole_ ? std::trunc(number) != number : !std::isfinite(number))
            return !isWhole_; // what is not finite is so in every type of such numbers
        return number >= range_[0] && number <= range_[1];
    }
    std::string_view takeWord()
    {
        constexpr std::string_view separators = " \t\r\n\v\f,";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(separators), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(separators));
        rest_.remove_prefix(word.size());
        return word;
    }

    std::string_view rest_;
    std::uint64_t count_;
    bool moreMayFollow_;
    std::uint64_t taken_ = 0;
    bool isWhole_ = false;
    std::array<double, 2> range_{};
    Status problem_;
};

/// The value of the next point.
template <class Source> bool takeValue(Source& source, const StoredNumbers& numbers, double& value)
{
    double squares = 0;
    for (std::uint64_t component = 0; component < numbers.components; ++component) {
        double number = 0;
        if (!source.take(number))
            return false;
        number = numbers.summand + numbers.factor * number;
        if (component == numbers.component)
            value = number;
        squares += number * number;
    }
    if (!numbers.component)
        value = std::sqrt(squares);
    return true;
}

/// Calls `use(index, value)` for each point, in the order of the file.
template <class Source, class Use>
Status forEachValue(Source source, const StoredNumbers& numbers, const Progress& progress, const Use& use)
{
    const auto& size = numbers.size;
    const bool turned = numbers.lastFastest;
    const std::array<std::uint64_t, 3> steps{1, size[0], std::uint64_t(size[0]) * size[1]};
    const std::size_t slow = turned ? 0 : 2, fast = turned ? 2 : 0;
    for (std::uint64_t outer = 0; outer < size[slow]; ++outer) {
        progress.report(static_cast<double>(outer) / size[slow], Message::marked("Reading"));
        for (std::uint64_t middle = 0; middle < size[1]; ++middle) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            for (std::uint64_t inner = 0; inner < size[fast]; ++inner) {
                double value = 0;
                if (!takeValue(source, numbers, value))
                    return source.problem();
                use(outer * steps[slow] + middle * steps[1] + inner * steps[fast], value);
            }
        }
    }
    return source.problem();
}

template <class Use> Status forEachStored(std::span<const std::byte> data, const StoredNumbers& numbers,
                                          const Progress& progress, const Use& use)
{
    return numbers.isText ? forEachValue(TextNumbers(data, numbers), numbers, progress, use)
                          : forEachValue(BinaryNumbers(data, numbers), numbers, progress, use);
}

/// The type of samples that hold 64-bit integers; what they lose is told.
Result<SampleType> typeOfLongs(std::span<const std::byte> data, const StoredNumbers& numbers,
                               std::vector<Message>& remarks, const Progress& progress)
{
    constexpr double least = std::numeric_limits<std::int32_t>::min(), most = std::numeric_limits<std::int32_t>::max();
    bool fits = true;
    const Status looked = forEachStored(
        data, numbers, progress, [&](std::uint64_t, double value) { fits = fits && value >= least && value <= most; });
    if (!looked)
        return looked.error();
    if (fits)
        return SampleType::Int32;
    remarks.push_back(Message::say("Its 64-bit integers became floating-point numbers of 53 bits."));
    return SampleType::Float64;
}

bool areStoredInPlace(std::span<const std::byte> data, const StoredNumbers& numbers)
{
    const std::size_t size = storedSize(numbers.type);
    return !numbers.isText && numbers.type <= StoredType::Float64 && numbers.components == 1 && !isScaled(numbers) &&
           !numbers.lastFastest && (size == 1 || numbers.order == std::endian::native) &&
           reinterpret_cast<std::uintptr_t>(data.data()) % size == 0;
}

} // namespace

std::optional<SampleType> sampleTypeOf(const StoredNumbers& numbers) noexcept
{
    if (isScaled(numbers))
        return SampleType::Float32;
    if (numbers.type == StoredType::Float16)
        return SampleType::Float32;
    const bool isMagnitude = !numbers.component;
    if (isLong(numbers.type))
        return isMagnitude ? std::optional(SampleType::Float64) : std::nullopt;
    const auto type = static_cast<SampleType>(numbers.type);
    return isMagnitude && isInteger(type) ? SampleType::Float64 : type;
}

std::uint64_t storedBytes(const StoredNumbers& numbers) noexcept
{
    return boundedProduct(countOf(numbers), storedSize(numbers.type));
}

Status checkStored(std::span<const std::byte> data, const StoredNumbers& numbers)
{
    const auto& size = numbers.size;
    if (numbers.isText && countOf(numbers) > (data.size() + 1) / 2)
        return Error{ErrorKind::BadInput,
                     Message::say("its header asks for %1 x %2 x %3 points with %4 numbers each, and only %5 bytes of "
                                  "text follow. It is cut short, or the header is wrong.",
                                  size[0], size[1], size[2], numbers.components, data.size())};
    if (!numbers.isText && storedBytes(numbers) > data.size())
        return Error{ErrorKind::BadInput,
                     Message::say("its header asks for %1 x %2 x %3 points with %4 bytes each, and only %5 bytes are "
                                  "there. It is cut short, or the header is wrong.",
                                  size[0], size[1], size[2],
                                  boundedProduct(numbers.components, storedSize(numbers.type)), data.size())};
    return {};
}

Result<ScalarField> readStored(std::span<const std::byte> data, const StoredNumbers& numbers,
                               std::vector<Message>& remarks, const Progress& progress,
                               const std::shared_ptr<const void>& owner)
{
    if (const Status enough = checkStored(data, numbers); !enough)
        return enough.error();
    const std::uint64_t points = pointsOf(numbers);
    if (owner && areStoredInPlace(data, numbers))
        return ScalarField::scanned(static_cast<SampleType>(numbers.type), points, {owner, data.data()}, progress);
    const auto known = sampleTypeOf(numbers);
    constexpr double halfway = 0.5;
    const auto type =
        known ? Result<SampleType>(*known) : typeOfLongs(data, numbers, remarks, progress.part(0, halfway));
    if (!type)
        return type.error();
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(*type, points);
    if (!samples)
        return samples.error();
    const Status read = visitSampleType(*type, [&]<class T>() {
        T* const to = reinterpret_cast<T*>(samples->get());
        return forEachStored(data, numbers, known ? progress : progress.part(halfway, 1),
                             [to](std::uint64_t index, double value) { to[index] = static_cast<T>(value); });
    });
    if (!read)
        return read.error();
    return ScalarField(*type, points, *std::move(samples));
}

} // namespace tetra
