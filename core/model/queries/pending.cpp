// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/sharp_focus.h"

namespace tetra {

class SharpFocus::Work {};
bool SharpFocus::fits(const Model&)
{
    return false;
}
SharpFocus::SharpFocus(const Model&) {}
SharpFocus::~SharpFocus() = default;
SharpFocus::SharpFocus(SharpFocus&&) noexcept = default;
SharpFocus& SharpFocus::operator=(SharpFocus&&) noexcept = default;
std::uint64_t SharpFocus::sitesInside(const SpaceRamp&)
{
    return 0;
}
Result<ExtractedMesh> SharpFocus::extract(const SpaceRamp&, bool, const Progress&, ExtractedMesh)
{
    return Error{ErrorKind::WrongUsage, "pending"};
}

} // namespace tetra
