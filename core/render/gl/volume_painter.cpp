// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/volume_painter.h"

#include "core/render/focus_weight.h"
#include "core/render/gl/gl_program.h"
#include "core/render/tiles.h"
#include "core/render/view_transform.h"
#include "core/render/volume/projected_volume.h"
#include "core/render/volume/volume_mesh.h"
#include "core/render/volume/volume_view.h"

#include <tan/render.h>

#include <Eigen/LU>

#include <algorithm>
#include <chrono>

namespace tetra {

namespace {

/// Layers of the fine volume in the border on either side. Blending cannot mix the two volumes, so their layers
/// alternate. The layers of one begin in the middle of those of the other, so that parts drawn too early and too late
/// balance out.
constexpr int fineLayers = 2;

RegionsInView regionsInView(std::span<const FocusRegion> regions, const VolumeView& view)
{
    const Eigen::Matrix3d worldFromImage = view.imageFromWorld.leftCols<3>().inverse();
    RegionsInView inView;
    for (const FocusRegion& region : regions) {
        const RegionShape shape = shapeOf(region);
        const Eigen::Vector3d fromImage = -(worldFromImage * view.imageFromWorld.col(3)) - shape.centre;
        const Eigen::Vector3f size = (shape.size / view.unit).cast<float>();
        const Eigen::Vector3f place = (fromImage / view.unit).cast<float>();
        inView.shapes.emplace_back(size.x(), size.y(), size.z(), shape.isBall ? 1 : 0);
        inView.places.emplace_back(place.x(), place.y(), place.z(), static_cast<float>(shape.border / view.unit));
    }
    inView.worldFromImage = (worldFromImage / view.unit).cast<float>();
    return inView;
}

/// What a volume with a focus, or without, is drawn in, front to back.
std::vector<VolumePart> partsOf(const std::optional<RegionsInView>& regions)
{
    using Place = VolumePart::Place;
    if (!regions)
        return {{Place::Whole}};
    std::vector<VolumePart> parts;
    const bool hasBorder = std::ranges::any_of(regions->places, [](const auto& place) { return place.w() > 0; });
    const auto addBorder = [&](Place place, int interval) {
        const auto addLayer = [&](bool fine, float begin, float end) {
            parts.push_back({place, interval, fine, {std::max(0.0f, begin), std::min(1.0f, end)}});
        };
        for (int layer = 0; layer <= fineLayers && hasBorder; ++layer) {
            const auto number = static_cast<float>(layer);
            addLayer(false, (number - 0.5f) / fineLayers, (number + 0.5f) / fineLayers);
            if (layer < fineLayers)
                addLayer(true, number / fineLayers, (number + 1) / fineLayers);
        }
    };
    const int count = static_cast<int>(regions->shapes.size());
    for (int interval = 0; interval < count; ++interval) {
        parts.push_back({Place::Before, interval});
        addBorder(Place::FrontBorder, interval);
        parts.push_back({Place::Within, interval, true});
        addBorder(Place::BackBorder, interval);
    }
    parts.push_back({Place::Before, count});
    return parts;
}

/// Sets the uniforms of focus.frag in the program in use, as does setVolumePart().
void setRegions(const GlProgram& program, const std::optional<RegionsInView>& regions)
{
    const RegionsInView& used = regions ? *regions : RegionsInView{};
    program.set("regionCount", static_cast<int>(used.shapes.size()));
    program.set("regionShapes", used.shapes);
    program.set("regionPlaces", used.places);
    program.set("worldFromImage", used.worldFromImage);
}

void setVolumePart(const GlProgram& program, const VolumePart& part)
{
    program.set("focusPart", static_cast<int>(part.place));
    program.set("focusInterval", part.interval);
    program.set("fine", part.fine ? 1 : 0);
    program.set("borderShares", part.shares);
}

constexpr MarkedText drawingVolume = Message::marked("Drawing the volume");
constexpr int verticesPerCell = 12;
/// How often in a picture the samples that nothing can be added to are marked: a pass over all samples each.
constexpr std::size_t marks = 16;
/// Texels that every texture buffer of OpenGL 3.3 can have.
constexpr std::size_t mostRayData = 65'536;
/// Less light than this from behind is none, as on the CPU.
constexpr float leastLight = 1.0f / 16384;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What is left of numbers that are rounded to floats.
Eigen::Vector3f lowPart(const Eigen::Vector3d& number)
{
    return (number - number.cast<float>().cast<double>()).cast<float>();
}

/// q (volume.frag) at the far plane, and how much it rises towards the eye for one unit of depth.
Eigen::Vector2f boundOfDepth(const Eigen::Matrix4d& projection, bool perspective, double unit)
{
    const double a = projection(2, 2), b = projection(2, 3);
    if (perspective)
        return Eigen::Vector2d((1 + a) / b, -2 / b).cast<float>() * static_cast<float>(unit);
    return Eigen::Vector2d((1 - b) / (a * unit), -2 / (a * unit)).cast<float>();
}

/// The planes in the picture, as volume.frag wants them.
std::vector<Eigen::Vector4f> cutsOf(const std::vector<ClipPlane>& planes, const VolumeView& view,
                                    const Eigen::Vector3d& origin)
{
    const Eigen::Matrix3d worldFromImage = view.imageFromWorld.leftCols<3>().inverse();
    const Eigen::Vector3d imageOfOrigin = view.imageFromWorld * origin.homogeneous();
    std::vector<Eigen::Vector4f> cuts;
    for (const ClipPlane& plane : planes) {
        const Eigen::Vector3d normal = worldFromImage.transpose() * plane.normal;
        const double atOrigin = plane.normal.dot(origin) - plane.offset;
        const double atZero = atOrigin - normal.dot(imageOfOrigin);
        const Eigen::Vector4d cut = view.perspective ? Eigen::Vector4d(normal.x(), normal.y(), normal.z(), atZero)
                                                     : Eigen::Vector4d(normal.x(), normal.y(), atZero, -normal.z());
        cuts.emplace_back(cut.cast<float>());
    }
    return cuts;
}

} // namespace

Status VolumePainter::prepareBuffers(const Volume& volume, const CachedOrder::Request& order, int threads,
                                     const Progress& progress, DrawnVolume& drawn)
{
    const Result<VolumeBuffers*> kept = drawn.kept.buffersOf(volume.mesh, order.camera);
    if (!kept)
        return kept.error();
    drawn.buffers = *kept;
    VolumeBuffers& buffers = *drawn.buffers;
    Clock::time_point start = Clock::now();
    if (Status status = onThreads(threads, [&] { return buffers.order.prepare(order, progress); }); !status)
        return status;
    statistics_.orderSeconds += secondsSince(start);
    statistics_.orderReused = statistics_.orderReused && buffers.order.reused();
    statistics_.cutCells = std::max(statistics_.cutCells, buffers.order.cutCells());
    statistics_.brokenCycles = std::max(statistics_.brokenCycles, buffers.order.brokenCycles());
    start = Clock::now();
    if (!buffers.order.reused() || buffers.transfer.lock() != volume.transfer) {
        buffers.transfer.reset(); // until it is true
        if (Status status = fillCells(gl_, volume, buffers); !status)
            return status;
        buffers.transfer = volume.transfer;
        statistics_.sentBytes += buffers.sentBytes;
    }
    statistics_.setUpSeconds += secondsSince(start);
    statistics_.cells += buffers.cells;
    return {};
}

Status VolumePainter::prepareVolume(const Volume& volume, const SampleView& view, const PictureOptions& options,
                                    const Progress& progress, DrawnVolume& drawn)
{
    drawn.shaded = volume.shaded && !volume.model;
    drawn.perFullGradient = perFullGradient(volume.fullGradient, volume.mesh->longestGradient);
    drawn.segments = scaleSegments(volume.transfer->segments, view_.unit);
    drawn.buffers = nullptr;
    fillSegments(gl_, drawn.segments, drawn.segmentBuffer);
    const CachedOrder::Request order{volume.mesh, view.camera, whole_, view.part, options.orderTolerance};
    return prepareBuffers(volume, order, options.threads, progress, drawn);
}

/// Programs are kept for the next picture: compiling takes longer than drawing.
Result<const GlProgram*> VolumePainter::keptProgram(Programs& kept, MakeProgram make, const std::string& shader,
                                                    const std::string& maker) const
{
    constexpr std::size_t mostKept = 16;
    auto found = kept.find(shader);
    if (found == kept.end()) {
        auto program = make(gl_, shader, maker);
        if (!program)
            return program.error();
        if (kept.size() >= mostKept)
            kept.clear();
        found = kept.emplace(shader, *std::move(program)).first;
    }
    return found->second.get();
}

Status VolumePainter::prepareModel(const Volume& volume, const std::string& maker)
{
    combiner_ = combinerOf(volume);
    program_ = rayProgram_ = nullptr;
    if (!volume.model)
        return {};
    const auto program = keptProgram(models_, makeModelProgram, volume.model->shader, maker);
    if (!program)
        return program.error();
    if (volume.model->lightOfRay && combiner_ != Combiner::Over)
        if (Status status = prepareRays(volume.model, maker); !status)
            return status;
    program_ = *program;
    return {};
}

Status VolumePainter::prepareRays(const std::shared_ptr<const OpticalModel>& model, const std::string& maker)
{
    if (const std::size_t size = model->rayData.size(); size > mostRayData)
        return Error{ErrorKind::BadInput,
                     maker.empty()
                         ? Message::say("The table of an optical model has %1 entries; at most %2 can be used.", size,
                                        mostRayData)
                         : Message::say("The plugin '%1' has an optical model with a table of %2 entries; at "
                                        "most %3 can be used. This is a fault of the plugin; tell its author.",
                                        maker, size, mostRayData)};
    const auto program = keptProgram(rays_, makeRayProgram, model->rayShader, maker);
    if (!program)
        return program.error();
    if (rayDataOf_.lock() != model)
        fillRayData(gl_, model->rayData, rayData_);
    rayDataOf_ = model;
    rayProgram_ = *program;
    return {};
}

void VolumePainter::setRayData() const
{
    rayProgram_->setTexture("rayData", 1, rayData_.texture.name(), gl::textureBuffer);
}

Status VolumePainter::prepare(const Scene& scene, const SampleView& view, const PictureOptions& options,
                              const Progress& progress)
{
    statistics_ = {};
    statistics_.orderReused = true; // until a volume needs a new one
    const Camera& camera = view.camera;
    whole_ = makeVolumeView(camera, view.width, view.height, view.bounds);
    view_ = partOf(whole_, view.part);
    origin_ = camera.perspective ? eyePosition(camera) : camera.target;
    cuts_ = cutsOf(scene.clipPlanes, view_, origin_);
    const double aspectRatio = static_cast<double>(view.width) / view.height;
    boundOfDepth_ = boundOfDepth(projectionMatrix(camera, aspectRatio, view.bounds), camera.perspective, view_.unit);
    const Volume& volume = *volumeOf(scene);
    const FocusVolume* focus = focusOf(scene);
    wholeCells_ = volume.wholeCells;
    if (Status status = prepareModel(volume, scene.maker); !status)
        return status;
    regions_.reset();
    if (focus == nullptr)
        return prepareVolume(volume, view, options, progress, coarse_);
    regions_ = regionsInView(focus->regions, view_);
    if (Status status = prepareVolume(volume, view, options, progress.part(0, 0.5), coarse_); !status)
        return status;
    return prepareVolume(focus->fine, view, options, progress.part(0.5, 1), fine_);
}

void VolumePainter::setUniforms(const GlProgram& program) const
{
    const Eigen::Vector3d imageOfOrigin = view_.imageFromWorld * origin_.homogeneous();
    program.set("perspective", view_.perspective ? 1 : 0);
    program.set("imageFromWorld", Eigen::Matrix3f(view_.imageFromWorld.leftCols<3>().cast<float>()));
    program.set("imageOfOrigin",
                view_.perspective ? Eigen::Vector3f(0, 0, 0) : Eigen::Vector3f(imageOfOrigin.cast<float>()));
    program.set("pictureSize", Eigen::Vector2f(static_cast<float>(view_.width), static_cast<float>(view_.height)));
    program.set("pictureCentre", Eigen::Vector2f(view_.centre.cast<float>()));
    program.set("sampleShift", Eigen::Vector2f(static_cast<float>(sampleX - 0.5), static_cast<float>(sampleY - 0.5)));
    program.set("samplesPerSlope", Eigen::Vector2f(view_.samplesPerSlope.cast<float>()));
    program.set("nearest", static_cast<float>(view_.nearest));
    program.set("nearestBound", view_.perspective ? static_cast<float>(1 / view_.nearest) : 0.0f);
    program.set("cutCount", static_cast<int>(cuts_.size()));
    program.set("cuts", cuts_);
    program.set("boundOfDepth", boundOfDepth_);
    program.set("wholeCells", wholeCells_ ? 1 : 0);
    program.set("unit", static_cast<float>(view_.unit));
    setLights(program);
    // How long u and v are for one unit of length across the view, in units of w for one along it.
    program.set(
        "lengths",
        Eigen::Vector2f((view_.imageFromWorld.leftCols<3>().topRows<2>().rowwise().norm() * view_.unit).cast<float>()));
    program.set("viewAxes", view_.axes());
    setRegions(program, regions_);
}

void VolumePainter::setVolume(const GlProgram& program, const DrawnVolume& volume) const
{
    const Eigen::Vector3d origin = origin_ - volume.buffers->origin;
    program.set("originHigh", Eigen::Vector3f(origin.cast<float>()));
    program.set("originLow", lowPart(origin));
    const ScaledSegments& segments = volume.segments;
    const auto smallest = static_cast<float>(segments.smallest);
    program.set("smallestValue", Eigen::Vector2f(smallest, static_cast<float>(segments.smallest - double(smallest))));
    program.set("perValue", static_cast<float>(segments.perValue));
    program.set("shaded", volume.shaded ? 1 : 0);
    program.set("perFullGradient", volume.perFullGradient);
    program.setTexture("segments", 4, volume.segmentBuffer.texture.name(), gl::textureBuffer);
}

void VolumePainter::setCellState() const
{
    gl_.enable(gl::cullFace);
    gl_.cullFace(gl::front);
    gl_.frontFace(gl::counterclockwise);
    gl_.enable(gl::depthTest);
    gl_.depthFunc(gl::lessOrEqual);
    gl_.depthMask(0);
}

void VolumePainter::markSaturated(const GlProgram& program, const SampleTargets& targets) const
{
    gl_.bindFramebuffer(gl::framebuffer, targets.saturatedFramebuffer.name());
    gl_.disable(gl::cullFace);
    gl_.depthMask(1);
    program.use();
    program.setTexture("accumulated", textureUnits - 1, targets.accumulated.name());
    program.set("saturated", 1 - leastLight);
    gl_.drawArrays(gl::triangles, 0, 3);
    // Not to be read while it is drawn into.
    gl_.bindTexture(gl::texture2D, 0);
    gl_.bindFramebuffer(gl::framebuffer, targets.accumulatedFramebuffer.name());
    setCellState();
}

void VolumePainter::setPartUniforms(const GlProgram& program, const DrawnVolume& volume, const VolumePart& part) const
{
    program.use();
    setUniforms(program);
    setVolume(program, volume);
    setVolumePart(program, part);
}

Status VolumePainter::drawPart(const PainterPrograms& programs, const SampleTargets& targets,
                               const VolumeLayers& layers, const VolumePart& part, const Progress& progress) const
{
    const DrawnVolume& volume = part.fine ? fine_ : coarse_;
    const GlProgram& program = program_ != nullptr ? *program_ : *programs.volume;
    setPartUniforms(program, volume, part);
    program.setTexture("vertices", 3, volume.buffers->vertices.texture.name(), gl::textureBuffer);
    program.setTexture("gradients", 7, volume.buffers->gradients.texture.name(), gl::textureBuffer);
    program.set("layered", layers.behind != 0 ? 1 : 0);
    program.setTexture("opaqueDepth", 0, layers.opaqueDepth);
    program.setTexture("layerBefore", 1, layers.before);
    program.setTexture("layerBehind", 2, layers.behind);
    const std::vector<CellChunk>& chunks = volume.buffers->chunks;
    const std::size_t chunksPerMark = (chunks.size() + marks - 1) / marks;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        if (progress.cancelled())
            return cancelledError(drawingVolume);
        if (i > 0 && i % chunksPerMark == 0 && combiner_ == Combiner::Over)
            markSaturated(*programs.saturated, targets);
        program.use();
        program.setTexture("corners", 5, chunks[i].corners.texture.name(), gl::textureBuffer);
        program.setTexture("segmentsOfCell", 6, chunks[i].segments.texture.name(), gl::textureBuffer);
        gl_.drawArrays(gl::triangles, 0, chunks[i].count * verticesPerCell);
    }
    return {};
}

Status VolumePainter::draw(const PainterPrograms& programs, const SampleTargets& targets, const VolumeLayers& layers,
                           const Progress& progress) const
{
    setCellState();
    Status status;
    bool first = true;
    for (const VolumePart& part : partsOf(regions_)) {
        if (!first)
            markSaturated(*programs.saturated, targets);
        first = false;
        if (status = drawPart(programs, targets, layers, part, progress); !status)
            break;
    }
    gl_.disable(gl::cullFace);
    gl_.disable(gl::depthTest);
    gl_.depthFunc(gl::less);
    gl_.depthMask(1);
    return status;
}

} // namespace tetra
