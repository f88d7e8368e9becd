// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <utility>

namespace tetra {
namespace {

/// Icons are drawn on a square of this many units, with lines of two.
constexpr double gridSize = 24;

void addPolyline(QPainterPath& path, std::initializer_list<QPointF> points)
{
    path.addPolygon(QPolygonF(QList<QPointF>(points)));
}

QPainterPath arrowBack()
{
    QPainterPath path;
    addPolyline(path, {{9, 5}, {4, 10}, {9, 15}});
    path.moveTo(4, 10);
    path.lineTo(14, 10);
    path.arcTo(QRectF(9, 10, 10, 10), 90, -180);
    path.lineTo(10, 20);
    return path;
}

QPainterPath outline(Glyph glyph)
{
    QPainterPath path;
    switch (glyph) {
    case Glyph::Open:
        addPolyline(path, {{5, 19}, {3, 19}, {3, 5}, {9, 5}, {11, 8}, {19, 8}, {19, 11}});
        addPolyline(path, {{5, 19}, {8, 11}, {22, 11}, {19, 19}, {5, 19}});
        break;
    case Glyph::Build:
        addPolyline(path, {{12, 3}, {3, 18}, {15, 21}, {12, 3}, {21, 15}, {15, 21}});
        addPolyline(path, {{3, 18}, {21, 15}});
        break;
    case Glyph::Picture:
        path.addRoundedRect(QRectF(3, 5, 18, 14), 2, 2);
        addPolyline(path, {{4, 18}, {10, 11}, {14, 15}, {16, 13}, {20, 17}});
        path.addEllipse(QPointF(16, 9), 1, 1);
        break;
    case Glyph::Undo: path = arrowBack(); break;
    case Glyph::Redo: path = QTransform(-1, 0, 0, 1, gridSize, 0).map(arrowBack()); break;
    case Glyph::Fit:
        addPolyline(path, {{4, 9}, {4, 4}, {9, 4}});
        addPolyline(path, {{15, 4}, {20, 4}, {20, 9}});
        addPolyline(path, {{20, 15}, {20, 20}, {15, 20}});
        addPolyline(path, {{9, 20}, {4, 20}, {4, 15}});
        path.addRect(QRectF(9, 9, 6, 6));
        break;
    case Glyph::Add:
        addPolyline(path, {{12, 5}, {12, 19}});
        addPolyline(path, {{5, 12}, {19, 12}});
        break;
    case Glyph::Remove:
        addPolyline(path, {{4, 7}, {20, 7}});
        addPolyline(path, {{9, 7}, {9, 4}, {15, 4}, {15, 7}});
        addPolyline(path, {{6, 7}, {7, 20}, {17, 20}, {18, 7}});
        break;
    case Glyph::Close:
        addPolyline(path, {{6, 6}, {18, 18}});
        addPolyline(path, {{18, 6}, {6, 18}});
        break;
    case Glyph::Warning:
        addPolyline(path, {{12, 4}, {21, 20}, {3, 20}, {12, 4}});
        addPolyline(path, {{12, 10}, {12, 14}});
        path.addEllipse(QPointF(12, 17), 0.4, 0.4);
        break;
    case Glyph::Information:
        path.addEllipse(QPointF(12, 12), 9, 9);
        addPolyline(path, {{12, 11}, {12, 17}});
        path.addEllipse(QPointF(12, 7.5), 0.4, 0.4);
        break;
    case Glyph::Mesh:
        addPolyline(path, {{12, 3}, {3, 12}, {12, 21}, {21, 12}, {12, 3}});
        addPolyline(path, {{3, 12}, {21, 12}});
        addPolyline(path, {{12, 3}, {12, 21}});
        break;
    case Glyph::Sphere:
        path.addEllipse(QPointF(12, 12), 9, 9);
        path.addEllipse(QPointF(12, 12), 9, 3.5);
        break;
    case Glyph::Box:
        addPolyline(path, {{3, 8}, {12, 3}, {21, 8}, {21, 17}, {12, 22}, {3, 17}, {3, 8}});
        addPolyline(path, {{3, 8}, {12, 12}, {21, 8}});
        addPolyline(path, {{12, 12}, {12, 22}});
        break;
    case Glyph::Window:
        addPolyline(path, {{7, 2}, {7, 17}, {22, 17}});
        addPolyline(path, {{2, 7}, {17, 7}, {17, 22}});
        break;
    case Glyph::Lens:
        path.addEllipse(QPointF(10, 10), 7, 7);
        addPolyline(path, {{15, 15}, {21, 21}});
        break;
    }
    return path;
}

class GlyphEngine : public QIconEngine {
public:
    explicit GlyphEngine(QPainterPath path) : path_(std::move(path)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / gridSize, rect.height() / gridSize);
        painter->setPen(QPen(QApplication::palette().color(group, QPalette::WindowText), 1.7, Qt::SolidLine,
                             Qt::RoundCap, Qt::RoundJoin));
        painter->drawPath(path_);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new GlyphEngine(path_); }

private:
    QPainterPath path_;
};

void fillTriangle(QPainter& painter, QPointF a, QPointF b, QPointF c, const QColor& colour)
{
    painter.setBrush(colour);
    painter.setPen(QPen(colour, 0.4));
    painter.drawPolygon(QPolygonF({a, b, c}));
}

} // namespace

QIcon glyphIcon(Glyph glyph)
{
    return QIcon(new GlyphEngine(outline(glyph)));
}

QIcon lineIcon(const QList<QPolygonF>& lines)
{
    QPainterPath path;
    for (const QPolygonF& line : lines)
        path.addPolygon(line);
    return QIcon(new GlyphEngine(path));
}

QIcon programIcon()
{
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(size / gridSize, size / gridSize);
        const QPointF top(12, 2);
        const QPointF left(2, 18);
        const QPointF front(15, 22);
        const QPointF right(22, 15);
        fillTriangle(painter, top, left, front, QColor(230, 159, 0));
        fillTriangle(painter, top, front, right, QColor(86, 180, 233));
        icon.addPixmap(pixmap);
    }
    return icon;
}

} // namespace tetra
