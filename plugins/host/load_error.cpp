// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/load_error.h"

#include <string>

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

Message advice(std::string_view own, const Message& general)
{
    return own.empty() ? general : Message::of(std::string(own), {});
}

} // namespace

Message explainLoadError(std::string_view systemText, std::string_view remedy)
{
    if (const std::string library(wordBefore(systemText, ": cannot open shared object file")); !library.empty())
        return Message::say("The library %1 is missing. %2", library,
                            advice(remedy, Message::say("Install the package that contains it (on Debian, '%1' names "
                                                        "it), or remove the plugin.",
                                                        "apt-file search " + library)));
    if (const std::string symbol(wordAfter(systemText, "undefined symbol: ")); !symbol.empty())
        return Message::say("It needs the function %1, which no library here provides: it was built for another "
                            "version of TAn or of a library. %2",
                            symbol,
                            advice(remedy, Message::say("Rebuild it, or install the version for this program.")));
    return Message::say("It could not be loaded: %1 %2", systemText,
                        advice(remedy, Message::say("Install it again, or remove it.")));
}

} // namespace tetra
