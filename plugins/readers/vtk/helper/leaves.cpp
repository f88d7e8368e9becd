// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/leaves.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>

#include <algorithm>
#include <cstdint>

namespace tetra {
namespace {

std::string nameOf(vtkCompositeDataIterator& at, std::size_t number)
{
    if (at.HasCurrentMetaData() != 0)
        if (const char* name = at.GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()); name != nullptr && *name != 0)
            return name;
    return "part " + std::to_string(number);
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
    auto* parts = vtkCompositeDataSet::SafeDownCast(&data);
    if (parts == nullptr)
        return leaves;
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(parts->NewIterator());
    for (at->InitTraversal(); at->IsDoneWithTraversal() == 0; at->GoToNextItem())
        if (auto* leaf = vtkDataSet::SafeDownCast(at->GetCurrentDataObject());
            leaf != nullptr && leaf->GetNumberOfPoints() > 0)
            leaves.push_back({nameOf(*at, leaves.size() + 1), leaf});
    return leaves;
}

Result<VtkLeaf> chooseLeaf(const std::vector<VtkLeaf>& leaves, const std::string& wanted)
{
    const auto found = std::ranges::find(leaves, wanted, &VtkLeaf::name);
    if (found != leaves.end())
        return *found;
    if (const auto number = parseNumber<std::uint64_t>(wanted); number && *number >= 1 && *number <= leaves.size())
        return leaves[*number - 1];
    return Error{ErrorKind::WrongUsage, Message::say("it has no part '%1'. %2", wanted,
                                                     leaves.size() == 1 && leaves[0].name.empty()
                                                         ? Message::say("It is all one: leave 'part' empty.")
                                                         : Message::say("There is: %1.", namesText(leaves)))};
}

} // namespace tetra
