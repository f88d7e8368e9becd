// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/load_error.h"

namespace tetra {
namespace {

/// The word that ends where `marker` begins in `text`; empty without one.
std::string_view wordBefore(std::string_view text, std::string_view marker)
{
    const auto end = text.find(marker);
    if (end == std::string_view::npos)
        return {};
    const auto before = text.substr(0, end).find_last_of(" (");
    return text.substr(before + 1, end - before - 1); // npos + 1 is 0
}

std::string_view wordAfter(std::string_view text, std::string_view marker)
{
    const auto begin = text.find(marker);
    if (begin == std::string_view::npos)
        return {};
    const std::string_view rest = text.substr(begin + marker.size());
    return rest.substr(0, rest.find_first_of(" ,)"));
}

std::string advice(std::string_view own, const std::string& general)
{
    return own.empty() ? general : std::string(own);
}

} // namespace

std::string explainLoadError(std::string_view systemText, std::string_view remedy)
{
    if (const std::string library(wordBefore(systemText, ": cannot open shared object file")); !library.empty())
        return "The library " + library + " is missing. " +
               advice(remedy, "Install the package that contains it (on Debian, 'apt-file search " + library +
                                  "' names it), or remove the plugin.");
    if (const std::string symbol(wordAfter(systemText, "undefined symbol: ")); !symbol.empty())
        return "It needs the function " + symbol +
               ", which no library here has: it was built for another version of TAn or of a library. " +
               advice(remedy, "Rebuild it, or install the version for this program.");
    return "It could not be loaded: " + std::string(systemText) + " " +
           advice(remedy, "Install it again, or remove it.");
}

} // namespace tetra
