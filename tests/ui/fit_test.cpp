// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QRadioButton>
#include <QToolButton>

using namespace tetra;

/// No text is cut off on a small screen, in any language.
class FitTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void nothingIsCutOff_data() { addLanguageRows(); }
    void nothingIsCutOff();

private:
    QTemporaryDir folder_;
    QString model_;
    QString volume_;
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

/// What is wrong with a label or a button; empty if its text is seen whole.
QString cutOff(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (label->text().isEmpty())
            return {};
        const QSize hint = label->wordWrap() ? QSize(0, label->heightForWidth(label->width())) : label->sizeHint();
        return hint.width() > label->width() || hint.height() > label->height() ? plainSize(widget, label->text(), hint)
                                                                                : QString();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        const QSize text = button->fontMetrics().size(Qt::TextShowMnemonic, button->text());
        const bool hasMark = qobject_cast<const QCheckBox*>(button) || qobject_cast<const QRadioButton*>(button);
        const bool showsText = !button->text().isEmpty() &&
                               (qobject_cast<const QToolButton*>(button) == nullptr || button->icon().isNull());
        const int beside = button->icon().isNull() ? 0 : button->iconSize().width() + 4;
        const QSize needed = hasMark ? button->sizeHint() : QSize(text.width() + beside + 4, text.height());
        if (showsText && (needed.width() > button->width() || needed.height() > button->height()))
            return plainSize(widget, button->text(), needed);
    }
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

} // namespace

void FitTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("fit");
    const auto host = hostOfThisBuild();
    const std::filesystem::path folder = folder_.path().toStdString();
    model_ = QString::fromStdString(buildSampleModel(*host, sampleDataset(16), folder).string());
    volume_ = QString::fromStdString(writeNrrd(sampleDataset(8), folder).string());
}

void FitTest::nothingIsCutOff()
{
    QFETCH(QString, language);
    QSettings().clear();
    QLocale::setDefault(QLocale(language));
    const Speaking speaking(language);
    WindowFixture window;
    window.window.resize(smallScreen);
    window.window.show();
    QStringList found = cutOffIn(window.find<QWidget>("empty"));
    window.window.open(model_);
    QTRY_VERIFY(window.workbench.session().model() && window.settled());
    window.window.open(volume_);
    QTRY_VERIFY(window.workbench.dataset());
    QVERIFY2(window.window.width() <= smallScreen.width() && window.window.height() <= smallScreen.height(),
             "the window grew");
    int docks = 0;
    for (QDockWidget* dock : window.window.findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        QTRY_VERIFY2(dock->widget()->isVisible(), qPrintable(dock->objectName()));
        found += cutOffIn(*dock);
        ++docks;
    }
    QVERIFY(docks >= 9);
    for (const auto& [action, dialog] : {std::pair("plugins", "pluginWindow"), {"about", "aboutBox"}}) {
        window.find<QAction>(QString("action.") + action).trigger();
        auto& widget = window.find<QWidget>(dialog);
        QTRY_VERIFY(widget.isVisible());
        found += cutOffIn(widget);
        widget.close();
    }
    window.workbench.openWithOptions(volume_);
    QTRY_VERIFY(window.window.findChild<QWidget*>("importDialog"));
    QCoreApplication::processEvents();
    found += cutOffIn(window.find<QWidget>("importDialog"));
    QVERIFY2(found.isEmpty(), qPrintable(found.join("\n")));
}

QTEST_MAIN(FitTest)
#include "fit_test.moc"
