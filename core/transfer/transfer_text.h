// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

namespace tetra {

struct JsonValue;

/// As transferFunctionFromText(), of what is a part of another text.
Result<TransferFunction> transferFunctionFromJson(const JsonValue& root);

} // namespace tetra
