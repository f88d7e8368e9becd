// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

namespace tetra {

/// How the boundary of the mesh is shown: parameters that all renderers share (plugins/api/scene_parameters.h).
inline constexpr const char* boundaryId = "boundary";
inline constexpr const char* boundaryOpacityId = "boundary-opacity";
inline constexpr const char* boundaryFarSideId = "boundary-far-side";
inline constexpr const char* boundaryOff = Message::marked("off").text;
inline constexpr const char* boundaryTranslucent = Message::marked("translucent").text;
inline constexpr const char* boundaryValues = Message::marked("values").text;

/// std::string, one of the three above, the first by default.
inline Parameter boundaryParameter()
{
    Parameter parameter;
    parameter.id = boundaryId;
    parameter.label = Message::marked("Boundary");
    parameter.explanation = Message::marked(
        "Shows where the mesh ends, holes and cavities included: 'translucent' in a light colour, so that you can see "
        "inside, or in the colours that the transfer function gives the 'values' there.");
    parameter.defaultValue = std::string(boundaryOff);
    parameter.choices = {boundaryOff, boundaryTranslucent, boundaryValues};
    return parameter;
}

/// double in (0, 1].
inline Parameter boundaryOpacityParameter()
{
    Parameter parameter;
    parameter.id = boundaryOpacityId;
    parameter.label = Message::marked("Opacity of the boundary");
    parameter.explanation = Message::marked("The opacity of a translucent boundary; 1 hides what is behind it.");
    parameter.defaultValue = 0.25;
    parameter.minimum = 0.01;
    parameter.maximum = 1;
    parameter.onlyWith = {boundaryId, {std::string(boundaryTranslucent)}};
    return parameter;
}

/// bool, false by default.
inline Parameter boundaryFarSideParameter()
{
    Parameter parameter;
    parameter.id = boundaryFarSideId;
    parameter.label = Message::marked("Back faces only");
    parameter.explanation = Message::marked(
        "Shows only the far walls of the boundary, seen from inside, and leaves out those that face the camera.");
    parameter.defaultValue = false;
    parameter.onlyWith = {boundaryId, {std::string(boundaryTranslucent), std::string(boundaryValues)}};
    return parameter;
}

/// bool, false by default: whether light changes the colours of its values.
inline Parameter boundaryLitParameter()
{
    Parameter parameter = litParameter();
    parameter.onlyWith = {boundaryId, {std::string(boundaryValues)}};
    return parameter;
}

/// The transfer function for a renderer that needs one for the boundary's values alone.
inline Parameter boundaryTransferParameter(const FieldExtent& field)
{
    Parameter parameter = transferParameter(field);
    parameter.onlyWith = {boundaryId, {std::string(boundaryValues)}};
    return parameter;
}

/// Adds the boundary of the cache's mesh to a scene, behind its other surfaces, if the values ask for one. Errors:
/// those of BoundaryCache.
inline Status addBoundary(BoundaryCache& cache, const RendererView& view, const Progress& progress, Scene& scene)
{
    const auto shown = view.value<std::string>(boundaryId);
    BoundaryLook look;
    look.backFacesOnly = view.value<bool>(boundaryFarSideId);
    if (shown == boundaryTranslucent)
        look.opacity = static_cast<float>(view.value<double>(boundaryOpacityId));
    if (shown == boundaryTranslucent || shown == boundaryValues) {
        auto surface = shown == boundaryValues
                           ? cache.coloured(view.value<TransferFunction>(transferId), look, progress)
                           : cache.plain(look, progress);
        if (!surface)
            return surface.error();
        if (shown == boundaryValues)
            surface->lit = view.value<bool>(litId);
        scene.drawables.push_back({.id = boundaryId, .label = "Boundary", .shape = *std::move(surface)});
    }
    progress.report(1, {});
    return {};
}

} // namespace tetra
