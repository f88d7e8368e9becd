// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_writer.h"
#include "core/base/system_error.h"
#include "core/data/cells/clean_cells.h"
#include "core/picture/session_document.h"
#include "plugins/host/colour_text.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/model_building.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parameter_text.h"
#include "plugins/host/plugin_file.h"
#include "tests/ui/languages.h"
#include "tests/ui/sample_files.h"
#include "ui/session/language.h"
#include "ui/session/message_text.h"

#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <fstream>

#include <sys/resource.h>

using namespace tetra;

/// Sentences of core and of plugins come to the user in his language, whole, with their arguments in place.
class SentencesTest : public QObject {
    Q_OBJECT
private slots:
    void messagesAreTranslatedByTheirPlaces_data();
    void messagesAreTranslatedByTheirPlaces();
    void commonMistakes();
    void whatReadersRemark_data() { addLanguageRows(); }
    void whatReadersRemark();
    void aPluginBringsItsTranslations();
};

namespace {

namespace fs = std::filesystem;

template <class Value> Message errorOf(const Result<Value>& result)
{
    return result ? Message() : result.error().message;
}

/// A word that only English has, outside of quotes.
QString englishWord(const QString& text)
{
    static const QRegularExpression quoted("„[^“]*“|«[^»]*»|'[^']*'|\"[^\"]*\"");
    static const QRegularExpression english(
        "\\b(the|is|are|and|of|it|its|with|from|was|were|cannot|has|have|which)\\b");
    return english.match(QString(text).remove(quoted)).captured();
}

/// What of a message stays English in the language that is spoken: a sentence without a translation, or a sentence that
/// was passed for a name. Nothing if all is well.
QString untranslated(const Message& message)
{
    const QString sentence = QString::fromStdString(message.sentence());
    if (sentence.isEmpty())
        return englishWord(QString::fromStdString(message.text()));
    static const QRegularExpression places("%[1-9]|[^\\p{L}]");
    constexpr int shortWord = 2; // "in", which German and Italian have as well
    if (QString(sentence).remove(places).size() > shortWord && translatedText(message.sentence()) == sentence)
        return sentence;
    for (const Message& argument : message.arguments())
        if (const QString left = untranslated(argument); !left.isEmpty())
            return left;
    return {};
}

struct Mistake {
    QString name;
    Message message;
};

/// The mistakes that users make, and what they are told.
class Mistakes {
public:
    explicit Mistakes(const fs::path& folder) : folder_(folder), host_(hostOfThisBuild()) {}

    std::vector<Mistake> all()
    {
        files();
        tables();
        meshes();
        options();
        models();
        writing();
        building();
        texts();
        plugins();
        return std::move(all_);
    }

private:
    fs::path made(const char* name, const std::string& content) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    void add(const char* name, const Message& message) { all_.push_back({name, message}); }
    /// That opening such a file is refused.
    void refused(const char* name, const char* file, const std::string& content, const ParameterValues& values = {})
    {
        add(name, errorOf(openDataset(*host_, made(file, content), {.reader = {}, .values = values, .part = {}})));
    }

    static std::string nrrd(const std::string& fields, const std::string& samples = std::string(8, '\1'))
    {
        return "NRRD0004\ndimension: 3\n" + fields + "\n" + samples;
    }

