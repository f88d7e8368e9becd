// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/cgns_contents.h"

#include "plugins/readers/vtk/checks/checked_file.h"
#include "plugins/readers/vtk/unit_powers.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace tetra {
namespace {

/// A zone, as VTK would make a dataset of it.
struct CgnsZone {
    VtkPart part;
    std::array<std::uint32_t, 3> size{}; ///< of grids
    std::uint64_t points = 0;
    std::uint64_t cells = 0;
};

/// Without what fills it up behind.
std::string_view wordOf(std::string_view text)
{
    return text.substr(0, text.find_last_not_of(std::string_view(" \0", 2)) + 1);
}

/// The word of a child; empty without one.
std::string_view wordIn(const CgnsNode& node, std::string_view label)
{
    const CgnsNode* child = node.child(label);
    return child == nullptr ? std::string_view() : wordOf(child->text);
}

/// Whether this is a whole number of points along an axis.
bool isLength(double number)
{
    return number >= 0 && number < std::numeric_limits<std::int32_t>::max();
}

/// Adds arrays of a solution as VTK gives them: three that end in X, Y and Z are one of three components.
void addSolution(const CgnsNode& solution, std::vector<VtkArray>& arrays)
{
    const std::string_view location = wordIn(solution, "GridLocation_t");
    if (!location.empty() && location != "Vertex" && location != "CellCenter")
        return;
    const auto hasArray = [&](const std::string& name) {
        return std::ranges::any_of(solution.children,
                                   [&](const CgnsNode& one) { return one.label == "DataArray_t" && one.name == name; });
    };
    for (const CgnsNode& node : solution.children) {
        if (node.label != "DataArray_t" || node.name.empty())
            continue;
        const std::string stem = node.name.substr(0, node.name.size() - 1);
        const char axis = node.name.back();
        const bool isVector = !stem.empty() && axis >= 'X' && axis <= 'Z' && hasArray(stem + 'X') &&
                              hasArray(stem + 'Y') && hasArray(stem + 'Z');
        VtkArray array{.name = isVector ? stem : node.name, .perCell = location == "CellCenter"};
        array.components = isVector ? 3 : 1;
        array.isHelping = isHelpingArray(array.name);
        const auto isSame = [&](const VtkArray& other) {
            return other.name == array.name && other.perCell == array.perCell;
        };
        if (std::ranges::none_of(arrays, isSame))
            arrays.push_back(std::move(array));
    }
}

/// The zone, or nothing if it says no size.
std::optional<CgnsZone> zoneOf(const CgnsNode& node, bool isOfSpace)
{
    CgnsZone zone;
    const bool isGrid = wordIn(node, "ZoneType_t") != "Unstructured";
    const std::size_t dimensions = node.numbers.size() / 3; // lengths in points, in cells, and what is no longer used
    if (dimensions < 1 || dimensions > 3 || (!isGrid && dimensions != 1))
        return std::nullopt;
    if (isGrid) {
        zone.points = zone.cells = 1;
        zone.size.fill(1);
        for (std::size_t axis = 0; axis < dimensions; ++axis) {
            if (!isLength(node.numbers[axis]) || node.numbers[axis] < 1)
                return std::nullopt;
            zone.size[axis] = static_cast<std::uint32_t>(node.numbers[axis]);
            zone.points = boundedProduct(zone.points, zone.size[axis]);
            zone.cells = boundedProduct(zone.cells, std::max(1U, zone.size[axis] - 1));
        }
    } else if (node.numbers[0] >= 1 && node.numbers[1] >= 0 && node.numbers[0] < 0x1p62 && node.numbers[1] < 0x1p62) {
        zone.points = static_cast<std::uint64_t>(node.numbers[0]);
        zone.cells = static_cast<std::uint64_t>(node.numbers[1]);
    } else {
        return std::nullopt;
    }
    zone.part.isMesh = !isGrid;
    zone.part.isVolume = isGrid ? std::ranges::min(zone.size) > 1 : isOfSpace;
    for (const CgnsNode& solution : node.children)
        if (solution.label == "FlowSolution_t")
            addSolution(solution, zone.part.arrays);
    std::ranges::stable_sort(zone.part.arrays, {}, &VtkArray::perCell); // those of points come first
    return zone;
}

/// All zones, and their names: with that of the base if two have the same.
std::pair<std::vector<CgnsZone>, std::vector<VtkLeaf>> zonesOf(const CgnsNode& root)
{
    std::vector<CgnsZone> zones;
    std::vector<std::pair<std::string, std::string>> names;
    for (const CgnsNode& base : root.children)
        for (const CgnsNode& node : base.children)
            if (base.label == "CGNSBase_t" && node.label == "Zone_t")
                if (auto zone = zoneOf(node, !base.numbers.empty() && base.numbers[0] == 3)) {
                    zones.push_back(*std::move(zone));
                    names.emplace_back(base.name, node.name);
                }
    std::map<std::string, int> uses;
    for (const auto& [base, name] : names)
        ++uses[name];
    std::vector<VtkLeaf> leaves;
    for (const auto& [base, name] : names)
        leaves.push_back({uses[name] > 1 ? base + "/" + name : name, nullptr});
    return {std::move(zones), std::move(leaves)};
}

void addZone(const CgnsZone& zone, FileContents& contents)
{
    if (!contents.domain && !zone.part.isMesh)
        contents.lattice.size = zone.size;
    if (!contents.domain)
        contents.domain = zone.part.isMesh ? DomainClass::Irregular : DomainClass::Curvilinear;
    contents.points = boundedSum(contents.points, zone.points);
    contents.cells = boundedSum(contents.cells, zone.cells);
}

/// What a word of DimensionalUnits_t stands for; empty if it is none of these.
std::string_view unitNamed(std::string_view word)
{
    using Unit = std::pair<std::string_view, std::string_view>;
    constexpr std::array<Unit, 16> units{{{"Kilogram", "kg"},
                                          {"Gram", "g"},
                                          {"Slug", "slug"},
                                          {"PoundMass", "lb"},
                                          {"Meter", "m"},
                                          {"Centimeter", "cm"},
                                          {"Millimeter", "mm"},
                                          {"Foot", "ft"},
                                          {"Inch", "in"},
                                          {"Second", "s"},
                                          {"Kelvin", "K"},
                                          {"Celsius", "degC"},
                                          {"Rankine", "degR"},
                                          {"Fahrenheit", "degF"},
                                          {"Degree", "deg"},
                                          {"Radian", "rad"}}};
    const auto found = std::ranges::find(units, word, &Unit::first);
    return found == units.end() ? std::string_view() : found->second;
}

/// What holds for a node and all below it, unless they say something else.
struct CgnsUnits {
    const CgnsNode* units = nullptr; ///< of mass, length, time, temperature and angle, 32 letters each
    const CgnsNode* kind = nullptr;  ///< whether the numbers have units at all

