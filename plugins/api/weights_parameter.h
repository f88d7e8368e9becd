// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/data.h>

#include <string>

namespace tetra {

/// "weights", the parameter of builders that weight errors and warpings (R6): a text for parseWeighting().
inline Parameter weightsParameter()
{
    Parameter weights;
    weights.id = "weights";
    weights.label = Message::marked("Weights");
    weights.explanation =
        Message::marked("Where accuracy matters: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach or value:q,reach, "
                        "several separated by ';'. Errors there count in full, and the weight falls linearly to a "
                        "tenth (or to ',floor' at the end) at the distance 'reach'; where several apply, the largest "
                        "weight counts. Examples: 'point:16,16,8,10', 'value:120,15,0.05'.");
    weights.defaultValue = std::string();
    weights.separator = ';';
    weights.mistake = [](const std::string& text) {
        const auto weighting = parseWeighting(text);
        return weighting ? Message() : weighting.error().message;
    };
    return weights;
}

} // namespace tetra
