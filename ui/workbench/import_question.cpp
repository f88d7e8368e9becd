// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/import_question.h"

namespace tetra {

bool offersChoice(const FileContents& contents)
{
    return contents.arrays.size() > 1 || contents.timeSteps.size() > 1 || contents.blocks.size() > 1 ||
           !contents.suggestions.empty();
}

} // namespace tetra
