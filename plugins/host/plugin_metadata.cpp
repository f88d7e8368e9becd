// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_metadata.h"

#include "core/base/json.h"
#include "plugins/api/metadata.h"
#include "plugins/api/tool.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace tetra {
namespace {

struct KindEntry {
    PluginKind kind;
    MarkedText text;
    std::string_view interface;

    std::string_view name() const noexcept { return text; }
};

constexpr std::array<KindEntry, 6> kinds = {{{PluginKind::Builder, Message::marked("builder"), interfaceId<Builder>},
                                             {PluginKind::Renderer, Message::marked("renderer"), interfaceId<Renderer>},
                                             {PluginKind::Reader, Message::marked("reader"), interfaceId<Reader>},
                                             {PluginKind::Writer, Message::marked("writer"), interfaceId<Writer>},
                                             {PluginKind::Editor, Message::marked("editor"), interfaceId<Editor>},
                                             {PluginKind::Tool, Message::marked("tool"), interfaceId<Tool>}}};

Error malformed(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("Its metadata are malformed: %1. Ask the plugin's author for a fixed version.", what)};
}

/// The text of a key that may be missing; empty then.
std::string textOf(const JsonValue& json, std::string_view key)
{
    const JsonValue* const value = json.find(key);
    const std::string* const text = value != nullptr ? value->string() : nullptr;
    return text != nullptr ? *text : std::string();
}

Result<std::string> requiredText(const JsonValue& json, const char* key)
{
    if (json.find(key) == nullptr)
        return malformed(Message::say("the key \"%1\" is missing", key));
    std::string text = textOf(json, key);
    if (text.empty())
        return malformed(Message::say("\"%1\" is not a string", key));
    return text;
}

Result<Version> requiredVersion(const JsonValue& json, const char* key)
{
    const auto text = requiredText(json, key);
    if (!text)
        return text.error();
    const auto version = parseVersion(*text);
    if (!version)
        return malformed(Message::say("\"%1\" is \"%2\", which is not a version like \"1.2.3\"", key, *text));
    return *version;
}

Result<PluginKind> parseKind(const std::string& text)
{
    const auto entry = std::ranges::find(kinds, std::string_view(text), &KindEntry::name);
    if (entry == kinds.end())
        return malformed(Message::say(
            "\"kind\" is \"%1\", which is not one of builder, renderer, reader, writer, editor, tool", text));
    return entry->kind;
}

bool isId(const std::string& text)
{
    return std::ranges::all_of(text, [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' ||
               letter == '_';
    });
}

Result<std::vector<std::string>> parseRequiredIds(const JsonValue* value)
{
    std::vector<std::string> ids;
    if (value == nullptr)
        return ids;
    if (value->array() == nullptr)
        return malformed(Message::say("\"requires\" is not a list"));
    for (const JsonValue& entry : *value->array()) {
        if (entry.string() == nullptr || !isId(*entry.string()))
            return malformed(Message::say("\"requires\" lists something that is not the id of a plugin"));
        ids.push_back(*entry.string());
    }
    return ids;
}

/// The values of the keys "name[de]", "name[it]" ..., by what stands in the brackets.
std::map<std::string, std::string> translationsOf(const JsonValue& json, const std::string& key)
{
    std::map<std::string, std::string> texts;
    const std::string start = key + '[';
    for (const auto& [name, value] : *json.object())
        if (name.starts_with(start) && name.ends_with(']') && value.string() != nullptr)
            texts[name.substr(start.size(), name.size() - start.size() - 1)] = *value.string();
    return texts;
}

} // namespace

std::string_view pluginKindName(PluginKind kind) noexcept
{
    return std::ranges::find(kinds, kind, &KindEntry::kind)->name();
}

Message pluginKindText(PluginKind kind)
{
    return std::ranges::find(kinds, kind, &KindEntry::kind)->text;
}

std::string_view pluginInterface(PluginKind kind) noexcept
{
    return std::ranges::find(kinds, kind, &KindEntry::kind)->interface;
}

Result<PluginMetadata> parsePluginMetadata(std::string_view text)
{
    const auto json = parseJson(text);
    if (!json)
        return Error{ErrorKind::BadInput,
                     Message::say("Its metadata are malformed: %1 Ask the plugin's author for a fixed version.",
                                  json.error().message)};
    const JsonValue* const found = json->find("metadata");
    if (found == nullptr || found->object() == nullptr)
        return malformed(Message::say("the key \"%1\" is missing", "metadata"));
    const JsonValue& own = *found;
    PluginMetadata metadata;
    const auto id = requiredText(own, "id");
    if (!id)
        return id.error();
    if (!isId(*id))
        return malformed(
            Message::say("\"id\" is \"%1\"; it may contain only lower-case letters, digits, '.', '-' and '_'", *id));
    metadata.id = *id;

    const auto kindName = requiredText(own, "kind");
    if (!kindName)
        return kindName.error();
    const auto kind = parseKind(*kindName);
    if (!kind)
        return kind.error();
    metadata.kind = *kind;

    const auto version = requiredVersion(own, "version");
    if (!version)
        return version.error();
    metadata.version = *version;
    const auto api = requiredVersion(own, "api");
    if (!api)
        return api.error();
    metadata.api = *api;

    const auto name = requiredText(own, "name");
    if (!name)
        return name.error();
    metadata.name = *name;

    auto requiredIds = parseRequiredIds(own.find("requires"));
    if (!requiredIds)
        return requiredIds.error();
    metadata.requiredIds = *std::move(requiredIds);

    metadata.title = textOf(own, own.find("title") != nullptr ? "title" : "name");
    metadata.edits = textOf(own, "edits");
    if (metadata.kind == PluginKind::Editor && metadata.edits.empty())
        return malformed(Message::say("\"edits\" does not state which type of parameters the editor is for"));
    metadata.description = textOf(own, "description");
    metadata.names = translationsOf(own, "name");
    metadata.titles = translationsOf(own, own.find("title") != nullptr ? "title" : "name");
    metadata.descriptions = translationsOf(own, "description");
    metadata.remedy = textOf(own, "remedy");
    metadata.interface = textOf(*json, "interface");
    metadata.qt = parseVersion(textOf(*json, "qt")).value_or(Version{});
    metadata.buildTag = textOf(*json, "build");
    return metadata;
}

} // namespace tetra
