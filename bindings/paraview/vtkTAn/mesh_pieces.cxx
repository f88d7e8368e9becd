// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_pieces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

namespace tanpieces {
namespace {

using Corners = std::array<std::uint32_t, 4>;

/// Four times the middle, which orders as well.
Eigen::Vector3d middleOf(const tetra::TetrahedralMesh& mesh, std::uint32_t tetrahedron)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t corner : mesh.tetrahedra[tetrahedron])
        sum += mesh.positions[corner];
    return sum;
}

struct Division {
    const tetra::TetrahedralMesh& mesh;
    std::vector<std::uint32_t>& result;

    /// Gives the tetrahedra to the pieces from `first` on.
    void divide(std::span<std::uint32_t> tetrahedra, std::uint32_t first, std::uint32_t pieces) const
    {
        if (pieces == 1 || tetrahedra.empty()) {
            for (const std::uint32_t tetrahedron : tetrahedra)
                result[tetrahedron] = first;
            return;
        }
        Eigen::AlignedBox3d box;
        for (const std::uint32_t tetrahedron : tetrahedra)
            box.extend(middleOf(mesh, tetrahedron));
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        const std::uint32_t half = pieces / 2;
        const std::size_t split = tetrahedra.size() * half / pieces;
        const auto key = [&](std::uint32_t tetrahedron) {
            return std::tuple(middleOf(mesh, tetrahedron)[axis], tetrahedron);
        };
        std::ranges::nth_element(tetrahedra, tetrahedra.begin() + static_cast<std::ptrdiff_t>(split), {}, key);
        divide(tetrahedra.first(split), first, half);
        divide(tetrahedra.subspan(split), first + half, pieces - half);
    }
};

} // namespace

std::vector<std::uint32_t> pieceOfEach(const tetra::TetrahedralMesh& mesh, std::uint32_t pieces)
{
    std::vector<std::uint32_t> result(mesh.tetrahedra.size(), 0), all(mesh.tetrahedra.size());
    std::iota(all.begin(), all.end(), 0U);
    Division{mesh, result}.divide(all, 0, std::max(pieces, 1U));
    return result;
}

MeshPiece pieceOf(const tetra::TetrahedralMesh& mesh, const std::vector<std::uint32_t>& pieceOfEach,
                  std::uint32_t piece, int layers)
{
    std::vector<bool> isHere(mesh.tetrahedra.size()), hasVertex(mesh.positions.size());
    const auto takeVertices = [&] {
        for (std::size_t t = 0; t < isHere.size(); ++t)
            if (isHere[t])
                for (const std::uint32_t corner : mesh.tetrahedra[t])
                    hasVertex[corner] = true;
    };
    for (std::size_t t = 0; t < isHere.size(); ++t)
        isHere[t] = pieceOfEach[t] == piece;
    takeVertices();
    for (int layer = 0; layer < layers; ++layer) {
        for (std::size_t t = 0; t < isHere.size(); ++t)
            if (!isHere[t])
                isHere[t] =
                    std::ranges::any_of(mesh.tetrahedra[t], [&](auto corner) { return bool(hasVertex[corner]); });
        takeVertices();
    }
    std::vector<std::uint32_t> owners(mesh.positions.size(), std::numeric_limits<std::uint32_t>::max());
    for (std::size_t t = 0; t < isHere.size(); ++t)
        for (const std::uint32_t corner : mesh.tetrahedra[t])
            owners[corner] = std::min(owners[corner], pieceOfEach[t]);
    MeshPiece found;
    for (std::uint32_t t = 0; t < isHere.size(); ++t)
        if (isHere[t]) {
            found.tetrahedra.push_back(t);
            found.isOthers.push_back(pieceOfEach[t] != piece);
        }
    for (std::uint32_t v = 0; v < hasVertex.size(); ++v)
        if (hasVertex[v]) {
            found.vertices.push_back(v);
            found.isOthersVertex.push_back(owners[v] != piece);
        }
    return found;
}

} // namespace tanpieces
