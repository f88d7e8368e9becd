// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_content.h"
#include "core/picture/annotations/bar_axis.h"
#include "core/picture/drawing/rectangle.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// How large texts are, in the units of the picture.
struct TextMeasure {
    std::function<double(const std::string& text)> width;
    std::function<double(const std::string& text)> boldWidth; ///< of a title
    double height = 16;                                       ///< of a line
};

/// A text with its place; the text is cut to it already.
struct PlacedText {
    std::string text{};
    Rectangle place{};
};

/// A value on the colour bar's axis.
struct AxisMark {
    double position = 0; ///< down the picture
    PlacedText label{};  ///< an empty text where there is no room for one
    bool beyond = false; ///< the value is not on the axis, and has no mark
};

struct ColourBarLayout {
    BarAxis axis{};
    Rectangle bar{};
    PlacedText field{};
    std::vector<AxisMark> ticks{};
    std::vector<AxisMark> isovalues{}; ///< as many as the content has
};

struct AxisLayout {
    Eigen::Vector2d tip{0, 0}; ///< from the origin
    double depth = 0;          ///< towards the viewer, of the unit vector
    PlacedText label{};
};

struct AxesLayout {
    Eigen::Vector2d origin{0, 0};
    std::array<AxisLayout, 3> axes{}; ///< x, y, z
};

struct ScaleBarLayout {
    Eigen::Vector2d from{0, 0};
    Eigen::Vector2d to{0, 0};
    double length = 0; ///< in the units of the dataset
    PlacedText label{};
};

/// A value on an axis along the box, and its place in the picture.
struct BoxTick {
    double value = 0;
    Eigen::Vector2d place{0, 0};
    PlacedText label{}; ///< an empty text where there is no room for one
};

/// An edge of the data's box that has numbers.
struct BoxAxisLayout {
    std::size_t axis = 0;                 ///< x, y, z
    Eigen::Vector2d from{0, 0}, to{0, 0}; ///< what is in the picture of it, towards larger values
    Eigen::Vector2d outwards{0, 0};       ///< away from the box, 1 long
    std::vector<BoxTick> ticks{};         ///< rising, those that are in the picture
    PlacedText name{};                    ///< with the unit of length
};

/// Where annotations stand in a picture. Those that are switched off, have nothing to say or find no room are missing.
struct AnnotationLayout {
    std::array<Rectangle, annotationCount> places{}; ///< by kind; empty if missing
    std::optional<ColourBarLayout> colourBar{};
    std::optional<AxesLayout> axes{};
    std::optional<ScaleBarLayout> scaleBar{};
    std::optional<PlacedText> title{};
    std::optional<PlacedText> accuracy{};
    std::vector<BoxAxisLayout> boxAxes{}; ///< at most one of each direction
};

/// Stacks what is in one corner, from the corner on. Nothing overlaps or leaves the picture: the colour bar becomes
/// shorter first, then what matters least goes. The axes with numbers take what room is left. Sizes are for text of 12
/// units or so.
AnnotationLayout layOutAnnotations(const AnnotationContent& content, const Size& picture, const TextMeasure& measure);

} // namespace tetra
