// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of what the program paints itself, light and dark, against those that somebody has looked at: the
// editor of transfer functions (R18), annotations, regions with their handles (R24, R25), icons, and each way to draw a
// model (R19, R20, R21). None of them has a text in it, so that no font matters. They are renewed, and then looked at,
// by
//
//     TAN_UPDATE_BASELINES=1 ctest --preset release -R test_ui_baselines
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/annotations/placed_text.h"
#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/editors/transferfunction/preset.h"
#include "plugins/widgets/curves/whole_function.h"
#include "plugins/widgets/icons.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"
#include "tests/ui/pictures.h"
#include "ui/session/annotation_language.h"
#include "ui/viewport/region_painter.h"

#include <QPainter>

using namespace tetra;

namespace {

/// The colours of the window, whatever the desktop has.
QPalette paletteOf(bool dark)
{
    QPalette palette;
    const QColor ground = dark ? QColor(45, 45, 48) : QColor(239, 239, 239);
    const QColor text = dark ? QColor(232, 232, 232) : QColor(24, 24, 24);
    palette.setColor(QPalette::Window, ground);
    palette.setColor(QPalette::Button, ground);
    palette.setColor(QPalette::Base, dark ? QColor(30, 30, 32) : QColor(255, 255, 255));
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::Highlight, QColor(38, 121, 213));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    return palette;
}

void addLightAndDark()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

QString named(const QString& name, bool dark)
{
    return name + (dark ? "-dark" : "-light");
}

void compare(const QImage& picture, const QString& name, const PictureTolerance& tolerance)
{
    const QString wrong = compareWithBaseline(picture, name, tolerance);
    QVERIFY2(wrong.isEmpty(), qPrintable(name + ": " + wrong));
}

TransferFunction uneven(const ValueRange& range)
{
    const auto at = [&range](double part) { return range.minimum + part * range.extent(); };
    return transferFunctionFromPoints({{at(0), {0.1F, 0.2F, 0.8F}, 0},
                                       {at(0.25), {0, 0.7F, 0.6F}, 0.6F},
                                       {at(0.5), {0.9F, 0.9F, 0.2F}, 0.1F},
                                       {at(0.5), {0.8F, 0.2F, 0.1F}, 0.8F},
                                       {at(0.8), {1, 0.6F, 0.2F}, 0.3F},
                                       {at(1), {1, 1, 1}, 1}},
                                      1);
}

/// The plot of the editor with its handles and its strip of colours; the numbers beside and below it are left out.
QImage plotOf(const EditorFixture& editor, bool dark, const std::optional<QRectF>& band = std::nullopt)
{
    const QRectF area(16, 16, 168, 88);
    constexpr QRect withoutNumbers(11, 4, 182, 113);
    TransferPlot plot = editor.canvas().plot();
    plot.area = area;
    const QPalette palette = paletteOf(dark);
    QImage image(200, 140, QImage::Format_RGB32);
    image.fill(palette.color(QPalette::Window));
    QPainter painter(&image);
    paintCanvas(painter, {editor.state(), plot, palette, true, false, true, band}, image.rect());
    painter.end();
    return image.copy(withoutNumbers);
}

/// Everything that can be annotated, seen from where all three axes are equally long.
AnnotationContent contentOn(bool dark)
{
    AnnotationContent content;
    for (AnnotationPlace& place : content.state.places)
        place.shown = true;
    content.range = {0, 10};
    content.transfer = uneven({0, 10});
    content.isovalues = std::vector<Isovalue>{{.value = 2.5}, {.value = 7.5, .red = 0, .green = 0.5F, .blue = 0.7F}};
    content.title = "a model";
    content.camera.azimuth = 45;
    content.camera.elevation = 35.26;
    content.background = dark ? Colour{0.12F, 0.12F, 0.13F} : Colour{1, 1, 1};
    if (const auto fonts = openFonts())
        content.fonts = *fonts;
    return content;
}

AnnotationLayout layoutOf(const AnnotationContent& content, const Size& picture)
{
    return layOutAnnotations(content, picture, textMeasure(*content.fonts));
}

/// What is painted of a picture of this size in a rectangle of it, from a whole pixel on.
QImage annotationsIn(const Rectangle& place, const AnnotationContent& content, const Size& picture)
{
    QImage image(qRound(picture.width), qRound(picture.height), QImage::Format_RGBA8888);
    image.fill(QColor::fromRgbF(content.background.red, content.background.green, content.background.blue));
    if (!paintAnnotations(pixelsOf(image), content, 1))
        return {};
    return image.copy(qRound(place.left), qRound(place.top), qRound(place.width), qRound(place.height));
}

/// The bar and the marks on its left; a picture in which the bar is 130 high, which depends on the font.
QImage colourBarOf(const AnnotationContent& content)
{
    constexpr double height = 130;
    Size picture{900, 300};
    Rectangle bar;
    for (int round = 0; round < 40; ++round) {
        bar = layoutOf(content, picture).colourBar->bar;
        picture.height += height - bar.height;
    }
    return annotationsIn({bar.left - 11, bar.top - 8, bar.width + 14, bar.height + 16}, content, picture);
}

/// The arrows, with a piece of the ground where their letters are.
QImage axesOf(const AnnotationContent& content)
{
    constexpr Size picture{900, 600};
    const AxesLayout axes = *layoutOf(content, picture).axes;
    const Rectangle place{axes.origin.x() - 40, axes.origin.y() - 40, 80, 80};
    QImage image = annotationsIn(place, content, picture);
    QPainter painter(&image);
    for (const AxisLayout& axis : axes.axes) {
        const Eigen::Vector2d letter = axis.label.place.centre() - Eigen::Vector2d(place.left, place.top);
        painter.fillRect(QRectF(letter.x() - 7, letter.y() - 7, 14, 14), image.pixelColor(0, 0));
    }
    return image;
}

