// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/stored_values.h"

#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace tetra {
namespace {

/// Calls `function.operator()<T>()` with the C++ type of an nc_type that is a number.
template <class Function> decltype(auto) visitStored(int type, Function&& function)
{
    switch (type) {
    case NC_BYTE: return function.template operator()<std::int8_t>();
    case NC_UBYTE: return function.template operator()<std::uint8_t>();
    case NC_SHORT: return function.template operator()<std::int16_t>();
    case NC_USHORT: return function.template operator()<std::uint16_t>();
    case NC_INT: return function.template operator()<std::int32_t>();
    case NC_UINT: return function.template operator()<std::uint32_t>();
    case NC_INT64: return function.template operator()<std::int64_t>();
    case NC_UINT64: return function.template operator()<std::uint64_t>();
    case NC_FLOAT: return function.template operator()<float>();
    default: return function.template operator()<double>();
    }
}

bool isFloating(int type)
{
    return type == NC_FLOAT || type == NC_DOUBLE;
}

int unsignedOf(int type)
{
    switch (type) {
    case NC_BYTE: return NC_UBYTE;
    case NC_SHORT: return NC_USHORT;
    case NC_INT: return NC_UINT;
    case NC_INT64: return NC_UINT64;
    default: return type;
    }
}

/// What the library fills a variable of this type with that says nothing of it; bytes have no such number.
std::optional<long double> defaultFillOf(int type)
{
    switch (type) {
    case NC_SHORT: return NC_FILL_SHORT;
    case NC_USHORT: return NC_FILL_USHORT;
    case NC_INT: return NC_FILL_INT;
    case NC_UINT: return NC_FILL_UINT;
    case NC_INT64: return NC_FILL_INT64;
    case NC_UINT64: return NC_FILL_UINT64;
    case NC_FLOAT: return NC_FILL_FLOAT;
    case NC_DOUBLE: return NC_FILL_DOUBLE;
    default: return std::nullopt;
    }
}

/// A number as the type stores it; nothing if it cannot. Negative ones of an unsigned type are those of the signed one.
template <class T> std::optional<T> storedAs(long double number)
{
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(number);
    } else {
        if (std::is_unsigned_v<T> && number < 0)
            number += std::ldexp(1.0L, 8 * int(sizeof(T)));
        if (!(number >= static_cast<long double>(std::numeric_limits<T>::min()) &&
              number <= static_cast<long double>(std::numeric_limits<T>::max())) ||
            number != std::trunc(number))
            return std::nullopt;
        return static_cast<T>(number);
    }
}

bool fitsStored(int type, long double number)
{
    return visitStored(type, [&]<class T>() { return storedAs<T>(number).has_value(); });
}

} // namespace

std::string numberText(long double number)
{
    if (number == std::trunc(number) && std::abs(number) < 9e18L)
        return std::to_string(static_cast<std::int64_t>(number));
    const auto single = static_cast<float>(number); // "1e+20", which is not quite that
    return single == number ? formatNumber(single) : formatNumber(static_cast<double>(number));
}

Message filledByLibrary(long double number)
{
    return Message::say("%1, with which the NetCDF library fills what was never written", numberText(number));
}

std::optional<long double> libraryFillOf(const NetCdfFile& file, const NetCdfVariable& variable)
{
    const bool isFilled = file.attributeType(variable, "_FillValue") == 0 && file.fillsUnwritten(variable);
    return isFilled ? defaultFillOf(variable.type) : std::nullopt;
}

