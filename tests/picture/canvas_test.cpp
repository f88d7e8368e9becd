// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes by the area that they cover, which closed forms tell, and pixels by the formula of "over".
#include "core/picture/drawing/blending.h"
#include "core/picture/drawing/canvas.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace tetra;

namespace {

constexpr PixelInk black{0, 0, 0};

Picture whitePicture(int width, int height)
{
    return {width, height,
            std::vector<std::array<std::uint8_t, 4>>(static_cast<std::size_t>(width * height), {255, 255, 255, 255})};
}

/// Of the picture, in pixels, after black was painted on white.
double coveredArea(const Picture& picture)
{
    double sum = 0;
    for (const auto& pixel : picture.pixels)
        sum += (255 - pixel[0]) / 255.0;
    return sum;
}

/// Painted by `paint` on a white picture, in units of `scale` pixels.
template <class Paint> double areaOf(double scale, Paint paint)
{
    Picture picture = whitePicture(200, 160);
    paint(PixelCanvas(pixelsOf(picture), scale));
    return coveredArea(picture);
}

/// Ends, widths and corners are counted in 64ths of a pixel, which is two of them along the edges at most; and what 255
/// steps leave.
bool isNear(double area, double expected, double edges)
{
    return std::abs(area - expected) < edges / 32 + 0.05;
}

/// Curves are drawn as straight pieces that leave them by a tenth of a pixel at most.
bool isNearRound(double area, double expected, double edges)
{
    return std::abs(area - expected) < edges / 12 + 0.05;
}

double overlap(double from, double to, int pixel)
{
    return std::max(0.0, std::min(to, pixel + 1.0) - std::max(from, double(pixel)));
}

} // namespace

