// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/libcurl.h"

#include <tan/version.h>

#include <cstdlib>
#include <filesystem>
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

} // namespace

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
