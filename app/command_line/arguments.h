// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/syntax.h"

#include <tan/base.h>

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// The words given to a subcommand, sorted by its syntax.
struct Arguments {
    std::vector<std::string> positionals;
    std::vector<std::pair<std::string, std::string>> options; ///< name and value, as given
    std::set<std::string, std::less<>> ownOptions;            ///< ownOptionNames() of the syntax

    bool has(std::string_view name) const;
    std::optional<std::string> value(std::string_view name) const;
    std::vector<std::string> values(std::string_view name) const;
};

/// The names of options that are the program's own, and no plugin's.
std::set<std::string, std::less<>> ownOptionNames(const Syntax& syntax);

/// Takes "--name value", "--name=value", "-o value" and "--", after which nothing is an option. Errors (WrongUsage): an
/// unknown option, with the nearest known one; a missing or superfluous value, option or word; an option given twice.
Result<Arguments> parseArguments(const Syntax& syntax, std::span<const std::string> words);

} // namespace tetra
