// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/control_list.h"
#include "tests/ui/driving/driving_test.h"
#include "ui/tools/tool_desk.h"

#include <QComboBox>
#include <QDockWidget>

using namespace tetra;

/// Every control of every dock is found by its name, is used once by keys as somebody would, and does what it is for.
class DockControlsTest : public DrivingTest {
    Q_OBJECT
private slots:
    void initTestCase() { makeFiles("dock_controls"); }
    void cleanupTestCase() { endWindow(); }
    void everyControlIsDriven();
    void controlWorks_data();
    void controlWorks();

private:
    static Drivers drivers()
    {
        return allOf({accuracyControls(), lookControls(), transferControls(), regionControls(), animationControls(),
                      buildControls(), toolControls()});
    }
    QStringList controlNames();
};

namespace {

void addNames(QStringList& names, const DrivenWindow& window)
{
    for (const QDockWidget* dock : window.window.findChildren<QDockWidget*>())
        for (const QWidget* control : controlsOf(*dock->widget())) {
            const QString name = control->objectName();
            names.append(
                !name.isEmpty()
                    ? name
                    : QString("nameless %1 in %2").arg(control->metaObject()->className(), dock->objectName()));
        }
}

} // namespace

/// Of all the forms that depend on a choice, too.
QStringList DockControlsTest::controlNames()
{
    DrivenWindow& window = startWindow();
    QStringList names;
    for (const auto& mode : window.workbench.scenes().modes()) {
        window.choose(QString::fromStdString(mode.id));
        addNames(names, window);
    }
    auto& builder = window.find<QComboBox>("build.builder");
    for (int index = 0; index < builder.count(); ++index) {
        builder.setCurrentIndex(index);
        addNames(names, window);
    }
    ViewValue view = window.now();
    view.appearance.mode = "isosurface";
    view.tools["ruler"] = "0,0,0 1,0,0";
    view.appearance.settings["clip"] = std::string("1,0,0,4");
    window.session().setView(view);
    auto& tools = window.find<ToolDesk>("viewport.toolDesk");
    for (const auto& tool : tools.tools()) {
        tools.choose(tool.id);
        addNames(names, window);
    }
    names.removeDuplicates();
    return names;
}

void DockControlsTest::everyControlIsDriven()
{
    const QStringList names = controlNames();
    QVERIFY(names.size() > 120);
    const QStringList found = gaps(drivers(), names);
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void DockControlsTest::controlWorks_data()
{
    QTest::addColumn<QString>("name");
    for (const Driver& driver : drivers())
        QTest::newRow(driver.name.toUtf8()) << driver.name;
}

void DockControlsTest::controlWorks()
{
    QFETCH(QString, name);
    const Drivers all = drivers();
    const auto driver = std::ranges::find(all, name, &Driver::name);
    DrivenWindow& window = startWindow();
    driver->prepare(window);
    window.remember();
    auto& control = window.find<QWidget>(name);
    QVERIFY2(control.isVisible(), "it is not seen");
    QVERIFY2(control.isEnabled(), "it is not enabled");
    const QString wrong = drive(window, *driver, [&] {
        if (driver->use)
            driver->use(window);
        else
            useByKeys(control);
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

QTEST_MAIN(DockControlsTest)
#include "dock_controls_test.moc"
