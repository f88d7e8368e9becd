// SPDX-License-Identifier: GPL-3.0-or-later
// Datasets of arrays: lattices, grids, points, cells. What is refused here rather than in Python is what would be read
// beyond an array's end.
#include "binding.h"

#include <tan/data.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace tetra::python {

namespace {

using Numbers = py::array_t<double, py::array::c_style>;
using Counts = py::array_t<std::uint64_t, py::array::c_style>;
using Flags = py::array_t<std::uint8_t, py::array::c_style>;

/// What an array does not say of itself.
struct Names {
    std::string name;
    std::string value;
    std::string valueUnit;
    std::string lengthUnit;
    std::string space;
};

/// Where a lattice lies.
struct Frame {
    std::array<double, 3> spacing{1, 1, 1};
    std::array<double, 3> origin{0, 0, 0};
    std::array<std::array<double, 3>, 3> directions{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< rows
};

[[noreturn]] void refuse(const Message& reason)
{
    raise({ErrorKind::WrongUsage, reason});
}

SampleType typeOf(const py::array& values)
{
    const py::dtype type = values.dtype();
    const bool usable = (values.flags() & py::array::c_style) != 0 && type.attr(attributeName("isnative")).cast<bool>();
    for (int number = 0; usable && number <= static_cast<int>(SampleType::Float64); ++number) {
        const auto known = static_cast<SampleType>(number);
        const char kind = !isInteger(known) ? 'f' : number % 2 == 0 ? 'u' : 'i';
        if (type.kind() == kind && static_cast<std::size_t>(type.itemsize()) == sampleSize(known))
            return known;
    }
    refuse(Message::say("Values are C-contiguous arrays of integers of 8 to 32 bits, float32 or float64."));
}

/// The size of an array with axes z, y and x, as x, y and z.
std::array<std::uint32_t, 3> sizeOf(const py::array& values)
{
    if (values.ndim() != 3)
        refuse(Message::say("Values of a lattice or a grid are an array with three axes, not %1.", values.ndim()));
    std::array<std::uint64_t, 3> size{};
    for (int axis = 0; axis < 3; ++axis)
        size[axis] = static_cast<std::uint64_t>(values.shape(2 - axis));
    valueOf(checkLatticeSize(size));
    return {static_cast<std::uint32_t>(size[0]), static_cast<std::uint32_t>(size[1]),
            static_cast<std::uint32_t>(size[2])};
}

void checkShape(const py::array& array, const std::vector<py::ssize_t>& shape, const char* what)
{
    bool same = array.ndim() == static_cast<py::ssize_t>(shape.size());
    for (std::size_t axis = 0; same && axis < shape.size(); ++axis)
        same = array.shape(static_cast<py::ssize_t>(axis)) == shape[axis];
    if (!same)
        refuse(Message::say("%1 do not have the shape that fits the others.", what));
}

std::vector<Eigen::Vector3d> placesOf(const Numbers& places)
{
    static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
    if (places.ndim() < 1 || places.shape(places.ndim() - 1) != 3)
        refuse(Message::say("Positions are an array whose last axis has three numbers: x, y and z."));
    std::vector<Eigen::Vector3d> copied(static_cast<std::size_t>(places.size() / 3));
    if (!copied.empty())
        std::memcpy(copied.front().data(), places.data(), copied.size() * sizeof(Eigen::Vector3d));
    return copied;
}

std::shared_ptr<const std::vector<GridCell>> cellsOf(const std::optional<Flags>& holes, const py::array& values)
{
    if (!holes)
        return nullptr;
    checkShape(*holes, {values.shape(0) - 1, values.shape(1) - 1, values.shape(2) - 1}, "Flags of cells");
    auto cells = std::make_shared<std::vector<GridCell>>(static_cast<std::size_t>(holes->size()));
    std::transform(holes->data(), holes->data() + holes->size(), cells->begin(),
                   [](std::uint8_t hole) { return hole != 0 ? GridCell::Blanked : GridCell::Kept; });
    return cells;
}

Source sourceOf(const Names& names)
{
    Source source;
    source.name = names.name;
    source.valueName = names.value;
    if (!names.valueUnit.empty())
        source.taken.push_back({TakenPart::Unit, names.valueUnit, false});
    return source;
}

Dataset named(Dataset dataset, const Names& names)
{
    Source source = sourceOf(names);
    source.hash = dataset.source.hash;
    dataset.source = std::move(source);
    dataset.space = names.space;
    dataset.lengthUnit = names.lengthUnit;
    return dataset;
}

/// A grid with holes as the mesh that is left of it.
Result<Dataset> withoutHoles(Dataset grid, const Names& names, const Progress& progress)
{
    grid = named(std::move(grid), names);
    auto left = withHoles(grid, progress);
    if (!left && left.error().kind != ErrorKind::Cancelled)
        return Error{left.error().kind, Message::say("Cannot use '%1': %2", names.name, left.error().message)};
    return left;
}

Lattice latticeOf(const std::array<std::uint32_t, 3>& size, const Frame& frame)
{
    Lattice lattice;
    lattice.size = size;
    lattice.spacing = Eigen::Vector3d(frame.spacing.data());
    lattice.origin = Eigen::Vector3d(frame.origin.data());
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            lattice.directions(row, column) = frame.directions[row][column];
    return lattice;
}

/// Samples in the array's own memory.
Result<ScalarField> fieldOf(SampleType type, std::uint64_t count, const std::shared_ptr<const std::byte>& memory,
                            const Progress& progress)
{
    return ScalarField::scanned(type, count, memory, progress);
}

HeldDataset latticeData(const py::array& values, const Frame& frame, const std::optional<Flags>& holes,
                        const Names& names, const py::object& progress)
{
    const SampleType type = typeOf(values);
    const Lattice lattice = latticeOf(sizeOf(values), frame);
    const auto cells = cellsOf(holes, values);
    const auto memory = memoryOf(values);
    const auto make = [&](const Progress& told) -> Result<Dataset> {
        if (const Status usable = checkLatticePlacement(lattice); !usable)
            return Error{usable.error().kind, Message::say("Cannot use '%1': %2", names.name, usable.error().message)};
        auto field = fieldOf(type, lattice.pointCount(), memory, told.part(0, 0.2));
        if (!field)
            return field.error();
        if (cells || field->notFiniteCount() > 0)
            return withoutHoles(Dataset{.lattice = lattice, .values = *std::move(field), .source = {}, .cells = cells},
                                names, told.part(0.2, 1));
        auto dataset = latticeDataset(lattice, *std::move(field), names.name);
        return dataset ? named(*std::move(dataset), names) : dataset;
    };
    return {finished(progress, make)};
}

HeldDataset gridData(const Numbers& places, const py::array& values, const std::optional<Flags>& holes,
                     const Names& names, const py::object& progress)
{
    const SampleType type = typeOf(values);
    const auto size = sizeOf(values);
    checkShape(places, {values.shape(0), values.shape(1), values.shape(2), 3}, "Positions of a grid");
    const auto cells = cellsOf(holes, values);
    const auto memory = memoryOf(values);
    std::vector<Eigen::Vector3d> positions = placesOf(places);
    const auto make = [&](const Progress& told) -> Result<Dataset> {
        auto field = fieldOf(type, positions.size(), memory, told.part(0, 0.2));
        if (!field)
            return field.error();
        if (cells || field->notFiniteCount() > 0)
            return withoutHoles(
                Dataset{.domain = DomainClass::Curvilinear,
                        .lattice = {.size = size},
                        .positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions)),
                        .values = *std::move(field),
                        .source = {},
                        .cells = cells},
                names, told.part(0.2, 1));
        auto dataset = curvilinearDataset(size, std::move(positions), *std::move(field), names.name);
        return dataset ? named(*std::move(dataset), names) : dataset;
    };
    return {finished(progress, make)};
}

