// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_function.h"

#include <string>
#include <string_view>

namespace tetra {

struct JsonValue;

/// A transfer function as a JSON text (R18), and back to the same bits:
///
///     {
///       "format": "tan-transfer-function",
///       "version": 1,
///       "unitDistance": 2.5,
///       "mask": {"least": 1, "largest": 6},
///       "points": [
///         {"value": 0, "colour": [0, 0.2, 1], "opacity": 0.02},
///         {"value": 7, "colour": [1, 1, 0.5], "opacity": 0.8, "group": 3}
///       ]
///     }
///
/// "format", "version" and "points" must be there; "unitDistance" is 1 if it is not, and there is no mask
/// and no group where none is written. A member of another name is an error, so that a slip of the pen is not taken for
/// nothing.
std::string transferFunctionToText(const TransferFunction& function);

/// The error says what is wrong and in which line and column.
Result<TransferFunction> transferFunctionFromText(std::string_view text);
Result<TransferFunction> transferFunctionFromJson(const JsonValue& root);

} // namespace tetra
