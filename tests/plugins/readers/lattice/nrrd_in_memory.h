// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd_fields.h"
#include "plugins/readers/lattice/nrrd_layout.h"
#include "plugins/readers/lattice/sample_reading.h"

#include <tan/data.h>

#include <span>
#include <string_view>

namespace tetra {

/// What the reader does with a file, without the file: for tests that read millions of them.
inline Result<Dataset> readNrrdInMemory(std::string_view file)
{
    const Result<NrrdFields> fields = parseNrrdFields(file);
    if (!fields)
        return fields.error();
    const Result<NrrdLayout> layout = nrrdLayout(*fields);
    if (!layout)
        return layout.error();
    const auto data = std::as_bytes(std::span(file)).subspan(fields->headerBytes);
    const Result<ScalarField> values = readSamples(data, layout->samples, {});
    if (!values)
        return values.error();
    return withHoles(Dataset{.lattice = layout->samples.lattice, .values = *values, .source = {}});
}

} // namespace tetra