    CgnsUnits in(const CgnsNode& node) const
    {
        const CgnsNode *ownUnits = node.child("DimensionalUnits_t"), *ownKind = node.child("DataClass_t");
        return {ownUnits == nullptr ? units : ownUnits, ownKind == nullptr ? kind : ownKind};
    }
};

/// The unit of an array; empty if it has none, or one that is not told.
std::string unitOf(const CgnsNode& array, const CgnsUnits& told)
{
    constexpr std::size_t letters = 32;
    const CgnsNode* powers = array.child("DimensionalExponents_t");
    if (powers == nullptr || told.units == nullptr || !powers->children.empty() || // of current, light ...
        (told.kind != nullptr && wordOf(told.kind->text) != "Dimensional"))
        return {};
    const std::string_view words = told.units->text;
    std::vector<std::string_view> names;
    for (std::size_t at = 0; at < powers->numbers.size(); ++at) {
        names.push_back(unitNamed(wordOf(words.substr(std::min(words.size(), at * letters), letters))));
        if (names.back().empty() && powers->numbers[at] != 0)
            return {};
    }
    return unitOfPowers(names, powers->numbers);
}

/// The units of arrays by name, each as the first zone tells it.
std::map<std::string, std::string> cgnsUnits(const CgnsNode& root)
{
    std::map<std::string, std::string> units;
    for (const CgnsNode& base : root.children) {
        const CgnsUnits ofBase = CgnsUnits().in(base);
        for (const CgnsNode& zone : base.children) {
            const CgnsUnits ofZone = ofBase.in(zone);
            for (const CgnsNode& solution : zone.children) {
                const CgnsUnits ofSolution = ofZone.in(solution);
                for (const CgnsNode& array : solution.children)
                    if (std::string unit = unitOf(array, ofSolution.in(array)); !unit.empty())
                        units.emplace(array.name, std::move(unit));
            }
        }
    }
    return units;
}

/// Of a vector that of its first component; empty if none is told.
std::string unitFor(const std::map<std::string, std::string>& units, const std::string& array)
{
    const auto own = units.find(array), first = units.find(array + 'X');
    return own != units.end() ? own->second : first != units.end() ? first->second : std::string();
}

} // namespace

