// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/libcurl.h"

#include "core/remote/address.h"

#include <tan/version.h>

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>

namespace tetra {

namespace {

/// The file of the certificates that are trusted: what SSL_CERT_FILE names; nothing where libcurl knows one that is
/// there; otherwise where other systems than that of its build keep theirs.
std::string trustedCertificates()
{
    if (const char* const given = std::getenv("SSL_CERT_FILE"); given != nullptr && *given != '\0')
        return given;
    std::error_code problem;
    const curl_version_info_data* const library = ::curl_version_info(CURLVERSION_NOW);
    if (library->cainfo == nullptr || std::filesystem::exists(library->cainfo, problem))
        return {};
    for (const char* path : {"/etc/ssl/certs/ca-certificates.crt", "/etc/pki/tls/certs/ca-bundle.crt",
                             "/etc/ssl/ca-bundle.pem", "/etc/ssl/cert.pem"})
        if (std::filesystem::exists(path, problem))
            return path;
    return {};
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

std::string addressWithoutUser(std::string_view address, AddressPart part)
{
    if (part == AddressPart::All)
        return without(address, {CURLUPART_USER, CURLUPART_PASSWORD, CURLUPART_OPTIONS});
    return without(address,
                   {CURLUPART_USER, CURLUPART_PASSWORD, CURLUPART_OPTIONS, CURLUPART_QUERY, CURLUPART_FRAGMENT});
}

bool isCurlReady()
{
    static const bool ready = ::curl_global_init(CURL_GLOBAL_DEFAULT) == CURLE_OK;
    return ready;
}

CURL* newCurlHandle()
{
    return isCurlReady() ? ::curl_easy_init() : nullptr;
}

CURLcode setCurlHandle(CURL* handle, const std::string& address, std::chrono::milliseconds mostForConnecting)
{
    ::curl_easy_reset(handle);
    const std::string certificates = trustedCertificates();
    CurlOptions options(handle); // copies are made of all texts
    options.set(CURLOPT_URL, address.c_str())
        .set(CURLOPT_PROTOCOLS_STR, "http,https")
        .set(CURLOPT_NOSIGNAL, 1L)
        .set(CURLOPT_USERAGENT, "TAn/" TAN_VERSION)
        .set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(mostForConnecting.count()));
    if (!certificates.empty())
        options.set(CURLOPT_CAINFO, certificates.c_str());
    return options.code();
}

} // namespace tetra
