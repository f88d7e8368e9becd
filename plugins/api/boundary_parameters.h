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
    parameter.explanation =
        Message::marked("Shows where the mesh ends, holes and cavities included: 'translucent' in one light colour, "
                        "so that one sees what is inside within its walls, or in the colours that the transfer "
                        "function gives the 'values' there.");
    parameter.defaultValue = std::string(boundaryOff);
    parameter.choices = {boundaryOff, boundaryTranslucent, boundaryValues};
    return parameter;
}

/// double in (0, 1].
inline Parameter boundaryOpacityParameter()
{
    Parameter parameter;
    parameter.id = boundaryOpacityId;
    parameter.label = Message::marked("Opacity");
    parameter.explanation = Message::marked("The opacity of a translucent boundary; 1 hides what lies behind.");
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
        "Shows only the far walls of the boundary, seen from within, and leaves out those that face the camera.");
    parameter.defaultValue = false;
    parameter.onlyWith = {boundaryId, {std::string(boundaryTranslucent), std::string(boundaryValues)}};
    return parameter;
}

/// The transfer function for a renderer that needs one for the boundary's values alone.
inline Parameter boundaryTransferParameter(const FieldExtent& field)
{
    Parameter parameter = transferParameter(field);
    parameter.onlyWith = {boundaryId, {std::string(boundaryValues)}};
    return parameter;
}

/// Adds the boundary of the maker's mesh to a scene, behind its other surfaces, if the values ask for one. The
/// parameters are those of the renderer. Errors: those of BoundaryCache.
inline Status addBoundary(BoundaryCache& maker, const std::vector<Parameter>& parameters, const ParameterValues& values,
                          const Progress& progress, Scene& scene)
{
    const auto shown = parameterValue<std::string>(parameters, values, boundaryId);
    BoundaryLook look;
    look.backFacesOnly = parameterValue<bool>(parameters, values, boundaryFarSideId);
    if (shown == boundaryTranslucent)
        look.opacity = static_cast<float>(parameterValue<double>(parameters, values, boundaryOpacityId));
    else if (shown != boundaryValues) {
        progress.report(1, {});
        return {};
    }
    const auto surface =
        shown == boundaryValues
            ? maker.coloured(parameterValue<TransferFunction>(parameters, values, transferId), look, progress)
            : maker.plain(look, progress);
    if (!surface)
        return surface.error();
    scene.surfaces.push_back(*surface);
    progress.report(1, {});
    return {};
}

} // namespace tetra
