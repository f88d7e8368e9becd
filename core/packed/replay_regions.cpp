// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay_regions.h"

#include "core/base/progress.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace tetra {

bool ReplayRegion::has(std::uint32_t latticePoint) const noexcept
{
    const std::array<std::uint32_t, 3> place = placeInLattice(latticePoint);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (place[axis] < box.origin[axis] || place[axis] > box.last(axis))
            return false;
    return true;
}

std::uint32_t ReplayRegion::inBox(std::uint32_t latticePoint) const noexcept
{
    const auto [x, y, z] = placeInLattice(latticePoint);
    return ((z - box.origin[2]) * box.size[1] + y - box.origin[1]) * box.size[0] + x - box.origin[0];
}

std::uint32_t ReplayRegion::inLattice(std::uint32_t boxPoint) const noexcept
{
    const auto [x, y, z] = placeInBox(boxPoint);
    return ((z + box.origin[2]) * latticeSize[1] + y + box.origin[1]) * latticeSize[0] + x + box.origin[0];
}

bool ReplayRegion::shares(std::uint32_t boxPoint) const noexcept
{
    const std::array<std::uint32_t, 3> place = placeInBox(boxPoint);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (place[axis] == box.size[axis] - 1 && box.last(axis) < latticeSize[axis] - 1)
            return true;
    return false;
}

void ReplayRegion::forEachOwnRow(const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& visit) const
{
    for (std::uint32_t z = 0; z < box.size[2]; ++z)
        for (std::uint32_t y = 0; y < box.size[1]; ++y) {
            const std::uint32_t first = firstOwn(y, z), inside = (z * box.size[1] + y) * box.size[0] + first;
            if (first < box.size[0])
                visit(inside, inLattice(inside), box.size[0] - first);
        }
}

namespace {

/// How many blocks a region has along an edge: so many that not too much of it is faces, and that there are not too
/// many regions, as each takes its share of the beginning of the file.
std::uint32_t blocksOfRegions(const std::array<std::uint32_t, 3>& latticeSize, std::uint32_t blockCells)
{
    constexpr std::uint32_t leastCells = 64, mostRegions = 512;
    if (blockCells == 0)
        return 1;
    std::uint32_t blocks = (leastCells + blockCells - 1) / blockCells;
    while (BlockDivision(latticeSize, blocks * blockCells).count() > mostRegions)
        ++blocks;
    return blocks;
}

} // namespace

ReplayRegions::ReplayRegions(const std::array<std::uint32_t, 3>& latticeSize, std::uint32_t blockCells)
    : latticeSize_(latticeSize), blocksAlong_(blocksOfRegions(latticeSize, blockCells)),
      division_(latticeSize, blocksAlong_ * blockCells)
{
}

ReplayRegion ReplayRegions::operator[](std::uint32_t number) const
{
    return {number, division_.box(number), latticeSize_, blocksAlong_ % 2 == 1 && division_.odd(number)};
}

std::vector<std::uint32_t> ReplayRegions::touching(std::uint32_t number) const
{
    std::vector<std::uint32_t> result, there;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        division_.blocksOf(division_.box(number).corner(corner), there);
        std::ranges::copy_if(there, std::back_inserter(result), [&](std::uint32_t one) { return one < number; });
    }
    std::ranges::sort(result);
    result.erase(std::ranges::unique(result).begin(), result.end());
    return result;
}

void ReplayRegions::withPoint(std::uint32_t latticePoint, std::vector<std::uint32_t>& regions) const
{
    const std::uint32_t row = latticePoint / latticeSize_[0];
    division_.blocksOf({latticePoint - row * latticeSize_[0], row % latticeSize_[1], row / latticeSize_[1]}, regions);
}

Status ReplayRegions::forEach(const Progress& progress, const Message& activity,
                              const std::function<Status(const ReplayRegion&, const Progress&)>& work) const
{
    double points = 0;
    for (std::uint32_t number = 0; number < count(); ++number)
        points += static_cast<double>(division_.box(number).pointCount());
    SharedProgress done(progress, points, activity);
    FirstFailure failure;
    std::atomic<std::uint32_t> next = 0;
    const auto workOn = [&]() -> Status {
        for (std::uint32_t number = next++; number < count() && !failure.happened(); number = next++) {
            const ReplayRegion region = (*this)[number];
            const Progress own =
                failure.watching(progress).withCallback(done.piece(static_cast<double>(region.box.pointCount())));
            if (const Status worked = work(region, own); !worked)
                return worked;
            own.report(1, {});
        }
        return {};
    };
    const int workers = std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(count()));
    tbb::parallel_for(
        0, workers, [&](int) { failure.run(workOn); }, tbb::simple_partitioner());
    return failure.status();
}

SharedSites::SharedSites(const ReplayRegions& regions) : told_(regions.count())
{
    for (std::uint32_t number = 0; number < regions.count(); ++number)
        touching_.push_back(regions.touching(number));
}

Status SharedSites::await(const ReplayRegion& region, std::uint32_t level, std::vector<std::uint32_t>& sites,
                          const Progress& progress)
{
    constexpr std::chrono::milliseconds patience{100};
    sites.clear();
    std::unique_lock lock(mutex_);
    for (const std::uint32_t before : touching_[region.number]) {
        const Told& told = told_[before];
        while (told.ends.size() <= level) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Replaying the insertions"));
            changed_.wait_for(lock, patience);
        }
        const std::size_t begin = level == 0 ? 0 : told.ends[level - 1];
        std::copy_if(told.sites.begin() + static_cast<std::ptrdiff_t>(begin),
                     told.sites.begin() + static_cast<std::ptrdiff_t>(told.ends[level]), std::back_inserter(sites),
                     [&](std::uint32_t site) { return region.has(site); });
    }
    return {};
}

void SharedSites::tell(const ReplayRegion& region, std::span<const std::uint32_t> sites)
{
    {
        const std::lock_guard lock(mutex_);
        Told& told = told_[region.number];
        told.sites.insert(told.sites.end(), sites.begin(), sites.end());
        told.ends.push_back(told.sites.size());
    }
    changed_.notify_all();
}

} // namespace tetra
