// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/render.h: from a mesh to a picture. Surfaces and volumes of a mesh make a scene, a camera looks at it, a back
/// end draws it: on the CPU, which needs nothing but memory, or by OpenGL without a window. The result is a Picture in
/// memory; nothing here draws into a window of the caller.
///
/// ~~~{.cpp}
/// /// A picture of a field: an isosurface in a translucent volume.
/// tetra::Result<tetra::Picture> look(std::shared_ptr<const tetra::TetrahedralMesh> mesh, double isovalue,
///                                    const tetra::TransferFunction& function)
/// {
///     const auto surfaces = tetra::IsosurfaceCache(mesh).update(std::array{tetra::Isovalue{.value = isovalue}});
///     if (!surfaces)
///         return surfaces.error();
///     const auto volume = tetra::VolumeCache(mesh).update(function, false);
///     if (!volume)
///         return volume.error();
///     tetra::Scene scene;
///     scene.drawables.push_back({.id = "surface", .shape = surfaces->front(), .value = isovalue});
///     scene.drawables.push_back({.id = "volume", .shape = *volume});
///     for (const Eigen::Vector3d& position : mesh->positions)
///         scene.bounds.extend(position);
///     const tetra::Camera camera = tetra::fitted({.azimuth = 60, .elevation = 25}, scene.bounds);
///     return tetra::makeCpuBackend()->render(scene, camera, {.width = 320, .height = 320});
/// }
/// ~~~

#include <tan/base.h>
#include <tan/mesh.h>
#include <tan/transfer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

struct Dataset;
struct IsosurfaceIndex;
struct SampledField;
struct SampledTransfer;
struct SampleGradients;
struct VolumeMesh;
struct VolumeTransfer;

/// Which axis of the dataset points up, and which way.
enum class UpAxis { X, MinusX, Y, MinusY, Z, MinusZ };

/// A camera that looks at `target` from `distance` away. Angles in degrees, lengths in the units of the dataset. A
/// value: functions return changed copies.
struct Camera {
    Eigen::Vector3d target{0, 0, 0};
    double distance = 1;
    /// Around the up axis, counterclockwise seen from above. At 0 the camera looks
    ///     along +y if z or -z is up,
    ///     along -z if y or -y is up,
    ///     along +z if x or -x is up.
    double azimuth = 30;
    double elevation = 20; ///< above the plane across the up axis, kept within [-90, 90]
    double roll = 0;       ///< about the line of sight: positive angles turn the picture clockwise
    UpAxis up = UpAxis::Z;
    double fieldOfView = 30; ///< across the shorter side of the picture, in (0, 180)
    bool perspective = true; ///< else orthographic, showing the same part of the plane through the target
    /// How it is turned by hand: if true like a ball, in any direction, roll included; else like a turntable.
    bool trackball = false;
    bool operator==(const Camera&) const = default;
};

/// The camera that looks at the middle of `bounds` from the direction of `camera`, so that the box fills a picture of
/// this width / height but for a narrow margin. Fitted to 1 the box is seen whole in a picture of any shape.
TAN_API Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& bounds, double aspectRatio = 1);
/// The same for places: it looks at the middle of the box around them, and they are all seen.
TAN_API Camera fitted(const Camera& camera, std::span<const Eigen::Vector3d> places, double aspectRatio = 1);
/// The eye moved around the target by angles in degrees, counterclockwise seen from above; elevation stops at the
/// poles.
TAN_API Camera turned(const Camera& camera, double azimuth, double elevation);
/// What is seen turned clockwise about the line of sight, in degrees.
TAN_API Camera rolled(const Camera& camera, double degrees);
/// What is seen turned about the target: by a rotation in the eye's coordinates.
TAN_API Camera rotated(const Camera& camera, const Eigen::Matrix3d& rotation);
/// Another axis upright, seen from the same azimuth and elevation, the horizon level.
TAN_API Camera upright(const Camera& camera, UpAxis up);
/// The same axis, the other way.
TAN_API UpAxis opposite(UpAxis up);
/// Nearer (factor < 1) or farther (factor > 1).
TAN_API Camera zoomed(const Camera& camera, double factor);
/// The camera moved in the plane of the picture, by fractions of the picture's shorter side at the target.
TAN_API Camera panned(const Camera& camera, double right, double up);

