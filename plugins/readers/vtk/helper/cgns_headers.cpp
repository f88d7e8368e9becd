// SPDX-License-Identifier: GPL-3.0-or-later
// The standard: https://cgns.github.io/CGNS_docs_current/sids and .../filemap
#include "plugins/readers/vtk/helper/cgns_headers.h"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgns_io.h)
// clang-format on

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

namespace tetra {
namespace {

constexpr std::size_t mostCgnsNodes = 200'000; // some 2 kB each, most of them in the library
/// What is of interest lies along such a path; nodes elsewhere may lead back to where they are.
constexpr std::array<std::string_view, 5> followedLabels{"CGNSBase_t", "Zone_t", "FlowSolution_t", "DataArray_t",
                                                         "DimensionalExponents_t"};
constexpr cgsize_t mostCgnsData = 1024; // of a node whose data are read

bool isLabelOf(std::string_view label, std::initializer_list<std::string_view> labels)
{
    return std::ranges::find(labels, label) != labels.end();
}

/// A file that is open; its nodes are known by numbers.
class CgnsFile {
public:
    explicit CgnsFile(const std::string& path)
    {
        isOpen_ = cgio_open_file(path.c_str(), CGIO_MODE_READ, CGIO_FILE_NONE, &file_) == CGIO_ERR_NONE;
    }
    CgnsFile(const CgnsFile&) = delete;
    CgnsFile& operator=(const CgnsFile&) = delete;
    ~CgnsFile()
    {
        if (isOpen_)
            cgio_close_file(file_);
    }

    std::optional<CgnsNode> root()
    {
        double id = 0;
        if (!isOpen_ || cgio_get_root_id(file_, &id) != CGIO_ERR_NONE)
            return std::nullopt;
        CgnsNode node;
        return addChildren(id, node, 0) ? std::optional(std::move(node)) : std::nullopt;
    }

private:
    bool addChildren(double id, CgnsNode& node, std::size_t depth)
    {
        int count = 0, got = 0;
        if (cgio_number_children(file_, id, &count) != CGIO_ERR_NONE || count < 0)
            return false;
        nodes_ += static_cast<std::size_t>(count);
        if (nodes_ > mostCgnsNodes)
            return false;
        std::vector<double> ids(static_cast<std::size_t>(count));
        if (count > 0 && cgio_children_ids(file_, id, 1, count, &got, ids.data()) != CGIO_ERR_NONE)
            return false;
        ids.resize(static_cast<std::size_t>(std::clamp(got, 0, count)));
        bool isRead = true;
        for (const double child : ids) { // what was given must be released, read or not
            if (isRead)
                isRead = read(child, node.children.emplace_back(), depth);
            cgio_release_id(file_, child);
        }
        return isRead;
    }

    bool read(double id, CgnsNode& node, std::size_t depth)
    {
        std::array<char, CGIO_MAX_NAME_LENGTH + 1> name{}, label{};
        std::array<char, CGIO_MAX_DATATYPE_LENGTH + 1> type{};
        if (cgio_get_name(file_, id, name.data()) != CGIO_ERR_NONE ||
            cgio_get_label(file_, id, label.data()) != CGIO_ERR_NONE ||
            cgio_get_data_type(file_, id, type.data()) != CGIO_ERR_NONE)
            return false;
        node.name = name.data();
        node.label = label.data();
        node.type = type.data();
        if (isLabelOf(node.label, {"CGNSBase_t", "Zone_t", "ZoneType_t", "GridLocation_t", "DataClass_t",
                                   "DimensionalUnits_t", "DimensionalExponents_t"}) &&
            !readData(id, node))
            return false;
        return depth >= followedLabels.size() || node.label != followedLabels[depth] ||
               addChildren(id, node, depth + 1);
    }

    bool readData(double id, CgnsNode& node)
    {
        std::array<cgsize_t, CGIO_MAX_DIMENSIONS> size{};
        int dimensions = 0;
        if (cgio_get_dimensions(file_, id, &dimensions, size.data()) != CGIO_ERR_NONE || dimensions < 1 ||
            dimensions > CGIO_MAX_DIMENSIONS)
            return false;
        cgsize_t count = 1;
        for (int axis = 0; axis < dimensions; ++axis) {
            if (size[static_cast<std::size_t>(axis)] < 1 || size[static_cast<std::size_t>(axis)] > mostCgnsData / count)
                return false;
            count *= size[static_cast<std::size_t>(axis)];
        }
        if (node.type == "C1") {
            node.text.resize(static_cast<std::size_t>(count));
            return cgio_read_all_data_type(file_, id, "C1", node.text.data()) == CGIO_ERR_NONE;
        }
        return (node.type == "I4" && readNumbers<std::int32_t>(id, count, node)) ||
               (node.type == "I8" && readNumbers<std::int64_t>(id, count, node)) ||
               (node.type == "R4" && readNumbers<float>(id, count, node)) ||
               (node.type == "R8" && readNumbers<double>(id, count, node));
    }

    template <class Number> bool readNumbers(double id, cgsize_t count, CgnsNode& node)
    {
        std::vector<Number> numbers(static_cast<std::size_t>(count));
        if (cgio_read_all_data_type(file_, id, node.type.c_str(), numbers.data()) != CGIO_ERR_NONE)
            return false;
        node.numbers.reserve(numbers.size());
        for (const Number number : numbers)
            node.numbers.push_back(static_cast<double>(number));
        return true;
    }

    int file_ = 0;
    bool isOpen_ = false;
    std::size_t nodes_ = 0;
};

} // namespace

const CgnsNode* CgnsNode::child(std::string_view childLabel) const
{
    const auto found = std::ranges::find(children, childLabel, &CgnsNode::label);
    return found == children.end() ? nullptr : &*found;
}

std::optional<CgnsNode> readCgnsHeaders(const std::string& path)
{
    return CgnsFile(path).root();
}

} // namespace tetra
