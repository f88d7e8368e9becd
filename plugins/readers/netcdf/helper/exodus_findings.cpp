// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/exodus_findings.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/api/time_steps.h"
#include "plugins/readers/netcdf/helper/exodus_cells.h"
#include "plugins/readers/netcdf/helper/stored_values.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

Message listed(const std::vector<Message>& texts)
{
    constexpr std::size_t most = 40;
    Message list;
    for (std::size_t at = 0; at < std::min(most, texts.size()); ++at)
        list = list.empty() ? texts[at] : Message::say("%1, %2", list, texts[at]);
    return texts.size() > most ? Message::say("%1 and %2 more", list, texts.size() - most) : list;
}

/// The blocks of a request, by what they are for TAn.
struct ChosenBlocks {
    std::vector<std::pair<const ExodusBlock*, ExodusShape>> volumes{};
    std::size_t flat = 0;
    std::vector<std::string> unknown{}; ///< types of shapes that are not known
};

bool isBlockNamed(const ExodusBlock& block, const std::string& wanted)
{
    return wanted == block.name || wanted == blockName(block) ||
           wanted == "Unnamed block ID: " + std::to_string(block.id); // as ParaView calls it
}

Result<const ExodusBlock*> chooseBlock(const ExodusFile& exodus, const std::string& wanted)
{
    for (const ExodusBlock& block : exodus.blocks)
        if (isBlockNamed(block, wanted))
            return &block;
    if (const auto number = parseNumber<std::uint64_t>(wanted);
        number && *number >= 1 && *number <= exodus.blocks.size())
        return &exodus.blocks[*number - 1];
    for (const ExodusBlock& block : exodus.blocks)
        if (wanted == std::to_string(block.id))
            return &block;
    std::vector<Message> names;
    for (const ExodusBlock& block : exodus.blocks)
        names.emplace_back(printable(blockName(block)));
    return Error{ErrorKind::WrongUsage,
                 Message::say("it has no part '%1'. Available: %2.", printable(wanted), listed(names))};
}

Result<ChosenBlocks> chooseBlocks(const ExodusFile& exodus, const std::string& part)
{
    const ExodusBlock* wanted = nullptr;
    if (!part.empty()) {
        const auto found = chooseBlock(exodus, part);
        if (!found)
            return found.error();
        wanted = *found;
    }
    ChosenBlocks chosen;
    for (const ExodusBlock& block : exodus.blocks) {
        if (wanted != nullptr && &block != wanted)
            continue;
        const auto shape = shapeOf(block);
        if (!shape)
            chosen.unknown.push_back(block.type);
        else if (shape->shape == CellShape::Flat)
            ++chosen.flat;
        else
            chosen.volumes.emplace_back(&block, *shape);
    }
    if (chosen.volumes.empty() && chosen.flat == 0)
        return Error{
            ErrorKind::BadInput,
            chosen.unknown.empty()
                ? Message::say("it has no elements. Write it with a mesh.")
                : Message::say(
                      "its elements are of a shape that TAn does not support: %1. Divide them into simpler ones.",
                      printable(chosen.unknown.front()))};
    return chosen;
}

Error noArrays(const ExodusFile& exodus)
{
    return {ErrorKind::BadInput,
            exodus.times.empty()
                ? Message::say("it is a mesh without results: no variables of nodes or elements. Open the file that "
                               "the solver wrote, or write it with values.")
                : Message::say("it has no variables of nodes or elements. Write it with one.")};
}

/// An array, and of several components which one; nothing stands for the magnitude.
struct ChosenArray {
    ExodusArray array;
    std::optional<std::size_t> component{};
    bool isPart = false; ///< asked for by the name of one component
};

std::optional<ChosenArray> arrayNamed(const ExodusFile& exodus, const std::string& wanted)
{
    for (const ExodusArray& array : exodus.arrays) {
        if (array.name == wanted)
            return ChosenArray{array};
        for (std::size_t part = 0; part < array.parts.size(); ++part)
            if (array.parts[part] == wanted)
                return ChosenArray{array, part, true};
        if (array.parts.size() > 1 && array.parts[0].substr(0, array.parts[0].size() - 1) == wanted) // as in ParaView
            return ChosenArray{array};
    }
    return std::nullopt;
}

