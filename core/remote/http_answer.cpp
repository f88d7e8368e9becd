// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/http_answer.h"

#include "core/base/text.h"

#include <tan/base.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace tetra {

namespace {

constexpr std::size_t longestText = 1024;
constexpr std::uint64_t mostBytes = std::uint64_t(1) << 44; // 2^32 sites and the history of their tetrahedra
constexpr std::uint64_t longestWait = 3600;

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Digits alone: parseNumber() takes a plus, too.
std::optional<std::uint64_t> wholeNumber(std::string_view text)
{
    if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos)
        return {};
    return parseNumber<std::uint64_t>(text);
}

/// A text that is kept, and sent back to the server: no control characters.
std::string keptText(std::string_view text)
{
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    return text.size() > longestText || std::ranges::any_of(text, isControl) ? std::string() : std::string(text);
}

/// "Sun, 06 Nov 1994 08:49:37 GMT", which all servers write today.
std::optional<std::chrono::sys_seconds> timeOf(std::string_view text)
{
    constexpr std::string_view pattern = "???, 00 ??? 0000 00:00:00 GMT",
                               months = "JanFebMarAprMayJunJulAugSepOctNovDec";
    if (text.size() != pattern.size())
        return {};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        if (pattern[i] == '0' ? !isDigit : pattern[i] != '?' && text[i] != pattern[i])
            return {};
    }
    const auto number = [&](std::size_t at, std::size_t digits) { return *parseNumber<int>(text.substr(at, digits)); };
    const std::size_t month = months.find(text.substr(8, 3));
    if (month == std::string_view::npos || month % 3 != 0)
        return {};
    const std::chrono::year_month_day day(std::chrono::year(number(12, 4)), std::chrono::month(unsigned(month) / 3 + 1),
                                          std::chrono::day(unsigned(number(5, 2))));
    if (!day.ok())
        return {};
    return std::chrono::sys_days(day) + std::chrono::hours(number(17, 2)) + std::chrono::minutes(number(20, 2)) +
           std::chrono::seconds(number(23, 2));
}

/// HTTP/1.1 206 Partial Content
int statusOf(std::string_view line)
{
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos)
        return 0;
    const std::string_view rest = line.substr(blank + 1);
    const std::optional<std::uint64_t> status = wholeNumber(rest.substr(0, rest.find(' ')));
    return status && *status >= 100 && *status <= 999 ? static_cast<int>(*status) : 0;
}

} // namespace

std::optional<ContentRange> parseContentRange(std::string_view value)
{
    value = trimmed(value);
    if (smallLetters(value.substr(0, 6)) != "bytes ")
        return {};
    value = trimmed(value.substr(6));
    const std::size_t slash = value.find('/');
    if (slash == std::string_view::npos)
        return {};
    const std::string_view range = trimmed(value.substr(0, slash)), total = trimmed(value.substr(slash + 1));
    ContentRange result;
    if (total != "*") {
        result.total = wholeNumber(total);
        if (!result.total)
            return {};
    }
    if (range == "*")
        return result.total ? std::optional(result) : std::nullopt;
    const std::size_t dash = range.find('-');
    if (dash == std::string_view::npos)
        return {};
    result.first = wholeNumber(range.substr(0, dash));
    result.last = wholeNumber(range.substr(dash + 1));
    if (!result.first || !result.last || *result.first > *result.last ||
        (result.total && *result.last >= *result.total))
        return {};
    return result;
}

std::string_view HttpAnswer::validator() const
{
    return !entityTag.empty() && !entityTag.starts_with("W/") ? entityTag : lastModified;
}

bool HttpAnswer::tellsChanges() const
{
    const std::string_view told = validator();
    if (told.empty() || told != lastModified)
        return !told.empty();
    const auto changed = timeOf(lastModified), answered = timeOf(date);
    return changed && answered ? *changed < *answered : lastModified != date;
}

bool HttpAnswer::sameState(const HttpAnswer& other) const
{
    return entityTag == other.entityTag && lastModified == other.lastModified;
}

