// SPDX-License-Identifier: GPL-3.0-or-later
// How the window names an error in each of its languages is what the table of docs/user/accuracy.md says (C12).
#include "core/history/error_meaning.h"
#include "tests/ui/languages.h"
#include "ui/session/message_text.h"
#include "ui/session/shown_mesh_text.h"

#include <QFile>
#include <QLocale>
#include <QMap>
#include <QTest>

using namespace tetra;

namespace {

/// The cells of a language by those of the first column.
QMap<QString, QString> wordsOfPage(const QString& language)
{
    QFile file(TAN_SOURCE_DIR "/docs/user/accuracy.md");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString page = QString::fromUtf8(file.readAll());
    const QString rest = page.section("\nIn the languages of the window:\n", 1, 1).section("\n## ", 0, 0);
    QMap<QString, QString> words;
    qsizetype column = -1;
    for (const QString& line : rest.split('\n')) {
        QStringList cells;
        for (const QString& cell : line.split('|'))
            cells << cell.trimmed();
        if (cells.size() < 2 || cells[1].startsWith("---"))
            continue;
        if (column < 0)
            column = cells.indexOf(QLocale::languageToString(QLocale(language).language()));
        else
            words.insert(cells[1], cells.value(column));
    }
    return words;
}

ShownMesh meshOf(ErrorMeaning meaning)
{
    ShownMesh mesh;
    mesh.query.error = 1;
    mesh.errorMeaning = meaning;
    return mesh;
}

QString headOf(ErrorMeaning meaning)
{
    return translatedText(textFor(errorLabels, meaning));
}

QMap<QString, QString> wordsOfWindow()
{
    ShownMesh measured = meshOf(ErrorMeaning::InGrid), focused = meshOf(ErrorMeaning::InGrid);
    measured.errorInSpace = 7;
    focused.query.error = SpaceRamp{Sphere{{0, 0, 0}, 1}, 1, 4, 1};
    return {{"one error", errorText(meshOf(ErrorMeaning::Only))},
            {"in the grid", errorText(meshOf(ErrorMeaning::InGrid))},
            {"in the grid, measured in space", errorText(measured)},
            {"in space", errorText(meshOf(ErrorMeaning::InSpace))},
            {"in the grid, in a focus", errorText(focused)},
            {"below the number: in the grid", errorPlaceText(ErrorMeaning::InGrid, {})},
            {"below the number: measured in space", errorPlaceText(ErrorMeaning::InGrid, 7)},
            {"below the number: in space", errorPlaceText(ErrorMeaning::InSpace, {})},
            {"head of a column: one error", headOf(ErrorMeaning::Only)},
            {"head of a column: in the grid", headOf(ErrorMeaning::InGrid)},
            {"head of a column: in space", headOf(ErrorMeaning::InSpace)}};
}

} // namespace

class ErrorLanguagesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theWindowSaysWhatThePageSays_data() { addLanguageRows(); }
    void theWindowSaysWhatThePageSays()
    {
        QFETCH(QString, language);
        const Speaking speaking(language);
        const QMap<QString, QString> page = wordsOfPage(language);
        const QMap<QString, QString> window = wordsOfWindow();
        QCOMPARE(page.keys(), window.keys());
        for (auto word = window.begin(); word != window.end(); ++word) {
            QString said = word.value();
            QCOMPARE(said.replace(QChar::Nbsp, ' '), page[word.key()]);
        }
    }
};

QTEST_GUILESS_MAIN(ErrorLanguagesTest)
#include "error_languages_test.moc"
