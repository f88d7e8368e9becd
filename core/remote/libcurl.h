// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include <curl/curl.h>

namespace tetra {

/// Sets libcurl's own data up, once in a process; false if that fails.
bool isCurlReady();

/// Sets options of a handle, one after the other until one is refused.
class CurlOptions {
public:
    explicit CurlOptions(CURL* handle) : handle_(handle) {}

    template <class Value> CurlOptions& set(CURLoption option, Value value)
    {
        if (code_ == CURLE_OK)
            code_ = ::curl_easy_setopt(handle_, option, value);
        return *this;
    }
    /// Why one was refused, or CURLE_OK.
    CURLcode code() const noexcept { return code_; }

private:
    CURL* handle_;
    CURLcode code_ = CURLE_OK;
};

/// Sets a handle to ask for an address as all of TAn's requests do: by HTTP alone, with certificates that this machine
/// trusts, without signals. One that has asked before forgets what it was set to; its connections stay open.
CURLcode setCurlHandle(CURL* handle, const std::string& address, std::chrono::milliseconds mostForConnecting);

/// A new handle, which the caller cleans up. nullptr without memory.
CURL* newCurlHandle();

} // namespace tetra
