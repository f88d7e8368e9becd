// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/result.h"
#include "core/geometry/region.h"
#include "core/render/picture.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetra {

struct VolumeMesh;
struct VolumeTransfer;

/// Triangles with shared vertices and a unit normal at each; colours and values are linear between vertices.
struct TriangleMesh {
    Buffer<Eigen::Vector3f> positions;
    Buffer<Eigen::Vector3f> normals;
    Buffer<std::array<std::uint32_t, 3>> triangles;
    Buffer<float> values{};   ///< of the field at each vertex; none where that is not told
    Buffer<Colour> colours{}; ///< of each vertex; none where the surface's colour holds
};

/// A surface, lit from both sides. Opacity in (0, 1]; below one it is blended in depth order (R19).
struct Surface {
    std::shared_ptr<const TriangleMesh> mesh;
    Colour colour;
    float opacity = 1;
    bool backFacesOnly = false; ///< triangles that the eye sees counterclockwise are not drawn
};

/// Straight lines of one colour, hidden by what lies before them.
struct LineSet {
    std::vector<Eigen::Vector3f> points;
    std::vector<std::array<std::uint32_t, 2>> segments;
    Colour colour;
    float width = 1; ///< in pixels of the picture
};

/// A field seen through its transfer function as a translucent cloud (R20), in core/render/volume/volume_mesh.h.
struct Volume {
    std::shared_ptr<const VolumeMesh> mesh;
    std::shared_ptr<const VolumeTransfer> transfer; ///< of that mesh
    bool shaded = false;                            ///< lit from both sides, as a surface across the gradient would be
};

/// A part of a volume that is drawn from a finer mesh (R24). Along each ray the optical depth of the fine volume counts
/// by its weight, and that of the other by the rest to one, so that no band shows (S18). The weight is 1 in the region
/// and falls with the distance from it, to 0 at `border`.
struct FocusVolume {
    Volume fine; ///< fills all that is nearer to the region than `border`, as far as the domain does
    std::variant<Box, Sphere> region;
    double border = 0; ///< in the units of the dataset; 0 is a sharp one
};

/// How a volume is drawn where surfaces lie in it (R21).
enum class HybridOrder {
    Exact,    ///< a surface ends one piece of a ray through a cell and begins the next
    WithCell, ///< as in the paper: what lies in a cell is drawn before the cell
};

/// A half-space: points with normal . x >= offset are shown.
struct ClipPlane {
    Eigen::Vector3d normal{1, 0, 0};
    double offset = 0;
};

/// What a renderer makes and a back end draws: an immutable value, shared between threads as shared_ptr<const Scene>.
struct Scene {
    std::vector<Surface> surfaces;
    std::vector<LineSet> lines;
    Eigen::AlignedBox3d bounds; ///< of the domain; depth is scaled by it, and what lies outside may be cut off
    std::optional<Volume> volume{};
    std::optional<FocusVolume> focus{}; ///< of the volume, which it must have then
    HybridOrder hybridOrder = HybridOrder::Exact;
    std::vector<ClipPlane> clipPlanes{}; ///< cut surfaces and the volume, not lines
};

/// The twelve edges of a box, as the outline of a domain.
LineSet boxOutline(const Eigen::AlignedBox3d& box, const Colour& colour, float width = 1);

/// Clip planes as text, "nx,ny,nz,offset" each, separated by ';': where nx x + ny y + nz z >= offset is shown. No text
/// is no plane. Errors (WrongUsage): four finite numbers each, the first three of them not all zero; the text says
/// which plane is wrong.
Result<std::vector<ClipPlane>> parseClipPlanes(std::string_view text);

/// The text that parseClipPlanes() reads as these planes.
std::string clipPlanesText(std::span<const ClipPlane> planes);

/// The light on a surface, the same in both back ends: a headlight in the eye, equal on both sides. With c the cosine
/// between the normal and the direction to the eye, a colour channel becomes
///     min(1, channel * (ambient + diffuse * |c|) + specular * |c|^32).
/// Lighting and blending act on the sRGB-coded channels, not on linear light, as VTK and ParaView do: a colour map
/// looks here as it does there.
struct Shading {
    static constexpr float ambient = 0.25f;
    static constexpr float diffuse = 0.75f;
    static constexpr float specular = 0.15f;
};

/// The colour of a lit surface, from the absolute cosine and its square, which the caller has anyway.
inline Colour shaded(const Colour& colour, float cosine, float squaredCosine)
{
    const float power4 = squaredCosine * squaredCosine;
    const float power8 = power4 * power4;
    const float power16 = power8 * power8;
    const float specular = Shading::specular * power16 * power16;
    const float factor = Shading::ambient + Shading::diffuse * cosine;
    return {std::min(1.0f, colour.red * factor + specular), std::min(1.0f, colour.green * factor + specular),
            std::min(1.0f, colour.blue * factor + specular)};
}

} // namespace tetra
