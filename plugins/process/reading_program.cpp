// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/process/reading_program.h"

#include "plugins/process/process_limits.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <unistd.h>

namespace tetra {
namespace {

bool writeAll(int output, const void* data, std::size_t bytes)
{
    constexpr std::size_t most = std::size_t(1) << 30; // a call of write() takes no more than 2 GB
    for (const char* place = static_cast<const char*>(data); bytes > 0;) {
        const ssize_t written = write(output, place, std::min(bytes, most));
        if (written <= 0)
            return false;
        place += written;
        bytes -= static_cast<std::size_t>(written);
    }
    return true;
}

bool readAll(void* data, std::size_t bytes)
{
    for (char* place = static_cast<char*>(data); bytes > 0;) {
        const ssize_t count = read(STDIN_FILENO, place, bytes);
        if (count <= 0)
            return false;
        place += count;
        bytes -= static_cast<std::size_t>(count);
    }
    return true;
}

template <class Value> void send(ExchangeOutput& output, ProcessMessage message, Value value)
{
    exchange(output, message);
    exchange(output, value);
}

Error inFile(const std::string& file, const Error& error)
{
    if (!error.file.empty())
        return error;
    return {error.kind, Message::say("Cannot read '%1': %2", file, error.message), file};
}

Result<ReadAnswer> answerOf(const AnswerRequest& answer, const std::string& library, const TellProgress& progress)
try {
    return answer(progress);
} catch (const std::bad_alloc&) {
    return memoryLimitMet(library);
} catch (const std::length_error&) {
    return Error{ErrorKind::BadInput, Message::say("it claims to hold more than any machine can. It is damaged.")};
} catch (const std::exception& problem) {
    return Error{ErrorKind::BadInput, Message::say("%1 says: %2. It cannot be read.", library, problem.what())};
}

} // namespace

int runReadingProgram(const std::string& library, const std::function<AnswerRequest(RequestInput&)>& take)
{
    limitThisProcess();
    const int descriptor = takeStandardOutput();
    ExchangeInput input(readAll);
    RequestInput request{input};
    const AnswerRequest answer = take(request);
    if (descriptor < 0 || !input.good())
        return 2;
    ExchangeOutput output([=](const void* data, std::size_t bytes) { return writeAll(descriptor, data, bytes); });
    auto answered =
        answerOf(answer, library, [&](double fraction) { send(output, ProcessMessage::Progress, fraction); });
    if (!answered)
        send(output, ProcessMessage::Error, inFile(request.file, answered.error()));
    else if (auto* findings = std::get_if<FileFindings>(&*answered))
        send(output, ProcessMessage::Findings, std::move(*findings));
    else
        send(output, ProcessMessage::Contents, std::get<FileContents>(std::move(*answered)));
    close(descriptor);
    return output.good() ? 0 : 1;
}

} // namespace tetra