Result<ChosenArray> withComponent(ChosenArray chosen, const std::string& component)
{
    const std::size_t components = chosen.array.parts.size();
    if (chosen.isPart || component.empty() || component == "magnitude") {
        if (components == 1)
            chosen.component = 0;
        return chosen;
    }
    const auto number = parseNumber<std::uint64_t>(component);
    if (!number || *number >= components)
        return Error{ErrorKind::WrongUsage,
                     Message::say("its array '%1' has no component '%2'. Choose one from 0 to %3, or 'magnitude'.",
                                  printable(chosen.array.name), printable(component), components - 1)};
    chosen.component = *number;
    return chosen;
}

Result<ChosenArray> chooseArray(const ExodusFile& exodus, const NetCdfRequest& request)
{
    if (auto named = arrayNamed(exodus, request.array))
        return withComponent(*std::move(named), request.component);
    if (const auto number = parseNumber<std::uint64_t>(request.array);
        number && *number >= 1 && *number <= exodus.arrays.size())
        return withComponent({exodus.arrays[*number - 1]}, request.component);
    std::vector<Message> names;
    for (const ExodusArray& array : exodus.arrays)
        names.push_back(array.perCell ? Message::say("'%1' (of cells)", printable(array.name))
                                      : Message("'" + printable(array.name) + "'"));
    return Error{ErrorKind::WrongUsage, Message::say("it has no array '%1'. Choose one of these: %2.",
                                                     printable(request.array), listed(names))};
}

/// What one part of the values says of those that nobody wrote holds for all.
void tellUnwritten(const ExodusValues& part, ExodusValues& all)
{
    if (!part.noNumber)
        return;
    all.noNumber = part.noNumber;
    all.isGuessed = all.isGuessed || part.isGuessed;
}

/// Calls `read` for the variable of the component, or of each one for the magnitude of all.
template <class Read> Result<std::optional<ExodusValues>> combined(const ChosenArray& chosen, const Read& read)
{
    if (chosen.component)
        return read(chosen.array.numbers[*chosen.component]);
    ExodusValues all;
    std::vector<double>& sums = all.numbers;
    for (const std::size_t number : chosen.array.numbers) {
        const Result<std::optional<ExodusValues>> values = read(number);
        if (!values || !*values)
            return values;
        const std::vector<double>& component = (*values)->numbers;
        sums.resize(component.size(), 0);
        for (std::size_t at = 0; at < sums.size(); ++at)
            sums[at] += component[at] * component[at];
        tellUnwritten(**values, all);
    }
    for (double& sum : sums)
        sum = std::sqrt(sum);
    return std::optional(std::move(all));
}

/// The values at all nodes, or of the elements of the blocks one after the other, without those that have none.
struct ArrayValues {
    ExodusValues values{};
    std::vector<std::pair<const ExodusBlock*, ExodusShape>> blocks{};
    bool isConstant = true;
};

bool areConstant(const std::vector<double>& values)
{
    const auto isNumber = [](double value) { return !std::isnan(value); };
    const auto first = std::ranges::find_if(values, isNumber);
    return std::all_of(first, values.end(), [&](double value) { return !isNumber(value) || value == *first; });
}

Result<ArrayValues> readValues(const ExodusFile& exodus, const ChosenArray& chosen, const ChosenBlocks& blocks,
                               std::size_t step)
{
    ArrayValues read;
    if (!chosen.array.perCell) {
        auto values = combined(chosen, [&](std::size_t number) -> Result<std::optional<ExodusValues>> {
            auto one = nodeValues(exodus, number, step);
            return one ? Result<std::optional<ExodusValues>>(std::optional(*std::move(one))) : one.error();
        });
        if (!values)
            return values.error();
        read.values = **std::move(values);
        read.blocks = blocks.volumes;
    } else {
        for (const auto& block : blocks.volumes) {
            const auto values =
                combined(chosen, [&](std::size_t number) { return elementValues(exodus, number, *block.first, step); });
            if (!values)
                return values.error();
            if (!*values)
                continue;
            read.values.numbers.insert(read.values.numbers.end(), (*values)->numbers.begin(), (*values)->numbers.end());
            tellUnwritten(**values, read.values);
            read.blocks.push_back(block);
        }
    }
    read.isConstant = areConstant(read.values.numbers);
    return read;
}

struct Wanted {
    ChosenArray chosen;
    ArrayValues read;
};

