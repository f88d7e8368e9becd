// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/driver.h"
#include "core/picture/session_document.h"
#include "tests/waiting.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDoubleSpinBox>

namespace tetra {
namespace {

constexpr int longestWait = 30'000;       // milliseconds: a build takes its time where all is checked
constexpr double sliderStep = 0.01;       ///< of what it goes over
constexpr double invisibleValue = 2.5e-4; ///< of the range of values: what number boxes round to
constexpr float invisibleOpacity = 1e-4F;
constexpr float invisibleColour = 1e-3F;

/// Away from the end that it is at.
Qt::Key stepKey(const QWidget& box)
{
    return box.property("value") == box.property("maximum") ? Qt::Key_Down : Qt::Key_Up;
}

/// Whether both look the same; values within a distance.
bool isSameLook(const TransferFunction& one, const TransferFunction& other, double distance)
{
    const auto isNear = [distance](double a, double b) { return std::abs(a - b) <= distance; };
    const auto sameColour = [&](const ColourPoint& a, const ColourPoint& b) {
        bool same = isNear(a.value, b.value) && a.group == b.group;
        for (std::size_t channel = 0; channel < 3; ++channel)
            same = same && std::abs(a.colour[channel] - b.colour[channel]) <= invisibleColour;
        return same;
    };
    const auto sameOpacity = [&](const OpacityPoint& a, const OpacityPoint& b) {
        return isNear(a.value, b.value) && a.group == b.group && std::abs(a.opacity - b.opacity) <= invisibleOpacity;
    };
    if (one.mask.has_value() != other.mask.has_value())
        return false;
    const bool sameMask =
        !one.mask || (isNear(one.mask->least, other.mask->least) && isNear(one.mask->largest, other.mask->largest));
    return sameMask && std::abs(one.unitDistance - other.unitDistance) <= 1e-3 * one.unitDistance &&
           std::ranges::equal(one.colours, other.colours, sameColour) &&
           std::ranges::equal(one.opacities, other.opacities, sameOpacity);
}

ViewValue expectedBy(const Driver& driver, const DrivenWindow& window)
{
    ViewValue view = window.before();
    if (driver.changes)
        driver.changes(view, window);
    return window.session().following(window.before(), view);
}

QStringList linesOf(const ViewValue& view)
{
    SessionDocument document;
    document.view = view;
    document.hasCamera = true;
    return QString::fromStdString(sessionToText(document, "/")).split('\n');
}

/// What is not as it should be: the first lines of the views as files have them.
QString differences(const ViewValue& is, const ViewValue& should)
{
    constexpr qsizetype mostLines = 12;
    const QStringList isLines = linesOf(is);
    const QStringList shouldLines = linesOf(should);
    QStringList told;
    for (const QString& line : shouldLines)
        if (!isLines.contains(line))
            told.append("- " + line.trimmed());
    for (const QString& line : isLines)
        if (!shouldLines.contains(line))
            told.append("+ " + line.trimmed());
    return '\n' + told.mid(0, mostLines).join('\n');
}

/// Back and forth, or forth and back, brings what was there.
QString undoneAndRedone(DrivenWindow& window, const Driver& driver)
{
    if (driver.steps == 0)
        return {};
    const ViewValue after = window.now();
    window.trigger(driver.steps > 0 ? "action.undo" : "action.redo");
    if (window.now() != window.before())
        return "undo does not bring back " + differences(window.now(), window.before());
    window.trigger(driver.steps > 0 ? "action.redo" : "action.undo");
    return window.now() == after ? QString() : "redo does not do it again: " + differences(window.now(), after);
}

} // namespace

bool Driver::drives(const QString& other) const
{
    return name.endsWith('*') ? other.startsWith(name.chopped(1)) : other == name;
}

Driver edit(const QString& name, Driver::Change changes, Driver::Step prepare, Driver::Step use)
{
    return {name, std::move(changes), {}, std::move(prepare), std::move(use), 1};
}

Driver redraw(const QString& name, Driver::Change changes, Driver::Condition shows, Driver::Step prepare,
              Driver::Step use)
{
    return {name, std::move(changes), std::move(shows), std::move(prepare), std::move(use), 1};
}

Driver showing(const QString& name, Driver::Condition shows, Driver::Step prepare, Driver::Step use)
{
    return {name, {}, std::move(shows), std::move(prepare), std::move(use)};
}

Driver opening(const QString& name, const QString& widget, Driver::Step prepare)
{
    return showing(
        name, [widget](const DrivenWindow& window) { return window.isOpen(widget); }, std::move(prepare));
}

AimFrom stepOfBox(const QString& box, const Distance& step)
{
    return [box, step](const DrivenWindow& window, double before) -> Aim {
        const auto& found = window.find<QDoubleSpinBox>(box);
        const double unit = std::pow(10.0, -found.decimals());
        const bool isAtEnd = before >= found.maximum() - unit;
        const double by = step(window);
        // It steps from the number that it shows, and shows what comes of it.
        return {before + (isAtEnd ? -1 : 1) * by, std::min(1.01 * unit, 0.4 * by)};
    };
}

Distance hundredthOf(const Ends& ends)
{
    return [ends](const DrivenWindow& window) {
        const auto [least, largest] = ends(window);
        return sliderStep * (largest - least);
    };
}

AimFrom stepOfSlider(const Ends& ends)
{
    return [ends](const DrivenWindow& window, double before) -> Aim {
        const auto [least, largest] = ends(window);
        const double unit = (largest - least) / 1000; // of the slider's positions
        const double position = std::round((before - least) / unit);
        const bool isAtEnd = position >= 1000;
        return {least + (position + (isAtEnd ? -1 : 1) * 1000 * sliderStep) * unit, 1e-6 * (largest - least)};
    };
}

Driver::Change transfer(const TransferEdit& edited)
{
    return [edited](ViewValue& view, const DrivenWindow& window) {
        const TransferFunction should = edited(view.appearance.transfer, window);
        const TransferFunction is = window.session().view().appearance.transfer;
        view.appearance.transfer =
            isSameLook(is, should, invisibleValue * window.session().range().extent()) ? is : should;
    };
}

TransferLimits rangeOf(const DrivenWindow& window)
{
    return {window.session().range().minimum, window.session().range().maximum};
}

void fitView(ViewValue& view, const DrivenWindow& window)
{
    view.camera = fitted(view.camera, window.workbench.scenes().extent().object, window.session().shape());
}

void fitWholeView(ViewValue& view, const DrivenWindow& window)
{
    view.camera = fitted(view.camera, window.session().model()->description().bounds, window.session().shape());
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

/// Of Okabe and Ito, as they have written them.
Colour paletteColour(int index)
{
    constexpr std::array<std::array<int, 3>, paletteSize> colours{{{230, 159, 0}, // of Okabe and Ito
                                                                   {86, 180, 233},
                                                                   {0, 158, 115},
                                                                   {213, 94, 0},
                                                                   {0, 114, 178},
                                                                   {204, 121, 167},
                                                                   {240, 228, 66},
                                                                   {232, 220, 196}, // materials
                                                                   {224, 172, 142},
                                                                   {190, 92, 80},
                                                                   {176, 186, 198},
                                                                   {150, 142, 132},
                                                                   {96, 156, 196},
                                                                   {245, 245, 242},
                                                                   {255, 255, 255}, // for grounds, too
                                                                   {0, 0, 0}}};
    const auto [red, green, blue] = colours[static_cast<std::size_t>(index)];
    const QColor colour(red, green, blue);
    return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()), static_cast<float>(colour.blueF())};
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
    if (driver.shows ? driver.shows(window) : expectedBy(driver, window) == window.before())
        return "its effect is there before it is used";
    if (driver.use)
        driver.use(window);
    else
        use();
    if (driver.shows && !waitFor([&] { return driver.shows(window); }, longestWait))
        return "it is not seen";
    if (driver.opensAnother)
        return {};
    if (const ViewValue expected = expectedBy(driver, window); window.now() != expected)
        return "not as it should be: " + differences(window.now(), expected);
    if (window.undoSteps() != window.stepsBefore() + driver.steps)
        return QString("it is %1 steps to be undone").arg(window.undoSteps() - window.stepsBefore());
    return undoneAndRedone(window, driver);
}

} // namespace tetra
