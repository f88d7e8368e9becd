// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <curl/curl.h>

namespace tetra {

/// Why a request did not bring what it was to bring.
struct Refusal {
    Message reason;     ///< with what to do, sentences
    bool again = false; ///< another attempt may
    bool moved = false; ///< the address that a redirection led to may have had its time
    ErrorKind kind = ErrorKind::BadInput;
    Credential wants = Credential::None;
};

/// No other attempt will.
Refusal final(Message reason);
/// Another attempt may.
Refusal again(Message reason);

Refusal noHttp();
Refusal brokenOff();

/// What an error of libcurl means. `detail`: what it wrote into its buffer for errors. `status`: of the answer as far
/// as it came, or 0. May throw std::bad_alloc, which may be the error.
Refusal refusedTransfer(CURLcode code, const char* detail, int status);

/// What it means that libcurl cannot be set up to ask. May throw std::bad_alloc, which may be why.
Refusal refusedSettings(CURLcode code);

/// Whether an answer's status says that the server is at its limit for now: then it is asked again after a while.
bool isBusy(int status) noexcept;

} // namespace tetra
