// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/packed/packed_file.h"

#include <tan/packed.h>

namespace tetra {

/// The second method (PackMethod::StoredByParts): each array of a model by itself, cut where levels end (FORMAT.md,
/// "Packed form"). For every model. These may throw std::bad_alloc.

/// Writes chunks and levels into `file`, which was created with the model; the caller finishes it. The bytes by part;
/// fileBytes is the caller's.
Result<PackReport> packParts(const Model& model, PackedFileWriter& file, const Progress& progress);

/// Writes the model, byte for byte, to `output`.
Result<UnpackReport> unpackParts(const PackedFile& file, const std::filesystem::path& output, const Progress& progress);

/// Writes a model of the meshes up to `level`, which is below the number of levels.
Status unpackPrefixOfParts(const PackedFile& file, std::size_t level, const std::filesystem::path& output,
                           const Progress& progress);

} // namespace tetra