TAN_API Eigen::Vector3d eyePosition(const Camera& camera);
/// How the eye is turned: the columns are its right, its up and its back, towards the viewer, in dataset coordinates.
TAN_API Eigen::Matrix3d eyeAxes(const Camera& camera);
/// The camera turned so, with its own up axis.
TAN_API Camera withEyeAxes(const Camera& camera, const Eigen::Matrix3d& axes);
/// From dataset coordinates to the eye's: x right, y up, z towards the viewer.
TAN_API Eigen::Matrix4d viewMatrix(const Camera& camera);
/// From the eye's coordinates to OpenGL's clip space, for a picture of this width / height; the near and far planes
/// enclose `bounds`; in perspective the near plane stays in front of the eye. Without bounds they enclose what lies as
/// near to the target as the eye.
TAN_API Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds);

/// A camera as a JSON text, and back to the same bits:
///
///     {
///       "azimuth": 30,
///       "elevation": 20,
///       "roll": 0,
///       "up": "z",
///       "fieldOfView": 30,
///       "perspective": true,
///       "trackball": false,
///       "target": [32, 32, 32],
///       "distance": 214.2
///     }
///
/// Angles in degrees, target and distance in the units of the dataset; what points up is x, -x, y, -y, z or -z. Each
/// key may be left out; roll, up and trackball are, where they are as usual, so that older programs can read the text.
TAN_API std::string cameraToText(const Camera& camera);

/// Keys that the text lacks have their defaults, and fit `bounds` into a picture of this width / height. The error says
/// what is wrong and in which line and column; a key that is not known is one.
TAN_API Result<Camera> cameraFromText(std::string_view text, const Eigen::AlignedBox3d& bounds, double aspectRatio = 1);

/// A finished picture: rows from top to bottom, 8-bit sRGB with straight (not premultiplied) alpha.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels;
    /// If wanted: for each pixel the distance from the eye along the view's axis, in the units of the dataset, at which
    /// half of the light from behind is absorbed; infinity where it never is.
    std::vector<float> depth{};
};

/// The colour of the index-th of several things to be told apart, also by people who do not see red or green as others
/// do: the palette of Okabe and Ito (Color Universal Design, 2008) without black, repeated after seven.
constexpr Colour distinctColour(std::size_t index)
{
    constexpr std::array<Colour, 7> okabeIto = {{
        {230 / 255.0f, 159 / 255.0f, 0 / 255.0f},   // orange
        {86 / 255.0f, 180 / 255.0f, 233 / 255.0f},  // sky blue
        {0 / 255.0f, 158 / 255.0f, 115 / 255.0f},   // bluish green
        {213 / 255.0f, 94 / 255.0f, 0 / 255.0f},    // vermilion
        {0 / 255.0f, 114 / 255.0f, 178 / 255.0f},   // blue
        {204 / 255.0f, 121 / 255.0f, 167 / 255.0f}, // reddish purple
        {240 / 255.0f, 228 / 255.0f, 66 / 255.0f},  // yellow
    }};
    return okabeIto[index % okabeIto.size()];
}

/// A colour of what things are made of: quiet enough that light shows the shape of a surface.
struct Material {
    const char* word; ///< one that a user types
    MarkedText name;
    Colour colour;
};

/// The first is that of a lone surface for which nobody has chosen a colour.
inline constexpr std::array<Material, 7> materials{{
    {"bone", Message::marked("Bone"), {232 / 255.0f, 220 / 255.0f, 196 / 255.0f}},
    {"skin", Message::marked("Skin"), {224 / 255.0f, 172 / 255.0f, 142 / 255.0f}},
    {"flesh", Message::marked("Flesh"), {190 / 255.0f, 92 / 255.0f, 80 / 255.0f}},
    {"steel", Message::marked("Steel"), {176 / 255.0f, 186 / 255.0f, 198 / 255.0f}},
    {"stone", Message::marked("Stone"), {150 / 255.0f, 142 / 255.0f, 132 / 255.0f}},
    {"water", Message::marked("Water"), {96 / 255.0f, 156 / 255.0f, 196 / 255.0f}},
    {"chalk", Message::marked("Chalk"), {245 / 255.0f, 245 / 255.0f, 242 / 255.0f}},
}};

/// The colour of the index-th of several surfaces for which nobody has chosen one: of bone, and then distinct ones.
constexpr Colour surfaceColour(std::size_t index)
{
    return index == 0 ? materials.front().colour : distinctColour(index);
}

/// What a thing that is shown in two resolutions has of a place: the weight of the finer one, or what is left of it.
struct FocusShare {
    std::vector<FocusRegion> regions; ///< OpenGL takes at most 16
    bool fine = false;                ///< this is the finer one
};

