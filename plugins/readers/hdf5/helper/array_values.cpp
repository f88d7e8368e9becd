// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/array_values.h"

#include "plugins/readers/hdf5/helper/attributes.h"
#include "plugins/readers/hdf5/helper/hdf5_filters.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

namespace tetra {
namespace {

constexpr std::uint64_t noBytes = ~std::uint64_t(0);

/// How many chunks, or other parts, an array should have and how many were written.
struct Written {
    std::uint64_t parts = 1;
    std::uint64_t there = 1;
};

Result<Written> writtenOf(hid_t opened, hid_t creation, const Hdf5Array& array)
{
    Written written;
    const std::size_t rank = array.size.size();
    std::vector<hsize_t> chunk(rank);
    if (H5Pget_layout(creation) == H5D_CHUNKED &&
        H5Pget_chunk(creation, static_cast<int>(rank), chunk.data()) == static_cast<int>(rank)) {
        const Hdf5Id space(H5Dget_space(opened), H5Sclose);
        hsize_t chunks = 0;
        if (!space || H5Dget_num_chunks(opened, space, &chunks) < 0)
            return hdf5Error(Message::say("the chunks of its array '%1'", printable(array.path)));
        for (std::size_t dimension = 0; dimension < rank; ++dimension) {
            const std::uint64_t along = (array.size[dimension] - 1) / std::max<hsize_t>(1, chunk[dimension]) + 1;
            written.parts = written.parts > noBytes / along ? noBytes : written.parts * along;
        }
        written.there = chunks;
        return written;
    }
    H5D_space_status_t status = H5D_SPACE_STATUS_NOT_ALLOCATED;
    H5Dget_space_status(opened, &status);
    written.there = status == H5D_SPACE_STATUS_NOT_ALLOCATED ? 0 : 1;
    return written;
}

std::string numberText(long double number)
{
    if (number == std::trunc(number) && std::abs(number) < 9e18L)
        return std::to_string(static_cast<std::int64_t>(number));
    return formatNumber(static_cast<double>(number));
}

void addNoValue(long double number, StoredMeaning& meaning, std::string& list)
{
    if (std::ranges::find(meaning.noValue, number) != meaning.noValue.end())
        return;
    meaning.noValue.push_back(number);
    list += (list.empty() ? "" : ", ") + numberText(number);
}

/// The fill value that the array's creation says, of arrays of single numbers.
std::optional<long double> givenFill(hid_t creation, const Hdf5Array& array)
{
    H5D_fill_value_t status = H5D_FILL_VALUE_UNDEFINED;
    long double fill = 0;
    if (array.element.components != 1 || H5Pfill_value_defined(creation, &status) < 0 ||
        status != H5D_FILL_VALUE_USER_DEFINED || H5Pget_fill_value(creation, H5T_NATIVE_LDOUBLE, &fill) < 0)
        return std::nullopt;
    return fill;
}

bool isFilled(hid_t creation)
{
    H5D_fill_value_t status = H5D_FILL_VALUE_UNDEFINED;
    H5D_fill_time_t time = H5D_FILL_TIME_NEVER;
    return H5Pfill_value_defined(creation, &status) >= 0 && status != H5D_FILL_VALUE_UNDEFINED &&
           H5Pget_fill_time(creation, &time) >= 0 && time != H5D_FILL_TIME_NEVER;
}

Status checkWritten(const Written& written, hid_t creation, const Hdf5Array& array)
{
    if (written.there == 0)
        return Error{ErrorKind::BadInput, Message::say("nothing was written to its array %1: it holds only a fill "
                                                       "value. Choose another array, or write this one.",
                                                       arrayText(array))};
    if (written.there < written.parts && !isFilled(creation))
        return Error{ErrorKind::BadInput, Message::say("only %1 of the %2 chunks of its array '%3' were written, and "
                                                       "it has no fill value for the others. Write all of it.",
                                                       written.there, written.parts, printable(array.path))};
    return {};
}

void findFill(hid_t opened, hid_t creation, const Written& written, const Hdf5Array& array, StoredMeaning& meaning)
{
    std::string said, given;
    for (const char* name : {"_FillValue", "missing_value"})
        for (const long double number : attributeNumbers(opened, name))
            addNoValue(number, meaning, said);
    const auto fill = givenFill(creation, array);
    if (fill && *fill != 0)
        addNoValue(*fill, meaning, given);
    Message what(said);
    if (!given.empty())
        what = said.empty() ? Message::say("%1, the array's fill value", given)
                            : Message::say("%1, %2, the array's fill value", said, given);
    else if (written.there < written.parts && (!fill || *fill == 0) && meaning.noValue.empty())
        what = Message::say("0 in %1 of %2 chunks, which were never written", written.parts - written.there,
                            written.parts);
    if (!what.empty())
        meaning.fill = Taken{TakenPart::Fill, what, said.empty()};
}

/// The stored numbers that stand for no value, in their own type.
template <class T> std::vector<T> noValuesAs(const StoredMeaning& meaning)
{
    std::vector<T> numbers;
    for (const long double number : meaning.noValue)
        if constexpr (std::is_floating_point_v<T>)
            numbers.push_back(static_cast<T>(number));
        else if (number >= static_cast<long double>(std::numeric_limits<T>::min()) &&
                 number <= static_cast<long double>(std::numeric_limits<T>::max()) && number == std::trunc(number))
            numbers.push_back(static_cast<T>(number));
    return numbers;
}

template <class T> bool isValue(T number, const std::vector<T>& none)
{
    return std::ranges::find(none, number) == none.end();
}

/// The type that holds all of the values, and holes.
template <class T> SampleType typeFor(const StoredMeaning& meaning, bool isMagnitude, bool hasHoles, bool fitsInt32)
{
    if (meaning.isPacked)
        return meaning.unpacksToFloat ? SampleType::Float32 : SampleType::Float64;
    if constexpr (std::is_floating_point_v<T>)
        return sampleTypeOf<T>();
    else if (isMagnitude || hasHoles)
        return sizeof(T) < 4 ? SampleType::Float32 : SampleType::Float64;
    else if constexpr (sizeof(T) == 8)
        return fitsInt32 ? SampleType::Int32 : SampleType::Float64;
    else
        return sampleTypeOf<T>();
}

std::uint64_t pointsOf(const ArrayPart& part)
{
    std::uint64_t points = 1;
    for (const hsize_t count : part.count)
        points = count != 0 && points > noBytes / count ? noBytes : points * count;
    return points;
}

/// How elements lie in memory when one of their components, or all, are read.
struct MemoryElement {
    Hdf5Id type;
    std::uint64_t components = 1; ///< read at once
    std::uint64_t wanted = 0;     ///< of these
};

MemoryElement memoryElement(const ElementType& element, std::uint64_t component)
{
    const hid_t number = memoryType(element.kind);
    if (!element.members.empty()) {
        Hdf5Id record(H5Tcreate(H5T_COMPOUND, H5Tget_size(number)), H5Tclose);
        H5Tinsert(record, element.members[component].c_str(), 0, number);
        return {std::move(record)};
    }
    if (!element.shape.empty())
        return {Hdf5Id(H5Tarray_create2(number, static_cast<unsigned>(element.shape.size()), element.shape.data()),
                       H5Tclose),
                element.components, component};
    return {Hdf5Id(H5Tcopy(number), H5Tclose)};
}

/// Reads one component of a part of an array into `to`, in layers of its slowest dimension, so many at a time that
/// cancelling has a chance, and as many as a chunk has, so that none is unpacked twice.
class LayerReader {
public:
    LayerReader(hid_t opened, const Hdf5Array& array, const ArrayAxes* axes, const ArrayPart& part)
        : opened_(opened), array_(array), axes_(axes), part_(part)
    {
    }

