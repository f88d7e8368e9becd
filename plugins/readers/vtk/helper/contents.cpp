// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/contents.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/helper/grid_findings.h"
#include "plugins/readers/vtk/helper/provenance.h"

#include <vtkDataObject.h>
#include <vtkDataObjectTypes.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredDataReader.h>

#include <algorithm>

namespace tetra {
namespace {

DomainClass domainOf(vtkDataSet& data)
{
    if (const auto grid = gridOf(data))
        return grid->onLattice ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    return vtkUnstructuredGrid::SafeDownCast(&data) != nullptr ? DomainClass::Irregular : DomainClass::Scattered;
}

std::optional<ValueRange> rangeOf(const VtkArray& array)
{
    double range[2] = {1, 0};
    array.array->GetRange(range, array.array->GetNumberOfComponents() > 1 ? -1 : 0);
    return range[0] <= range[1] ? std::optional(ValueRange{range[0], range[1]}) : std::nullopt;
}

void addGrid(vtkDataSet& data, FileContents& contents)
{
    if (const auto grid = gridOf(data))
        contents.lattice = grid->lattice;
}

/// Adds the fields of points or cells that the information names; false if one has no name.
bool addFields(vtkInformation& information, vtkInformationInformationVectorKey* key, bool perCell,
               std::vector<VtkArray>& arrays)
{
    vtkInformationVector* fields = information.Get(key);
    for (int field = 0; fields != nullptr && field < fields->GetNumberOfInformationObjects(); ++field) {
        vtkInformation& entry = *fields->GetInformationObject(field);
        if (entry.Has(vtkDataObject::FIELD_NAME()) == 0)
            return false;
        VtkArray array{.name = entry.Get(vtkDataObject::FIELD_NAME()), .perCell = perCell};
        array.isHelping = isHelpingArray(array.name);
        const int roles = entry.Has(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE()) != 0
                              ? entry.Get(vtkDataObject::FIELD_ACTIVE_ATTRIBUTE())
                              : 0;
        array.active = (roles >> vtkDataSetAttributes::SCALARS & 1) != 0;
        for (const int role : helpingRoles)
            array.isHelping = array.isHelping || (roles >> role & 1) != 0;
        if (entry.Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()) != 0)
            array.components = entry.Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS());
        if (const double* range = entry.Get(vtkDataObject::FIELD_RANGE()); range != nullptr && array.components == 1)
            array.range = ValueRange{range[0], range[1]};
        arrays.push_back(std::move(array));
    }
    return true;
}

/// Whether the information holds the extent of a grid, which is then added.
bool addExtent(vtkInformation& information, FileContents& contents)
{
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    if (information.Has(Pipeline::WHOLE_EXTENT()) == 0)
        return false;
    const int* extent = information.Get(Pipeline::WHOLE_EXTENT());
    Eigen::Vector3d first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (extent[2 * axis + 1] < extent[2 * axis])
            return false;
        contents.lattice.size[axis] = static_cast<std::uint32_t>(extent[2 * axis + 1] - extent[2 * axis] + 1);
        first[static_cast<Eigen::Index>(axis)] = extent[2 * axis];
    }
    if (information.Has(vtkDataObject::SPACING()) != 0 && information.Has(vtkDataObject::ORIGIN()) != 0) {
        using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
        Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
        if (information.Has(vtkDataObject::DIRECTION()) != 0)
            directions = Eigen::Map<const Rows>(information.Get(vtkDataObject::DIRECTION()));
        const Eigen::Vector3d spacing(information.Get(vtkDataObject::SPACING()));
        const Eigen::Vector3d origin(information.Get(vtkDataObject::ORIGIN()));
        placeByDirections(contents.lattice, directions, spacing, origin + directions * spacing.cwiseProduct(first));
    }
    contents.points = contents.lattice.pointCount();
    return true;
}

void addCounts(vtkAlgorithm& reader, FileContents& contents)
{
    auto* xml = vtkXMLUnstructuredDataReader::SafeDownCast(&reader);
    if (xml == nullptr)
        return;
    xml->SetupUpdateExtent(0, 1, 0);
    contents.points = static_cast<std::uint64_t>(std::max<vtkIdType>(0, xml->GetNumberOfPoints()));
    contents.cells = static_cast<std::uint64_t>(std::max<vtkIdType>(0, xml->GetNumberOfCells()));
}

} // namespace

std::optional<FileContents> contentsFromInformation(vtkAlgorithm& reader, const VtkRequest& request)
{
    vtkInformation* information = reader.GetOutputInformation(0);
    vtkDataObject* output = reader.GetOutputDataObject(0);
    if (information == nullptr || output == nullptr)
        return std::nullopt;
    std::vector<VtkArray> arrays;
    if (!addFields(*information, vtkDataObject::POINT_DATA_VECTOR(), false, arrays) ||
        !addFields(*information, vtkDataObject::CELL_DATA_VECTOR(), true, arrays) || arrays.empty())
        return std::nullopt;
    FileContents contents;
    for (const VtkArray& array : arrays)
        contents.arrays.push_back({array.name, array.components, array.perCell, array.range});
    if (const auto chosen = chooseArray(arrays, request.array)) {
        Provenance provenance;
        tellArray(arrays, *chosen, request, provenance);
        contents.taken = std::move(provenance.taken);
    }
    const int type = output->GetDataObjectType();
    if (type == VTK_IMAGE_DATA || type == VTK_STRUCTURED_GRID) {
        contents.domain = type == VTK_IMAGE_DATA ? DomainClass::RegularLattice : DomainClass::Curvilinear;
        if (!addExtent(*information, contents))
            return std::nullopt;
    } else if (type == VTK_POLY_DATA) {
        contents.domain = DomainClass::Scattered;
        addCounts(reader, contents);
    } else {
        return std::nullopt;
    }
    return contents;
}

FileContents contentsOf(const std::vector<VtkLeaf>& leaves, const VtkRequest& request)
{
    FileContents contents;
    for (const VtkLeaf& leaf : leaves)
        if (!leaf.name.empty())
            contents.blocks.push_back(leaf.name);
    const auto selection = selectParts(leaves, request);
    const auto part = request.part.empty() ? Result<std::size_t>(Error{}) : chooseLeaf(leaves, request.part);
    for (std::size_t number = 0; number < leaves.size(); ++number) {
        vtkDataSet& data = *leaves[number].data;
        if (part && *part != number)
            continue;
        if (!selection || std::ranges::find(selection->parts, number) != selection->parts.end()) {
            if (!contents.domain) {
                contents.domain = domainOf(data);
                addGrid(data, contents);
            }
            contents.points += static_cast<std::uint64_t>(data.GetNumberOfPoints());
            contents.cells += static_cast<std::uint64_t>(data.GetNumberOfCells());
        }
        for (const VtkArray& array : arraysOf(data))
            if (std::ranges::none_of(contents.arrays, [&](const FileArray& there) {
                    return there.name == array.name && there.perCell == array.perCell;
                }))
                contents.arrays.push_back({array.name, array.components, array.perCell, rangeOf(array)});
    }
    if (!selection)
        return contents;
    if (selection->joinsVolumes) {
        contents.domain = DomainClass::Irregular;
        contents.lattice = {};
    }
    Provenance provenance = provenanceOf(leaves, *selection, request);
    contents.taken = std::move(provenance.taken);
    contents.leftOut = std::move(provenance.leftOut);
    return contents;
}

} // namespace tetra
