// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/libcurl.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <curl/curl.h>

namespace tetra {

bool isCurlReady()
{
    static const bool ready = ::curl_global_init(CURL_GLOBAL_DEFAULT) == CURLE_OK;
    return ready;
}

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

} // namespace tetra
