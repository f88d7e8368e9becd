// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd_layout.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/nrrd_files.h"
#include "plugins/readers/lattice/nrrd_geometry.h"

namespace tetra {

namespace {

Status missing(const NrrdFields& fields, const std::string& field)
{
    if (!fields[field].empty())
        return {};
    return Error{ErrorKind::BadInput, Message::say("its header has no field '%1'. Add it.", field)};
}

Status parseEncoding(const NrrdFields& fields, SampleLayout& layout)
{
    const Result<SampleType> type = parseSampleType(fields["type"]);
    if (!type)
        return type.error();
    layout.type = *type;
    const Result<SampleEncoding> encoding = parseSampleEncoding(fields["encoding"]);
    if (!encoding)
        return encoding.error();
    layout.encoding = *encoding;
    const bool needsOrder = sampleSize(layout.type) > 1 && layout.encoding != SampleEncoding::Text;
    if (needsOrder)
        if (const Status there = missing(fields, "endian"); !there)
            return there.error();
    if (!fields["endian"].empty()) {
        const Result<std::endian> order = parseByteOrder(fields["endian"]);
        if (!order)
            return order.error();
        layout.order = *order;
    }
    return {};
}

Status parseSkips(const NrrdFields& fields, SampleLayout& layout)
{
    if (fields.has("line skip")) {
        const auto lines = parseNumber<std::uint64_t>(fields["line skip"]);
        if (!lines)
            return Error{ErrorKind::BadInput, Message::say("its 'line skip' must be a whole number from 0.")};
        layout.skippedLines = *lines;
    }
    if (fields.has("byte skip")) {
        const auto bytes = parseNumber<std::int64_t>(fields["byte skip"]);
        if (!bytes || *bytes < -1 || (*bytes == -1 && layout.encoding != SampleEncoding::Raw))
            return Error{
                ErrorKind::BadInput,
                Message::say(
                    "its 'byte skip' must be a whole number from 0, or -1 for raw data at the end of the file.")};
        layout.atEndOfFile = *bytes == -1;
        layout.skippedBytes = *bytes > 0 ? static_cast<std::uint64_t>(*bytes) : 0;
    }
    return {};
}

/// Which fields say where it lies, and the unit of the samples.
std::vector<Taken> takenOf(const NrrdFields& fields)
{
    std::vector<Taken> taken;
    if (fields.has("space directions"))
        taken.push_back({TakenPart::Frame, Message::say("space directions"), false});
    std::string_view unit = fields["sample units"];
    if (unit.size() > 1 && unit.front() == '"' && unit.back() == '"')
        unit = trimmed(unit.substr(1, unit.size() - 2));
    if (!unit.empty() && unit != "???") // the format's way of saying that it is not known
        taken.push_back({TakenPart::Unit, Message(printable(unit)), false});
    return taken;
}

/// Of the fields that are accepted and not used those that would change what the data mean.
std::vector<Message> leftOutOf(const NrrdFields& fields)
{
    std::vector<Message> leftOut;
    if (fields.has("old min") || fields.has("old max"))
        leftOut.push_back(Message::say("Its samples stand for numbers from %1 to %2 ('old min', 'old max'), from which "
                                       "they were quantized; they are taken as they are stored.",
                                       fields.has("old min") ? printable(fields["old min"]) : std::string("?"),
                                       fields.has("old max") ? printable(fields["old max"]) : std::string("?")));
    const bool placesTwice = fields.has("spacings") || fields.has("axis mins") || fields.has("axis maxs");
    if (fields.has("space directions") && placesTwice)
        leftOut.push_back(Message::say("Its spacings and the ends of its axes are not used: its space directions say "
                                       "where it lies."));
    return leftOut;
}

} // namespace

Result<NrrdLayout> nrrdLayout(const NrrdFields& fields)
{
    for (const std::string field : {"type", "dimension", "sizes", "encoding"})
        if (const Status there = missing(fields, field); !there)
            return there.error();
    NrrdLayout layout;
    if (const Status parsed = parseEncoding(fields, layout.samples); !parsed)
        return parsed.error();
    if (const Status parsed = parseSkips(fields, layout.samples); !parsed)
        return parsed.error();
    const Result<Lattice> lattice = nrrdLattice(fields);
    if (!lattice)
        return lattice.error();
    layout.samples.lattice = *lattice;
    layout.samples.space = nrrdSpace(fields);
    layout.samples.lengthUnit = nrrdLengthUnit(fields);
    layout.samples.untold =
        untoldPlacement(tellsNrrdSpacing(fields), tellsNrrdOrigin(fields), !layout.samples.lengthUnit.empty());
    layout.samples.stepsToOrigin = nrrdStepsToOrigin(fields);
    layout.samples.remarks = nrrdPlaceRemarks(fields);
    layout.samples.taken = takenOf(fields);
    layout.samples.leftOut = leftOutOf(fields);
    auto files = nrrdDataFiles(fields);
    if (!files)
        return files.error();
    layout.dataFiles = *std::move(files);
    return layout;
}

} // namespace tetra
