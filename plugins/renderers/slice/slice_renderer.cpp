// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/api/slice_parameters.h"
#include "plugins/renderers/slice/plane_slice.h"

#include <tan/mesh.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {
using namespace tetra;

constexpr const char* axisId = "slice-axis";
constexpr const char* placeId = "slice-place";
constexpr const char* opacityId = "slice-opacity";
constexpr const char* surfacesId = "isosurfaces";
constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
constexpr const char* allAxes = Message::marked("all").text;
constexpr const char* opaqueSlices = Message::marked("opaque").text;
constexpr const char* opacityOfFunction = Message::marked("function").text;

Parameter axisParameter()
{
    Parameter parameter;
    parameter.id = axisId;
    parameter.label = Message::marked("Axis");
    parameter.explanation =
        Message::marked("The axis perpendicular to the plane; 'all' shows three planes, one for each axis.");
    parameter.defaultValue = std::string(allAxes);
    parameter.choices = {allAxes, axes[0], axes[1], axes[2]};
    parameter.onlyWith = {slicesId, {std::string()}};
    return parameter;
}

Parameter placeParameter()
{
    Parameter parameter;
    parameter.id = placeId;
    parameter.label = Message::marked("Place");
    parameter.explanation =
        Message::marked("Where the plane lies along its axis: 0 where the data begin, 100 where they end.");
    parameter.unit = Message::marked("%");
    parameter.defaultValue = 50.0;
    parameter.maximum = 100;
    parameter.onlyWith = {slicesId, {std::string()}};
    return parameter;
}

Parameter slicesParameter(const FieldExtent& field)
{
    Parameter parameter;
    parameter.id = slicesId;
    parameter.label = Message::marked("Planes");
    parameter.explanation =
        Message::marked("Planes instead of those perpendicular to the axes: each by its axis and its position in the "
                        "coordinates of the data, as in z=12.5, or in any direction: nx,ny,nz,offset, for the points "
                        "with nx x + ny y + nz z = offset.");
    parameter.defaultValue = std::string();
    parameter.separator = ';';
    parameter.mistake = [bounds = field.bounds](const std::string& text) {
        const auto slices = parseSlices(text, bounds);
        return slices ? Message() : slices.error().message;
    };
    return parameter;
}

Parameter opacityParameter()
{
    Parameter parameter;
    parameter.id = opacityId;
    parameter.label = Message::marked("Opacity of slices");
    parameter.explanation =
        Message::marked("Whether slices hide what is behind them ('opaque'), or each value is as opaque as the "
                        "transfer 'function' makes a layer of its unit of thickness.");
    parameter.defaultValue = std::string(opaqueSlices);
    parameter.choices = {opaqueSlices, opacityOfFunction};
    return parameter;
}

Parameter surfacesParameter()
{
    Parameter parameter;
    parameter.id = surfacesId;
    parameter.label = Message::marked("Isosurfaces");
    parameter.explanation = Message::marked("Shows the isosurfaces beside the slices.");
    parameter.defaultValue = false;
    return parameter;
}

Parameter isovaluesBesideSlices(const FieldExtent& field)
{
    Parameter parameter = isovaluesParameter(field);
    parameter.onlyWith = {surfacesId, {true}};
    return parameter;
}

/// Those that the values ask for; planes that miss the data are empty slices.
Result<std::vector<SlicePlane>> planesOf(const RendererView& view, const Eigen::AlignedBox3d& bounds)
{
    auto planes = parseSlices(view.value<std::string>(slicesId));
    if (!planes)
        return ofSetting(slicesId, planes.error());
    if (!planes->empty() || bounds.isEmpty())
        return planes;
    const auto wanted = view.value<std::string>(axisId);
    const double share = std::clamp(view.value<double>(placeId) / 100, 0.0, 1.0);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const std::string name = axes[static_cast<std::size_t>(axis)];
        const double place = std::lerp(bounds.min()[axis], bounds.max()[axis], share);
        if (wanted == name || wanted == allAxes)
            planes->push_back({{Eigen::Vector3d::Unit(axis), place}, name + "=" + formatNumber(place)});
    }
    return planes;
}

/// Of a layer of the function's unit distance.
double opacityAt(const TransferFunction& function, double value)
{
    return -std::expm1(-evaluate(function, value).extinction * function.unitDistance);
}

/// So many steps a slice has from transparent to opaque: half a step is no more than 1/255.
constexpr int opacitySteps = 128;

