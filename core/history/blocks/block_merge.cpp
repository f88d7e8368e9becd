// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/block_merge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

namespace tetra {

/// Reads the batches of one run one after the other through a buffer.
class BlockMerge::RunBatches {
public:
    RunBatches(const RunFiles& files, std::uint32_t block, std::uint32_t bufferWords)
        : files_(&files), block_(block), bufferWords_(bufferWords)
    {
    }

    /// The bits of the running key of the next batch, greater ones for greater keys; none at the end. An Error if the
    /// file cannot be read.
    Result<std::optional<std::uint32_t>> nextKey();

    /// A group of the batch whose key was asked for.
    struct Group {
        std::uint32_t tetrahedronCount = 0;
        std::uint32_t destroyedCount = 0;
        std::span<const std::uint32_t> points; ///< until the next call
    };
    /// The number of groups, then as many groups.
    Result<std::uint32_t> groupCount();
    Result<Group> nextGroup();

private:
    Status fetch(std::uint32_t words);
    std::uint32_t take() { return buffer_[position_++]; }

    const RunFiles* files_;
    std::uint32_t block_;
    std::uint32_t bufferWords_;
    std::uint64_t read_ = 0; ///< words of the file that are or were in the buffer
    std::vector<std::uint32_t> buffer_;
    std::size_t position_ = 0;
};

Result<std::optional<std::uint32_t>> BlockMerge::RunBatches::nextKey()
{
    if (position_ == buffer_.size() && read_ == files_->header(block_).wordCount)
        return std::optional<std::uint32_t>();
    if (const Status fetched = fetch(1); !fetched)
        return fetched.error();
    return std::optional(take());
}

Result<std::uint32_t> BlockMerge::RunBatches::groupCount()
{
    if (const Status fetched = fetch(1); !fetched)
        return fetched.error();
    return take();
}

Result<BlockMerge::RunBatches::Group> BlockMerge::RunBatches::nextGroup()
{
    if (const Status fetched = fetch(3); !fetched)
        return fetched.error();
    const std::uint32_t sites = take();
    Group group{take(), take(), {}};
    if (const Status fetched = fetch(sites); !fetched)
        return fetched.error();
    group.points = std::span(buffer_).subspan(position_, sites);
    position_ += sites;
    return group;
}

/// Makes sure that so many words are in the buffer.
Status BlockMerge::RunBatches::fetch(std::uint32_t words)
{
    const std::size_t have = buffer_.size() - position_;
    if (have >= words)
        return {};
    std::ranges::copy(std::span(buffer_).subspan(position_), buffer_.begin());
    const std::uint64_t left = files_->header(block_).wordCount - read_;
    const std::uint64_t more = std::min<std::uint64_t>(std::max<std::uint64_t>(words - have, bufferWords_), left);
    buffer_.resize(have + std::max<std::uint64_t>(more, words - have));
    position_ = 0;
    const std::span<std::uint32_t> to = std::span(buffer_).subspan(have);
    const Status read = files_->readWords(block_, read_, to); // tells a run that ends too early
    read_ += to.size();
    return read;
}

namespace {

constexpr std::uint32_t noGroup = 0xffffffff;
/// All buffers together, in words.
constexpr std::uint32_t bufferWords = 8 << 20;

} // namespace

BlockMerge::BlockMerge(const RunFiles& files) : counts_(files.blockCount())
{
    const std::uint32_t words = std::clamp(bufferWords / std::max(files.blockCount(), 1u), 256u, 1u << 14);
    for (std::uint32_t block = 0; block < files.blockCount(); ++block)
        runs_.emplace_back(files, block, words);
}

BlockMerge::~BlockMerge() = default;

Result<bool> BlockMerge::next()
{
    if (!started_)
        for (std::uint32_t block = 0; block < runs_.size(); ++block)
            if (const Status advanced = advance(block); !advanced)
                return advanced.error();
    started_ = true;
    if (fronts_.empty())
        return false;
    const std::uint32_t key = fronts_.top().key;
    batch_.runningKey = std::bit_cast<float>(key);
    batch_.parts.clear();
    entries_.clear();
    while (!fronts_.empty() && fronts_.top().key == key) {
        const std::uint32_t block = fronts_.top().block;
        fronts_.pop();
        if (const Status read = readBatch(block); !read)
            return read.error();
        if (const Status advanced = advance(block); !advanced)
            return advanced.error();
    }
    if (batch_.parts.size() == 1)
        takeOnlyPart();
    else
        unite();
    return true;
}

Status BlockMerge::advance(std::uint32_t block)
{
    const Result<std::optional<std::uint32_t>> key = runs_[block].nextKey();
    if (!key)
        return key.error();
    if (*key)
        fronts_.push({**key, block});
    return {};
}

Status BlockMerge::readBatch(std::uint32_t block)
{
    const Result<std::uint32_t> groups = runs_[block].groupCount();
    if (!groups)
        return groups.error();
    Counts& counts = counts_[block];
    for (std::uint32_t number = 0; number < *groups; ++number) {
        const Result<RunBatches::Group> group = runs_[block].nextGroup();
        if (!group)
            return group.error();
        const auto part = static_cast<std::uint32_t>(batch_.parts.size());
        const auto slot = static_cast<std::uint32_t>(entries_.size());
        const auto sites = static_cast<std::uint32_t>(group->points.size());
        batch_.parts.push_back(
            {block, sites, counts.sites, group->tetrahedronCount, group->destroyedCount, slot, counts.tetrahedra, 0});
        for (std::uint32_t i = 0; i < sites; ++i)
            entries_.push_back({group->points[i], part, slot + i});
        counts.sites += sites;
        counts.tetrahedra += group->tetrahedronCount;
    }
    return {};
}

/// Most batches: nothing to unite, and everything in order.
void BlockMerge::takeOnlyPart()
{
    batch_.points.clear();
    for (const Entry& entry : entries_)
        batch_.points.push_back(entry.point);
    batch_.groupGoesOn.assign(entries_.size(), 1);
    batch_.groupGoesOn.back() = 0;
    batch_.places.resize(entries_.size());
    std::iota(batch_.places.begin(), batch_.places.end(), 0u);
}

void BlockMerge::unite()
{
    std::ranges::sort(entries_, {}, [](const Entry& entry) { return std::pair(entry.point, entry.slot); });
    groups_.reset(batch_.parts.size());
    const bool initial = std::isinf(batch_.runningKey); // the mesh that they start from has no parts
    for (std::size_t i = 1; i < entries_.size(); ++i)
        if (initial || entries_[i].point == entries_[i - 1].point)
            groups_.join(entries_[i].part, entries_[i - 1].part);
    numberGroups();
    placeSites();
    sortParts();
}

/// By their first points, which is the order in which sorted entries show them.
void BlockMerge::numberGroups()
{
    for (MergedBatch::Part& part : batch_.parts)
        part.group = noGroup;
    groupSizes_.clear();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        MergedBatch::Part& first = batch_.parts[groups_.root(entries_[i].part)];
        if (first.group == noGroup) {
            first.group = static_cast<std::uint32_t>(groupSizes_.size());
            groupSizes_.push_back(0);
        }
        if (i == 0 || entries_[i].point != entries_[i - 1].point)
            ++groupSizes_[first.group];
    }
    for (std::uint32_t part = 0; part < batch_.parts.size(); ++part)
        batch_.parts[part].group = batch_.parts[groups_.root(part)].group;
}

void BlockMerge::placeSites()
{
    std::uint32_t sites = 0;
    for (std::uint32_t& size : groupSizes_)
        sites += std::exchange(size, sites);
    batch_.points.resize(sites);
    batch_.places.resize(entries_.size());
    batch_.groupGoesOn.assign(sites, 1);
    for (const std::uint32_t first : groupSizes_)
        if (first > 0)
            batch_.groupGoesOn[first - 1] = 0;
    batch_.groupGoesOn.back() = 0;
    std::uint32_t place = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (i == 0 || entries_[i].point != entries_[i - 1].point) {
            place = groupSizes_[batch_.parts[entries_[i].part].group]++;
            batch_.points[place] = entries_[i].point;
        }
        batch_.places[entries_[i].slot] = place;
    }
}

void BlockMerge::sortParts()
{
    std::ranges::stable_sort(batch_.parts, {}, &MergedBatch::Part::group);
}

} // namespace tetra
