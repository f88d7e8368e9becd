// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/block_run.h"

#include "core/base/checksum.h"
#include "core/base/rounding.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>

namespace tetra {

void BlockRunRecorder::start()
{
    builder_ = std::make_unique<BatchBuilder>(pointCount_, static_cast<BatchSink&>(*this));
    finalKey_ = 0;
    siteCount_ = 0;
    words_.clear();
    tetrahedra_.clear();
    setFindings({}, 0, 0);
}

Status BlockRunRecorder::add(const HistoryStep& step)
{
    return builder_->add(step);
}

Status BlockRunRecorder::finish(float finalKey)
{
    finalKey_ = finalKey;
    const Status done = builder_->finish();
    livingCount_ = builder_->aliveCount();
    builder_.reset();
    return done;
}

Status BlockRunRecorder::add(const Batch& batch)
{
    for (const Batch::Tetrahedron& made : batch.tetrahedra)
        tetrahedra_.push_back({made.sites, WideTetrahedron::never, halfBound(made.error, valueExtent_),
                               diagonal_ > 0 ? halfBound(made.warping, diagonal_) : std::uint16_t(0)});
    destroyed_.assign(batch.points.size(), 0);
    for (const Batch::Destruction& destruction : batch.destructions) {
        tetrahedra_[destruction.tetrahedron].destroyer = destruction.destroyer;
        ++destroyed_[destruction.destroyer - batch.firstSite];
    }
    words_.push_back(std::bit_cast<std::uint32_t>(batch.runningKey));
    words_.push_back(static_cast<std::uint32_t>(std::ranges::count(batch.groupGoesOn, 0)));
    std::size_t first = 0;
    for (std::size_t place = 0; place < batch.points.size(); ++place)
        if (batch.groupGoesOn[place] == 0) {
            addGroup(batch, first, place + 1);
            first = place + 1;
        }
    siteCount_ += static_cast<std::uint32_t>(batch.points.size());
    return {};
}

void BlockRunRecorder::addGroup(const Batch& batch, std::size_t first, std::size_t end)
{
    std::uint32_t destroyed = 0;
    for (std::size_t place = first; place < end; ++place)
        destroyed += destroyed_[place];
    words_.push_back(static_cast<std::uint32_t>(end - first));
    words_.push_back(batch.starEnds[end - 1] - (first == 0 ? 0 : batch.starEnds[first - 1]));
    words_.push_back(destroyed);
    for (std::size_t place = first; place < end; ++place)
        words_.push_back(static_cast<std::uint32_t>(batch.points[place]));
}

/// The tetrahedra with numbers of 16 bits.
std::span<const std::byte> BlockRunRecorder::narrowed()
{
    const auto narrow = []<class Record>(const WideTetrahedron& wide, Record& record) {
        std::ranges::transform(wide.sites, record.sites.begin(),
                               [](std::uint32_t site) { return static_cast<std::uint16_t>(site); });
        record.destroyer = static_cast<std::uint16_t>(wide.destroyer);
        record.ownError = wide.ownError;
    };
    if (diagonal_ > 0) {
        warped_.resize(tetrahedra_.size());
        for (std::size_t i = 0; i < warped_.size(); ++i) {
            narrow(tetrahedra_[i], warped_[i]);
            warped_[i].ownWarping = tetrahedra_[i].ownWarping;
        }
        return std::as_bytes(std::span(warped_));
    }
    narrow_.resize(tetrahedra_.size());
    for (std::size_t i = 0; i < narrow_.size(); ++i)
        narrow(tetrahedra_[i], narrow_[i]);
    return std::as_bytes(std::span(narrow_));
}

void BlockRunRecorder::setFindings(std::vector<FaceCure> cures, std::uint64_t inverted, std::uint64_t degenerate)
{
    cures_ = std::move(cures);
    inverted_ = static_cast<std::uint32_t>(inverted);
    degenerate_ = static_cast<std::uint32_t>(degenerate);
}

FinishedRun BlockRunRecorder::finished(std::uint64_t fingerprint, std::uint32_t block)
{
    if (!cures_.empty()) { // nobody will read the rest
        siteCount_ = 0;
        livingCount_ = 0;
        words_.clear();
        tetrahedra_.clear();
    }
    const bool isNarrow = siteCount_ <= NarrowTetrahedron::never;
    FinishedRun run;
    run.header.fingerprint = fingerprint;
    run.header.block = block;
    run.header.cureCount = cures_.size();
    run.header.inverted = inverted_;
    run.header.degenerate = degenerate_;
    run.header.siteCount = siteCount_;
    run.header.wordCount = words_.size();
    run.header.tetrahedronCount = tetrahedra_.size();
    run.header.finalKey = finalKey_;
    run.header.livingCount = livingCount_;
    run.header.recordBytes = !isNarrow       ? sizeof(WideTetrahedron)
                             : diagonal_ > 0 ? sizeof(WarpedTetrahedron)
                                             : sizeof(NarrowTetrahedron);
    run.content = {std::as_bytes(std::span(words_)),
                   isNarrow ? narrowed() : std::as_bytes(std::span(std::as_const(tetrahedra_))),
                   std::as_bytes(std::span(cures_))};
    run.header.checksum = runChecksum(run.header, run.content);
    return run;
}

std::uint64_t runChecksum(const BlockRunHeader& header, std::span<const std::span<const std::byte>> content)
{
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(BlockRunHeader, checksum)));
    for (const std::span<const std::byte> part : content)
        checksum.add(part);
    return checksum.value();
}

std::uint64_t runBytes(const BlockRunHeader& header) noexcept
{
    return sizeof header + header.wordCount * sizeof(std::uint32_t) + header.tetrahedronCount * header.recordBytes +
           header.cureCount * sizeof(FaceCure);
}

Status checkMeshSize(std::uint64_t tetrahedra, std::uint64_t expected)
{
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max(); // FORMAT.md: mesh sizes
    constexpr std::uint64_t farTooMany = most + most / 4;                     // what is expected is not known so well
    if (tetrahedra <= most && expected <= farTooMany)
        return {};
    return Error{ErrorKind::OutOfResource,
                 Message::say("The finest mesh would have about %1 tetrahedra, and a model holds meshes of at most %2. "
                              "Choose a larger error, or take a part of the dataset.",
                              std::max(tetrahedra, expected), most)};
}

} // namespace tetra
