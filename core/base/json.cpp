// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>

namespace tetra {
namespace {

constexpr int deepestNesting = 64;

bool isDigit(char character)
{
    return character >= '0' && character <= '9';
}

void appendUtf8(std::string& text, std::uint32_t code)
{
    const auto add = [&](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xc0 | code >> 6);
        add(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        add(0xe0 | code >> 12);
        add(0x80 | (code >> 6 & 0x3f));
        add(0x80 | (code & 0x3f));
    } else {
        add(0xf0 | code >> 18);
        add(0x80 | (code >> 12 & 0x3f));
        add(0x80 | (code >> 6 & 0x3f));
        add(0x80 | (code & 0x3f));
    }
}

/// Reads from the front of a text; after the first error all reading fails.
class JsonReader {
public:
    explicit JsonReader(std::string_view text) : text_(text) {}

    Result<JsonValue> read()
    {
        std::optional<JsonValue> value = checkBytes() ? readValue(0) : std::nullopt;
        skipBlanks();
        if (value && next_ < text_.size())
            value = fail(Message::say("there is something after the end of the value"));
        if (value)
            return std::move(*value);
        return Error{ErrorKind::BadInput, error_};
    }

private:
    bool checkBytes()
    {
        const std::size_t good = utf8Bytes(text_);
        if (good == text_.size())
            return true;
        next_ = good;
        fail(Message::say("a byte that is not of UTF-8 text"));
        return false;
    }

    std::nullopt_t fail(const Message& what)
    {
        if (error_.empty())
            error_ = Message::say("Not valid JSON: %1 (%2).", what, describePlace(place()));
        return std::nullopt;
    }

    TextPlace place() const
    {
        const std::string_view before = text_.substr(0, next_);
        const auto lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
        return {lines + 1, before.size() - (before.rfind('\n') + 1) + 1};
    }

    void skipBlanks()
    {
        while (next_ < text_.size() && std::string_view(" \t\r\n").find(text_[next_]) != std::string_view::npos) {
            if (text_[next_] == '\n') {
                ++line_;
                lineStart_ = next_ + 1;
            }
            ++next_;
        }
    }

    bool take(std::string_view expected)
    {
        if (!text_.substr(next_).starts_with(expected))
            return false;
        next_ += expected.size();
        return true;
    }

    std::optional<JsonValue> readValue(int depth)
    {
        skipBlanks();
        JsonValue value;
        value.place = {line_, next_ - lineStart_ + 1};
        if (depth > deepestNesting)
            return fail(Message::say("too many levels"));
        if (take("null"))
            return value;
        if (take("true") || take("false")) {
            value.content = text_[next_ - 2] == 'u';
            return value;
        }
        if (take("["))
            return readArray(std::move(value), depth);
        if (take("{"))
            return readObject(std::move(value), depth);
        if (text_.substr(next_).starts_with('"')) {
            std::optional<std::string> string = readString();
            if (!string)
                return std::nullopt;
            value.content = std::move(*string);
            return value;
        }
        return readNumber(std::move(value));
    }

    std::optional<JsonValue> readArray(JsonValue value, int depth)
    {
        JsonArray elements;
        skipBlanks();
        if (!take("]")) {
            do {
                std::optional<JsonValue> element = readValue(depth + 1);
                if (!element)
                    return std::nullopt;
                elements.push_back(std::move(*element));
                skipBlanks();
            } while (take(","));
            if (!take("]"))
                return fail(Message::say("expected ',' or ']'"));
        }
        value.content = std::move(elements);
        return value;
    }

    std::optional<JsonValue> readObject(JsonValue value, int depth)
    {
        JsonObject members;
        std::unordered_set<std::string> names; // once there are many
        const auto isThere = [&](const std::string& name) {
            constexpr std::size_t few = 16;
            if (members.size() < few)
                return std::ranges::find(members, name, &JsonMember::first) != members.end();
            if (names.empty())
                for (const JsonMember& member : members)
                    names.insert(member.first);
            return !names.insert(name).second;
        };
        skipBlanks();
        if (!take("}")) {
            do {
                skipBlanks();
                std::optional<std::string> name = readString();
                if (!name)
                    return std::nullopt;
                if (isThere(*name))
                    return fail(Message::say("the member \"%1\" is there twice", printable(*name)));
                skipBlanks();
                if (!take(":"))
                    return fail(Message::say("expected ':'"));
                std::optional<JsonValue> member = readValue(depth + 1);
                if (!member)
                    return std::nullopt;
                members.emplace_back(std::move(*name), std::move(*member));
                skipBlanks();
            } while (take(","));
            if (!take("}"))
                return fail(Message::say("expected ',' or '}'"));
        }
        value.content = std::move(members);
        return value;
    }

    std::optional<JsonValue> readNumber(JsonValue value)
    {
        const std::size_t start = next_;
        const auto digits = [&] {
            const std::size_t first = next_;
            while (next_ < text_.size() && isDigit(text_[next_]))
                ++next_;
            return next_ > first;
        };
        take("-");
        bool good = take("0") || digits();
        if (good && take("."))
            good = digits();
        if (good && (take("e") || take("E"))) {
            if (!take("+"))
                take("-");
            good = digits();
        }
        if (!good)
            return fail(Message::say("expected a value"));
        value.content = JsonValue::Number{std::string(text_.substr(start, next_ - start))};
        return value;
    }

