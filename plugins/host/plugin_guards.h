// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"
#include "plugins/api/metadata.h"
#include "plugins/api/reader.h"
#include "plugins/api/renderer.h"
#include "plugins/api/tool.h"
#include "plugins/api/writer.h"

#include <functional>
#include <memory>
#include <string>
#include <variant>

namespace tetra {

/// Who is guarded, and who hears of what has no Result to give; from any thread.
struct GuardTarget {
    std::string id;
    std::function<void(const Error&)> tell;
};

/// Plugins as the program calls them: what they throw ends here. A call that gives a Result gives an error then; of
/// others the failure is told, and they give nothing. What all plugins of a kind would have to do alike is done here,
/// too:
/// - readers: an error names the file, a dataset has its source's name, path and hash;
/// - readers and writers: the text when memory is short names the file;
/// - renderers: values that are missing or of another type are the defaults for the mesh; a text that is none of a
///   parameter's choices is an error of prepare(), and so is a scene that cannot be shown (none, or drawables without
///   an id or with the same one); the scene says whose it is (Scene::maker).
///
/// - tools: what an answer would keep that is no text (UTF-8, without zeros), or of more than mostToolBytes, is told
/// and
///   not kept; of two handles with one id the first is shown, and so are lines, points, texts and handles at finite
///   places only.
///
/// Each stands for `plugin`, which outlives it.
std::unique_ptr<const Builder> guarded(const Builder& plugin, GuardTarget target);
std::unique_ptr<const Reader> guarded(const Reader& plugin, GuardTarget target);
std::unique_ptr<const Writer> guarded(const Writer& plugin, GuardTarget target);
std::unique_ptr<const Renderer> guarded(const Renderer& plugin, GuardTarget target);
std::unique_ptr<const Tool> guarded(const Tool& plugin, GuardTarget target);

/// What a tool may keep in a view.
inline constexpr std::size_t mostToolBytes = std::size_t(1) << 20;

/// A plugin in use: its guard, or an editor, which whoever makes its widget guards (callPlugin()).
using PluginGuard = std::variant<std::monostate, std::unique_ptr<const Builder>, std::unique_ptr<const Reader>,
                                 std::unique_ptr<const Writer>, std::unique_ptr<const Renderer>, const Editor*,
                                 std::unique_ptr<const Tool>>;

} // namespace tetra
