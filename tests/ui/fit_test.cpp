// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/every_dialog.h"
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/build_panel.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMenuBar>
#include <QRadioButton>
#include <QStatusBar>
#include <QStyleOptionComboBox>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

using namespace tetra;

/// No text is cut off on a small screen, in any language, with the usual and with larger letters.
class FitTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theWindowFits_data();
    void theWindowFits();
    void everyDockFits_data() { theWindowFits_data(); }
    void everyDockFits();
    void everyDialogFits_data() { theWindowFits_data(); }
    void everyDialogFits();

private:
    void open();

    QTemporaryDir folder_;
    QString model_;
    QString volume_;
    QString raw_;
    QFont usualFont_;
    std::unique_ptr<Speaking> speaking_;
    std::unique_ptr<WindowFixture> window_;
};

namespace {

constexpr QSize smallScreen(1366, 768);

QString plainSize(const QWidget& widget, const QString& text, QSize needed)
{
    return QString("%1 '%2' needs %3 x %4, has %5 x %6")
        .arg(widget.objectName(), text)
        .arg(needed.width())
        .arg(needed.height())
        .arg(widget.width())
        .arg(widget.height());
}

QString cutOffLabel(const QLabel& label)
{
    if (label.text().isEmpty())
        return {};
    const QSize hint = label.wordWrap() ? QSize(0, label.heightForWidth(label.width())) : label.sizeHint();
    return hint.width() > label.width() || hint.height() > label.height() ? plainSize(label, label.text(), hint)
                                                                          : QString();
}

QString cutOffButton(const QAbstractButton& button)
{
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    const bool hasIcon = !button.icon().isNull();
    if (button.text().isEmpty() || (tool != nullptr && hasIcon && tool->toolButtonStyle() == Qt::ToolButtonIconOnly))
        return {};
    const QSize text = button.fontMetrics().size(Qt::TextShowMnemonic, button.text());
    const QSize icon = hasIcon ? button.iconSize() : QSize(0, 0);
    QSize needed(text.width() + 4, text.height());
    if (qobject_cast<const QCheckBox*>(&button) != nullptr || qobject_cast<const QRadioButton*>(&button) != nullptr)
        needed = button.sizeHint();
    else if (tool != nullptr && hasIcon && tool->toolButtonStyle() == Qt::ToolButtonTextUnderIcon)
        needed = QSize(std::max(text.width(), icon.width()) + 4, icon.height() + 4 + text.height());
    else if (hasIcon)
        needed += QSize(icon.width() + 4, 0);
    const bool isWhole = needed.width() <= button.width() && needed.height() <= button.height();
    return isWhole ? QString() : plainSize(button, button.text(), needed);
}

/// Of the entry that is chosen; a list that opens is as wide as it has to be.
QString cutOffChoice(const QComboBox& box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const int room =
        box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
    const QSize text = box.fontMetrics().size(0, box.currentText());
    return text.width() > room || text.height() > box.height() ? plainSize(box, box.currentText(), text) : QString();
}

/// Numbers only: what is typed may be as long as it likes.
QString cutOffNumber(const QLineEdit& line)
{
    if (qobject_cast<const QAbstractSpinBox*>(line.parentWidget()) == nullptr)
        return {};
    const QSize text = line.fontMetrics().size(0, line.displayText());
    return text.width() > line.width() ? plainSize(*line.parentWidget(), line.displayText(), text) : QString();
}

QString cutOffEntry(const QListView& list)
{
    const int needed = list.sizeHintForColumn(0);
    return needed > list.viewport()->width() ? plainSize(list, "an entry", {needed, 0}) : QString();
}

/// What is wrong with a widget; empty if its text is seen whole.
QString cutOff(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return cutOffLabel(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return cutOffButton(*button);
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
        return cutOffChoice(*choice);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        return cutOffNumber(*line);
    if (const auto* list = qobject_cast<const QListView*>(&widget))
        return cutOffEntry(*list);
    return {};
}

QStringList cutOffIn(const QWidget& root)
{
    QStringList found;
    for (const QWidget* widget : root.findChildren<QWidget*>())
        if (widget->isVisible())
            if (const QString text = cutOff(*widget); !text.isEmpty())
                found.append(root.objectName() + ": " + text);
    return found;
}

/// Once it is at rest: what a worker found changes a form, whose layouts follow one after the other.
QStringList cutOffAtRest(const QWidget& root)
{
    constexpr int aMoment = 2000; // milliseconds
    (void)QTest::qWaitFor([&] { return cutOffIn(root).isEmpty(); }, aMoment);
    return cutOffIn(root);
}

/// Of the window, and what its parts need at least.
QString sizesOf(const QMainWindow& window)
{
    const auto text = [](const QSize& size) { return QString("%1 x %2").arg(size.width()).arg(size.height()); };
    QStringList parts{text(window.size())};
    QList<const QWidget*> widgets{window.centralWidget(), window.statusBar(), window.menuBar()};
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        widgets.append(dock);
    for (const QToolBar* bar : window.findChildren<QToolBar*>())
        widgets.append(bar);
    for (const QWidget* widget : widgets)
        parts.append(widget->objectName() + " " + text(widget->minimumSizeHint()) +
                     (widget->isVisible() ? "" : " (hidden)"));
    return parts.join(", ");
}

} // namespace

void FitTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("fit");
    usualFont_ = QApplication::font();
    const auto host = hostOfThisBuild();
    const std::filesystem::path folder = folder_.path().toStdString();
    model_ = QString::fromStdString(buildSampleModel(*host, sampleDataset(16), folder).string());
    volume_ = QString::fromStdString(writeNrrd(sampleDataset(8), folder).string());
    raw_ = folder_.filePath("bare_8x8x8_uint8.raw");
    QFile file(raw_);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(QByteArray(8 * 8 * 8, 'a')), 512);
}

