// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/json_fields.h"
#include "ui/session/view_value.h"

namespace tetra {

/// A view as JSON, and back: the one form that sessions, views that are kept, and pictures have of it.
///
///     {"mesh": {"error": 1, "focus": {...}, ...}, "look": {"mode": "volume", "transfer": {...}, "settings": {...}},
///      "isovalues": [...], "annotations": {"axes": {"shown": true, "corner": "bottomLeft"}, ...},
///      "animation": {...}, "camera": {...}, "background": [0, 0, 0.5]}
///
/// Cameras and transfer functions are in the forms that their own files have. Settings keep their type:
/// {"integer": 3}, {"number": 0.5}, true, "text". A background that nobody chose is left out.
QJsonObject toJson(const ViewValue& view);

/// What the text leaves open stays as it is in `view`; of a camera, what fits a box of side 1.
void readView(const JsonFields& fields, ViewValue& view);

} // namespace tetra
