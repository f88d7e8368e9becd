// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// What of an HTTP answer is read here and not by libcurl (RFC 9110). Nothing in it is trusted.

namespace tetra {

/// "bytes 0-16383/1400000" or, of a range that lies outside, "bytes */1400000".
struct ContentRange {
    std::optional<std::uint64_t> first, last; ///< both or neither; first <= last
    std::optional<std::uint64_t> total;       ///< more than last; not given: the server does not know

    bool operator==(const ContentRange&) const = default;
};

/// The value of a header Content-Range; nothing if it is none.
std::optional<ContentRange> parseContentRange(std::string_view value);

/// One answer's status and those of its headers that matter; texts no longer than a kilobyte, others are left out.
struct HttpAnswer {
    int status = 0;
    bool hasContentRange = false; ///< one that can be read or not, or several
    std::optional<ContentRange> contentRange;
    std::optional<std::uint64_t> contentLength;
    std::string entityTag;    ///< as it stands there, with its quotes and W/
    std::string lastModified; ///< as it stands there
    std::string contentType;  ///< small letters, without parameters
    std::string contentEncoding;

    /// What If-Range takes: a strong tag or else the date; empty if there is neither.
    std::string_view validator() const;
    /// What tells one state of a file from another: both.
    bool sameState(const HttpAnswer& other) const;

    bool operator==(const HttpAnswer&) const = default;
};

/// Takes a line of the answer's head, with or without its line end. A status line begins a new answer: after a
/// redirection, or one that says to go on.
void takeHeaderLine(HttpAnswer& answer, std::string_view line);

/// Whether an answer is a page for people, such as one to log in at, in place of data; `start` is where its content
/// begins.
bool isWebPage(const HttpAnswer& answer, std::span<const std::byte> start);

} // namespace tetra
