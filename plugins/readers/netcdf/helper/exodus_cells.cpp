// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/exodus_cells.h"

#include <algorithm>
#include <array>
#include <span>

namespace tetra {
namespace {

/// Where VTK's corner numbers of quadratic cells differ: Exodus goes round the bottom, up the sides, round the top.
constexpr std::array<std::size_t, 20> hexahedronOrder = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                                         10, 11, 16, 17, 18, 19, 12, 13, 14, 15};
/// Then the middle, and the faces below, above, left, right, in front, behind; VTK begins left.
constexpr std::array<std::size_t, 27> triquadraticOrder = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 16, 17,
                                                           18, 19, 12, 13, 14, 15, 23, 24, 25, 26, 21, 22, 20};
constexpr std::array<std::size_t, 15> prismOrder = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11};

std::span<const std::size_t> orderOf(CellShape shape)
{
    switch (shape) {
    case CellShape::QuadraticHexahedron: return hexahedronOrder;
    case CellShape::TriquadraticHexahedron: return triquadraticOrder;
    case CellShape::QuadraticPrism: return prismOrder;
    default: return {};
    }
}

struct KnownShape {
    std::string_view name; ///< that types begin with
    CellShape shape;
    std::uint64_t nodes;
};

/// Of each name the one with the most nodes that are there comes first.
constexpr std::array<KnownShape, 9> volumes = {{{"TET", CellShape::QuadraticTetrahedron, 10},
                                                {"TET", CellShape::Tetrahedron, 4},
                                                {"PYR", CellShape::QuadraticPyramid, 13},
                                                {"PYR", CellShape::Pyramid, 5},
                                                {"WED", CellShape::QuadraticPrism, 15},
                                                {"WED", CellShape::Prism, 6},
                                                {"HEX", CellShape::TriquadraticHexahedron, 27},
                                                {"HEX", CellShape::QuadraticHexahedron, 20},
                                                {"HEX", CellShape::Hexahedron, 8}}};
constexpr std::array<std::string_view, 16> flats = {"SHELL",  "SHEL",   "TRI",   "QUAD", "BAR",    "BEAM",
                                                    "TRUSS",  "ROD",    "EDGE",  "LINE", "SPHERE", "SPH",
                                                    "CIRCLE", "NSIDED", "POINT", "NODE"};

Error shortList(const std::string& name)
{
    return {
        ErrorKind::BadInput,
        Message::say("its list '%1' is missing or shorter than its elements require. It is damaged: export it again.",
                     name)};
}

/// Numbers of a list, from 1 up to `most`, made to be from 0.
Result<std::vector<std::uint64_t>> numbersFromOne(const ExodusFile& exodus, const std::string& name, std::uint64_t most)
{
    const NetCdfVariable* variable = exodus.file->find(name);
    if (variable == nullptr || !NetCdfFile::isNumeric(*variable))
        return shortList(name);
    const auto read = exodus.file->readIntegers(*variable);
    if (!read)
        return read.error();
    std::vector<std::uint64_t> numbers(read->size());
    for (std::size_t at = 0; at < numbers.size(); ++at) {
        if ((*read)[at] < 1 || static_cast<std::uint64_t>((*read)[at]) > most)
            return Error{
                ErrorKind::BadInput,
                Message::say("its list '%1' contains number %2, and there are %3. It is damaged: export it again.",
                             name, (*read)[at], most)};
        numbers[at] = static_cast<std::uint64_t>((*read)[at] - 1);
    }
    return numbers;
}

/// Where each entry of a list of so many lists begins, and where the last one ends.
Result<std::vector<std::uint64_t>> beginnings(const ExodusFile& exodus, const std::string& name, std::uint64_t entries)
{
    const NetCdfVariable* variable = exodus.file->find(name);
    if (variable == nullptr || !NetCdfFile::isNumeric(*variable))
        return shortList(name);
    const auto counts = exodus.file->readIntegers(*variable);
    if (!counts)
        return counts.error();
    if (counts->size() != entries)
        return shortList(name);
    constexpr std::int64_t most = std::int64_t(1) << 40;
    std::vector<std::uint64_t> begins{0};
    for (const std::int64_t count : *counts) {
        if (count < 0 || count > most || begins.back() > std::uint64_t(most))
            return shortList(name);
        begins.push_back(begins.back() + static_cast<std::uint64_t>(count));
    }
    return begins;
}

