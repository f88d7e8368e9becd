// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/mesh_sources.h"

#include "plugins/readers/vtk/helper/openfoam_source.h"
#include "plugins/readers/vtk/helper/tecplot_source.h"

#include <vtkCGNSReader.h>
#include <vtkFLUENTReader.h>
#include <vtkGAMBITReader.h>
#include <vtkGenericEnSightReader.h>

namespace tetra {
namespace {

VtkSource enSightSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkGenericEnSightReader>::New();
    reader->SetCaseFileName(path.c_str());
    reader->ReadAllVariablesOn();
    return {.reader = reader};
}

VtkSource cgnsSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkCGNSReader>::New();
    reader->SetFileName(path.c_str());
    return {.reader = reader, .selectArrays = [reader] {
                reader->EnableAllBases();
                reader->EnableAllPointArrays();
                reader->EnableAllCellArrays();
            }};
}

template <class Reader> VtkSource plainSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<Reader>::New();
    reader->SetFileName(path.c_str());
    return {.reader = reader};
}

} // namespace

Result<VtkSource> makeMeshSource(const VtkRequest& request)
{
    switch (request.format) {
    case VtkFormat::EnSight: return enSightSource(request.path);
    case VtkFormat::Cgns: return cgnsSource(request.path);
    case VtkFormat::Gambit: return plainSource<vtkGAMBITReader>(request.path);
    case VtkFormat::Fluent: return plainSource<vtkFLUENTReader>(request.path);
    case VtkFormat::OpenFoam: return makeOpenFoamSource(request.path);
    default: return makeTecplotSource(request);
    }
}

} // namespace tetra
