// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset_part.h"
#include "core/data/value_scale.h"
#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/model.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// How a dataset is opened, as far as there is a choice.
struct ImportOptions {
    std::optional<std::string> reader{}; ///< id; else the one that suits the file best
    ParameterValues values{};            ///< of the reader's parameters
    DatasetPart part{};                  ///< of what the reader gives
    ValueScale scale{};                  ///< of the values of that part
};

/// The names under which a model keeps, among its parameters, how its dataset was opened (core/history/FORMAT.md):
/// importPrefix and "reader", "region", "stride", "scale", or "value." and a parameter's id.
inline constexpr std::string_view importPrefix = "import.";

/// What a model keeps of them: nothing that is as it would be anyway.
std::vector<std::pair<std::string, std::string>> importTexts(const ImportOptions& options);

/// What importTexts() wrote into a model, of values those of the reader whose `parameters` these are. Errors
/// (WrongUsage): a text that does not fit.
Result<ImportOptions> importOf(const ModelDescription& description, const std::vector<Parameter>& parameters);

/// The reader that the model's dataset was opened by, if that was a choice.
std::optional<std::string> importReaderOf(const ModelDescription& description);

} // namespace tetra