std::vector<double> copied(const Numbers& values)
{
    if (values.ndim() != 1)
        refuse(Message::say("Values are an array with one axis, not %1.", values.ndim()));
    return {values.data(), values.data() + values.size()};
}

HeldDataset pointData(const Numbers& places, const Numbers& values, const Names& names, const py::object& progress)
{
    std::vector<Eigen::Vector3d> positions = placesOf(places);
    std::vector<double> samples = copied(values);
    const auto make = [&](const Progress& /*told*/) -> Result<Dataset> {
        auto dataset = scatteredDataset(std::move(positions), std::move(samples), names.name);
        return dataset ? named(*std::move(dataset), names) : dataset;
    };
    return {finished(progress, make)};
}

void append(CellComplex& complex, const std::string& shape, const Counts& corners)
{
    using enum CellShape;
    constexpr std::array<std::pair<std::string_view, CellShape>, 9> shapes{{{"tetra", Tetrahedron},
                                                                            {"pyramid", Pyramid},
                                                                            {"wedge", Prism},
                                                                            {"hexahedron", Hexahedron},
                                                                            {"voxel", Voxel},
                                                                            {"tetra10", QuadraticTetrahedron},
                                                                            {"pyramid13", QuadraticPyramid},
                                                                            {"wedge15", QuadraticPrism},
                                                                            {"hexahedron20", QuadraticHexahedron}}};
    constexpr std::array<py::ssize_t, 9> counts{4, 5, 6, 8, 8, 10, 13, 15, 20};
    const CellShape kind = choice("the shape of cells", shape, shapes);
    const auto place = std::ranges::find(shapes, kind, &std::pair<std::string_view, CellShape>::second);
    if (corners.ndim() != 2 || corners.shape(1) != counts[static_cast<std::size_t>(place - shapes.begin())])
        refuse(Message::say("Cells of the shape '%1' are an array with a row of %2 numbers of points for each.", shape,
                            counts[static_cast<std::size_t>(place - shapes.begin())]));
    const auto first = static_cast<std::uint64_t>(complex.corners.size());
    complex.corners.insert(complex.corners.end(), corners.data(), corners.data() + corners.size());
    complex.shapes.insert(complex.shapes.end(), static_cast<std::size_t>(corners.shape(0)), kind);
    for (py::ssize_t cell = 1; cell <= corners.shape(0); ++cell)
        complex.offsets.push_back(first + static_cast<std::uint64_t>(cell * corners.shape(1)));
}

