// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/transfer.h>

namespace tetra {

/// What errorRemarkText() and errorCureText() say, of a field of logarithms to base 10, too: values as they are typed,
/// log10(3e-5), and errors as factors.
TAN_INTERNAL Message errorRemarkText(const ErrorRemark& remark, bool ofLogarithms);
TAN_INTERNAL Message errorCureText(const ErrorRemark& remark, const TransferLimits& range, bool ofLogarithms);

} // namespace tetra
