// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QJsonObject>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// What an axis of an array is for.
struct ZarrAxis {
    enum class Kind : std::uint8_t { Space, Time, Channel, Other };
    Kind kind = Kind::Other;
    std::string name{}; ///< empty if it has none
    std::string unit{};
};

/// An axis of this name, as far as that tells what it is for.
ZarrAxis zarrAxisOfName(const std::string& name);

/// An array of an OME-Zarr image.
struct OmeLevel {
    std::string path;                           ///< from the folder that was opened
    std::string name;                           ///< as the image names it
    std::vector<double> scale{}, translation{}; ///< one an axis; empty if the image does not say where it lies
};

/// An image in several levels of detail, the finest first (OME-NGFF).
struct OmeImage {
    std::string path; ///< of its group
    std::vector<ZarrAxis> axes;
    std::vector<OmeLevel> levels;            ///< at least one
    std::vector<std::string> channelNames{}; ///< as far as it names them
    std::vector<Message> leftOut{};
};

/// Whether a group with these attributes is an image.
bool isOmeImage(const QJsonObject& attributes);

/// The image that a group is. Errors, sentences about "it": what is missing, contradicts itself, or is not read.
Result<OmeImage> omeImage(const std::string& path, const QJsonObject& attributes);

/// A unit of length by its name in UDUNITS: how it is shown, and how many metres it has (0: not known).
struct LengthUnit {
    std::string shown;
    double metres = 0;
};
LengthUnit lengthUnitOf(std::string_view name);

} // namespace tetra