namespace {

/// A number with a fraction of packed whole numbers is one of unpacked values.
bool isOfUnpacked(const StoredNumbers& stored, int attributeType, long double number)
{
    return stored.isPacked && !isFloating(stored.type) && isFloating(attributeType) && !fitsStored(stored.type, number);
}

/// Limits of a type that packed whole numbers do not have are limits of the values.
bool areOfUnpacked(const StoredNumbers& stored, int attributeType)
{
    return stored.isPacked && !isFloating(stored.type) && isFloating(attributeType);
}

void addNoValues(const NetCdfFile& file, const NetCdfVariable& variable, StoredNumbers& stored)
{
    std::vector<std::string> texts;
    for (const char* name : {"_FillValue", "missing_value"})
        for (const long double number : file.numbers(variable, name)) {
            if (isOfUnpacked(stored, file.attributeType(variable, name), number))
                stored.noUnpackedValue.push_back(static_cast<double>(number));
            else
                stored.noValue.push_back(number);
            if (const std::string text = numberText(number); std::ranges::find(texts, text) == texts.end())
                texts.push_back(text);
        }
    std::string list;
    for (const std::string& text : texts)
        list += (list.empty() ? "" : ", ") + text;
    stored.saysNoValue = Message(list);
    stored.defaultFill = libraryFillOf(file, variable);
    if (stored.defaultFill && stored.type != variable.type && *stored.defaultFill < 0)
        stored.defaultFill = *stored.defaultFill + std::ldexp(1.0L, 8 * int(netCdfTypeBytes(stored.type)));
}

void addLimits(const NetCdfFile& file, const NetCdfVariable& variable, StoredNumbers& stored)
{
    std::optional<long double> least, most;
    int type = 0;
    if (const auto range = file.numbers(variable, "valid_range"); range.size() == 2) {
        least = range[0];
        most = range[1];
        type = file.attributeType(variable, "valid_range");
    } else {
        if (const auto limit = file.numbers(variable, "valid_min"); limit.size() == 1)
            least = limit[0], type = file.attributeType(variable, "valid_min");
        if (const auto limit = file.numbers(variable, "valid_max"); limit.size() == 1)
            most = limit[0], type = file.attributeType(variable, "valid_max");
    }
    if (!least && !most)
        return;
    const Message limits = least && most ? Message::say("all beyond %1 to %2", numberText(*least), numberText(*most))
                           : least       ? Message::say("all below %1", numberText(*least))
                                         : Message::say("all above %1", numberText(*most));
    stored.saysNoValue = stored.saysNoValue.empty() ? limits : Message::say("%1, %2", stored.saysNoValue, limits);
    if (areOfUnpacked(stored, type)) {
        stored.leastUnpacked = static_cast<double>(least.value_or(stored.leastUnpacked));
        stored.mostUnpacked = static_cast<double>(most.value_or(stored.mostUnpacked));
        return;
    }
    const auto asStored = [&](long double limit) { // signed limits of unsigned numbers
        const bool wraps = limit < 0 && stored.type != variable.type;
        return wraps ? limit + std::ldexp(1.0L, 8 * int(netCdfTypeBytes(stored.type))) : limit;
    };
    stored.least = asStored(least.value_or(stored.least));
    stored.most = asStored(most.value_or(stored.most));
    if (stored.type == NC_FLOAT) { // as the numbers were rounded
        stored.least = static_cast<float>(stored.least);
        stored.most = static_cast<float>(stored.most);
    }
}

/// The stored numbers that stand for no value, in their own type.
template <class T> struct NoValues {
    std::vector<T> numbers;
    std::optional<T> defaultFill;

    explicit NoValues(const StoredNumbers& stored)
    {
        for (const long double number : stored.noValue)
            if (const auto value = storedAs<T>(number))
                numbers.push_back(*value);
        if (stored.defaultFill)
            defaultFill = storedAs<T>(*stored.defaultFill);
    }
};

enum class ValueKind : std::uint8_t { Value, NoValue, DefaultFill };

/// Judges and converts each stored number.
template <class T> class Decoder {
public:
    explicit Decoder(const StoredNumbers& stored) : stored_(stored), none_(stored)
    {
        hasLimits_ = std::isfinite(stored.least) || std::isfinite(stored.most);
        hasUnpackedLimits_ = std::isfinite(stored.leastUnpacked) || std::isfinite(stored.mostUnpacked);
    }

    ValueKind kindOf(T number) const
    {
        for (const T none : none_.numbers)
            if (number == none)
                return ValueKind::NoValue;
        if (none_.defaultFill && number == *none_.defaultFill)
            return ValueKind::DefaultFill;
        if (hasLimits_ && (number < stored_.least || number > stored_.most))
            return ValueKind::NoValue;
        if (stored_.noUnpackedValue.empty() && !hasUnpackedLimits_)
            return ValueKind::Value;
        const double value = valueOf(number);
        for (const double none : stored_.noUnpackedValue)
            if (value == none)
                return ValueKind::NoValue;
        return value < stored_.leastUnpacked || value > stored_.mostUnpacked ? ValueKind::NoValue : ValueKind::Value;
    }
    double valueOf(T number) const
    {
        const auto value = static_cast<double>(number);
        return stored_.isPacked ? value * stored_.scale + stored_.offset : value;
    }

private:
    const StoredNumbers& stored_;
    NoValues<T> none_;
    bool hasLimits_ = false;
    bool hasUnpackedLimits_ = false;
};

/// The type that holds all of the values, and holes.
template <class T> SampleType typeFor(const StoredNumbers& stored, bool hasHoles, bool fitsInt32)
{
    if (stored.isPacked)
        return stored.unpacksToFloat ? SampleType::Float32 : SampleType::Float64;
    if constexpr (std::is_floating_point_v<T>)
        return sampleTypeOf<T>();
    else if constexpr (sizeof(T) == 8)
        return fitsInt32 && !hasHoles ? SampleType::Int32 : SampleType::Float64;
    else
        return !hasHoles ? sampleTypeOf<T>() : sizeof(T) < 4 ? SampleType::Float32 : SampleType::Float64;
}

template <class T> NetCdfSamples decoded(const StoredNumbers& stored, std::span<const T> numbers)
{
    const Decoder<T> decoder(stored);
    NetCdfSamples result;
    bool fitsInt32 = true;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const T number : numbers) {
        const ValueKind kind = decoder.kindOf(number);
        result.holes += kind != ValueKind::Value;
        result.isDefaultFill |= kind == ValueKind::DefaultFill;
        if (kind != ValueKind::Value)
            continue;
        const double value = decoder.valueOf(number);
        least = std::min(least, value);
        most = std::max(most, value);
        if constexpr (sizeof(T) == 8 && !std::is_floating_point_v<T>)
            fitsInt32 = fitsInt32 && std::in_range<std::int32_t>(number);
    }
    result.isConstant = !(least < most);
    result.type = typeFor<T>(stored, result.holes > 0, fitsInt32);
    if (!stored.isPacked && sizeof(T) == 8 && !std::is_floating_point_v<T> && !fitsInt32)
        result.remarks.push_back(
            Message::say("Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits."));
    result.samples.resize(numbers.size() * sampleSize(result.type));
    visitSampleType(result.type, [&]<class S>() {
        S* samples = reinterpret_cast<S*>(result.samples.data());
        for (std::size_t at = 0; at < numbers.size(); ++at) {
            const bool isValue = decoder.kindOf(numbers[at]) == ValueKind::Value;
            if constexpr (std::is_floating_point_v<S>)
                samples[at] =
                    isValue ? static_cast<S>(decoder.valueOf(numbers[at])) : std::numeric_limits<S>::quiet_NaN();
            else
                samples[at] = static_cast<S>(numbers[at]); // there are no holes, and all fit
        }
    });
    return result;
}

