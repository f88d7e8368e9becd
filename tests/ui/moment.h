// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"
#include "ui/session/session_document.h"
#include "ui/viewport/viewport.h"

#include <optional>
#include <vector>

namespace tetra {

/// All of a window that the user can change and undo, at a moment.
struct Moment {
    QueryState query;
    Look look;
    std::vector<Isovalue> isovalues;
    AnnotationState annotations;
    Animation animation;
    Camera camera;
    std::optional<Colour> background;
    bool operator==(const Moment&) const = default;
};

inline Moment momentOf(const Session& session, const Viewport& viewport)
{
    const ViewState& view = session.view();
    return {view.query(),     view.look(),       view.isovalues(),           view.annotations(),
            view.animation(), viewport.camera(), viewport.chosenBackground()};
}

/// As a file keeps it.
inline Moment momentOf(const SessionDocument& document)
{
    return {document.query,       document.look,      document.isovalues,
            document.annotations, document.animation, document.camera.value_or(Camera{}),
            document.background};
}

} // namespace tetra
