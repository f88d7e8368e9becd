// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/animation.h"
#include "ui/session/annotation_state.h"
#include "ui/session/json_fields.h"

namespace tetra {

/// Annotations and films as JSON, and back, as view_json.h does it for the rest of a session.

/// {"colourBar": {"shown": true, "corner": "topRight"}, ...}
QJsonObject toJson(const AnnotationState& annotations);
void readAnnotations(const JsonFields& fields, AnnotationState& annotations);

QJsonObject toJson(const Animation& animation);
void readAnimation(const JsonFields& fields, Animation& animation, std::optional<Error>& error);

} // namespace tetra
