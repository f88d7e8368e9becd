// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/blocks/merged_numbers.h"

#include "core/model/blocks/block_merge.h"
#include "core/model/model.h"

namespace tetra {

namespace {

constexpr std::uint64_t sitesBetweenReports = 1 << 16;

Error unfitNumbers()
{
    return {ErrorKind::OutOfResource, "The runs of the blocks do not fit together. Start the build again."};
}

} // namespace

Result<MergedNumbers> MergedNumbers::make(const RunFiles& runs, const std::filesystem::path& workFolder,
                                          const Progress& progress)
{
    std::vector<std::uint64_t> firsts{0};
    for (std::uint32_t block = 0; block < runs.blockCount(); ++block)
        firsts.push_back(firsts.back() + runs.header(block).siteCount);
    Result<ScratchFile> file = ScratchFile::create(workFolder, firsts.back() * sizeof(std::uint32_t));
    if (!file)
        return file.error();
    MergedNumbers numbers(*std::move(file));
    numbers.firsts_ = std::move(firsts);
    if (const Status filled = numbers.fill(runs, progress); !filled)
        return filled.error();
    return numbers;
}

Status MergedNumbers::fill(const RunFiles& runs, const Progress& progress)
{
    const std::span<std::uint32_t> numbers = file_.as<std::uint32_t>();
    BlockMerge merge(runs);
    std::uint64_t done = 0;
    std::uint64_t reported = 0;
    for (;;) {
        const Result<bool> more = merge.next();
        if (!more)
            return more.error();
        if (!*more)
            break;
        const MergedBatch& batch = merge.batch();
        if (batch.points.size() >= Model::never - siteCount_)
            return Error{ErrorKind::OutOfResource, "The model would have more than 4294967294 sites. Ask for a larger "
                                                   "error, or take a part of the dataset."};
        for (const MergedBatch::Part& part : batch.parts) {
            const std::uint64_t first = firsts_[part.block] + part.firstSite;
            if (first + part.siteCount > firsts_[part.block + 1])
                return unfitNumbers();
            for (std::uint32_t site = 0; site < part.siteCount; ++site)
                numbers[first + site] = siteCount_ + batch.places[part.firstPlace + site];
            done += part.siteCount;
        }
        siteCount_ += static_cast<std::uint32_t>(batch.points.size());
        if (done < reported + sitesBetweenReports)
            continue;
        reported = done;
        if (progress.cancelled())
            return cancelledError("Merging the blocks");
        progress.report(static_cast<double>(done) / static_cast<double>(numbers.size()), "Numbering the sites");
    }
    return done == numbers.size() ? Status() : Status(unfitNumbers());
}

} // namespace tetra
