// SPDX-License-Identifier: GPL-3.0-or-later
// Axes with numbers along the edges of the data's box: at the places where the back ends draw the box, outside of it,
// and never over each other; the size and the weight of all texts. The box is projected by the matrices that pictures
// are drawn with.
#include "core/picture/annotations/annotation_layout.h"
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/annotations/placed_text.h"
#include "core/picture/drawing/vector_drawing.h"
#include "core/view/view_value.h"

#include <QTest>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace tetra;

namespace {

constexpr Size usualPicture{1000, 700};

const TextMeasure measure{[](const std::string& text) { return 7.0 * static_cast<double>(text.size()); },
                          [](const std::string& text) { return 8.0 * static_cast<double>(text.size()); }, 15};

AnnotationContent contentOf(const Eigen::AlignedBox3d& box, const Camera& camera)
{
    AnnotationContent content;
    for (AnnotationPlace& place : content.state.places)
        place.shown = false;
    content.state[AnnotationKind::BoxAxes].shown = true;
    content.box = box;
    content.camera = camera;
    content.background = {1, 1, 1};
    return content;
}

/// Where a place is seen, x to the right and y down.
class Projected {
public:
    Projected(const AnnotationContent& content, const Size& picture)
        : matrix_(projectionMatrix(content.camera, picture.width / picture.height, content.box) *
                  viewMatrix(content.camera)),
          picture_(picture)
    {
    }

    Eigen::Vector2d at(const Eigen::Vector3d& place) const
    {
        const Eigen::Vector4d clip = matrix_ * place.homogeneous();
        return {(clip.x() / clip.w() + 1) / 2 * picture_.width, (1 - clip.y() / clip.w()) / 2 * picture_.height};
    }

private:
    Eigen::Matrix4d matrix_;
    Size picture_;
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether a place is well within what the box covers: in a triangle of three of its corners.
bool isCovered(const Eigen::Vector2d& place, const std::vector<Eigen::Vector2d>& corners)
{
    constexpr double room = 0.5;
    const auto within = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
        const double sign = cross(b - a, c - a) > 0 ? 1 : -1;
        const auto inside = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
            return sign * cross(to - from, place - from) > room * (to - from).norm();
        };
        return inside(a, b) && inside(b, c) && inside(c, a);
    };
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (within(corners[i], corners[j], corners[k]))
                    return true;
    return false;
}

