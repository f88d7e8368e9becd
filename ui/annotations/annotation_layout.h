// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/annotations/annotation_content.h"
#include "ui/annotations/bar_axis.h"

#include <QLineF>
#include <QRectF>
#include <QSizeF>

#include <array>
#include <functional>

namespace tetra {

/// How large texts are, in the units of the picture.
struct TextMeasure {
    std::function<double(const QString& text)> width;
    std::function<double(const QString& text)> boldWidth; ///< of a title
    double height = 16;                                   ///< of a line
};

/// A text with its place; the text is cut to it already.
struct PlacedText {
    QString text;
    QRectF place;
};

/// A value on the colour bar's axis.
struct AxisMark {
    double position = 0; ///< down the picture
    PlacedText label;    ///< an empty text where there is no room for one
    bool beyond = false; ///< the value is not on the axis, and has no mark
};

struct ColourBarLayout {
    BarAxis axis;
    QRectF bar;
    PlacedText field;
    std::vector<AxisMark> ticks;
    std::vector<AxisMark> isovalues; ///< as many as the content has
};

struct AxisLayout {
    QPointF tip;      ///< from the origin
    double depth = 0; ///< towards the viewer, of the unit vector
    PlacedText label;
};

struct AxesLayout {
    QPointF origin;
    std::array<AxisLayout, 3> axes; ///< x, y, z
};

struct ScaleBarLayout {
    QLineF bar;
    double length = 0; ///< in the units of the dataset
    PlacedText label;
};

/// Where annotations stand in a picture. Those that are switched off, have nothing to say or find no room are missing.
struct AnnotationLayout {
    std::array<QRectF, annotationCount> places; ///< by kind; null if missing
    std::optional<ColourBarLayout> colourBar;
    std::optional<AxesLayout> axes;
    std::optional<ScaleBarLayout> scaleBar;
    std::optional<PlacedText> title;
    std::optional<PlacedText> accuracy;
};

/// Stacks what is in one corner, from the corner on. Nothing overlaps or leaves the picture: the colour bar becomes
/// shorter first, then what matters least goes. Sizes are for text of 12 units or so.
AnnotationLayout layOutAnnotations(const AnnotationContent& content, QSizeF picture, const TextMeasure& measure);

} // namespace tetra
