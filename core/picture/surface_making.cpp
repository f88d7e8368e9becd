// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/surface_making.h"

#include "core/base/guarded.h"
#include "core/base/text.h"

#include <tan/render.h>

#include <array>
#include <charconv>
#include <string>
#include <utility>

namespace tetra {
namespace {

constexpr MarkedText noMemory =
    Message::marked("Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh.");

/// A mesh, and what its surfaces of all isovalues have in common.
class SurfaceSource {
public:
    /// Errors: those of closingBasis().
    static Result<SurfaceSource> of(const TetrahedralMesh& mesh, const SurfaceMaking& making, const Progress& progress)
    {
        if (!making.solid)
            return SurfaceSource{mesh, making, vertexGradients(mesh), {}};
        auto basis = closingBasis(mesh, progress);
        if (!basis)
            return basis.error();
        return SurfaceSource{mesh, making, {}, *std::move(basis)};
    }

    Result<TriangleMesh> surface(double isovalue, const Progress& progress,
                                 Buffer<std::uint32_t>* cells = nullptr) const;

private:
    SurfaceSource(const TetrahedralMesh& mesh, const SurfaceMaking& making, Buffer<Eigen::Vector3f> gradients,
                  ClosingBasis basis)
        : mesh_(&mesh), making_(making), gradients_(std::move(gradients)), basis_(std::move(basis))
    {
    }

    const TetrahedralMesh* mesh_;
    SurfaceMaking making_;
    Buffer<Eigen::Vector3f> gradients_; ///< closed surfaces have no normals, so none then
    ClosingBasis basis_;                ///< of closed surfaces
};

Result<TriangleMesh> SurfaceSource::surface(double isovalue, const Progress& progress,
                                            Buffer<std::uint32_t>* cells) const
{
    auto surface = making_.solid ? closedIsosurface(*mesh_, basis_, isovalue, *making_.solid, progress)
                                 : extractIsosurface(*mesh_, gradients_, isovalue, progress, cells);
    if (surface && making_.largestPart)
        keepLargestPart(*surface, making_.solid ? SurfaceParts::Outer : SurfaceParts::All);
    return surface;
}

/// Part `index` of `count` equal ones.
Progress share(const Progress& progress, std::size_t index, std::size_t count)
{
    const double each = 1.0 / static_cast<double>(count);
    return progress.part(each * static_cast<double>(index), each * static_cast<double>(index + 1));
}

/// The same query for the finest mesh there is.
MeshQuery finestOf(MeshQuery query)
{
    query.error = 0.0;
    query.warping = 0.0;
    query.budget.reset();
    query.method = VariableMethod::Automatic;
    return query;
}

/// As many digits as tell something of a measured length.
std::string figureText(double number)
{
    constexpr int digits = 4;
    std::array<char, 32> text{}; // -1.235e-308 has 11 characters
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return {text.data(), end};
}

Result<MadeSurface> makeSurface(const SurfaceSource& source, double isovalue, const Progress& progress,
                                Buffer<std::uint32_t>* cells)
{
    constexpr double extracted = 0.8;
    Buffer<std::uint32_t> own;
    auto surface = source.surface(isovalue, progress.part(0, extracted), cells != nullptr ? &own : nullptr);
    if (!surface)
        return surface.error();
    MadeSurface made{isovalue, *std::move(surface)};
    if (cells != nullptr) {
        cells->insert(cells->end(), own.begin(), own.end());
        return made;
    }
    made.shape = shapeOf(made.mesh, progress.part(extracted, 1));
    if (progress.cancelled())
        return cancelledError(Message::say("Looking for openings"));
    return made;
}

Status measure(MeshExtractor& extractor, const MeshQuery& query, const SurfaceMaking& making,
               std::span<MadeSurface> surfaces, const Progress& progress)
{
    constexpr double extracted = 0.4, prepared = 0.5, made = 0.2, measuredOnce = 0.6;
    const auto finest = extractor.extract(finestOf(query), progress.part(0, extracted));
    if (!finest)
        return finest.error();
    const auto source = SurfaceSource::of((*finest)->mesh, making, progress.part(extracted, prepared));
    if (!source)
        return source.error();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Progress part = share(progress.part(prepared, 1), i, surfaces.size());
        MadeSurface& surface = surfaces[i];
        const auto reference = source->surface(surface.value, part.part(0, made));
        if (!reference)
            return reference.error();
        surface.hasNoCounterpart = surface.mesh.triangles.empty() != reference->triangles.empty();
        if (surface.mesh.triangles.empty() || reference->triangles.empty())
            continue;
        const auto to = surfaceDistance(*reference, surface.mesh, part.part(made, measuredOnce));
        if (!to)
            return to.error();
        const auto from = surfaceDistance(surface.mesh, *reference, part.part(measuredOnce, 1));
        if (!from)
            return from.error();
        surface.deviation = SurfaceDeviation{*to, *from};
    }
    return {};
}

} // namespace

