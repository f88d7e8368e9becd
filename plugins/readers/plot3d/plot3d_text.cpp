// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace tetra {

namespace {

constexpr std::string_view textBlanks = " \t\r\n\v\f";
constexpr std::string_view separators = " \t\r\n\v\f,";
constexpr std::string_view decimalDigits = "0123456789";

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The next word, and moves `text` behind it; empty at the end.
std::string_view nextWord(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(separators));
    text.remove_prefix(word.size());
    return word;
}

bool isWhole(std::string_view word)
{
    return !word.empty() && word.find_first_not_of(decimalDigits) == std::string_view::npos;
}

/// A number as C++ writes it. Those too small to be told from zero are zero.
std::optional<double> plainNumber(std::string_view word)
{
    if (word.starts_with('+') && !word.starts_with("+-"))
        word.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument)
        return std::nullopt;
    if (error == std::errc())
        return number;
    const bool isSmall = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return isSmall ? std::optional(0.0) : std::nullopt;
}

/// Whether the exponent begins at `place` without a letter, for which Fortran has no room if it has three digits.
bool isBareExponent(std::string_view word, std::size_t place)
{
    constexpr std::size_t digits = 3;
    return (word[place] == '+' || word[place] == '-') && word.size() == place + 1 + digits &&
           isWhole(word.substr(place + 1)) && word.substr(0, place).find('.') != std::string_view::npos &&
           decimalDigits.find(word[place - 1]) != std::string_view::npos;
}

std::optional<double> fortranNumber(std::string_view word)
{
    constexpr std::size_t longest = 100;
    if (const auto number = plainNumber(word))
        return number;
    if (word.size() > longest)
        return std::nullopt;
    std::string plain;
    for (std::size_t place = 0; place < word.size(); ++place) {
        if (place > 0 && isBareExponent(word, place))
            plain += 'e';
        const char c = word[place];
        plain += c == 'D' || c == 'd' || c == 'Q' || c == 'q' ? 'e' : c;
    }
    return plainNumber(plain);
}

/// Whether single precision holds the number as it is written.
bool fitsSinglePrecision(std::string_view word, double number)
{
    constexpr std::ptrdiff_t digitsOfSingle = 9;
    if (std::isfinite(number) && std::abs(number) > std::numeric_limits<float>::max())
        return false;
    if (word.size() <= std::size_t(digitsOfSingle))
        return true;
    word = word.substr(0, word.find_first_of("eEdDqQ"));
    word.remove_prefix(std::min(word.find_first_of("123456789"), word.size()));
    return std::ranges::count_if(word, [](char c) { return c >= '0' && c <= '9'; }) <= digitsOfSingle;
}

/// Whether the text may have been cut within its last number. An end of line behind it shows that it was not; so do
/// numbers that are all as long as one another, their signs left out, unless they are so short that it is chance.
bool mayEndWithinNumber(std::string_view text)
{
    constexpr std::size_t looked = 4096, formatted = 8;
    if (text.empty() || textBlanks.find(text.back()) != std::string_view::npos)
        return false;
    if (text.size() > looked) {
        text.remove_prefix(text.size() - looked);
        nextWord(text);
    }
    std::size_t shortest = std::numeric_limits<std::size_t>::max(), longest = 0;
    for (std::string_view word = nextWord(text); !word.empty(); word = nextWord(text)) {
        const std::size_t length = word.size() - (word.starts_with('-') || word.starts_with('+') ? 1 : 0);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    return shortest != longest || longest < formatted;
}

/// A word of a text: a number, and how often it stands there.
struct Repeated {
    std::uint64_t times = 1;
    std::string_view word;
};

std::optional<Repeated> repeatedWord(std::string_view word)
{
    const std::size_t star = word.find('*');
    if (star == std::string_view::npos)
        return Repeated{1, word};
    const auto times = parseNumber<std::uint64_t>(word.substr(0, star));
    return times && *times > 0 ? std::optional(Repeated{*times, word.substr(star + 1)}) : std::nullopt;
}

Error notANumber(std::string_view text, std::string_view word)
{
    const auto line = 1 + std::count(text.data(), word.data(), '\n');
    return {ErrorKind::BadInput,
            Message::say("'%1' in line %2 is not a number, or is too large. The file is damaged, or of another format.",
                         printable(word), line)};
}

} // namespace

bool isPlot3dText(std::span<const std::byte> firstBytes)
{
    std::string_view text = asText(firstBytes);
    const bool isReadable = std::ranges::all_of(
        text, [](char c) { return (c >= ' ' && c <= '~') || textBlanks.find(c) != std::string_view::npos; });
    return isReadable && isWhole(nextWord(text));
}

bool looksLikePlot3dText(std::span<const std::byte> firstBytes)
{
    const std::string_view text = asText(firstBytes);
    if (text.find_first_not_of("0123456789+-.*,eEdD \t\r\n") != std::string_view::npos)
        return false;
    std::string_view line = text.substr(0, text.find('\n'));
    int words = 0;
    for (; line.find_first_not_of(textBlanks) != std::string_view::npos; ++words) {
        line.remove_prefix(line.find_first_not_of(textBlanks));
        const std::string_view word = line.substr(0, line.find_first_of(textBlanks));
        if (!isWhole(word))
            return false;
        line.remove_prefix(word.size());
    }
    return words == 1 || words == 3;
}

Result<Plot3dText> readPlot3dText(std::span<const std::byte> bytes, const Progress& progress)
{
    constexpr std::uint64_t wordsBetweenReports = 1 << 16, mostPerByte = 1024;
    const std::string_view text = asText(bytes);
    if (mayEndWithinNumber(text))
        return Error{ErrorKind::BadInput,
                     Message::say("it ends directly after its last number, or within it. If the file is complete, add "
                                  "an end of line; otherwise copy the file again.")};
    Plot3dText result;
    const std::uint64_t most = mostPerByte * text.size();
    std::string_view rest = text;
    std::uint64_t words = 0;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest), ++words) {
        if (words % wordsBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            progress.report(1 - static_cast<double>(rest.size()) / static_cast<double>(text.size()),
                            Message::marked("Reading"));
        }
        const auto repeated = repeatedWord(word);
        const auto number = repeated ? fortranNumber(repeated->word) : std::nullopt;
        if (!number)
            return notANumber(text, word);
        if (repeated->times > most - std::min<std::uint64_t>(most, result.numbers.size()))
            return Error{ErrorKind::BadInput, Message::say("with '%1' it repeats numbers more often than is plausible "
                                                           "for a file of its size. Write them one by one.",
                                                           printable(word))};
        result.numbers.insert(result.numbers.end(), repeated->times, *number);
        result.singlePrecision = result.singlePrecision && fitsSinglePrecision(repeated->word, *number);
    }
    return result;
}

} // namespace tetra
