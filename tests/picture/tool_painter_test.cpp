// SPDX-License-Identifier: GPL-3.0-or-later
// What tools show lies where a pinhole camera sees it, by the area that it covers and by its first and last pixels.
#include "core/picture/tool_painter.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <vector>

using namespace tetra;
using Eigen::Vector3d;

namespace {

constexpr int width = 400, height = 300;
constexpr double inkStep = 255 - 28; ///< from the white background to the ink

/// Looks along +y at the origin from 10 before it: x goes to the right and z up.
Camera camera(bool perspective = true)
{
    Camera camera;
    camera.distance = 10;
    camera.azimuth = 0;
    camera.elevation = 0;
    camera.perspective = perspective;
    return camera;
}

/// Pixels for a unit of length at the target.
double pixelsPerUnit(double scale = 1)
{
    return std::min(width, height) * scale / 2 / std::tan(15 * std::numbers::pi / 180) / 10;
}

ToolInk inkFor(const Camera& seenBy)
{
    return {.camera = seenBy, .background = {1, 1, 1}};
}

class Painted {
public:
    explicit Painted(const ToolDrawing& drawing, const ToolInk& ink = inkFor(camera()), double scale = 1)
        : picture_{int(width * scale), int(height * scale), {}}
    {
        picture_.pixels.resize(std::size_t(picture_.width) * std::size_t(picture_.height), {255, 255, 255, 255});
        fine_ = paintTools(pixelsOf(picture_), std::vector{drawing}, ink, scale).ok();
    }

    bool fine() const { return fine_; }
    double darkness(int x, int y) const
    {
        return (255 - picture_.pixels[std::size_t(y) * std::size_t(picture_.width) + std::size_t(x)][0]) / inkStep;
    }
    /// In pixels, of the columns from `first` to before `last`.
    double area(int first = 0, int last = 1 << 20) const
    {
        double sum = 0;
        for (int y = 0; y < picture_.height; ++y)
            for (int x = first; x < std::min(last, picture_.width); ++x)
                sum += darkness(x, y);
        return sum;
    }
    const Picture& picture() const { return picture_; }

private:
    Picture picture_;
    bool fine_ = false;
};

ToolDrawing lineThrough(std::vector<Vector3d> points, double lineWidth = 2)
{
    ToolDrawing drawing;
    drawing.lines.push_back({.points = std::move(points), .width = lineWidth});
    return drawing;
}

bool isNear(double found, double expected, double tolerance)
{
    if (std::abs(found - expected) <= tolerance)
        return true;
    qWarning("%g instead of %g", found, expected);
    return false;
}

} // namespace

class ToolPainterTest : public QObject {
    Q_OBJECT
private slots:
    void linesLieWhereTheyAreSeen()
    {
        for (const double scale : {1.0, 2.0})
            for (const double depth : {0.0, 5.0}) { // behind the target
                const double units = pixelsPerUnit() * 10 / (10 + depth);
                const Painted painted(lineThrough({{-1, depth, 0.5}, {2, depth, 0.5}}), inkFor(camera()), scale);
                QVERIFY(painted.fine());
                QVERIFY(isNear(painted.area(), (3 * units + 2) * 2 * scale * scale, 3));
                const double left = (width / 2.0 - units - 1) * scale, right = (width / 2.0 + 2 * units + 1) * scale;
                QVERIFY(isNear(painted.area(0, int(left)), 0, 0.5));
                QVERIFY(isNear(painted.area(int(right) + 2), 0, 0.5));
                const int row = int((height / 2.0 - 0.5 * units) * scale);
                QVERIFY(painted.darkness(int(width / 2.0 * scale), row) > 0.4);
            }
    }

