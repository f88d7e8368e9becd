// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/build_facts.h"

#include <charconv>
#include <limits>

namespace tetra {

BuildFacts buildFacts(const ModelDescription& description)
{
    BuildFacts facts;
    facts.isRefined = description.builder == buildText::refinement;
    for (const auto& [name, text] : description.parameters) {
        if (name == buildText::error)
            facts.error = parseNumber<double>(text).value_or(std::numeric_limits<double>::quiet_NaN());
        else if (name == buildText::weights)
            facts.weights = text;
        else if (name == buildText::block)
            std::from_chars(text.data(), text.data() + text.size(), facts.blockCells); // a word leaves it
        else if (name == buildText::selection)
            facts.hasPaperSelection = text == buildText::paper;
        else if (name == buildText::errorIn)
            facts.claimsInSpace = text == buildText::space;
        else if (name == buildText::distance)
            facts.claimsTwoSides = text == buildText::twoSided;
    }
    return facts;
}

} // namespace tetra
