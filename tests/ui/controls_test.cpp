// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/every_dialog.h"
#include "tests/ui/languages.h"
#include "ui/widgets/mnemonics.h"
#include "ui/window/help_texts.h"

#include <QAccessible>
#include <QDialog>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>

#include <algorithm>
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
    void dialogsAreEnteredAndLeftByKeys();
    void enterDoesWhatTheDialogIsFor_data();
    void enterDoesWhatTheDialogIsFor();
    void everyPanelSaysWhatItIs();
    void helpIsShownForAControl();

private:
    void open(const QString& language);
    std::vector<QMenu*> menus() const;

    QTemporaryDir folder_;
    QString model_;
    QString volume_;
    QString raw_;
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

/// What its controls lack, and how many there are.
int findWhatIsMissing(const QWidget& root, QStringList& without)
{
    int controls = 0;
    for (QWidget* control : root.findChildren<QWidget*>()) {
        if (control->focusPolicy() == Qt::NoFocus || isInner(control))
            continue;
        ++controls;
        if (nameOf(control).isEmpty())
            without.append("no name: " + where(control));
        const bool isButton = qobject_cast<QAbstractButton*>(control) != nullptr && control->toolTip().isEmpty();
        if (HelpTexts::textFor(control).isEmpty() && !(isButton && !nameOf(control).isEmpty()))
            without.append("no explanation: " + where(control));
        if ((control->focusPolicy() & Qt::TabFocus) == 0)
            without.append("not reached by Tab: " + where(control));
    }
    return controls;
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
    raw_ = folder_.filePath("bare.raw");
    QFile file(raw_);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(QByteArray(8 * 8 * 8, 'a')), 512);
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
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
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
    const auto docks = window_->window.findChildren<QDockWidget*>();
    QVERIFY(!docks.empty());
    for (const QDockWidget* dock : docks) {
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
    QStringList without;
    int controls = findWhatIsMissing(window_->find<QWidget>("empty"), without);
    window_->find<MessageBar>("messages")
        .ask(
            "A question", "An answer", [] {}, [] {});
    controls += findWhatIsMissing(window_->find<QWidget>("messages"), without);
    for (QDockWidget* dock : window_->window.findChildren<QDockWidget*>())
        controls += findWhatIsMissing(*dock->widget(), without);
    for (const OpenableDialog& dialog : everyDialog(volume_, raw_)) {
        dialog.open(*window_);
        auto& widget = window_->find<QWidget>(dialog.name);
        controls += findWhatIsMissing(widget, without);
        widget.close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY(controls > 150);
    without.removeDuplicates();
    QVERIFY2(without.isEmpty(), qPrintable(without.join("; ")));
}

/// A dialog takes the keys when it opens, Tab goes through it, and Escape leaves it.
void ControlsTest::dialogsAreEnteredAndLeftByKeys()
{
    open("en");
    const auto dialogs = everyDialog(volume_, raw_);
    QVERIFY(!dialogs.empty());
    for (const OpenableDialog& dialog : dialogs) {
        dialog.open(*window_);
        auto& widget = window_->find<QWidget>(dialog.name);
        QTRY_VERIFY2(widget.isVisible(), dialog.name);
        const QPointer<QWidget> opened(&widget);
        widget.activateWindow();
        QTRY_VERIFY2(widget.focusWidget() != nullptr, dialog.name);
        QTest::keyClick(widget.focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY2(!opened || !opened->isVisible(), dialog.name);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

void ControlsTest::enterDoesWhatTheDialogIsFor_data()
{
    QTest::addColumn<QString>("button");
    QTest::newRow("pictureOptions") << "picture.save";
    QTest::newRow("filmOptions") << "film.save";
    QTest::newRow("importDialog") << "import.read";
}

void ControlsTest::enterDoesWhatTheDialogIsFor()
{
    QFETCH(QString, button);
    open("en");
    const auto dialogs = everyDialog(volume_, raw_);
    const auto isMeant = [](const OpenableDialog& dialog) { return QString(dialog.name) == QTest::currentDataTag(); };
    const auto dialog = std::ranges::find_if(dialogs, isMeant);
    QVERIFY(dialog != dialogs.end());
    for (int time = 0; time < 2; ++time) {
        dialog->open(*window_);
        auto& opened = window_->find<QDialog>(dialog->name);
        QTRY_VERIFY(window_->find<QPushButton>(button).isDefault());
        for (auto* other : opened.findChildren<QPushButton*>()) // as the last one that was used
            if (other->isEnabled() && other->objectName() != button)
                other->setFocus();
        opened.close();
    }
}

void ControlsTest::everyPanelSaysWhatItIs()
{
    open("en");
    const auto docks = window_->window.findChildren<QDockWidget*>();
    QVERIFY(!docks.empty());
    for (const QDockWidget* dock : docks) {
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
