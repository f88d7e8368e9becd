// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <memory>
#include <string>

namespace tetra {

/// A renderer as the program calls it: `plugin`, whose id is `id`, behind a wall. What it throws becomes an error of
/// prepare(). Values that are missing or of another type are the defaults for the mesh; a text that is none of a
/// parameter's choices, and a scene that is none (no value, drawables without or with equal names), are errors. The
/// plugin must outlive it.
std::unique_ptr<Renderer> guardedRenderer(std::string id, const Renderer& plugin);

} // namespace tetra
