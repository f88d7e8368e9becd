// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/scene_builder.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tetra {
namespace {

/// A scene is given up for a newer one if it takes longer than this, or much longer than the last one took, so that the
/// picture follows a slider or a focus that is being dragged as quickly as scenes can be made; but never longer than
/// the second.
constexpr auto leastPatience = std::chrono::milliseconds(300);
constexpr auto mostPatience = std::chrono::milliseconds(2500);
constexpr double muchLonger = 1.5;

std::chrono::milliseconds patienceFor(double seconds)
{
    const auto wanted = std::chrono::milliseconds(std::llround(1000 * muchLonger * seconds));
    return std::clamp(wanted, leastPatience, mostPatience);
}

} // namespace

SceneBuilder::SceneBuilder(QObject* parent)
    : QObject(parent), patience_(leastPatience), pipeline_(std::make_shared<ScenePipeline>())
{
}

SceneBuilder::~SceneBuilder() = default;

void SceneBuilder::request(SceneRequest request)
{
    setBusy(true);
    job_.submit(
        [this, number = ++newest_, pipeline = pipeline_, request = std::move(request)](const std::stop_token& stop) {
            Result<BuiltScene> result = pipeline->make(request, Progress(stop, {}));
            QMetaObject::invokeMethod(
                this, [this, number, result = std::move(result)] { arrived(number, result); }, Qt::QueuedConnection);
        },
        patience_);
}

std::shared_ptr<const ExtractedMesh> SceneBuilder::mesh() const
{
    return pipeline_->mesh();
}

void SceneBuilder::clear()
{
    cleared_ = newest_;
    last_.reset();
    // The worker gives back the mesh, in its own time.
    job_.submit([pipeline = pipeline_](const std::stop_token&) { pipeline->clear(); });
    setBusy(false);
}

void SceneBuilder::arrived(quint64 number, const Result<BuiltScene>& result)
{
    if (number <= cleared_)
        return;
    if (number == newest_)
        setBusy(false);
    if (result)
        patience_ = patienceFor(result->extractionSeconds + result->sceneSeconds);
    if (result) {
        last_ = *result;
        emit sceneReady(*result);
        return;
    }
    if (number == newest_)
        last_.reset();
    if (result.error().kind != ErrorKind::Cancelled)
        emit failed(result.error());
}

void SceneBuilder::setBusy(bool busy)
{
    if (busy_ == busy)
        return;
    busy_ = busy;
    emit busyChanged(busy);
}

} // namespace tetra