int stepAt(const TransferFunction& function, double value)
{
    return static_cast<int>(std::lround(opacityAt(function, value) * opacitySteps));
}

/// The values between `begin` and `end`, where the extinction goes in a straight line, at which the step changes.
void addStepChanges(const TransferFunction& function, double begin, double end, std::vector<double>& values)
{
    constexpr double inside = 1e-9; // the ends may be steps of the function
    const double extent = end - begin;
    const double first = evaluate(function, begin + inside * extent).extinction;
    const double last = evaluate(function, end - inside * extent).extinction;
    if (first == last)
        return;
    for (int step = 0; step < opacitySteps; ++step) {
        const double share =
            (extinctionOf((step + 0.5) / opacitySteps, function.unitDistance) - first) / (last - first);
        if (share > 0 && share < 1)
            values.push_back(begin + share * extent);
    }
}

/// The same colours, with further points so that between two neighbouring ones the step of opacity is the same.
TransferFunction cutAtSteps(const TransferFunction& function)
{
    std::vector<double> ends;
    for (const ColourPoint& point : function.colours)
        ends.push_back(point.value);
    for (const OpacityPoint& point : function.opacities)
        ends.push_back(point.value);
    if (function.mask)
        ends.insert(ends.end(), {function.mask->least, function.mask->largest});
    std::ranges::sort(ends);
    std::vector<double> values = ends;
    for (std::size_t i = 1; i < ends.size(); ++i)
        if (ends[i - 1] < ends[i])
            addStepChanges(function, ends[i - 1], ends[i], values);
    std::set<double> known;
    for (const ColourPoint& point : function.colours)
        known.insert(point.value);
    TransferFunction cut = function;
    for (const double value : values) {
        const std::array<double, 3> colour = evaluateUnmasked(function, value).colour;
        if (known.insert(value).second)
            cut.colours.push_back({value, {float(colour[0]), float(colour[1]), float(colour[2])}});
    }
    std::ranges::stable_sort(cut.colours, {}, &ColourPoint::value);
    return cut;
}

/// Some triangles of a surface, with the vertices that they have.
std::shared_ptr<const TriangleMesh> partOf(const TriangleMesh& whole,
                                           const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(whole.positions.size(), none);
    auto part = std::make_shared<TriangleMesh>();
    for (std::array<std::uint32_t, 3> triangle : triangles) {
        for (std::uint32_t& vertex : triangle) {
            std::uint32_t& number = numbers[vertex];
            if (number == none) {
                number = static_cast<std::uint32_t>(part->positions.size());
                part->positions.push_back(whole.positions[vertex]);
                part->normals.push_back(whole.normals[vertex]);
                part->values.push_back(whole.values[vertex]);
                if (!whole.colours.empty())
                    part->colours.push_back(whole.colours[vertex]);
            }
            vertex = number;
        }
        part->triangles.push_back(triangle);
    }
    return part;
}

/// What of a slice has one opacity.
struct SlicePiece {
    int step = opacitySteps; ///< its opacity
    Surface surface;
};

SlicePiece pieceOf(std::shared_ptr<const TriangleMesh> mesh, int step)
{
    const float opacity = static_cast<float>(step) / opacitySteps;
    return {step, {.mesh = std::move(mesh), .colour = {1, 1, 1}, .opacity = opacity, .lit = false}};
}

/// The whole cut, opaque.
std::vector<SlicePiece> opaquePiece(const TriangleMesh& cut, const TransferFunction& function)
{
    return {pieceOf(std::make_shared<const TriangleMesh>(colouredByValue(cut, function)), opacitySteps)};
}

/// What is seen of a cut whose values have the opacities of the function.
std::vector<SlicePiece> piecesByOpacity(const TriangleMesh& cut, const TransferFunction& function)
{
    const TriangleMesh coloured = colouredByValue(cut, cutAtSteps(function));
    std::map<int, std::vector<std::array<std::uint32_t, 3>>> steps;
    for (const auto& triangle : coloured.triangles) {
        double sum = 0;
        for (const std::uint32_t vertex : triangle)
            sum += static_cast<double>(coloured.values[vertex]);
        if (const int step = stepAt(function, sum / 3); step > 0)
            steps[step].push_back(triangle);
    }
    std::vector<SlicePiece> pieces;
    for (const auto& [step, triangles] : steps)
        pieces.push_back(pieceOf(partOf(coloured, triangles), step));
    return pieces;
}

