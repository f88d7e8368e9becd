// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"

#include <tan/base.h>
#include <tan/data.h>

#include <span>

namespace tetra {

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
                 Message::say("'%1' was cut short or changed while it was open, so that what was made of it would be "
                              "wrong. Open it again; if that fails, get or make the file again.",
                              mappedFile->path().string())};
}

} // namespace tetra
