// SPDX-License-Identifier: GPL-3.0-or-later
// In place of scattered_delaunay.cpp where the option TAN_CGAL is off: a mesh that cannot be started.
#include "core/refine/free/scattered_delaunay.h"

namespace tetra {

struct ScatteredDelaunay::Mesh {};

ScatteredDelaunay::ScatteredDelaunay(std::span<const Eigen::Vector3d>) {}

ScatteredDelaunay::~ScatteredDelaunay() = default;

Status ScatteredDelaunay::start()
{
    return Error{
        ErrorKind::WrongUsage,
        Message::say("This TAn cannot make a mesh of scattered points: it was built without CGAL (TAN_CGAL). Use one "
                     "that has it, or data with a grid or with cells.")};
}

// The rest is for a mesh that was started.
std::uint32_t ScatteredDelaunay::locate(std::uint32_t, std::uint32_t) const
{
    return none;
}

std::uint32_t ScatteredDelaunay::locateInStar(std::uint32_t, std::uint32_t) const
{
    return none;
}

void ScatteredDelaunay::insert(std::uint32_t, std::uint32_t) {}

void ScatteredDelaunay::archive(StateArchive&) {}

} // namespace tetra
