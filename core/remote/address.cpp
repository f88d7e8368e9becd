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

} // namespace

bool isRemoteAddress(std::string_view text) noexcept
{
    return startsWithSmall(text, "http://") || startsWithSmall(text, "https://");
}

std::string shownAddress(std::string_view address)
{
    const std::string shown = addressWithoutUser(address, AddressPart::UpToQuery);
    if (!shown.empty())
        return printable(shown);
    const std::size_t scheme = address.find("://"), at = address.rfind('@');
    std::string bare(address);
    if (at != std::string_view::npos)
        bare = std::string(scheme < at ? address.substr(0, scheme + 3) : "") + std::string(address.substr(at + 1));
    return printable(std::string_view(bare).substr(0, bare.find_first_of("?#")));
}

} // namespace tetra
