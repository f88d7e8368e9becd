// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/picture.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A PNG file of greys of 16 bits, as pngOf() makes one of colours; `greys` has width * height of them, row by row.
Result<std::vector<std::byte>> pngOfGreys(std::span<const std::uint16_t> greys, int width, int height,
                                          const PngFacts& facts = {});

/// The text of a keyword before the pixels of a PNG file, as UTF-8; empty if there is none, or if this is no PNG file.
/// Reads no pixels.
std::string textInPng(std::span<const std::byte> file, std::string_view keyword);

} // namespace tetra
