// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of raw volumes with a line of what the user says of the file, fields separated by '|', and the file
// behind it; and, where the line is not that, with the lines up to an empty one as a detached NRRD header.
#include "core/base/text.h"
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

#include <array>

namespace tetra {
namespace {

constexpr std::array<const char*, 6> words = {"size", "type", "byte-order", "spacing", "origin", "unit"};

void readDetached(const LatticeReader& reader, const FuzzFolder& folder, std::string_view text)
{
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    folder.write("samples.raw", asBytes(text.substr(std::min(end + 2, text.size()))));
    requireSound(reader.read(folder.write("volume.nhdr", asBytes(text.substr(0, end))), {}, {}));
}

} // namespace
} // namespace tetra

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const LatticeReader reader;
    std::string_view text = asText(bytes, size);
    if (text.starts_with("NRRD")) {
        readDetached(reader, folder, text);
        return 0;
    }
    std::string_view line = takeUntil(text, '\n');
    ParameterValues values;
    for (const char* word : words)
        values[word] = std::string(takeUntil(line, '|'));
    values["skip"] = parseNumber<std::int64_t>(line).value_or(0);
    requireSound(reader.read(folder.write("volume.raw", asBytes(text)), values, {}));
    return 0;
}
