// SPDX-License-Identifier: GPL-3.0-or-later
// The program in which VTK reads a file for the plugin: takes one request from its input and writes messages to its
// output (plugins/readers/vtk/vtk_exchange.h). It may break down: the plugin bears that.
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/vtk/checks/file_check.h"
#include "plugins/readers/vtk/helper/contents.h"
#include "plugins/readers/vtk/helper/findings.h"
#include "plugins/readers/vtk/helper/running.h"
#include "plugins/readers/vtk/process_limits.h"
#include "plugins/readers/vtk/vtk_exchange.h"

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

template <class Value> void send(ExchangeOutput& output, VtkMessage message, Value value)
{
    exchange(output, message);
    exchange(output, value);
}

Error inFile(const VtkRequest& request, const Error& error)
{
    if (!error.file.empty())
        return error;
    return {error.kind, Message::say("Cannot read '%1': %2", request.path, error.message), request.path};
}

Result<FileContents> lookInto(const VtkSource& source, const VtkRequest& request, const VtkLog& log,
                              const std::function<void(double)>& progress)
{
    if (source.knowsContents) {
        source.reader->UpdateInformation();
        if (const Status done = statusOf(log); !done)
            return done.error();
        if (auto contents = contentsFromInformation(*source.reader)) {
            contents->timeSteps = timesOf(*source.reader);
            source.finishContents(*contents);
            contents->untold = source.untold;
            return *contents;
        }
    }
    const auto data = runSource(source, request.timeStep, log, progress);
    if (!data)
        return data.error();
    FileContents contents = contentsOf(leavesOf(**data), request.part);
    contents.timeSteps = timesOf(*source.reader);
    source.finishContents(contents);
    contents.untold = source.untold;
    return contents;
}

Result<VtkFindings> find(const VtkSource& source, const VtkRequest& request, const VtkLog& log,
                         const std::function<void(double)>& progress)
{
    const auto data = runSource(source, request.timeStep, log, progress);
    if (!data)
        return data.error();
    auto found = findingsOf(leavesOf(**data), request);
    if (!found)
        return found.error();
    if (const Status done = statusOf(log); !done)
        return done.error();
    source.finish(*found);
    found->untold = source.untold;
    for (std::size_t warning = 0; warning < std::min<std::size_t>(2, log.warnings.size()); ++warning)
        found->remarks.push_back(Message::say("VTK says: %1", log.warnings[warning]));
    if (const std::size_t steps = timesOf(*source.reader).size(); steps > 1)
        found->remarks.push_back(
            Message::say("Time step %1 of %2. Choose another one with 'time'.", request.timeStep, steps));
    return found;
}

void answer(const VtkRequest& request, const VtkLog& log, ExchangeOutput& output)
try {
    const auto progress = [&](double fraction) { send(output, VtkMessage::Progress, fraction); };
    const auto checked = checkBeforeVtk(request);
    if (!checked) {
        send(output, VtkMessage::Error, inFile(request, checked.error()));
        return;
    }
    limitWork(limitsFor(checked->bytes, checked->unpackedBytes, physicalBytes()));
    const auto source = makeSource(request);
    if (!source) {
        send(output, VtkMessage::Error, inFile(request, source.error()));
    } else if (const Status fits = checkUntold(request.given, source->untold); !fits) {
        send(output, VtkMessage::Error, inFile(request, fits.error()));
    } else if (request.contentsOnly) {
        const auto contents = lookInto(*source, request, log, progress);
        contents ? send(output, VtkMessage::Contents, *contents)
                 : send(output, VtkMessage::Error, inFile(request, contents.error()));
    } else {
        auto found = find(*source, request, log, progress);
        if (found)
            found->remarks.insert(found->remarks.begin(), checked->remarks.begin(), checked->remarks.end());
        found ? send(output, VtkMessage::Findings, *std::move(found))
              : send(output, VtkMessage::Error, inFile(request, found.error()));
    }
} catch (const std::bad_alloc&) {
    send(output, VtkMessage::Error, inFile(request, memoryLimitMet()));
} catch (const std::length_error&) {
    send(output, VtkMessage::Error,
         inFile(request, {ErrorKind::BadInput,
                          Message::say("it says that it holds more than any machine can. It is damaged.")}));
} catch (const std::exception& problem) {
    send(output, VtkMessage::Error,
         inFile(request, {ErrorKind::BadInput, Message::say("VTK says: %1. It is damaged.", problem.what())}));
}

int run()
{
    limitThisProcess();
    const int descriptor = takeStandardOutput();
    ExchangeInput input(readAll);
    VtkRequest request;
    exchange(input, request);
    if (descriptor < 0 || !input.good())
        return 2;
    VtkLog log;
    sendVtkMessagesTo(log);
    ExchangeOutput output([=](const void* data, std::size_t bytes) { return writeAll(descriptor, data, bytes); });
    answer(request, log, output);
    close(descriptor);
    _exit(output.good() ? 0 : 1); // VTK's own tidying up has been seen to crash
}

} // namespace
} // namespace tetra

int main()
{
    return tetra::run();
}