    template <class T>
    Status read(std::uint64_t component, std::span<T> to, const std::function<void(double)>& progress) const
    {
        constexpr std::uint64_t pieceBytes = std::uint64_t(64) << 20;
        const MemoryElement element = memoryElement(array_.element, axes_ == nullptr ? component : 0);
        const auto slowest = static_cast<std::size_t>(
            std::ranges::find_if(part_.count, [](hsize_t count) { return count > 1; }) - part_.count.begin());
        const std::uint64_t all = part_.count[slowest], layer = to.size() / all;
        const std::uint64_t layerBytes = layer * sizeof(T) * element.components, chunk = chunkAlong(slowest);
        const std::uint64_t layers = (std::max<std::uint64_t>(1, pieceBytes / layerBytes) + chunk - 1) / chunk * chunk;
        Buffer<T> several(element.components == 1 ? 0 : std::min(layers, all) * layer * element.components);
        for (std::uint64_t done = 0; done < all; done += layers) {
            const std::uint64_t count = std::min(layers, all - done);
            T* place = to.data() + done * layer;
            if (const Status read =
                    readPiece(slowest, done, count, component, element, several.empty() ? place : several.data());
                !read)
                return read;
            for (std::size_t at = 0; !several.empty() && at < count * layer; ++at)
                place[at] = several[at * element.components + element.wanted];
            progress(static_cast<double>(done + count) / static_cast<double>(all));
        }
        return {};
    }

private:
    std::uint64_t chunkAlong(std::size_t dimension) const
    {
        const Hdf5Id creation(H5Dget_create_plist(opened_), H5Pclose);
        std::vector<hsize_t> chunk(array_.size.size(), 1);
        const bool isChunked = H5Pget_layout(creation) == H5D_CHUNKED &&
                               H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()) > 0;
        return isChunked ? std::max<hsize_t>(1, chunk[dimension]) : 1;
    }

