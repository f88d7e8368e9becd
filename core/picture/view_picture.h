// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_content.h"
#include "core/picture/drawing/canvas.h"
#include "core/picture/drawing/rectangle.h"
#include "core/picture/picture_order.h"
#include "core/picture/scene_pipeline.h"
#include "plugins/api/renderer.h"
#include "plugins/api/tool.h"
#include "plugins/host/plugin_host.h"

#include <tan/model.h>
#include <tan/view.h>

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace tetra {

// The way from how a model is seen to a picture of that: the window's and the command line's, so that both draw the
// same.

/// What is known of a model before there is a mesh of it: its range and its box.
FieldExtent roughExtentOf(const Model& model);
/// What defaults follow from: the model's range and box, and by a coarse mesh of it how the values share the volume, so
/// that transfer functions to begin with show what is rare, and where the data have a surface. The same for window and
/// command line. Takes some milliseconds, or asks a server: not for the GUI thread. Errors: those of a mesh.
Result<FieldExtent> extentOf(const std::shared_ptr<const Model>& model, const Progress& progress = {});
/// For who shows a model as well as it goes: without a mesh, its range and its box.
FieldExtent knownExtentOf(const std::shared_ptr<const Model>& model, const Progress& progress = {});

/// The transfer function that a model has in this query's mesh as long as nobody has chosen one: it paints nothing into
/// the background that the error of the mesh has made. The same for window and command line.
TransferFunction usualTransfer(const std::vector<Provided<Renderer>>& modes, const Model& model,
                               const FieldExtent& field, const QueryState& query);
TransferFunction usualTransfer(const std::vector<Provided<Renderer>>& modes, const Model& model,
                               const FieldExtent& field, const MeshQuery& query);

/// How a model is seen that nobody has looked at yet, in a picture of this width / height.
ViewValue startingView(const std::vector<Provided<Renderer>>& modes, const Model& model, const FieldExtent& field,
                       double aspectRatio = 1);

/// What a picture of a view frames (framed()): the object, unless more of the field than that is shown: by isovalues,
/// by the transfer function (without points: the usual one), by the boundary, or by slices, which reach through all of
/// the domain. Null: there is no renderer of the view's mode.
std::span<const Eigen::Vector3d> framedObject(const FieldExtent& field, const Renderer* renderer,
                                              const ViewValue& view);

/// The renderer of this id; null if there is none.
const Renderer* rendererOf(const std::vector<Provided<Renderer>>& modes, const std::string& id);

/// The scene of a view. `parameters`: those of the renderer that fit the field.
SceneRequest sceneOf(const std::shared_ptr<const Model>& model, const Renderer* renderer,
                     const std::vector<Parameter>& parameters, const ViewValue& view);
/// The same that can show the samples (model_samples.h). `host` outlives it.
SceneRequest withSamples(SceneRequest request, PluginHost& host);

/// What of a picture is within the error of its mesh, of what the renderer was given and of what it has drawn.
std::vector<ErrorRemark> errorRemarksOf(const FieldExtent& field, const ShownMesh& mesh, const ParameterValues& values,
                                        const Scene& scene);

/// Whether what a renderer draws stands before a dark ground, unless another one was chosen: volumes, but for those
/// whose light somebody has turned off. `settings`: what was chosen.
bool hasDarkGround(const Renderer& renderer, const ParameterValues& settings);

/// The background of a view for which none was chosen.
Colour usualBackground(bool isDark);
/// The view that `tan render` takes pictures of, unless a session says how large its own was: its texts and lines are
/// as large as in the pictures. In pixels.
inline const Eigen::Vector2i usualViewSize(1024, 768);

/// What a picture shows, and how large.
struct ViewPicture {
    std::shared_ptr<const Scene> scene{};
    AnnotationContent annotations{};  ///< with the camera and the background
    std::vector<ToolDrawing> tools{}; ///< painted over them (kept_tools.h)
    Eigen::Vector2i size{0, 0};       ///< in pixels
    /// Of the view that it is a picture of: lines and annotations take as much of the picture as they do of that.
    Eigen::Vector2i viewSize = usualViewSize;
    bool transparent = false;
    int dotsPerInch = 0;
};

/// In the units of annotations (annotationScale()).
Size sizeInUnits(const ViewPicture& picture);

/// Annotations, and over them what tools show, seen by the same camera, onto a canvas, which may be a drawing. Errors
/// as of paintAnnotations().
Status paintOver(const PixelCanvas& canvas, const AnnotationContent& content, std::span<const ToolDrawing> tools);

/// Writes the accuracy into the picture, asked for or not, where it says that something else than the mesh is seen.
void tellShown(AnnotationContent& content, ShownField shown);

/// The picture, without a target.
PictureOrder pictureOrder(const ViewPicture& picture);

} // namespace tetra
