// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace tetra {

/// The parameters that renderers share, so that what was chosen stays when another renderer takes over. A renderer
/// takes those that it can do; the shell knows the ids. Those of isovalues and transfer function: tan/parameter.h.
inline constexpr const char* shadedId = "shaded";
inline constexpr const char* fullGradientId = "full-gradient";
inline constexpr const char* litId = "lit";
inline constexpr const char* outlineId = "outline";
inline constexpr const char* clipId = "clip";
inline constexpr const char* shownId = "show";

/// std::vector<Isovalue>; by default where the field has a surface, or the middle of the range if that is not known.
inline Parameter isovaluesParameter(const FieldExtent& field)
{
    const ValueRange& range = field.range;
    const auto [red, green, blue] = materials.front().colour;
    Parameter parameter;
    parameter.id = isovaluesId;
    parameter.label = Message::marked("Isovalues");
    parameter.explanation = Message::marked("The values whose surfaces are shown, each with its colour and opacity.");
    const double value = field.surface.value_or(range.minimum + range.extent() / 2);
    parameter.defaultValue = std::vector{Isovalue{value, red, green, blue, 1, true}};
    parameter.minimum = range.minimum;
    parameter.maximum = range.maximum;
    return parameter;
}

/// The thickness of a layer that opacities are for by default: a fortieth of the diagonal, but of data that are flat or
/// thin so much less that the shortest side holds six of them. A picture of a slab has no more to look through than
/// that, however far its other sides reach.
inline double usualUnitDistance(const Eigen::AlignedBox3d& bounds)
{
    constexpr double inDiagonal = 40, inShortestSide = 6;
    if (bounds.isEmpty())
        return 1;
    const double ofDiagonal = bounds.diagonal().norm() / inDiagonal;
    const double ofShortest = bounds.sizes().minCoeff() / inShortestSide;
    const double distance = ofShortest > 0 ? std::min(ofDiagonal, ofShortest) : ofDiagonal;
    return distance > 0 ? distance : 1;
}

/// TransferFunction; by default one that fits the field, the better the more is known of it.
inline Parameter transferParameter(const FieldExtent& field)
{
    const double unitDistance = usualUnitDistance(field.bounds);
    Parameter parameter;
    parameter.id = transferId;
    parameter.label = Message::marked("Transfer function");
    parameter.explanation = Message::marked("The colour and the opacity of each value.");
    parameter.defaultValue = field.volumes.counts.empty()
                                 ? sequentialTransferFunction(field.range.minimum, field.range.maximum, unitDistance)
                                 : fittedTransferFunction(field.volumes, unitDistance, field.error);
    return parameter;
}

/// bool, by default true where light shows relief: of images with a background, as far as that is known. Other fields
/// have no surfaces that it could fall on. Where nothing was chosen, the ground behind the volume is dark.
inline Parameter shadedParameter(const FieldExtent& field = {})
{
    Parameter parameter;
    parameter.id = shadedId;
    parameter.label = Message::marked("Shaded");
    parameter.explanation = Message::marked(
        "Lights the volume as if a surface lay perpendicular to the direction in which its values change most; the "
        "background is then dark, unless you choose another one.");
    parameter.defaultValue =
        field.volumes.counts.empty() || (field.hasSamples && backgroundValues(field.volumes).has_value());
    return parameter;
}

/// double, 0 by default: Volume::fullGradient.
inline Parameter fullGradientParameter(const FieldExtent& field)
{
    constexpr double mostOfUsual = 20;
    Parameter parameter;
    parameter.id = fullGradientId;
    parameter.label = Message::marked("Full opacity at gradient");
    parameter.explanation = Message::marked(
        "Of a shaded volume, how steeply the values must change, in units of the values for one of length, to be as "
        "opaque as the transfer function says; where they change less, the opacity is less in proportion, so that "
        "boundaries stand out. 0: the opacity does not depend on it.");
    parameter.defaultValue = 0.0;
    parameter.maximum = mostOfUsual * field.range.extent() / usualUnitDistance(field.bounds);
    parameter.onlyWith = {shadedId, {true}};
    return parameter;
}

/// What shownParameter() can be.
inline constexpr const char* shownMesh = Message::marked("mesh").text;
inline constexpr const char* shownData = Message::marked("data").text;
inline constexpr const char* shownDifference = Message::marked("difference").text;

