// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include <curl/curl.h>

namespace tetra {

/// Sets libcurl's own data up, once in a process; false if that fails.
bool isCurlReady();

/// A handle that asks for an address as all of TAn's requests do: by HTTP alone, with certificates that this machine
/// trusts, without signals. The caller cleans it up. nullptr without memory.
CURL* newCurlHandle(const std::string& address, std::chrono::milliseconds mostForConnecting);
/// Makes one that has asked before such a handle; its connections stay open. False without memory.
bool renewCurlHandle(CURL* handle, const std::string& address, std::chrono::milliseconds mostForConnecting);

} // namespace tetra
