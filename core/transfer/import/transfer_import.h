// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_editing.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// What a file of colours or opacities alone is completed with, and where presets without values of their own go.
struct ImportSurroundings {
    TransferFunction present{};
    std::optional<TransferLimits> limits{}; ///< presets from 0 to 1 are spread over these; none: they stay
};

/// A transfer function of a file and what it is called there.
struct ImportedTransfer {
    std::string name; ///< may be empty
    TransferFunction function;
    bool coloursOnly = false; ///< the opacities are those of `present`
};

/// The transfer functions of a file, one or more: one of ours (transfer_text.h), or ParaView's presets, JSON or XML
/// (presets.h).
Result<std::vector<ImportedTransfer>> importTransferFunctions(std::string_view text,
                                                              const ImportSurroundings& surroundings);

/// A file for ParaView that looks as the function does.
std::string transferFunctionToParaview(const TransferFunction& function, const std::string& name);

} // namespace tetra
