// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/mesh_sources.h"

#include "plugins/readers/vtk/helper/openfoam_source.h"
#include "plugins/readers/vtk/helper/tecplot_source.h"

#include <vtkCGNSReader.h>
#include <vtkExodusIIReader.h>
#include <vtkFLUENTReader.h>
#include <vtkGAMBITReader.h>
#include <vtkGenericEnSightReader.h>
#include <vtkNetCDFCFReader.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

VtkSource exodusSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkExodusIIReader>::New();
    reader->SetFileName(path.c_str());
    reader->GenerateObjectIdCellArrayOff();
    reader->GenerateGlobalElementIdArrayOff();
    reader->GenerateGlobalNodeIdArrayOff();
    return {.reader = reader, .selectArrays = [reader] {
                reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
                reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
            }};
}

VtkSource enSightSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkGenericEnSightReader>::New();
    reader->SetCaseFileName(path.c_str());
    reader->ReadAllVariablesOn();
    return {.reader = reader};
}

/// The dimensions to load: those of the wanted variable, else the most that any variable has, without time.
std::string netCdfDimensions(vtkNetCDFReader& reader, const std::string& wanted)
{
    std::string best;
    int bestCount = -1;
    vtkStringArray* dimensions = reader.GetVariableDimensions();
    for (int variable = 0; variable < reader.GetNumberOfVariableArrays(); ++variable) {
        const std::string text = dimensions->GetValue(variable);
        if (wanted == reader.GetVariableArrayName(variable))
            return text;
        const int count = static_cast<int>(std::ranges::count(text, ',')) - (text.find("time") != std::string::npos);
        if (count > bestCount) {
            bestCount = count;
            best = text;
        }
    }
    return best;
}

VtkSource netCdfSource(const VtkRequest& request)
{
    const auto reader = vtkSmartPointer<vtkNetCDFCFReader>::New();
    reader->SetFileName(request.path.c_str());
    reader->SphericalCoordinatesOff();
    reader->ReplaceFillValueWithNanOn();
    return {.reader = reader, .selectArrays = [reader, wanted = request.array] {
                reader->SetDimensions(netCdfDimensions(*reader, wanted).c_str());
            }};
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
    case VtkFormat::Exodus: return exodusSource(request.path);
    case VtkFormat::EnSight: return enSightSource(request.path);
    case VtkFormat::NetCdf: return netCdfSource(request);
    case VtkFormat::Cgns: return cgnsSource(request.path);
    case VtkFormat::Gambit: return plainSource<vtkGAMBITReader>(request.path);
    case VtkFormat::Fluent: return plainSource<vtkFLUENTReader>(request.path);
    case VtkFormat::OpenFoam: return makeOpenFoamSource(request.path);
    default: return makeTecplotSource(request);
    }
}

} // namespace tetra
