// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace tetra {

/// What can be written over a picture.
enum class AnnotationKind { ColourBar, Axes, ScaleBar, Title, Accuracy };
inline constexpr std::size_t annotationCount = 5;
/// As files and object names call them, in the order of AnnotationKind.
inline constexpr std::array<const char*, annotationCount> annotationNames{"colourBar", "axes", "scaleBar", "title",
                                                                          "accuracy"};

enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };
inline constexpr std::array<const char*, 4> cornerNames{"topLeft", "topRight", "bottomLeft", "bottomRight"};

struct AnnotationPlace {
    bool shown = false;
    Corner corner = Corner::TopLeft;
    bool operator==(const AnnotationPlace&) const = default;
};

/// Which annotations are shown, and in which corner of the picture: a value.
struct AnnotationState {
    std::array<AnnotationPlace, annotationCount> places{{{true, Corner::TopRight},
                                                         {true, Corner::BottomLeft},
                                                         {false, Corner::BottomRight},
                                                         {false, Corner::TopLeft},
                                                         {false, Corner::TopLeft}}};
    bool operator==(const AnnotationState&) const = default;

    AnnotationPlace& operator[](AnnotationKind kind) { return places[static_cast<std::size_t>(kind)]; }
    const AnnotationPlace& operator[](AnnotationKind kind) const { return places[static_cast<std::size_t>(kind)]; }
};

} // namespace tetra
