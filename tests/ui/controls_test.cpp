// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"
#include "ui/session/import_question.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/help_texts.h"
#include "ui/window/import_dialog.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>

#include <map>

using namespace tetra;

/// What every control owes to those who use keys or hear what others see: actions are reached by keys that mean one
/// thing only, controls have a name and an explanation, in every language.
class ControlsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void shortcutsAreUnique_data() { addLanguageRows(); }
    void shortcutsAreUnique();
    void everyActionIsReachedByKeys_data() { addLanguageRows(); }
    void everyActionIsReachedByKeys();
    void panelsDoNotTakeTheKeysOfTheMenus_data() { addLanguageRows(); }
    void panelsDoNotTakeTheKeysOfTheMenus();
    void everyControlHasANameAndAnExplanation_data() { addLanguageRows(); }
    void everyControlHasANameAndAnExplanation();
    void everyPanelSaysWhatItIs();
    void helpIsShownForAControl();

private:
    void open(const QString& language);
    std::vector<QMenu*> menus() const;

    QTemporaryDir folder_;
    QString model_;
    QString volume_;
    std::unique_ptr<Speaking> speaking_;
    std::unique_ptr<WindowFixture> window_;
};

namespace {

/// Parts of Qt's own compound widgets, which their owner speaks for.
bool isInner(const QWidget* widget)
{
    return widget->objectName().startsWith("qt_") || widget->focusProxy() != nullptr ||
           widget->inherits("QLabel") /* its text is both */ || widget->inherits("QScrollArea") ||
           widget->inherits("QComboBoxPrivateContainer") || widget->inherits("QComboBoxListView") ||
           widget->inherits("QTabBar") || widget->inherits("QAbstractScrollArea");
}

QString nameOf(QWidget* widget)
{
    const QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget);
    return accessible ? accessible->text(QAccessible::Name) : QString();
}

QString where(const QWidget* widget)
{
    return QString("%1 (%2)").arg(widget->objectName(), widget->metaObject()->className());
}

} // namespace

void ControlsTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("controls");
    QLocale::setDefault(QLocale::c());
    const auto host = hostOfThisBuild();
    const std::filesystem::path folder = folder_.path().toStdString();
    model_ = QString::fromStdString(buildSampleModel(*host, sampleDataset(10), folder).string());
    volume_ = QString::fromStdString(writeNrrd(sampleDataset(8), folder).string());
}

void ControlsTest::init()
{
    QSettings().clear();
}

void ControlsTest::cleanup()
{
    window_.reset();
    speaking_.reset();
}

/// With a model and a dataset, so that all panels are filled.
void ControlsTest::open(const QString& language)
{
    speaking_ = std::make_unique<Speaking>(language);
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(window_->workbench.session().model() && window_->settled());
    window_->window.open(volume_);
    QTRY_VERIFY(window_->workbench.dataset());
}

std::vector<QMenu*> ControlsTest::menus() const
{
    std::vector<QMenu*> found;
    for (QMenu* menu : window_->window.menuBar()->findChildren<QMenu*>()) {
        if (menu->title().isEmpty())
            continue; // Qt's own, for what the bar has no room for
        emit menu->aboutToShow();
        found.push_back(menu);
    }
    return found;
}

void ControlsTest::shortcutsAreUnique()
{
    QFETCH(QString, language);
    open(language);
    std::map<QString, QString> taken;
    const auto take = [&taken](const QKeySequence& keys, const QString& name) {
        const auto [found, isNew] = taken.emplace(keys.toString(), name);
        QVERIFY2(isNew || found->second == name,
                 qPrintable(keys.toString() + " is of " + found->second + " and of " + name));
    };
    for (const QAction* action : window_->window.findChildren<QAction*>())
        for (const QKeySequence& keys : action->shortcuts())
            if (!keys.isEmpty() && action->shortcutContext() != Qt::WidgetShortcut)
                take(keys, action->objectName());
    for (const QAction* action : window_->window.menuBar()->actions())
        take(QKeySequence::mnemonic(action->text()), action->text());
    QVERIFY(taken.size() > 25);
}

