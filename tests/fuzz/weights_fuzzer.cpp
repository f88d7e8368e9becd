// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for the text of a weighting; what is read weighs, and comes back from its text.
#include "tests/fuzz/fuzz_input.h"

#include <tan/data.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    const auto weighting = parseWeighting(asText(bytes, size));
    if (!weighting) {
        requireText(weighting.error());
        return 0;
    }
    const double weight = weighting->weight({1, 2, 3}, 50);
    require(weight > 0 && weight <= 1, "a weight lies in (0, 1]");
    const std::string text = weightingText(*weighting);
    const auto again = parseWeighting(text);
    require(again && weightingText(*again) == text, "a weighting comes back");
    return 0;
}
