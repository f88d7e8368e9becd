// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <array>

namespace tetra {

/// A colour of what things are made of: quiet enough that light shows the shape of a surface.
struct Material {
    const char* word; ///< on the command line
    MarkedText name;
    Colour colour;
};

inline constexpr std::array<Material, 7> materials{{
    {"bone", Message::marked("Bone"), {232 / 255.0f, 220 / 255.0f, 196 / 255.0f}},
    {"skin", Message::marked("Skin"), {224 / 255.0f, 172 / 255.0f, 142 / 255.0f}},
    {"flesh", Message::marked("Flesh"), {190 / 255.0f, 92 / 255.0f, 80 / 255.0f}},
    {"steel", Message::marked("Steel"), {176 / 255.0f, 186 / 255.0f, 198 / 255.0f}},
    {"stone", Message::marked("Stone"), {150 / 255.0f, 142 / 255.0f, 132 / 255.0f}},
    {"water", Message::marked("Water"), {96 / 255.0f, 156 / 255.0f, 196 / 255.0f}},
    {"chalk", Message::marked("Chalk"), {245 / 255.0f, 245 / 255.0f, 242 / 255.0f}},
}};

/// What the first surface of a model is of, until its user knows better.
inline constexpr Material usualMaterial = materials[0];

} // namespace tetra
