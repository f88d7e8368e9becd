// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/shown_mesh.h"

#include <tan/data.h>
#include <tan/model.h>

#include <QString>

namespace tetra {

// What is told of a model of logarithms (core/data/value_scale.h): its errors are factors, and its values those of the
// data, by the user's locale.

/// factorNumber() as the user writes numbers.
QString factorNumber(double percent, const ValueRange& logarithms);
/// The same in a sentence: "a factor of 1.26".
QString factorWords(double percent, const ValueRange& logarithms);

/// The value that this is the logarithm of, with enough digits to tell values apart among those of this range.
QString antilogarithmText(double logarithm, const ValueRange& logarithms);

/// A value of a model as its data have it: itself, or what it is the logarithm of.
QString dataValueText(double value, const ModelDescription& model);
/// Likewise an end of the model's range, as numberInRange() tells it.
QString rangeEndText(double end, const ModelDescription& model);

} // namespace tetra
