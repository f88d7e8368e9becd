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
    bool isWhole = false;         ///< the empty line that ends it has come
    bool hasContentRange = false; ///< one that can be read or not, or several
    std::optional<ContentRange> contentRange;
    std::optional<std::uint64_t> contentLength;
    std::string entityTag;    ///< as it stands there, with its quotes and W/
    std::string lastModified; ///< as it stands there
    std::string date;         ///< when the answer was made, as it stands there
    std::string contentType;  ///< small letters, without parameters
    std::string contentEncoding;
    std::optional<std::uint64_t> retryAfter; ///< seconds, at most an hour; a date is left out
    bool wantsBearer = false;                ///< WWW-Authenticate asks for a token, and not for a name and a password

    /// What If-Range takes: a strong tag or else the date; empty if there is neither.
    std::string_view validator() const;
    /// Whether what it says of the file's state will be another one after the next change: a strong tag, or a date
    /// that is past. A file that was changed within the second of the answer may be changed again within it, and keep
    /// its date (RFC 9110, 8.8.2.2).
    bool tellsChanges() const;
    /// What tells one state of a file from another: both.
    bool sameState(const HttpAnswer& other) const;

    bool operator==(const HttpAnswer&) const = default;
};

/// Takes a line of the answer's head, with or without its line end. A status line begins a new answer: after a
/// redirection, or one that says to go on; what comes after an empty line and is none is left out.
void takeHeaderLine(HttpAnswer& answer, std::string_view line);

/// Whether an answer is a text in place of data: a page for people, such as one to log in at, or a list of files.
/// `start` is where its content begins.
bool isWebPage(const HttpAnswer& answer, std::span<const std::byte> start);

/// What an answer is good for.
enum class AnswerUse {
    Part, ///< a part of the file from the first byte on that was asked for
    EmptyFile,
    Changed,    ///< it is of another state of the file than the first answer
    WebPage,    ///< isWebPage()
    WholeFile,  ///< in place of a part: the server knows no ranges
    Packed,     ///< of bytes that are coded, so that nobody knows which they are
    OtherPart,  ///< none that was asked for, or one that contradicts itself
    NoLength,   ///< the first answer does not say how long the file is
    TooLong,    ///< it says that it is longer than any model
    CutShort,   ///< within its head
    NoAnswer,   ///< no HTTP
    OtherStatus ///< no data, as its status says
};

/// What was asked for, and what the first answer was to be held against.
struct Asked {
    std::uint64_t first = 0, end = 0;     ///< not empty
    const HttpAnswer* original = nullptr; ///< none: this is the first one
    std::uint64_t size = 0;               ///< of the file, by the first one
};

/// `start` is what has come of the content. A Part has contentRange with both ends; it begins at `asked.first` and ends
/// no later than `asked.end`, but perhaps before. The first one also has the length of the file, at most 2^44.
AnswerUse useOfAnswer(const HttpAnswer& answer, const Asked& asked, std::span<const std::byte> start);

} // namespace tetra
