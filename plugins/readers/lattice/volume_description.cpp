// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/volume_description.h"

#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/gzip_decoding.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

constexpr const char* magnitudeName = "magnitude";

Error wrongChoice(const Message& text)
{
    return {ErrorKind::WrongUsage, text};
}

std::string choiceText(const ParameterValues& values, const std::string& id)
{
    return std::string(trimmed(parameterValue<std::string>(choiceParameters(), values, id)));
}

/// Names in a row, the first ten of them.
Message namesOf(const std::vector<FileArray>& arrays)
{
    constexpr std::size_t mostNames = 10;
    Message names;
    for (std::size_t i = 0; i < std::min(arrays.size(), mostNames); ++i) {
        const std::string name = printable(arrays[i].name);
        names = names.empty() ? Message(name) : Message::say("%1, %2", names, name);
    }
    return arrays.size() > mostNames ? Message::say("%1 ...", names) : names;
}

Error inNumbersFile(const VolumeRequest& request, const std::filesystem::path& path, const Error& error)
{
    if (error.kind != ErrorKind::BadInput || path == request.path)
        return error;
    return {error.kind,
            Message::say("Cannot read '%1': %2 The header '%3' names it as its data file.", path.string(),
                         error.message, request.path.string()),
            path};
}

/// The bytes that begin with the numbers, and what keeps them.
struct NumberBytes {
    std::span<const std::byte> bytes;
    std::shared_ptr<const void> owner;
};

Result<NumberBytes> unpackedBytes(const VolumeDescription& volume, const Progress& progress)
{
    const auto packed = volume.file->bytes();
    const std::uint64_t wanted = storedBytes(volume.numbers);
    if (const std::uint64_t most = largestUnpackedSize(packed.size());
        wanted > most || volume.firstByte > most - wanted)
        return Error{ErrorKind::BadInput, Message::say("its header asks for %1 bytes, and %2 bytes of compressed data "
                                                       "cannot hold as many. It is cut short, or the header is wrong.",
                                                       wanted, packed.size())};
    const auto room = allocateSamples(SampleType::UInt8, wanted);
    if (!room)
        return room.error();
    const std::span<std::byte> bytes(room->get(), wanted);
    if (const Status unpacked = unpackGzip(packed, volume.firstByte, bytes, progress); !unpacked)
        return unpacked.error();
    return NumberBytes{bytes, *room};
}

/// What stands from the first of the numbers on.
std::span<const std::byte> bytesFromFirst(const VolumeDescription& volume)
{
    auto all = volume.file->bytes();
    if (volume.endByte)
        all = all.first(static_cast<std::size_t>(std::min<std::uint64_t>(*volume.endByte, all.size())));
    return all.subspan(static_cast<std::size_t>(std::min<std::uint64_t>(volume.firstByte, all.size())));
}

Result<NumberBytes> numberBytes(const VolumeDescription& volume, const Progress& progress)
{
    if (volume.isPacked)
        return unpackedBytes(volume, progress);
    return NumberBytes{bytesFromFirst(volume), volume.file};
}

} // namespace

std::vector<Parameter> choiceParameters()
{
    Parameter array;
    array.id = "array";
    array.label = Message::marked("Array");
    array.explanation = Message::marked("Files with several sets of values (Gaussian cube, OpenDX): one, by name or by "
                                        "number from 1; nothing takes the first.");
    array.defaultValue = std::string();
    Parameter component;
    component.id = "component";
    component.label = Message::marked("Component");
    component.explanation =
        Message::marked("Of arrays with several components: the number of one, from 0, or 'magnitude'.");
    component.defaultValue = std::string(magnitudeName);
    return {array, component};
}

Result<std::size_t> chooseArray(const ParameterValues& values, VolumeDescription& volume)
{
    const std::vector<FileArray>& arrays = volume.arrays;
    const std::string wanted = choiceText(values, "array");
    std::size_t chosen = 0;
    if (!wanted.empty()) {
        const auto named = std::ranges::find(arrays, wanted, &FileArray::name);
        const auto number = parseNumber<std::uint64_t>(wanted);
        if (named != arrays.end())
            chosen = static_cast<std::size_t>(named - arrays.begin());
        else if (number && *number >= 1 && *number <= arrays.size())
            chosen = static_cast<std::size_t>(*number - 1);
        else if (arrays.size() == 1)
            return wrongChoice(
                Message::say("it has no array '%1', but a single one. Leave '--array' out.", printable(wanted)));
        else
            return wrongChoice(Message::say("it has no array '%1'. It has %2: %3.", printable(wanted), arrays.size(),
                                            namesOf(arrays)));
    }
    volume.valueName = arrays[chosen].name;
    if (arrays.size() > 1)
        volume.taken.push_back(
            {TakenPart::Array,
             Message::say("%1, number %2 of %3", printable(arrays[chosen].name), chosen + 1, arrays.size()),
             wanted.empty()});
    return chosen;
}

