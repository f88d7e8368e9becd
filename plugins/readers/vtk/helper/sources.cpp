// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/sources.h"

#include "plugins/api/time_steps.h"
#include "plugins/process/process_limits.h"
#include "plugins/readers/vtk/helper/mesh_sources.h"
#include "plugins/readers/vtk/helper/series_source.h"
#include "plugins/readers/vtk/helper/xml_sources.h"

#include <vtkGenericDataObjectReader.h>
#include <vtkHDFReader.h>

#include <algorithm>

namespace tetra {
namespace {

VtkSource legacySource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
    reader->SetFileName(path.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTCoordsOn();
    reader->ReadAllColorScalarsOn();
    return {.reader = reader};
}

} // namespace

Result<std::size_t> stepAsked(const VtkRequest& request, std::size_t steps)
{
    const auto number = static_cast<std::size_t>(std::max<std::int64_t>(1, request.timeStep));
    if (number <= std::max<std::size_t>(1, steps))
        return number - 1;
    return noSuchTimeStep(steps, request.timeStep);
}

Result<VtkSource> makeSource(const VtkRequest& request)
{
    switch (request.format) {
    case VtkFormat::Xml: return makeXmlSource(request);
    case VtkFormat::Legacy: return legacySource(request.path);
    case VtkFormat::Series: return makeSeriesSource(request);
    case VtkFormat::Hdf: {
        allowOneFile();
        const auto reader = vtkSmartPointer<vtkHDFReader>::New();
        reader->SetFileName(request.path.c_str());
        return VtkSource{.reader = reader};
    }
    default: return makeMeshSource(request);
    }
}

} // namespace tetra
