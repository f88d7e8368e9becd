// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/grid_findings.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/netcdf/helper/axes.h"
#include "plugins/readers/netcdf/helper/calendar.h"
#include "plugins/readers/netcdf/helper/fields.h"
#include "plugins/readers/netcdf/helper/places.h"
#include "plugins/readers/netcdf/helper/stored_values.h"

#include <algorithm>

namespace tetra {
namespace {

/// A field with all that is taken of it but its values.
struct PlacedField {
    NetCdfField field;
    FieldPart part;
    FieldPlaces places;
    std::vector<Taken> taken{}; ///< in the order of TakenPart
};

/// "2 of 5, 1900-01-01 00:30 (0.5 hours since 1900-01-01)"; "2 of 5, time 0.5 (months since 1900-01-01)" of units that
/// make no date; a text where the file has texts for times.
Result<std::optional<Taken>> takenTime(const NetCdfFile& file, const NetCdfField& field, const FieldPart& part,
                                       bool isGiven)
{
    const std::uint64_t steps = field.time ? lengthOf(file, field, *field.time) : 1;
    if (steps < 2)
        return std::optional<Taken>();
    const std::size_t dimension = field.variable->dimensions[*field.time];
    Message time = Message::say("%1 of %2", part.timeIndex + 1, steps);
    const NetCdfVariable* times = timesAlong(file, *field.variable, dimension);
    const NetCdfVariable* texts = file.findFrom(*field.variable, "Times"); // of WRF
    if (times != nullptr) {
        const auto value = readValues(file, *times, {{part.timeIndex}, {1}});
        if (!value)
            return value.error();
        const std::string units = file.text(*times, "units");
        const std::string number = formatNumber((*value)[0]);
        const auto date = dateOf((*value)[0], units, file.text(*times, "calendar"));
        time = date            ? Message::say("%1, %2 (%3 %4)", time, *date, number, printable(units))
               : units.empty() ? Message::say("%1, time %2", time, number)
                               : Message::say("%1, time %2 (%3)", time, number, printable(units));
    } else if (texts != nullptr && texts->dimensions.size() == 2 && texts->dimensions[0] == dimension) {
        const auto all = file.readTexts(*texts);
        if (all && part.timeIndex < all->size())
            time = Message::say("%1, %2", time, printable((*all)[part.timeIndex]));
    }
    return std::optional(Taken{TakenPart::TimeStep, time, !isGiven});
}

Result<PlacedField> placed(const NetCdfFile& file, const NetCdfField& field, bool isChoice,
                           const NetCdfRequest& request)
{
    auto part = partOf(file, field, request);
    if (!part)
        return part.error();
    auto places = placesOf(file, field, *part);
    if (!places)
        return places.error();
    if (const Status fits = checkUntold(request.given, places->untold); !fits)
        return fits.error();
    const auto time = takenTime(file, field, *part, request.timeIsGiven);
    if (!time)
        return time.error();
    PlacedField result{field, *std::move(part), *std::move(places)};
    const auto add = [&](const std::vector<Taken>& taken) {
        result.taken.insert(result.taken.end(), taken.begin(), taken.end());
    };
    if (isChoice)
        add({{TakenPart::Array, Message(printable(field.variable->path)), isAutomatic(request)}});
    add(result.places.taken);
    add(result.part.taken);
    if (*time)
        add({**time});
    if (const std::string unit = file.text(*field.variable, "units"); !unit.empty() && unit != "1")
        add({{TakenPart::Unit, Message(printable(unit)), false}});
    const StoredNumbers stored = storedNumbers(file, *field.variable);
    if (!stored.saysNoValue.empty())
        add({{TakenPart::Fill, stored.saysNoValue, false}});
    return result;
}

struct ReadField {
    NetCdfField field;
    NetCdfSamples samples;
};

/// The values of the field that is asked for, or of the first that is not constant, else of the first.
Result<ReadField> readWanted(const NetCdfFile& file, const std::vector<NetCdfField>& fields,
                             const NetCdfRequest& request, const TellProgress& progress)
{
    const auto read = [&](const NetCdfField& field) -> Result<ReadField> {
        const auto part = partOf(file, field, request);
        if (!part)
            return part.error();
        if (const Status fits = checkLatticeSize(sizeOf(file, field)); !fits)
            return fits.error();
        auto samples = readSamples(file, *field.variable, part->part, progress);
        return samples ? Result<ReadField>(ReadField{field, *std::move(samples)}) : samples.error();
    };
    if (!isAutomatic(request)) {
        const auto chosen = chooseField(file, fields, request.array);
        return chosen ? read(*chosen) : chosen.error();
    }
    auto first = read(fields.front());
    for (std::size_t at = 1; first && first->samples.isConstant && at < fields.size() && !fields[at].isCoordinate; ++at)
        if (auto other = read(fields[at]); other && !other->samples.isConstant)
            return other;
    return first;
}

/// The field that readWanted() would take.
Result<NetCdfField> wantedField(const NetCdfFile& file, const std::vector<NetCdfField>& fields,
                                const NetCdfRequest& request)
{
    constexpr std::uint64_t mostRead = std::uint64_t(1) << 22;
    const std::uint64_t points = valueCount(file.whole(*fields.front().variable));
    if (!isAutomatic(request))
        return chooseField(file, fields, request.array);
    if (fields.size() == 1 || points > mostRead)
        return fields.front();
    const auto read = readWanted(file, fields, request, [](double) {});
    return read ? Result<NetCdfField>(read->field) : read.error();
}

/// The smallest and largest value, where the file says them.
std::optional<ValueRange> statedRange(const NetCdfFile& file, const NetCdfVariable& variable)
{
    const auto range = file.numbers(variable, "actual_range");
    if (range.size() != 2 || !(range[0] <= range[1]))
        return std::nullopt;
    return ValueRange{static_cast<double>(range[0]), static_cast<double>(range[1])};
}

} // namespace

Result<FileFindings> gridFindings(const NetCdfFile& file, const NetCdfRequest& request, const TellProgress& progress)
{
    const auto fields = fieldsOf(file);
    if (fields.empty())
        return noFields(file);
    auto read = readWanted(file, fields, request, progress);
    if (!read)
        return read.error();
    auto field = placed(file, read->field, fields.size() > 1, request);
    if (!field)
        return field.error();
    FileFindings found;
    found.kind = field->places.isLattice ? FoundKind::Lattice : FoundKind::Grid;
    found.lattice = field->places.lattice;
    found.lengthUnit = field->places.lengthUnit;
    found.untold = field->places.untold;
    found.type = read->samples.type;
    found.samples = std::move(read->samples.samples);
    found.arrayName = field->field.variable->path;
    found.remarks = std::move(field->places.remarks);
    found.remarks.insert(found.remarks.end(), read->samples.remarks.begin(), read->samples.remarks.end());
    found.taken = std::move(field->taken);
    const StoredNumbers stored = storedNumbers(file, *field->field.variable);
    if (read->samples.isDefaultFill && stored.defaultFill) {
        const Message filled = filledByLibrary(*stored.defaultFill);
        std::erase_if(found.taken, [](const Taken& taken) { return taken.part == TakenPart::Fill; });
        found.taken.push_back({TakenPart::Fill,
                               stored.saysNoValue.empty() ? filled : Message::say("%1, %2", stored.saysNoValue, filled),
                               true});
    }
    found.leftOut = std::move(field->places.leftOut);
    if (!field->places.isLattice)
        found.positions = positionsOf(file, field->field, field->places);
    return found;
}

Result<FileContents> gridContents(const NetCdfFile& file, const NetCdfRequest& request)
{
    const auto fields = fieldsOf(file);
    if (fields.empty())
        return noFields(file);
    const auto wanted = wantedField(file, fields, request);
    if (!wanted)
        return wanted.error();
    auto field = placed(file, *wanted, fields.size() > 1, request);
    if (!field)
        return field.error();
    FileContents contents;
    contents.domain = field->places.isLattice ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    contents.lattice = field->places.lattice;
    contents.points = contents.lattice.pointCount();
    contents.type = sampleTypeOf(storedNumbers(file, *wanted->variable));
    for (const NetCdfField& one : fields)
        contents.arrays.push_back({.name = one.variable->path,
                                   .range = statedRange(file, *one.variable),
                                   .unit = file.text(*one.variable, "units")});
    const auto times = timesOf(file, *wanted);
    if (!times)
        return times.error();
    contents.timeSteps = times->size() > 1 ? *times : std::vector<double>();
    contents.untold = field->places.untold;
    contents.taken = std::move(field->taken);
    contents.leftOut = std::move(field->places.leftOut);
    return contents;
}

} // namespace tetra
