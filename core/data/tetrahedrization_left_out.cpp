// SPDX-License-Identifier: GPL-3.0-or-later
// In place of tetrahedrization.cpp where the option TAN_CGAL is off.
#include <tan/data.h>

namespace tetra {

Result<Dataset> tetrahedrized(const Dataset& points, const Progress&)
{
    return Error{
        ErrorKind::WrongUsage,
        Message::say("This TAn cannot make a mesh of the points of '%1': it was built without CGAL (TAN_CGAL). Use "
                     "one that has it, or data with a grid or with cells.",
                     points.source.name)};
}

} // namespace tetra
