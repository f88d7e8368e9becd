// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/mesh_sources.h"

#include "plugins/process/process_limits.h"
#include "plugins/readers/vtk/checks/file_check.h"
#include "plugins/readers/vtk/fluent_nodes.h"
#include "plugins/readers/vtk/helper/cgns_contents.h"
#include "plugins/readers/vtk/helper/exact_places.h"
#include "plugins/readers/vtk/helper/leaves.h"
#include "plugins/readers/vtk/helper/openfoam_source.h"
#include "plugins/readers/vtk/helper/tecplot_source.h"

#include <vtkCGNSReader.h>
#include <vtkFLUENTReader.h>
#include <vtkGAMBITReader.h>
#include <vtkGenericEnSightReader.h>

#include <memory>
#include <optional>
#include <string_view>

namespace tetra {
namespace {

bool isText(vtkGenericEnSightReader& reader)
{
    return std::string_view(reader.GetClassName()).find("Binary") == std::string_view::npos;
}

VtkSource enSightSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkGenericEnSightReader>::New();
    reader->SetCaseFileName(path.c_str());
    reader->ReadAllVariablesOn();
    // Its text has six digits as a rule; its binary files are in single precision themselves.
    const auto isOfText = [reader] { return reader->GetReader() != nullptr && isText(*reader->GetReader()); };
    return {.reader = reader,
            .refine =
                [isOfText](vtkDataObject& data) {
                    if (isOfText())
                        setSixDigitPlaces(data);
                },
            .tell =
                [isOfText, reader](Provenance& provenance) {
                    if (isOfText())
                        tellSinglePrecision(*reader->GetOutputDataObject(0), provenance.leftOut);
                }};
}

void tellFamilies(vtkCGNSReader& reader, Provenance& provenance)
{
    std::vector<std::string> families;
    for (int number = 0; number < reader.GetNumberOfFamilyArrays(); ++number)
        families.emplace_back(reader.GetFamilyArrayName(number));
    if (!families.empty())
        provenance.leftOut.push_back(Message::say(
            "Its families (boundary conditions and the like) are not distinguished: %1.", namesToldOf(families)));
}

VtkSource cgnsSource(const std::string& path)
{
    allowOneFile();
    const auto reader = vtkSmartPointer<vtkCGNSReader>::New();
    reader->SetFileName(path.c_str());
    const auto headers = std::make_shared<const std::optional<CgnsNode>>(readCgnsHeaders(path));
    VtkSource source{.reader = reader};
    source.selectArrays = [reader, headers] {
        reader->EnableAllBases();
        reader->EnableAllPointArrays();
        reader->EnableAllCellArrays();
        if (*headers)
            for (const VtkArray& array : arraysOfCgns(**headers))
                array.perCell ? reader->SetCellArrayStatus(array.name.c_str(), 1)
                              : reader->SetPointArrayStatus(array.name.c_str(), 1);
    };
    source.tell = [reader, headers](Provenance& provenance) {
        if (*headers)
            tellCgnsUnit(**headers, provenance);
        else
            provenance.leftOut.push_back(Message::say("Its units are not known: it has too many nodes to be looked at, "
                                                      "or not those that CGNS's library writes."));
        tellFamilies(*reader, provenance);
    };
    source.finishContents = [headers](FileContents& contents) {
        if (*headers)
            addCgnsUnits(**headers, contents.arrays);
    };
    if (*headers && isToldByHeaders(path))
        source.contentsOfHeaders = [headers](const VtkRequest& request) { return contentsOfCgns(**headers, request); };
    return source;
}

/// Gives the zones of cells, each of which has all nodes, the places of the file, which VTK has rounded.
void refineNodes(vtkDataObject& data, const std::string& path)
{
    const std::vector<VtkLeaf> zones = leavesOf(data);
    const auto file = MappedFile::open(path);
    if (!file || zones.empty())
        return;
    const std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
    const auto nodes = readFluentNodes(text, static_cast<std::uint64_t>(zones.front().data->GetNumberOfPoints()));
    for (const VtkLeaf& zone : zones)
        if (auto* points = vtkPointSet::SafeDownCast(zone.data); points != nullptr && nodes)
            setExactPlaces(*points, *nodes);
}

VtkSource fluentSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkFLUENTReader>::New();
    reader->SetFileName(path.c_str());
    return {.reader = reader, .refine = [path](vtkDataObject& data) { refineNodes(data, path); }};
}

/// With a word on places that VTK has left in single precision.
VtkSource toldSingle(VtkSource source)
{
    source.tell = [tell = std::move(source.tell), reader = source.reader](Provenance& provenance) {
        tell(provenance);
        tellSinglePrecision(*reader->GetOutputDataObject(0), provenance.leftOut);
    };
    return source;
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
    case VtkFormat::Fluent: return toldSingle(fluentSource(request.path));
    case VtkFormat::OpenFoam: {
        auto source = makeOpenFoamSource(request.path);
        return source ? Result<VtkSource>(toldSingle(*std::move(source))) : source.error();
    }
    default: return makeTecplotSource(request);
    }
}

} // namespace tetra
