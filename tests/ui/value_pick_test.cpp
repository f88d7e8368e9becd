// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/viewport/value_pick.h"

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>

using namespace tetra;

/// A value picked in the picture (R18, R23): by a click or by keys, on a surface and in a volume, and what becomes of
/// it.
class ValuePickTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aClickOnASurfaceFindsItsIsovalue();
    void aClickInAVolumeFindsAValue();
    void bothTogether();
    void aDragAndOtherKeysPickNothing();
    void aClickBesideForgets();
    void escapeAndAnotherModelForget();
    void keysPickAndMakeIsovaluesAndPoints();
    void aRightClickOffersWhatCanBeDone();
    void aPickWaitsForThePicture();
    void theMarkIsSeen();

private:
    Session& session() const { return window_->workbench.session(); }
    const std::optional<PickedValue>& picked() const { return window_->find<ValuePick>("viewport.pick").picked(); }
    QPoint middle() const { return window_->viewport().rect().center(); }
    void show(const char* mode) const
    {
        window_->find<QAction>(QString("action.mode.") + mode).trigger();
        QTRY_VERIFY(window_->settled());
    }
    void click(QPoint place, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::mouseClick(&window_->viewport(), Qt::LeftButton, modifiers, place);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void ValuePickTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("value-pick");
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(8), folder_.path().toStdString()).string());
}

/// Also with OpenGL, where the test runs on a display that has it.
void ValuePickTest::init()
{
    QSettings().clear();
    const bool offscreen = QGuiApplication::platformName() == "offscreen";
    window_ = std::make_unique<WindowFixture>(offscreen ? BackendChoice::Cpu : BackendChoice::Gl);
    // Small pictures of few cells: OpenGL that the processor draws takes seconds for others.
    for (QDockWidget* dock : window_->window.findChildren<QDockWidget*>())
        dock->hide();
    window_->window.resize(360, 260);
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY_WITH_TIMEOUT(session().model() && window_->settled(), 30'000);
}

void ValuePickTest::cleanup()
{
    window_.reset();
}

void ValuePickTest::aClickOnASurfaceFindsItsIsovalue()
{
    Isovalue isovalue = session().view().isovalues.front();
    isovalue.value = session().range().minimum + 0.6 * session().range().extent();
    session().setIsovalue(0, isovalue);
    QTRY_VERIFY(window_->settled());
    const int steps = session().undoStack().index();
    click(middle());
    QTRY_VERIFY(picked().has_value());
    QVERIFY(picked()->onSurface);
    QCOMPARE(picked()->value, isovalue.value);
    const auto pixel = window_->viewport().projection().pixelOf(picked()->place);
    QVERIFY(pixel && (*pixel - middle()).manhattanLength() < 1e-3);
    QCOMPARE(session().undoStack().index(), steps); // looking is no edit
    auto& text = window_->find<QLabel>("status.picked");
    QVERIFY(text.isVisible());
    QVERIFY(text.text().contains("(") && !text.toolTip().isEmpty());
    QCOMPARE(window_->viewport().accessibleDescription(), text.text());
}

void ValuePickTest::aClickInAVolumeFindsAValue()
{
    show("volume");
    // Only values about one are seen, so that it is clear which one is meant.
    const ValueRange range = session().range();
    const double value = range.minimum + 0.5 * range.extent(), reach = 0.02 * range.extent();
    session().setTransfer({{{value, {1, 0, 0}}},
                           {{value - reach, 0}, {value, 1}, {value + reach, 0}},
                           session().model()->diagonal() / 100});
    QTRY_VERIFY(window_->settled());
    click(middle());
    QTRY_VERIFY(picked().has_value());
    QVERIFY(!picked()->onSurface);
    QVERIFY(std::abs(picked()->value - value) < reach);
    QVERIFY(session().model()->description().bounds.contains(picked()->place));
}

void ValuePickTest::bothTogether()
{
    show("hybrid");
    session().setTransfer({{{0, {1, 0, 0}}}, {{0, 0}}}); // an empty volume
    QTRY_VERIFY(window_->settled());
    session().addIsovalue();
    QTRY_VERIFY(window_->settled());
    click(middle());
    QTRY_VERIFY(picked().has_value());
    QVERIFY(picked()->onSurface);
    const auto& isovalues = session().view().isovalues;
    QVERIFY(std::ranges::any_of(isovalues, [this](const Isovalue& one) { return one.value == picked()->value; }));
}

void ValuePickTest::aDragAndOtherKeysPickNothing()
{
    Viewport& viewport = window_->viewport();
    QTest::mousePress(&viewport, Qt::LeftButton, {}, middle());
    const QPoint to = middle() + QPoint(20, 0);
    QMouseEvent move(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&viewport, &move);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, middle());
    click(middle(), Qt::ControlModifier);
    click(middle(), Qt::ShiftModifier);
    QTest::mouseClick(&viewport, Qt::RightButton, {}, middle());
    QVERIFY(!window_->find<ValuePick>("viewport.pick").busy());
    click(middle());
    QVERIFY(window_->find<ValuePick>("viewport.pick").busy());
}