/// A surface, lit from both sides. Opacity in (0, 1]; below one it is blended in depth order (R19).
struct Surface {
    std::shared_ptr<const TriangleMesh> mesh;
    Colour colour;
    float opacity = 1;
    bool backFacesOnly = false; ///< triangles that the eye sees counterclockwise are not drawn
    /// If false, its colours are seen as they are. Where nothing is said, those of the mesh's vertices are, because
    /// they stand for values that light would falsify, and one colour all over is lit.
    std::optional<bool> lit{};
    /// If any: where the share of a place is w, the opacity is 1 - (1 - opacity)^w. So the surface of a finer mesh and
    /// that of the mesh outside let through together what one of them would (R24, S18). An opaque one counts as if it
    /// let 1/4096 through.
    std::shared_ptr<const FocusShare> share{};
};

/// Straight lines of one colour, hidden by what is before them. On a surface, draw them a pixel nearer to the eye.
struct LineSet {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::uint32_t, 2>> segments;
    Colour colour;
    float width = 1; ///< in pixels of the picture
};

/// Pieces of rays through the cells of a volume, as arrays of `count` numbers. In a piece the value of the field goes
/// in a straight line from `entry` to `exit`.
struct OpticalPieces {
    std::size_t count = 0;
    const float* entry = nullptr;    ///< in the units of the data
    const float* exit = nullptr;     ///< the same; farther from the eye
    const float* length = nullptr;   ///< in the units of the dataset; 0 for one that does not count
    const float* gradient = nullptr; ///< magnitude of the field's gradient, in values for a unit of length
    // To be set:
    float* red = nullptr; ///< light that the piece sends to the eye: colour times opacity, in [0, opacity]
    float* green = nullptr;
    float* blue = nullptr;
    float* transmittance = nullptr; ///< part of the light from behind that gets through, in [0, 1]: 1 - opacity
};

/// What becomes of the pieces of one ray.
enum class Combiner {
    Over,    ///< each is put over what lies behind
    Maximum, ///< the largest of each channel, and of the opacity
    Sum,     ///< of each channel, and of the opacity, up to 1
};

/// What the pieces of a volume add to a ray, for both back ends: as a call for many pieces at once, and as a text of
/// the shading language of OpenGL 3.3. The two must do the same. Pieces end at cells, opaque surfaces and clip planes;
/// those that are put over each other at translucent surfaces, too. Other combinations lie before all translucent
/// surfaces, and have no depth (PictureOptions::depth).
struct OpticalModel {
    Combiner combiner = Combiner::Over;
    /// Sets the light of all pieces. Called from several threads.
    std::function<void(const OpticalPieces& pieces)> evaluate;
    /// A function that gives red, green, blue (times opacity) and opacity of one piece:
    ///     vec4 lightOfPiece(float entry, float exit, float way, float gradient) { ... }
    /// What cannot be compiled is an error of render(), which names Scene::maker and has the compiler's text.
    std::string shader;
    /// Of Maximum and Sum, if set: what is seen of a ray whose pieces together have this opacity, above 0 and at most
    /// 1, in place of their light: red, green and blue times opacity, and opacity. So the opacities of pieces can stand
    /// for values, and that of the ray have the colour of one. Called from several threads.
    std::function<std::array<float, 4>(float opacity)> lightOfRay{};
    /// The same as a function in the shading language; needed if lightOfRay is set:
    ///     vec4 lightOfRay(float opacity) { ... }
    std::string rayShader{};
    /// What that text reads as rayDatum(0) and on, each a vec4; rayDataCount() are there, at most 65,536. A table that
    /// people edit belongs here, as each text is compiled anew, and the same one with other data is not.
    std::vector<std::array<float, 4>> rayData{};
};

/// The largest value along each ray, as opacity: 0 at `least`, 1 at `largest`; in one colour.
TAN_API std::shared_ptr<const OpticalModel> maximumIntensity(double least, double largest, const Colour& colour);
/// The sum of values along each ray, as opacity: a unit of length adds (value - least) / (largest - least), within
/// [0, 1], divided by `opaqueLength`.
TAN_API std::shared_ptr<const OpticalModel> xRay(double least, double largest, double opaqueLength,
                                                 const Colour& colour);

