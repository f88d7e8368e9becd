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
        return vtkError(std::string(vtkErrorCode::GetStringFromErrorCode(code)) + ".");
    return {};
}

} // namespace

std::vector<double> timesOf(const VtkSource& source)
{
    if (!source.times.empty())
        return source.times;
    vtkInformation* information = source.reader->GetOutputInformation(0);
    if (information == nullptr || information->Has(Pipeline::TIME_STEPS()) == 0)
        return {};
    const double* times = information->Get(Pipeline::TIME_STEPS());
    return {times, times + information->Length(Pipeline::TIME_STEPS())};
}

Result<vtkSmartPointer<vtkDataObject>> runSource(const VtkSource& source, const VtkRequest& request, const VtkLog& log,
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
    const std::vector<double> times = timesOf(source);
    const auto step = stepAsked(request, times.size());
    if (!step)
        return step.error();
    if (times.empty() || !source.times.empty())
        reader.Update();
    else
        reader.UpdateTimeStep(times[*step]);
    if (const Status done = checkDone(reader, log); !done)
        return done.error();
    vtkSmartPointer<vtkDataObject> data = reader.GetOutputDataObject(0);
    if (data == nullptr)
        return Error{
            ErrorKind::BadInput,
            Message::say("VTK finds nothing in it that it can read. Export it in another format (.vtu, .vti).")};
    return data;
}

} // namespace tetra