/// Of those that nobody names, one component comes before several, values at nodes before those of elements, and
/// constant ones last.
Result<Wanted> readWanted(const ExodusFile& exodus, const ChosenBlocks& blocks, const NetCdfRequest& request,
                          std::size_t step)
{
    if (!isAutomatic(request)) {
        auto chosen = chooseArray(exodus, request);
        if (!chosen)
            return chosen.error();
        auto read = readValues(exodus, *chosen, blocks, step);
        return read ? Result<Wanted>(Wanted{*std::move(chosen), *std::move(read)}) : read.error();
    }
    std::vector<ExodusArray> arrays = exodus.arrays;
    std::ranges::stable_sort(arrays, {},
                             [](const ExodusArray& array) { return std::pair(array.perCell, array.parts.size() > 1); });
    std::optional<Result<Wanted>> first;
    for (const ExodusArray& array : arrays) {
        auto chosen = withComponent({array}, request.component);
        if (!chosen)
            return chosen.error();
        auto read = readValues(exodus, *chosen, blocks, step);
        if (!read)
            return read.error();
        const bool isUsable = !read->isConstant;
        if (isUsable || !first || (first->value().read.values.numbers.empty() && !read->values.numbers.empty()))
            first.emplace(Wanted{*std::move(chosen), *std::move(read)});
        if (isUsable)
            break;
    }
    return *std::move(first);
}

Result<std::size_t> stepOf(const ExodusFile& exodus, const NetCdfRequest& request)
{
    const auto steps = static_cast<std::int64_t>(std::max<std::size_t>(1, exodus.times.size()));
    if (request.timeStep < 1 || request.timeStep > steps)
        return noSuchTimeStep(static_cast<std::uint64_t>(steps), request.timeStep);
    return static_cast<std::size_t>(request.timeStep - 1);
}

/// What is taken beside the values themselves.
std::vector<Taken> takenOf(const ExodusFile& exodus, const NetCdfRequest& request, const ChosenArray& chosen)
{
    std::vector<Taken> taken;
    if (exodus.arrays.size() > 1)
        taken.push_back({TakenPart::Array, Message(printable(chosen.array.name)), isAutomatic(request)});
    if (chosen.array.parts.size() > 1)
        taken.push_back(
            {TakenPart::Component,
             chosen.component ? Message(printable(chosen.array.parts[*chosen.component])) : Message::say("magnitude"),
             !chosen.component && request.component.empty()});
    if (request.displaced && displacement(exodus) != nullptr)
        taken.push_back(
            {TakenPart::Places, Message::say("moved by '%1'", printable(displacement(exodus)->name)), false});
    if (!request.part.empty())
        if (const auto block = chooseBlock(exodus, request.part))
            taken.push_back({TakenPart::Block, Message(printable(blockName(**block))), false});
    if (exodus.times.size() > 1)
        taken.push_back({TakenPart::TimeStep,
                         Message::say("%1 of %2, time %3", request.timeStep, exodus.times.size(),
                                      formatNumber(exodus.times[static_cast<std::size_t>(request.timeStep - 1)])),
                         !request.timeIsGiven});
    return taken;
}

std::vector<Message> leftOutOf(const ExodusFile& exodus, const NetCdfRequest& request, const ChosenBlocks& blocks)
{
    std::vector<Message> leftOut;
    if (const ExodusArray* moves = displacement(exodus); moves != nullptr && !request.displaced)
        leftOut.push_back(
            Message::say("It has displacements ('%1'); its nodes are not moved by them. 'displace' moves them.",
                         printable(moves->name)));
    if (blocks.flat > 0 && !blocks.volumes.empty())
        leftOut.push_back(blocks.flat == 1
                              ? Message::say("1 of its blocks has lines or surfaces and is left out.")
                              : Message::say("%1 of its blocks have lines or surfaces and are left out.", blocks.flat));
    if (!blocks.unknown.empty())
        leftOut.push_back(
            Message::say("%1 of its blocks have elements of a shape that TAn does not support ('%2') and are left out.",
                         blocks.unknown.size(), printable(blocks.unknown.front())));
    return leftOut;
}