std::optional<FileContents> contentsOfCgns(const CgnsNode& root, const VtkRequest& request)
{
    const auto [zones, leaves] = zonesOf(root);
    if (zones.empty())
        return std::nullopt;
    std::vector<VtkPart> parts;
    FileContents contents;
    for (std::size_t number = 0; number < zones.size(); ++number) {
        parts.push_back(zones[number].part);
        contents.blocks.push_back(leaves[number].name);
    }
    const auto selection = selectParts(leaves, parts, request);
    const auto part = request.part.empty() ? Result<std::size_t>(Error{}) : chooseLeaf(leaves, request.part);
    for (std::size_t number = 0; number < zones.size(); ++number) {
        if (part && *part != number)
            continue;
        if (!selection || std::ranges::find(selection->parts, number) != selection->parts.end())
            addZone(zones[number], contents);
        for (const VtkArray& array : zones[number].part.arrays)
            if (std::ranges::find(contents.arrays, array.name, &FileArray::name) == contents.arrays.end())
                contents.arrays.push_back({array.name, array.components, array.perCell});
    }
    if (!selection)
        return contents;
    if (selection->joinsVolumes) {
        contents.domain = DomainClass::Irregular;
        contents.lattice = {};
    }
    Provenance provenance;
    tellArray(parts[selection->parts.front()].arrays, selection->array, request, provenance);
    tellParts(leaves, *selection, provenance);
    contents.taken = std::move(provenance.taken);
    contents.leftOut = std::move(provenance.leftOut);
    return contents;
}

std::vector<VtkArray> arraysOfCgns(const CgnsNode& root)
{
    std::vector<VtkArray> arrays;
    for (const CgnsNode& base : root.children)
        for (const CgnsNode& zone : base.children)
            for (const CgnsNode& solution : zone.children)
                if (solution.label == "FlowSolution_t")
                    addSolution(solution, arrays);
    return arrays;
}

void tellCgnsUnit(const CgnsNode& root, Provenance& provenance)
{
    const auto array = std::ranges::find(provenance.taken, TakenPart::Array, &Taken::part);
    if (array == provenance.taken.end())
        return;
    if (const std::string unit = unitFor(cgnsUnits(root), array->what.text()); !unit.empty())
        addTaken({TakenPart::Unit, printable(unit), false}, provenance);
}

void addCgnsUnits(const CgnsNode& root, std::vector<FileArray>& arrays)
{
    const auto units = cgnsUnits(root);
    for (FileArray& array : arrays)
        array.unit = unitFor(units, array.name);
}

} // namespace tetra
