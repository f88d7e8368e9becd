// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/transfer_error.h"

#include <new>
#include <utility>

namespace tetra {

Refusal final(Message reason)
{
    return {.reason = std::move(reason)};
}

Refusal again(Message reason)
{
    return {.reason = std::move(reason), .again = true};
}

Refusal noHttp()
{
    return final(Message::say("the program that answers there is not a web server. Check the address and its port."));
}

Refusal brokenOff()
{
    return again(Message::say("the connection was lost again and again, because of the server or a proxy on the way. "
                              "Try again later, or download the file and open the copy."));
}

Refusal refusedSettings(CURLcode code)
{
    if (code == CURLE_OUT_OF_MEMORY)
        throw std::bad_alloc();
    Refusal refusal = final(Message::say("the libcurl of this machine does not support what TAn needs (%1). Check the "
                                         "address and SSL_CERT_FILE, and install a libcurl with HTTPS, 7.85 or later.",
                                         ::curl_easy_strerror(code)));
    refusal.kind = ErrorKind::OutOfResource;
    return refusal;
}

bool isBusy(int status) noexcept
{
    constexpr int tooManyRequests = 429, serviceUnavailable = 503;
    return status == tooManyRequests || status == serviceUnavailable;
}

Refusal refusedTransfer(CURLcode code, const char* detail, int status)
{
    const auto saying = [&](const char* otherwise) {
        return printable(detail != nullptr && *detail != '\0' ? detail : otherwise);
    };
    switch (code) {
    case CURLE_URL_MALFORMAT: {
        Refusal refusal = final(
            Message::say("it is not the address of a file. Write it as https://HOST/PATH, with spaces as %1.", "%20"));
        refusal.kind = ErrorKind::WrongUsage;
        return refusal;
    }
    case CURLE_COULDNT_RESOLVE_HOST:
        return again(Message::say("its host was not found. Check the address and the network."));
    case CURLE_COULDNT_RESOLVE_PROXY:
        return again(Message::say("the proxy was not found. Check http_proxy and https_proxy."));
    case CURLE_COULDNT_CONNECT:
        return again(Message::say("nothing answers at that host and port. Check the address and the network."));
    case CURLE_TOO_MANY_REDIRECTS:
        return final(
            Message::say("the server redirects from one address to another and never to a file. Check the address."));
    case CURLE_PEER_FAILED_VERIFICATION:
        return final(Message::say("the certificate of its host cannot be trusted (%1). Check the address and this "
                                  "machine's clock; read nothing from it if you do not know why.",
                                  saying("not valid")));
    case CURLE_SSL_CONNECT_ERROR:
    case CURLE_SSL_CERTPROBLEM:
    case CURLE_SSL_CIPHER:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
    case CURLE_SSL_INVALIDCERTSTATUS:
    case CURLE_USE_SSL_FAILED:
        return final(Message::say("a secure connection to its host cannot be made (%1). Check whether the address "
                                  "begins with http:// or https://.",
                                  saying("TLS")));
    case CURLE_UNSUPPORTED_PROTOCOL:
        if (status >= 300 && status < 400)
            return final(Message::say(
                "the server redirects to an address that is not safe to follow. Give the address of the file itself."));
        return noHttp();
    case CURLE_WEIRD_SERVER_REPLY:
    case CURLE_BAD_CONTENT_ENCODING: return noHttp();
    case CURLE_OUT_OF_MEMORY: throw std::bad_alloc();
    default: return brokenOff();
    }
}

} // namespace tetra
