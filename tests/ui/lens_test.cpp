// SPDX-License-Identifier: GPL-3.0-or-later
// The lens over the picture (C5): where it lies and what it shows, by mouse and by keys, and what is kept of it.
#include "core/picture/session_document.h"
#include "core/picture/view_picture.h"
#include "core/view/lens.h"
#include "tests/ui/sample_window.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/scenes/picture_image.h"
#include "ui/viewport/lens_tool.h"
#include "ui/viewport/value_pick.h"
#include "ui/viewport/view_projection.h"

#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

#include <cmath>
#include <random>

using namespace tetra;

class LensTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theFrustumHoldsWhatIsSeen_data();
    void theFrustumHoldsWhatIsSeen();
    void itIsTheLargerPicture_data();
    void itIsTheLargerPicture();
    void keysAndActions();
    void theMouse();
    void picksBeneathIt();
    void itIsKept();
    void itIsInSavedPictures();

private:
    Session& session() const { return window_->workbench.session(); }
    const LensState& lens() const { return session().view().lens; }
    LensTool& tool() const { return window_->find<LensTool>("viewport.lens"); }
    bool upToDate() const { return window_->settled() && session().showsQuery() && tool().settled(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::keyClick(&window_->viewport(), key, modifiers);
    }
    void switchOn() const;

    std::unique_ptr<WindowFixture> window_;
};

namespace {

Camera anyCamera(std::mt19937& random, bool perspective)
{
    std::uniform_real_distribution<double> unit(0, 1);
    return {.target = {unit(random), unit(random), unit(random)},
            .distance = 2 + unit(random),
            .azimuth = 360 * unit(random),
            .elevation = 160 * unit(random) - 80,
            .roll = 360 * unit(random),
            .fieldOfView = 20 + 40 * unit(random),
            .perspective = perspective};
}

LensState anyLens(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0, 1);
    return {.shape = LensState::Shape::Square,
            .x = unit(random),
            .y = unit(random),
            .radius = 0.05 + 0.45 * unit(random),
            .magnification = 1 + 15 * unit(random)};
}

bool inAll(std::span<const HalfSpace> planes, const Eigen::Vector3d& place)
{
    return std::ranges::all_of(planes, [&](const HalfSpace& plane) { return plane.normal.dot(place) <= plane.offset; });
}

} // namespace

void LensTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("lens");
    QLocale::setDefault(QLocale::c());
}

void LensTest::init()
{
    window_ = windowOnSample(20, {900, 600});
}

void LensTest::cleanup()
{
    window_.reset();
}

void LensTest::switchOn() const
{
    session().setError(8);
    LensState on = lens();
    on.shape = LensState::Shape::Circle;
    on.error = 0.5;
    session().setLens(on);
    QTRY_VERIFY(upToDate());
}

void LensTest::theFrustumHoldsWhatIsSeen_data()
{
    QTest::addColumn<bool>("perspective");
    QTest::newRow("perspective") << true;
    QTest::newRow("orthographic") << false;
}

/// A place is in all half-spaces if and only if it is seen in the lens's square; and a line of sight through the lens
/// is the one through the place beneath in the picture.
void LensTest::theFrustumHoldsWhatIsSeen()
{
    QFETCH(bool, perspective);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    int seen = 0;
    for (int round = 0; round < 600; ++round) {
        const Camera camera = anyCamera(random, perspective);
        const int width = 200 + static_cast<int>(random() % 400), height = 200 + static_cast<int>(random() % 400);
        const LensState state = anyLens(random);
        const LensPicture picture = lensPicture(state, width, height);
        QVERIFY(picture.part.left >= 0 && picture.part.width >= 1 &&
                picture.part.left + picture.part.width <= picture.width);
        QVERIFY(picture.part.top >= 0 && picture.part.height >= 1 &&
                picture.part.top + picture.part.height <= picture.height);
        QVERIFY(std::abs(static_cast<double>(picture.width) / width - state.magnification) < 0.01);
        const auto planes = seenInLens(picture, camera);
        const ViewProjection enlarged(camera, QSize(picture.width, picture.height)),
            small(camera, QSize(width, height));
        for (int place = 0; place < 20; ++place) {
            const Eigen::Vector3d point(unit(random), unit(random), unit(random));
            const auto pixel = enlarged.pixelOf(point);
            QVERIFY(pixel);
            const QRectF part(picture.part.left, picture.part.top, picture.part.width, picture.part.height);
            if (part.adjusted(-1, -1, 1, 1).contains(*pixel) != part.adjusted(1, 1, -1, -1).contains(*pixel))
                continue; // at the border: rounding of the sizes
            QCOMPARE(inAll(planes, point), part.contains(*pixel));
            seen += part.contains(*pixel) ? 1 : 0;
        }
        const Eigen::Vector2d place(picture.square.left + picture.left + unit(random) * picture.part.width,
                                    picture.square.top + picture.top + unit(random) * picture.part.height);
        const Eigen::Vector2d beneath = placeUnder(picture, place);
        const PickingRay line = small.pickingRay({beneath.x(), beneath.y()});
        const PickingRay through =
            enlarged.pickingRay({place.x() - picture.square.left - picture.left + picture.part.left,
                                 place.y() - picture.square.top - picture.top + picture.part.top});
        const double pixels = 1e-2; // the enlarged picture has whole pixels
        QVERIFY((line.direction - through.direction).norm() < pixels && (line.origin - through.origin).norm() < pixels);
    }
    QVERIFY2(seen > 100, QByteArray::number(seen)); // of twelve thousand
}

