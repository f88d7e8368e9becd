// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/card_volume.h"

#include "core/graphics/cpu/drawing_threads.h"
#include "core/graphics/volume/order_drift.h"

#include <algorithm>
#include <chrono>

namespace tetra {
namespace {

using Clock = std::chrono::steady_clock;

double secondsAfter(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

Result<bool> CardVolume::orderOnCard(const ComputeContext& context, const ComputePrograms& programs,
                                     const KeptOrder::Request& request, const Progress& progress,
                                     RenderStatistics& statistics)
{
    const VolumeMesh& mesh = *request.mesh;
    if (keysFit_ && orderDrift(mesh.bounds, camera_, request.camera) <= request.tolerance)
        return true;
    keysFit_ = false;
    statistics.orderReused = false;
    const Result<bool> made =
        keys_.make(context, programs, mesh_, {request.whole.eye, request.whole.perspective}, mesh.bounds, progress);
    if (made && *made) {
        keysFit_ = true;
        camera_ = request.camera;
    }
    return made;
}

Status CardVolume::order(const ComputeContext& context, const ComputePrograms& programs, const Request& request,
                         const Progress& progress, RenderStatistics& statistics)
{
    if (cardOrders_) {
        const Result<bool> made = orderOnCard(context, programs, request.order, progress, statistics);
        if (!made)
            return made.error();
        cardOrders_ = *made; // where it failed once it would each time
        if (*made)
            return {};
    }
    statistics.orderOnCard = false;
    if (Status status = onThreads(request.threads, [&] { return order_.prepare(request.order, progress); }); !status)
        return status;
    statistics.brokenCycles = std::max(statistics.brokenCycles, order_.brokenCycles());
    if (order_.reused())
        return {};
    statistics.orderReused = false;
    keys_.take(context, order_.cells());
    statistics.sentBytes += order_.cells().size_bytes();
    return checkDriver(context);
}

Status CardVolume::tryPreparing(const ComputeContext& context, const ComputePrograms& programs, const Request& request,
                                const Progress& progress, RenderStatistics& statistics)
{
    if (!filled_) {
        if (Status status = fillMesh(context, *request.order.mesh, mesh_); !status)
            return status;
        cardOrders_ = request.order.mesh->convex;
        filled_ = true;
    }
    Clock::time_point start = Clock::now();
    if (Status status = order(context, programs, request, progress, statistics); !status)
        return status;
    statistics.orderSeconds += secondsAfter(start);
    start = Clock::now();
    if (Status status = cells_.choose(context, programs, mesh_, keys_, *request.volume.transfer, request.setView);
        !status)
        return status;
    statistics.setUpSeconds += secondsAfter(start);
    statistics.sentBytes += cells_.sentBytes();
    statistics.cells += cells_.count();
    return {};
}

Status CardVolume::prepare(const ComputeContext& context, const ComputePrograms& programs, const Request& request,
                           const Progress& progress, RenderStatistics& statistics)
{
    if (!refused_)
        return refused_;
    Status status = tryPreparing(context, programs, request, progress, statistics);
    if (!status && status.error().kind != ErrorKind::Cancelled) {
        *this = CardVolume(); // its memory is of use for others
        refused_ = status;
    }
    return status;
}

CardVolume& CardVolumeCache::volumeOf(const std::shared_ptr<const VolumeMesh>& mesh)
{
    Entry& entry = entries_[mesh.get()];
    if (!entry.volume || entry.mesh.expired())
        entry = {mesh, std::make_unique<CardVolume>()};
    return *entry.volume;
}

void CardVolumeCache::dropDead()
{
    std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
}

} // namespace tetra