/// The bar without what it says.
QImage scaleBarOf(const AnnotationContent& content)
{
    constexpr Size picture{900, 600};
    const ScaleBarLayout bar = *layoutOf(content, picture).scaleBar;
    return annotationsIn({bar.from.x() - 8, bar.from.y() - 3, std::ceil(bar.to.x() - bar.from.x()) + 16, 10}, content,
                         picture);
}

enum class Hold { Selected, Hovered, Dragged };

/// A region around the origin, seen from a corner.
QImage regionPicture(RegionKind kind, const MovableRegion& region, bool dark, Hold hold)
{
    constexpr QSize size(120, 90);
    Camera camera;
    camera.distance = 12;
    const ViewProjection projection(camera, size);
    const QPalette palette = paletteOf(dark);
    const auto handles = handlesOf(region, projection);
    RegionLook look;
    look.colour = regionColour(kind, palette.color(QPalette::Window));
    look.rim = palette.color(QPalette::Base);
    look.selected = hold == Hold::Selected;
    look.dragged = hold == Hold::Dragged;
    if (hold == Hold::Hovered)
        look.hovered = handles.back();
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(palette.color(QPalette::Window));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    if (look.dragged)
        paintAxis(painter, projection, centreOf(region), 2, 3, look.colour);
    paintRegion(painter, projection, region, handles, look);
    return image;
}

} // namespace

class BaselinesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "baselines"); }
    void plotsOfTheEditor_data() { addLightAndDark(); }
    void plotsOfTheEditor();
    void annotations_data() { addLightAndDark(); }
    void annotations();
    void regions_data() { addLightAndDark(); }
    void regions();
    void icons_data() { addLightAndDark(); }
    void icons();
    void presets();

private:
    QTemporaryDir folder_;
    QString model_;
};

void BaselinesTest::plotsOfTheEditor()
{
    QFETCH(bool, dark);
    const EditorFixture editor(model_);
    Session& session = editor.session();
    const auto compareAs = [&](const char* name, const std::optional<QRectF>& band = std::nullopt) {
        compare(plotOf(editor, dark, band), named(name, dark), paintedTolerance);
    };
    compareAs("editor-sequential");
    session.setTransfer(uneven(session.range()));
    compareAs("editor-step");
    editor.state().select({1, 2, 3});
    compareAs("editor-selected", QRectF(50, 30, 60, 50));
    editor.state().setCurrent({});
    const ValueRange range = session.range();
    session.setTransfer(withMask(uneven(range), {range.minimum + 0.2 * range.extent(), range.maximum - 10}));
    session.addIsovalue(range.minimum + 0.3 * range.extent());
    Isovalue hidden = session.view().isovalues.back();
    hidden.visible = false;
    session.setIsovalue(1, hidden);
    compareAs("editor-mask");
    editor.state().setView({{}, {0, 0.5}, OpacityAxis::Logarithmic, ValueAxis::Linear, false});
    compareAs("editor-other-axes");
}

void BaselinesTest::annotations()
{
    QFETCH(bool, dark);
    AnnotationContent content = contentOn(dark);
    compare(colourBarOf(content), named("colour-bar", dark), paintedTolerance);
    compare(axesOf(content), named("axes", dark), paintedTolerance);
    compare(scaleBarOf(content), named("scale-bar", dark), paintedTolerance);
    content.transfer.reset();
    compare(colourBarOf(content), named("colour-bar-of-surfaces", dark), paintedTolerance);
}

void BaselinesTest::regions()
{
    QFETCH(bool, dark);
    const Box box{{-1.5, -1, -1}, {1.5, 1, 1}};
    const Sphere sphere{{0.3, 0, 0}, 1.3};
    const auto compareAs = [dark](const char* name, RegionKind kind, const MovableRegion& region, Hold hold) {
        compare(regionPicture(kind, region, dark, hold), named(name, dark), paintedTolerance);
    };
    compareAs("region-focus-box", RegionKind::Focus, box, Hold::Selected);
    compareAs("region-focus-sphere", RegionKind::Focus, sphere, Hold::Hovered);
    compareAs("region-window", RegionKind::Window, box, Hold::Dragged);
}

void BaselinesTest::icons()
{
    QFETCH(bool, dark);
    constexpr int side = 20;
    constexpr int columns = 8;
    const QPalette before = QGuiApplication::palette();
    QGuiApplication::setPalette(paletteOf(dark));
    QImage image(columns * side, 2 * side, QImage::Format_ARGB32_Premultiplied);
    image.fill(paletteOf(dark).color(QPalette::Window));
    QPainter painter(&image);
    for (int glyph = 0; glyph <= static_cast<int>(Glyph::Lens); ++glyph)
        glyphIcon(static_cast<Glyph>(glyph))
            .paint(&painter, QRect(glyph % columns * side, glyph / columns * side, side, side));
    painter.end();
    QGuiApplication::setPalette(before);
    compare(image, named("icons", dark), paintedTolerance);
}

void BaselinesTest::presets()
{
    constexpr QSize size(72, 18);
    const std::vector<Preset> all = suppliedPresets();
    QImage image(size.width(), size.height() * static_cast<int>(all.size()), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    for (std::size_t i = 0; i < all.size(); ++i)
        painter.drawPixmap(0, size.height() * static_cast<int>(i), presetIcon(all[i], size).pixmap(size));
    painter.end();
    compare(image, "presets", paintedTolerance);
}

QTEST_MAIN(BaselinesTest)
#include "baselines_test.moc"