void LensTest::itIsTheLargerPicture_data()
{
    QTest::addColumn<QString>("mode");
    QTest::addColumn<bool>("perspective");
    for (const char* mode : {"isosurface", "volume", "hybrid"})
        for (const bool perspective : {true, false})
            QTest::addRow("%s, %s", mode, perspective ? "perspective" : "orthographic") << QString(mode) << perspective;
}

/// What is seen in the lens is the crop of a larger picture drawn with the finer mesh, pixel for pixel.
void LensTest::itIsTheLargerPicture()
{
    QFETCH(QString, mode);
    QFETCH(bool, perspective);
    window_->find<QAction>("action.mode." + mode).trigger();
    Camera camera = window_->viewport().camera();
    camera.perspective = perspective;
    window_->viewport().setCamera(camera);
    switchOn();
    const DrawnLens drawn = *tool().drawn();
    QVERIFY(drawn.tetrahedra > session().shown()->tetrahedra);

    SceneRequest request = lensScene({lens(), window_->workbench.scenes().sceneRequest()}, drawn.place, camera);
    QVERIFY(!(request.query == session().shown()->query));
    ScenePipeline pipeline;
    const auto built = pipeline.make(request, {});
    QVERIFY(built.ok());
    QCOMPARE(built->mesh.tetrahedra, drawn.tetrahedra);
    PictureOrder whole;
    whole.scene = built->scene;
    whole.camera = camera;
    whole.background = window_->viewport().background();
    whole.width = drawn.place.width;
    whole.height = drawn.place.height;
    whole.samplesPerAxis = 2;
    const auto picture = pipeline.draw(whole, false, {});
    QVERIFY(picture.ok());
    const PixelRectangle& part = drawn.place.part;
    const QImage crop = imageOf(*picture).copy(part.left, part.top, part.width, part.height);
    const QImage content = imageOf(drawn.content);
    QCOMPARE(crop.size(), content.size());
    QVERIFY(crop.convertToFormat(QImage::Format_RGB32) == content.convertToFormat(QImage::Format_RGB32));
    // With the mesh of the picture it would be another one.
    whole.scene = window_->viewport().scene();
    const auto coarse = pipeline.draw(whole, false, {});
    QVERIFY(coarse.ok() && coarse->pixels != picture->pixels);
    // On the screen it lies in its place.
    const QImage screen = window_->viewport().grab().toImage();
    const QPoint middle(drawn.place.square.left + drawn.place.square.width / 2,
                        drawn.place.square.top + drawn.place.square.height / 2);
    QCOMPARE(QColor(screen.pixel(middle)),
             QColor(content.pixel(middle - QPoint(drawn.place.square.left + drawn.place.left,
                                                  drawn.place.square.top + drawn.place.top))));
    // Another mode, camera or error is another picture.
    session().setLens([&] {
        LensState moved = lens();
        moved.x += 0.05;
        return moved;
    }());
    QVERIFY(!tool().settled());
    QTRY_VERIFY(upToDate());
    QVERIFY(tool().drawn()->content.pixels != drawn.content.pixels);
}

void LensTest::keysAndActions()
{
    QVERIFY(!lens().isOn() && !tool().isVisible());
    window_->viewport().setFocus();
    const int steps = session().undoStack().count();
    window_->find<QAction>("action.lens").trigger();
    QCOMPARE(lens().shape, LensState::Shape::Circle);
    QVERIFY(tool().isVisible() && window_->find<QAction>("action.lens").isChecked());
    QVERIFY(window_->find<QToolButton>("lens.circle").isChecked() &&
            window_->find<QWidget>("lens.magnification.box").isVisible());
    QCOMPARE(tool().accessibleName(), QString("Lens"));
    QVERIFY(tool().accessibleDescription().contains('3'));
    QCOMPARE(session().undoStack().undoText(), QString("Change Lens"));
    const LensState first = lens();
    key(Qt::Key_Right, Qt::AltModifier);
    key(Qt::Key_Down, Qt::AltModifier);
    QVERIFY(lens().x > first.x && lens().y > first.y);
    key(Qt::Key_Plus, Qt::AltModifier);
    QVERIFY(lens().magnification > first.magnification);
    QCOMPARE(session().undoStack().count(), steps + 2); // one series
    key(Qt::Key_Left);                                  // of the camera
    QVERIFY(session().view().camera != Camera() && lens().y > first.y);
    key(Qt::Key_Escape);
    QVERIFY(!lens().isOn() && !tool().isVisible());
    QVERIFY(!window_->find<QWidget>("lens.magnification.box").isVisible());
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(lens().isOn());
    while (session().undoStack().count() > 0 && session().undoStack().index() > steps)
        session().undoStack().undo();
    QVERIFY(!lens().isOn());
    LensState wrong = first;
    wrong.x = std::nan("");
    wrong.magnification = 1e9;
    wrong.radius = -1;
    session().setLens(wrong);
    QCOMPARE(lens().x, LensState().x);
    QCOMPARE(lens().magnification, largestMagnification);
    QCOMPARE(lens().radius, leastLensRadius);
}