std::vector<Eigen::Vector2d> cornersOf(const Projected& projected, const Eigen::AlignedBox3d& box)
{
    std::vector<Eigen::Vector2d> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners.push_back(projected.at(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
    return corners;
}

bool coversText(const std::vector<Eigen::Vector2d>& corners, const Rectangle& place)
{
    constexpr int steps = 6;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            if (isCovered({place.left + place.width * i / steps, place.top + place.height * j / steps}, corners))
                return true;
    return false;
}

/// How far a tick is from the nearest of the four edges where its value is.
double distanceFromEdges(const BoxTick& tick, std::size_t axis, const Projected& projected,
                         const Eigen::AlignedBox3d& box)
{
    double nearest = 1e9;
    for (int sides = 0; sides < 4; ++sides) {
        Eigen::Vector3d place;
        place[static_cast<int>(axis)] = tick.value;
        for (int i = 0; i < 2; ++i) {
            const int other = static_cast<int>(axis + 1 + static_cast<std::size_t>(i)) % 3;
            place[other] = (sides >> i & 1) == 0 ? box.min()[other] : box.max()[other];
        }
        nearest = std::min(nearest, (projected.at(place) - tick.place).norm());
    }
    return nearest;
}

std::vector<Rectangle> textsOf(const AnnotationLayout& layout)
{
    std::vector<Rectangle> places;
    for (const BoxAxisLayout& axis : layout.boxAxes) {
        for (const BoxTick& tick : axis.ticks)
            if (!tick.label.text.empty())
                places.push_back(tick.label.place);
        if (!axis.name.text.empty())
            places.push_back(axis.name.place);
    }
    return places;
}

double numberOf(const std::string& text)
{
    double number = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

Camera anyCamera(std::mt19937& random, const Eigen::AlignedBox3d& box)
{
    std::uniform_real_distribution<double> angle(-180, 180), height(-89, 89), far(1.2, 4);
    Camera camera{.target = box.center(),
                  .distance = far(random) * box.diagonal().norm(),
                  .azimuth = angle(random),
                  .elevation = height(random),
                  .perspective = random() % 2 == 0};
    camera.roll = random() % 3 == 0 ? angle(random) : 0;
    return camera;
}

/// From a corner, with room around the box.
Camera inRoom(const Eigen::AlignedBox3d& box, double aspectRatio)
{
    ViewValue view{.camera = {.azimuth = 30, .elevation = 20}};
    view.annotations[AnnotationKind::BoxAxes].shown = true;
    return fittedToBox(view, box, aspectRatio);
}

Picture painted(const AnnotationContent& content, double scale)
{
    Picture picture{.width = 800, .height = 600, .pixels = {}};
    picture.pixels.assign(800 * 600, {255, 255, 255, 255});
    return paintAnnotations(pixelsOf(picture), content, scale) ? picture : Picture();
}

double darkness(const Picture& picture)
{
    double sum = 0;
    for (const auto& pixel : picture.pixels)
        sum += 255 - (pixel[0] + pixel[1] + pixel[2]) / 3.0;
    return sum;
}

} // namespace

class BoxAxesTest : public QObject {
    Q_OBJECT
private slots:
    void numbersStandWhereTheBoxIsAndOutsideOfIt()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> place(-100, 100), length(-2, 3);
        int seen = 0, named = 0, all = 0;
        for (int round = 0; round < 400; ++round) {
            const Eigen::Vector3d least(place(random), place(random), place(random));
            const Eigen::Vector3d extent(std::pow(10, length(random)), std::pow(10, length(random)),
                                         std::pow(10, length(random)));
            const Eigen::AlignedBox3d box(least, least + extent);
            AnnotationContent content = contentOf(box, anyCamera(random, box));
            content.lengthUnit = "mm";
            for (const AnnotationKind kind : {AnnotationKind::Axes, AnnotationKind::ScaleBar})
                content.state[kind].shown = random() % 2 == 0;
            const AnnotationLayout layout = layOutAnnotations(content, usualPicture, measure);
            const Projected projected(content, usualPicture);
            const auto corners = cornersOf(projected, box);
            std::set<std::size_t> axes;
            for (const BoxAxisLayout& axis : layout.boxAxes) {
                QVERIFY(axes.insert(axis.axis).second);
                std::size_t labels = 0;
                for (const BoxTick& tick : axis.ticks) {
                    QVERIFY(distanceFromEdges(tick, axis.axis, projected, box) < 1e-3);
                    if (tick.label.text.empty())
                        continue;
                    ++labels;
                    const double step = axis.ticks.size() > 1 ? axis.ticks[1].value - axis.ticks[0].value : 1;
                    QVERIFY2(std::abs(numberOf(tick.label.text) - tick.value) < 1e-3 * step, tick.label.text.c_str());
                    QVERIFY(!coversText(corners, tick.label.place));
                }
                QVERIFY(labels > 1);
                QVERIFY(axis.name.text.empty() || !coversText(corners, axis.name.place));
                QVERIFY(axis.name.text.empty() || axis.name.text == std::string("xyz").substr(axis.axis, 1) + " (mm)");
                named += axis.name.text.empty() ? 0 : 1;
                ++all;
            }
            seen += layout.boxAxes.empty() ? 0 : 1;
        }
        QVERIFY2(seen > 350, QByteArray::number(seen));
        QVERIFY2(named > 0.95 * all, QByteArray::number(100 * named / std::max(1, all)));
    }

    void nothingOverlapsOrLeavesThePicture()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> side(20, 1500);
        const Eigen::AlignedBox3d box(Eigen::Vector3d(-3, 10, 0), Eigen::Vector3d(120, 95, 0.4));
        for (int round = 0; round < 400; ++round) {
            AnnotationContent content = contentOf(box, anyCamera(random, box));
            content.camera.distance *= round % 3 == 0 ? 0.3 : 1; // near it, and in it
            content.camera.target += Eigen::Vector3d::Random() * (round % 5 == 0 ? 80 : 0);
            content.lengthUnit = "mm";
            content.title = "a title";
            content.accuracy = "Error 1 %";
            content.range = {0, 255};
            content.transfer = transferFunctionFromPoints({{0, {0, 0, 1}, 0}, {255, {1, 0, 0}, 0.9F}}, 1);
            for (AnnotationPlace& place : content.state.places)
                place = {true, static_cast<Corner>(random() % 4)};
            const Size picture{side(random), side(random)};
            const AnnotationLayout layout = layOutAnnotations(content, picture, measure);
            auto places = textsOf(layout);
            for (const Rectangle& place : places)
                QVERIFY(Rectangle({0, 0, picture.width, picture.height}).contains(place));
            places.insert(places.end(), layout.places.begin(), layout.places.end());
            for (std::size_t i = 0; i < places.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    QVERIFY(!places[i].intersects(places[j]));
            for (const BoxAxisLayout& axis : layout.boxAxes)
                for (const Eigen::Vector2d& end : {axis.from, axis.to})
                    QVERIFY(
                        Rectangle({0, 0, picture.width, picture.height}).grown(1).contains({end.x(), end.y(), 0, 0}));
        }
    }

    void usualViewsHaveAllThree_data()
    {
        QTest::addColumn<double>("azimuth");
        QTest::addColumn<double>("elevation");
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<int>("axes");
        for (const bool perspective : {false, true}) {
            QTest::addRow("corner %d", perspective) << 30.0 << 20.0 << perspective << 3;
            QTest::addRow("from behind %d", perspective) << 200.0 << -35.0 << perspective << 3;
            QTest::addRow("front %d", perspective) << 0.0 << 0.0 << perspective << 2;
            QTest::addRow("top %d", perspective) << 0.0 << 90.0 << perspective << 2;
        }
    }
    void usualViewsHaveAllThree()
    {
        QFETCH(double, azimuth);
        QFETCH(double, elevation);
        QFETCH(bool, perspective);
        QFETCH(int, axes);
        const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(255, 255, 127));
        const Camera camera{.azimuth = azimuth, .elevation = elevation, .perspective = perspective};
        ViewValue view{.camera = camera};
        view.annotations[AnnotationKind::BoxAxes].shown = true;
        const AnnotationContent content =
            contentOf(box, fittedToBox(view, box, usualPicture.width / usualPicture.height));
        const AnnotationLayout layout = layOutAnnotations(content, usualPicture, measure);
        QCOMPARE(static_cast<int>(layout.boxAxes.size()), axes);
        for (const BoxAxisLayout& axis : layout.boxAxes) {
            QVERIFY(!axis.name.text.empty());
            QVERIFY(std::ranges::count_if(axis.ticks, [](const BoxTick& tick) { return !tick.label.text.empty(); }) >=
                    2);
        }
    }

    void theyAreWrittenAsAskedFor()
    {
        const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
        AnnotationContent content = contentOf(box, inRoom(box, 1.4));
        content.state[AnnotationKind::ScaleBar].shown = true;
        content.space = "RAS";
        content.state.lengths = {NumberFormat::Style::Plain, 3};
        AnnotationLayout layout = layOutAnnotations(content, usualPicture, measure);
        QVERIFY(layout.boxAxes.size() == 3 && layout.scaleBar);
        for (const BoxAxisLayout& axis : layout.boxAxes) {
            QCOMPARE(axis.name.text, std::string("RAS").substr(axis.axis, 1));
            for (const BoxTick& tick : axis.ticks)
                QVERIFY(tick.label.text.empty() || tick.label.text.size() == 5);
        }
        QVERIFY2(layout.scaleBar->label.text.find(".000 ") != std::string::npos ||
                     layout.scaleBar->label.text.find("00 units") != std::string::npos,
                 layout.scaleBar->label.text.c_str());
        content.state.lengths = {NumberFormat::Style::Powers, 1};
        content.language.numbers.decimalPoint = ",";
        layout = layOutAnnotations(content, usualPicture, measure);
        for (const BoxAxisLayout& axis : layout.boxAxes)
            for (const BoxTick& tick : axis.ticks)
                QVERIFY(tick.label.text.empty() || tick.label.text.find(",0e") != std::string::npos);
    }

    void thereAreNoneWithoutABoxOrInIt()
    {
        const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
        const Camera camera{.target = {0.5, 0.5, 0.5}, .distance = 0.1};
        QVERIFY(layOutAnnotations(contentOf(box, camera), usualPicture, measure).boxAxes.empty());
        QVERIFY(layOutAnnotations(contentOf({}, Camera()), usualPicture, measure).boxAxes.empty());
        const Eigen::AlignedBox3d point(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 1, 1));
        QVERIFY(layOutAnnotations(contentOf(point, Camera()), usualPicture, measure).boxAxes.empty());
        AnnotationContent off = contentOf(box, inRoom(box, 1.4));
        QVERIFY(!layOutAnnotations(off, usualPicture, measure).boxAxes.empty());
        off.state[AnnotationKind::BoxAxes].shown = false;
        QVERIFY(layOutAnnotations(off, usualPicture, measure).boxAxes.empty());
    }

    /// Their texts in a drawing are texts.
    void drawingsKeepThemAsTexts()
    {
        const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 10, 10));
        const AnnotationContent content = contentOf(box, inRoom(box, 4.0 / 3));
        std::vector<DrawnShape> drawing;
        QVERIFY(paintAnnotations(PixelCanvas(drawing, 800, 600, 1), content).ok());
        const auto texts = std::ranges::count_if(
            drawing, [](const DrawnShape& shape) { return std::holds_alternative<WrittenText>(shape); });
        const auto fonts = openFonts();
        QVERIFY(fonts.ok());
        const AnnotationLayout layout = layOutAnnotations(content, {800, 600}, textMeasure(**fonts));
        QCOMPARE(static_cast<std::size_t>(texts), textsOf(layout).size());
        QVERIFY(texts > 12);
        const auto largest = [&](double textSize) {
            AnnotationContent sized = content;
            sized.state.textSize = textSize;
            std::vector<DrawnShape> drawn;
            double size = 0;
            if (paintAnnotations(PixelCanvas(drawn, 2400, 1800, 3), sized))
                for (const DrawnShape& shape : drawn)
                    if (const auto* text = std::get_if<WrittenText>(&shape))
                        for (const GlyphRun& run : text->runs)
                            size = std::max(size, run.size);
            return size;
        };
        QCOMPARE(largest(usualTextSize), usualTextSize);
        QCOMPARE(largest(24), 24.0);
    }

    /// All of a picture's annotations grow with their texts, as on a screen with more pixels.
    void textsAreAsLargeAndHeavyAsAskedFor()
    {
        const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 10, 10));
        AnnotationContent content = contentOf(box, inRoom(box, 4.0 / 3));
        content.title = "A title";
        content.state[AnnotationKind::Title].shown = true;
        content.state[AnnotationKind::Axes].shown = true;
        const Picture usual = painted(content, 1), twice = painted(content, 2);
        QVERIFY(!usual.pixels.empty() && usual.pixels != twice.pixels);
        content.state.textSize = 2 * usualTextSize;
        QVERIFY(painted(content, 1).pixels == twice.pixels);
        content.state.textSize = usualTextSize;
        content.state.boldText = true;
        const double heavier = darkness(painted(content, 1)) / darkness(usual);
        QVERIFY2(heavier > 1.05, QByteArray::number(heavier));
        content.state[AnnotationKind::BoxAxes].shown = false;
        content.state[AnnotationKind::Axes].shown = false; // a title is bold anyway
        const Picture title = painted(content, 1);
        content.state.boldText = false;
        QVERIFY(painted(content, 1).pixels == title.pixels);
    }
};

QTEST_GUILESS_MAIN(BoxAxesTest)
#include "box_axes_test.moc"