/// One plane: its cut is made once, its pieces for each function.
class Slice {
public:
    Slice(HalfSpace plane, TriangleMesh cut) : plane_(std::move(plane)), cut_(std::move(cut)) {}

    const HalfSpace& plane() const { return plane_; }

    const std::vector<SlicePiece>& pieces(const TransferFunction& function, bool opaque)
    {
        if (!isMade_ || function_ != function || opaque_ != opaque)
            pieces_ = opaque ? opaquePiece(cut_, function) : piecesByOpacity(cut_, function);
        isMade_ = true;
        function_ = function;
        opaque_ = opaque;
        return pieces_;
    }

private:
    HalfSpace plane_;
    TriangleMesh cut_;
    bool isMade_ = false;
    TransferFunction function_; ///< of the pieces, like the next
    bool opaque_ = true;
    std::vector<SlicePiece> pieces_;
};

/// "slice-1", and of several pieces "slice-1-64", by their steps of opacity.
void addSlice(const std::vector<SlicePiece>& pieces, std::size_t number, const std::string& text, Scene& scene)
{
    for (const auto& [step, surface] : pieces) {
        Drawable drawable{.id = "slice-" + std::to_string(number), .label = "slice " + text};
        if (step < opacitySteps) {
            drawable.id += "-" + std::to_string(step);
            drawable.label += ", opacity " + formatNumber(surface.opacity);
        }
        drawable.shape = surface;
        drawable.saved = true;
        scene.drawables.push_back(std::move(drawable));
    }
}

/// Keeps the cuts of the planes that are seen: another function cuts nothing anew.
class SliceSession : public RendererSession {
public:
    explicit SliceSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), mesh_(meshes.mesh), surfaces_(meshes.mesh), boundary_(meshes.mesh)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        const auto function = view.value<TransferFunction>(transferId);
        if (const Status usable = checkTransferFunction(function); !usable)
            return usable.error();
        const auto planes = planesOf(view, bounds_);
        if (!planes)
            return planes.error();
        if (const Status kept = keepCuts(*planes, progress.part(0, 0.6)); !kept)
            return kept.error();
        if (view.value<bool>(surfacesId))
            if (const Status added = addIsosurfaces(surfaces_, view, progress.part(0.6, 0.8), *scene); !added)
                return added.error();
        const bool opaque = view.value<std::string>(opacityId) != opacityOfFunction;
        for (std::size_t i = 0; i < slices_.size(); ++i)
            addSlice(slices_[i]->pieces(function, opaque), i + 1, (*planes)[i].text, *scene);
        if (const Status added = addBoundary(boundary_, view, progress.part(0.8, 1), *scene); !added)
            return added.error();
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    /// One slice for each plane, in their order.
    Status keepCuts(const std::vector<SlicePlane>& planes, const Progress& progress)
    {
        std::vector<std::shared_ptr<Slice>> slices;
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const HalfSpace& plane = planes[i].plane;
            const auto known =
                std::ranges::find_if(slices_, [&](const auto& slice) { return slice->plane() == plane; });
            if (known != slices_.end()) {
                slices.push_back(*known);
                continue;
            }
            const auto count = static_cast<double>(planes.size());
            auto cut = planeSlice(*mesh_, plane, progress.part(double(i) / count, double(i + 1) / count));
            if (!cut)
                return cut.error();
            slices.push_back(std::make_shared<Slice>(plane, *std::move(cut)));
        }
        slices_ = std::move(slices);
        return {};
    }

    Eigen::AlignedBox3d bounds_;
    std::shared_ptr<const TetrahedralMesh> mesh_;
    IsosurfaceCache surfaces_;
    BoundaryCache boundary_;
    std::vector<std::shared_ptr<Slice>> slices_; ///< shared, so that none is copied when the list changes
};

} // namespace

/// The field on planes, in colours that stand for its values.
class SliceRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return {axisParameter(),
                placeParameter(),
                slicesParameter(field),
                opacityParameter(),
                transferParameter(field),
                surfacesParameter(),
                isovaluesBesideSlices(field),
                boundaryParameter(),
                boundaryOpacityParameter(),
                boundaryFarSideParameter(),
                boundaryLitParameter(),
                clipParameter(),
                outlineParameter()};
    }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<SliceSession>(meshes);
    }
};

TAN_PLUGIN(SliceRenderer, tetra::Renderer)
