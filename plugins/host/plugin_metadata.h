// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/version.h"

#include <tan/base.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

enum class PluginKind { Builder, Renderer, Reader, Writer, Editor, Tool };

/// "builder", "renderer", "reader", "writer", "editor", "tool".
std::string_view pluginKindName(PluginKind kind) noexcept;

/// The same, for the user.
Message pluginKindText(PluginKind kind);

/// The id of the interface that a plugin of this kind implements.
std::string_view pluginInterface(PluginKind kind) noexcept;

/// What a plugin says of itself (plugins/api/metadata.h), and what its build wrote into it.
struct PluginMetadata {
    std::string id;
    PluginKind kind = PluginKind::Builder;
    Version version;
    Version api;
    std::string name;
    std::string title; ///< a word or two, for a dock; else the name
    std::string description;
    /// The three in other languages, by their codes: "de", "pt_BR".
    std::map<std::string, std::string> names, titles, descriptions;
    std::string edits; ///< of editors: the type of the parameters that they edit
    std::vector<std::string> requiredIds;
    std::string remedy;
    std::string interface; ///< the id of what it implements
    Version qt;            ///< of the Qt that an editor was built with; 0 of others
    std::string buildTag;  ///< what it was built with, and for (TAnPlugin.cmake)
};

/// Reads what a library says of itself (plugin_file.h). The error says which key is missing or wrong.
Result<PluginMetadata> parsePluginMetadata(std::string_view text);

} // namespace tetra
