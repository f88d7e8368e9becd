// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/ply_head.h"

#include "core/mesh/files/mesh_formats.h"

#include <algorithm>

namespace tetra {

PlyHead& PlyHead::comment(std::string_view text)
{
    std::string line(text);
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    text_ += "comment " + line + "\n";
    return *this;
}

PlyHead& PlyHead::facts(const MeshFacts& facts)
{
    for (const auto& [name, fact] : facts)
        comment(name + ": " + factText(fact));
    return *this;
}

PlyHead& PlyHead::element(std::string_view name, std::uint64_t count)
{
    text_ += "element " + std::string(name) + " " + std::to_string(count) + "\n";
    return *this;
}

PlyHead& PlyHead::property(std::string_view type, std::string_view name)
{
    std::string word(name);
    std::ranges::replace_if(
        word, [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
    text_ += "property " + std::string(type) + " " + word + "\n";
    return *this;
}

PlyHead& PlyHead::vertexList()
{
    text_ += "property list uchar int vertex_indices\n";
    return *this;
}

} // namespace tetra
