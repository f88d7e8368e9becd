// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions as text: they come back the same, keep what they do not know, and say what is wrong with them.
#include "ui/session/recovery.h"
#include "ui/session/session_document.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace tetra;

namespace {

Eigen::Vector3d randomVector(std::mt19937& random)
{
    std::uniform_real_distribution<double> any(-1e6, 1e6);
    return {any(random), any(random) * 1e-9, any(random)};
}

SessionDocument randomDocument(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0, 1);
    std::uniform_real_distribution<float> channel(0, 1);
    SessionDocument document;
    document.model = "/data/models/one.tan";
    document.identity = (std::uint64_t(random()) << 32) + random();
    document.query.error = 100 * unit(random);
    document.query.byBudget = random() % 2 == 0;
    document.query.budget = random();
    document.query.focus = {static_cast<FocusState::Shape>(random() % 3),
                            randomVector(random),
                            randomVector(random),
                            unit(random),
                            unit(random),
                            unit(random)};
    document.query.window.enabled = random() % 2 == 0;
    document.query.window.window = {{randomVector(random), randomVector(random)},
                                    static_cast<WindowBorder>(random() % 3)};
    document.query.values = {random() % 2 == 0, unit(random), unit(random)};
    document.look.mode = "hybrid";
    document.look.transfer = {{{unit(random), {channel(random), channel(random), channel(random)}, channel(random)},
                               {2, {channel(random), channel(random), channel(random)}, channel(random)}},
                              0.5 + unit(random)};
    document.look.settings = {{"switch", random() % 2 == 0},
                              {"count", static_cast<std::int64_t>(random())},
                              {"share", unit(random)},
                              {"whole", 3.0},
                              {"name", std::string("a \"text\" with ü")}};
    for (unsigned count = random() % 4; count > 0; --count)
        document.isovalues.push_back(
            {unit(random), channel(random), channel(random), channel(random), channel(random), random() % 2 == 0});
    if (random() % 2 == 0)
        document.camera = Camera{randomVector(random), 0.1 + unit(random), 30, 20, 40, random() % 2 == 0};
    if (random() % 2 == 0)
        document.background = Colour{channel(random), channel(random), channel(random)};
    for (AnnotationPlace& place : document.annotations.places)
        place = {random() % 2 == 0, static_cast<Corner>(random() % 4)};
    document.animation.kind = static_cast<Animation::Kind>(random() % 2);
    document.animation.framesPerSecond = 1 + 100 * unit(random);
    document.animation.turntable = {static_cast<Turntable::Axis>(random() % 2), 360 * unit(random),
                                    static_cast<int>(1 + random() % 999)};
    for (unsigned count = random() % 4; count > 0; --count) {
        const FilmFrame frame{{randomVector(random), 0.1 + unit(random), 30, 20, 40, random() % 2 == 0},
                              document.look.transfer,
                              document.isovalues,
                              unit(random),
                              random() % 2 == 0,
                              random()};
        document.animation = withKey(document.animation, frame);
    }
    return document;
}

} // namespace

class SessionDocumentTest : public QObject {
    Q_OBJECT
private slots:
    void aSessionComesBackTheSame();
    void modelsInTheFolderMoveWithIt();
    void whatIsNotKnownIsKept();
    void whatIsMissingIsAsUsual();
    void badSessionsAreRefused_data();
    void badSessionsAreRefused();
    void aSessionThatWasLostIsFound();
    void theSessionOfARunningProgramIsNotLost();
};

void SessionDocumentTest::aSessionComesBackTheSame()
{
    QLocale::setDefault(QLocale(QLocale::German));
    std::mt19937 random(8);
    for (int round = 0; round < 200; ++round) {
        const SessionDocument before = randomDocument(random);
        const auto after = sessionFromText(sessionToText(before, "/elsewhere"), "/elsewhere");
        QVERIFY2(after, after ? "" : after.error().text.c_str());
        QCOMPARE(after->model, before.model);
        QCOMPARE(after->identity, before.identity);
        QVERIFY(after->query == before.query);
        QVERIFY(after->look == before.look);
        QVERIFY(after->isovalues == before.isovalues);
        QVERIFY(after->camera == before.camera);
        QVERIFY(after->background == before.background);
        QVERIFY(after->annotations == before.annotations);
        QVERIFY(after->animation == before.animation);
    }
}

void SessionDocumentTest::modelsInTheFolderMoveWithIt()
{
    SessionDocument document;
    document.model = "/old/place/models/one.tan";
    QCOMPARE(sessionFromText(sessionToText(document, "/old/place"), "/new")->model.string(), "/new/models/one.tan");
    QCOMPARE(sessionFromText(sessionToText(document, "/old/other"), "/new")->model.string(),
             "/old/place/models/one.tan");
}

