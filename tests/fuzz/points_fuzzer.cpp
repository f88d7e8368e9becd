// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of point tables with a line of what the user says, positions|values|+ to skip incomplete rows, and
// the table behind it.
#include "plugins/readers/points/point_reader.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    std::string_view text = asText(bytes, size);
    std::string_view line = takeUntil(text, '\n');
    ParameterValues values;
    values["positions"] = std::string(takeUntil(line, '|'));
    values["array"] = std::string(takeUntil(line, '|'));
    values["skip-incomplete"] = !line.empty();
    const auto path = folder.write("points.csv", asBytes(text));
    const PointReader reader;
    reader.score(path, asBytes(text.substr(0, 4096)));
    requireSound(reader.read(path, values, {}));
    return 0;
}
