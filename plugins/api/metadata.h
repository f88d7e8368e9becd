// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/version.h"

#include <string_view>

namespace tetra {

class Builder;
class Renderer;
class Reader;
class Writer;
class Editor;

/// The name of an interface. Its number goes up with every change, and a plugin of another number is not loaded.
template <class Interface> inline constexpr std::string_view interfaceId;
template <> inline constexpr std::string_view interfaceId<Builder> = "org.tan.Builder/2";
template <> inline constexpr std::string_view interfaceId<Renderer> = "org.tan.Renderer/4";
template <> inline constexpr std::string_view interfaceId<Reader> = "org.tan.Reader/3";
template <> inline constexpr std::string_view interfaceId<Writer> = "org.tan.Writer/4";
template <> inline constexpr std::string_view interfaceId<Editor> = "org.tan.Editor/3";

/// The version of Qt that plugins of a kind are built with, which the program's must fit. Of editors (editor.h), which
/// make widgets, and of nobody else.
template <class Interface> inline constexpr std::string_view qtOf;

/// What every plugin says of itself in the JSON file that tan_plugin_module() names (TAnPlugin.cmake). It is put into
/// the library, and read without running any code of that (plugin_note.h). The library's other end is one line
/// (plugin.h):
///
///     class LatticeReader : public tetra::Reader { ... };
///     TAN_PLUGIN(LatticeReader, tetra::Reader)
///
/// | key         | type             | meaning                                                                       |
/// |-------------|------------------|-------------------------------------------------------------------------------|
/// | id          | string, required | stable name, unique among all plugins: lower-case letters, digits, . - _      |
/// | kind        | string, required | builder, renderer, reader, writer, editor or tool: fits the interface         |
/// | version     | string, required | the plugin's own, "1.2.3"                                                     |
/// | api         | string, required | pluginInterfaceVersion of the headers that it is written for, "0.2"           |
/// | name        | string, required | for people                                                                    |
/// | title       | string           | a word or two for an editor's dock; else the name                             |
/// | description | string           | one or two sentences for people                                               |
/// | name[de] .. | string           | the name in another language, by its code; title[de], description[de] likewise |
/// | edits       | string           | of editors, required: parameterTypeName() of what they edit, or a type of the |
/// |             |                  | plugin's own (OwnValue::type)                                                 |
/// | requires    | array of strings | ids of plugins that must be there, and are loaded before                      |
/// | remedy      | string           | what to do if a library that it needs is missing: "Install libvtk9.1."        |
///
/// Other keys are ignored. A plugin is built with tan_plugin_module(), which adds the tag of its build: the system, the
/// compiler, the C++ library, and TAn's version. A plugin of another build is not loaded, and the user is told why.
///
/// All other texts of a plugin are Messages, or marked by Message::marked(). Their translations are in a file beside
/// the library that is called like it: libmine_de.qm beside libmine.so (docs/developer/guide.md).
///
/// Until 1.0 the interfaces have the program's version, and another minor version does not fit. From then on a
/// published interface never changes: what it lacks comes as a new, optional one, which the minor number counts.
inline constexpr Version pluginInterfaceVersion{0, 2, 0};

} // namespace tetra