    Status readPiece(std::size_t slowest, std::uint64_t first, std::uint64_t count, std::uint64_t component,
                     const MemoryElement& element, void* to) const
    {
        std::vector<hsize_t> from = part_.first, counts = part_.count;
        from[slowest] += first;
        counts[slowest] = count;
        if (axes_ != nullptr)
            from[*axes_->component] = component;
        const Hdf5Id inFile(H5Dget_space(opened_), H5Sclose);
        const Hdf5Id inMemory(H5Screate_simple(static_cast<int>(counts.size()), counts.data(), nullptr), H5Sclose);
        if (!inFile || !inMemory || !element.type ||
            H5Sselect_hyperslab(inFile, H5S_SELECT_SET, from.data(), nullptr, counts.data(), nullptr) < 0 ||
            H5Dread(opened_, element.type, inMemory, inFile, H5P_DEFAULT, to) < 0)
            return hdf5Error(Message::say("its array '%1'", printable(array_.path)));
        return {};
    }

    hid_t opened_;
    const Hdf5Array& array_;
    const ArrayAxes* axes_; ///< of arrays whose components lie along a dimension, else null
    const ArrayPart& part_;
};

template <class T> ArraySamples decoded(const StoredMeaning& meaning, Buffer<T> numbers)
{
    const std::vector<T> none = noValuesAs<T>(meaning);
    bool hasHoles = false, fitsInt32 = true;
    for (const T number : numbers) {
        const bool isOne = isValue(number, none);
        hasHoles |= !isOne;
        if constexpr (sizeof(T) == 8 && !std::is_floating_point_v<T>)
            fitsInt32 = fitsInt32 && (!isOne || std::in_range<std::int32_t>(number));
    }
    ArraySamples result{.type = typeFor<T>(meaning, false, hasHoles, fitsInt32)};
    if (!meaning.isPacked && sizeof(T) == 8 && !std::is_floating_point_v<T> && !fitsInt32)
        result.remarks.push_back(
            Message::say("Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits."));
    result.samples.resize(numbers.size() * sampleSize(result.type));
    visitSampleType(result.type, [&]<class S>() {
        S* samples = reinterpret_cast<S*>(result.samples.data());
        for (std::size_t at = 0; at < numbers.size(); ++at)
            if constexpr (std::is_floating_point_v<S>) {
                const auto value = static_cast<double>(numbers[at]);
                samples[at] = !isValue(numbers[at], none) ? std::numeric_limits<S>::quiet_NaN()
                              : meaning.isPacked          ? static_cast<S>(value * meaning.scale + meaning.offset)
                                                          : static_cast<S>(value);
            } else {
                samples[at] = static_cast<S>(numbers[at]); // there are no holes, and all fit
            }
    });
    return result;
}

/// The lengths of all components together; none where one of them has no value.
template <class T> Result<ArraySamples> magnitudes(const LayerReader& reader, const StoredMeaning& meaning,
                                                   const ArrayPart& part, const std::function<void(double)>& progress)
{
    const std::vector<T> none = noValuesAs<T>(meaning);
    Buffer<T> numbers(pointsOf(part));
    std::vector<double> lengths(numbers.size(), 0);
    for (std::uint64_t component = 0; component < part.components; ++component) {
        const auto within = [&](double fraction) {
            progress((static_cast<double>(component) + fraction) / static_cast<double>(part.components));
        };
        if (const Status read = reader.read<T>(component, numbers, within); !read)
            return read.error();
        for (std::size_t at = 0; at < lengths.size(); ++at) {
            const double value = static_cast<double>(numbers[at]) * meaning.scale + meaning.offset;
            lengths[at] =
                isValue(numbers[at], none) ? std::hypot(lengths[at], value) : std::numeric_limits<double>::quiet_NaN();
        }
    }
    ArraySamples result{.type = typeFor<T>(meaning, true, false, false)};
    result.samples.resize(lengths.size() * sampleSize(result.type));
    visitSampleType(result.type, [&]<class S>() {
        std::ranges::transform(lengths, reinterpret_cast<S*>(result.samples.data()),
                               [](double length) { return static_cast<S>(length); });
    });
    return result;
}

} // namespace

