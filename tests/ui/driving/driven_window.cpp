// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/driven_window.h"

#include "tests/waiting.h"
#include "ui/panels/build_panel.h"
#include "ui/session/files.h"
#include "ui/tools/tool_desk.h"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QMenu>
#include <QTimer>
#include <QToolButton>
#include <QWhatsThis>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr int patience = 60'000; // milliseconds

/// With a mode that has two transfer functions, which no mode of this build has.
std::unique_ptr<PluginHost> hostWithTwoFunctions()
{
    return std::make_unique<PluginHost>(PluginHostOptions{
        .folders = {TAN_BINARY_DIR "/lib/tan/plugins", TAN_BINARY_DIR "/tests/ui-fixtures/renderers"}});
}

template <class Condition> void waitUntil(const Condition& done, const char* what)
{
    if (!waitFor(done, patience))
        qFatal("waited in vain until %s", what);
}

} // namespace

DrivenWindow::DrivenWindow(QString model, QString volume)
    : WindowFixture(BackendChoice::Cpu, hostWithTwoFunctions()), model_(std::move(model)), volume_(std::move(volume))
{
    window.resize(1366, 768);
    window.show();
    startAnew();
}

void DrivenWindow::closeDialogs() const
{
    QWhatsThis::leaveWhatsThisMode();
    while (QWidget* popup = QApplication::activePopupWidget())
        popup->close();
    for (QDialog* dialog : window.findChildren<QDialog*>())
        dialog->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void DrivenWindow::openAnew()
{
    workbench.building().stopBuild(BuildEnd::Discard);
    waitUntil([this] { return !workbench.building().running(); }, "no build runs");
    workbench.opening().models().close();
    workbench.opening().views().forget(filePath(model_)); // as at first
    window.open(model_);
    waitUntil([this] { return session().model() && settled(); }, "the model is open");
    if (!workbench.opening().datasets().dataset() ||
        workbench.opening().datasets().dataset()->source.path != volume_.toStdString()) {
        window.open(volume_);
        waitUntil(
            [this] {
                return workbench.opening().datasets().dataset() &&
                       workbench.opening().datasets().dataset()->source.path == volume_.toStdString();
            },
            "the dataset is open");
    }
    waitUntil([this] { return !find<BuildPanel>("build").looking(); }, "it is known what is there already");
    session().undoStack().clear();
    resetLayout();
    opened_ = session().model();
    atFirst_ = now();
}

/// The picture has its size then, and a camera that nobody has moved fits it.
void DrivenWindow::resetLayout()
{
    window.setWindowState(Qt::WindowNoState);
    trigger("action.resetLayout");
    QCoreApplication::processEvents();
}

void DrivenWindow::startAnew()
{
    closeDialogs();
    find<MessageBar>("messages").clear();
    viewport().setPreview(std::nullopt);
    session().endGesture();
    find<ToolDesk>("viewport.toolDesk").choose({});
    session().undoStack().setIndex(0);
    resetLayout();
    const bool isThere = opened_ && session().model() == opened_ && workbench.opening().datasets().dataset() &&
                         workbench.opening().datasets().dataset()->source.path == volume_.toStdString() &&
                         now() == atFirst_;
    if (!isThere)
        openAnew();
    session().undoStack().clear();
    for (int item = 0; item < 2; ++item)
        press("transfer.canvas", Qt::Key_Escape); // what was selected, then what was picked
    for (const char* look : {"transfer.zoom.all", "transfer.axis.squareRoot", "transfer.valueAxis.linear"})
        trigger(look);
    remember();
}

void DrivenWindow::remember()
{
    before_ = now();
    stepsBefore_ = undoSteps();
}

void DrivenWindow::press(const QString& control, Qt::Key key, Qt::KeyboardModifiers modifiers) const
{
    auto& widget = find<QWidget>(control);
    widget.setFocus();
    QTest::keyClick(&widget, key, modifiers);
}

void DrivenWindow::raise(const QString& dock) const
{
    auto& found = find<QDockWidget>(dock);
    found.show();
    found.raise();
    QCoreApplication::processEvents();
}

void DrivenWindow::addTransferPoint() const
{
    // The model's own function has one in the middle, which another one there would make a step.
    const TransferFunction& function = now().appearance.transfer;
    std::vector<TransferPoint> points = transferPoints(function);
    std::erase_if(points, [this](const TransferPoint& point) {
        return std::abs(point.value - middleOfRange()) < session().range().extent() / 10;
    });
    session().setTransfer(transferFunctionFromPoints(points, function.unitDistance));
    raise("dock.transfer");
    press("transfer.canvas", Qt::Key_Insert);
}

std::size_t DrivenWindow::addedPoint() const
{
    const std::vector<TransferPoint> points = transferPoints(before_.appearance.transfer);
    const auto distance = [this](const TransferPoint& point) { return std::abs(point.value - middleOfRange()); };
    return static_cast<std::size_t>(std::ranges::min_element(points, {}, distance) - points.begin());
}

double DrivenWindow::middleOfRange() const
{
    return session().range().minimum + session().range().extent() / 2;
}

void DrivenWindow::waitForPicture() const
{
    waitUntil([this] { return settled(); }, "the picture comes");
}

bool DrivenWindow::isOpen(const QString& widget) const
{
    const auto* found = window.findChild<QWidget*>(widget);
    return found != nullptr && found->isVisible();
}

void chooseInMenu(QToolButton& button, const QString& action)
{
    QTimer waiting;
    QObject::connect(&waiting, &QTimer::timeout, &button, [&] {
        if (!button.menu()->isVisible())
            return;
        waiting.stop();
        auto* chosen = button.menu()->findChild<QAction*>(action);
        if (chosen == nullptr)
            qFatal("the menu of %s has no %s", qPrintable(button.objectName()), qPrintable(action));
        button.menu()->setActiveAction(chosen);
        QTest::keyClick(button.menu(), Qt::Key_Return);
    });
    waiting.start(1);
    button.setFocus();
    QTest::keyClick(&button, Qt::Key_Space); // comes back when the menu is closed
}

} // namespace tetra
