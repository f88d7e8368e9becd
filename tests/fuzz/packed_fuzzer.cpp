// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for a packed model, with checksums made right where there is room for them: opens it, makes a
// prefix and the whole.
#include "tests/core/packed/packed_checksums.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

#include <tan/packed.h>

#include <vector>

namespace tetra {
namespace {

/// Larger ones only take time and memory: as much as their header says.
constexpr std::uint64_t mostPoints = 4096;

void unpackAll(const PackedModel& packed, const FuzzFolder& folder)
{
    for (const std::size_t level : {std::size_t(0), packed.levels().size() - 1}) {
        const Status made = unpackPrefix(packed, level, folder.path() / "prefix.tan");
        if (!made)
            requireText(made.error());
        else
            require(Model::open(folder.path() / "prefix.tan").ok(), "a prefix can be opened");
    }
    const auto unpacked = unpackModel(packed, folder.path() / "model.tan");
    if (!unpacked)
        requireText(unpacked.error());
    else
        require(Model::open(folder.path() / "model.tan").ok(), "what was unpacked can be opened");
}

} // namespace
} // namespace tetra

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const auto given = std::as_bytes(std::span(bytes, size));
    std::vector<std::byte> file(given.begin(), given.end());
    repairPackedChecksums(file);
    const auto packed = PackedModel::open(folder.write("packed.tan", file));
    if (!packed)
        requireText(packed.error());
    else if ((*packed)->description().lattice.pointCount() <= mostPoints)
        unpackAll(**packed, folder);
    return 0;
}