void takeHeaderLine(HttpAnswer& answer, std::string_view line)
{
    line = trimmed(line);
    if (line.starts_with("HTTP/")) {
        answer = {};
        answer.status = statusOf(line);
        return;
    }
    if (answer.isWhole) // what comes behind the content says nothing of it
        return;
    answer.isWhole = line.empty();
    const std::size_t colon = line.find(':');
    if (colon > longestText) // or there is none
        return;
    const std::string name = smallLetters(trimmed(line.substr(0, colon)));
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (name == "content-range") {
        answer.contentRange = answer.hasContentRange ? std::nullopt : parseContentRange(value);
        answer.hasContentRange = true;
    } else if (name == "content-length") {
        answer.contentLength = wholeNumber(value);
    } else if (name == "etag") {
        answer.entityTag = keptText(value);
    } else if (name == "last-modified") {
        answer.lastModified = keptText(value);
    } else if (name == "date") {
        answer.date = keptText(value);
    } else if (name == "content-type") {
        answer.contentType = smallLetters(trimmed(keptText(value.substr(0, value.find(';')))));
    } else if (name == "content-encoding") {
        answer.contentEncoding = smallLetters(keptText(value));
    } else if (name == "retry-after") {
        answer.retryAfter = wholeNumber(value);
        if (answer.retryAfter)
            answer.retryAfter = std::min(*answer.retryAfter, longestWait);
    } else if (name == "www-authenticate") {
        answer.wantsBearer = smallLetters(value.substr(0, value.find(' '))) == "bearer";
    }
}

AnswerUse useOfAnswer(const HttpAnswer& answer, const Asked& asked, std::span<const std::byte> start)
{
    const bool isFirst = asked.original == nullptr;
    const std::optional<ContentRange>& range = answer.contentRange;
    if (answer.status == 0)
        return AnswerUse::NoAnswer;
    if (!answer.isWhole)
        return AnswerUse::CutShort;
    if (answer.status == 416 && !isFirst)
        return AnswerUse::Changed;
    if (answer.status == 416 && range && range->total == 0)
        return AnswerUse::EmptyFile;
    if (answer.status != 200 && answer.status != 206)
        return AnswerUse::OtherStatus;
    if (isWebPage(answer, asked.first == 0 ? start : std::span<const std::byte>()))
        return AnswerUse::WebPage;
    const bool isChanged = !isFirst && !answer.sameState(*asked.original);
    if (answer.status == 200) {
        if (isFirst)
            return answer.contentLength == 0 ? AnswerUse::EmptyFile : AnswerUse::WholeFile;
        const bool isOtherLength = answer.contentLength && *answer.contentLength != asked.size;
        return isChanged || isOtherLength ? AnswerUse::Changed : AnswerUse::WholeFile;
    }
    if (!answer.contentEncoding.empty() && answer.contentEncoding != "identity")
        return AnswerUse::Packed;
    if (isChanged)
        return AnswerUse::Changed;
    if (!range || range->first != asked.first || *range->last >= asked.end)
        return AnswerUse::OtherPart;
    if (isFirst && !range->total)
        return AnswerUse::NoLength;
    if (isFirst && *range->total > mostBytes)
        return AnswerUse::TooLong;
    if (!isFirst && range->total && *range->total != asked.size)
        return AnswerUse::Changed;
    const bool isSound = !answer.contentLength || *answer.contentLength == *range->last - asked.first + 1;
    return isSound ? AnswerUse::Part : AnswerUse::OtherPart;
}

bool isWebPage(const HttpAnswer& answer, std::span<const std::byte> start)
{
    // Object stores list what they have as XML, 'tan serve' as JSON.
    constexpr std::array<std::string_view, 5> types = {"text/html", "application/xhtml+xml", "application/json",
                                                       "application/xml", "text/xml"};
    if (std::ranges::find(types, answer.contentType) != types.end())
        return true;
    const std::string_view text(reinterpret_cast<const char*>(start.data()), std::min<std::size_t>(start.size(), 512));
    const std::string begin = smallLetters(trimmed(text).substr(0, 16));
    return begin.starts_with("<!doctype html") || begin.starts_with("<html");
}

} // namespace tetra