/// A field seen through its transfer function as a translucent cloud (R20), in core/render/volume/volume_mesh.h.
struct Volume {
    std::shared_ptr<const VolumeMesh> mesh;
    std::shared_ptr<const VolumeTransfer> transfer; ///< of that mesh
    /// Lit from both sides, as a surface across the gradient, which is interpolated between those of the vertices
    /// (docs/developer/tetrahedral-graphics.md).
    bool shaded = false;
    /// If it is shaded: the length of the gradient, in units of the values for one of length, from which on it is as
    /// opaque as the transfer function says; where the values change less, extinction is less in proportion. 0: it
    /// does not depend on the gradient.
    double fullGradient = 0;
    /// Where surfaces lie in it (R21) each ends one piece of a ray through a cell and begins the next; if this is set
    /// what lies in a cell is drawn before the cell, as in the paper: quicker, and not exact.
    bool wholeCells = false;
    /// How it is seen; none: by emission and absorption as the transfer function has them, lit if it is shaded. Cells
    /// all of whose values the transfer function makes transparent are left out by any model. Not in a blend of two.
    std::shared_ptr<const OpticalModel> model{};
};

/// Two volumes of one field blended into one: a finer one within regions, and another one outside (R24). Along each ray
/// their optical depths are blended with the weights w and 1 - w, so that no seam shows (S18); w is that of the
/// regions.
struct FocusVolume {
    Volume outside;                   ///< its `wholeCells` is that of both
    Volume fine;                      ///< fills all of the domain that is nearer to a region than its border
    std::vector<FocusRegion> regions; ///< OpenGL takes at most 16
};

/// The samples of a lattice seen through a transfer function, trilinear between the samples: the data that a Volume
/// shows within the error of its mesh. Rays are cast through them, so there is no order and nothing to be made but once
/// (SampledVolumeCache). OpenGL refuses them.
struct SampledVolume {
    std::shared_ptr<const SampledField> samples;        ///< core/render/samples/sampled_field.h, like the next two
    std::shared_ptr<const SampledTransfer> transfer;    ///< of those samples
    std::shared_ptr<const SampleGradients> gradients{}; ///< of the samples, if they are lit as a Volume is
    double fullGradient = 0;                            ///< as of a Volume
};

/// A half-space: points with normal . x >= offset are shown (of a HalfSpace it is the other side). OpenGL takes at
/// most 16.
struct ClipPlane {
    Eigen::Vector3d normal{1, 0, 0};
    double offset = 0;
};

struct Drawable;

/// What depends on the camera and the size of the picture: arrows that turn towards the eye, labels of one size, a
/// frame around the picture. `draw` gives the drawables of a picture of `width` x `height` pixels: surfaces and lines;
/// other shapes are left out. Called by the back ends before each picture, in their thread; quick. A mesh that is
/// handed out again is not sent to the graphics card again. Picking does not see it.
/// - Ids: what `draw` gives is called "id of this one/its own id", so its own need only differ from each other.
/// - Overlays: all of it is drawn over the scene if this one's Drawable::overlay is set, else what has it set itself;
///   it stands in the list where this one stands, in the order in which `draw` gives it.
/// - Throwing: ends the picture, not the program. RenderBackend::render() gives an error with what() of the exception;
///   the next picture calls `draw` again.
/// - Drawable::saved means nothing here, for this one as for what it gives: what depends on the camera is no part of
///   the data's surfaces. What belongs into their file is a drawable of the scene itself.
struct CustomDrawable {
    std::function<std::vector<Drawable>(const Camera& camera, int width, int height)> draw;
};

/// What can be drawn.
using Shape = std::variant<Surface, LineSet, Volume, FocusVolume, SampledVolume, std::shared_ptr<const CustomDrawable>>;

/// A thing in a scene.
struct Drawable {
    /// Its name in the scene, which no other drawable has; the same thing has it in the next scene, too.
    std::string id{};
    /// What it is called in the file where the surfaces of a scene are saved: "isovalue 0.3". Not translated, and not
    /// shown in the window: a scene makes the same file whatever the user's language.
    std::string label{};
    Shape shape{};
    /// The value that its field has all over it, as of an isosurface. None: of a surface `mesh->values` tell, if it has
    /// any; of a volume its field.
    std::optional<double> value{};
    /// Surfaces and lines: drawn over everything that is no overlay, later ones over earlier ones, opaque, and not cut
    /// by clip planes. What lies before the eye's near plane is still cut off. There is no depth there
    /// (Picture::depth).
    bool overlay = false;
    bool saved = false; ///< a surface that belongs into the file where the surfaces of a scene are saved, by its label
};

/// A difference of 1 of 255 is as bright as this many of 255 in the picture of a difference.
inline constexpr int differenceBrightness = 8;

