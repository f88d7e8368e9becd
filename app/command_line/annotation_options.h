// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"

#include <tan/view.h>

namespace tetra {

/// What is written over a picture, as the window writes it: --colour-bar, --axes, --scale-bar, --title; and the ends of
/// the colour bar and its texts, --bar-range, --bar-quantity, --bar-unit, --bar-numbers.
std::vector<Option> annotationOptions();

/// Which of them, each in its usual corner, and what the options say of their texts. Errors (WrongUsage): ends that are
/// no range, numbers that nobody can write so, or something of a bar that is not asked for.
Result<AnnotationState> annotationsOf(const Arguments& arguments);

} // namespace tetra
