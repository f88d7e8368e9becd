// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/control_list.h"
#include "tests/ui/every_dialog.h"

#include <QComboBox>
#include <QMetaProperty>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest/qtestspontaneevent.h>

using namespace tetra;

/// The wheel over a panel or a dialog scrolls, and changes only what was chosen by a click or by Tab before.
class WheelTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void controlsOfPanelsAreKept();
    void controlsOfDialogsAreKept();
    void thePanelScrollsInPlaceOfTheControl();
    void aControlWithTheKeysFollowsTheWheel();
    void theWheelZoomsThePicture();

private:
    Session& session() const { return window_->workbench.session(); }
    QStringList changedBelow(const QWidget& root) const;

    QTemporaryDir folder_;
    QString model_;
    QString volume_;
    QString raw_;
    std::unique_ptr<WindowFixture> window_;
};

namespace {

/// Counts the turns of the wheel that come to a widget.
class WheelSpy : public QObject {
public:
    explicit WheelSpy(QWidget& widget) { widget.installEventFilter(this); }

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        seen_ += event->type() == QEvent::Wheel ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }
    int seen() const { return seen_; }

private:
    int seen_ = 0;
};

/// As by hand: such an event may also give the keys to what is below the pointer.
void turnWheel(QWidget& widget, int angle = -120)
{
    const QPointF place(widget.rect().center());
    QWidget* below = widget.childAt(place.toPoint());
    QWidget& receiver = below != nullptr ? *below : widget;
    const QPointF there = receiver.mapFrom(&widget, place);
    QWheelEvent event(there, receiver.mapToGlobal(there), {}, {0, angle}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&receiver, &event);
}

/// What the control says, whatever it is.
QVariant valueOf(const QWidget& control)
{
    return control.metaObject()->userProperty().read(&control);
}

bool hasKeys(const QWidget& widget)
{
    const QWidget* focused = QApplication::focusWidget();
    return focused != nullptr && (&widget == focused || widget.isAncestorOf(focused));
}

bool mayHaveWheel(const QWidget& widget)
{
    return (widget.focusPolicy() & Qt::ClickFocus) == 0 || widget.inherits("QAbstractScrollArea") || hasKeys(widget);
}

} // namespace

void WheelTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("wheel");
    QLocale::setDefault(QLocale::c());
    const auto host = hostOfThisBuild();
    const std::filesystem::path folder = folder_.path().toStdString();
    model_ = QString::fromStdString(buildSampleModel(*host, sampleDataset(10), folder).string());
    volume_ = QString::fromStdString(writeNrrd(sampleDataset(8), folder).string());
    raw_ = folder_.filePath("bare.raw");
    QFile file(raw_);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(QByteArray(8 * 8 * 8, 'a')), 512);
}

void WheelTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window_->window));
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
    window_->window.open(volume_);
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    window_->viewport().setFocus();
}

/// The wheel is turned over all that is seen of `root`; what that changed, and what it came to that has not the keys.
QStringList WheelTest::changedBelow(const QWidget& root) const
{
    QStringList changed;
    const QWidget* focused = QApplication::focusWidget();
    const ViewValue view = session().view();
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        if (!widget->isVisible() || !widget->isEnabled() || widget->visibleRegion().isEmpty())
            continue;
        const QString name = widget->objectName() + " (" + widget->metaObject()->className() + ")";
        const QVariant before = valueOf(*widget);
        const WheelSpy spy(*widget);
        const bool keeps = !mayHaveWheel(*widget);
        turnWheel(*widget);
        turnWheel(*widget, 120);
        turnWheel(*widget, 240);
        if (keeps && spy.seen() > 0)
            changed << name + " gets the wheel";
        if (keeps && valueOf(*widget) != before)
            changed << name + " has changed";
        if (QApplication::focusWidget() != focused)
            changed << name + " has taken the keys";
        if (!(session().view() == view))
            changed << name + " has changed the view";
        if (!changed.isEmpty())
            break;
    }
    return changed;
}

void WheelTest::controlsOfPanelsAreKept()
{
    qsizetype controls = 0;
    for (const auto& mode : window_->workbench.scenes().modes()) {
        window_->find<QAction>("action.mode." + QString::fromStdString(mode.id)).trigger();
        window_->viewport().setFocus();
        for (QDockWidget* dock : window_->window.findChildren<QDockWidget*>()) {
            dock->setFloating(true); // all of it is seen
            dock->resize(dock->widget()->sizeHint().expandedTo({500, 1200}));
            dock->show();
            window_->window.activateWindow();
            QTRY_VERIFY(QApplication::focusWidget() == &window_->viewport());
            const QStringList changed = changedBelow(*dock->widget());
            QVERIFY2(changed.isEmpty(), qPrintable(dock->objectName() + ": " + changed.join("; ")));
            for (const QWidget* control : controlsOf(*dock->widget()))
                controls += control->isVisible();
            dock->hide();
        }
    }
    QVERIFY2(controls > 400, qPrintable(QString::number(controls)));
}

void WheelTest::controlsOfDialogsAreKept()
{
    qsizetype controls = 0;
    for (const OpenableDialog& dialog : everyDialog(volume_, raw_)) {
        dialog.open(*window_);
        auto& widget = window_->find<QWidget>(dialog.name);
        QTRY_VERIFY2(widget.isVisible(), dialog.name);
        const QStringList changed = changedBelow(widget);
        QVERIFY2(changed.isEmpty(), qPrintable(QString(dialog.name) + ": " + changed.join("; ")));
        controls += controlsOf(widget).size();
        widget.close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY2(controls > 60, qPrintable(QString::number(controls)));
}

void WheelTest::thePanelScrollsInPlaceOfTheControl()
{
    auto& dock = window_->find<QDockWidget>("dock.view");
    dock.show();
    dock.raise();
    auto& choice = window_->find<QComboBox>("view.projection");
    const QScrollArea* area = nullptr;
    for (QWidget* around = choice.parentWidget(); area == nullptr && around != nullptr; around = around->parentWidget())
        area = qobject_cast<QScrollArea*>(around);
    QVERIFY(area != nullptr);
    QTRY_VERIFY(area->verticalScrollBar()->maximum() > 0);
    const QString before = choice.currentText();
    turnWheel(choice);
    QVERIFY(area->verticalScrollBar()->value() > 0);
    QCOMPARE(choice.currentText(), before);
}

void WheelTest::aControlWithTheKeysFollowsTheWheel()
{
    auto& dock = window_->find<QDockWidget>("dock.view");
    dock.show();
    dock.raise();
    auto& choice = window_->find<QComboBox>("view.projection");
    const QString before = choice.currentText();
    choice.setFocus();
    turnWheel(choice);
    QVERIFY(choice.currentText() != before);
}

void WheelTest::theWheelZoomsThePicture()
{
    window_->find<QWidget>("accuracy.slider").setFocus();
    const double distance = window_->viewport().camera().distance;
    turnWheel(window_->viewport());
    QVERIFY(window_->viewport().camera().distance > distance);
}

QTEST_MAIN(WheelTest)
#include "wheel_test.moc"
