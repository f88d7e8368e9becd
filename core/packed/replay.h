// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/packed/packed_file.h"

#include <tan/packed.h>

#include <optional>

namespace tetra {

/// The first method (PackMethod::Replayed): the samples, in the order in which they became sites (FORMAT.md, "Packed
/// form"). These may throw std::bad_alloc.

/// Whether a model may be packed so, as far as its description tells: a lattice by refinement.
bool mayBeReplayed(const Model& model);

/// What of the progress it takes to find out.
constexpr double triedAt = 0.5;

/// Writes chunks and levels into `file`, which was created with the model; the caller finishes it. Nothing if the model
/// is not what its samples and its text make: then `file` is of no further use.
Result<std::optional<PackReport>> packReplayed(const Model& model, PackedFileWriter& file, const Progress& progress);

/// As unpackModel() and unpackPrefix().
Result<UnpackReport> unpackReplayed(const PackedFile& file, const std::filesystem::path& output,
                                    const Progress& progress);
Status unpackPrefixOfReplayed(const PackedFile& file, std::size_t level, const std::filesystem::path& output,
                              const Progress& progress);

/// Which sections of a model that was made again are not what they were when it was packed.
Result<UnpackReport> compareSections(const PackedFile& file, const std::filesystem::path& model);

} // namespace tetra
