// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset_part.h"
#include "core/data/sample_slice.h"
#include "plugins/api/parameter.h"
#include "plugins/host/build_estimate.h"

#include <tan/data.h>

#include <QString>

#include <cstdint>
#include <optional>

namespace tetra {

/// A sentence that says whether something is as it should be.
struct ImportCheck {
    bool fits = false;
    QString text;
};

/// The layout that the parameters "size", "type", "byte-order" and "skip" describe; nothing if the size is not three
/// numbers of at least 2.
std::optional<StoredSamples> storedSamplesOf(const ParameterValues& values);

/// "32 × 32 × 32 × uint8 = 32,768 bytes; the file has 32,768."
ImportCheck checkRawSize(const StoredSamples& samples, std::uint64_t fileBytes);

/// "32 × 32 × 32, uint8": a suggestion of a reader.
QString suggestionText(const ParameterValues& suggestion);

/// How many points of the grid the part takes, or what is wrong with it.
ImportCheck countPart(const Lattice& lattice, const DatasetPart& part);

/// Those of the machine.
unsigned usableThreads();

/// What a build takes: "up to" as long as nothing is known of the data but their size, else "about".
QString estimateText(const BuildSize& size, const BuildEstimate& estimate);
/// "426 MiB, 2 min": the model and the time that it takes.
QString modelSizeText(const BuildEstimate& estimate);

} // namespace tetra
