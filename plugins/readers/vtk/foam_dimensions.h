// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tetra {

/// The unit of an OpenFOAM field by its entry "dimensions [0 2 -2 0 0 0 0]", the powers of kg, m, s, K, mol, A and cd:
/// "m^2/s^2". Empty without such an entry, or of a quantity without a unit. A unit that the entry names, "[m^2 s^-2]",
/// is taken as it stands. `text`: how the file begins.
std::string foamUnit(std::string_view text);

/// The same of a file, which may be packed by gzip; empty if it cannot be read. No more than its beginning is looked
/// at. Any thread.
std::string foamUnitOfFile(const std::filesystem::path& path);

} // namespace tetra
