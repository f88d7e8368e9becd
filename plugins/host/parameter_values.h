// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "plugins/api/parameter.h"

#include <string>
#include <vector>

namespace tetra {

/// An error (WrongUsage) if `values` holds something that `parameters` does not describe, or of another type.
/// `owner` is whose parameters they are: "reader 'lattice'".
Status checkParameterValues(const std::string& owner, const std::vector<Parameter>& parameters,
                            const ParameterValues& values);

} // namespace tetra
