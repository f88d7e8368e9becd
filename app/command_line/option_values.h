// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"

#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace tetra {

/// The number that an option has, or `byDefault`. Errors (WrongUsage) name the option and its bounds.
Result<double> numberOption(const Arguments& arguments, std::string_view name, double byDefault, double least,
                            double most);
Result<std::int64_t> wholeNumberOption(const Arguments& arguments, std::string_view name, std::int64_t byDefault,
                                       std::int64_t least, std::int64_t most);

/// Numbers separated by commas: "4,3,.5".
Result<std::vector<double>> parseNumbers(std::string_view option, std::string_view text, double least, double most);

/// A limit on error or warping, in %: anyError (which is anyWarping) for "none".
Result<double> limitOption(const Arguments& arguments, std::string_view name, double byDefault);

/// The inverse, rounded: "none" for what is no limit.
std::string limitText(double percent);
/// One number that limits both, or the pair: "1:5".
std::string levelText(const Accuracy& level);

/// --error and --warping, the accuracy of a query in % of the value range and of the diagonal.
Option errorOption();
Option warpingOption();
/// An error (WrongUsage) if --warping is given and the model's data cannot warp.
Status checkWarpingOption(const Arguments& arguments, const Model& model);
Status checkWarpingOption(const Arguments& arguments, const ModelDescription& model, const std::string& place);
Result<Accuracy> accuracyOption(const Arguments& arguments);

/// The arguments with every "2.5sd" that begins a value of the option's list (separated by commas; what follows a colon
/// says something else) replaced by the value of the model's data that it is; `told` gets a sentence for each. Errors
/// as of statisticsOf() the model.
Result<Arguments> withValuesOfData(Arguments arguments, std::string_view option, const Model& model,
                                   const Progress& progress, std::vector<Message>& told);

/// --lod, the levels of detail to tell of: errors, or pairs; with --warping all errors have that one.
Option levelsOption();
Result<std::vector<Accuracy>> levelsOf(const Arguments& arguments);

/// --threads, the most to use; 0 without it.
Option threadsOption();
Result<int> threadsOf(const Arguments& arguments);

/// --output, -o.
Option outputOption(std::string placeholder, std::string explanation, bool required = true);

} // namespace tetra
