// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/byte_source.h"
#include "core/history/file_layout.h"
#include "core/history/format.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// What the beginning of a `.tan` file tells: with files of format 1.3 that have a level index, one request to a server
/// (FORMAT.md).
struct ModelFront {
    FileLayout layout;
    ModelDescription description;
    std::vector<format::LevelEntry> levels; ///< empty: the file does not tell
};

/// `name`: the file, or its address, for messages. Nothing of the file is trusted: sizes are bounded by the source's,
/// and index and text are checked against their checksums. Errors: the source's, no model, damaged, made by a later
/// version. May throw std::bad_alloc, as do all of these.
Result<ModelFront> readFront(const ByteSource& source, const std::string& name, const Progress& progress = {});

/// The first sites of a model, which end a batch.
struct PrefixEnd {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< that they created
    float key = 0;                ///< of their mesh
};

/// The prefix of the first level that is at least as accurate as asked; the whole if none is, or if there is no index.
PrefixEnd prefixFor(const ModelFront& front, const Accuracy& accuracy);
/// That of the finest level whose prefix takes at most so many bytes of the source; the coarsest if none does.
PrefixEnd prefixWithin(const ModelFront& front, std::uint64_t bytes);
/// Likewise of a model on this disk, to a batch.
PrefixEnd prefixFor(const Model& model, const Accuracy& accuracy);

/// What is read of the file for a prefix, in the order of the places: the beginning of each array, up to the end of a
/// chunk, with the chunks' checksums; whole arrays if the file has none of these; all of it if all sites are wanted.
std::vector<ByteRange> prefixRanges(const ModelFront& front, const PrefixEnd& end);

/// Writes the first sites, their tetrahedra and what follows from them as a `.tan` file of its own: its meshes are
/// those of the original up to there. Tetrahedra that later sites destroy live for ever; all samples (23) are left out
/// unless the whole is taken, which is then the same file byte for byte. All ranges are announced to the source at
/// once. What is read is checked: by its checksums, and that every number lies where it can. Memory: 8 bytes a site,
/// those of writeDerivedSections(), and for grids 24 a site besides. Errors: the source's, damage, those of writing,
/// cancelled; then there is no file.
Status copyPrefix(const ByteSource& source, const std::string& name, const ModelFront& front, const PrefixEnd& end,
                  const std::filesystem::path& output, const Progress& progress = {});

} // namespace tetra
