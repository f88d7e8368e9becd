// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/xml_tags.h"

#include <array>

namespace tetra {

namespace {

constexpr std::string_view tagBlanks = " \t\r\n";

std::string unescaped(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, char>, 5> entities = {
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    while (!text.empty()) {
        std::size_t taken = 1;
        char c = text[0];
        for (const auto& [entity, meaning] : entities)
            if (text.starts_with(entity)) {
                taken = entity.size();
                c = meaning;
            }
        result += c;
        text.remove_prefix(taken);
    }
    return result;
}

std::string_view trimmed(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(tagBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(tagBlanks) + 1);
}

/// key="value" key='value' ...; false if it is something else.
bool parseAttributes(std::string_view text, XmlTag& tag)
{
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos)
            return false;
        const std::string_view key = trimmed(text.substr(0, equals));
        text = trimmed(text.substr(equals + 1));
        if (text.empty() || (text[0] != '"' && text[0] != '\''))
            return false;
        const std::size_t end = text.find(text[0], 1);
        if (end == std::string_view::npos)
            return false;
        tag.attributes.emplace_back(key, unescaped(text.substr(1, end - 1)));
        text.remove_prefix(end + 1);
    }
    return true;
}

} // namespace

std::string XmlTag::attribute(std::string_view key) const
{
    for (const auto& [found, value] : attributes)
        if (found == key)
            return value;
    return {};
}

std::optional<XmlTag> XmlTags::fail()
{
    broken_ = true;
    at_ = text_.size();
    return std::nullopt;
}

std::optional<XmlTag> XmlTags::next()
{
    for (;;) {
        const std::size_t begin = text_.find('<', at_);
        if (begin == std::string_view::npos)
            return std::nullopt;
        const bool comment = text_.substr(begin).starts_with("<!--");
        const std::size_t end = comment ? text_.find("-->", begin) : text_.find('>', begin);
        if (end == std::string_view::npos)
            return fail();
        at_ = end + (comment ? 3 : 1);
        std::string_view inside = text_.substr(begin + 1, end - begin - 1);
        if (comment || inside.starts_with('?') || inside.starts_with('!'))
            continue;
        XmlTag tag;
        tag.end = at_;
        if (inside.starts_with('/')) {
            tag.closes = true;
            tag.opens = false;
            inside.remove_prefix(1);
        } else if (inside.ends_with('/')) {
            tag.closes = true;
            inside.remove_suffix(1);
        }
        tag.name = inside.substr(0, inside.find_first_of(tagBlanks));
        if (tag.name.empty() || !parseAttributes(inside.substr(tag.name.size()), tag))
            return fail();
        return tag;
    }
}

} // namespace tetra
