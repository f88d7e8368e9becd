// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/history/query/error_field.h"

#include <string>
#include <string_view>

namespace tetra {

/// Error fields as text (B2), for command lines, sessions and fields of forms. A number is a field, and so are
///
///     box(x,y,z, X,Y,Z; inner, outer, falloff)           two opposite corners
///     sphere(x,y,z, radius; inner, outer, falloff)
///     halfspace(a,b,c, d; inner, outer, falloff)         a x + b y + c z <= d
///     camera(x,y,z; inner, outer, distance)              a sphere of radius 0: `outer` from that distance away
///     values(value:error, value:error, ...)              linear between
///     isovalues(value, value, ...; inner, outer, falloff)
///     opacity(value:opacity, ...; inner, outer)          the opacity of a transfer function
///     sum(a, b, ...)  product(a, b, ...)  min(a, b, ...)  max(a, b, ...)     of two fields or more
///
/// A falloff that is left out is 0: a sharp border. Blanks may stand between any two words or signs; numbers have a
/// decimal point under every locale, and "inf" is one. At most 1000 fields are combined, nested 100 deep. Errors
/// (WrongUsage) name the place, counted in characters from 1, and what is expected there.
Result<ErrorField> parseErrorField(std::string_view text);

/// Text that parseErrorField() makes the same field of (==), with the shortest numbers. Isovalues and opacities come
/// back as values(). The field must be of finite regions, and of the size that can be parsed.
std::string toText(const ErrorField& field);

} // namespace tetra
