// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/data/dataset_part.h"

#include <cmath>
#include <vector>

namespace tetra {

namespace {

std::vector<std::string_view> entriesOf(std::string_view text)
{
    std::vector<std::string_view> entries;
    for (;;) {
        const auto end = text.find(',');
        entries.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return entries;
        text.remove_prefix(end + 1);
    }
}

} // namespace

std::string regionText(const DatasetPart& part)
{
    std::string text;
    if (part.region)
        for (const Eigen::Vector3d& corner : {Eigen::Vector3d(part.region->min()), Eigen::Vector3d(part.region->max())})
            for (const double number : corner)
                text += (text.empty() ? "" : ",") + formatNumber(number);
    return text;
}

std::string strideText(const DatasetPart& part)
{
    const auto& stride = part.stride;
    if (stride[0] == stride[1] && stride[1] == stride[2])
        return stride[0] == 1 ? std::string() : std::to_string(stride[0]);
    return std::to_string(stride[0]) + "," + std::to_string(stride[1]) + "," + std::to_string(stride[2]);
}

Result<std::optional<Eigen::AlignedBox3d>> parseRegion(std::string_view text)
{
    if (text.empty())
        return std::optional<Eigen::AlignedBox3d>();
    const auto wrong = [&](const std::string& what) {
        return Error{ErrorKind::WrongUsage, "The region '" + std::string(text) + "' " + what};
    };
    const auto entries = entriesOf(text);
    if (entries.size() != 6)
        return wrong("is not understood. Give six numbers separated by commas: the first corner's and the last one's, "
                     "as in 0,0,0,31,31,15.");
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < 6; ++i) {
        const auto number = parseNumber<double>(entries[i]);
        if (!number || !std::isfinite(*number))
            return wrong("holds '" + std::string(entries[i]) + "', which is no number.");
        numbers[i] = *number;
    }
    const Eigen::Vector3d first(numbers[0], numbers[1], numbers[2]);
    const Eigen::Vector3d last(numbers[3], numbers[4], numbers[5]);
    if ((first.array() > last.array()).any())
        return wrong("ends before it begins. Give the smaller numbers first.");
    return std::optional(Eigen::AlignedBox3d(first, last));
}

Result<std::array<std::uint32_t, 3>> parseStride(std::string_view text)
{
    std::array<std::uint32_t, 3> stride{1, 1, 1};
    if (text.empty())
        return stride;
    const auto entries = entriesOf(text);
    for (std::size_t axis = 0; axis < 3 && (entries.size() == 1 || entries.size() == 3); ++axis) {
        const auto number = parseNumber<std::uint32_t>(entries[entries.size() == 1 ? 0 : axis]);
        stride[axis] = number.value_or(0);
    }
    if ((entries.size() != 1 && entries.size() != 3) || stride[0] == 0 || stride[1] == 0 || stride[2] == 0)
        return Error{ErrorKind::WrongUsage, "The stride '" + std::string(text) +
                                                "' is not understood. Give one whole number from 1, or three "
                                                "separated by commas, as in 2,2,1."};
    return stride;
}

} // namespace tetra
