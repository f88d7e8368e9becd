// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QImage>
#include <QPolygonF>
#include <QRectF>
#include <QString>

#include <filesystem>
#include <vector>

class QPainter;

namespace tetra {

/// What things are drawn in: the parts of a chart, and from Series on eight colours that people of any colour vision
/// can tell apart (after Okabe and Ito).
enum class Ink { Ground, Text, Soft, Grid, Axis, Series };
/// The colour of a number, over and over.
Ink seriesInk(std::size_t number);

enum class Letters { Plain, Soft, Strong, Title };
enum class Anchor { Left, Middle, Right }; ///< which end of a text is at its place

/// Lines, areas, dots and texts in the plane, y pointing down. It is written as SVG, which can be read on a light and
/// on a dark ground and by a screen reader, or painted on white.
class Drawing {
public:
    /// The description says in words what it shows.
    Drawing(const QSizeF& size, QString title, QString description);

    void text(const QPointF& place, const QString& words, Letters letters = Letters::Plain,
              Anchor anchor = Anchor::Left);
    void line(const QPolygonF& points, Ink ink, double width = 1);
    void area(const QPolygonF& border, Ink ink);
    void dots(const QPolygonF& places, Ink ink, double diameter);

    QByteArray svg() const;
    /// Needs a QGuiApplication for its letters. Null if memory is short.
    QImage image(double pixelsPerUnit) const;

private:
    enum class Kind { Text, Line, Area, Dots };
    struct Shape {
        Kind kind;
        QPolygonF points;
        Ink ink;
        double width = 1; ///< of lines and dots
        QString words = {};
        Letters letters = Letters::Plain;
        Anchor anchor = Anchor::Left;
    };
    static QString svgOf(const Shape& shape);
    static void paint(QPainter& painter, const Shape& shape);

    QSizeF size_;
    QString title_;
    QString description_;
    std::vector<Shape> shapes_;
};

/// Writes FILE.png, of two pixels a unit, and FILE.svg, each whole or not at all; gives their names.
Result<std::vector<std::filesystem::path>> writeDrawing(const std::filesystem::path& file, const Drawing& drawing);

} // namespace tetra