/// What a renderer makes and a back end draws: an immutable value, shared between threads as shared_ptr<const Scene>.
/// Surfaces and volumes are sorted as exactly as light needs it, whatever their places in the list; opaque surfaces and
/// lines hide what lies behind. There may be one volume, one blend of two, or the samples of one: cells of two meshes
/// that lie in the same place have no order, so two volumes are only drawn together where a weight says how they share
/// each ray.
struct Scene {
    Eigen::AlignedBox3d bounds{};        ///< of the domain; depth is scaled by it, and what lies outside may be cut off
    std::vector<ClipPlane> clipPlanes{}; ///< cut surfaces and volumes, not lines
    std::vector<Drawable> drawables{};
    /// If set, the picture is the difference to the picture of that scene, which has none itself: for each channel
    /// differenceBrightness times as much as the two differ, on black. The CPU back end draws it.
    std::shared_ptr<const Scene> reference{};
    /// Whose shaders and functions are in it, as errors call that: the id of a renderer's plugin, set by its host.
    std::string maker{};
};

/// The shapes of one kind in a scene, in their order; they live as long as the scene.
template <class Kind> std::vector<const Kind*> shapesOf(const Scene& scene)
{
    std::vector<const Kind*> shapes;
    for (const Drawable& drawable : scene.drawables)
        if (const Kind* shape = std::get_if<Kind>(&drawable.shape))
            shapes.push_back(shape);
    return shapes;
}

/// The drawable of this name; null if there is none.
TAN_API const Drawable* drawableOf(const Scene& scene, std::string_view id);

/// The twelve edges of a box, as the outline of a domain.
TAN_API LineSet boxOutline(const Eigen::AlignedBox3d& box, const Colour& colour, float width = 1);

/// Clip planes as text, "nx,ny,nz,offset" each, separated by ';': where nx x + ny y + nz z >= offset is shown. No text
/// is no plane. A normal of an unusual size, beyond 2^40 or below 2^-40, comes scaled with its offset. Errors
/// (WrongUsage): four finite numbers each, the first three of them not all zero, for a plane at a finite distance; the
/// text says which plane is wrong.
TAN_API Result<std::vector<ClipPlane>> parseClipPlanes(std::string_view text);

/// The text that parseClipPlanes() reads as these planes.
TAN_API std::string clipPlanesText(std::span<const ClipPlane> planes);

/// One isosurface to show (R19).
struct Isovalue {
    double value = 0;                            ///< in units of the data
    float red = 0.9f, green = 0.6f, blue = 0.2f; ///< sRGB, [0, 1]
    float opacity = 1;                           ///< (0, 1]
    bool visible = true;
    bool operator==(const Isovalue&) const = default;
};

/// The field's gradient at each vertex: the mean of the gradients of its tetrahedra, weighted by volume, but for those
/// with a corner that is not finite; zero at a vertex without others. O(tetrahedra), on all threads, the same result
/// with any number of them. May throw std::bad_alloc.
TAN_API Buffer<Eigen::Vector3f> vertexGradients(const TetrahedralMesh& mesh);

/// Marching tetrahedra (R19): the isosurface of the piecewise-linear field, a vertex for each crossed edge, shared by
/// its triangles. A vertex is inside if its value >= isovalue (S16), so the surface is closed but for the domain's
/// boundary, on any data. Edges that all cross in one mesh vertex (its value is the isovalue) share one vertex there,
/// and triangles that lose a corner by that are left out, so no crack opens. Where the inside touches itself along an
/// edge of the mesh, four triangles meet. Triangles wind so that their front looks towards smaller values; normals come
/// from `gradients` (vertexGradients of the same mesh) and look the same way; where the gradient vanishes, from the
/// triangles. `cells`, if given, gets the tetrahedron that each triangle lies in, ascending: so triangles are chosen by
/// what is known of their tetrahedra (R17). O(vertices + tetrahedra), on all threads, the same result with any number
/// of them. Errors: cancelled, not enough memory, arguments that do not belong together.
TAN_API Result<TriangleMesh> extractIsosurface(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients,
                                               double isovalue, const Progress& progress = {},
                                               Buffer<std::uint32_t>* cells = nullptr);

/// A point of an edge of a mesh, from + share (to - from): so whatever is known at each vertex is interpolated there.
struct EdgePoint {
    std::uint32_t from = 0; ///< the edge's ends, numbers of the mesh's vertices
    std::uint32_t to = 0;
    double share = 0; ///< in [0, 1]
};

