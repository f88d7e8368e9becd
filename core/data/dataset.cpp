// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"

#include <tan/base.h>
#include <tan/data.h>

#include <span>

namespace tetra {

MarkedText takenPartText(TakenPart part) noexcept
{
    constexpr MarkedText texts[] = {
        Message::marked("array"),     Message::marked("component"), Message::marked("places"),
        Message::marked("block"),     Message::marked("series"),    Message::marked("channel"),
        Message::marked("time step"), Message::marked("frame"),     Message::marked("unit of the values"),
        Message::marked("fill value")};
    return texts[static_cast<std::size_t>(part)];
}

std::string_view takenPartName(TakenPart part) noexcept
{
    constexpr std::string_view names[] = {"array",   "component", "columns", "block", "series",
                                          "channel", "step",      "frame",   "unit",  "fill"};
    return names[static_cast<std::size_t>(part)];
}

Message takenText(const Taken& taken)
{
    return taken.guessed ? Message::say("%1: %2 (a guess)", takenPartText(taken.part), taken.what)
                         : Message::say("%1: %2", takenPartText(taken.part), taken.what);
}

std::uint64_t contentHash(const ScalarField& values, const PointPositions& positions, const PointTetrahedra& tetrahedra)
{
    Checksum sum;
    sum.add(values.bytes());
    if (positions)
        sum.add(std::as_bytes(std::span(*positions)));
    if (tetrahedra)
        sum.add(std::as_bytes(std::span(*tetrahedra)));
    return sum.value();
}

Eigen::AlignedBox3d Dataset::bounds() const
{
    if (!positions)
        return lattice.bounds();
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : *positions)
        box.extend(position);
    return box;
}

Status Dataset::checkIntact() const
{
    if (!mappedFile || !mappedFile->damaged())
        return {};
    return Error{ErrorKind::BadInput,
                 Message::say("'%1' was cut short or changed while it was open, so that the result would be wrong. "
                              "Open it again; if that fails, get or make the file again.",
                              mappedFile->path().string())};
}

} // namespace tetra
