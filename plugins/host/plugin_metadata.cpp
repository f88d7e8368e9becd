// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_metadata.h"

#include "plugins/api/builder.h"
#include "plugins/api/editor.h"
#include "plugins/api/reader.h"
#include "plugins/api/renderer.h"
#include "plugins/api/writer.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <optional>

namespace tetra {
namespace {

struct KindEntry {
    PluginKind kind;
    MarkedText text;
    std::string_view interface;

    std::string_view name() const noexcept { return text; }
};

constexpr std::array<KindEntry, 5> kinds = {
    {{PluginKind::Builder, Message::marked("builder"), TAN_BUILDER_INTERFACE},
     {PluginKind::Renderer, Message::marked("renderer"), TAN_RENDERER_INTERFACE},
     {PluginKind::Reader, Message::marked("reader"), TAN_READER_INTERFACE},
     {PluginKind::Writer, Message::marked("writer"), TAN_WRITER_INTERFACE},
     {PluginKind::Editor, Message::marked("editor"), TAN_EDITOR_INTERFACE}}};

Error malformed(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("Its metadata are malformed: %1. Ask the plugin's author for a fixed version.", what)};
}

Result<std::string> requiredText(const QJsonObject& json, const char* key)
{
    const QJsonValue value = json.value(QLatin1String(key));
    if (value.isUndefined())
        return malformed(Message::say("the key \"%1\" is missing", key));
    if (!value.isString() || value.toString().isEmpty())
        return malformed(Message::say("\"%1\" is not a text", key));
    return value.toString().toStdString();
}

Result<Version> requiredVersion(const QJsonObject& json, const char* key)
{
    const auto text = requiredText(json, key);
    if (!text)
        return text.error();
    const auto version = parseVersion(*text);
    if (!version)
        return malformed(Message::say("\"%1\" is \"%2\", which is no version like \"1.2.3\"", key, *text));
    return *version;
}

Result<PluginKind> parseKind(const std::string& text)
{
    const auto entry = std::ranges::find(kinds, std::string_view(text), &KindEntry::name);
    if (entry == kinds.end())
        return malformed(
            Message::say("\"kind\" is \"%1\", which is none of builder, renderer, reader, writer, editor", text));
    return entry->kind;
}

bool isId(const std::string& text)
{
    return std::ranges::all_of(text, [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' ||
               letter == '_';
    });
}

Result<std::vector<std::string>> parseRequiredIds(const QJsonValue& value)
{
    std::vector<std::string> ids;
    if (value.isUndefined())
        return ids;
    if (!value.isArray())
        return malformed(Message::say("\"requires\" is not a list"));
    for (const QJsonValue entry : value.toArray()) {
        if (!entry.isString() || !isId(entry.toString().toStdString()))
            return malformed(Message::say("\"requires\" lists something that is no plugin's id"));
        ids.push_back(entry.toString().toStdString());
    }
    return ids;
}

/// The values of the keys "name[de]", "name[it]" ..., by what stands in the brackets.
std::map<std::string, std::string> translationsOf(const QJsonObject& json, const QString& key)
{
    std::map<std::string, std::string> texts;
    for (auto member = json.begin(); member != json.end(); ++member)
        if (const QString name = member.key(); name.startsWith(key + '[') && name.endsWith(']'))
            texts[name.mid(key.size() + 1).chopped(1).toStdString()] = member.value().toString().toStdString();
    return texts;
}

/// Qt writes its version as 0x00MMmmpp.
Version qtVersion(int packed)
{
    return {packed >> 16, packed >> 8 & 0xff, packed & 0xff};
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

Result<PluginMetadata> parsePluginMetadata(const QJsonObject& json)
{
    const QJsonObject own = json.value(QLatin1String("MetaData")).toObject();
    PluginMetadata metadata;
    const auto id = requiredText(own, "id");
    if (!id)
        return id.error();
    if (!isId(*id))
        return malformed(
            Message::say("\"id\" is \"%1\"; only lower-case letters, digits, '.', '-' and '_' may stand in it", *id));
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

    auto requiredIds = parseRequiredIds(own.value(QLatin1String("requires")));
    if (!requiredIds)
        return requiredIds.error();
    metadata.requiredIds = *std::move(requiredIds);

    metadata.title =
        own.value(QLatin1String("title")).toString(own.value(QLatin1String("name")).toString()).toStdString();
    metadata.edits = own.value(QLatin1String("edits")).toString().toStdString();
    if (metadata.kind == PluginKind::Editor && metadata.edits.empty())
        return malformed(Message::say("\"edits\" does not say which type of parameters the editor is for"));
    metadata.description = own.value(QLatin1String("description")).toString().toStdString();
    metadata.names = translationsOf(own, "name");
    metadata.titles = translationsOf(own, own.contains(QLatin1String("title")) ? "title" : "name");
    metadata.descriptions = translationsOf(own, "description");
    metadata.remedy = own.value(QLatin1String("remedy")).toString().toStdString();
    metadata.interface = json.value(QLatin1String("IID")).toString().toStdString();
    metadata.qt = qtVersion(json.value(QLatin1String("version")).toInt());
    metadata.buildTag = json.value(QLatin1String("build")).toArray().at(0).toString().toStdString();
    return metadata;
}

} // namespace tetra
