// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd/nrrd_volume.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/nrrd/nrrd_axes.h"
#include "plugins/readers/lattice/nrrd/nrrd_fields.h"
#include "plugins/readers/lattice/nrrd/nrrd_files.h"
#include "plugins/readers/lattice/nrrd/nrrd_geometry.h"
#include "plugins/readers/lattice/nrrd/nrrd_types.h"

namespace tetra {

namespace {

Status missing(const NrrdFields& fields, const std::string& field)
{
    if (!fields[field].empty())
        return {};
    return Error{ErrorKind::BadInput, Message::say("its header has no field '%1'. Add it.", field)};
}

Status parseEncoding(const NrrdFields& fields, StoredPacking packing, StoredVolume& volume)
{
    const Result<StoredType> type = parseStoredType(fields["type"]);
    if (!type)
        return type.error();
    volume.type = *type;
    const bool needsOrder = storedSize(volume.type) > 1 && packing != StoredPacking::Text;
    if (needsOrder)
        if (const Status there = missing(fields, "endian"); !there)
            return there.error();
    if (!fields["endian"].empty()) {
        const Result<std::endian> order = parseByteOrder(fields["endian"]);
        if (!order)
            return order.error();
        volume.order = *order;
    }
    return {};
}

Status parseSkips(const NrrdFields& fields, StoredPacking packing, StoredVolume& volume)
{
    if (fields.has("line skip")) {
        const auto lines = parseNumber<std::uint64_t>(fields["line skip"]);
        if (!lines)
            return Error{ErrorKind::BadInput, Message::say("its 'line skip' must be a whole number of at least 0.")};
        volume.skippedLines = *lines;
    }
    if (fields.has("byte skip")) {
        const auto bytes = parseNumber<std::int64_t>(fields["byte skip"]);
        if (!bytes || *bytes < -1 || (*bytes == -1 && packing != StoredPacking::None))
            return Error{ErrorKind::BadInput, Message::say("its 'byte skip' must be a whole number of at least 0, or "
                                                           "-1 for raw data at the end of the file.")};
        volume.atEndOfFile = *bytes == -1;
        (packing == StoredPacking::Zlib ? volume.unpackedOffset : volume.offset) +=
            *bytes > 0 ? static_cast<std::uint64_t>(*bytes) : 0;
    }
    return {};
}

/// Which fields say where it lies, the unit of the samples; and of the fields that are accepted and not used those that
/// would change what the data mean.
void tellFields(const NrrdFields& fields, StoredVolume& volume)
{
    if (fields.has("space directions"))
        volume.taken.push_back({TakenPart::Frame, Message::say("space directions"), false});
    std::string_view unit = fields["sample units"];
    if (unit.size() > 1 && unit.front() == '"' && unit.back() == '"')
        unit = trimmed(unit.substr(1, unit.size() - 2));
    if (!unit.empty() && unit != "???") // the format's way of saying that it is not known
        volume.taken.push_back({TakenPart::Unit, Message(printable(unit)), false});
    if (fields.has("old min") || fields.has("old max"))
        volume.leftOut.push_back(Message::say("Its samples stand for numbers from %1 to %2 ('old min', 'old max'), "
                                              "from which they were quantized; they are used as stored.",
                                              fields.has("old min") ? printable(fields["old min"]) : std::string("?"),
                                              fields.has("old max") ? printable(fields["old max"]) : std::string("?")));
    const bool placesTwice = fields.has("spacings") || fields.has("axis mins") || fields.has("axis maxs");
    if (fields.has("space directions") && placesTwice)
        volume.leftOut.push_back(Message::say(
            "Its spacings and the ends of its axes are not used: its space directions state where it lies."));
}

/// Where the samples that are wanted stand among all.
Status setSamples(const NrrdFields& fields, const ParameterValues& values, StoredVolume& volume)
{
    const auto axes = parseNrrdAxes(fields);
    const auto roles = axes ? nrrdRoles(*axes) : axes.error();
    if (!roles)
        return roles.error();
    const auto size = [&](std::size_t axis) { return (*axes)[axis].size; };
    const auto stride = [&](std::size_t axis) {
        std::uint64_t numbers = 1;
        for (std::size_t faster = 0; faster < axis; ++faster)
            numbers = cappedProduct(numbers, size(faster));
        return numbers;
    };
    const std::uint64_t steps = roles->steps ? size(*roles->steps) : 1;
    volume.components = roles->components ? static_cast<std::uint32_t>(size(*roles->components)) : 1;
    const auto& points = roles->points;
    if (const Status fits = setStoredSize(volume, {size(points[0]), size(points[1]), size(points[2])}, steps); !fits)
        return fits;
    for (std::size_t i = 0; i < 3; ++i)
        volume.strides[i] = stride(points[i]);
    volume.componentStride = stride(roles->components.value_or(0));
    if (const NrrdAxis& first = (*axes)[points[0]];
        !roles->components && first.size <= 4 && first.kind.empty() && !first.spacing && !first.direction)
        volume.taken.push_back({TakenPart::Places,
                                Message::say("the first axis, of %1 points; if it holds colours, the header has to say "
                                             "so ('kinds: RGB-color domain domain')",
                                             first.size),
                                true});
    const std::string kind = roles->components ? (*axes)[*roles->components].kind : std::string();
    const bool isHalfMatrix = kind.ends_with("matrix") &&
                              (kind.find("symmetric") != std::string::npos || kind.find("masked") != std::string::npos);
    if (isHalfMatrix && !values.contains("component"))
        return Error{ErrorKind::WrongUsage,
                     Message::say("its samples are matrices of %1 numbers ('%2'), whose magnitude has no meaning. "
                                  "Choose one of them with '--component', from 0.",
                                  volume.components, printable(kind))};
    if (const Status taken = takeComponent(volume, values); !taken)
        return taken;
    const NrrdAxis ofSteps = roles->steps ? (*axes)[*roles->steps] : NrrdAxis();
    for (std::uint64_t step = 0; ofSteps.spacing && steps <= mostTimes && step < steps; ++step)
        volume.timeSteps.push_back(ofSteps.minimum.value_or(0) + static_cast<double>(step) * *ofSteps.spacing);
    return takeTimeStep(volume, values, steps, stride(roles->steps.value_or(0)));
}

/// Behind the header, or in files of their own.
Status setFiles(const NrrdFields& fields, const std::filesystem::path& path, StoredPacking packing,
                StoredVolume& volume)
{
    const auto names = nrrdDataFiles(fields);
    if (!names)
        return names.error();
    for (const std::string& name : *names)
        volume.files.push_back({path.parent_path() / name, packing});
    if (!names->empty())
        return {};
    volume.files = {{path, packing}};
    volume.headerBytes = fields.headerBytes;
    return {};
}

} // namespace

Result<StoredVolume> nrrdVolume(const VolumeRequest& request)
{
    const auto parsed = parseNrrdFields(request.text());
    if (!parsed)
        return parsed.error();
    const NrrdFields& fields = *parsed;
    for (const std::string field : {"type", "dimension", "sizes", "encoding"})
        if (const Status there = missing(fields, field); !there)
            return there.error();
    const auto packing = parsePacking(fields["encoding"]);
    if (!packing)
        return packing.error();
    StoredVolume volume;
    volume.rest = StoredRest::Refused;
    if (const Status known = parseEncoding(fields, *packing, volume); !known)
        return known.error();
    if (const Status known = parseSkips(fields, *packing, volume); !known)
        return known.error();
    const Result<Lattice> lattice = nrrdLattice(fields);
    if (!lattice)
        return lattice.error();
    volume.lattice = *lattice;
    if (const Status known = setSamples(fields, request.values, volume); !known)
        return known.error();
    volume.space = nrrdSpace(fields);
    volume.lengthUnit = nrrdLengthUnit(fields);
    volume.untold = untoldPlacement(tellsNrrdSpacing(fields), tellsNrrdOrigin(fields), !volume.lengthUnit.empty());
    volume.stepsToOrigin = nrrdStepsToOrigin(fields);
    volume.remarks = nrrdPlaceRemarks(fields);
    tellFields(fields, volume);
    if (const Status known = setFiles(fields, request.path, *packing, volume); !known)
        return known.error();
    return volume;
}

std::vector<std::filesystem::path> nrrdCompanions(const VolumeRequest& request)
{
    const auto volume = nrrdVolume(request);
    const bool isDetached = volume && volume->files.size() == 1 && volume->files.front().path != request.path;
    return isDetached ? std::vector<std::filesystem::path>{volume->files.front().path}
                      : std::vector<std::filesystem::path>();
}

} // namespace tetra
