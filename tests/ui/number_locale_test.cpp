// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/session_document.h"
#include "tests/ui/window_fixture.h"

#include <tan/render.h>

#include <QAbstractSpinBox>
#include <QFile>
#include <QLineEdit>

using namespace tetra;

/// Numbers are typed as the user's country writes them; files are the same everywhere.
class NumberLocaleTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void numbersAreTypedAndSaved_data();
    void numbersAreTypedAndSaved();

private:
    static void type(const WindowFixture& window, const QString& box, const QString& text);
};

void NumberLocaleTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("numberLocale");
}

void NumberLocaleTest::type(const WindowFixture& window, const QString& box, const QString& text)
{
    auto& spin = window.find<QAbstractSpinBox>(box);
    spin.selectAll();
    QTest::keyClicks(&spin, text);
    QTest::keyClick(&spin, Qt::Key_Return);
}

void NumberLocaleTest::numbersAreTypedAndSaved_data()
{
    QTest::addColumn<QString>("locale");
    QTest::addColumn<QString>("text");
    QTest::newRow("de_DE") << "de_DE"
                           << "1,5";
    QTest::newRow("it_IT") << "it_IT"
                           << "1,5";
    QTest::newRow("en_US") << "en_US"
                           << "1.5";
}

void NumberLocaleTest::numbersAreTypedAndSaved()
{
    QFETCH(QString, locale);
    QFETCH(QString, text);
    QSettings().clear();
    QLocale::setDefault(QLocale(locale));
    WindowFixture window;
    window.window.show();
    const auto path = buildSampleModel(*window.host, sampleDataset(12), window.folderPath());
    window.window.open(QString::fromStdString(path.string()));
    QTRY_VERIFY(window.workbench.session().model() && window.settled());

    const Session& session = window.workbench.session();
    type(window, "accuracy.box", text);
    QCOMPARE(session.view().query.error, 1.5);
    type(window, "isovalue.0.value.box", text);
    QCOMPARE(session.view().isovalues.front().value, 1.5);
    type(window, "view.azimuth", text);
    QCOMPARE(window.viewport().camera().azimuth, 1.5);
    type(window, "view.target.x", text);
    QCOMPARE(window.viewport().camera().target.x(), 1.5);
    QVERIFY(window.find<QAbstractSpinBox>("view.target.x").text().startsWith(text));

    const auto document = window.workbench.opening().sessions().document();
    QVERIFY(document);
    const std::string saved = sessionToText(*document, window.folderPath());
    QVERIFY2(saved.find("1.5") != std::string::npos && saved.find("1,5") == std::string::npos, saved.c_str());
    const std::string camera = cameraToText(window.viewport().camera());
    QVERIFY(camera.find("1.5") != std::string::npos && camera.find("1,5") == std::string::npos);
    const std::filesystem::path table = std::filesystem::path(window.folderPath()) / "levels.csv";
    window.workbench.exporting().saveStatistics(table);
    QTRY_VERIFY(std::filesystem::exists(table));
    QFile file(table);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("\n0.5,"));
}

QTEST_MAIN(NumberLocaleTest)
#include "number_locale_test.moc"