/// A plane cut through a mesh.
struct MeshCut {
    TriangleMesh surface;     ///< with the field's values
    Buffer<EdgePoint> points; ///< where each of its vertices lies in the mesh, to interpolate more than the values
};

/// Cuts a mesh by the plane that ends a half-space: marching tetrahedra over the distances from it, as
/// extractIsosurface() does, so vertices are shared and no crack opens. Each vertex lies in the plane but for the
/// rounding of its depth to a float, a part of its distance. Triangles wind, and normals look, out of the half-space.
/// Where the plane lies in faces of the mesh, these are in the cut if there is a tetrahedron outside of the half-space
/// behind them. Besides the result 16 bytes a vertex while it runs. O(vertices + tetrahedra), on all threads, the same
/// result with any number of them. Errors: cancelled, not enough memory, a normal that is zero or a number that is not
/// finite, arrays that do not belong together.
TAN_API Result<MeshCut> cutByPlane(const TetrahedralMesh& mesh, const HalfSpace& plane, const Progress& progress = {});

/// The isosurfaces of one mesh for a list of isovalues that changes. Keeps the gradients of its mesh, and the surface
/// of each isovalue for as long as the value is in the list: to change a colour, an opacity or the visibility extracts
/// nothing. From its second extraction on it takes the mesh in spatial order with an index, which are not worth their
/// time for one alone, or from the first if the mesh is in that order already. Used from one thread at a time.
class TAN_API IsosurfaceCache {
public:
    explicit IsosurfaceCache(std::shared_ptr<OrderedMesh> mesh);
    explicit IsosurfaceCache(std::shared_ptr<const TetrahedralMesh> mesh);

    /// The surfaces of the isovalues that are seen, in their order. Extracts what is missing, all at once on all
    /// threads. What was finished before a cancellation or an error is kept. Errors: an isovalue that is no number or
    /// has an opacity outside 0 to 1, cancelled, not enough memory.
    Result<std::vector<Surface>> update(std::span<const Isovalue> isovalues, const Progress& progress = {});
    /// The same as parts of a scene, each with its value and to be saved: "isosurface-1", "isosurface-2" ... by their
    /// places in the whole list.
    Result<std::vector<Drawable>> drawables(std::span<const Isovalue> isovalues, const Progress& progress = {});

private:
    Status extractMissing(std::span<const Isovalue> isovalues, const Progress& progress);

    Status chooseMesh(const Progress& progress);
    Result<TriangleMesh> extract(double isovalue, const Progress& progress) const;

    std::shared_ptr<OrderedMesh> mesh_;
    std::shared_ptr<const TetrahedralMesh> chosen_;                  ///< of the two in mesh_
    Buffer<Eigen::Vector3f> gradients_;                              ///< of the chosen one
    std::shared_ptr<const IsosurfaceIndex> index_;                   ///< of the ordered one, if that is chosen
    std::map<double, std::shared_ptr<const TriangleMesh>> surfaces_; ///< by isovalue
};

/// Edges of the boundary that turn by more than this many degrees are drawn sharp, others smooth.
inline constexpr double usualFeatureAngle = 30;

/// The boundary of a mesh as a surface: its boundaryFaces(), cavities and all components included, counterclockwise
/// seen from outside, with the values of the field. Normals look outwards and are smooth where neighbouring triangles
/// turn by at most `featureAngle` degrees, 0 for flat ones: means of the triangles' normals, weighted by their angles
/// (G. Thürmer and C. Wüthrich, "Computing vertex normals from polygonal facets", 1998). At a sharper edge, and where
/// other than two triangles meet, a vertex comes once for each side. O(vertices + tetrahedra + boundary log boundary),
/// the same result with any number of threads. Errors: cancelled, too many tetrahedra, not enough memory.
TAN_API Result<TriangleMesh> extractBoundary(const TetrahedralMesh& mesh, double featureAngle = usualFeatureAngle,
                                             const Progress& progress = {});

/// The surface with the colours that a transfer function gives its values, whatever their opacity; the surface must
/// have values. Between two points of the function, colours are linear in the value, and so they are on a triangle:
/// each triangle is cut where its value is that of a point (R22), so that the colours are exact at any place, steps
/// included, however large the triangles are. Triangles that share an edge are cut at the same places, bit for bit. A
/// function without points, and a surface without values, leave the surface as it is. O(triangles + pieces). May throw
/// std::bad_alloc.
TAN_API TriangleMesh colouredByValue(const TriangleMesh& surface, const TransferFunction& function);

