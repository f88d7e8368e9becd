// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/tecplot_source.h"

#include "plugins/readers/vtk/tecplot_text.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace tetra {
namespace {

/// Looks at the values where they are; they must live as long.
vtkSmartPointer<vtkDataArray> tecplotArray(const TecplotValues& values, const std::string& name)
{
    constexpr int keep = 1; // the array does not own them
    vtkSmartPointer<vtkDataArray> array;
    if (values.doubles.empty()) {
        const auto singles = vtkSmartPointer<vtkFloatArray>::New();
        singles->SetArray(const_cast<float*>(values.singles.data()), static_cast<vtkIdType>(values.size()), keep);
        array = singles;
    } else {
        const auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
        doubles->SetArray(const_cast<double*>(values.doubles.data()), static_cast<vtkIdType>(values.size()), keep);
        array = doubles;
    }
    array->SetName(name.c_str());
    return array;
}

vtkSmartPointer<vtkPoints> tecplotPoints(const TecplotFile& file, const TecplotZone& zone)
{
    const auto axis = [&](std::size_t i) -> const TecplotValues& { return *zone.values[file.axes[i]]; };
    const bool single = axis(0).doubles.empty() && axis(1).doubles.empty() && axis(2).doubles.empty();
    const auto points = vtkSmartPointer<vtkPoints>::Take(vtkPoints::New(single ? VTK_FLOAT : VTK_DOUBLE));
    points->SetNumberOfPoints(static_cast<vtkIdType>(zone.nodes));
    for (std::size_t i = 0; i < zone.nodes; ++i)
        points->SetPoint(static_cast<vtkIdType>(i), axis(0).at(i), axis(1).at(i), axis(2).at(i));
    return points;
}

int vtkTypeOf(TecplotElement element)
{
    switch (element) {
    case TecplotElement::Line: return VTK_LINE;
    case TecplotElement::Triangle: return VTK_TRIANGLE;
    case TecplotElement::Quadrilateral: return VTK_QUAD;
    case TecplotElement::Tetrahedron: return VTK_TETRA;
    case TecplotElement::Brick: return VTK_HEXAHEDRON;
    default: return VTK_VERTEX;
    }
}

vtkSmartPointer<vtkPointSet> tecplotGrid(const TecplotZone& zone)
{
    if (zone.element != TecplotElement::Ordered) {
        const auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
        const auto corners = static_cast<vtkIdType>(cornersOf(zone.element));
        const auto cells = vtkSmartPointer<vtkCellArray>::New();
        cells->AllocateExact(static_cast<vtkIdType>(zone.elements), static_cast<vtkIdType>(zone.elements) * corners);
        for (vtkIdType cell = 0; cell < static_cast<vtkIdType>(zone.elements); ++cell)
            if (zone.connectivity)
                cells->InsertNextCell(corners,
                                      reinterpret_cast<const vtkIdType*>(zone.connectivity->data()) + cell * corners);
            else
                cells->InsertNextCell(1, &cell);
        mesh->SetCells(vtkTypeOf(zone.element), cells);
        return mesh;
    }
    if (std::ranges::count(zone.size, 1U) >= 2) // a row of points
        return vtkSmartPointer<vtkPolyData>::New();
    const auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(static_cast<int>(zone.size[0]), static_cast<int>(zone.size[1]), static_cast<int>(zone.size[2]));
    return grid;
}

vtkSmartPointer<vtkPointSet> tecplotBlock(const TecplotFile& file, const TecplotZone& zone)
{
    const vtkSmartPointer<vtkPointSet> grid = tecplotGrid(zone);
    grid->SetPoints(tecplotPoints(file, zone));
    for (std::size_t i = 0; i < file.variables.size(); ++i)
        if (zone.values[i] && std::ranges::find(file.axes, i) == file.axes.end()) {
            vtkDataSetAttributes& attributes =
                zone.perElement[i] ? static_cast<vtkDataSetAttributes&>(*grid->GetCellData()) : *grid->GetPointData();
            attributes.AddArray(tecplotArray(*zone.values[i], file.variables[i]));
        }
    return grid;
}

} // namespace

Result<VtkSource> makeTecplotSource(const VtkRequest& request)
{
    static_assert(sizeof(vtkIdType) == sizeof(std::int64_t));
    const auto mapped = MappedFile::open(request.path);
    if (!mapped)
        return mapped.error();
    auto read = readTecplot({reinterpret_cast<const char*>((*mapped)->bytes().data()), (*mapped)->bytes().size()});
    if (!read)
        return read.error();
    const auto file = std::make_shared<const TecplotFile>(*std::move(read));
    std::vector<double> times = tecplotTimes(*file);
    const auto step = stepAsked(request, times.size());
    if (!step)
        return step.error();
    const auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (const TecplotZone& zone : file->zones)
        if (times.empty() || isThereAt(zone, times[*step])) {
            const unsigned number = blocks->GetNumberOfBlocks();
            blocks->SetBlock(number, tecplotBlock(*file, zone));
            blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), zone.name.c_str());
        }
    const auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
    producer->SetOutput(blocks);
    return VtkSource{.reader = producer,
                     .finish = [file](VtkFindings&) {}, // the arrays look into it
                     .times = std::move(times)};
}

} // namespace tetra
