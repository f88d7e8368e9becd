// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/version.h"

namespace tetra {

/// What every plugin says of itself in the JSON file that its Q_PLUGIN_METADATA names. It is read without running any
/// code of the plugin.
///
///     class LatticeReader : public QObject, public Reader {
///         Q_OBJECT
///         Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "lattice.json")
///         Q_INTERFACES(tetra::Reader)
///         ...
///
/// | key         | type             | meaning                                                                       |
/// |-------------|------------------|-------------------------------------------------------------------------------|
/// | id          | string, required | stable name, unique among all plugins: lower-case letters, digits, . - _      |
/// | kind        | string, required | builder, renderer, reader, writer or editor: fits the IID                     |
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
/// the library that is called like it: libmine_de.qm beside libmine.so (docs/developers.md).
///
/// Until 1.0 the interfaces have the program's version, and another minor version does not fit. From then on a
/// published interface never changes: what it lacks comes as a new, optional one, which the minor number counts.
inline constexpr Version pluginInterfaceVersion{0, 2, 0};

} // namespace tetra
