// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/disk_need.h"

#include "core/base/number_text.h"
#include "core/model/planned_model_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

/// Rounded up.
std::string sizeText(std::uint64_t bytes)
{
    const auto size = static_cast<double>(bytes);
    return bytes < 1'000'000'000 ? formatNumber(std::ceil(size / 1e6)) + " MB"
                                 : formatNumber(std::ceil(size / 1e8) / 10) + " GB";
}

} // namespace

DiskNeed diskNeed(const RunTotals& expected, SampleType type) noexcept
{
    constexpr std::uint64_t mostSites = std::numeric_limits<std::uint32_t>::max();
    const PlannedCounts counts{static_cast<std::uint32_t>(std::min(expected.sites, mostSites)), expected.tetrahedra};
    const std::uint64_t siteNumbers = expected.sites * sizeof(std::uint32_t);
    return {PlannedModelWriter::expectedBytes(counts, type, expected.points), expected.fileBytes + siteNumbers};
}

std::string textOf(const DiskNeed& need)
{
    return "model about " + sizeText(need.model) + ", work files " + sizeText(need.workFiles);
}

Status checkRoom(const DiskNeed& need, std::uint64_t written, std::uint64_t free, const std::filesystem::path& folder)
{
    if (need.total() <= written || need.total() - written <= free)
        return {};
    return Error{ErrorKind::CannotWrite, "The build needs about " + sizeText(need.total()) + " on the disk of '" +
                                             folder.string() + "' (" + textOf(need) + "), and " +
                                             sizeText(free + written) +
                                             " are free. Free some space, choose another disk or ask for a larger "
                                             "error."};
}

} // namespace tetra
