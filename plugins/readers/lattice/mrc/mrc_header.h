// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// The header of an MRC or CCP4 map, 1,024 bytes, as it stands there. The format, with the same names:
/// https://www.ccpem.ac.uk/mrc_format/mrc2014.php. Arrays of three are of columns, rows and sections where the format
/// says so (size, start, axes), else of x, y and z.
struct MrcHeader {
    std::endian order = std::endian::little;
    bool isOrderGuessed = false;        ///< the stamp of the machine does not say it, or contradicts the other numbers
    std::array<std::int32_t, 3> size{}; ///< NX, NY, NZ
    std::int32_t mode = 0;
    std::array<std::int32_t, 3> start{}; ///< NXSTART ...
    std::array<std::int32_t, 3> grid{};  ///< MX, MY, MZ: how many steps the cell has
    std::array<double, 3> cell{};        ///< CELLA, lengths in angstrom
    std::array<double, 3> angles{};      ///< CELLB, in degrees
    std::array<std::int32_t, 3> axes{};  ///< MAPC, MAPR, MAPS: 1 is x
    double least = 0, most = 0;          ///< DMIN, DMAX
    std::int32_t spaceGroup = 0;         ///< ISPG
    std::int32_t extensionBytes = 0;     ///< NSYMBT
    std::int32_t skew = 0;               ///< LSKFLG of CCP4: 1 if a matrix turns the map
    std::array<double, 3> origin{};      ///< ORIGIN, in angstrom
    bool isOfImod = false;
    std::int32_t imodFlags = 0;
};

inline constexpr std::size_t mrcHeaderBytes = 1024;

/// Whether the stamp 'MAP' is where maps have it.
bool looksLikeMrc(std::span<const std::byte> firstBytes);

/// The header at the beginning of a file. The byte order is the one in which its numbers make sense; if both do, or
/// none, the one that the machine stamp says. Errors: the file is shorter.
Result<MrcHeader> parseMrcHeader(std::span<const std::byte> file);

} // namespace tetra