Result<StoredMeaning> storedMeaning(hid_t file, const Hdf5Array& array)
{
    const Hdf5Id opened = openArray(file, array.path);
    const Hdf5Id creation(opened ? H5Dget_create_plist(opened) : H5I_INVALID_HID, H5Pclose);
    if (!creation)
        return hdf5Error(Message::say("its array '%1'", printable(array.path)));
    const auto written = writtenOf(opened, creation, array);
    if (!written)
        return written.error();
    if (const Status there = checkWritten(*written, creation, array); !there)
        return there.error();
    if (const Status unpacks = checkFilters(creation, array.path); !unpacks)
        return unpacks.error();
    StoredMeaning meaning;
    const auto scale = attributeNumbers(opened, "scale_factor"), offset = attributeNumbers(opened, "add_offset");
    meaning.isPacked = scale.size() == 1 || offset.size() == 1;
    if (scale.size() == 1)
        meaning.scale = static_cast<double>(scale[0]);
    if (offset.size() == 1)
        meaning.offset = static_cast<double>(offset[0]);
    const auto isSingle = [&](const char* name) {
        return !hasAttribute(opened, name) || isSingleAttribute(opened, name);
    };
    meaning.unpacksToFloat =
        array.element.kind != NumberKind::Double && isSingle("scale_factor") && isSingle("add_offset");
    findFill(opened, creation, *written, array, meaning);
    return meaning;
}

SampleType sampleTypeOf(const StoredMeaning& meaning, const Hdf5Array& array, const ArrayPart& part)
{
    return visitNumber(array.element.kind,
                       [&]<class T>() { return typeFor<T>(meaning, !part.component, false, true); });
}

std::uint64_t neededBytes(const Hdf5Array& array, const ArrayPart& part)
{
    const std::uint64_t each = 2 * sizeof(double) + numberBytes(array.element.kind), points = pointsOf(part);
    return points > noBytes / each ? noBytes : points * each;
}

Result<ArraySamples> readSamples(hid_t file, const Hdf5Array& array, const ArrayAxes& axes, const ArrayPart& part,
                                 const StoredMeaning& meaning, const std::function<void(double)>& progress)
{
    const Hdf5Id opened = openArray(file, array.path);
    if (!opened)
        return hdf5Error(Message::say("its array '%1'", printable(array.path)));
    const LayerReader reader(opened, array, axes.component ? &axes : nullptr, part);
    auto result = visitNumber(array.element.kind, [&]<class T>() -> Result<ArraySamples> {
        if (!part.component)
            return magnitudes<T>(reader, meaning, part, progress);
        Buffer<T> numbers(pointsOf(part));
        if (const Status read = reader.read<T>(*part.component, numbers, progress); !read)
            return read.error();
        return decoded<T>(meaning, std::move(numbers));
    });
    if (result && array.element.losesDigits)
        result->remarks.push_back(Message::say(
            "Its numbers of more than 64 bits were converted to floating-point numbers, which are exact to 53 bits."));
    return result;
}

} // namespace tetra