void ControlsTest::everyActionIsReachedByKeys()
{
    QFETCH(QString, language);
    open(language);
    int actions = 0;
    for (const QMenu* menu : menus()) {
        QVERIFY2(!QKeySequence::mnemonic(menu->title()).isEmpty(), qPrintable(menu->title()));
        std::map<QString, QString> taken;
        for (const QAction* action : menu->actions()) {
            if (action->isSeparator())
                continue;
            ++actions;
            const QString key = QKeySequence::mnemonic(action->text()).toString();
            QVERIFY2(!key.isEmpty(), qPrintable(menu->title() + ": " + action->text()));
            const auto [found, isNew] = taken.emplace(key, action->text());
            QVERIFY2(isNew, qPrintable(menu->title() + ": " + action->text() + " has the key of " + found->second));
        }
    }
    QVERIFY(actions > 40);
}

void ControlsTest::panelsDoNotTakeTheKeysOfTheMenus()
{
    QFETCH(QString, language);
    open(language);
    std::map<QString, QString> taken;
    for (const QAction* action : window_->window.menuBar()->actions())
        taken.emplace(QKeySequence::mnemonic(action->text()).toString(), action->text());
    for (const QDockWidget* dock : window_->window.findChildren<QDockWidget*>()) {
        std::map<QString, QString> ofPanel = taken;
        const auto take = [&](const QString& text) {
            const QString key = QKeySequence::mnemonic(text).toString();
            if (key.isEmpty())
                return;
            const auto [found, isNew] = ofPanel.emplace(key, text);
            QVERIFY2(isNew || found->second == text,
                     qPrintable(dock->objectName() + ": " + text + " has the key of " + found->second));
        };
        for (const QLabel* label : dock->findChildren<QLabel*>())
            if (label->buddy() != nullptr)
                take(label->text());
        for (const QAbstractButton* button : dock->findChildren<QAbstractButton*>())
            take(button->text());
    }
}

void ControlsTest::everyControlHasANameAndAnExplanation()
{
    QFETCH(QString, language);
    open(language);
    window_->find<QAction>("action.plugins").trigger();
    window_->workbench.openWithOptions(volume_);
    QTRY_VERIFY(window_->window.findChild<QWidget*>("importDialog"));
    QWidgetList roots{&window_->find<QWidget>("pluginWindow"), &window_->find<QWidget>("importDialog"),
                      &window_->find<QWidget>("palette")};
    for (QDockWidget* dock : window_->window.findChildren<QDockWidget*>())
        roots.append(dock->widget());
    QStringList without;
    int controls = 0;
    for (const QWidget* root : roots)
        for (QWidget* control : root->findChildren<QWidget*>()) {
            if (control->focusPolicy() == Qt::NoFocus || isInner(control))
                continue;
            ++controls;
            if (nameOf(control).isEmpty())
                without.append("no name: " + where(control));
            const bool isButton = qobject_cast<QAbstractButton*>(control) != nullptr && control->toolTip().isEmpty();
            if (HelpTexts::textFor(control).isEmpty() && !(isButton && !nameOf(control).isEmpty()))
                without.append("no explanation: " + where(control));
        }
    QVERIFY(controls > 60);
    QVERIFY2(without.isEmpty(), qPrintable(without.join("; ")));
}

void ControlsTest::everyPanelSaysWhatItIs()
{
    open("en");
    for (const QDockWidget* dock : window_->window.findChildren<QDockWidget*>()) {
        QVERIFY2(!dock->whatsThis().isEmpty(), qPrintable(dock->objectName()));
        QVERIFY(HelpTexts::textFor(dock->widget()).size() > 20);
    }
}

void ControlsTest::helpIsShownForAControl()
{
    open("en");
    auto& box = window_->find<QWidget>("view.azimuth");
    QHelpEvent asked(QEvent::WhatsThis, {1, 1}, box.mapToGlobal(QPoint(1, 1)));
    QCoreApplication::sendEvent(&box, &asked);
    auto& text = window_->find<QLabel>("help.text");
    QVERIFY(text.isVisible());
    QCOMPARE(text.text(), box.toolTip());
    QTest::keyClick(&window_->find<QWidget>("help"), Qt::Key_Escape);
    QTRY_VERIFY(window_->window.findChild<QWidget*>("help") == nullptr);
}

QTEST_MAIN(ControlsTest)
#include "controls_test.moc"
