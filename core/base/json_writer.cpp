// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_writer.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tetra {
namespace {

/// "\u202e"; a character beyond U+FFFF takes two of them (RFC 8259, 7).
void appendEscape(std::string& text, std::uint32_t code)
{
    if (code > 0xffff) {
        appendEscape(text, 0xd800 + ((code - 0x10000) >> 10));
        code = 0xdc00 + (code & 0x3ff);
    }
    constexpr std::string_view digits = "0123456789abcdef";
    text += "\\u";
    for (const unsigned shift : {12U, 8U, 4U, 0U})
        text += digits[code >> shift & 15];
}

void appendCharacter(std::string& text, char character)
{
    constexpr std::string_view meanings = "\"\\\b\f\n\r\t";
    constexpr std::string_view names = "\"\\bfnrt";
    const auto found = meanings.find(character);
    if (found != std::string_view::npos)
        text += {'\\', names[found]};
    else if (static_cast<unsigned char>(character) < 0x20)
        appendEscape(text, static_cast<unsigned char>(character));
    else
        text += character;
}

/// Of a finite number: JsonValue says which.
std::string floatingText(double number)
{
    constexpr double mostExact = 1LL << 53;
    if (std::abs(number) <= mostExact && number == std::trunc(number))
        return std::to_string(static_cast<std::int64_t>(number));
    std::array<char, 32> buffer{}; // -1.7976931348623157e+308 has 24 characters
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::scientific);
    const std::string scientific(buffer.data(), end);
    const std::size_t start = scientific[0] == '-' ? 1 : 0, exponentMark = scientific.find('e');
    const int exponent = *parseNumber<int>(std::string_view(scientific).substr(exponentMark + 1));
    std::string digits = scientific.substr(start, exponentMark - start);
    std::erase(digits, '.');
    // The same digits without an exponent: the shortest that read back, and zeros where more places are needed.
    const auto whole = static_cast<std::size_t>(std::max(exponent + 1, 1));
    if (exponent < 0)
        digits.insert(0, static_cast<std::size_t>(-exponent), '0');
    if (digits.size() < whole)
        digits.append(whole - digits.size(), '0');
    else if (digits.size() > whole)
        digits.insert(whole, ".");
    const std::string plain = scientific.substr(0, start) + digits;
    return plain.size() <= scientific.size() ? plain : scientific;
}

/// Writes one value after the other to the end of a text.
class JsonWriter {
public:
    explicit JsonWriter(bool isIndented) : isIndented_(isIndented) {}

    void write(const JsonValue& value)
    {
        if (const bool* const truth = std::get_if<bool>(&value.content))
            text_ += *truth ? "true" : "false";
        else if (const JsonValue::Number* const number = value.number())
            text_ += number->text;
        else if (const std::string* const string = value.string())
            text_ += jsonString(*string);
        else if (const JsonArray* const elements = value.array())
            writeList('[', *elements, ']', [this](const JsonValue& element) { write(element); });
        else if (const JsonObject* const members = value.object())
            writeList('{', *members, '}', [this](const JsonMember& member) {
                text_ += jsonString(member.first) + (isIndented_ ? ": " : ":");
                write(member.second);
            });
        else
            text_ += "null";
    }

    std::string take() { return std::move(text_); }

private:
    template <class List, class WriteOne>
    void writeList(char opening, const List& list, char closing, const WriteOne& writeOne)
    {
        text_ += opening;
        ++depth_;
        bool isFirst = true;
        for (const auto& one : list) {
            if (!isFirst)
                text_ += ',';
            isFirst = false;
            startLine();
            writeOne(one);
        }
        --depth_;
        startLine();
        text_ += closing;
    }

    void startLine()
    {
        constexpr std::size_t blanks = 4;
        if (isIndented_)
            text_.append("\n").append(blanks * depth_, ' ');
    }

    bool isIndented_;
    std::size_t depth_ = 0;
    std::string text_;
};

/// Of the characters of category Cf (Unicode 15) those that are seen: joiners of letters, and signs that stand around
/// numbers and verses.
bool isSeenFormat(std::uint32_t code) noexcept
{
    struct Range {
        std::uint32_t first, last;
    };
    constexpr std::array<Range, 7> formats = {{{0x600, 0x605},
                                               {0x6dd, 0x6dd},
                                               {0x890, 0x891},
                                               {0x8e2, 0x8e2},
                                               {0x200c, 0x200d},
                                               {0x110bd, 0x110bd},
                                               {0x110cd, 0x110cd}}};
    return std::ranges::any_of(formats, [&](const Range& range) { return range.first <= code && code <= range.last; });
}

} // namespace

std::string compactJson(const JsonValue& value)
{
    JsonWriter writer(false);
    writer.write(value);
    return writer.take();
}

std::string indentedJson(const JsonValue& value)
{
    JsonWriter writer(true);
    writer.write(value);
    return writer.take() + "\n";
}

JsonValue byName(JsonValue value)
{
    if (JsonArray* const elements = value.array())
        for (JsonValue& element : *elements)
            element = byName(std::move(element));
    if (JsonObject* const members = value.object()) {
        for (auto& [name, member] : *members)
            member = byName(std::move(member));
        std::ranges::sort(*members, {}, &JsonMember::first);
    }
    return value;
}

std::string visibleJson(std::string_view json)
{
    std::string visible;
    while (!json.empty()) {
        const TextCharacter next = firstCharacter(json);
        const bool isLayout = next.code == '\n'; // between values: in strings it is an escape already
        if (isLayout || (isSeenAsItself(next.code) && !isSeenFormat(next.code)))
            visible += json.substr(0, next.bytes);
        else
            appendEscape(visible, next.code);
        json.remove_prefix(next.bytes);
    }
    return visible;
}

std::string jsonString(std::string_view text)
{
    std::string quoted = "\"";
    while (true) {
        const std::size_t good = utf8Bytes(text);
        for (const char character : text.substr(0, good))
            appendCharacter(quoted, character);
        if (good == text.size())
            return quoted + '"';
        quoted += "\xef\xbf\xbd"; // U+FFFD
        text.remove_prefix(good + 1);
    }
}

JsonValue JsonValue::ofFloating(double number)
{
    return std::isfinite(number) ? JsonValue(Number{floatingText(number)}) : JsonValue();
}

} // namespace tetra
