// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <hdf5.h>

namespace tetra {

inline constexpr H5Z_filter_t lzfFilter = 32000; ///< of h5py, read by lzf_filter.h

/// An error (BadInput) that names the first filter of an array's creation properties that the library does not bring
/// and that is none of ours; `array` is the array's path.
Status checkFilters(hid_t creation, const std::string& array);

} // namespace tetra