    void files()
    {
        const std::string raw = "type: uint8\nsizes: 2 2 2\nencoding: raw\n";
        add("no such file", errorOf(openDataset(*host_, folder_ / "missing.nrrd")));
        add("a folder", errorOf(openDataset(*host_, folder_)));
        refused("an empty file", "empty.nrrd", "");
        refused("an unknown format", "letter.odt", "Dear Sir");
        refused("a picture", "photo.png", "\x89PNG and so on");
        refused("a surface", "part.stl", "solid part");
        refused("an archive", "data.zip", "PK\3\4 and so on");
        refused("a damaged .gz", "data.nrrd.gz", "\x1f\x8b\x08 and so on");
        refused("NRRD, cut short", "short.nrrd", nrrd(raw, "1234"));
        refused("NRRD, too long", "long.nrrd", nrrd(raw, "1234567890"));
        refused("NRRD, unknown type", "type.nrrd", nrrd("type: complex\nsizes: 2 2 2\nencoding: raw\n"));
        refused("NRRD, 64 bits", "wide.nrrd", nrrd("type: int64\nsizes: 2 2 2\nencoding: raw\nendian: little\n"));
        refused("NRRD, no sizes", "sizes.nrrd", nrrd("type: uint8\nencoding: raw\n"));
        refused("NRRD, flat", "flat.nrrd", nrrd("type: uint8\nsizes: 2 4 1\nencoding: raw\n"));
        refused("NRRD, unknown encoding", "bzip.nrrd", nrrd("type: uint8\nsizes: 2 2 2\nencoding: bzip2\n"));
        refused("NRRD, no data file", "detached.nhdr", nrrd(raw + "data file: missing.raw\n"));
        refused("NRRD, damaged header", "header.nrrd", nrrd(raw + "no such field\n"));
        refused("NRRD, NaN", "nan.nrrd", nrrd("type: float\nsizes: 2 2 2\nencoding: ascii\n", "1 2 3 nan 5 6 7 8"));
        refused("raw, nothing said", "data.raw", std::string(60, '\1'));
        refused("raw, size not understood", "size.raw", std::string(60, '\1'), {{"size", std::string("3x4")}});
        refused("raw, wrong size", "wrong.raw", std::string(60, '\1'), {{"size", std::string("3x4x6")}});
        refused("raw, unknown type", "float.raw", std::string(60, '\1'),
                {{"size", std::string("3x4x5")}, {"type", std::string("real")}});
    }

    void tables()
    {
        refused("table, a missing number", "gap.csv", "x,y,z,v\n1,2,3,\n");
        refused("table, decimal comma", "comma.csv", "x;y;z;v\n1,5;2;3;4\n");
        refused("table, no number", "word.csv", "x,y,z,v\n1,2,north,4\n");
        refused("table, too few columns", "few.csv", "x,y,z\n1,2,3\n");
        refused("table, columns differ", "columns.csv", "x,y,z,v\n1,2,3,4\n1,2,3\n");
        refused("table, names alone", "names.csv", "x,y,z,v\n");
        refused("table, UTF-16", "utf16.csv", "\xff\xfex\0,\0y\0");
        refused("table, unknown column", "depth.csv", "x,y,z,v\n1,2,3,4\n",
                {{"positions", std::string("lon,lat,depth")}});
    }

    void meshes()
    {
        refused("UCD, damaged", "mesh.inp", "8 1 1 0 0\n1 0 0\n");
        refused("UCD, cut short", "cut.inp", "4 1 1 0 0\n1 0 0 0\n2 1 0 0\n");
        refused("PLOT3D, a text", "grid.p3d", "This is a grid.");
        refused("VTK XML, cut short", "cut.vtu",
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n<Unstr");
        refused("VTK, damaged", "damaged.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET NONSENSE\n");
        refused("EnSight, damaged", "run.case", "FORM\n");
        refused("MetaImage, no data file", "volume.mhd",
                "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
                "ElementDataFile = missing.raw\n");
    }

    void options()
    {
        const fs::path volume = writeNrrd(sampleDataset(4), folder_);
        const auto part = [&](const DatasetPart& wanted) {
            return errorOf(openDataset(*host_, volume, {.reader = {}, .values = {}, .part = wanted}));
        };
        const Eigen::AlignedBox3d outside(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, 9, 9));
        add("a region outside", part({.region = outside}));
        add("a stride too large", part({.region = {}, .stride = {9, 9, 9}}));
        add("an unknown parameter",
            errorOf(openDataset(*host_, volume, {.reader = {}, .values = {{"nonsense", 1.0}}, .part = {}})));
        add("an unknown reader", errorOf(chooseReader(*host_, volume, std::string("nobody"))));
        Parameter percent{.id = "error", .label = {}, .explanation = {}, .unit = "%", .defaultValue = 1.0};
        percent.maximum = 100;
        add("a number out of bounds", errorOf(parseParameter(percent, "101")));
        add("no isovalue", errorOf(parseIsovalue("red")));
        add("no colour", errorOf(parseColour("reddish")));
    }

