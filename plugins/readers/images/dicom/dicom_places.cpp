// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/images/dicom/dicom_volumes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

/// What digits positions have in files, of a step and in millimetres.
double roundingOfPositions(double step)
{
    constexpr double relative = 2e-3, absolute = 6e-4, mostRelative = 0.02;
    return std::max(relative * step, std::min(absolute, mostRelative * step));
}

/// How far each point lies from where even steps would put it, at most.
double unevenness(std::span<const Eigen::Vector3d> slices, const Eigen::Vector3d& step)
{
    double largest = 0;
    for (std::size_t slice = 0; slice < slices.size(); ++slice)
        largest = std::max(largest, (slices[slice] - slices[0] - step * static_cast<double>(slice)).norm());
    return largest;
}

/// Where whole numbers of slices are missing between others that lie evenly: behind which (from 1), and how many.
/// Nothing if the distances are no multiples of one.
std::vector<std::pair<std::size_t, std::uint64_t>> gapsOf(const std::vector<double>& distances)
{
    std::vector<double> sorted = distances;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    const double usual = *middle;
    std::vector<std::pair<std::size_t, std::uint64_t>> gaps;
    for (std::size_t slice = 0; slice < distances.size(); ++slice) {
        const double times = std::round(distances[slice] / usual);
        if (!(times >= 1 && times < 1e6) ||
            std::abs(distances[slice] - times * usual) > times * 3 * roundingOfPositions(usual))
            return {};
        if (times > 1)
            gaps.emplace_back(slice + 1, static_cast<std::uint64_t>(times) - 1);
    }
    return gaps;
}

Message placeText(const Eigen::Vector3d& place)
{
    const auto digits = [](double number) { return formatNumber(std::round(number * 1e3) / 1e3 + 0.0); };
    return Message::say("(%1, %2, %3)", digits(place[0]), digits(place[1]), digits(place[2]));
}

/// What is said of slices that no even steps reach.
std::vector<Message> remarksOnGaps(std::span<const Eigen::Vector3d> slices)
{
    constexpr std::size_t mostTold = 5;
    std::vector<double> distances;
    for (std::size_t slice = 1; slice < slices.size(); ++slice)
        distances.push_back((slices[slice] - slices[slice - 1]).norm());
    const auto gaps = gapsOf(distances);
    if (gaps.empty()) {
        const auto [least, most] = std::ranges::minmax(distances);
        return {Message::say("Its slices are spaced unevenly, %1 to %2 mm apart; each was left where it lies.",
                             formatNumber(std::round(least * 1e4) / 1e4), formatNumber(std::round(most * 1e4) / 1e4))};
    }
    std::uint64_t missing = 0;
    for (const auto& gap : gaps)
        missing += gap.second;
    std::vector<Message> remarks = {
        missing == 1
            ? Message::say(
                  "1 slice is missing between the others. The gap stays, and values are interpolated across it.")
            : Message::say(
                  "%1 slices are missing between the others. The gaps stay, and values are interpolated across "
                  "them.",
                  missing)};
    for (std::size_t gap = 0; gap < std::min(gaps.size(), mostTold); ++gap) {
        const auto [slice, count] = gaps[gap];
        remarks.push_back(Message::say("Missing after slice %1, between %2 and %3: %4.", slice,
                                       placeText(slices[slice - 1]), placeText(slices[slice]), count));
    }
    return remarks;
}

/// The distance of slices that do not say where they lie, from one to the next, and where that was taken from.
std::optional<std::pair<double, Message>> guessedDistance(std::span<const DicomHeader> series,
                                                          const DicomVolume& volume)
{
    const auto frame = [&](std::size_t number) -> const DicomFrame& {
        return series[volume.pictures[number].file].frames[volume.pictures[number].frame];
    };
    const std::size_t last = volume.pictures.size() - 1;
    if (frame(0).height && frame(last).height && *frame(0).height != *frame(last).height)
        return std::pair((*frame(last).height - *frame(0).height) / static_cast<double>(last),
                         Message("SliceLocation"));
    if (frame(0).distance && *frame(0).distance != 0)
        return std::pair(*frame(0).distance, Message("SpacingBetweenSlices"));
    if (frame(0).thickness)
        return std::pair(*frame(0).thickness, Message("SliceThickness"));
    return std::nullopt;
}

