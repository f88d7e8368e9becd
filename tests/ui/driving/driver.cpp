// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>

namespace tetra {
namespace {

constexpr int longestWait = 30'000; // milliseconds: a build takes its time where all is checked

/// Away from the end that it is at.
Qt::Key stepKey(const QWidget& box)
{
    return box.property("value") == box.property("maximum") ? Qt::Key_Down : Qt::Key_Up;
}

} // namespace

bool Driver::drives(const QString& other) const
{
    return name.endsWith('*') ? other.startsWith(name.chopped(1)) : other == name;
}

Driver showing(const QString& name, Driver::Condition done, Driver::Step prepare, Driver::Step use)
{
    return {name, std::move(done), std::move(prepare), std::move(use), false};
}

Driver opening(const QString& name, const QString& widget, Driver::Step prepare)
{
    return showing(
        name, [widget](const DrivenWindow& window) { return window.isOpen(widget); }, std::move(prepare));
}

Drivers allOf(std::initializer_list<Drivers> parts)
{
    Drivers all;
    for (const Drivers& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

Driver::Step inDock(const QString& dock)
{
    return [dock](DrivenWindow& window) { window.raise(dock); };
}

void useByKeys(QWidget& control)
{
    control.setFocus();
    if (const auto* box = qobject_cast<const QComboBox*>(&control))
        QTest::keyClick(&control, box->currentIndex() + 1 < box->count() ? Qt::Key_Down : Qt::Key_Up);
    else if (qobject_cast<QAbstractButton*>(&control) != nullptr)
        QTest::keyClick(&control, Qt::Key_Space);
    else if (const auto* slider = qobject_cast<const QAbstractSlider*>(&control))
        QTest::keyClick(&control, slider->value() < slider->maximum() ? Qt::Key_Right : Qt::Key_Left);
    else if (qobject_cast<QAbstractSpinBox*>(&control) != nullptr)
        QTest::keyClick(&control, stepKey(control));
    else
        QTest::keyClick(&control, Qt::Key_Down);
}

QString drive(DrivenWindow& window, const Driver& driver, const std::function<void()>& use)
{
    if (driver.done(window))
        return "its effect is there before it is used";
    use();
    if (!waitFor([&] { return driver.done(window); }, longestWait))
        return "it has no effect";
    if (!driver.isEdit)
        return {};
    if (window.undoSteps() != window.stepsBefore() + 1)
        return QString("it is %1 steps to be undone").arg(window.undoSteps() - window.stepsBefore());
    const ViewValue after = window.now();
    window.trigger("action.undo");
    if (window.now() != window.before())
        return "undo does not bring back what was there";
    window.trigger("action.redo");
    return window.now() == after ? QString() : "redo does not do it again";
}

} // namespace tetra
