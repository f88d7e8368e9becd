// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"
#include "core/picture/drawing/rectangle.h"
#include "plugins/api/tool.h"
#include "plugins/host/plugin_host.h"

#include <tan/model.h>
#include <tan/parameter.h>
#include <tan/render.h>
#include <tan/view.h>

#include <vector>

namespace tetra {

/// How annotations of this language write numbers, for ToolSurroundings.
ToolNumbers numbersOf(const AnnotationLanguage& language);

/// Those of the tools that keep something in a view that are there.
std::vector<Provided<Tool>> keptTools(PluginHost& host, const ViewValue& view);

/// What the tools that keep something in a view show in a picture of it, seen by this camera: without their handles, as
/// nobody grabs them there, and
/// none that is empty. `parameters`: of the rendering mode, those that matter; `size`: of the picture, in units of
/// which a text is twelve high. Any thread.
std::vector<ToolDrawing> keptDrawings(const std::vector<Provided<Tool>>& tools, const ModelDescription& model,
                                      const std::vector<Parameter>& parameters, const ViewValue& view,
                                      const Camera& camera, const Size& size, const AnnotationLanguage& language);

} // namespace tetra