/// What the boundary of a mesh looks like.
struct BoundaryLook {
    Colour colour{0.60f, 0.64f, 0.70f}; ///< nearly grey, so that it is no value's colour, and seen on light and dark
    float opacity = 1;                  ///< in (0, 1]
    bool backFacesOnly = false;         ///< what faces the eye is left out, so that one sees into the domain
};

/// Makes the boundary of one mesh, in a look that changes: extracted once, coloured anew for another transfer function.
/// Used from one thread at a time.
class TAN_API BoundaryCache {
public:
    explicit BoundaryCache(std::shared_ptr<const TetrahedralMesh> mesh) : mesh_(std::move(mesh)) {}

    /// Errors: those of extractBoundary(), an opacity outside (0, 1].
    Result<Surface> plain(const BoundaryLook& look, const Progress& progress = {});
    /// In the colours of the field's values (colouredByValue()), which no light changes. Errors: the same, and those of
    /// checkTransferFunction().
    Result<Surface> coloured(const TransferFunction& function, const BoundaryLook& look, const Progress& progress = {});

private:
    std::shared_ptr<const TetrahedralMesh> mesh_;
    std::shared_ptr<const TriangleMesh> boundary_;
    TransferFunction function_; ///< that `coloured_` has its colours from
    std::shared_ptr<const TriangleMesh> coloured_;
};

/// Makes volumes of one mesh for a transfer function that changes: the mesh is put in spatial order and made ready
/// once, the function when it is another one. Used from one thread at a time.
class TAN_API VolumeCache {
public:
    explicit VolumeCache(std::shared_ptr<OrderedMesh> mesh);
    explicit VolumeCache(std::shared_ptr<const TetrahedralMesh> mesh);

    /// Errors: those of inSpatialOrder() and checkTransferFunction(); a mesh with more than a thousand million
    /// tetrahedra or a function with too many pieces (OutOfResource); cancelled.
    Result<Volume> update(const TransferFunction& function, bool shaded, const Progress& progress = {});

private:
    Status makeMesh(const Progress& progress);
    Status makeTransfer(const TransferFunction& function);

    std::shared_ptr<OrderedMesh> tetrahedra_;
    std::shared_ptr<const VolumeMesh> mesh_;
    TransferFunction function_; ///< that `transfer_` was made from
    std::shared_ptr<const VolumeTransfer> transfer_;
};

/// Makes volumes of the samples of one lattice for a transfer function that changes. Keeps the dataset; used from one
/// thread at a time.
class TAN_API SampledVolumeCache {
public:
    explicit SampledVolumeCache(std::shared_ptr<const Dataset> dataset) : dataset_(std::move(dataset)) {}

    /// O(samples) for the first, and once more for the first that is shaded, on all threads; else as quick as the
    /// function has points. Takes a byte for 8 samples, 8 bytes a sample for light, and 4 for values of more than 16
    /// bits, of which single precision is used, as in meshes. Errors: those of checkTransferFunction(); a dataset that
    /// is no lattice, or has holes or values that are not finite (WrongUsage); not enough memory; cancelled.
    Result<SampledVolume> update(const TransferFunction& function, bool shaded, const Progress& progress = {});
    /// The same for the segments of a function (transferSegments()).
    Result<SampledVolume> update(std::span<const TransferSegment> segments, bool shaded, const Progress& progress = {});

private:
    std::shared_ptr<const Dataset> dataset_;
    std::shared_ptr<const SampledField> samples_;
    std::shared_ptr<const SampleGradients> gradients_;
    std::shared_ptr<const SampledTransfer> transfer_; ///< the last one
};

/// A value within [least, largest] whose isosurface is likely to be a real boundary of materials, as the skin of a head
/// or the walls of a casting, rather than noise. Of all isosurfaces it is the one for which a product of two functions
/// of the contour spectrum is largest: the total gradient on it, which grows with its size, and a power of the mean
/// gradient, which tells a boundary between two materials from noise within one; a surface that is too small to be seen
/// beside the whole mesh counts less. (C. Bajaj, V. Pascucci, D. Schikore: The contour spectrum, IEEE Visualization
/// 1997.) Nothing for a constant field. The same for the same mesh on every machine and any number of threads, but for
/// rounding. O(cells).
TAN_API std::optional<double> surfaceValue(const TetrahedralMesh& mesh, double least, double largest);

