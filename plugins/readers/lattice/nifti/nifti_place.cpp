// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nifti/nifti_place.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tetra {

namespace {

/// The distances of samples that the header tells; 1 for those that it does not.
Eigen::Vector3d distancesOf(const NiftiHeader& header)
{
    Eigen::Vector3d distances;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double distance = std::abs(header.pixdim[axis + 1]);
        distances[static_cast<Eigen::Index>(axis)] = distance > 0 && std::isfinite(distance) ? distance : 1;
    }
    return distances;
}

bool tellsDistances(const NiftiHeader& header)
{
    return std::ranges::any_of(std::span(header.pixdim).subspan(1, 3),
                               [](double distance) { return distance != 0 && std::isfinite(distance); });
}

/// The rotation of a quaternion of length 1 by its last three parts.
Eigen::Matrix3d rotationOf(Eigen::Vector3d parts)
{
    constexpr double least = 1e-7; // less than that is a rounding of half a turn
    double a = 1 - parts.squaredNorm();
    if (a < least) {
        parts.normalize();
        a = 0;
    } else {
        a = std::sqrt(a);
    }
    const double b = parts[0], c = parts[1], d = parts[2];
    Eigen::Matrix3d rotation;
    rotation << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), //
        2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b),         //
        2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - c * c - b * b;
    return rotation;
}

/// With as many digits as most headers have.
std::string numberText(double number)
{
    return formatNumber(static_cast<float>(number));
}

/// A lattice that the header describes; nothing if it leads nowhere.
std::optional<Lattice> usable(const Lattice& lattice)
{
    return checkLatticePlacement(lattice) ? std::optional(lattice) : std::nullopt;
}

std::optional<Lattice> bySform(const NiftiHeader& header, Lattice lattice)
{
    placeBySteps(lattice, header.sRows.leftCols<3>(), header.sRows.col(3));
    return usable(lattice);
}

std::optional<Lattice> byQform(const NiftiHeader& header, Lattice lattice)
{
    Eigen::Vector3d distances = distancesOf(header);
    distances[2] *= header.pixdim[0] < 0 ? -1 : 1; // qfac
    placeByDirections(lattice, rotationOf(header.quaternion), distances, header.qOffset);
    return usable(lattice);
}

MarkedText systemOf(std::int32_t code)
{
    constexpr std::array<MarkedText, 6> systems = {
        Message::marked("unknown"),      Message::marked("of the scanner"), Message::marked("aligned to another scan"),
        Message::marked("of Talairach"), Message::marked("of MNI 152"),     Message::marked("of a template")};
    return systems[code > 0 && code < static_cast<std::int32_t>(systems.size()) ? static_cast<std::size_t>(code) : 0];
}

/// How far the corners of one lattice lie from those of the other.
double distanceBetween(const Lattice& one, const Lattice& other)
{
    double largest = 0;
    for (const std::uint32_t i : {0u, one.size[0] - 1})
        for (const std::uint32_t j : {0u, one.size[1] - 1})
            for (const std::uint32_t k : {0u, one.size[2] - 1})
                largest = std::max(largest, (one.position(i, j, k) - other.position(i, j, k)).norm());
    return largest;
}

void tellOther(const Lattice& taken, const Lattice& other, StoredVolume& volume)
{
    constexpr double partOfStep = 0.01; // less is a rounding: quaternions are numbers of single precision
    const double distance = distanceBetween(taken, other);
    if (distance <= partOfStep * taken.spacing.minCoeff())
        return;
    const std::string far = numberText(distance);
    volume.leftOut.push_back(
        taken.isLeftHanded() != other.isLeftHanded()
            ? Message::say("Its qform would place it elsewhere, mirrored and up to %1 away; it was not used.", far)
            : Message::say("Its qform would place it elsewhere, up to %1 away; it was not used.", far));
}

/// Where the sform says other distances than pixdim, which programs that know no sform take.
void tellOtherDistances(const NiftiHeader& header, StoredVolume& volume)
{
    constexpr double partOfStep = 0.01;
    const Eigen::Vector3d told = distancesOf(header), taken = volume.lattice.spacing;
    if (tellsDistances(header) && ((told - taken).array().abs() > partOfStep * taken.array()).any())
        volume.leftOut.push_back(
            Message::say("Its pixdim states that samples are %1 x %2 x %3 apart, which was not used.",
                         numberText(told[0]), numberText(told[1]), numberText(told[2])));
}