void ValuePickTest::aClickBesideForgets()
{
    click(middle());
    QTRY_VERIFY(picked().has_value());
    click({3, 3});
    QTRY_VERIFY(!picked());
    QVERIFY(!window_->find<QLabel>("status.picked").isVisible());
}

void ValuePickTest::escapeAndAnotherModelForget()
{
    click(middle());
    QTRY_VERIFY(picked().has_value());
    QTest::keyClick(&window_->viewport(), Qt::Key_Escape);
    QVERIFY(!picked());
    click(middle());
    QTRY_VERIFY(picked().has_value());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(!picked());
    QVERIFY(!window_->find<QAction>("action.pickValue").isEnabled());
}

void ValuePickTest::keysPickAndMakeIsovaluesAndPoints()
{
    auto& isovalueHere = window_->find<QAction>("action.isovalueHere");
    auto& pointHere = window_->find<QAction>("action.pointHere");
    QVERIFY(!isovalueHere.isEnabled() && !pointHere.isEnabled());
    show("volume");
    window_->find<QAction>("action.pickValue").trigger();
    QTRY_VERIFY(picked().has_value());
    const double value = picked()->value;
    const int steps = session().undoStack().index();
    const auto isovalues = session().view().isovalues.size();
    const TransferFunction before = session().view().appearance.transfer;
    isovalueHere.trigger();
    QCOMPARE(session().view().isovalues.size(), isovalues + 1);
    QCOMPARE(session().view().isovalues.back().value, value);
    pointHere.trigger();
    const auto points = transferPoints(session().view().appearance.transfer);
    QCOMPARE(points.size(), transferPoints(before).size() + 1);
    QVERIFY(std::ranges::find(points, value, &TransferPoint::value) != points.end());
    QCOMPARE(session().undoStack().index(), steps + 2);
    window_->find<QAction>("action.undo").trigger();
    QCOMPARE(session().view().appearance.transfer, before);
    window_->find<QAction>("action.undo").trigger();
    QCOMPARE(session().view().isovalues.size(), isovalues);
    window_->find<QAction>("action.forgetPicked").trigger();
    QVERIFY(!picked());
}

void ValuePickTest::aRightClickOffersWhatCanBeDone()
{
    Viewport& viewport = window_->viewport();
    auto& menu = window_->find<QMenu>("menu.picture");
    const auto rightClick = [&] {
        QContextMenuEvent event(QContextMenuEvent::Mouse, middle(), viewport.mapToGlobal(middle()));
        QCoreApplication::sendEvent(&viewport, &event);
    };
    rightClick();
    QVERIFY(menu.isVisible());
    QTRY_VERIFY(picked().has_value());
    for (const char* name : {"isovalueHere", "pointHere", "forgetPicked", "fit", "copyPicture", "savePicture"}) {
        auto& action = window_->find<QAction>(QString("action.") + name);
        QVERIFY2(menu.actions().contains(&action) && action.isEnabled(), name);
    }
    const std::size_t before = session().view().isovalues.size();
    window_->find<QAction>("action.isovalueHere").trigger();
    QCOMPARE(session().view().isovalues.size(), before + 1);
    menu.close();
    window_->find<QAction>("action.close").trigger();
    rightClick();
    QVERIFY(!menu.isVisible()); // there is nothing to do anything with
}

void ValuePickTest::aPickWaitsForThePicture()
{
    Isovalue isovalue = session().view().isovalues.front();
    isovalue.value = session().range().minimum + 0.7 * session().range().extent();
    session().setIsovalue(0, isovalue);
    QVERIFY(window_->workbench.scenes().sceneBuilder().busy());
    click(middle()); // the picture shows another isovalue yet
    QTRY_VERIFY(picked().has_value());
    QCOMPARE(picked()->value, isovalue.value);
}

void ValuePickTest::theMarkIsSeen()
{
    auto& pick = window_->find<ValuePick>("viewport.pick");
    const auto markedPixels = [&] {
        QImage image(pick.size(), QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        pick.render(&image, {}, {}, QWidget::RenderFlags());
        const QRgb highlight = pick.palette().color(QPalette::Highlight).rgb();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixel(x, y) == highlight;
        return count;
    };
    QCOMPARE(markedPixels(), 0);
    click(middle());
    QTRY_VERIFY(picked().has_value());
    QVERIFY(markedPixels() > 100);
}

QTEST_MAIN(ValuePickTest)
#include "value_pick_test.moc"
