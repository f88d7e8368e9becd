// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace tetra {

/// Whether all elements of a DICOM file up to its pixels lie in it: GDCM, as Debian builds it, ends the program where
/// one does not. What is no DICOM file is none; of deflated ones only the beginning is looked at.
bool hasWholeElements(std::string_view bytes);

} // namespace tetra
