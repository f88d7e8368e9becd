// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"

#include <memory>
#include <optional>
#include <vector>

namespace tetra {

/// What is asked of a builder before it builds. It outlives the question.
struct BuildQuestion {
    const Builder* builder = nullptr;
    std::shared_ptr<const Dataset> dataset;
    BuildSize size{};
    ParameterValues values{};
    std::vector<ParameterValues> others{}; ///< each in place of those values
};

/// What it says to that.
struct BuildOutlook {
    std::optional<BuildEstimate> estimate{};
    std::vector<std::optional<BuildEstimate>> others{}; ///< with the other values
    bool resumes = false;
};

/// Asks in this thread; an outside plugin may take its time.
BuildOutlook outlookOf(const BuildQuestion& question);

} // namespace tetra
