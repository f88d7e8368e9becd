// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/control_list.h"
#include "tests/ui/driving/driving_test.h"

#include <QMenu>

using namespace tetra;

/// Every command of the window does what it is for: all its actions are found, and each has a driver that uses it and
/// looks for its effect.
class CommandsTest : public DrivingTest {
    Q_OBJECT
private slots:
    void initTestCase() { makeFiles("commands"); }
    void cleanupTestCase() { endWindow(); }
    void everyCommandIsDriven();
    void commandWorks_data();
    void commandWorks();

private:
    static Drivers drivers()
    {
        return allOf({fileCommands(), viewCommands(), regionAndHelpCommands(), transferCommands(), colourCommands(),
                      pickCommands(), toolCommands()});
    }
    QStringList commandNames();
};

/// Of a window with everything in it; menus that are filled when they open are open.
QStringList CommandsTest::commandNames()
{
    const DrivenWindow& window = startWindow();
    for (QMenu* menu : window.window.findChildren<QMenu*>())
        emit menu->aboutToShow();
    QStringList names;
    for (const QAction* action : commandsOf(window.window))
        names.append(action->objectName().isEmpty() ? "nameless " + action->text() : action->objectName());
    names.removeDuplicates();
    return names;
}

void CommandsTest::everyCommandIsDriven()
{
    const QStringList names = commandNames();
    QVERIFY(names.size() > 120);
    const QStringList found = gaps(drivers(), names);
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void CommandsTest::commandWorks_data()
{
    QTest::addColumn<QString>("name");
    const Drivers all = drivers();
    for (const QString& name : commandNames())
        QTest::newRow(name.toUtf8()) << name;
}

void CommandsTest::commandWorks()
{
    QFETCH(QString, name);
    const Drivers all = drivers();
    const auto driver = std::ranges::find_if(all, [&](const Driver& each) { return each.drives(name); });
    QVERIFY2(driver != all.end(), "it has no driver");
    DrivenWindow& window = startWindow();
    if (driver->prepare)
        driver->prepare(window);
    window.remember();
    auto& action = window.find<QAction>(name);
    QVERIFY2(action.isEnabled(), "it is not enabled");
    const QString wrong = drive(window, *driver, [&action] { action.trigger(); });
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

QTEST_MAIN(CommandsTest)
#include "commands_test.moc"
