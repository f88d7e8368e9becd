// SPDX-License-Identifier: GPL-3.0-or-later
// The program in which VTK reads a file for the plugin: takes one request from its input and writes messages to its
// output (plugins/process/exchange.h). It may break down: the plugin bears that.
#include "plugins/api/placement_parameters.h"
#include "plugins/process/process_limits.h"
#include "plugins/process/reading_program.h"
#include "plugins/readers/vtk/checks/file_check.h"
#include "plugins/readers/vtk/helper/contents.h"
#include "plugins/readers/vtk/helper/findings.h"
#include "plugins/readers/vtk/helper/running.h"
#include "plugins/readers/vtk/helper/series_source.h"
#include "plugins/readers/vtk/unwritten_memory.h"

#include <unistd.h>

namespace tetra {
namespace {

/// Provenance as far as it is that of the file as a whole.
void tellOfFile(const VtkSource& source, const VtkRequest& request, std::vector<Taken>& taken,
                std::vector<Message>& leftOut)
{
    Provenance provenance{std::move(taken), std::move(leftOut)};
    source.tell(provenance);
    tellTimeStep(timesOf(source), request, source.stepFile, provenance);
    taken = std::move(provenance.taken);
    leftOut = std::move(provenance.leftOut);
}

FileContents finished(FileContents contents, const VtkSource& source, const VtkRequest& request)
{
    contents.timeSteps = timesOf(source);
    source.finishContents(contents);
    contents.untold = source.untold;
    tellOfFile(source, request, contents.taken, contents.leftOut);
    return contents;
}

/// What the information of the reader, or the headers of the file, tell; nothing if that takes the data.
std::optional<FileContents> contentsWithoutData(const VtkSource& source, const VtkRequest& request)
{
    auto contents = source.contentsOfHeaders(request);
    if (!contents && !source.knowsContents)
        return std::nullopt;
    source.reader->UpdateInformation(); // it knows the times, too
    return contents ? std::move(contents) : contentsFromInformation(*source.reader, request);
}

Result<FileContents> lookInto(const VtkSource& source, const VtkRequest& request, const VtkLog& log,
                              const TellProgress& progress)
{
    auto told = contentsWithoutData(source, request);
    if (const Status done = statusOf(log); !done)
        return done.error();
    if (told)
        return finished(*std::move(told), source, request);
    const auto data = runSource(source, request, log, progress);
    if (!data)
        return data.error();
    source.refine(**data);
    return finished(contentsOf(leavesOf(**data), request), source, request);
}

Result<VtkFindings> find(const VtkSource& source, const VtkRequest& request, const VtkLog& log,
                         const TellProgress& progress)
{
    const auto data = runSource(source, request, log, progress);
    if (!data)
        return data.error();
    source.refine(**data);
    auto found = findingsOf(leavesOf(**data), request);
    if (!found)
        return found.error();
    if (const Status done = statusOf(log); !done)
        return done.error();
    source.finish(*found);
    found->untold = source.untold;
    tellOfFile(source, request, found->taken, found->leftOut);
    for (std::size_t warning = 0; warning < std::min<std::size_t>(2, log.warnings.size()); ++warning)
        found->remarks.push_back(Message::say("VTK says: %1", log.warnings[warning]));
    return found;
}

/// Each reading by a reader of its own, whose progress is half of the whole.
Result<VtkFindings> findTwice(const VtkRequest& request, const VtkLog& log, const TellProgress& progress)
{
    double done = 0;
    return readTwice([&]() -> Result<VtkFindings> {
        const auto source = makeSource(request);
        if (!source)
            return source.error();
        auto found = find(*source, request, log, [&](double fraction) { progress(done + fraction / 2); });
        done = 0.5;
        return found;
    });
}

Result<ReadAnswer> answer(const VtkRequest& request, const VtkLog& log, const TellProgress& progress)
{
    const auto checked = request.format == VtkFormat::Series ? checkSeries(request) : checkBeforeVtk(request);
    if (!checked)
        return checked.error();
    limitWork(limitsFor(checked->bytes, checked->unpackedBytes, physicalBytes()));
    const auto source = makeSource(request);
    if (!source)
        return source.error();
    if (const Status fits = checkUntold(request.given, source->untold); !fits)
        return fits.error();
    if (request.contentsOnly) {
        auto contents = lookInto(*source, request, log, progress);
        return contents ? Result<ReadAnswer>(*std::move(contents)) : contents.error();
    }
    auto found =
        mayBeUnwritten(request.format) ? findTwice(request, log, progress) : find(*source, request, log, progress);
    if (!found)
        return found.error();
    found->remarks.insert(found->remarks.begin(), checked->remarks.begin(), checked->remarks.end());
    return ReadAnswer(*std::move(found));
}

} // namespace
} // namespace tetra

int main()
{
    using namespace tetra;
    static VtkLog log; // VTK writes to it up to the end of the process
    const int code = runReadingProgram("VTK", [](RequestInput& input) -> AnswerRequest {
        VtkRequest request;
        exchange(input.input, request);
        input.file = request.path;
        sendVtkMessagesTo(log);
        return [request](const TellProgress& progress) { return answer(request, log, progress); };
    });
    _exit(code); // VTK's own tidying up has been seen to crash
}
