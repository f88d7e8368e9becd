// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_metadata.h"

namespace tetra {

/// What a plugin must fit to be loaded.
struct HostBuild {
    Version api;
    Version qt; ///< of the Qt that runs; 0 in a program without windows, which uses no editors
    std::string buildTag;
};

/// Of this program; whoever makes windows adds its Qt.
HostBuild thisBuild();

/// Whether a plugin can be loaded at all, from its metadata alone: an interface of its kind and of this major version,
/// no newer Qt where it needs one, the same build tag: system, pointers, compiler, C++ library, TAn's version
/// before 1.0. The error names both and what to do.
Status checkCompatible(const PluginMetadata& plugin, const HostBuild& host);

} // namespace tetra
