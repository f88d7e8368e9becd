// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/exchange.h"
#include "plugins/process/findings.h"
#include "plugins/process/reading_process.h"

#include <tan/base.h>

#include <functional>
#include <string>

namespace tetra {

/// The other end of askReadingProgram(): what the main function of a reading program does. Its process is limited
/// (process_limits.h) before anything is read; what the library prints goes nowhere. It may break down: the reader
/// bears that.

using TellProgress = std::function<void(double)>; ///< a fraction

/// Answers by an error that tells of `file` by name unless it names another.
using AnswerRequest = std::function<Result<ReadAnswer>(const TellProgress&)>;

/// What runReadingProgram() gives to the function that knows the request.
struct RequestInput {
    ExchangeInput& input;
    std::string file{}; ///< to be set: what errors name
};

/// Takes one request from the standard input by `take`, which reads it, says the file, and returns what answers it, and
/// writes the answer to the standard output. Lack of memory and exceptions of the library become errors by the name
/// `library`. Returns the exit code of the program.
int runReadingProgram(const std::string& library, const std::function<AnswerRequest(RequestInput&)>& take);

} // namespace tetra
