// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"
#include "ui/session/message_text.h"

#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QUndoStack>
#include <QXmlStreamReader>

#include <algorithm>
#include <iterator>
#include <set>

using namespace tetra;

/// Every text has a translation into each language, those of our plugins too, and the window speaks them.
class TranslationTest : public QObject {
    Q_OBJECT
private slots:
    void theFilesAreThoseOfTheSources();
    void everyTextIsTranslated_data() { addTranslations(); }
    void everyTextIsTranslated();
    void everyTextOfAPluginIsTranslated_data() { addTranslations(); }
    void everyTextOfAPluginIsTranslated();
    void choicesAreCalledAsTheFormsShowThem_data() { addTranslations(); }
    void choicesAreCalledAsTheFormsShowThem();
    void quotationMarksAreThoseOfTheLanguage();
    void everyPlaceOfAMessageIsFilled_data() { addLanguageRows(); }
    void everyPlaceOfAMessageIsFilled();
    void germanHasASpaceBeforeAnEllipsis();
    void theWindowSpeaksGerman();
    void theWindowSpeaksItalian();
    void theUserChoosesTheLanguage();

private:
    static void addTranslations();
};

namespace {

QString tsFile(const QString& language)
{
    return QString(TAN_SOURCE_DIR "/translations/tan_%1.ts").arg(language);
}

struct TranslatedText {
    QString context;
    QString source;
    QString translation;
    bool unfinished = false;
};

std::vector<TranslatedText> messagesOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("cannot read %s", qPrintable(path));
    QXmlStreamReader xml(&file);
    std::vector<TranslatedText> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("source"))
            messages.push_back({context, xml.readElementText(), {}, false});
        else if (xml.name() == QLatin1String("translation")) {
            messages.back().unfinished = xml.attributes().hasAttribute("type");
            messages.back().translation = xml.readElementText();
        }
    }
    return messages;
}

std::set<QString> placeholders(const QString& text)
{
    std::set<QString> found;
    for (int number = 1; number <= 9; ++number)
        if (const QString place = "%" + QString::number(number); text.contains(place))
            found.insert(place);
    return found;
}

void collect(std::set<std::string>& texts, const std::vector<Parameter>& parameters)
{
    for (const Parameter& parameter : parameters) {
        texts.insert({parameter.label, parameter.explanation, parameter.unit});
        texts.insert(parameter.choices.begin(), parameter.choices.end());
    }
}

std::set<std::string> textsOf(PluginHost& host)
{
    std::set<std::string> texts;
    for (const auto& builder : host.builders())
        collect(texts, builder.plugin->parameters());
    for (const auto& reader : host.readers()) {
        collect(texts, reader.plugin->parameters());
        for (const std::string& filter : reader.plugin->nameFilters())
            texts.insert(filter);
    }
    for (const auto& writer : host.writers()) {
        collect(texts, writer.plugin->parameters());
        for (const FileFormat& format : writer.plugin->formats())
            texts.insert(format.name);
    }
    for (const auto& renderer : host.renderers())
        collect(texts, renderer.plugin->parameters({{0, 1}, {}}));
    texts.erase("");
    for (int type = 0; type <= static_cast<int>(SampleType::Float64); ++type) // names in any language
        texts.erase(std::string(sampleTypeName(static_cast<SampleType>(type))));
    for (const char* wider : {"int64", "uint64"}) // that are read as others
        texts.erase(wider);
    for (const char* axis : {"x", "y", "z"})
        texts.erase(axis);
    return texts;
}

} // namespace

/// Texts in the sources are English.
void TranslationTest::addTranslations()
{
    QTest::addColumn<QString>("language");
    for (const Language& language : languages())
        if (QString(language.code) != "en")
            QTest::newRow(language.code) << QString(language.code);
}

