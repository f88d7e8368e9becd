// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json.h"

#include "core/base/text.h"

#include <algorithm>
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
            value = fail(Message::say("there is text after the end of the value"));
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
        fail(Message::say("a byte that is not valid UTF-8"));
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
            return fail(Message::say("too many levels of nesting"));
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
                return members.find(name) != nullptr;
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
                    return fail(Message::say("the member \"%1\" appears twice", printable(*name)));
                skipBlanks();
                if (!take(":"))
                    return fail(Message::say("expected ':'"));
                std::optional<JsonValue> member = readValue(depth + 1);
                if (!member)
                    return std::nullopt;
                members.append(std::move(*name), std::move(*member));
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

JsonObject::JsonObject(std::initializer_list<JsonMember> members)
{
    for (const JsonMember& member : members)
        (*this)[member.first] = member.second;
}

JsonValue& JsonObject::operator[](std::string_view name)
{
    const auto found = std::ranges::find(members_, name, &JsonMember::first);
    return found != members_.end() ? found->second : members_.emplace_back(name, JsonValue()).second;
}

const JsonValue* JsonObject::find(std::string_view name) const noexcept
{
    const auto found = std::ranges::find(members_, name, &JsonMember::first);
    return found == members_.end() ? nullptr : &found->second;
}

void JsonObject::append(std::string name, JsonValue value)
{
    members_.emplace_back(std::move(name), std::move(value));
}

std::size_t JsonObject::size() const noexcept
{
    return members_.size();
}

JsonObject::Members::const_iterator JsonObject::begin() const noexcept
{
    return members_.begin();
}

JsonObject::Members::const_iterator JsonObject::end() const noexcept
{
    return members_.end();
}

JsonObject::Members::iterator JsonObject::begin() noexcept
{
    return members_.begin();
}

JsonObject::Members::iterator JsonObject::end() noexcept
{
    return members_.end();
}

const JsonValue* JsonValue::find(std::string_view name) const noexcept
{
    const JsonObject* members = object();
    return members != nullptr ? members->find(name) : nullptr;
}

Result<JsonValue> parseJson(std::string_view text)
{
    return JsonReader(text).read();
}

} // namespace tetra
