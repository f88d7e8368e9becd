// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tetra {

/// Something that needs others of its kind.
struct Dependent {
    std::string id;
    std::vector<std::string> requiredIds;
};

struct DependencyOrder {
    std::vector<std::size_t> order; ///< indices of those that can be had, each after all that it needs
    std::vector<Message> errors;    ///< for each index: empty, or why it cannot be had
};

/// Orders by need. What needs something missing, or itself in a circle, or something that cannot be had for one of
/// these reasons, is left out with a text. Ids are unique. O(n + needs) look-ups.
DependencyOrder dependencyOrder(const std::vector<Dependent>& dependents);

} // namespace tetra