Result<std::vector<MadeSurface>> makeSurfaces(const TetrahedralMesh& mesh, std::span<const double> isovalues,
                                              const SurfaceMaking& making, const Progress& progress,
                                              Buffer<std::uint32_t>* cells)
{
    return guarded(noMemory, [&]() -> Result<std::vector<MadeSurface>> {
        constexpr double prepared = 0.2;
        const auto source = SurfaceSource::of(mesh, making, progress.part(0, prepared));
        if (!source)
            return source.error();
        std::vector<MadeSurface> surfaces;
        for (std::size_t i = 0; i < isovalues.size(); ++i) {
            auto made =
                makeSurface(*source, isovalues[i], share(progress.part(prepared, 1), i, isovalues.size()), cells);
            if (!made)
                return made.error();
            surfaces.push_back(*std::move(made));
        }
        return surfaces;
    });
}

Status measureDeviations(MeshExtractor& extractor, const MeshQuery& query, const SurfaceMaking& making,
                         std::span<MadeSurface> surfaces, const Progress& progress)
{
    return guarded(noMemory, [&] { return measure(extractor, query, making, surfaces, progress); });
}

void addDeviation(std::span<const MadeSurface> surfaces, MeshFacts& facts)
{
    double largest = -1, mean = 0;
    for (const MadeSurface& surface : surfaces) {
        if (surface.hasNoCounterpart)
            return;
        if (surface.deviation) {
            largest = std::max(largest, surface.deviation->largest());
            mean = std::max(mean, surface.deviation->mean());
        }
    }
    if (largest < 0)
        return;
    facts.emplace_back("deviation", largest);
    facts.emplace_back("mean_deviation", mean);
}

Message missingDeviationText(const MadeSurface& surface)
{
    const std::string value = formatNumber(surface.value);
    return surface.mesh.triangles.empty()
               ? Message::say(
                     "The finest mesh has the surface of %1 and this mesh does not, so no deviation is stated.", value)
               : Message::say("The finest mesh does not have the surface of %1, so no deviation is stated.", value);
}

Message shapeText(const MadeSurface& surface, const std::string& lengthUnit)
{
    const SurfaceShape& shape = surface.shape;
    const auto measured = [&](double number, const char* power) {
        return figureText(number) + (lengthUnit.empty() ? "" : " " + visibleText(lengthUnit) + power);
    };
    const std::string value = formatNumber(surface.value), area = measured(shape.area, "²");
    if (surface.mesh.triangles.empty())
        return Message::say("Value %1: empty.", value);
    Message text = shape.isClosed() ? Message::say("Value %1: closed; parts: %2, area: %3, volume: %4.", value,
                                                   shape.parts, area, measured(shape.volume, "³"))
                                    : Message::say("Value %1: open; openings: %2 (edges: %3), parts: %4, area: %5.",
                                                   value, shape.openings, shape.openEdges, shape.parts, area);
    if (shape.crowdedEdges > 0)
        text = Message::say("%1 More than two triangles meet at some edges: %2.", text, shape.crowdedEdges);
    if (const auto& deviation = surface.deviation)
        text = Message::say("%1 Deviation from the finest mesh, measured at many places: largest %2 (mean %3), and of "
                            "that from this: largest %4 (mean %5).",
                            text, measured(deviation->toFinest.largest, ""), measured(deviation->toFinest.mean, ""),
                            measured(deviation->fromFinest.largest, ""), measured(deviation->fromFinest.mean, ""));
    return text;
}

} // namespace tetra
