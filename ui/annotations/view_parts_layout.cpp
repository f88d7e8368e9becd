// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to the camera: axes and scale bar; and texts.
#include "ui/annotations/annotation_parts.h"
#include "ui/annotations/axis_ticks.h"
#include "ui/annotations/picture_projection.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(Annotations)
};

constexpr double axisLength = 30;
constexpr double labelDistance = 9; ///< from the tip of an axis to the middle of its label
constexpr double longestBar = 180;
constexpr double longestShare = 0.28; ///< of the picture's width
constexpr double tickHeight = 7;

/// Away from the others, along the axis or beside it.
void placeLabel(AxisLayout& axis, const QPointF& origin, const std::vector<QRectF>& taken, const TextMeasure& measure)
{
    const QSizeF size(measure.width(axis.label.text), measure.height);
    const double length = std::hypot(axis.tip.x(), axis.tip.y());
    const QPointF along = length > 1 ? axis.tip / length : QPointF(0.6, -0.8);
    const QPointF aside(-along.y(), along.x());
    axis.label.place = QRectF(QPointF(0, 0), size);
    for (const double shift : {0.0, 1.0, -1.0, 2.0, -2.0}) {
        const QPointF middle = origin + axis.tip + along * labelDistance + aside * (shift * 0.9 * measure.height);
        axis.label.place.moveCenter(middle);
        if (std::ranges::none_of(taken, [&](const QRectF& other) { return other.intersects(axis.label.place); }))
            return;
    }
}

/// In the units of the dataset: nothing longer fits.
double barUnits(const AnnotationContent& content, const QSizeF& picture)
{
    const double pixels = std::min(longestBar, longestShare * picture.width());
    return niceLength(pixels * PictureProjection(content.camera, picture).unitsPerPixel(content.camera.target));
}

QString barText(const AnnotationContent& content, double units)
{
    const QString number = shortNumber(units);
    if (!content.lengthUnit.isEmpty())
        return content.camera.perspective ? Texts::tr("%1 %2 at the target").arg(number, content.lengthUnit)
                                          : number + " " + content.lengthUnit;
    if (units == 1)
        return content.camera.perspective ? Texts::tr("1 unit at the target") : Texts::tr("1 unit");
    return content.camera.perspective ? Texts::tr("%1 units at the target").arg(number)
                                      : Texts::tr("%1 units").arg(number);
}

} // namespace

QSizeF axesSize(const TextMeasure& measure)
{
    const double side = 2 * (axisLength + labelDistance) + measure.height;
    return {side, side};
}

AxesLayout layOutAxes(const AnnotationContent& content, const QRectF& place, const TextMeasure& measure)
{
    AxesLayout layout;
    layout.origin = place.center();
    const QString letters = content.space.size() == 3 ? content.space : QString("xyz");
    const Eigen::Matrix3d rotation = viewMatrix(content.camera).topLeftCorner<3, 3>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d seen = rotation.col(static_cast<Eigen::Index>(axis));
        layout.axes[axis].tip = QPointF(seen.x(), -seen.y()) * axisLength;
        layout.axes[axis].depth = seen.z();
        layout.axes[axis].label.text = letters.mid(static_cast<qsizetype>(axis), 1);
    }
    // The longest first: it is the one whose place is clear.
    std::array<AxisLayout*, 3> order{&layout.axes[0], &layout.axes[1], &layout.axes[2]};
    std::ranges::stable_sort(order, {}, [](const AxisLayout* axis) { return std::abs(axis->depth); });
    std::vector<QRectF> taken;
    for (AxisLayout* axis : order) {
        placeLabel(*axis, layout.origin, taken, measure);
        taken.push_back(axis->label.place);
    }
    return layout;
}

QSizeF scaleBarSize(const AnnotationContent& content, QSizeF picture, const TextMeasure& measure)
{
    const double units = barUnits(content, picture);
    if (!(units > 0))
        return {};
    const double bar = units / PictureProjection(content.camera, picture).unitsPerPixel(content.camera.target);
    return {std::max(bar, measure.width(barText(content, units))) + 2, measure.height + tickHeight + 2};
}

ScaleBarLayout layOutScaleBar(const AnnotationContent& content, QSizeF picture, const QRectF& place,
                              const TextMeasure& measure)
{
    ScaleBarLayout layout;
    layout.length = barUnits(content, picture);
    const double bar = layout.length / PictureProjection(content.camera, picture).unitsPerPixel(content.camera.target);
    const double y = place.bottom() - tickHeight / 2 - 1;
    layout.bar = QLineF(place.center().x() - bar / 2, y, place.center().x() + bar / 2, y);
    layout.label = fittedText(barText(content, layout.length), place.width(), measure);
    layout.label.place.moveCenter({place.center().x(), place.top() + measure.height / 2});
    return layout;
}

PlacedText fittedText(const QString& text, double most, const TextMeasure& measure)
{
    constexpr qsizetype mostKept = 4096; // wider than any picture
    const auto shortened = [&](qsizetype kept) { return text.left((kept + 1) / 2) + u'…' + text.right(kept / 2); };
    QString fitted = text;
    if (text.size() > mostKept || measure.width(text) > most) {
        qsizetype fits = 1, tooLong = std::min(text.size(), mostKept);
        while (tooLong - fits > 1) {
            const qsizetype kept = (fits + tooLong) / 2;
            (measure.width(shortened(kept)) > most ? tooLong : fits) = kept;
        }
        fitted = shortened(fits);
    }
    return {fitted, QRectF(0, 0, std::ceil(measure.width(fitted)), measure.height)};
}

} // namespace tetra