void SessionDocumentTest::whatIsNotKnownIsKept()
{
    std::mt19937 random(2);
    SessionDocument document = randomDocument(random);
    document.background = Colour{1, 0, 0};
    QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(document, "/"))).object();
    root["ofTomorrow"] = QJsonValue(QJsonArray({QJsonValue(1), QJsonValue("two")}));
    QJsonObject mesh = root["mesh"].toObject();
    mesh["alsoOfTomorrow"] = true;
    root["mesh"] = mesh;
    auto read = sessionFromText(QJsonDocument(root).toJson().toStdString(), "/");
    QVERIFY(read);
    read->background.reset();
    read->look.settings.clear();
    const QJsonObject written = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(*read, "/"))).object();
    QCOMPARE(written["ofTomorrow"], root["ofTomorrow"]);
    QCOMPARE(written["mesh"].toObject()["alsoOfTomorrow"].toBool(), true);
    QVERIFY(!written.contains("background"));
    QVERIFY(written["look"].toObject()["settings"].toObject().isEmpty());
}

void SessionDocumentTest::whatIsMissingIsAsUsual()
{
    const auto read =
        sessionFromText(R"({"format": "tan-session", "version": 1, "model": {"path": "a.tan"}})", "/folder");
    QVERIFY(read);
    QCOMPARE(read->model.string(), "/folder/a.tan");
    QVERIFY(read->query == QueryState() && read->isovalues.empty() && !read->camera && read->identity == 0);
}

void SessionDocumentTest::badSessionsAreRefused_data()
{
    QTest::addColumn<QString>("members");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* name, const char* members, const char* told) {
        QTest::newRow(name) << members << told;
    };
    row("no model", R"("x": 1)", "model.path");
    row("model is a text", R"("model": "a.tan")", "\"model\" must be an object");
    row("path is a number", R"("model": {"path": 3})", "\"model.path\" must be a text");
    row("error is a text", R"("model": {"path": "a"}, "mesh": {"error": "1 %"})", "\"mesh.error\" must be a number");
    row("two coordinates", R"("model": {"path": "a"}, "mesh": {"focus": {"centre": [1, 2]}})",
        "\"mesh.focus.centre\" must be three numbers");
    row("shape", R"("model": {"path": "a"}, "mesh": {"focus": {"shape": "cone"}})", "\"mesh.focus.shape\"");
    row("border", R"("model": {"path": "a"}, "mesh": {"window": {"border": 3}})", "\"mesh.window.border\"");
    row("transfer", R"("model": {"path": "a"}, "look": {"transfer": {"points": []}})", "transfer function");
    row("isovalue", R"("model": {"path": "a"}, "isovalues": [{"value": 1}, {"value": null}])",
        "\"isovalues[1].value\"");
    row("camera", R"("model": {"path": "a"}, "camera": {"azimuth": "north"})", "azimuth");
    row("background", R"("model": {"path": "a"}, "background": "red")", "\"background\"");
}

void SessionDocumentTest::badSessionsAreRefused()
{
    QFETCH(QString, members);
    QFETCH(QString, told);
    const QString text = QString(R"({"format": "tan-session", "version": 1, %1})").arg(members);
    const auto read = sessionFromText(text.toStdString(), "/");
    QVERIFY(!read);
    QVERIFY2(QString::fromStdString(read.error().text).contains(told), read.error().text.c_str());
    for (const char* other :
         {"", "{", "[]", R"({"format": "tan-transfer-function"})", R"({"format": "tan-session", "version": 2})"})
        QVERIFY(!sessionFromText(other, "/"));
}

void SessionDocumentTest::aSessionThatWasLostIsFound()
{
    const QTemporaryDir home;
    const std::filesystem::path folder = filePath(home.filePath("recovery"));
    QVERIFY(lostSessions(folder).empty());
    std::mt19937 random(1);
    const std::string text = sessionToText(randomDocument(random), folder);
    {
        // As a program leaves it that was killed: the file, and a lock of nobody.
        Recovery killed(folder);
        QVERIFY(killed.keep(text));
        const QStringList files = QDir(pathText(folder)).entryList({"*.tansession"}, QDir::Files);
        QCOMPARE(files.size(), 1);
        QVERIFY(QFile::copy(pathText(folder) + "/" + files.first(), pathText(folder) + "/of-the-dead.tansession"));
    }
    QVERIFY(writeTextFile(folder / "no-session.tansession", "{}"));
    const std::vector<LostSession> lost = lostSessions(folder);
    QCOMPARE(lost.size(), std::size_t(1));
    QCOMPARE(lost.front().text, text);
    removeLostSession(lost.front());
    QVERIFY(lostSessions(folder).empty());
}

void SessionDocumentTest::theSessionOfARunningProgramIsNotLost()
{
    const QTemporaryDir home;
    const std::filesystem::path folder = filePath(home.filePath("recovery"));
    std::mt19937 random(1);
    const std::string text = sessionToText(randomDocument(random), folder);
    Recovery one(folder), other(folder);
    QVERIFY(one.keep(text) && other.keep(text) && one.keep(text));
    QVERIFY(lostSessions(folder).empty());
    one.forget();
    other.forget();
    QVERIFY(QDir(pathText(folder)).isEmpty());
    const auto full = Recovery("/proc/nowhere").keep(text);
    QVERIFY(!full && full.error().text.find("/proc/nowhere") != std::string::npos);
}

QTEST_GUILESS_MAIN(SessionDocumentTest)
#include "session_document_test.moc"
