// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/running.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace tetra {
namespace {

using Pipeline = vtkStreamingDemandDrivenPipeline;

void report(vtkObject* reader, unsigned long, void* function, void*)
{
    (*static_cast<const std::function<void(double)>*>(function))(static_cast<vtkAlgorithm*>(reader)->GetProgress());
}

Status checkDone(vtkAlgorithm& reader, const VtkLog& log)
{
    if (const Status done = statusOf(log); !done)
        return done;
    if (const unsigned long code = reader.GetErrorCode(); code != vtkErrorCode::NoError)
        return Error{ErrorKind::BadInput, Message::say("VTK says: %1. The file is damaged, incomplete, or of a kind "
                                                       "that VTK does not know: copy or export it again.",
                                                       vtkErrorCode::GetStringFromErrorCode(code))};
    return {};
}

} // namespace

std::vector<double> timesOf(vtkAlgorithm& reader)
{
    vtkInformation* information = reader.GetOutputInformation(0);
    if (information == nullptr || information->Has(Pipeline::TIME_STEPS()) == 0)
        return {};
    const double* times = information->Get(Pipeline::TIME_STEPS());
    return {times, times + information->Length(Pipeline::TIME_STEPS())};
}

Result<vtkSmartPointer<vtkDataObject>> runSource(const VtkSource& source, std::int64_t timeStep, const VtkLog& log,
                                                 const std::function<void(double)>& progress)
{
    vtkAlgorithm& reader = *source.reader;
    const auto observer = vtkSmartPointer<vtkCallbackCommand>::New();
    observer->SetCallback(report);
    observer->SetClientData(const_cast<std::function<void(double)>*>(&progress));
    reader.AddObserver(vtkCommand::ProgressEvent, observer);

    reader.UpdateInformation();
    if (const Status done = checkDone(reader, log); !done)
        return done.error();
    source.selectArrays();
    reader.UpdateInformation();
    const std::vector<double> times = timesOf(reader);
    const auto steps = static_cast<std::int64_t>(std::max<std::size_t>(1, times.size()));
    if (timeStep < 1 || timeStep > steps)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("it has %1 time steps, and number %2 is asked for. Choose one from 1 to %3 with 'time'.",
                         steps, timeStep, steps)};
    if (times.empty())
        reader.Update();
    else
        reader.UpdateTimeStep(times[static_cast<std::size_t>(timeStep - 1)]);
    if (const Status done = checkDone(reader, log); !done)
        return done.error();
    vtkSmartPointer<vtkDataObject> data = reader.GetOutputDataObject(0);
    if (data == nullptr)
        return Error{ErrorKind::BadInput,
                     Message::say("VTK finds nothing in it. It is damaged, or of another format.")};
    return data;
}

} // namespace tetra