void LensTest::theMouse()
{
    switchOn();
    Viewport& viewport = window_->viewport();
    const int steps = session().undoStack().count();
    const Camera camera = session().view().camera;
    const QPoint from(static_cast<int>(lens().x * viewport.width()), static_cast<int>(lens().y * viewport.height()));
    const LensState before = lens();
    const auto moveTo = [&](QPoint to) {
        QMouseEvent move(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport, &move);
    };
    QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i)
        moveTo(from + QPoint(10 * i, 5 * i));
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, from + QPoint(40, 20));
    QVERIFY(std::abs(lens().x - before.x - 40.0 / viewport.width()) < 1e-9);
    QVERIFY(std::abs(lens().y - before.y - 20.0 / viewport.height()) < 1e-9);
    QCOMPARE(session().undoStack().count(), steps + 1);
    const auto wheel = [&](QPoint place) {
        QWheelEvent turn(place, viewport.mapToGlobal(place), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&viewport, &turn);
    };
    wheel(from);
    wheel(from);
    QVERIFY(lens().magnification > 1.2 * before.magnification);
    QCOMPARE(session().undoStack().count(), steps + 2);
    QVERIFY(session().view().camera == camera);
    wheel({3, 3}); // beside it
    QVERIFY(session().view().camera.distance < camera.distance);
    // A drag that is given up.
    const LensState now = lens();
    QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
    moveTo(from + QPoint(50, 0));
    QVERIFY(lens() != now);
    QTest::keyClick(&viewport, Qt::Key_Escape);
    QVERIFY(lens() == now);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, from + QPoint(50, 0));
    // Beside it a drag turns the camera.
    const Camera turned = session().view().camera;
    QTest::mousePress(&viewport, Qt::LeftButton, {}, {5, 5});
    moveTo({45, 30});
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, {45, 30});
    QVERIFY(session().view().camera != turned && lens() == now);
}

/// A click in the lens picks what is seen there.
void LensTest::picksBeneathIt()
{
    window_->find<QAction>("action.mode.isosurface").trigger();
    switchOn();
    Viewport& viewport = window_->viewport();
    const QPointF middle(lens().x * viewport.width(), lens().y * viewport.height());
    const QPointF place = middle + QPointF(30, -18);
    const QPointF beneath = viewport.beneathLens(place);
    QVERIFY(QLineF(beneath, middle + QPointF(30, -18) / lens().magnification).length() < 1.5);
    QCOMPARE(viewport.beneathLens({2, 2}), QPointF(2, 2));
    auto& pick = *viewport.findChild<ValuePick*>();
    pick.pickAt(place);
    QTRY_VERIFY(!pick.busy());
    if (pick.picked())
        QVERIFY(QLineF(*viewport.projection().pixelOf(pick.picked()->place), beneath).length() < 1.5);
}

void LensTest::itIsKept()
{
    SessionDocument document;
    document.model = "/some/model.tan";
    document.view.lens = {LensState::Shape::Square, 0.25, 0.75, 0.125, 4.5, 0.1};
    const auto read = sessionFromText(sessionToText(document, "/some"), "/some");
    QVERIFY(read.ok());
    QVERIFY(read->view.lens == document.view.lens);
}

/// Saved pictures have it, at any size, around the same place.
void LensTest::itIsInSavedPictures()
{
    window_->find<QAction>("action.mode.volume").trigger();
    switchOn();
    AnnotationState none;
    for (AnnotationPlace& place : none.places)
        place.shown = false;
    const QSize size(300, 260);
    PictureOrder order = pictureOrder(window_->workbench, window_->viewport(), {size, 0, false, none});
    QVERIFY(order.lens);
    const auto drawnWith = drawPicture(order, {});
    order.lens.reset();
    const auto drawnWithout = drawPicture(order, {});
    QVERIFY(drawnWith.ok() && drawnWithout.ok());
    const QImage with = imageOf(*drawnWith), without = imageOf(*drawnWithout);
    const LensPicture place = lensPicture(lens(), size.width(), size.height());
    int changed = 0;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const bool differs = with.pixel(x, y) != without.pixel(x, y);
            const Eigen::Vector2d beside(x + (x < size.width() / 2 ? 3 : -3), y + (y < size.height() / 2 ? 3 : -3));
            if (!holds(lens(), place, {x + 0.5, y + 0.5}) && !holds(lens(), place, beside))
                QVERIFY(!differs);
            changed += differs ? 1 : 0;
        }
    QVERIFY2(changed > 500, QByteArray::number(changed));
}

QTEST_MAIN(LensTest)
#include "lens_test.moc"