class CanvasTest : public QObject {
    Q_OBJECT
private slots:
    void rectanglesCoverTheirPartOfEachPixel()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> any(-20, 60);
        for (int round = 0; round < 200; ++round) {
            Picture picture = whitePicture(40, 30);
            const double left = any(random), top = any(random);
            const Rectangle rectangle{left, top, std::abs(any(random)), std::abs(any(random))};
            const double scale = round % 2 == 0 ? 1 : 1.5;
            fill(PixelCanvas(pixelsOf(picture), scale), rectangle, black);
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x) {
                    const double covered = overlap(left * scale, rectangle.right() * scale, x) *
                                           overlap(top * scale, rectangle.bottom() * scale, y);
                    QVERIFY(std::abs(255 * (1 - covered) - pixelsOf(picture).row(y)[x][0]) < 0.51);
                }
        }
    }

    void shapesCoverTheirArea()
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> x(2, 98), y(2, 78);
        for (const double scale : {1.0, 2.0})
            for (int round = 0; round < 100; ++round) {
                const std::array<Eigen::Vector2d, 3> corners{
                    {{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}}};
                const Eigen::Vector2d one = corners[1] - corners[0], other = corners[2] - corners[0];
                const double area = std::abs(one.x() * other.y() - one.y() * other.x()) / 2;
                const double edges = one.norm() + other.norm() + (other - one).norm();
                const double covered =
                    areaOf(scale, [&](const PixelCanvas& canvas) { fill(canvas, polygonPath(corners), black); });
                QVERIFY2(isNear(covered, area * scale * scale, edges * scale), QByteArray::number(covered));
            }
        const Rectangle around{20.3, 10.7, 60, 40};
        const double ellipse =
            areaOf(1.5, [&](const PixelCanvas& canvas) { fill(canvas, ellipsePath(around), black); });
        QVERIFY2(isNearRound(ellipse, std::numbers::pi * 45 * 30, 240), QByteArray::number(ellipse));
    }

    void linesCoverTheirArea()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> x(10, 90), y(10, 70), wide(0.5, 8);
        for (int round = 0; round < 100; ++round) {
            const Eigen::Vector2d from(x(random), y(random)), to(x(random), y(random));
            const double width = wide(random), length = (to - from).norm();
            const double flat =
                areaOf(1, [&](const PixelCanvas& canvas) { strokeLine(canvas, from, to, width, black); });
            const double square = areaOf(
                1, [&](const PixelCanvas& canvas) { strokeLine(canvas, from, to, width, black, LineEnd::Square); });
            QVERIFY2(isNear(flat, length * width, 2 * (length + width)), QByteArray::number(flat));
            QVERIFY2(isNear(square, (length + width) * width, 2 * (length + 2 * width)), QByteArray::number(square));
        }
    }

    /// A frame has bevelled corners; a ring has none.
    void outlinesCoverTheirArea()
    {
        const Rectangle around{20.3, 20.7, 50, 30};
        for (const double width : {1.0, 3.0, 8.0}) {
            const double frame =
                areaOf(1.5, [&](const PixelCanvas& canvas) { stroke(canvas, rectanglePath(around), width, black); });
            QVERIFY2(isNear(frame, 2.25 * (2 * width * 80 - width * width / 2), 480), QByteArray::number(frame));
            const Rectangle square{20.3, 20.7, 40, 40};
            const double ring =
                areaOf(1.5, [&](const PixelCanvas& canvas) { stroke(canvas, ellipsePath(square), width, black); });
            QVERIFY2(isNearRound(ring, 2.25 * 2 * std::numbers::pi * 20 * width, 377), QByteArray::number(ring));
        }
    }

    /// The same ink twice as far away is the same part of the picture: what lies outside is left away.
    void whatLiesOutsideIsLeftAway()
    {
        for (const double far : {0.0, 100.0, -300.0, 1e4, -1e4}) {
            const Rectangle around{-30 + far, -30 + far, 60, 60};
            const double covered =
                areaOf(1, [&](const PixelCanvas& canvas) { fill(canvas, ellipsePath(around), black); });
            const bool isSeen = far == 0.0 || far == 100.0;
            QVERIFY2(isSeen ? covered > 500 : covered == 0, QByteArray::number(covered));
        }
        Picture nothing;
        const PixelCanvas canvas(pixelsOf(nothing), 1);
        fill(canvas, Rectangle{-5, -5, 10, 10}, black);
        strokeLine(canvas, {-5, -5}, {5, 5}, 3, black);
    }

    /// Of straight alpha: what is seen over any ground is what double precision tells.
    void inkLiesOverWhatIsThere()
    {
        std::mt19937 random(4);
        const auto byte = [&] { return static_cast<std::uint8_t>(random() % 256); };
        for (int round = 0; round < 20000; ++round) {
            const std::array<std::uint8_t, 4> before{byte(), byte(), byte(),
                                                     round % 3 == 0 ? std::uint8_t{255} : byte()};
            const PixelInk ink{byte(), byte(), byte(), byte()};
            const unsigned coverage = byte();
            auto pixel = before;
            blend(pixel, ink, coverage);
            const double over = ink.alpha * coverage / 255.0 / 255, under = before[3] / 255.0;
            const double alpha = over + under * (1 - over);
            QVERIFY(std::abs(pixel[3] - 255 * alpha) <= 1);
            const double seen = ink.red * over + before[0] * under * (1 - over);
            QVERIFY2(std::abs(pixel[0] * (pixel[3] / 255.0) - seen) <= 1.5, QByteArray::number(seen));
        }
        std::array<std::uint8_t, 4> clear{9, 9, 9, 0};
        blend(clear, {10, 20, 30, 255}, 128);
        QCOMPARE(clear, (std::array<std::uint8_t, 4>{10, 20, 30, 128}));
        blend(clear, {1, 2, 3, 255}, 255);
        QCOMPARE(clear, (std::array<std::uint8_t, 4>{1, 2, 3, 255}));
    }

    /// Inside the other picture, outside the one that was there, and at the edge between.
    void aPartIsReplaced()
    {
        Picture picture = whitePicture(60, 40);
        Picture content = whitePicture(30, 20);
        for (std::size_t i = 0; i < content.pixels.size(); ++i)
            content.pixels[i] = {static_cast<std::uint8_t>(i % 200), 7, 9, 40};
        const PixelCanvas canvas(pixelsOf(picture), 1);
        replaceWithin(canvas, rectanglePath({10, 5, 30.5, 30}), content, 15, 10);
        QCOMPARE(pixelsOf(picture).row(12)[20], content.pixels[2 * 30 + 5]);
        QCOMPARE(pixelsOf(picture).row(7)[12], (std::array<std::uint8_t, 4>{255, 255, 255, 255})); // it ends there
        QCOMPARE(pixelsOf(picture).row(12)[41], (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
        QVERIFY(std::abs(pixelsOf(picture).row(12)[40][3] - (40 + 255) / 2.0) <= 1);
    }
};

QTEST_GUILESS_MAIN(CanvasTest)
#include "canvas_test.moc"