void FitTest::theWindowFits_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<double>("letters");
    for (const Language& language : languages())
        for (const double letters : {1.0, 1.25})
            QTest::addRow("%s, %g", language.code, letters) << QString(language.code) << letters;
}

void FitTest::init()
{
    QFETCH(QString, language);
    QFETCH(double, letters);
    QSettings().clear();
    QLocale::setDefault(QLocale(language));
    QFont font = usualFont_;
    font.setPointSizeF(letters * font.pointSizeF());
    QApplication::setFont(font);
    speaking_ = std::make_unique<Speaking>(language);
    window_ = std::make_unique<WindowFixture>();
    window_->window.resize(smallScreen);
    window_->window.show();
}

void FitTest::cleanup()
{
    window_.reset();
    speaking_.reset();
    QApplication::setFont(usualFont_);
}

void FitTest::open()
{
    window_->window.open(model_);
    QTRY_VERIFY(window_->workbench.session().model() && window_->settled());
    window_->window.open(volume_);
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QTRY_VERIFY(!window_->find<BuildPanel>("build").looking()); // what a build takes is told by a worker
}

void FitTest::theWindowFits()
{
    QCoreApplication::processEvents();
    QStringList found = cutOffAtRest(window_->find<QWidget>("empty"));
    auto& messages = window_->find<MessageBar>("messages");
    messages.add("A message that is so long that it has to go on in a second line: it names a file, says what is wrong "
                 "with it and what can be done about that.");
    messages.ask(
        "A question", "An answer", [] {}, [] {});
    QCoreApplication::processEvents();
    found += cutOffAtRest(messages);
    messages.clear();
    open();
    QCoreApplication::processEvents();
    found += cutOffAtRest(window_->window);
    QVERIFY2(window_->window.width() <= smallScreen.width() && window_->window.height() <= smallScreen.height(),
             qPrintable("the window grew to " + sizesOf(window_->window)));
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void FitTest::everyDockFits()
{
    open();
    QStringList found;
    int docks = 0;
    for (QDockWidget* dock : window_->window.findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        QTRY_VERIFY2(dock->widget()->isVisible(), qPrintable(dock->objectName()));
        found += cutOffAtRest(*dock);
        ++docks;
    }
    QVERIFY(docks >= 9);
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

void FitTest::everyDialogFits()
{
    open();
    QStringList found;
    for (const OpenableDialog& dialog : everyDialog(volume_, raw_)) {
        dialog.open(*window_);
        auto& widget = window_->find<QWidget>(dialog.name);
        QTRY_VERIFY2(widget.isVisible(), dialog.name);
        found += cutOffAtRest(widget);
        if (widget.width() > smallScreen.width() || widget.height() > smallScreen.height())
            found.append(QString("%1 has %2 x %3").arg(dialog.name).arg(widget.width()).arg(widget.height()));
        widget.close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

QTEST_MAIN(FitTest)
#include "fit_test.moc"
