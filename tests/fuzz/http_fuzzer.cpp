// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for two answers of a server, heads and the beginning of content, and for an address. What is
// taken for a part of a file is one that was asked for.
#include "core/remote/http_answer.h"
#include "core/remote/remote_file.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

using namespace tetra;

/// Takes a head off the front.
HttpAnswer takeAnswer(std::string_view& text)
{
    HttpAnswer answer;
    while (!text.empty() && !answer.isWhole)
        takeHeaderLine(answer, takeUntil(text, '\n'));
    return answer;
}

void requireSound(const HttpAnswer& answer)
{
    require(answer.status == 0 || (answer.status >= 100 && answer.status <= 999), "a status has three digits");
    for (const std::string& kept : {answer.entityTag, answer.lastModified, answer.contentType, answer.contentEncoding})
        require(kept.size() <= 1024 &&
                    std::ranges::none_of(kept, [](char c) { return c == '\n' || c == '\r' || c == 0; }),
                "what is kept is short, and can be sent back in a head");
    if (const auto& range = answer.contentRange) {
        require(range->first.has_value() == range->last.has_value(), "a range has two ends or none");
        require(!range->first || (*range->first <= *range->last && *range->last < range->total.value_or(~0ull)),
                "a range lies within its file");
    }
}

void useAnswers(std::string_view text)
{
    const HttpAnswer first = takeAnswer(text);
    requireSound(first);
    const Asked whole{0, 16384, nullptr, 0};
    if (useOfAnswer(first, whole, asBytes(text)) != AnswerUse::Part)
        return;
    const std::uint64_t size = *first.contentRange->total;
    require(first.contentRange->first == 0u && *first.contentRange->last < 16384 && size <= std::uint64_t(1) << 60,
            "the first part is one that was asked for");
    const HttpAnswer next = takeAnswer(text);
    requireSound(next);
    const Asked asked{16384, 65536, &first, size};
    if (useOfAnswer(next, asked, asBytes(text)) == AnswerUse::Part) {
        require(next.contentRange->first == 16384u && *next.contentRange->last < 65536, "a part is one asked for");
        require(next.sameState(first), "all parts are of one state of the file");
    }
}

void useAddress(std::string_view text)
{
    const std::string shown = shownAddress(text);
    require(std::ranges::none_of(shown, [](char c) { return static_cast<unsigned char>(c) < ' '; }),
            "an address can be shown");
    (void)isRemoteAddress(text);
}

void mergePieces(std::string_view text)
{
    std::vector<std::uint64_t> pieces;
    std::uint64_t piece = 0;
    for (const char step : text.substr(0, 64))
        pieces.push_back(piece += 1 + static_cast<unsigned char>(step) % 8);
    const std::uint64_t pieceBytes = 16384, gap = 65536, size = piece * pieceBytes + 100;
    const std::vector<ByteRange> ranges = mergedRanges(pieces, pieceBytes, gap, size);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        require(ranges[i].size > 0 && ranges[i].offset + ranges[i].size <= size, "ranges lie within the file");
        require(i == 0 || ranges[i].offset - ranges[i - 1].offset - ranges[i - 1].size >= gap, "gaps are large");
    }
    for (const std::uint64_t wanted : pieces)
        require(std::ranges::any_of(ranges,
                                    [&](const ByteRange& range) {
                                        return range.offset <= wanted * pieceBytes &&
                                               std::min((wanted + 1) * pieceBytes, size) <= range.offset + range.size;
                                    }),
                "each piece is asked for");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    const std::string_view text = asText(bytes, size);
    useAnswers(text);
    useAddress(text);
    mergePieces(text);
    return 0;
}
