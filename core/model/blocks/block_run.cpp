// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/blocks/block_run.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/half.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace tetra {

void BlockRunRecorder::start()
{
    arranger_ = std::make_unique<HistoryArranger>(pointCount_, static_cast<ArrangedBatchSink&>(*this));
    finalKey_ = 0;
    siteCount_ = 0;
    words_.clear();
    tetrahedra_.clear();
}

Status BlockRunRecorder::add(const HistoryStep& step)
{
    return arranger_->add(step);
}

Status BlockRunRecorder::finish(float finalKey)
{
    finalKey_ = finalKey;
    const Status done = arranger_->finish();
    livingCount_ = arranger_->aliveCount();
    arranger_.reset();
    return done;
}

Status BlockRunRecorder::add(const ArrangedBatch& batch)
{
    for (const ArrangedBatch::Tetrahedron& made : batch.tetrahedra)
        tetrahedra_.push_back({made.sites, WideTetrahedron::never, halfBound(made.error, valueExtent_)});
    destroyed_.assign(batch.points.size(), 0);
    for (const ArrangedBatch::Destruction& destruction : batch.destructions) {
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

void BlockRunRecorder::addGroup(const ArrangedBatch& batch, std::size_t first, std::size_t end)
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

void BlockRunRecorder::narrow()
{
    narrow_.resize(tetrahedra_.size());
    const auto narrowed = [](std::uint32_t number) { return static_cast<std::uint16_t>(number); };
    std::ranges::transform(tetrahedra_, narrow_.begin(), [&](const WideTetrahedron& wide) {
        const auto& s = wide.sites;
        return NarrowTetrahedron{
            {narrowed(s[0]), narrowed(s[1]), narrowed(s[2]), narrowed(s[3])}, narrowed(wide.destroyer), wide.ownError};
    });
}

Status BlockRunRecorder::write(const std::filesystem::path& path, std::uint64_t fingerprint, std::uint32_t block)
{
    BlockRunHeader header;
    header.fingerprint = fingerprint;
    header.block = block;
    header.siteCount = siteCount_;
    header.wordCount = words_.size();
    header.tetrahedronCount = tetrahedra_.size();
    header.finalKey = finalKey_;
    header.livingCount = livingCount_;
    const bool isNarrow = siteCount_ <= NarrowTetrahedron::never;
    header.recordBytes = isNarrow ? sizeof(NarrowTetrahedron) : sizeof(WideTetrahedron);
    if (isNarrow)
        narrow();
    const auto records = isNarrow ? std::as_bytes(std::span(narrow_)) : std::as_bytes(std::span(tetrahedra_));
    const auto words = std::as_bytes(std::span(words_));
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(BlockRunHeader, checksum)));
    checksum.add(words);
    checksum.add(records);
    header.checksum = checksum.value();

    Result<FileWriter> file = FileWriter::create(path, 1, path.parent_path());
    if (!file)
        return file.error();
    for (const std::span<const std::byte> part : {std::as_bytes(std::span(&header, 1)), words, records})
        if (const Status written = file->write(part); !written)
            return written;
    return file->commit(FileWriter::Durability::Process);
}

} // namespace tetra
