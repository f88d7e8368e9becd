// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/exodus_file.h"

#include "plugins/readers/netcdf/helper/stored_values.h"

#include <netcdf.h>

#include <algorithm>
#include <limits>

namespace tetra {
namespace {

std::string upper(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

Result<std::vector<std::string>> textsOf(const NetCdfFile& file, const char* name)
{
    const NetCdfVariable* variable = file.find(name);
    return variable == nullptr ? Result<std::vector<std::string>>(std::vector<std::string>())
                               : file.readTexts(*variable);
}

Result<std::vector<ExodusBlock>> blocksOf(const NetCdfFile& file)
{
    const auto names = textsOf(file, "eb_names");
    if (!names)
        return names.error();
    std::vector<std::int64_t> ids;
    if (const NetCdfVariable* property = file.find("eb_prop1")) {
        auto read = file.readIntegers(*property);
        if (!read)
            return read.error();
        ids = *std::move(read);
    }
    std::vector<ExodusBlock> blocks;
    const std::uint64_t count = file.length("num_el_blk").value_or(0);
    for (std::size_t number = 1; number <= count; ++number) {
        ExodusBlock block{.number = number, .id = static_cast<std::int64_t>(number)};
        block.elements = file.length(numbered("num_el_in_blk", number)).value_or(0);
        block.nodesPerElement = file.length(numbered("num_nod_per_el", number)).value_or(0);
        if (number <= ids.size())
            block.id = ids[number - 1];
        if (number <= names->size())
            block.name = (*names)[number - 1];
        for (const char* list : {"connect", "facconn"})
            if (const NetCdfVariable* connection = file.find(numbered(list, number)))
                block.type = upper(file.text(*connection, "elem_type"));
        if (block.elements > 0)
            blocks.push_back(std::move(block));
    }
    return blocks;
}

/// The variables as arrays: neighbours "a_x, a_y, a_z" are one of three components.
std::vector<ExodusArray> groupedArrays(const std::vector<std::string>& names, bool perCell)
{
    constexpr std::string_view separators = "_-. ";
    std::vector<ExodusArray> arrays;
    const auto endsWith = [&](std::size_t at, std::size_t component, std::string_view stem) {
        if (at >= names.size() || names[at].size() != stem.size() + 1 || !names[at].starts_with(stem))
            return false;
        const char last = names[at].back();
        return last == "xyz"[component] || last == "XYZ"[component];
    };
    for (std::size_t at = 0; at < names.size();) {
        const std::string stem = names[at].substr(0, names[at].empty() ? 0 : names[at].size() - 1);
        std::size_t components = 0;
        while (!stem.empty() && components < 3 && endsWith(at + components, components, stem))
            ++components;
        ExodusArray array{.name = names[at], .perCell = perCell};
        if (components < 2)
            components = 1;
        else
            array.name = stem;
        for (std::size_t part = 0; part < components; ++part, ++at) {
            array.parts.push_back(names[at]);
            array.numbers.push_back(at + 1);
        }
        const std::string bare = array.name.substr(0, array.name.find_last_not_of(separators) + 1);
        const bool isFree = std::ranges::find(names, bare) == names.end();
        if (components > 1 && !bare.empty() && isFree)
            array.name = bare;
        arrays.push_back(std::move(array));
    }
    return arrays;
}

/// Steps, or parts of one, that a program never came to.
void markUnwritten(const NetCdfFile& file, const NetCdfVariable& variable, ExodusValues& values)
{
    const auto named = file.numbers(variable, "_FillValue");
    const auto unwritten = named.size() == 1 ? std::optional(named[0]) : libraryFillOf(file, variable);
    if (!unwritten)
        return;
    const auto stored = static_cast<double>(*unwritten);
    for (double& number : values.numbers)
        if (number == stored) {
            number = std::numeric_limits<double>::quiet_NaN();
            values.noNumber = unwritten;
        }
    values.isGuessed = values.noNumber && named.empty();
}

/// Values of one time step, `count` of them, of a variable (time, values), or (values) without times.
Result<ExodusValues> valuesAt(const NetCdfFile& file, const NetCdfVariable& variable, std::size_t step,
                              std::uint64_t count, std::optional<std::size_t> number)
{
    const std::size_t rank = number ? 3 : 2;
    NetCdfPart part = file.whole(variable);
    const bool fits = part.count.size() == rank && step < part.count[0] && part.count.back() == count &&
                      (!number || *number < part.count[1]);
    if (!fits)
        return Error{ErrorKind::BadInput, Message::say("its variable '%1' does not have %2 values at time step %3. It "
                                                       "is damaged or was not written completely: export it again.",
                                                       printable(variable.path), count, step + 1)};
    part.first[0] = step;
    part.count[0] = 1;
    if (number) {
        part.first[1] = *number;
        part.count[1] = 1;
    }
    auto numbers = file.readDoubles(variable, part);
    if (!numbers)
        return numbers.error();
    ExodusValues values{.numbers = *std::move(numbers)};
    markUnwritten(file, variable, values);
    return values;
}

} // namespace

std::string numbered(const char* name, std::size_t number)
{
    return name + std::to_string(number);
}

bool isExodus(const NetCdfFile& file)
{
    const bool hasElements = file.length("num_el_blk").has_value() || file.length("num_elem").has_value();
    return file.length("num_nodes").has_value() && (hasElements || file.hasGlobal("api_version"));
}

std::string blockName(const ExodusBlock& block)
{
    return block.name.empty() ? "block " + std::to_string(block.id) : block.name;
}

Result<ExodusFile> exodusFile(const NetCdfFile& file)
{
    ExodusFile exodus{.file = &file};
    exodus.nodes = file.length("num_nodes").value_or(0);
    exodus.dimensions = static_cast<int>(std::min<std::uint64_t>(3, file.length("num_dim").value_or(3)));
    auto blocks = blocksOf(file);
    if (!blocks)
        return blocks.error();
    exodus.blocks = *std::move(blocks);
    for (const auto& [name, perCell] : {std::pair{"name_nod_var", false}, {"name_elem_var", true}}) {
        const auto names = textsOf(file, name);
        if (!names)
            return names.error();
        const auto arrays = groupedArrays(*names, perCell);
        exodus.arrays.insert(exodus.arrays.end(), arrays.begin(), arrays.end());
    }
    if (const NetCdfVariable* times = file.find("time_whole"); times != nullptr && NetCdfFile::isNumeric(*times)) {
        auto read = file.readDoubles(*times, file.whole(*times));
        if (!read)
            return read.error();
        exodus.times = *std::move(read);
    }
    return exodus;
}

Result<std::vector<Eigen::Vector3d>> nodePositions(const ExodusFile& exodus)
{
    const NetCdfFile& file = *exodus.file;
    constexpr std::array<const char*, 3> names = {"coordx", "coordy", "coordz"};
    const NetCdfVariable* together = file.find("coord");
    std::vector<Eigen::Vector3d> positions(exodus.nodes, Eigen::Vector3d::Zero());
    for (int axis = 0; axis < exodus.dimensions; ++axis) {
        const NetCdfVariable* alone = file.find(names[static_cast<std::size_t>(axis)]);
        const NetCdfVariable* variable = alone != nullptr ? alone : together;
        if (variable == nullptr)
            return Error{ErrorKind::BadInput, Message::say("it has no coordinates of its nodes ('%1'). Write it with a "
                                                           "mesh.",
                                                           names[static_cast<std::size_t>(axis)])};
        NetCdfPart part = file.whole(*variable);
        const std::size_t rank = alone != nullptr ? 1 : 2;
        if (part.count.size() != rank || part.count.back() != exodus.nodes ||
            (rank == 2 && part.count[0] <= std::size_t(axis)))
            return Error{ErrorKind::BadInput,
                         Message::say("its coordinates '%1' are not those of %2 nodes. It is damaged: export it again.",
                                      printable(variable->path), exodus.nodes)};
        if (rank == 2) {
            part.first[0] = std::size_t(axis);
            part.count[0] = 1;
        }
        const auto values = file.readDoubles(*variable, part);
        if (!values)
            return values.error();
        for (std::size_t node = 0; node < positions.size(); ++node)
            positions[node][axis] = (*values)[node];
    }
    return positions;
}

SampleType storedType(const ExodusFile& exodus, const ExodusArray& array)
{
    const std::string number = std::to_string(array.numbers.front());
    std::vector<std::string> names{"vals_nod_var" + number, "vals_nod_var"};
    if (array.perCell) {
        names.clear();
        for (const ExodusBlock& block : exodus.blocks)
            names.push_back("vals_elem_var" + number + "eb" + std::to_string(block.number));
    }
    for (const std::string& name : names)
        if (const NetCdfVariable* variable = exodus.file->find(name))
            return variable->type == NC_FLOAT ? SampleType::Float32 : SampleType::Float64;
    return SampleType::Float64;
}

Result<ExodusValues> nodeValues(const ExodusFile& exodus, std::size_t variable, std::size_t step)
{
    const NetCdfFile& file = *exodus.file;
    if (const NetCdfVariable* alone = file.find(numbered("vals_nod_var", variable)))
        return valuesAt(file, *alone, step, exodus.nodes, std::nullopt);
    if (const NetCdfVariable* together = file.find("vals_nod_var"))
        return valuesAt(file, *together, step, exodus.nodes, variable - 1);
    return Error{
        ErrorKind::BadInput,
        Message::say("it lists a variable number %1 at its nodes but has no values of it. Export it again.", variable)};
}

Result<std::optional<ExodusValues>> elementValues(const ExodusFile& exodus, std::size_t variable,
                                                  const ExodusBlock& block, std::size_t step)
{
    const NetCdfVariable* found = exodus.file->find(numbered("vals_elem_var", variable) + numbered("eb", block.number));
    if (found == nullptr)
        return std::optional<ExodusValues>();
    auto values = valuesAt(*exodus.file, *found, step, block.elements, std::nullopt);
    return values ? Result<std::optional<ExodusValues>>(std::optional(*std::move(values))) : values.error();
}

const ExodusArray* displacement(const ExodusFile& exodus)
{
    const auto found = std::ranges::find_if(exodus.arrays, [&](const ExodusArray& array) {
        return !array.perCell && array.parts.size() == std::size_t(exodus.dimensions) &&
               upper(array.name).starts_with("DIS");
    });
    return found == exodus.arrays.end() ? nullptr : &*found;
}

} // namespace tetra
