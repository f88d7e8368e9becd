// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_split.h"

#include <tan/data.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace tetra {

/// Blocks of cells of all linear shapes that fit together, over the box from 0 to its size; coordinates are multiples
/// of 2^-10, so that sums of determinants are exact.
class RandomCells {
public:
    enum class Kinds { All, NoTetrahedra, OnlyTetrahedra };
    /// `jitter`: how far inner points are moved, of the spacing 1.
    RandomCells(std::array<std::uint32_t, 3> size, double jitter, std::uint32_t seed, Kinds kinds = Kinds::All)
        : size_(size), random_(seed), kinds_(kinds)
    {
        makePoints(jitter);
        for (std::uint32_t j = 0; j < size[1]; ++j)
            for (std::uint32_t i = 0; i < size[0]; ++i)
                addColumn(i, j);
        shuffleCells();
    }
    const CellComplex& complex() const { return complex_; }
    CellComplex& complex() { return complex_; }
    double volume() const { return double(size_[0]) * size_[1] * size_[2]; }
    std::uint32_t random(std::uint32_t below) { return random_() % below; }

private:
    void makePoints(double jitter)
    {
        const std::uint32_t cells = size_[0] * size_[1] * size_[2];
        const std::uint32_t corners = (size_[0] + 1) * (size_[1] + 1) * (size_[2] + 1);
        numbers_.resize(corners + cells); // one more for the middle of each cell
        std::iota(numbers_.begin(), numbers_.end(), 0);
        std::ranges::shuffle(numbers_, random_);
        complex_.positions.resize(numbers_.size());
        for (std::uint32_t k = 0; k <= size_[2]; ++k)
            for (std::uint32_t j = 0; j <= size_[1]; ++j)
                for (std::uint32_t i = 0; i <= size_[0]; ++i)
                    complex_.positions[corner(i, j, k)] = {moved(i, size_[0], jitter), moved(j, size_[1], jitter),
                                                           moved(k, size_[2], jitter)};
    }
    double moved(std::uint32_t index, std::uint32_t last, double jitter)
    {
        if (index == 0 || index == last)
            return index;
        return index + std::round(std::uniform_real_distribution(-jitter, jitter)(random_) * 1024) / 1024;
    }
    std::uint32_t corner(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
    {
        return numbers_[(std::size_t(k) * (size_[1] + 1) + j) * (size_[0] + 1) + i];
    }

    void addColumn(std::uint32_t i, std::uint32_t j)
    {
        const bool prisms = kinds_ != Kinds::OnlyTetrahedra && random(3) == 0;
        const bool otherDiagonal = random(2) == 0;
        for (std::uint32_t k = 0; k < size_[2]; ++k) {
            const std::array<std::uint32_t, 8> c = {
                corner(i, j, k),     corner(i + 1, j, k),     corner(i + 1, j + 1, k),     corner(i, j + 1, k),
                corner(i, j, k + 1), corner(i + 1, j, k + 1), corner(i + 1, j + 1, k + 1), corner(i, j + 1, k + 1)};
            if (prisms && otherDiagonal) {
                add(CellShape::Prism, {c[0], c[1], c[3], c[4], c[5], c[7]});
                add(CellShape::Prism, {c[1], c[2], c[3], c[5], c[6], c[7]});
            } else if (prisms) {
                add(CellShape::Prism, {c[0], c[1], c[2], c[4], c[5], c[6]});
                add(CellShape::Prism, {c[0], c[2], c[3], c[4], c[6], c[7]});
            } else {
                addCube(c);
            }
        }
    }
    void addCube(const std::array<std::uint32_t, 8>& c)
    {
        const std::uint32_t chance = random(3);
        switch (kinds_ == Kinds::All ? chance : kinds_ == Kinds::OnlyTetrahedra ? 1 : chance & 2) {
        case 0: add(CellShape::Hexahedron, {c.begin(), c.end()}); break;
        case 1: {
            CellPieces pieces;
            splitCell(CellShape::Hexahedron, c, pieces);
            for (const auto& piece : pieces)
                add(CellShape::Tetrahedron, {piece.begin(), piece.end()});
            break;
        }
        default: {
            const std::uint32_t middle = numbers_[numbers_.size() - 1 - middles_++];
            Eigen::Vector3d sum(0, 0, 0);
            for (const std::uint32_t point : c)
                sum += complex_.positions[point];
            complex_.positions[middle] = sum / 8;
            for (const CellPolygon& face : quadrilateralsOf(CellShape::Hexahedron, c))
                add(CellShape::Pyramid, {face.nodes[3], face.nodes[2], face.nodes[1], face.nodes[0], middle});
        }
        }
    }
    /// One in eight cells with its corners in the order of a mirrored one.
    void add(CellShape shape, std::vector<std::uint32_t> corners)
    {
        if (random(8) == 0)
            switch (shape) {
            case CellShape::Tetrahedron: std::swap(corners[0], corners[1]); break;
            case CellShape::Pyramid: std::swap(corners[1], corners[3]); break;
            default: std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(corners.size() / 2), corners.end());
            }
        cells_.emplace_back(shape, std::move(corners));
    }
    void shuffleCells()
    {
        std::ranges::shuffle(cells_, random_);
        complex_.offsets = {0};
        for (const auto& [shape, corners] : cells_) {
            complex_.shapes.push_back(shape);
            complex_.corners.insert(complex_.corners.end(), corners.begin(), corners.end());
            complex_.offsets.push_back(complex_.corners.size());
        }
    }

    std::array<std::uint32_t, 3> size_;
    std::mt19937 random_;
    Kinds kinds_;
    std::vector<std::uint32_t> numbers_;
    std::uint32_t middles_ = 0;
    std::vector<std::pair<CellShape, std::vector<std::uint32_t>>> cells_;
    CellComplex complex_;
};

/// A complex of tetrahedra, or of cells of any one shape.
inline CellComplex complexOf(std::vector<Eigen::Vector3d> positions, CellShape shape,
                             const std::vector<std::vector<std::uint64_t>>& cells)
{
    CellComplex complex;
    complex.positions = std::move(positions);
    complex.offsets = {0};
    for (const auto& cell : cells) {
        complex.shapes.push_back(shape);
        complex.corners.insert(complex.corners.end(), cell.begin(), cell.end());
        complex.offsets.push_back(complex.corners.size());
    }
    return complex;
}

} // namespace tetra