/// The mean step, with the digits that it would have without the rounding of large coordinates.
Eigen::Vector3d stepOf(std::span<const Eigen::Vector3d> slices)
{
    constexpr double digits = 1e9, rounding = 1e-13;
    const Eigen::Vector3d step = (slices.back() - slices.front()) / static_cast<double>(slices.size() - 1);
    const double largest = std::max(slices.back().cwiseAbs().maxCoeff(), slices.front().cwiseAbs().maxCoeff());
    return step.unaryExpr([&](double part) {
        const double rounded = std::round(part * digits) / digits;
        return std::abs(rounded - part) <= rounding * largest ? rounded : part;
    });
}

/// Slices that each say where they lie.
void placeByPositions(std::vector<Eigen::Vector3d> slices, const std::array<Eigen::Vector3d, 2>& axes,
                      const Eigen::Vector2d& spacing, DicomPlaces& places)
{
    const Eigen::Vector3d step = stepOf(slices);
    Eigen::Matrix3d directions;
    directions << axes[0], axes[1], step.normalized();
    placeByDirections(places.lattice, directions, {spacing[0], spacing[1], step.norm()}, slices.front());
    if (unevenness(slices, step) <= roundingOfPositions(step.norm()))
        return;
    places.remarks = remarksOnGaps(slices);
    places.slices = std::move(slices);
}

} // namespace

DicomPlaces placesOf(std::span<const DicomHeader> series, const DicomVolume& volume)
{
    const DicomPicture& firstPicture = volume.pictures.front();
    const DicomHeader& header = series[firstPicture.file];
    const DicomFrame& first = header.frames[firstPicture.frame];
    DicomPlaces places;
    places.lattice.size = {static_cast<std::uint32_t>(header.columns), static_cast<std::uint32_t>(header.rows),
                           static_cast<std::uint32_t>(volume.pictures.size())};
    const auto axes =
        first.axes.value_or(std::array<Eigen::Vector3d, 2>{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()});
    const Eigen::Vector2d spacing = first.pixelSpacing.value_or(Eigen::Vector2d(1, 1));
    places.space = first.axes ? "LPS" : "";
    if (!header.areStacked && first.position) {
        std::vector<Eigen::Vector3d> slices;
        for (const DicomPicture& picture : volume.pictures)
            slices.push_back(*series[picture.file].frames[picture.frame].position);
        placeByPositions(std::move(slices), axes, spacing, places);
        places.untold = untoldPlacement(first.pixelSpacing.has_value(), true, true);
    } else {
        const auto distance = guessedDistance(series, volume);
        const double step = distance ? distance->first : 1;
        Eigen::Matrix3d directions;
        directions << axes[0], axes[1], axes[0].cross(axes[1]).normalized() * (step < 0 ? -1.0 : 1.0);
        placeByDirections(places.lattice, directions, {spacing[0], spacing[1], std::abs(step)},
                          first.position.value_or(Eigen::Vector3d(0, 0, 0)));
        places.untold =
            untoldPlacement(first.pixelSpacing && distance, first.position.has_value(), first.pixelSpacing || distance);
        if (distance)
            places.guess = Message::say("slices %1 mm apart (%2)", formatNumber(step), distance->second);
    }
    if (first.pixelSpacing && header.isImagerSpacing)
        places.guess = Message::say("pixels %1 x %2 mm, as at the detector (ImagerPixelSpacing)",
                                    formatNumber(spacing[0]), formatNumber(spacing[1]));
    if (!places.slices.empty() && !first.pixelSpacing) {
        places.untold.clear(); // positions are told in part, and no one spacing would do
        places.guess = Message::say("pixels 1 x 1 mm, because the file does not state their size");
    }
    if (std::ranges::find(places.untold, "unit") == places.untold.end())
        places.lengthUnit = "mm";
    return places;
}

std::vector<Eigen::Vector3d> positionsOf(const DicomPlaces& places)
{
    const Lattice& lattice = places.lattice;
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(lattice.pointCount());
    for (const Eigen::Vector3d& slice : places.slices)
        for (std::uint32_t j = 0; j < lattice.size[1]; ++j)
            for (std::uint32_t i = 0; i < lattice.size[0]; ++i)
                positions.push_back(slice + lattice.step(Eigen::Vector3d(i, j, 0)));
    return positions;
}

} // namespace tetra
