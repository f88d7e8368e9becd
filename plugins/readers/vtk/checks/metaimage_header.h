// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The header of a MetaImage. The format: https://itk.org/Wiki/ITK/MetaIO/Documentation; where its library goes other
/// ways, as the library does.

inline constexpr std::string_view metaBlanks = " \t\r\n\v\f";

std::string_view strippedOfBlanks(std::string_view text);
std::vector<std::string> metaWords(std::string_view text);

/// The fields up to ElementDataFile, and where what follows begins.
struct MetaHeader {
    std::map<std::string, std::string, std::less<>> fields;
    std::size_t end = 0;

    std::string_view text(std::string_view name) const;
    bool isTrue(std::string_view name) const;
};

/// The error says that the last line is missing.
Result<MetaHeader> metaHeaderOf(std::string_view bytes);

/// Where a MetaImage of three dimensions lies, all but its size, in coordinates of ITK's convention: to the left, to
/// the back and to the head.
struct MetaPlace {
    Lattice lattice;
    std::string space = "LPS";
    std::string lengthUnit{}; ///< "um", "mm" or "cm", which are all that the format knows; empty if it does not say
    std::vector<std::string> untold{}; ///< FileContents::untold
    std::vector<Message> remarks{};
};

/// By ElementSpacing or ElementSize, TransformMatrix, whose rows are the directions of the axes, and Offset; or by the
/// other names that they have (Orientation, Rotation; Position, Origin). What is not there: spacing 1, along the axes,
/// origin 0. AnatomicalOrientation adds nothing to that; a remark says where it contradicts it. Nothing for images of
/// other dimensions. Errors: fields with too few numbers.
Result<std::optional<MetaPlace>> metaImagePlace(const MetaHeader& header);
Result<std::optional<MetaPlace>> metaImagePlace(const std::filesystem::path& path);

} // namespace tetra
