// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/address.h"

#include "core/base/text.h"
#include "core/remote/libcurl.h"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <new>

namespace tetra {
namespace {

bool startsWithSmall(std::string_view text, std::string_view start)
{
    return text.size() >= start.size() && std::ranges::equal(text.substr(0, start.size()), start, {}, smallLetter);
}

/// The address without these parts; empty for what is none.
std::string without(std::string_view address, std::initializer_list<CURLUPart> parts)
{
    const std::unique_ptr<CURLU, decltype(&::curl_url_cleanup)> url(::curl_url(), &::curl_url_cleanup);
    if (!url)
        throw std::bad_alloc();
    if (address.find('\0') != std::string_view::npos ||
        ::curl_url_set(url.get(), CURLUPART_URL, std::string(address).c_str(), CURLU_NON_SUPPORT_SCHEME) != CURLUE_OK)
        return {};
    for (const CURLUPart part : parts)
        ::curl_url_set(url.get(), part, nullptr, 0);
    char* text = nullptr;
    if (::curl_url_get(url.get(), CURLUPART_URL, &text, 0) != CURLUE_OK)
        return {};
    std::string result(text);
    ::curl_free(text);
    return result;
}

} // namespace

bool isRemoteAddress(std::string_view text) noexcept
{
    return startsWithSmall(text, "http://") || startsWithSmall(text, "https://");
}

std::string shownAddress(std::string_view address)
{
    const std::string shown =
        without(address, {CURLUPART_USER, CURLUPART_PASSWORD, CURLUPART_OPTIONS, CURLUPART_QUERY, CURLUPART_FRAGMENT});
    if (!shown.empty())
        return printable(shown);
    const std::size_t scheme = address.find("://"), at = address.rfind('@');
    std::string bare(address);
    if (at != std::string_view::npos)
        bare = std::string(scheme < at ? address.substr(0, scheme + 3) : "") + std::string(address.substr(at + 1));
    return printable(std::string_view(bare).substr(0, bare.find_first_of("?#")));
}

std::string addressWithoutUser(std::string_view address)
{
    return without(address, {CURLUPART_USER, CURLUPART_PASSWORD, CURLUPART_OPTIONS});
}

} // namespace tetra