Status displaceNodes(const ExodusFile& exodus, std::size_t step, std::vector<Eigen::Vector3d>& positions)
{
    const ExodusArray* moves = displacement(exodus);
    if (moves == nullptr)
        return Error{ErrorKind::WrongUsage,
                     Message::say("it has no displacements, whose names begin with 'disp'. Leave 'displace' out.")};
    for (std::size_t axis = 0; axis < moves->numbers.size(); ++axis) {
        const auto values = nodeValues(exodus, moves->numbers[axis], step);
        if (!values)
            return values.error();
        for (std::size_t node = 0; node < positions.size(); ++node)
            positions[node][static_cast<Eigen::Index>(axis)] += values->numbers[node];
    }
    return {};
}

/// Only the nodes that cells use, numbered anew.
void leaveOutUnusedNodes(FileFindings& found, std::vector<double>* values)
{
    constexpr std::uint64_t unused = ~std::uint64_t(0);
    std::vector<std::uint64_t> renumbered(found.positions.size(), unused);
    const auto forEachNode = [&](const auto& function) {
        for (std::size_t cell = 0; cell < found.shapes.size(); ++cell) {
            const bool hasFaces = found.shapes[cell] == CellShape::Polyhedron;
            for (std::uint64_t at = found.offsets[cell]; at < found.offsets[cell + 1]; ++at) {
                const std::uint64_t count = hasFaces ? found.corners[at++] : 1;
                for (std::uint64_t node = 0; node < count; ++node)
                    function(found.corners[at + node]);
                at += count - 1;
            }
        }
    };
    forEachNode([&](std::uint64_t& node) { renumbered[node] = 0; });
    std::uint64_t kept = 0;
    for (std::size_t node = 0; node < renumbered.size(); ++node)
        if (renumbered[node] != unused) {
            found.positions[kept] = found.positions[node];
            if (values != nullptr)
                (*values)[kept] = (*values)[node];
            renumbered[node] = kept++;
        }
    found.positions.resize(kept);
    if (values != nullptr)
        values->resize(kept);
    forEachNode([&](std::uint64_t& node) { node = renumbered[node]; });
}

std::string nameOf(const ChosenArray& chosen)
{
    if (chosen.array.parts.size() == 1)
        return chosen.array.name;
    return chosen.component ? chosen.array.parts[*chosen.component] : chosen.array.name + " (magnitude)";
}

void remarkCorners(const ArrayValues& read, FileFindings& found)
{
    std::uint64_t more = 0;
    for (const auto& [block, shape] : read.blocks)
        more += shape.shape != CellShape::Polyhedron && block->nodesPerElement > shape.nodes ? block->elements : 0;
    if (more > 0)
        found.remarks.push_back(Message::say(
            "%1 elements have nodes beyond those of linear and quadratic shapes, which were left out.", more));
}

/// What both of the following begin with.
struct OpenedExodus {
    ExodusFile exodus{};
    ChosenBlocks blocks{}; ///< of that
    std::size_t step = 0;
};

Result<OpenedExodus> openExodus(const NetCdfFile& file, const NetCdfRequest& request)
{
    OpenedExodus opened;
    auto exodus = exodusFile(file);
    if (!exodus)
        return exodus.error();
    opened.exodus = *std::move(exodus);
    if (opened.exodus.arrays.empty())
        return noArrays(opened.exodus);
    const auto blocks = chooseBlocks(opened.exodus, request.part);
    if (!blocks)
        return blocks.error();
    const auto step = stepOf(opened.exodus, request);
    if (!step)
        return step.error();
    opened.blocks = *blocks;
    opened.step = *step;
    return opened; // moved: the blocks of a copy would be those of the first one
}

/// The array that would be read: of those that nobody names, which one is not constant shows only in the values.
Result<ChosenArray> arrayForContents(const ExodusFile& exodus, const ChosenBlocks& blocks, const NetCdfRequest& request,
                                     std::size_t step)
{
    constexpr std::uint64_t mostRead = std::uint64_t(1) << 22;
    if (!isAutomatic(request))
        return chooseArray(exodus, request);
    if (exodus.arrays.size() == 1 || exodus.nodes > mostRead)
        return withComponent({exodus.arrays.front()}, request.component);
    auto wanted = readWanted(exodus, blocks, request, step);
    return wanted ? Result<ChosenArray>(std::move(wanted->chosen)) : wanted.error();
}

Status asPoints(bool perCell, FileFindings& found)
{
    if (perCell)
        return Error{ErrorKind::BadInput,
                     Message::say("its array '%1' has values for its surfaces, not its points. Choose an array of "
                                  "points.",
                                  printable(found.arrayName))};
    found.kind = FoundKind::Points;
    found.remarks.push_back(
        Message::say("The lines and polygons that join its points were left out: they are scattered points."));
    return {};
}