/// A message may have nine, in any order.
void TranslationTest::everyPlaceOfAMessageIsFilled()
{
    QFETCH(QString, language);
    const Speaking speaking(language);
    const Message nine = Message::of(
        "%9 %8 %7 %6 %5 %4 %3 %2 %1: 100 % of %1.",
        {Message(1), Message(2), Message(3), Message(4), Message(5), Message(6), Message(7), Message(8), Message(9)});
    QCOMPARE(translatedMessage(nine), QString("9 8 7 6 5 4 3 2 1: 100 % of 1."));
    QCOMPARE(QString::fromStdString(nine.text()), translatedMessage(nine));
    // A message within a message is translated, too.
    const Message inner = Message::say("%1 was cancelled.", std::string("x"));
    const Message outer = Message::of("a %4", {Message(1), Message(2), Message(3), inner});
    QCOMPARE(translatedMessage(outer), "a " + translatedMessage(inner));
    if (language == "en")
        QCOMPARE(translatedMessage(inner), QString("x was cancelled."));
    else
        QVERIFY(translatedMessage(inner) != QString("x was cancelled.") && translatedMessage(inner).contains('x'));
}

/// Of core, plugins and window: none is missing, and none has lost its source.
void TranslationTest::theFilesAreThoseOfTheSources()
{
    if (QStandardPaths::findExecutable("lupdate", {"/usr/lib/qt6/bin"}).isEmpty())
        QSKIP("skipped: no lupdate");
    QProcess update;
    update.start("python3", {TAN_SOURCE_DIR "/translations/update.py", "--check"});
    QVERIFY(update.waitForFinished(120'000));
    QVERIFY2(update.exitStatus() == QProcess::NormalExit && update.exitCode() == 0,
             (update.readAllStandardOutput() + update.readAllStandardError()).constData());
}

void TranslationTest::everyTextIsTranslated()
{
    QFETCH(QString, language);
    const auto messages = messagesOf(tsFile(language));
    QVERIFY(!messages.empty());
    for (const TranslatedText& message : messages) {
        QVERIFY2(!message.unfinished && !message.translation.isEmpty(), qPrintable(message.source));
        QVERIFY2(placeholders(message.source) == placeholders(message.translation), qPrintable(message.source));
    }
}

/// Those that it gives away, and its name and description.
void TranslationTest::everyTextOfAPluginIsTranslated()
{
    QFETCH(QString, language);
    std::set<QString> known;
    for (const TranslatedText& message : messagesOf(tsFile(language)))
        if (message.context == "tetra::Message")
            known.insert(message.source);
    const auto host = hostOfThisBuild();
    const auto texts = textsOf(*host);
    QVERIFY(!texts.empty());
    for (const std::string& text : texts)
        QVERIFY2(known.contains(QString::fromStdString(text)), ("not marked by Message::marked(): " + text).c_str());
    QVERIFY(!host->plugins().empty());
    for (const PluginStatus& plugin : host->plugins()) {
        const PluginMetadata& metadata = plugin.metadata;
        QVERIFY2(metadata.names.contains(language.toStdString()), metadata.id.c_str());
        QVERIFY2(metadata.descriptions.contains(language.toStdString()), metadata.id.c_str());
    }
}

/// What an explanation has in quotes is found in the form that it explains.
void TranslationTest::choicesAreCalledAsTheFormsShowThem()
{
    QFETCH(QString, language);
    const Speaking speaking(language);
    const auto host = hostOfThisBuild();
    std::vector<Parameter> parameters;
    for (const auto& builder : host->builders())
        std::ranges::move(builder.plugin->parameters(), std::back_inserter(parameters));
    for (const auto& renderer : host->renderers())
        std::ranges::move(renderer.plugin->parameters({{0, 1}, {}}), std::back_inserter(parameters));
    int named = 0;
    for (const Parameter& parameter : parameters) {
        std::vector<std::string> choices = parameter.choices;
        std::ranges::copy(parameter.words, std::back_inserter(choices));
        const QString explanation = translatedText(parameter.explanation);
        for (const std::string& choice : choices) {
            if (parameter.explanation.find("'" + choice + "'") == std::string::npos)
                continue;
            ++named;
            const QString shown = translatedText(choice);
            QVERIFY2(explanation.contains(language == "de" ? "„" + shown + "“" : "«" + shown + "»"),
                     qPrintable(shown + ": " + explanation));
        }
    }
    QVERIFY(named > 10);
}

/// Those of code stay: array['field'].
void TranslationTest::quotationMarksAreThoseOfTheLanguage()
{
    static const QRegularExpression english("(^|\\s|\\s\\()'"), notGerman("[«»”]|\""), notItalian("[„“”]|\"");
    for (const TranslatedText& message : messagesOf(tsFile("de"))) {
        QVERIFY2(!english.match(message.translation).hasMatch(), qPrintable(message.translation));
        QVERIFY2(!notGerman.match(message.translation).hasMatch(), qPrintable(message.translation));
        QVERIFY2(message.translation.count("„") == message.translation.count("“"), qPrintable(message.translation));
    }
    for (const TranslatedText& message : messagesOf(tsFile("it"))) {
        QVERIFY2(!english.match(message.translation).hasMatch(), qPrintable(message.translation));
        QVERIFY2(!notItalian.match(message.translation).hasMatch(), qPrintable(message.translation));
        QVERIFY2(message.translation.count("«") == message.translation.count("»"), qPrintable(message.translation));
    }
}

/// Where words are left out; without one it would say that letters are.
void TranslationTest::germanHasASpaceBeforeAnEllipsis()
{
    const auto messages = messagesOf(tsFile("de"));
    QVERIFY(!messages.empty());
    for (const TranslatedText& message : messages) {
        const qsizetype place = message.translation.indexOf(QChar(0x2026));
        QVERIFY2(place <= 0 || message.translation[place - 1].isSpace(), qPrintable(message.translation));
    }
}

void TranslationTest::theWindowSpeaksGerman()
{
    const Speaking german("de");
    const WindowFixture window;
    QCOMPARE(window.find<QMenu>("menu.file").title(), QString("&Datei"));
    QCOMPARE(window.find<QWidget>("dock.accuracy").windowTitle(), QString("Genauigkeit"));
    auto& undo = window.find<QAction>("action.undo");
    QCOMPARE(undo.text(), QString("&Rückgängig")); // a colon follows only if something does
    QUndoStack& stack = window.workbench.session().undoStack();
    stack.push(new QUndoCommand("Drehen"));
    QCOMPARE(undo.text(), QString("&Rückgängig: Drehen"));
    stack.undo();
    QCOMPARE(undo.text(), QString("&Rückgängig"));
    QCOMPARE(translatedText("Transfer function"), QString("Transferfunktion"));
    QCOMPARE(inUsersLanguage("Volume", {{"de", "Volumen"}, {"it", "Volume"}}), QString("Volumen"));
}

void TranslationTest::theWindowSpeaksItalian()
{
    const Speaking italian("it");
    const WindowFixture window;
    QCOMPARE(window.find<QMenu>("menu.edit").title(), QString("&Modifica"));
    QCOMPARE(window.find<QWidget>("dock.accuracy").windowTitle(), QString("Accuratezza"));
    QCOMPARE(translatedText("Transfer function"), QString("Funzione di trasferimento"));
}

void TranslationTest::theUserChoosesTheLanguage()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("translation");
    QSettings().clear();
    const WindowFixture window;
    QVERIFY(window.find<QAction>("action.language.system").isChecked());
    window.find<QAction>("action.language.it").trigger();
    QCOMPARE(textLocale().language(), QLocale::Italian);
    QCOMPARE(window.messages().size(), 1);
    const WindowFixture next;
    QVERIFY(next.find<QAction>("action.language.it").isChecked());
    next.find<QAction>("action.language.system").trigger();
    QCOMPARE(textLocale(), QLocale());
}

QTEST_MAIN(TranslationTest)
#include "translation_test.moc"