    void models()
    {
        const fs::path model = buildSampleModel(*host_, sampleDataset(4), folder_);
        std::ifstream file(model, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        std::string broken = bytes;
        broken[20] = static_cast<char>(broken[20] + 1);
        add("no such model", errorOf(Model::open(folder_ / "missing.tan")));
        add("a folder as a model", errorOf(Model::open(folder_)));
        add("no model", errorOf(Model::open(made("letter.tan", std::string(1000, 'x')))));
        add("an empty model", errorOf(Model::open(made("empty.tan", ""))));
        add("a model that is cut short", errorOf(Model::open(made("short.tan", bytes.substr(0, bytes.size() / 2)))));
        add("a damaged model", errorOf(Model::open(made("broken.tan", broken))));
        add("a model in place of a dataset", errorOf(openDataset(*host_, model)));
        const auto open = Model::open(model);
        if (!open)
            return;
        MeshQuery query;
        query.budget = 0;
        add("a budget of nothing", errorOf(checkQuery(**open, query)));
        query = {};
        query.window = Window{.box = {{1, 0, 0}, {0, 1, 1}}};
        add("a window the wrong way round", errorOf(checkQuery(**open, query)));
        query = {};
        query.values = {{2, 1}};
        add("a range the wrong way round", errorOf(checkQuery(**open, query)));
        add("a budget too small", errorOf(meshSizeWithin(**open, {0, 100}, 1)));
    }

    void writing()
    {
        add("no such folder", errorOf(FileWriter::create(folder_ / "no/such/file")));
        add("a folder as a file", errorOf(FileWriter::create(folder_)));
        add("a name too long", errorOf(FileWriter::create(folder_ / std::string(300, 'n'))));
        add("no space left", fullDisk());
        add("a mesh in an unknown format", errorOf(checkWritable(*host_, WrittenContent::Mesh, "mesh.doc")));
        add("a surface in an unknown format", errorOf(checkWritable(*host_, WrittenContent::Surface, "surface.doc")));
        add("a dataset in an unknown format", errorOf(saveDataset(*host_, sampleDataset(4), "volume.doc", {}, {})));
        const std::array inputs{made("input.nrrd", "x")};
        add("output as input", errorOf(checkOutput(inputs[0], inputs)));
        add("something else in the way",
            errorOf(buildModel(*host_, sampleDataset(4), {}, {}, made("letter.txt", "x"))));
    }

    /// A file that may not grow, which is the same to a program.
    Message fullDisk() const
    {
        reportFailedWrites();
        rlimit before{};
        ::getrlimit(RLIMIT_FSIZE, &before);
        const rlimit small{4096, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
        const std::vector<std::byte> much(1 << 20);
        const Message message = errorOf(writeWholeFile(folder_ / "much", much));
        ::setrlimit(RLIMIT_FSIZE, &before);
        return message;
    }

    void building()
    {
        const fs::path output = folder_ / "built.tan";
        const auto points = scatteredDataset({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 2, 3}, "points");
        const auto built = [&](const Dataset& dataset, const char* builder, const ParameterValues& values) {
            return errorOf(buildModel(*host_, dataset, std::string(builder), values, output));
        };
        add("an unknown builder", built(sampleDataset(4), "nobody", {}));
        if (points)
            add("a builder that does not take it", built(*points, "decimation", {}));
        add("a wrong block", built(sampleDataset(4), "refinement", {{"block", std::string("some")}}));
        add("a parameter of other data", built(sampleDataset(4), "refinement", {{"selection", std::string("paper")}}));
        add("a wrong weight", built(sampleDataset(4), "refinement", {{"weights", std::string("point:1,2")}}));
        add("a weight of no kind", errorOf(parseWeighting("nonsense")));
    }

    void texts()
    {
        add("a clip plane", errorOf(parseClipPlanes("1,2")));
        add("no camera", errorOf(cameraFromText("[]", Eigen::AlignedBox3d())));
        add("a camera's number", errorOf(cameraFromText("{\"azimuth\": \"north\"}", Eigen::AlignedBox3d())));
        add("a camera's key", errorOf(cameraFromText("{\"zoom\": 1}", Eigen::AlignedBox3d())));
        add("no transfer function", errorOf(transferFunctionFromText("")));
        add("a transfer function's format", errorOf(transferFunctionFromText("{\"format\": \"x\", \"version\": 2}")));
        add("an error field", errorOf(parseErrorField("box(1, 2; 3)")));
        add("no session", errorOf(sessionFromText("x", folder_)));
        add("another file as a session", errorOf(sessionFromText("{}", folder_)));
        add("a session without a model",
            errorOf(sessionFromText("{\"format\": \"tan-session\", \"version\": 1}", folder_)));
    }

    void plugins()
    {
        PluginHost none({.folders = {folder_}});
        add("no reader at all", errorOf(openDataset(none, made("volume.nrrd", "x"))));
        add("no renderer at all", errorOf(none.renderer("volume")));
        PluginHost bad({.folders = {TAN_FIXTURES}, .disabled = {"good"}});
        for (const PluginStatus& plugin : bad.plugins())
            if (!plugin.error.empty())
                add(("plugin " + plugin.metadata.id).c_str(), plugin.error);
        add("plugin that throws", errorOf(bad.reader("throwing")));
        add("plugin that throws anything", errorOf(bad.reader("throwing-anything")));
        add("plugin of another kind", errorOf(bad.builder("impostor")));
        add("plugin without its library",
            explainLoadError("Cannot load library /p/x.so: (libx.so: cannot open shared object file: No such file)",
                             ""));
    }

    fs::path folder_;
    std::unique_ptr<PluginHost> host_;
    std::vector<Mistake> all_;
};

} // namespace

void SentencesTest::messagesAreTranslatedByTheirPlaces_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<QString>("german");
    const auto row = [](const char* name, const Message& message, const char* german) {
        QTest::newRow(name) << message << QString(german);
    };
    row("names stay, whatever they say",
        Message::say("'%1' is a folder. Choose a file inside it.", "Permission denied"),
        "„Permission denied“ ist ein Ordner. Wählen Sie eine Datei darin.");
    row("a sentence in a sentence", Message::say("'%1' cannot be read: %2.", "/a", systemErrorText(EACCES)),
        "„/a“ kann nicht gelesen werden: Keine Berechtigung.");
    row("a name that looks like a place",
        Message::say("Cannot open '%1': too many files are open. Close some of them.", "%2"),
        "„%2“ kann nicht geöffnet werden: Zu viele Dateien sind offen. Schließen Sie einige.");
    row("places in another order",
        Message::say("Not enough memory to write '%1' after %2 sites. Choose a larger error, or close other programs.",
                     "a.tan", 7),
        "Der Arbeitsspeicher reicht nach 7 Stützstellen nicht mehr, um „a.tan“ zu schreiben. Verlangen Sie einen "
        "größeren "
        "Fehler, oder schließen Sie andere Programme.");
    row("a marked text", Message::marked("Refining"), "Verfeinern");
    row("unknown", Message::say("Nobody knows %1.", 3), "Nobody knows 3.");
    row("no sentence", "Permission denied", "Permission denied");
    row("nothing", {}, "");
}

void SentencesTest::messagesAreTranslatedByTheirPlaces()
{
    QFETCH(Message, message);
    QFETCH(QString, german);
    QCOMPARE(translatedMessage(message), QString::fromStdString(message.text()));
    const Speaking speaking("de");
    QCOMPARE(translatedMessage(message), german);
}

/// The table of them, in three languages, stays in the test's folder: mistakes.md.
void SentencesTest::commonMistakes()
{
    const QTemporaryDir folder;
    const std::vector<Mistake> mistakes = Mistakes(folder.path().toStdString()).all();
    QVERIFY(mistakes.size() >= 60);
    const QString place = QRegularExpression::escape(folder.path());
    std::map<QString, QStringList> told;
    QStringList english;
    for (const char* language : {"en", "de", "it"}) {
        const Speaking speaking(language);
        for (const auto& [name, message] : mistakes) {
            told[name] << translatedMessage(message).remove(QRegularExpression(place + "/?"));
            if (QString(language) == "en")
                continue;
            if (const QString left = untranslated(message); !left.isEmpty())
                english << name + ": " + left;
            if (told[name].last() == told[name].first())
                english << name + ": " + told[name].last();
        }
    }
    QFile table("mistakes.md");
    QVERIFY(table.open(QIODevice::WriteOnly));
    for (const auto& [name, message] : mistakes) {
        QVERIFY2(!message.empty(), qPrintable(name + " is no mistake"));
        table.write(("## " + name + "\n\n- " + told[name].join("\n- ") + "\n\n").toUtf8());
    }
    QVERIFY2(english.isEmpty(), qPrintable(english.join('\n')));
}

void SentencesTest::whatReadersRemark()
{
    QFETCH(QString, language);
    const Speaking speaking(language);
    for (const std::uint64_t count : {1, 3}) {
        Repairs repairs{count, count, count, count, count, count, 0,     count, count, count, count,
                        count, count, count, count, count, false, count, count, true,  false, {}};
        for (const CellFault fault : {CellFault::CrowdedFace, CellFault::Folded, CellFault::Overlap})
            for (std::uint64_t cell = 0; cell < count; ++cell)
                repairs.faulty.push_back({cell, fault});
        for (const std::uint64_t cells : {count, count + 1}) { // all turned over, and some
            repairs.cells = cells;
            const auto remarks = repairRemarks(repairs);
            QCOMPARE(remarks.size(), std::size_t(20));
            for (const Message& remark : remarks) {
                const QString told = translatedMessage(remark);
                QVERIFY2((told == QString::fromStdString(remark.text())) == (language == "en"), qPrintable(told));
                QVERIFY2(language == "en" || untranslated(remark).isEmpty(), qPrintable(told));
            }
        }
    }
}

/// Of a file beside its library; what the program says itself stays.
void SentencesTest::aPluginBringsItsTranslations()
{
    const PluginHost host({.folders = {TAN_CHOICES}});
    QCOMPARE(host.plugins().size(), std::size_t(1));
    const auto names = host.plugins()[0].metadata.names;
    QVERIFY(pluginTranslators(host, QLocale("it")).empty());
    const auto theirs = pluginTranslators(host, QLocale("de"));
    QCOMPARE(theirs.size(), std::size_t(1));
    QTranslator ours;
    QVERIFY(ours.load(QLocale("de"), "tan", "_", ":/i18n"));
    QCoreApplication::installTranslator(&ours);
    QCOMPARE(translatedText("Which."), QString("Which."));
    installBehind(theirs, ours);
    QCOMPARE(translatedText("Which."), QString("Welche."));
    QCOMPARE(translatedText("Values"), QString("Werte")); // theirs is another
    QCOMPARE(inUsersLanguage("Files full of choices", names), QString("Dateien voller Auswahl"));
    QCoreApplication::removeTranslator(&ours);
    QCOMPARE(translatedText("Values"), QString("Zahlen"));
    QCOMPARE(inUsersLanguage("Files full of choices", names), QString("Files full of choices"));
}

QTEST_MAIN(SentencesTest)
#include "sentences_test.moc"
