// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>

namespace tetra {

/// The size of a page of virtual memory, in bytes.
std::size_t pageSize() noexcept;

/// Physical memory that this process occupies now, mapped files included, in bytes; 0 if the system does not tell.
TAN_INTERNAL std::uint64_t residentBytes();

/// The most that it ever occupied, or since forgetPeakResidentBytes(), in bytes; 0 if the system does not tell.
TAN_INTERNAL std::uint64_t peakResidentBytes();

/// Gives memory that is not in use back to the system and lets peakResidentBytes() count from what is left. False if
/// the system does not allow that.
TAN_INTERNAL bool forgetPeakResidentBytes();

} // namespace tetra
