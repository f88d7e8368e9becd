// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_tree.h"

#include "plugins/readers/zarr/helper/ome_image.h"
#include "plugins/readers/zarr/helper/zarr_array.h"

#include <algorithm>
#include <deque>

namespace tetra {
namespace {

constexpr std::size_t mostNodes = 4096, mostWaiting = 65536;

/// Numbers along at least three axes that TAn reads.
bool isVolume(const std::string& path, const ZarrNode& node)
{
    constexpr std::size_t space = 3;
    const auto array = zarrArray(path, node);
    return array && array->shape.size() >= space;
}

/// Puts a group or an array where it belongs; whether to look into it.
bool isLookedInto(const ZarrFolder& folder, const std::string& path, const ZarrNode& node, ZarrTree& tree)
{
    if (node.kind == ZarrNode::Kind::Array) {
        if (isVolume(path, node))
            tree.arrays.push_back(path);
        else
            ++tree.others;
        return false;
    }
    if (node.kind == ZarrNode::Kind::None || !isOmeImage(node.attributes))
        return node.kind == ZarrNode::Kind::Group;
    tree.images.push_back(path);
    const auto inside = folder.folders(path);
    tree.hasLabels = tree.hasLabels || std::ranges::find(inside, "labels") != inside.end();
    return false;
}

} // namespace

Result<ZarrTree> zarrTree(const ZarrFolder& folder)
{
    ZarrTree tree;
    std::deque<std::string> waiting{""};
    for (std::size_t count = 0; !waiting.empty(); ++count) {
        const std::string path = waiting.front();
        waiting.pop_front();
        if (count >= mostNodes) {
            tree.isCut = true;
            break;
        }
        const auto node = zarrNode(folder, path);
        if (!node && path.empty())
            return node.error();
        if (!node) {
            ++tree.damaged;
            continue;
        }
        if (!isLookedInto(folder, path, *node, tree))
            continue;
        for (const std::string& name : folder.folders(path))
            if (name == "labels")
                tree.hasLabels = true;
            else if (waiting.size() < mostWaiting)
                waiting.push_back(zarrPath(path, name));
    }
    std::ranges::sort(tree.images);
    std::ranges::sort(tree.arrays);
    return tree;
}

} // namespace tetra