HeldDataset cellData(const Numbers& places, const std::vector<std::pair<std::string, Counts>>& blocks,
                     const Numbers& values, bool perCell, bool singlePrecision, const Names& names,
                     const py::object& progress)
{
    CellComplex complex;
    complex.positions = placesOf(places);
    complex.offsets.push_back(0);
    for (const auto& [shape, corners] : blocks)
        append(complex, shape, corners);
    ComplexValues samples{copied(values), perCell, singlePrecision ? SampleType::Float32 : SampleType::Float64};
    const std::size_t expected = perCell ? complex.shapes.size() : complex.positions.size();
    if (samples.values.size() != expected)
        refuse(Message::say("There are %1 values for %2 %3. Give one value for each.", samples.values.size(), expected,
                            perCell ? "cells" : "points"));
    const auto make = [&](const Progress& told) -> Result<Dataset> {
        auto dataset = irregularDataset(complex, samples, sourceOf(names), told);
        if (!dataset && dataset.error().kind != ErrorKind::Cancelled)
            return Error{dataset.error().kind,
                         Message::say("Cannot use '%1': %2", names.name, dataset.error().message)};
        return dataset ? named(*std::move(dataset), names) : dataset;
    };
    return {finished(progress, make)};
}

py::dict factsOf(const HeldDataset& held)
{
    const Dataset& dataset = held.dataset;
    py::dict facts;
    facts["kind"] = std::string(domainClassName(dataset.domain));
    facts["points"] = dataset.pointCount();
    facts["cells"] = dataset.tetrahedra ? dataset.tetrahedra->size() : 0;
    facts["range"] = py::make_tuple(dataset.values.range().minimum, dataset.values.range().maximum);
    facts["name"] = dataset.source.name;
    py::list remarks;
    for (const Message& remark : dataset.remarks)
        remarks.append(visibleText(remark));
    facts["remarks"] = remarks;
    return facts;
}

} // namespace

void bindData(py::module_& module)
{
    py::class_<Names>(module, "Names")
        .def(py::init<>())
        .def_readwrite("name", &Names::name)
        .def_readwrite("value", &Names::value)
        .def_readwrite("value_unit", &Names::valueUnit)
        .def_readwrite("length_unit", &Names::lengthUnit)
        .def_readwrite("space", &Names::space);
    py::class_<Frame>(module, "Frame")
        .def(py::init<>())
        .def_readwrite("spacing", &Frame::spacing)
        .def_readwrite("origin", &Frame::origin)
        .def_readwrite("directions", &Frame::directions);
    py::class_<HeldDataset>(module, "Dataset").def("facts", &factsOf);
    module.def("lattice_data", &latticeData);
    module.def("grid_data", &gridData);
    module.def("point_data", &pointData);
    module.def("cell_data", &cellData);
}

} // namespace tetra::python
