// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/metadata.h"
#include "plugins/api/plugin_note.h"

#if !__has_include(<tan_plugin_metadata.h>)
#error "tan_plugin_module() makes tan_plugin_metadata.h of the plugin's JSON file: build the plugin with it."
#endif
#include <tan_plugin_metadata.h> // tetra::pluginMetadata and tetra::pluginBuild, texts

/// TAN_PLUGIN(CLASS, INTERFACE), once in a plugin, outside of all namespaces: the program finds CLASS, which is an
/// INTERFACE (tetra::Reader ...) and made without arguments, when it is first used; there is one object of it, which
/// lives until the program ends. What its constructor throws makes the plugin unusable, and its text is shown.
///
///     TAN_PLUGIN(LatticeReader, tetra::Reader)
#define TAN_PLUGIN(Class, Interface)                                                                                   \
    TAN_PLUGIN_NOTE(tetra::interfaceId<Interface>, tetra::qtOf<Interface>, tetra::pluginBuild)                         \
    TAN_PLUGIN_ENTRY(Class, Interface)

// The two halves of TAN_PLUGIN().

#ifdef __clang__ // puts zeros between what it checks
#define TAN_NOT_SANITIZED __attribute__((no_sanitize("address")))
#else
#define TAN_NOT_SANITIZED
#endif

/// What the library says of itself without being loaded.
#define TAN_PLUGIN_NOTE(interface, qt, build)                                                                          \
    namespace tan_plugin {                                                                                             \
    constexpr auto text = tetra::pluginNoteText(interface, qt, build, tetra::pluginMetadata);                          \
    TAN_NOT_SANITIZED                                                                                                  \
    __attribute__((section(".note.tan"), used, aligned(8))) constexpr tetra::PluginNote<tetra::totalBytes(text)>       \
        note(text);                                                                                                    \
    }

/// What the program calls: the object as the interface of this name, null if it is no such one.
#define TAN_PLUGIN_ENTRY(Class, Interface)                                                                             \
    static_assert(!tetra::interfaceId<Interface>.empty(), "an interface of plugins/api");                              \
    extern "C" __attribute__((visibility("default"))) const void* tanPlugin(const char* interface)                     \
    {                                                                                                                  \
        if (tetra::interfaceId<Interface> != interface)                                                                \
            return nullptr;                                                                                            \
        static const Interface* const plugin = new Class;                                                              \
        return plugin;                                                                                                 \
    }
