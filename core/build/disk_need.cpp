// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/disk_need.h"

#include "core/history/model_writer.h"

#include <algorithm>
#include <limits>

namespace tetra {

DiskNeed diskNeed(const RunTotals& expected, SampleType type, DomainClass domain) noexcept
{
    constexpr std::uint64_t mostSites = std::numeric_limits<std::uint32_t>::max();
    const FixedCounts counts{static_cast<std::uint32_t>(std::min(expected.sites, mostSites)), expected.tetrahedra};
    const std::uint64_t siteNumbers = expected.sites * sizeof(std::uint32_t);
    return {ModelFileWriter::expectedBytes(counts, type, domain, expected.points), expected.fileBytes + siteNumbers};
}

Message textOf(const DiskNeed& need)
{
    if (need.model == 0)
        return Message::say("work files %1", neededBytesText(need.workFiles));
    return Message::say("model about %1, work files %2", neededBytesText(need.model), neededBytesText(need.workFiles));
}

Status checkRoom(const DiskNeed& need, std::uint64_t written, std::uint64_t free, const std::filesystem::path& folder)
{
    if (need.total() <= written || need.total() - written <= free)
        return {};
    return Error{ErrorKind::CannotWrite, Message::say("The build needs about %1 on the disk of '%2' (%3), and %4 are "
                                                      "free. Free some space, choose another disk or a larger error.",
                                                      neededBytesText(need.total()), folder.string(), textOf(need),
                                                      neededBytesText(free + written))};
}

} // namespace tetra
