// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/file_layout.h"

#include <tan/model.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tetra {

/// How the lattice of a model lies and by which lengths its mesh was made, as far as the header does not tell: sections
/// 9 and 10 of FORMAT.md, which stand before the text.

/// One of them, to be written.
struct FrameSection {
    format::SectionId id = format::SectionId::Frame;
    std::vector<double> numbers;
};

inline constexpr std::array frameSectionIds{format::SectionId::Frame, format::SectionId::Metric};

/// Those that a model of this description has: none if the lattice lies along the axes and its mesh was made by its
/// own spacing.
std::vector<FrameSection> frameSections(const ModelDescription& description);

/// Takes one of them into a description that has what the header and the sections before say. False if the numbers
/// make no sense: directions that are not of unit length or lie in a plane, lengths that are not positive, a bounding
/// box that is not that of the lattice.
bool takeFrameSection(format::SectionId id, std::span<const std::byte> bytes, ModelDescription& description);

/// The smallest box of the world with all points of the lattice is, but for roundings, this one.
bool isBoxOfLattice(const Lattice& lattice, const Eigen::AlignedBox3d& box);

} // namespace tetra
