// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace tetra {

using TestTetrahedra = std::vector<std::array<std::uint32_t, 4>>;
using TestTriangles = std::vector<std::array<std::uint32_t, 3>>;

/// The faces with one side, counterclockwise from outside, and how a mesh hangs together. Slow and plain.
struct TetrahedraTopology {
    std::string fault; ///< why the mesh does not conform, or its boundary is no closed surface; empty if neither
    TestTriangles boundary;
    int euler = 0;
    int components = 0;
    int boundaryComponents = 0;

    friend bool operator==(const TetrahedraTopology& a, const TetrahedraTopology& b)
    {
        return a.fault == b.fault && a.euler == b.euler && a.components == b.components &&
               a.boundaryComponents == b.boundaryComponents;
    }
};

namespace test_topology {

/// How many sets remain when the members of each simplex are joined.
template <class Simplices> int componentCount(const Simplices& simplices)
{
    std::map<std::uint32_t, std::uint32_t> parent;
    const auto root = [&](std::uint32_t vertex) {
        while (parent.at(vertex) != vertex)
            vertex = parent.at(vertex);
        return vertex;
    };
    for (const auto& simplex : simplices)
        for (const std::uint32_t vertex : simplex) {
            parent.try_emplace(vertex, vertex);
            parent[root(vertex)] = root(simplex[0]);
        }
    return static_cast<int>(
        std::ranges::count_if(parent, [](const auto& entry) { return entry.first == entry.second; }));
}

/// Whether the triangles around each vertex are one closed fan.
inline std::string surfaceFault(const TestTriangles& triangles)
{
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> next;
    for (const auto& triangle : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (!next[triangle[i]].try_emplace(triangle[(i + 1) % 3], triangle[(i + 2) % 3]).second)
                return "an edge of the boundary has two triangles on one side";
    for (const auto& [vertex, around] : next) {
        std::size_t length = 0;
        std::uint32_t at = around.begin()->first;
        do {
            const auto found = around.find(at);
            if (found == around.end())
                return "the boundary has an edge";
            at = found->second;
            ++length;
        } while (at != around.begin()->first && length <= around.size());
        if (length != around.size())
            return "the boundary touches itself at vertex " + std::to_string(vertex);
    }
    return {};
}

} // namespace test_topology

inline TetrahedraTopology topologyOf(const TestTetrahedra& tetrahedra)
{
    TetrahedraTopology topology;
    std::set<std::uint32_t> vertices;
    std::set<std::array<std::uint32_t, 2>> edges;
    std::map<std::array<std::uint32_t, 3>, std::vector<std::array<std::uint32_t, 3>>> faces;
    for (const auto& t : tetrahedra) {
        vertices.insert(t.begin(), t.end());
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < i; ++k)
                edges.insert({std::min(t[i], t[k]), std::max(t[i], t[k])});
        const std::array<std::array<std::uint32_t, 3>, 4> outwards = {
            {{t[1], t[2], t[3]}, {t[0], t[3], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[1]}}};
        for (auto face : outwards) {
            auto key = face;
            std::ranges::sort(key);
            std::ranges::rotate(face, std::ranges::min_element(face));
            faces[key].push_back(face);
        }
    }
    for (const auto& [key, sides] : faces) {
        if (sides.size() > 2 || (sides.size() == 2 && sides[0] == sides[1]))
            topology.fault = "a face has two tetrahedra on one side";
        if (sides.size() == 1)
            topology.boundary.push_back(sides[0]);
    }
    topology.euler = static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
                     static_cast<int>(faces.size()) - static_cast<int>(tetrahedra.size());
    topology.components = test_topology::componentCount(tetrahedra);
    topology.boundaryComponents = test_topology::componentCount(topology.boundary);
    if (topology.fault.empty())
        topology.fault = test_topology::surfaceFault(topology.boundary);
    return topology;
}

} // namespace tetra