/// How the values of a mesh share its volume, whatever the sizes of its cells: the counts are parts
/// of 2^32 of the volume. In a cell all values between its smallest and its largest count alike. Cells that are not
/// finite and values outside of [least, largest] are not counted. No counts if the range is empty or not finite, or
/// there is no volume. O(cells + parts).
TAN_API ValueHistogram volumeHistogram(const TetrahedralMesh& mesh, double least, double largest, int parts);

/// The places of an object in a background that are farthest out, to frame it in a picture (fitted()). The object are
/// those vertices whose values are more than a thirtieth of the range beside the background (backgroundValues()) and
/// have a tenth of the largest extinction in the function that volumes have at first (fittedTransferFunction()),
/// and those on the other side of `surface` than the background; of them, the farthest in each of 128 directions all
/// around. Nothing if there is no background, and if the mesh is to be framed as the object is nearly as large, or tiny
/// in it: above nine tenths of its diagonal, or below a sixteenth. `volumes`: of the same mesh (volumeHistogram()).
/// O(vertices).
TAN_API std::vector<Eigen::Vector3d> objectOutline(const TetrahedralMesh& mesh, const ValueHistogram& volumes,
                                                   std::optional<double> surface = {});

/// Pixels of a picture: `width` columns from `left`, `height` rows from `top`, which count from its upper left corner.
struct PixelRectangle {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
    bool operator==(const PixelRectangle&) const = default;
};

struct PictureOptions {
    int width = 1024;
    int height = 768;
    /// Draw only this part: render() gives a picture of its size with the pixels that the whole one has there. So a
    /// region can be magnified, as a part of a larger picture (5.1), and a picture made piece by piece.
    std::optional<PixelRectangle> part{};
    Colour background{1, 1, 1};
    bool transparentBackground = false;
    int samplesPerAxis = 2; ///< a pixel is the mean of this many squared samples: 1 (fast, no antialiasing) to 4
    int threads = 0;        ///< of the CPU back end; 0 or too many means all of the machine
    bool depth = false;     ///< make Picture::depth, too
    /// In degrees: the visibility order of an earlier picture may be used again if the camera differs by no more than
    /// this. 0 for exact pictures; a few degrees while the camera moves.
    double orderTolerance = 0;
};

/// What the last picture took.
struct RenderStatistics {
    std::size_t cells = 0;     ///< tetrahedra of the volume that were drawn, counted once a tile by the CPU back end
    std::size_t fragments = 0; ///< samples of the picture times the cells drawn there, as far as they are counted
    /// Tetrahedra that were cut, because they hide each other in a circle and so have no order as a whole (S14).
    std::size_t cutCells = 0;
    std::size_t brokenCycles = 0; ///< circles left as they are, because their tetrahedra overlap
    bool orderReused = false;
    double orderSeconds = 0;
    double setUpSeconds = 0; ///< projecting, binning
    double fillSeconds = 0;
    int largestDifference = 0; ///< of a channel of a pixel to the scene's reference, of 255
    double meanDifference = 0; ///< over all pixels of the largest of their channels
    std::size_t sentBytes = 0; ///< of cells and their order, to the graphics card; without the mesh, sent once
};

/// Turns a scene into a picture (B4). The CPU back end is the reference; the OpenGL one draws the same within 2/255.
/// One object is used from one thread at a time; it caches what the next picture of the same scene can use.
class TAN_API RenderBackend {
public:
    virtual ~RenderBackend() = default;
    virtual std::string_view id() const noexcept = 0; ///< "cpu" or "gl"
    /// The scene as the camera sees it. What was prepared for a surface or a volume is used again as long as the scene
    /// holds the same objects (the shared meshes and transfer functions, told apart by address), so share them between
    /// scenes. O(triangles + cells + samples of the picture), a volume's cells in order of visibility besides. Errors
    /// (WrongUsage): arrays of the scene that do not belong together, a picture without pixels or too large, a part
    /// that is not in it, samples or threads out of their range; OutOfResource: memory, of the graphics card, too;
    /// cancelled.
    virtual Result<Picture> render(const Scene& scene, const Camera& camera, const PictureOptions& options,
                                   const Progress& progress = {}) = 0;
    /// Of the last picture that was finished.
    virtual RenderStatistics statistics() const = 0;
};

/// Needs nothing but memory.
TAN_API std::unique_ptr<RenderBackend> makeCpuBackend();
/// OpenGL 3.3 or newer without a window, by EGL; the error says what is missing on this machine.
TAN_API Result<std::unique_ptr<RenderBackend>> makeGlBackend();

} // namespace tetra