void setUnit(const NiftiHeader& header, StoredVolume& volume)
{
    constexpr std::int32_t lengthBits = 7;
    constexpr std::array<const char*, 4> units = {"", "m", "mm", "um"};
    const auto unit = static_cast<std::size_t>(header.units & lengthBits);
    volume.lengthUnit = unit < units.size() ? units[unit] : "";
    if (header.version == NiftiVersion::Analyze)
        volume.lengthUnit = printable(header.unitName);
}

/// Neither form: along the axes of the file.
void placeByDistances(const NiftiHeader& header, StoredVolume& volume)
{
    placeBySteps(volume.lattice, distancesOf(header).asDiagonal(), Eigen::Vector3d::Zero());
    volume.taken.push_back({TakenPart::Frame, Message::say("distances alone (pixdim)"), true});
    volume.leftOut.push_back(Message::say(
        "Its header states neither where it lies nor which side of it is the left one: it has no sform and no qform."));
    volume.untold = untoldPlacement(tellsDistances(header), false, !volume.lengthUnit.empty());
}

/// Analyze 7.5 has distances alone; SPM writes the number of the sample that lies at the origin, from 1.
void placeAnalyze(const NiftiHeader& header, StoredVolume& volume)
{
    Eigen::Vector3d sample;
    bool isLikely = header.originator != std::array<std::int16_t, 3>{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto points = static_cast<double>(volume.lattice.size[axis]);
        const double number = header.originator[axis];
        isLikely = isLikely && number > -points && number < 2 * points; // other programs have other things there
        sample[static_cast<Eigen::Index>(axis)] = number - 1;
    }
    const Eigen::Vector3d distances = distancesOf(header);
    const Eigen::Vector3d origin =
        isLikely ? Eigen::Vector3d(-sample.cwiseProduct(distances)) : Eigen::Vector3d::Zero();
    placeBySteps(volume.lattice, distances.asDiagonal(), origin);
    volume.taken.push_back({TakenPart::Frame,
                            isLikely ? Message::say("distances, and the origin as SPM writes it")
                                     : Message::say("distances alone (pixdim)"),
                            true});
    volume.leftOut.push_back(Message::say("Its header, of Analyze 7.5, does not state which side of it is the left "
                                          "one. Convert it to NIfTI with a program that knows where it comes from."));
    if (header.orientation != 0)
        volume.leftOut.push_back(Message::say("Its code for the orientation, %1, was not used.", header.orientation));
    volume.untold = untoldPlacement(tellsDistances(header), isLikely, !volume.lengthUnit.empty());
}

} // namespace

void placeNifti(const NiftiHeader& header, StoredVolume& volume)
{
    setUnit(header, volume);
    if (header.version == NiftiVersion::Analyze)
        return placeAnalyze(header, volume);
    const auto sform = header.sformCode > 0 ? bySform(header, volume.lattice) : std::nullopt;
    const auto qform = header.qformCode > 0 ? byQform(header, volume.lattice) : std::nullopt;
    if (header.sformCode > 0 && !sform)
        volume.leftOut.push_back(Message::say(
            "Its sform is unusable (its steps lie in a plane, or are not finite numbers); it was not used."));
    if (header.qformCode > 0 && !qform)
        volume.leftOut.push_back(Message::say(
            "Its qform is unusable (its numbers are not finite, or too large or small); it was not used."));
    if (!sform && !qform)
        return placeByDistances(header, volume);
    volume.lattice = sform ? *sform : *qform;
    volume.space = "RAS";
    volume.taken.push_back({TakenPart::Frame, sform
                                                  ? Message::say("sform, coordinates %1", systemOf(header.sformCode))
                                                  : Message::say("qform, coordinates %1", systemOf(header.qformCode))});
    if (sform && qform)
        tellOther(*sform, *qform, volume);
    if (sform)
        tellOtherDistances(header, volume);
    volume.untold = untoldPlacement(true, true, !volume.lengthUnit.empty());
}

} // namespace tetra
