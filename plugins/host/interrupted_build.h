// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tetra {

// A build that can be resumed (BuildControl::resume) has a note in its work folder that says which build it is: of
// which data, by which builder, with which values. What the build has done is the core's (core/base/saved_state.h),
// which takes up none of another build, whatever a note says.

/// What a note says: the builder's parameters that matter, with their defaults where `values` lacks them.
std::string buildNote(const Dataset& dataset, const Provided<Builder>& builder, const ParameterValues& values);

/// Leaves the note, unless there is something already that this build goes on with or is refused for. Failing that
/// costs no more than a word to the user later.
void leaveNote(const std::filesystem::path& workFolder, std::string_view note);

/// The note that an interrupted build has left where the model `output` is to be; empty if there is none, or if another
/// program is building. Reads a small file, for which a disk may take its time, and keeps others from building there
/// meanwhile: for a worker thread, and not while this program is building there.
std::string interruptedNote(const std::filesystem::path& output);

/// What is there to be gone on with where the model `output` is to be.
enum class LeftBuild {
    None,  ///< nothing, or another program is building
    Same,  ///< of the same build
    Other, ///< of other data, of another builder or values, or of another version of TAn
};
/// Of a note that was found there.
LeftBuild leftBuild(PluginHost& host, const Dataset& dataset, const std::string& builder, const ParameterValues& values,
                    std::string_view note);

/// A build of these data that can be gone on with.
struct InterruptedBuild {
    std::string builder; ///< id
    ParameterValues values;
};
/// Nothing if leftBuild() would not find Same whatever was chosen.
std::optional<InterruptedBuild> interruptedBuild(PluginHost& host, const Dataset& dataset, std::string_view note);

/// Removes what any interrupted build of this model left. May take a while: call it from a worker thread. Errors:
/// another program is building it; the folder is none of TAn's.
Status discardInterruptedBuild(const std::filesystem::path& output);

} // namespace tetra