/// A choice, the mesh by default; for renderers of volumes, of a field that has samples. They show the mesh: whoever
/// draws the scene puts the samples in the place of its volume.
inline Parameter shownParameter()
{
    Parameter parameter;
    parameter.id = shownId;
    parameter.label = Message::marked("Source");
    parameter.explanation = Message::marked(
        "What the volume is drawn from: the mesh; the samples of the data themselves, so that you see "
        "what the mesh leaves out; or the difference between the two pictures, made brighter. A moving "
        "picture always shows the mesh, and so does one with a focus, a crop box, a filter of values or "
        "a range of accuracies.");
    parameter.defaultValue = std::string(shownMesh);
    parameter.choices = {shownMesh, shownData, shownDifference};
    return parameter;
}

/// With that, if there may be samples.
inline std::vector<Parameter> withShown(std::vector<Parameter> parameters, const FieldExtent& field)
{
    if (field.hasSamples)
        parameters.push_back(shownParameter());
    return parameters;
}

/// bool, false by default: for renderers whose surfaces have colours that stand for values.
inline Parameter litParameter()
{
    Parameter parameter;
    parameter.id = litId;
    parameter.label = Message::marked("Lit");
    parameter.explanation = Message::marked("Lights surfaces in the colours of values, so that their shape is easier "
                                            "to see; their colours then differ from those of the colour bar.");
    parameter.defaultValue = false;
    return parameter;
}

/// bool, true by default, but of data with an object that a picture frames in place of the box.
inline Parameter outlineParameter(const FieldExtent& field = {})
{
    Parameter parameter;
    parameter.id = outlineId;
    parameter.label = Message::marked("Bounding box");
    parameter.explanation = Message::marked("Draws the bounding box of the data.");
    parameter.defaultValue = field.object.empty();
    return parameter;
}

/// std::string, a list that parseClipPlanes() reads; none by default.
inline Parameter clipParameter()
{
    Parameter parameter;
    parameter.id = clipId;
    parameter.label = Message::marked("Clip planes");
    parameter.explanation =
        Message::marked("Clip planes as nx,ny,nz,offset; keeps the points with nx x + ny y + nz z >= offset.");
    parameter.defaultValue = std::string();
    parameter.separator = ';';
    parameter.mistake = [](const std::string& text) {
        const auto planes = parseClipPlanes(text);
        return planes ? Message() : planes.error().message;
    };
    return parameter;
}

/// What is known of the field where the parameters have to be guessed from its mesh.
inline FieldExtent extentOf(const TetrahedralMesh& mesh, const Eigen::AlignedBox3d& bounds)
{
    if (mesh.values.empty())
        return {{}, bounds, {}};
    const auto [smallest, largest] = std::ranges::minmax(mesh.values);
    return {{smallest, largest}, bounds, {}};
}

/// The error of a text that is a setting's value. Of several texts, as in a session, it says which one is wrong.
inline Error ofSetting(const char* id, const Error& error)
{
    return {error.kind, Message::say("The setting '%1' cannot be used: %2", id, error.message)};
}

/// A scene with nothing in it but the domain's outline and the clip planes, as the values of `outline` and `clip` say.
/// The error is that of a text that is no clip plane.
inline Result<Scene> startScene(const RendererView& view, const Eigen::AlignedBox3d& bounds)
{
    constexpr Colour outlineColour{0.45f, 0.45f, 0.45f};
    constexpr float outlineWidth = 1.5f;
    auto planes = parseClipPlanes(view.value<std::string>(clipId));
    if (!planes)
        return ofSetting(clipId, planes.error());
    Scene scene{.bounds = bounds, .clipPlanes = *std::move(planes)};
    if (view.value<bool>(outlineId))
        scene.drawables.push_back(
            {.id = outlineId, .label = "Bounding box", .shape = boxOutline(bounds, outlineColour, outlineWidth)});
    return scene;
}

/// Adds the surfaces that the value of `isovalues` asks for. Errors: those of IsosurfaceCache::update().
inline Status addIsosurfaces(IsosurfaceCache& cache, const RendererView& view, const Progress& progress, Scene& scene)
{
    auto surfaces = cache.drawables(view.value<std::vector<Isovalue>>(isovaluesId), progress);
    if (!surfaces)
        return surfaces.error();
    std::ranges::move(*surfaces, std::back_inserter(scene.drawables));
    return {};
}

} // namespace tetra