/// The nodes of all faces of the file's face blocks, one face after the other.
struct Faces {
    std::vector<std::uint64_t> begins{0};
    std::vector<std::uint64_t> nodes{};
};

Result<Faces> facesOf(const ExodusFile& exodus)
{
    Faces faces;
    const std::uint64_t blocks = exodus.file->length("num_fa_blk").value_or(0);
    for (std::size_t block = 1; block <= blocks; ++block) {
        const std::uint64_t count = exodus.file->length(numbered("num_fa_in_blk", block)).value_or(0);
        if (count == 0)
            continue;
        const auto nodes = numbersFromOne(exodus, numbered("fbconn", block), exodus.nodes);
        if (!nodes)
            return nodes.error();
        const auto begins = beginnings(exodus, numbered("fbepecnt", block), count);
        if (!begins)
            return begins.error();
        if (begins->back() != nodes->size())
            return shortList(numbered("fbconn", block));
        const std::uint64_t before = faces.nodes.size();
        for (std::size_t face = 1; face < begins->size(); ++face)
            faces.begins.push_back(before + (*begins)[face]);
        faces.nodes.insert(faces.nodes.end(), nodes->begin(), nodes->end());
    }
    return faces;
}

Status addPolyhedra(const ExodusFile& exodus, const ExodusBlock& block, FileFindings& found)
{
    const auto faces = facesOf(exodus);
    if (!faces)
        return faces.error();
    const auto lists = numbersFromOne(exodus, numbered("facconn", block.number), faces->begins.size() - 1);
    if (!lists)
        return lists.error();
    const auto begins = beginnings(exodus, numbered("ebepecnt", block.number), block.elements);
    if (!begins)
        return begins.error();
    if (begins->back() != lists->size())
        return shortList(numbered("facconn", block.number));
    for (std::size_t element = 0; element < block.elements; ++element) {
        for (std::uint64_t at = (*begins)[element]; at < (*begins)[element + 1]; ++at) {
            const std::uint64_t first = faces->begins[(*lists)[at]], last = faces->begins[(*lists)[at] + 1];
            found.corners.push_back(last - first);
            found.corners.insert(found.corners.end(), faces->nodes.begin() + std::ptrdiff_t(first),
                                 faces->nodes.begin() + std::ptrdiff_t(last));
        }
        found.shapes.push_back(CellShape::Polyhedron);
        found.offsets.push_back(found.corners.size());
    }
    return {};
}

} // namespace

std::optional<ExodusShape> shapeOf(const ExodusBlock& block)
{
    if (block.type.starts_with("NFACED"))
        return ExodusShape{CellShape::Polyhedron, 0};
    for (const KnownShape& known : volumes)
        if (block.type.starts_with(known.name) && block.nodesPerElement >= known.nodes)
            return ExodusShape{known.shape, known.nodes};
    const bool isFlat = std::ranges::any_of(flats, [&](std::string_view name) { return block.type.starts_with(name); });
    return isFlat ? std::optional(ExodusShape{CellShape::Flat, block.nodesPerElement}) : std::nullopt;
}

Status addBlock(const ExodusFile& exodus, const ExodusBlock& block, const ExodusShape& shape, FileFindings& found)
{
    if (found.offsets.empty())
        found.offsets.push_back(0);
    if (shape.shape == CellShape::Polyhedron)
        return addPolyhedra(exodus, block, found);
    const std::string name = numbered("connect", block.number);
    const auto nodes = numbersFromOne(exodus, name, exodus.nodes);
    if (!nodes)
        return nodes.error();
    if (nodes->size() / std::max<std::uint64_t>(1, block.nodesPerElement) != block.elements)
        return shortList(name);
    const std::span<const std::size_t> order = orderOf(shape.shape);
    for (std::size_t element = 0; element < block.elements; ++element) {
        const std::uint64_t* corners = nodes->data() + element * block.nodesPerElement;
        for (std::size_t corner = 0; corner < shape.nodes; ++corner)
            found.corners.push_back(corners[order.empty() ? corner : order[corner]]);
        found.shapes.push_back(shape.shape);
        found.offsets.push_back(found.corners.size());
    }
    return {};
}

} // namespace tetra
