// SPDX-License-Identifier: GPL-3.0-or-later
// The program in which the HDF5 library reads a file for the plugin: takes one request from its input and writes
// messages to its output (plugins/process/exchange.h).
#include "plugins/process/process_limits.h"
#include "plugins/process/reading_program.h"
#include "plugins/readers/hdf5/helper/array_findings.h"
#include "plugins/readers/hdf5/helper/hdf5_arrays.h"
#include "plugins/readers/hdf5/helper/hdf5_id.h"

namespace tetra {
namespace {

template <class Value> Result<ReadAnswer> asAnswer(Result<Value> value)
{
    return value ? Result<ReadAnswer>(ReadAnswer(*std::move(value))) : value.error();
}

Result<ReadAnswer> answer(const Hdf5Request& request, const TellProgress& progress)
{
    std::error_code problem;
    const std::uint64_t bytes = std::filesystem::file_size(request.path, problem);
    if (problem)
        return Error{ErrorKind::BadInput,
                     Message::say("its size cannot be determined: %1.", systemErrorText(problem.value()))};
    limitWork(limitsFor(bytes, bytes, physicalBytes()));
    confineHdf5();
    const auto file = openHdf5(request.path);
    if (!file)
        return file.error();
    return request.contentsOnly ? asAnswer(arrayContents(*file, bytes, request))
                                : asAnswer(arrayFindings(*file, bytes, request, progress));
}

} // namespace
} // namespace tetra

int main()
{
    using namespace tetra;
    return runReadingProgram("HDF5", [](RequestInput& input) -> AnswerRequest {
        Hdf5Request request;
        exchange(input.input, request);
        input.file = request.path;
        return [request](const TellProgress& progress) { return answer(request, progress); };
    });
}
