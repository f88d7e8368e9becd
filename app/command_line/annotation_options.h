// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "core/picture/annotations/annotation_content.h"

namespace tetra {

/// What is written over a picture, as the window writes it: --colour-bar, --axes, --scale-bar, --title; and the ends of
/// the colour bar, --bar-range.
std::vector<Option> annotationOptions();

/// Which of them, each in its usual corner; the content says nothing more than the title yet. Errors (WrongUsage): ends
/// that are no range, or of a bar that is not asked for.
Result<AnnotationContent> annotationsOf(const Arguments& arguments);

} // namespace tetra
