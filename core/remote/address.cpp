// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/address.h"

#include "core/base/text.h"

#include <algorithm>

namespace tetra {
namespace {

bool startsWithSmall(std::string_view text, std::string_view start)
{
    return text.size() >= start.size() && std::ranges::equal(text.substr(0, start.size()), start, {}, smallLetter);
}

/// `shown` is the address as libcurl understands it. A password with a slash in it that nobody has escaped ends the
/// host for libcurl: of https://me:1/2@host/x it takes "me" for the host and 1 for its port. So where a port stands
/// before an '@' of the path, and no name does, what lies between is left out.
std::string withoutSplitPassword(const std::string& shown, std::string_view address)
{
    const std::size_t host = shown.find("://") + 3, path = shown.find('/', host), at = shown.rfind('@');
    const std::size_t bracket = shown.find(']', host), colon = shown.find(':', bracket < path ? bracket : host);
    const std::size_t given = address.find("://");
    const bool hasName = given != std::string_view::npos && address.find('@') < address.find('/', given + 3);
    if (hasName || at == std::string::npos || at < path || colon == std::string::npos || colon > path)
        return shown;
    return shown.substr(0, host) + "..." + shown.substr(at);
}

} // namespace

bool isRemoteAddress(std::string_view text) noexcept
{
    return startsWithSmall(text, "http://") || startsWithSmall(text, "https://");
}

std::string shownAddress(std::string_view address)
{
    const std::string shown = addressWithoutUser(address, AddressPart::UpToQuery);
    if (!shown.empty())
        return printable(withoutSplitPassword(shown, address));
    const std::size_t scheme = address.find("://"), at = address.rfind('@');
    std::string bare(address);
    if (at != std::string_view::npos)
        bare = std::string(scheme < at ? address.substr(0, scheme + 3) : "") + std::string(address.substr(at + 1));
    return printable(std::string_view(bare).substr(0, bare.find_first_of("?#")));
}

} // namespace tetra