Status addCells(const ExodusFile& exodus, const ChosenBlocks& blocks, bool perCell, ArrayValues& read,
                FileFindings& found)
{
    if (read.blocks.empty())
        return Error{ErrorKind::BadInput, Message::say("none of the blocks that are taken has '%1'. Choose another "
                                                       "array or part.",
                                                       printable(found.arrayName))};
    found.kind = FoundKind::Cells;
    found.perCell = perCell;
    for (const auto& [block, shape] : read.blocks)
        if (const Status added = addBlock(exodus, *block, shape, found); !added)
            return added.error();
    leaveOutUnusedNodes(found, perCell ? nullptr : &read.values.numbers);
    if (const std::size_t without = blocks.volumes.size() - read.blocks.size(); without == 1)
        found.remarks.push_back(
            Message::say("1 of its blocks has no '%1' and was left out.", printable(found.arrayName)));
    else if (without > 1)
        found.remarks.push_back(
            Message::say("%1 of its blocks have no '%2' and were left out.", without, printable(found.arrayName)));
    remarkCorners(read, found);
    return {};
}

} // namespace

Result<FileFindings> exodusFindings(const NetCdfFile& file, const NetCdfRequest& request, const TellProgress& progress)
{
    const auto opened = openExodus(file, request);
    if (!opened)
        return opened.error();
    const auto& [exodus, blocks, step] = *opened;
    if (const Status fits = checkUntold(request.given, {"unit"}); !fits)
        return fits.error();
    auto wanted = readWanted(exodus, blocks, request, step);
    if (!wanted)
        return wanted.error();
    progress(0.5);
    auto positions = nodePositions(exodus);
    if (!positions)
        return positions.error();
    FileFindings found;
    found.positions = *std::move(positions);
    if (request.displaced)
        if (const Status moved = displaceNodes(exodus, step, found.positions); !moved)
            return moved.error();
    found.arrayName = nameOf(wanted->chosen);
    found.untold = {"unit"};
    found.type = wanted->chosen.component ? storedType(exodus, wanted->chosen.array) : SampleType::Float64;
    found.taken = takenOf(exodus, request, wanted->chosen);
    if (const ExodusValues& values = wanted->read.values; values.noNumber)
        found.taken.push_back(
            {TakenPart::Fill,
             values.isGuessed ? filledByLibrary(*values.noNumber) : Message(numberText(*values.noNumber)),
             values.isGuessed});
    found.leftOut = leftOutOf(exodus, request, blocks);
    const bool perCell = wanted->chosen.array.perCell;
    const Status added =
        blocks.volumes.empty() ? asPoints(perCell, found) : addCells(exodus, blocks, perCell, wanted->read, found);
    if (!added)
        return added.error();
    const std::span bytes = std::as_bytes(std::span(wanted->read.values.numbers));
    found.samples.assign(bytes.begin(), bytes.end());
    return found;
}

Result<FileContents> exodusContents(const NetCdfFile& file, const NetCdfRequest& request)
{
    const auto opened = openExodus(file, request);
    if (!opened)
        return opened.error();
    const auto& [exodus, blocks, step] = *opened;
    const auto chosen = arrayForContents(exodus, blocks, request, step);
    if (!chosen)
        return chosen.error();
    FileContents contents;
    contents.domain = blocks.volumes.empty() ? DomainClass::Scattered : DomainClass::Irregular;
    contents.points = exodus.nodes;
    contents.type = chosen->component ? storedType(exodus, chosen->array) : SampleType::Float64;
    for (const auto& [block, shape] : blocks.volumes)
        contents.cells += block->elements;
    for (const ExodusBlock& block : exodus.blocks)
        contents.blocks.push_back(blockName(block));
    for (const ExodusArray& array : exodus.arrays)
        contents.arrays.push_back(
            {.name = array.name, .components = static_cast<int>(array.parts.size()), .perCell = array.perCell});
    contents.timeSteps = exodus.times;
    contents.untold = {"unit"};
    contents.taken = takenOf(exodus, request, *chosen);
    contents.leftOut = leftOutOf(exodus, request, blocks);
    return contents;
}

} // namespace tetra
