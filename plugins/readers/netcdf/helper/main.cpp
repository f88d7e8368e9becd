// SPDX-License-Identifier: GPL-3.0-or-later
// The program in which the NetCDF library reads a file for the plugin: takes one request from its input and writes
// messages to its output (plugins/process/exchange.h).
#include "plugins/process/process_limits.h"
#include "plugins/process/reading_program.h"
#include "plugins/readers/netcdf/classic_check.h"
#include "plugins/readers/netcdf/helper/exodus_findings.h"
#include "plugins/readers/netcdf/helper/grid_findings.h"

namespace tetra {
namespace {

template <class Value> Result<ReadAnswer> asAnswer(Result<Value> value)
{
    return value ? Result<ReadAnswer>(ReadAnswer(*std::move(value))) : value.error();
}

Result<ReadAnswer> answer(const NetCdfRequest& request, const TellProgress& progress)
{
    constexpr std::uint64_t usualPacking = 20; // times more that packed data become, at most
    const auto bytes = checkClassicNetCdf(request.path);
    if (!bytes)
        return bytes.error();
    limitWork(limitsFor(*bytes, usualPacking * *bytes, physicalBytes()));
    const auto file = NetCdfFile::open(request.path);
    if (!file)
        return file.error();
    if (isExodus(**file))
        return request.contentsOnly ? asAnswer(exodusContents(**file, request))
                                    : asAnswer(exodusFindings(**file, request, progress));
    return request.contentsOnly ? asAnswer(gridContents(**file, request))
                                : asAnswer(gridFindings(**file, request, progress));
}

} // namespace
} // namespace tetra

int main()
{
    using namespace tetra;
    return runReadingProgram("NetCDF", [](RequestInput& input) -> AnswerRequest {
        NetCdfRequest request;
        exchange(input.input, request);
        input.file = request.path;
        return [request](const TellProgress& progress) { return answer(request, progress); };
    });
}
