// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// An error (WrongUsage) if `values` holds something that `parameters` does not describe, or of another type.
/// `owner` is whose parameters they are: "reader 'lattice'".
Status checkParameterValues(const Message& owner, const std::vector<Parameter>& parameters,
                            const ParameterValues& values);

/// The option of the command line that sets a parameter.
using OptionOfParameter = std::function<std::string(const Parameter&)>;

/// The values, with what conditions of parameters may ask of a dataset (domainId).
ParameterValues withDomain(ParameterValues values, const Dataset& dataset);

/// The values that make a difference to this dataset, with the defaults of those that `values` lacks, as texts: what a
/// model keeps of how it was built.
std::vector<std::pair<std::string, std::string>> usedTexts(const std::vector<Parameter>& parameters,
                                                           const ParameterValues& values, const Dataset& dataset);

/// An error (WrongUsage) if `values` holds something that makes no difference to this dataset beside the others: what
/// is asked for in vain is not asked for by somebody who knows that. Where parameters are options, `optionOf` gives
/// their names, "--no-outline" for a truth value that is true by default; else they are called by their ids.
Status checkOfUse(const std::vector<Parameter>& parameters, const ParameterValues& values, const Dataset& dataset,
                  const OptionOfParameter& optionOf = {});

/// The same where no dataset is asked for: what only some domains have counts as used.
Status checkOfUse(const std::vector<Parameter>& parameters, const ParameterValues& values,
                  const OptionOfParameter& optionOf = {});

} // namespace tetra