/// Reads layers of the first dimension that has several, so many at a time that cancelling and progress have a chance
/// and packed pieces are unpacked once or twice.
Status readInPieces(const NetCdfFile& file, const NetCdfVariable& variable, const NetCdfPart& part, std::byte* to,
                    const std::function<void(double)>& progress)
{
    constexpr std::uint64_t pieceBytes = std::uint64_t(256) << 20;
    const std::uint64_t all = valueCount(part) * netCdfTypeBytes(variable.type);
    const auto slowest = std::ranges::find_if(part.count, [](std::size_t count) { return count > 1; });
    if (slowest == part.count.end() || all <= pieceBytes)
        return all == 0 ? Status() : file.readStored(variable, part, to);
    const auto axis = static_cast<std::size_t>(slowest - part.count.begin());
    const std::uint64_t layerBytes = all / *slowest;
    const std::size_t layers = std::max<std::uint64_t>(1, pieceBytes / layerBytes);
    for (std::size_t done = 0; done < *slowest; done += layers) {
        NetCdfPart piece = part;
        piece.first[axis] += done;
        piece.count[axis] = std::min(layers, *slowest - done);
        if (const Status read = file.readStored(variable, piece, to + done * layerBytes); !read)
            return read;
        progress(static_cast<double>(done) / static_cast<double>(*slowest));
    }
    return {};
}

} // namespace

