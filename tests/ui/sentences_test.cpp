// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_writer.h"
#include "core/base/system_error.h"
#include "core/data/cells/clean_cells.h"
#include "plugins/host/dataset_opening.h"
#include "tests/ui/languages.h"
#include "tests/ui/sample_files.h"
#include "ui/session/message_text.h"

#include <tan/data.h>
#include <tan/model.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QDirIterator>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <fstream>

using namespace tetra;

/// Sentences of core and plugins come to the user in his language: those that are known stand in the sources, and
/// those that ordinary mistakes bring about are known.
class SentencesTest : public QObject {
    Q_OBJECT
private slots:
    void everyKnownSentenceIsOfTheSources();
    void whatIsMadeOfIt_data();
    void whatIsMadeOfIt();
    void messagesAreTranslatedByTheirPlaces();
    void ordinaryMistakes_data();
    void ordinaryMistakes();
    void whatReadersRemark_data() { addLanguageRows(); }
    void whatReadersRemark();
};

namespace {

/// All that stands in quotes in the sources, with literals that follow each other joined, each in quotes.
QString literalsOfTheSources()
{
    QString all;
    for (const char* folder : {"core", "plugins", "ui"}) {
        QDirIterator files(QString(TAN_SOURCE_DIR "/") + folder, {"*.cpp", "*.h"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (file.fileName().endsWith("known_sentences.cpp") || !file.open(QIODevice::ReadOnly))
                continue;
            static const QRegularExpression joint("\"\\s*\\n\\s*\"");
            static const QRegularExpression literal("\"(?:[^\"\\\\\\n]|\\\\.)*\"");
            const QString text = QString::fromUtf8(file.readAll()).remove(joint);
            for (auto found = literal.globalMatch(text); found.hasNext();)
                all += found.next().captured() + "\n";
        }
    }
    return all.replace("\\\"", "\x01");
}

/// Whole in one literal, or the end of one and the beginning of another.
bool isMadeOf(const QString& literals, const QString& part)
{
    if (literals.contains(part))
        return true;
    for (qsizetype cut = 1; cut < part.size(); ++cut)
        if (literals.contains(part.left(cut) + '"') && literals.contains('"' + part.mid(cut)))
            return true;
    return false;
}

template <class Value> Message errorOf(const Result<Value>& result)
{
    return result ? Message() : result.error().message;
}

/// A word that only English has, outside of quotes.
QString englishWord(const QString& text)
{
    static const QRegularExpression quoted("„[^“]*“|«[^»]*»");
    static const QRegularExpression english("\\b(the|is|and|of|it|its|not|with|from|was|were|cannot)\\b");
    return english.match(QString(text).remove(quoted)).captured();
}

} // namespace

void SentencesTest::everyKnownSentenceIsOfTheSources()
{
    QString literals = literalsOfTheSources();
    for (int error = 1; error < 200; ++error)
        literals += QString("\"%1\"\n").arg(QString::fromStdString(systemErrorText(error)));
    QVERIFY(literals.size() > 100'000);
    static const QRegularExpression placeholder("%[1-9]|^1 ");
    static const QRegularExpression joints("^[ '.:,\x01]+|[ '.:,\x01]+$"); // stand alone now and then
    for (const char* sentence : knownSentences())
        for (QString part : QString::fromUtf8(sentence).replace('"', '\x01').split(placeholder))
            QVERIFY2(isMadeOf(literals, part.remove(joints)), sentence);
}

void SentencesTest::whatIsMadeOfIt_data()
{
    QTest::addColumn<QString>("english");
    QTest::addColumn<QString>("german");
    QTest::newRow("a sentence in a sentence")
        << "Cannot write '/a/b.png': No space left on device. Free some space or choose another disk."
        << "„/a/b.png“ kann nicht geschrieben werden: Kein Platz mehr auf dem Datenträger. Schaffen Sie Platz, oder "
           "wählen Sie einen anderen Datenträger.";
    QTest::newRow("a lack of open files")
        << "Cannot read '/a/b.tan': Too many open files. Close other programs, or raise the limit (ulimit)."
        << "„/a/b.tan“ kann nicht gelesen werden: Zu viele offene Dateien. Schließen Sie andere Programme, oder heben "
           "Sie die Begrenzung an (ulimit).";
    QTest::newRow("names stay, whatever they say") << "'Error' is a folder. Choose a file inside it."
                                                   << "„Error“ ist ein Ordner. Wählen Sie eine Datei darin.";
    QTest::newRow("a name that looks like a placeholder")
        << "Cannot open '%2': too many files are open. Close some of them."
        << "„%2“ kann nicht geöffnet werden: Zu viele Dateien sind offen. Schließen Sie einige.";
    QTest::newRow("a sentence behind a sentence, and a second line")
        << "'x.abc' has an unknown format. No reader is installed.\nNobody knows this."
        << "„x.abc“ hat ein unbekanntes Format. Es ist kein Leser installiert.\nNobody knows this.";
    QTest::newRow("a number at the beginning")
        << "12924 cells had inverted orientation and were corrected."
        << "12924 Zellen hatten die umgekehrte Orientierung und wurden korrigiert.";
    QTest::newRow("a text of a plugin")
        << "A tetrahedral mesh needs a cell: two points or more along each axis."
        << "Ein Tetraedernetz braucht eine Zelle: zwei Punkte oder mehr entlang jeder Achse.";
    QTest::newRow("unknown") << "Nobody knows this."
                             << "Nobody knows this.";
    QTest::newRow("nothing") << ""
                             << "";
}

void SentencesTest::whatIsMadeOfIt()
{
    QFETCH(QString, english);
    QFETCH(QString, german);
    QCOMPARE(translatedSentence(english.toStdString()), english);
    const Speaking speaking("de");
    QCOMPARE(translatedSentence(english.toStdString()), german);
}

void SentencesTest::messagesAreTranslatedByTheirPlaces()
{
    // Whatever names say, and whatever order a language puts things in; what stands in a place may be a sentence
    // itself.
    const Message named = Message::say("'%1' is a folder. Choose a file inside it.", "Permission denied");
    const Message nested =
        Message::say("Cannot read '%1': %2", "a: b", Message::say("it is a folder. Name a file in it."));
    const Message system = Message::say("'%1' cannot be read: %2.", "/a", systemErrorText(EACCES));
    const Message unknown = Message::say("Nobody knows %1.", 3);
    for (const Message& message : {named, nested, system, unknown})
        QCOMPARE(translatedMessage(message), QString::fromStdString(message.text()));
    const Speaking speaking("de");
    QCOMPARE(translatedMessage(named), QString("„Permission denied“ ist ein Ordner. Wählen Sie eine Datei darin."));
    QVERIFY(translatedMessage(nested).startsWith("„a: b“ kann nicht gelesen werden: "));
    QVERIFY(translatedMessage(system).contains("„/a“"));
    for (const Message& message : {nested, system})
        QVERIFY2(englishWord(translatedMessage(message)).isEmpty(), qPrintable(translatedMessage(message)));
    QCOMPARE(translatedMessage(unknown), QString("Nobody knows 3."));
}

void SentencesTest::ordinaryMistakes_data()
{
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    const auto host = hostOfThisBuild();
    const auto made = [&](const char* name, const std::string& content) {
        std::ofstream(path / name) << content;
        return path / name;
    };
    const std::filesystem::path model = buildSampleModel(*host, sampleDataset(4), path);
    std::string bytes;
    {
        std::ifstream file(model, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    std::string broken = bytes;
    broken[20] = static_cast<char>(broken[20] + 1);

    QTest::addColumn<Message>("message");
    const auto row = [](const char* name, const Message& message) { QTest::newRow(name) << message; };
    row("no such dataset", errorOf(openDataset(*host, path / "missing.nrrd")));
    row("a folder", errorOf(openDataset(*host, path)));
    row("an empty file", errorOf(openDataset(*host, made("empty.nrrd", ""))));
    row("an unknown format", errorOf(openDataset(*host, made("letter.odt", "Dear Sir"))));
    row("no such model", errorOf(Model::open(path / "missing.tan")));
    row("a model that is none", errorOf(Model::open(made("letter.tan", std::string(1000, 'x')))));
    row("an empty model", errorOf(Model::open(made("empty.tan", ""))));
    row("a model that is cut short", errorOf(Model::open(made("short.tan", bytes.substr(0, bytes.size() / 2)))));
    row("a model that is damaged", errorOf(Model::open(made("broken.tan", broken))));
    row("no such folder", errorOf(FileWriter::create(path / "no/such/file")));
    row("a folder as a file", errorOf(FileWriter::create(path)));
    row("a weight", errorOf(parseWeighting("point:1,2")));
    row("another weight", errorOf(parseWeighting("nonsense")));
    row("a clip plane", errorOf(parseClipPlanes("1,2")));
    row("no camera", errorOf(cameraFromText("[]", Eigen::AlignedBox3d())));
    row("a camera's number", errorOf(cameraFromText("{\"azimuth\": \"north\"}", Eigen::AlignedBox3d())));
    row("no transfer function", errorOf(transferFunctionFromText("")));
}

void SentencesTest::ordinaryMistakes()
{
    QFETCH(Message, message);
    QVERIFY(!message.text().empty());
    QVERIFY(!englishWord(QString::fromStdString(message.text())).isEmpty());
    for (const char* language : {"de", "it"}) {
        const Speaking speaking(language);
        const QString told = translatedMessage(message);
        QVERIFY2(englishWord(told).isEmpty(), qPrintable(told));
    }
}

void SentencesTest::whatReadersRemark()
{
    QFETCH(QString, language);
    const Speaking speaking(language);
    for (const std::uint64_t count : {1, 3}) {
        Repairs repairs{count, count, count, count, count, count, 0,     count,
                        count, count, count, count, count, count, count, true};
        for (const std::uint64_t cells : {count, count + 1}) { // all turned over, and some
            repairs.cells = cells;
            const auto remarks = repairRemarks(repairs);
            QCOMPARE(remarks.size(), std::size_t(15));
            for (const std::string& remark : remarks) {
                const QString told = translatedSentence(remark);
                QVERIFY2((told == QString::fromStdString(remark)) == (language == "en"), qPrintable(told));
                QVERIFY2(language == "en" || englishWord(told).isEmpty(), qPrintable(told));
            }
        }
    }
}

QTEST_MAIN(SentencesTest)
#include "sentences_test.moc"
