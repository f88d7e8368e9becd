// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <bit>
#include <cstddef>
#include <span>

namespace tetra {

/// Copies samples out of a file, one after the other as they stand there, and turns them into native byte order.
/// `encoded` and `samples` have the same size, a multiple of the sample's. Linear; cancellable.
Status copyRawSamples(std::span<const std::byte> encoded, SampleType type, std::endian order,
                      std::span<std::byte> samples, const Progress& progress);

/// Reverses the bytes of each sample unless `order` is the machine's own.
void toNativeOrder(std::span<std::byte> samples, SampleType type, std::endian order);

} // namespace tetra
