// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/leaves.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>

#include <algorithm>
#include <cstdint>

namespace tetra {
namespace {

std::string nameIn(vtkInformation* metaData, std::size_t number)
{
    const char* name = metaData == nullptr ? nullptr : metaData->Get(vtkCompositeDataSet::NAME());
    return name != nullptr && *name != 0 ? name : "part " + std::to_string(number);
}

/// A leaf with the names of the blocks in which it lies: "solid/internalMesh".
struct NestedLeaf {
    VtkLeaf leaf;
    std::string path;
};

void addLeaf(const std::string& name, const std::string& path, vtkDataObject* data, std::vector<NestedLeaf>& leaves)
{
    if (auto* leaf = vtkDataSet::SafeDownCast(data); leaf != nullptr && leaf->GetNumberOfPoints() > 0)
        leaves.push_back({{name, leaf}, path + name});
}

void addLeaves(vtkCompositeDataSet& parts, const std::string& path, std::vector<NestedLeaf>& leaves)
{
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&parts)) {
        for (unsigned block = 0; block < blocks->GetNumberOfBlocks(); ++block) {
            const std::string name =
                nameIn(blocks->HasMetaData(block) != 0 ? blocks->GetMetaData(block) : nullptr, leaves.size() + 1);
            if (auto* inner = vtkCompositeDataSet::SafeDownCast(blocks->GetBlock(block)))
                addLeaves(*inner, path + name + "/", leaves);
            else
                addLeaf(name, path, blocks->GetBlock(block), leaves);
        }
        return;
    }
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(parts.NewIterator());
    for (at->InitTraversal(); at->IsDoneWithTraversal() == 0; at->GoToNextItem())
        addLeaf(nameIn(at->HasCurrentMetaData() != 0 ? at->GetCurrentMetaData() : nullptr, leaves.size() + 1), path,
                at->GetCurrentDataObject(), leaves);
}

std::string namesText(const std::vector<VtkLeaf>& leaves)
{
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t leaf = 0; leaf < std::min(most, leaves.size()); ++leaf)
        text += (text.empty() ? "" : ", ") + leaves[leaf].name;
    return text + (leaves.size() > most ? " ..." : "");
}

} // namespace

std::vector<VtkLeaf> leavesOf(vtkDataObject& data)
{
    std::vector<VtkLeaf> leaves;
    if (auto* whole = vtkDataSet::SafeDownCast(&data)) {
        if (whole->GetNumberOfPoints() > 0)
            leaves.push_back({"", whole});
        return leaves;
    }
    std::vector<NestedLeaf> nested;
    if (auto* parts = vtkCompositeDataSet::SafeDownCast(&data))
        addLeaves(*parts, "", nested);
    for (const NestedLeaf& one : nested) {
        const auto sameName = [&](const NestedLeaf& other) { return other.leaf.name == one.leaf.name; };
        leaves.push_back(one.leaf);
        if (std::ranges::count_if(nested, sameName) > 1)
            leaves.back().name = one.path;
    }
    return leaves;
}

Result<std::size_t> chooseLeaf(const std::vector<VtkLeaf>& leaves, const std::string& wanted)
{
    const auto found = std::ranges::find(leaves, wanted, &VtkLeaf::name);
    if (found != leaves.end())
        return static_cast<std::size_t>(found - leaves.begin());
    if (const auto number = parseNumber<std::uint64_t>(wanted); number && *number >= 1 && *number <= leaves.size())
        return static_cast<std::size_t>(*number - 1);
    return Error{ErrorKind::WrongUsage, Message::say("it has no part '%1'. %2", wanted,
                                                     leaves.size() == 1 && leaves[0].name.empty()
                                                         ? Message::say("It has only one: leave 'part' empty.")
                                                         : Message::say("Available: %1.", namesText(leaves)))};
}

} // namespace tetra