    void aClosedLineReturns()
    {
        ToolDrawing square = lineThrough({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}});
        square.lines.front().closed = true;
        const Painted painted(square);
        QVERIFY(isNear(painted.area(), 4 * 2 * pixelsPerUnit() * 2, 6));
        square.lines.front().closed = false;
        QVERIFY(isNear(Painted(square).area(), 3 * 2 * pixelsPerUnit() * 2, 8));
    }

    void dashesAreTwoThirds()
    {
        ToolDrawing dashed = lineThrough({{-2, 0, 0}, {0.3, 0, 0}, {2, 0, 1}, {2, 0, -1}});
        const double length = (2.3 + std::hypot(1.7, 1) + 2) * pixelsPerUnit();
        dashed.lines.front().dashed = true;
        QVERIFY(isNear(Painted(dashed).area(), length * 2 * 2 / 3, 16));
        // The rim keeps the gaps legible on what is dark.
        ToolInk onBlack = inkFor(camera());
        onBlack.background = {0, 0, 0};
        QVERIFY(Painted(dashed, onBlack).area() > length * 2);
    }

    void whatLiesBehindTheEyeIsCutOff()
    {
        // It comes from the target and leaves the picture at the right, on its way past the eye.
        const Painted painted(lineThrough({{0, 0, 0}, {1, -20, 0}}));
        QVERIFY(isNear(painted.area(0, width / 2 - 2), 0, 0));
        for (int x = width / 2 + 1; x < width; ++x)
            QVERIFY(painted.darkness(x, height / 2) > 0.9);
        const Painted behind(lineThrough({{-1, -11, 0}, {1, -12, 0}}));
        QCOMPARE(behind.area(), 0.0);
        // Without perspective there is no eye to be behind of.
        QVERIFY(isNear(Painted(lineThrough({{-1, -11, 0}, {1, -12, 0}}), inkFor(camera(false))).area(),
                       (2 * pixelsPerUnit() + 2) * 2, 3));
        ToolDrawing others;
        others.points.push_back({.place = {0, -11, 0}});
        others.handles.push_back({.id = "a", .place = {0, -11, 0}});
        others.texts.push_back({{0, -11, 0}, Message::say("behind")});
        QCOMPARE(Painted(others).area(), 0.0);
    }

    void placesFarBesideDoNoHarm()
    {
        for (const double far : {1e3, 1e9, 1e15, 1e300}) {
            const Painted painted(lineThrough({{-far, 0, 0}, {far, 0, 0}}));
            QVERIFY(painted.fine());
            if (far < 1e300)
                QVERIFY(isNear(painted.area(), width * 2, 1));
            ToolDrawing dashed = lineThrough({{-far, 0, 0}, {far, 0, 0}});
            dashed.lines.front().dashed = true;
            if (far < 1e10) // its dashes are counted from its beginning
                QVERIFY(isNear(Painted(dashed).area(), width * 2 * 2 / 3.0, 20));
            QVERIFY(Painted(dashed).fine());
            ToolDrawing others;
            others.points.push_back({.place = {far, 0, far}});
            others.handles.push_back({.id = "a", .place = {far, 0, 0}});
            others.texts.push_back({{0, 0, -far}, Message::say("far")});
            QCOMPARE(Painted(others).area(), 0.0);
        }
    }

    void longLinesAreWhole()
    {
        constexpr int count = 20'000;
        std::vector<Vector3d> circle;
        for (int i = 0; i <= count; ++i)
            circle.emplace_back(2 * std::cos(2 * std::numbers::pi * i / count), 0,
                                2 * std::sin(2 * std::numbers::pi * i / count));
        const double length = 2 * std::numbers::pi * 2 * pixelsPerUnit();
        QVERIFY(isNear(Painted(lineThrough(circle, 3)).area(), length * 3, 0.03 * length * 3));
    }

    void pointsAndHandlesAreAsLargeAsTheySay()
    {
        ToolDrawing drawing;
        drawing.points.push_back({.place = {0, 0, 0}, .radius = 9, .colour = Colour{1, 0, 0}});
        const Painted point(drawing);
        const auto& middle = point.picture().pixels[std::size_t(height / 2) * width + width / 2];
        QCOMPARE(middle, (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
        drawing.points.clear();
        drawing.handles.push_back({.id = "round", .place = {-1, 0, 0}});
        drawing.handles.push_back({.id = "square", .place = {1, 0, 0}, .square = true});
        ToolInk ink = inkFor(camera());
        const Painted both(drawing, ink);
        QVERIFY(isNear(both.area(0, width / 2), std::numbers::pi * 36, 3));
        QVERIFY(isNear(both.area(width / 2), 144, 1));
        ink.selected = "round";
        const Painted selected(drawing, ink);
        QVERIFY(selected.area(0, width / 2) < both.area(0, width / 2) - 8);
        QCOMPARE(selected.area(width / 2), both.area(width / 2));
        ink.hovered = "square";
        QVERIFY(isNear(Painted(drawing, ink).area(width / 2), 256, 1));
    }

    void textsStandBesideTheirPlace()
    {
        ToolDrawing drawing;
        drawing.texts.push_back({{0, 0, 0}, Message::say("%1 mm", "12.5")});
        const Painted right(drawing);
        QCOMPARE(right.area(0, width / 2 + 8), 0.0);
        QVERIFY(right.area(width / 2 + 8, width / 2 + 80) > 30);
        drawing.texts.front().place = {(width / 2.0 - 5) / pixelsPerUnit(), 0, 0};
        const Painted left(drawing);
        QVERIFY(left.area(width - 14) < 1 && left.area() > 30); // no room at the right
        ToolInk ink = inkFor(camera());
        ink.language.translate = [](const Message& message) { return "[" + message.text() + " translated]"; };
        QVERIFY(Painted(drawing, ink).area() > left.area() * 1.5);
    }
};

QTEST_GUILESS_MAIN(ToolPainterTest)
#include "tool_painter_test.moc"
