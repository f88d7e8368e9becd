// SPDX-License-Identifier: GPL-3.0-or-later
// The program that reads a folder of Zarr for the plugin: takes one request from its input and writes messages to its
// output (plugins/process/exchange.h).
#include "plugins/process/reading_program.h"
#include "plugins/readers/zarr/helper/zarr_choice.h"
#include "plugins/readers/zarr/helper/zarr_samples.h"

namespace tetra {
namespace {

FileContents contentsOf(const ZarrChoice& choice)
{
    FileContents contents;
    contents.domain = DomainClass::RegularLattice;
    contents.lattice = choice.lattice;
    contents.points = choice.lattice.pointCount();
    contents.type = sampleTypeOf(choice.array.number);
    for (const std::string& path : choice.arrays)
        contents.arrays.push_back({.name = path});
    contents.timeSteps = choice.timeSteps;
    if (choice.levels.size() > 1)
        contents.blocks = choice.levels;
    contents.series = choice.series;
    contents.channels = choice.channels;
    contents.taken = choice.taken;
    contents.leftOut = choice.leftOut;
    contents.untold = choice.untold;
    return contents;
}

Result<ReadAnswer> answer(const ZarrRequest& request, const TellProgress& progress)
{
    const auto folder = ZarrFolder::open(request.folder);
    if (!folder)
        return folder.error();
    const auto choice = chooseZarr(*folder, request);
    if (!choice)
        return choice.error();
    if (request.contentsOnly)
        return ReadAnswer(contentsOf(*choice));
    auto read = readZarrSamples(*folder, choice->array, choice->selection, progress);
    if (!read)
        return read.error();
    FileFindings found;
    found.lattice = choice->lattice;
    found.lengthUnit = choice->lengthUnit;
    found.untold = choice->untold;
    found.type = read->type;
    found.samples = std::move(read->samples);
    found.arrayName = choice->arrayName;
    found.remarks = choice->remarks;
    found.remarks.insert(found.remarks.end(), read->remarks.begin(), read->remarks.end());
    found.taken = choice->taken;
    found.leftOut = choice->leftOut;
    return ReadAnswer(std::move(found));
}

} // namespace
} // namespace tetra

int main()
{
    using namespace tetra;
    return runReadingProgram("Zarr", [](RequestInput& input) -> AnswerRequest {
        ZarrRequest request;
        exchange(input.input, request);
        input.file = request.folder;
        return [request](const TellProgress& progress) { return answer(request, progress); };
    });
}
