// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/series_source.h"

#include "plugins/readers/vtk/checks/file_check.h"
#include "plugins/readers/vtk/checks/format_checks.h"
#include "plugins/readers/vtk/helper/series_list.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkTrivialProducer.h>

#include <set>
#include <string_view>
#include <system_error>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Error inSeriesFile(const SeriesPart& part, const Error& error)
{
    return {error.kind, Message::say("its file '%1': %2", printable(part.file.filename().string()), error.message)};
}

/// Of one file of a list; None for what VTK does not write, and for another list.
VtkFormat formatOf(const fs::path& path)
{
    if (const std::string type = xmlType(path); !type.empty())
        return type == "Collection" ? VtkFormat::None : VtkFormat::Xml;
    const auto file = MappedFile::open(path);
    if (!file)
        return VtkFormat::None;
    const std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
    return text.starts_with("# vtk DataFile") ? VtkFormat::Legacy
           : text.starts_with("\x89HDF")      ? VtkFormat::Hdf
                                              : VtkFormat::None;
}

struct SeriesChoice {
    std::vector<double> times;
    SeriesStep step;
};

Result<SeriesChoice> chooseStep(const VtkRequest& request)
{
    const auto steps = readSeries(request.path);
    if (!steps)
        return steps.error();
    const auto number = stepAsked(request, steps->size());
    if (!number)
        return number.error();
    SeriesChoice choice{.times = {}, .step = (*steps)[*number]};
    for (const SeriesStep& step : *steps)
        choice.times.push_back(step.time);
    return choice;
}

/// What is asked of one file of the step: all of its parts, of the only time that it has.
Result<VtkRequest> requestOf(const SeriesPart& part, const VtkRequest& request)
{
    std::error_code ignored;
    if (!fs::exists(part.file, ignored))
        return Error{ErrorKind::BadInput,
                     Message::say("its file '%1' is missing. Copy it into the same folder: they belong together.",
                                  printable(part.file.filename().string()))};
    VtkRequest one = request;
    one.path = part.file.string();
    one.format = formatOf(part.file);
    one.timeStep = 0;
    one.part.clear();
    if (one.format == VtkFormat::None)
        return Error{ErrorKind::BadInput,
                     Message::say("its file '%1' is not of VTK's own formats. Open that file on its own.",
                                  printable(part.file.filename().string()))};
    return one;
}

Result<vtkSmartPointer<vtkDataObject>> readPart(const SeriesPart& part, const VtkRequest& request)
{
    const auto one = requestOf(part, request);
    if (!one)
        return one.error();
    const auto source = makeSource(*one);
    if (!source)
        return inSeriesFile(part, source.error());
    source->reader->UpdateInformation();
    source->selectArrays();
    source->reader->Update();
    vtkSmartPointer<vtkDataObject> data = source->reader->GetOutputDataObject(0);
    return data;
}

} // namespace

Result<CheckedFile> checkSeries(const VtkRequest& request)
{
    const auto choice = chooseStep(request);
    if (!choice)
        return choice.error();
    CheckedFile all;
    std::set<fs::path> seen;
    for (const SeriesPart& part : choice->step.parts) {
        if (!seen.insert(part.file).second)
            return Error{ErrorKind::BadInput,
                         Message::say("it lists the file '%1' twice for one time. Write each part once.",
                                      printable(part.file.filename().string()))};
        const auto one = requestOf(part, request);
        if (!one)
            return one.error();
        const auto checked = checkBeforeVtk(*one);
        if (!checked)
            return inSeriesFile(part, checked.error());
        all.bytes = boundedSum(all.bytes, checked->bytes);
        all.unpackedBytes = boundedSum(all.unpackedBytes, checked->unpackedBytes);
        all.remarks.insert(all.remarks.end(), checked->remarks.begin(), checked->remarks.end());
    }
    return all;
}

Result<VtkSource> makeSeriesSource(const VtkRequest& request)
{
    auto choice = chooseStep(request);
    if (!choice)
        return choice.error();
    const auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
    const auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    const std::vector<SeriesPart>& parts = choice->step.parts;
    producer->SetOutput(blocks);
    for (const SeriesPart& part : parts) {
        const auto data = readPart(part, request);
        if (!data)
            return data.error();
        if (parts.size() == 1 && *data != nullptr) {
            producer->SetOutput(*data);
            continue;
        }
        const unsigned number = blocks->GetNumberOfBlocks();
        blocks->SetBlock(number, *data);
        blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), part.name.c_str());
    }
    VtkSource source{.reader = producer, .times = std::move(choice->times)};
    if (parts.size() == 1)
        source.stepFile = parts.front().name;
    return source;
}

} // namespace tetra
