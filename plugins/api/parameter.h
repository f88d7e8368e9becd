// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/parameter.h>

#include <string>
#include <string_view>

namespace tetra {

/// What is no parameter, but what their conditions may ask for: the std::string domainNameOf() the dataset.
inline constexpr const char* domainId = "domain";

/// domainClassName(), or "rectilinear" of rectilinear grids.
inline constexpr MarkedText rectilinear = Message::marked("rectilinear");
inline std::string domainNameOf(const Dataset& dataset)
{
    return std::string(dataset.domain == DomainClass::Curvilinear && dataset.convex ? std::string_view(rectilinear)
                                                                                    : domainClassName(dataset.domain));
}

} // namespace tetra
