// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace tetra {

struct ModelDescription;

/// What a model's values are called: the array that it was built of, else the dataset.
QString fieldName(const ModelDescription& description);

} // namespace tetra