    std::optional<std::uint32_t> readHexadecimal()
    {
        std::uint32_t code = 0;
        for (int digit = 0; digit < 4; ++digit, ++next_) {
            constexpr std::string_view digits = "0123456789abcdef0123456789ABCDEF";
            const auto found = next_ < text_.size() ? digits.find(text_[next_]) : std::string_view::npos;
            if (found == std::string_view::npos)
                return fail(Message::say("expected four hexadecimal digits"));
            code = code * 16 + static_cast<std::uint32_t>(found % 16);
        }
        return code;
    }

    bool readEscape(std::string& string)
    {
        constexpr std::string_view names = "\"\\/bfnrt";
        constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
        const char name = next_ < text_.size() ? text_[next_++] : '\0';
        if (const auto found = names.find(name); found != std::string_view::npos) {
            string.push_back(meanings[found]);
            return true;
        }
        std::optional<std::uint32_t> code = name == 'u' ? readHexadecimal() : fail(Message::say("unknown escape"));
        if (code && *code >= 0xd800 && *code < 0xe000) {
            const bool high = *code < 0xdc00 && take("\\u");
            const std::optional<std::uint32_t> low =
                high ? readHexadecimal() : fail(Message::say("half of a surrogate pair"));
            if (low && *low >= 0xdc00 && *low < 0xe000)
                code = 0x10000 + ((*code - 0xd800) << 10) + (*low - 0xdc00);
            else
                code = fail(Message::say("half of a surrogate pair"));
        }
        if (code)
            appendUtf8(string, *code);
        return code.has_value();
    }

    std::optional<std::string> readString()
    {
        if (!take("\""))
            return fail(Message::say("expected a name in quotes"));
        std::string string;
        while (next_ < text_.size()) {
            const char character = text_[next_];
            if (static_cast<unsigned char>(character) < 0x20)
                return fail(Message::say("a control character inside quotes"));
            ++next_;
            if (character == '"')
                return string;
            if (character != '\\')
                string.push_back(character);
            else if (!readEscape(string))
                return std::nullopt;
        }
        return fail(Message::say("the closing quote is missing"));
    }

    std::string_view text_;
    std::size_t next_ = 0;
    std::size_t line_ = 1; ///< of next_, like lineStart_
    std::size_t lineStart_ = 0;
    Message error_;
};

} // namespace

Message describePlace(const TextPlace& place)
{
    return Message::say("line %1, column %2", place.line, place.column);
}

const JsonValue* JsonValue::find(std::string_view name) const noexcept
{
    const JsonObject* members = object();
    if (members == nullptr)
        return nullptr;
    const auto found = std::ranges::find(*members, name, &JsonMember::first);
    return found == members->end() ? nullptr : &found->second;
}

Result<JsonValue> parseJson(std::string_view text)
{
    return JsonReader(text).read();
}

namespace {

std::string numberText(const std::string& text)
{
    constexpr double most = 0x1p63;
    if (text.find_first_of(".eE") == std::string::npos)
        return text;
    const auto number = parseNumber<double>(text);
    const bool isWhole = number && std::abs(*number) < most && *number == std::trunc(*number);
    return isWhole ? std::to_string(static_cast<std::int64_t>(*number)) : text;
}

/// One line for each of a list, between the two brackets.
template <class List, class Add>
void addLines(const List& list, std::string_view brackets, int level, std::string& text, const Add& add)
{
    constexpr std::size_t blanks = 4;
    text += {brackets[0], '\n'};
    for (std::size_t left = list.size(); const auto& one : list) {
        text.append(blanks * static_cast<std::size_t>(level + 1), ' ');
        add(one);
        text += --left > 0 ? ",\n" : "\n";
    }
    text.append(blanks * static_cast<std::size_t>(level), ' ');
    text += brackets[1];
}

void addValue(const JsonValue& value, int level, std::string& text)
{
    if (const JsonArray* const array = value.array()) {
        addLines(*array, "[]", level, text, [&](const JsonValue& element) { addValue(element, level + 1, text); });
    } else if (const JsonObject* const object = value.object()) {
        std::vector<const JsonMember*> members;
        for (const JsonMember& member : *object)
            members.push_back(&member);
        std::ranges::sort(members, {}, [](const JsonMember* member) -> const std::string& { return member->first; });
        addLines(members, "{}", level, text, [&](const JsonMember* member) {
            text += jsonString(member->first) + ": ";
            addValue(member->second, level + 1, text);
        });
    } else if (const std::string* const string = value.string()) {
        text += jsonString(*string);
    } else if (const JsonValue::Number* const number = value.number()) {
        text += numberText(number->text);
    } else if (const bool* const truth = std::get_if<bool>(&value.content)) {
        text += *truth ? "true" : "false";
    } else {
        text += "null";
    }
}

} // namespace

std::string formatJson(const JsonValue& value)
{
    std::string text;
    addValue(value, 0, text);
    return text + '\n';
}

std::string jsonString(std::string_view text)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string quoted = "\"";
    while (true) {
        const std::size_t good = utf8Bytes(text);
        for (const char character : text.substr(0, good)) {
            const auto byte = static_cast<unsigned char>(character);
            if (character == '"' || character == '\\') {
                quoted += {'\\', character};
            } else if (byte < 0x20) {
                quoted += "\\u00";
                quoted += {digits[byte / 16], digits[byte % 16]};
            } else {
                quoted.push_back(character);
            }
        }
        if (good == text.size())
            return quoted + '"';
        quoted += "\xef\xbf\xbd"; // U+FFFD
        text.remove_prefix(good + 1);
    }
}

} // namespace tetra
