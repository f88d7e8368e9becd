// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/session_document.h"
#include "plugins/api/renderer.h"
#include "plugins/host/plugin_host.h"

#include <tan/model.h>

#include <string>
#include <vector>

namespace tetra {

/// A part of a look that a model cannot have.
struct SessionDifference {
    /// "model", "camera", "focus", "window", "clip", "slices", "animation", "isovalues", "transfer", "values",
    /// "mode", "tools", "bookmarks" or "annotations".
    std::string part;
    Message text; ///< a sentence: what is shown instead, and why
};

/// How a model is seen again, and what of that could not be kept.
struct RestoredView {
    SessionDocument document;
    std::vector<SessionDifference> differences{};
};

/// How a model is seen again: as `kept` says, as far as that fits it and is known here; the rest is as at first. Values
/// are kept as they are, so that colours mean the same in two models of different ranges. In another domain the
/// document has no camera any more: the view's is the direction from which it showed all of its model.
RestoredView restoredView(SessionDocument kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                          const FieldExtent& field);

/// That the model is another one than the document was made for, if it is and that is known.
std::optional<SessionDifference> differentModel(const SessionDocument& document, const Model& model);

/// How the model of a file is seen again that was seen like this last. Where other data have taken its place, with
/// another domain or without most of the range, nothing of that depends on places or values; that
/// is told only if its places were those of the same data without their directions.
RestoredView lastView(SessionDocument kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                      const FieldExtent& field);

} // namespace tetra
