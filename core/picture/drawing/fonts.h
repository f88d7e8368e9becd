// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <memory>
#include <string>

namespace tetra {

/// The fonts of this system, as texts of one family take them (fontconfig): the family's own, and for characters that
/// it lacks the nearest others that have them. Files are opened when they are first needed, and stay open as long as
/// this lives: who paints more than one picture keeps it. Any number of threads.
class Fonts;

/// `family`: as fontconfig knows it, or what stands for one, such as "monospace"; empty: the system's sans-serif.
/// Errors (OutOfResource): this system has no font.
Result<std::shared_ptr<const Fonts>> openFonts(const std::string& family = {});

} // namespace tetra
