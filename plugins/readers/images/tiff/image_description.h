// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Pages of a TIFF file that follow each other in the order of their planes, as OME describes them.
struct OmePlanes {
    std::uint64_t firstPage = 0;
    std::uint64_t firstPlane = 0; ///< in PictureDescription's order
    std::uint64_t count = 0;      ///< 0: all the pages of the file
    std::string file{};           ///< a name in the same folder; empty: the file itself
};

/// What the text in a TIFF file says of its pages: one for each channel, slice and time.
struct PictureDescription {
    std::uint64_t channels = 1, slices = 1, times = 1;
    /// How many planes lie between one channel, slice or time and the next.
    std::uint64_t channelStep = 1, sliceStep = 1, timeStep = 1;
    std::array<std::optional<double>, 3> spacing{}; ///< along x, y, z
    std::string unit{};                             ///< of the spacing; empty if it is not said
    std::vector<std::string> channelNames{};        ///< none, or one of each channel
    std::optional<double> betweenTimes{};           ///< from one time to the next, in `timeUnit`
    std::string timeUnit{};
    std::vector<OmePlanes> planes{}; ///< of OME; else the first page is the first plane, and so on
    bool isImageJ = false;
    std::optional<double> offset{}; ///< ImageJ's: what is to be added to stored numbers
    bool hasCurve = false;          ///< ImageJ's: values are another function of the stored numbers
    std::string valueUnit{};
    std::vector<std::string> images{}; ///< OME's: the names of all volumes, of which one is described

    std::uint64_t planeCount() const { return channels * slices * times; }
    /// How long after the first one a time is, from 0, where that is known: 0.3 also as three times 0.1.
    double atTime(std::uint64_t time) const
    {
        constexpr double parts = 1e9;
        const double after = static_cast<double>(time) * betweenTimes.value_or(1);
        const double rounded = std::round(after * parts) / parts;
        return std::isfinite(rounded) ? rounded : after;
    }
    std::uint64_t plane(std::uint64_t channel, std::uint64_t slice, std::uint64_t time) const
    {
        return channel * channelStep + slice * sliceStep + time * timeStep;
    }
};

/// The most planes that a description may name.
inline constexpr std::uint64_t mostPlanes = std::uint64_t(1) << 26U;

bool isImageJDescription(std::string_view text);
bool isOmeDescription(std::string_view text);

/// ImageJ's "key=value" in lines. The pixels per unit along x and y stand elsewhere in the file, and where this text
/// names no unit, they may be of another one, inch or centimetre: then they are passed over. So is what makes no sense:
/// any text is understood.
PictureDescription imageJDescription(std::string_view text, const std::array<std::optional<double>, 2>& pixelsPerUnit,
                                     bool hasOtherUnit);

/// The OME-XML of one image (from 0). `file` is the name of the file in which it stands. The error says what is wrong
/// with "it". May throw std::bad_alloc.
Result<PictureDescription> omeDescription(std::string_view text, std::size_t image, std::string_view file);

/// A unit of length as it is shown: "µm" for all that means micrometre.
std::string lengthUnitText(std::string_view unit);

} // namespace tetra