StoredNumbers storedNumbers(const NetCdfFile& file, const NetCdfVariable& variable)
{
    StoredNumbers stored;
    const std::string isUnsigned = file.text(variable, "_Unsigned");
    stored.type = isUnsigned == "true" || isUnsigned == "True" ? unsignedOf(variable.type) : variable.type;
    const auto scale = file.numbers(variable, "scale_factor"), offset = file.numbers(variable, "add_offset");
    stored.isPacked = scale.size() == 1 || offset.size() == 1;
    if (scale.size() == 1)
        stored.scale = static_cast<double>(scale[0]);
    if (offset.size() == 1)
        stored.offset = static_cast<double>(offset[0]);
    const auto isFloat = [&](const char* name) {
        const int type = file.attributeType(variable, name);
        return type == NC_FLOAT || type == 0;
    };
    stored.unpacksToFloat = stored.type != NC_DOUBLE && isFloat("scale_factor") && isFloat("add_offset");
    addNoValues(file, variable, stored);
    addLimits(file, variable, stored);
    return stored;
}

SampleType sampleTypeOf(const StoredNumbers& stored)
{
    return visitStored(stored.type, [&]<class T>() { return typeFor<T>(stored, false, true); });
}

Result<NetCdfSamples> readSamples(const NetCdfFile& file, const NetCdfVariable& variable, const NetCdfPart& part,
                                  const std::function<void(double)>& progress)
{
    const StoredNumbers stored = storedNumbers(file, variable);
    const std::uint64_t count = valueCount(part);
    if (const std::uint64_t machine = physicalBytes();
        machine > 0 && count > machine / 2 / netCdfTypeBytes(variable.type))
        return Error{ErrorKind::OutOfResource, Message::say("its variable '%1' has %2 values, which do not fit into "
                                                            "half of the memory of this machine. Choose a smaller one.",
                                                            printable(variable.name), count)};
    Buffer<std::byte> numbers(count * netCdfTypeBytes(variable.type));
    if (const Status read = readInPieces(file, variable, part, numbers.data(), progress); !read)
        return read.error();
    return visitStored(stored.type, [&]<class T>() {
        return decoded<T>(stored, std::span(reinterpret_cast<const T*>(numbers.data()), count));
    });
}

Result<std::vector<double>> readValues(const NetCdfFile& file, const NetCdfVariable& variable, const NetCdfPart& part)
{
    const auto samples = readSamples(file, variable, part, [](double) {});
    if (!samples)
        return samples.error();
    std::vector<double> values;
    visitSampleType(samples->type, [&]<class T>() {
        const T* first = reinterpret_cast<const T*>(samples->samples.data());
        values.assign(first, first + samples->samples.size() / sizeof(T));
    });
    return values;
}

} // namespace tetra