Status chooseComponent(const ParameterValues& values, std::uint64_t components, VolumeDescription& volume)
{
    const std::string wanted = choiceText(values, "component");
    const bool isSaid = !wanted.empty() && wanted != magnitudeName;
    volume.numbers.components = components;
    volume.numbers.component = 0;
    if (components == 1)
        return isSaid ? Status(wrongChoice(Message::say("its values have one component. Leave '--component' out.")))
                      : Status();
    if (!isSaid) {
        volume.numbers.component.reset();
        volume.taken.push_back(
            {TakenPart::Component, Message::say("magnitude of %1", components), !values.contains("component")});
        volume.valueName += volume.valueName.empty() ? "" : " (magnitude)";
        return {};
    }
    const auto number = parseNumber<std::uint64_t>(wanted);
    if (!number || *number >= components)
        return wrongChoice(
            Message::say("'%1' is no component of values that have %2: say 'magnitude', or a number from 0 to %3.",
                         printable(wanted), components, components - 1));
    volume.numbers.component = *number;
    volume.taken.push_back({TakenPart::Component, Message::say("%1 of %2, from 0", *number, components), false});
    volume.valueName += volume.valueName.empty() ? "" : " (component " + std::to_string(*number) + ")";
    return {};
}

Status setVolumeSize(const std::array<std::uint64_t, 3>& size, VolumeDescription& volume)
{
    if (const Status checked = checkLatticeSize(size); !checked)
        return checked;
    for (std::size_t axis = 0; axis < 3; ++axis)
        volume.lattice.size[axis] = volume.numbers.size[axis] = static_cast<std::uint32_t>(size[axis]);
    return {};
}

Result<std::shared_ptr<const MappedFile>> openNumbersFile(const VolumeRequest& request, const std::string& name)
{
    const std::filesystem::path path = request.path.parent_path() / name;
    const auto file = MappedFile::open(path);
    if (!file && file.error().kind == ErrorKind::BadInput)
        return Error{
            ErrorKind::BadInput,
            Message::say("%1 The header '%2' names it as its data file.", file.error().message, request.path.string()),
            path};
    return file;
}

Result<FileContents> contentsOf(const VolumeDescription& volume)
{
    if (!volume.isPacked)
        if (const Status enough = checkStored(bytesFromFirst(volume), volume.numbers); !enough)
            return enough.error();
    FileContents contents{.domain = DomainClass::RegularLattice,
                          .lattice = volume.lattice,
                          .points = volume.lattice.pointCount(),
                          .type = sampleTypeOf(volume.numbers),
                          .arrays = volume.arrays,
                          .taken = volume.taken,
                          .leftOut = volume.leftOut,
                          .untold = volume.untold};
    std::ranges::sort(contents.taken, {}, &Taken::part); // as those of a dataset
    return contents;
}

Result<Dataset> readVolume(const VolumeRequest& request, VolumeDescription volume, const Progress& progress)
{
    constexpr double halfway = 0.5;
    const auto numbers = numberBytes(volume, progress.part(0, halfway));
    if (!numbers)
        return inNumbersFile(request, volume.file->path(), numbers.error());
    auto values = readStored(numbers->bytes, volume.numbers, volume.remarks,
                             volume.isPacked ? progress.part(halfway, 1) : progress, numbers->owner);
    if (volume.file->damaged())
        return inNumbersFile(request, volume.file->path(),
                             {ErrorKind::BadInput, Message::say("it changed while it was read. Read it again.")});
    if (!values)
        return inNumbersFile(request, volume.file->path(), values.error());
    Dataset dataset;
    dataset.lattice = volume.lattice;
    dataset.values = *values;
    dataset.source.name = request.path.filename().string();
    dataset.source.path = request.path;
    dataset.source.valueName = volume.valueName;
    dataset.source.taken = std::move(volume.taken);
    dataset.source.leftOut = std::move(volume.leftOut);
    dataset.remarks = std::move(volume.remarks);
    dataset.lengthUnit = volume.lengthUnit;
    if (!volume.isPacked && values->bytes().data() == bytesFromFirst(volume).data())
        dataset.mappedFile = volume.file;
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

} // namespace tetra
