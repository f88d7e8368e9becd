// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions as text: they come back the same, keep what they do not know, and say what is wrong with them.
#include "core/picture/session_model.h"
#include "core/picture/text_file.h"
#include "ui/opening/kept_views.h"
#include "ui/session/files.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>
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
    document.view.query.error = 100 * unit(random);
    document.view.query.warping = {static_cast<WarpingLimit>(random() % 3), 100 * unit(random)};
    document.view.query.byBudget = random() % 2 == 0;
    document.view.query.budget = random();
    document.view.query.focus = {static_cast<FocusState::Shape>(random() % 6),
                                 randomVector(random),
                                 randomVector(random),
                                 unit(random),
                                 unit(random),
                                 unit(random),
                                 unit(random),
                                 unit(random)};
    for (unsigned count = random() % 4; count > 0; --count)
        document.view.query.focus.others.push_back(
            random() % 2 == 0 ? MovableRegion(Sphere{randomVector(random), unit(random)})
                              : MovableRegion(Box{randomVector(random), randomVector(random)}));
    document.view.query.focus.number = static_cast<std::uint32_t>(document.view.query.focus.others.size());
    document.view.query.range = {random() % 2 == 0, unit(random), unit(random), unit(random),
                                 unit(random),      unit(random), unit(random)};
    document.view.query.window.enabled = random() % 2 == 0;
    document.view.query.window.window = {{randomVector(random), randomVector(random)},
                                         static_cast<WindowBorder>(random() % 3)};
    document.view.query.values = {random() % 2 == 0, unit(random), unit(random)};
    document.view.appearance.mode = "hybrid";
    document.view.appearance.transfer = {{{unit(random), {channel(random), channel(random), channel(random)}},
                                          {2, {channel(random), channel(random), channel(random)}}},
                                         {{unit(random), channel(random)}, {2, channel(random)}, {3, channel(random)}},
                                         0.5 + unit(random)};
    document.view.appearance.settings = {{"switch", random() % 2 == 0},
                                         {"count", static_cast<std::int64_t>(random())},
                                         {"share", unit(random)},
                                         {"whole", 3.0},
                                         {"name", std::string("a \"text\" with ü")}};
    for (unsigned count = random() % 4; count > 0; --count)
        document.view.isovalues.push_back(
            {unit(random), channel(random), channel(random), channel(random), channel(random), random() % 2 == 0});
    if (random() % 2 == 0)
        document.view.tools = {{"ruler", "1,2,3 4,5,6"}, {"example.gone", "{\"ü\":  [1, 2]}"}};
    document.hasCamera = random() % 2 == 0;
    if (document.hasCamera)
        document.view.camera = Camera{randomVector(random), 0.1 + unit(random), 30, 20, 10, UpAxis::MinusY, 40,
                                      random() % 2 == 0,    random() % 3 == 0};
    if (random() % 2 == 0)
        document.view.background = Colour{channel(random), channel(random), channel(random)};
    document.view.lens = {static_cast<LensState::Shape>(random() % 3),
                          unit(random),
                          unit(random),
                          unit(random),
                          1 + unit(random),
                          unit(random)};
    for (AnnotationPlace& place : document.view.annotations.places)
        place = {random() % 2 == 0, static_cast<Corner>(random() % 4)};
    if (random() % 2 == 0)
        document.view.annotations.barEnds = BarEnds{-unit(random), 1 + unit(random)};
    document.view.animation.kind = static_cast<Animation::Kind>(random() % 2);
    document.view.animation.framesPerSecond = 1 + 100 * unit(random);
    document.view.animation.turntable = {static_cast<Turntable::Axis>(random() % 2), 360 * unit(random),
                                         static_cast<int>(1 + random() % 999)};
    for (unsigned count = random() % 4; count > 0; --count) {
        const FilmFrame frame{{randomVector(random), 0.1 + unit(random), 30, 20, -50, UpAxis::X, 40, random() % 2 == 0,
                               random() % 3 == 0},
                              document.view.appearance.transfer,
                              document.view.isovalues,
                              unit(random),
                              random() % 2 == 0,
                              random()};
        document.view.animation = withKey(document.view.animation, frame);
    }
    return document;
}

} // namespace

class SessionDocumentTest : public QObject {
    Q_OBJECT
private slots:
    void aSessionComesBackTheSame();
    void endsOfTheBarAreForgotten();
    void textsOfAnnotationsAreForgotten();
    void modelsInTheFolderMoveWithIt();
    void aModelIsFoundWhereItIs_data();
    void aModelIsFoundWhereItIs();
    void whatIsNotKnownIsKept();
    void whatIsMissingIsAsUsual();
    void volumesStayLitOrNot();
    void badSessionsAreRefused_data();
    void badSessionsAreRefused();
    void aViewIsFoundByWhatItIsOf();
    void whatAProgramLeftIsLost();
    void twoProgramsKeepTheViewOfOneModel();
    void oldViewsGo();
    void whatCannotBeKeptIsToldOnce();
};

void SessionDocumentTest::aSessionComesBackTheSame()
{
    QLocale::setDefault(QLocale(QLocale::German));
    std::mt19937 random(8);
    for (int round = 0; round < 200; ++round) {
        const SessionDocument before = randomDocument(random);
        const auto after = sessionFromText(sessionToText(before, "/elsewhere"), "/elsewhere");
        QVERIFY2(after, after ? "" : after.error().text().c_str());
        QCOMPARE(after->model, before.model);
        QCOMPARE(after->identity, before.identity);
        QVERIFY(after->view == before.view);
        QCOMPARE(after->hasCamera, before.hasCamera);
    }
}

/// A bar over all values stays that when the session is saved over one with chosen ends; what is no range is none.
void SessionDocumentTest::endsOfTheBarAreForgotten()
{
    SessionDocument document;
    document.model = "/place/one.tan";
    document.view.annotations.barEnds = BarEnds{1, 2};
    const std::string chosen = sessionToText(document, "/place");
    SessionDocument read = sessionFromText(chosen, "/place").value();
    QVERIFY(read.view.annotations.barEnds == (BarEnds{1, 2}));
    read.view.annotations.barEnds.reset();
    QVERIFY(!sessionFromText(sessionToText(read, "/place"), "/place")->view.annotations.barEnds);
    QByteArray turned = QByteArray::fromStdString(chosen);
    turned.replace("\"largest\": 2", "\"largest\": 0");
    QVERIFY(turned.toStdString() != chosen);
    QVERIFY(!sessionFromText(turned.toStdString(), "/place")->view.annotations.barEnds);
}

/// Texts that are those of the data again do not come back from the file that is saved over.
void SessionDocumentTest::textsOfAnnotationsAreForgotten()
{
    SessionDocument document;
    document.model = "/place/one.tan";
    AnnotationState& annotations = document.view.annotations;
    annotations.title = "Skull";
    annotations.quantity = "Density";
    annotations.unit = "HU";
    annotations.numbers = {NumberFormat::Style::Powers, 3};
    annotations.lengths = {NumberFormat::Style::Plain, 0};
    annotations.textSize = 20;
    annotations.boldText = true;
    SessionDocument read = sessionFromText(sessionToText(document, "/place"), "/place").value();
    QVERIFY(read.view.annotations == annotations);
    read.view.annotations = {};
    QVERIFY(sessionFromText(sessionToText(read, "/place"), "/place")->view.annotations == AnnotationState());
}

void SessionDocumentTest::modelsInTheFolderMoveWithIt()
{
    SessionDocument document;
    document.model = "/old/place/models/one.tan";
    QCOMPARE(sessionFromText(sessionToText(document, "/old/place"), "/new")->model.string(), "/new/models/one.tan");
    QCOMPARE(sessionFromText(sessionToText(document, "/old/other"), "/new")->model.string(),
             "/old/place/models/one.tan");
}

void SessionDocumentTest::aModelIsFoundWhereItIs_data()
{
    QTest::addColumn<QString>("session");    // where both are when the session is read
    QTest::addColumn<QStringList>("models"); // "NAME" of the same content, "!NAME" of another one
    QTest::addColumn<QString>("found");
    const auto row = [](const char* name, const char* session, const QStringList& models, const char* found) {
        QTest::newRow(name) << session << models << found;
    };
    row("as it was", "project/looks/a.tansession", {"project/data/m.tan"}, "project/data/m.tan");
    row("moved together", "new/looks/a.tansession", {"new/data/m.tan"}, "new/data/m.tan");
    row("copied together", "new/looks/a.tansession", {"new/data/m.tan", "project/data/m.tan"}, "new/data/m.tan");
    row("the session moved", "far/away/a.tansession", {"project/data/m.tan"}, "project/data/m.tan");
    row("the model moved to it", "project/looks/a.tansession", {"project/looks/m.tan"}, "project/looks/m.tan");
    row("the model moved above it", "project/looks/a.tansession", {"project/m.tan"}, "project/m.tan");
    row("the session moved below", "new/looks/deep/er/a.tansession", {"new/data/m.tan"}, "new/data/m.tan");
    row("built anew", "project/looks/a.tansession", {"!project/data/m.tan"}, "project/data/m.tan");
    row("built anew, the old one beside", "project/looks/a.tansession", {"!project/data/m.tan", "project/looks/m.tan"},
        "project/looks/m.tan");
    row("another one beside", "project/looks/a.tansession", {"!project/looks/m.tan"}, "");
    row("none", "project/looks/a.tansession", {}, "");
}

void SessionDocumentTest::aModelIsFoundWhereItIs()
{
    QFETCH(QString, session);
    QFETCH(QStringList, models);
    QFETCH(QString, found);
    const QTemporaryDir home;
    const auto place = [&home](const QString& name) { return filePath(home.filePath(name)); };
    constexpr std::uint64_t identity = 0x123456789abcdef0;
    for (QString model : models) {
        const bool isOther = model.startsWith('!');
        std::string header(256, '\0'); // all that is looked at
        const std::uint64_t sum = isOther ? identity + 1 : identity;
        std::memcpy(header.data() + headerChecksumOffset, &sum, sizeof sum);
        const auto file = place(isOther ? model.mid(1) : model);
        std::filesystem::create_directories(file.parent_path());
        QVERIFY(writeTextFile(file, header));
    }
    SessionDocument document;
    document.model = place("project/data/m.tan");
    document.identity = identity;
    const std::string text = sessionToText(document, place("project/looks"));
    const auto read = sessionFromText(text, place(session).parent_path());
    QVERIFY(read);
    const auto model = sessionModel(*read, place(session));
    QCOMPARE(model.has_value(), !found.isEmpty());
    if (model)
        QCOMPARE(*model, place(found));
    // Saved again there, it says the new place.
    SessionDocument moved = *read;
    moved.model = place(found.isEmpty() ? "m.tan" : found);
    const auto again = sessionFromText(sessionToText(moved, place("elsewhere")), place("elsewhere"));
    QVERIFY(again && (again->relativeModel == moved.model || again->absoluteModel == moved.model));
}

void SessionDocumentTest::whatIsNotKnownIsKept()
{
    std::mt19937 random(2);
    SessionDocument document = randomDocument(random);
    document.view.background = Colour{1, 0, 0};
    document.view.tools = {{"ruler", "1,2,3"}, {"example.gone", "4"}};
    QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(document, "/"))).object();
    root["ofTomorrow"] = QJsonValue(QJsonArray({QJsonValue(1), QJsonValue("two")}));
    QJsonObject mesh = root["mesh"].toObject();
    mesh["alsoOfTomorrow"] = true;
    root["mesh"] = mesh;
    auto read = sessionFromText(QJsonDocument(root).toJson().toStdString(), "/");
    QVERIFY(read);
    read->view.background.reset();
    read->view.appearance.settings.clear();
    read->view.tools.erase("ruler");
    const QJsonObject written = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(*read, "/"))).object();
    QCOMPARE(written["ofTomorrow"], root["ofTomorrow"]);
    QCOMPARE(written["mesh"].toObject()["alsoOfTomorrow"].toBool(), true);
    QVERIFY(!written.contains("background"));
    QCOMPARE(written["tools"].toObject(), (QJsonObject{{"example.gone", "4"}}));
    QVERIFY(written["look"].toObject()["settings"].toObject().isEmpty());
}

void SessionDocumentTest::whatIsMissingIsAsUsual()
{
    const auto read =
        sessionFromText(R"({"format": "tan-session", "version": 1, "model": {"path": "a.tan"}})", "/folder");
    QVERIFY(read);
    QCOMPARE(read->model.string(), "/folder/a.tan");
    ViewValue usual;
    // What was meant where nothing said that volumes are usually lit, and usually without a box around an object.
    usual.appearance.settings["shaded"] = false;
    usual.appearance.settings["outline"] = true;
    QVERIFY(read->view == usual && !read->hasCamera && read->identity == 0);
}

/// Where volumes are usually lit, sessions say so; in others they are lit if their setting says so. Likewise the box.
void SessionDocumentTest::volumesStayLitOrNot()
{
    SessionDocument document;
    document.model = "/data/models/one.tan";
    const auto settingsOf = [](const QJsonObject& root) {
        const auto read = sessionFromText(QJsonDocument(root).toJson().toStdString(), "/");
        return read ? read->view.appearance.settings : ParameterValues{{"unread", true}};
    };
    QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(document, "/"))).object();
    QVERIFY(settingsOf(root).empty());
    root.remove("usuallyShaded");
    QVERIFY((settingsOf(root) == ParameterValues{{"shaded", false}}));
    document.view.appearance.settings["shaded"] = true;
    root = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(document, "/"))).object();
    root.remove("usuallyShaded");
    QVERIFY((settingsOf(root) == ParameterValues{{"shaded", true}}));
    root.remove("usuallyWithoutBox");
    QVERIFY((settingsOf(root) == ParameterValues{{"outline", true}, {"shaded", true}}));
    document.view.appearance.settings["outline"] = false;
    root = QJsonDocument::fromJson(QByteArray::fromStdString(sessionToText(document, "/"))).object();
    root.remove("usuallyWithoutBox");
    QVERIFY((settingsOf(root) == ParameterValues{{"outline", false}, {"shaded", true}}));
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
    row("path is a number", R"("model": {"path": 3})", "\"model.path\" must be text in quotes");
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
    QVERIFY2(QString::fromStdString(read.error().text()).contains(told), read.error().text().c_str());
    for (const char* other :
         {"", "{", "[]", R"({"format": "tan-transfer-function"})", R"({"format": "tan-session", "version": 2})"})
        QVERIFY(!sessionFromText(other, "/"));
}

void SessionDocumentTest::aViewIsFoundByWhatItIsOf()
{
    const QTemporaryDir home;
    const std::filesystem::path folder = filePath(home.filePath("views"));
    const std::filesystem::path model = filePath(home.filePath("one.tan"));
    std::mt19937 random(1);
    const SessionDocument first = randomDocument(random), second = randomDocument(random);
    {
        KeptViews views(folder);
        QVERIFY(!views.find(model));
        views.keep(model, first);
        QCOMPARE(views.find(model)->view.query, first.view.query); // whether it is written or not
        views.keep(model, second);
        views.keep(filePath(home.filePath("two.tan")), first);
        QCOMPARE(views.find(model)->view.query, second.view.query);
    }
    QVERIFY(QDir(pathText(folder)).entryList({"*.lock"}, QDir::Files).isEmpty()); // nothing is lost
    KeptViews views(folder);
    QVERIFY(views.lost().empty());
    QCOMPARE(views.find(model)->view.appearance, second.view.appearance);
    QCOMPARE(views.find(filePath(home.filePath("views/../one.tan")))->view.appearance, second.view.appearance);
    QVERIFY(QFile::link(home.filePath("two.tan"), home.filePath("link.tan")));
    QVERIFY(writeTextFile(filePath(home.filePath("two.tan")), ""));
    QCOMPARE(views.find(filePath(home.filePath("link.tan")))->view.appearance, first.view.appearance);
    views.forget(model);
    QVERIFY(!views.find(model));
    QTRY_VERIFY(views.idle());
    QVERIFY(!views.find(model));
    QCOMPARE(QDir(pathText(folder)).entryList(QDir::Files).size(), 1);
}

void SessionDocumentTest::whatAProgramLeftIsLost()
{
    const QTemporaryDir home;
    const std::filesystem::path folder = filePath(home.filePath("views"));
    const std::filesystem::path model = filePath(home.filePath("one.tan"));
    std::mt19937 random(1);
    const SessionDocument document = randomDocument(random);
    {
        KeptViews views(folder);
        views.keep(model, document);
        QTRY_VERIFY(views.idle());
        const QString lock = QDir(pathText(folder)).entryList({"*.lock"}, QDir::Files).value(0);
        QVERIFY(!lock.isEmpty());
        QVERIFY(KeptViews(folder).lost().empty()); // the program runs
        // As a program leaves it that was killed: a lock of nobody.
        QVERIFY(QFile::copy(pathText(folder) + "/" + lock, home.filePath("lock")));
        views.release();
        QTRY_VERIFY(views.idle());
        QFile file(home.filePath("lock"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QList<QByteArray> lines = file.readAll().split('\n');
        lines[0] = "999999999"; // its process
        QVERIFY(writeTextFile(folder / lock.toStdString(), lines.join('\n').toStdString()));
    }
    QVERIFY(writeTextFile(folder / "none.lost.tansession", "{}"));
    KeptViews views(folder);
    const std::vector<LostView> lost = views.lost();
    QCOMPARE(lost.size(), std::size_t(1));
    QCOMPARE(lost.front().document.view.query, document.view.query);
    QVERIFY(!views.find(model)); // it does not come back by itself
    QCOMPARE(KeptViews(folder).lost().size(), std::size_t(1));
    views.removeLost(model);
    QCOMPARE(views.lost().size(), std::size_t(1));
    views.removeLost(lost.front().path);
    QVERIFY(views.lost().empty());
}

void SessionDocumentTest::twoProgramsKeepTheViewOfOneModel()
{
    const QTemporaryDir home;
    const std::filesystem::path folder = filePath(home.filePath("views"));
    std::mt19937 random(1);
    const SessionDocument mine = randomDocument(random), theirs = randomDocument(random);
    auto one = std::make_unique<KeptViews>(folder);
    auto other = std::make_unique<KeptViews>(folder);
    one->keep("/a.tan", mine);
    QTRY_VERIFY(one->idle());
    other->keep("/a.tan", theirs);
    QTRY_VERIFY(other->idle());
    QCOMPARE(one->find("/a.tan")->view.query, theirs.view.query);
    QVERIFY(KeptViews(folder).lost().empty());
    other.reset();
    QVERIFY(KeptViews(folder).lost().empty()); // one still has it
    one.reset();
    QVERIFY(QDir(pathText(folder)).entryList({"*.lock"}, QDir::Files).isEmpty());
    QVERIFY(KeptViews(folder).find("/a.tan"));
}

void SessionDocumentTest::oldViewsGo()
{
    const QTemporaryDir home;
    const std::filesystem::path folder = filePath(home.filePath("views"));
    const QDir files(pathText(folder));
    std::mt19937 random(1);
    const SessionDocument document = randomDocument(random);
    KeptViews views(folder);
    for (int model = 0; model < 260; ++model)
        views.keep(filePath(QString("/%1.tan").arg(model)), document);
    QTRY_VERIFY_WITH_TIMEOUT(views.idle(), 60'000);
    QCOMPARE(files.entryList({"*.tansession"}, QDir::Files).size(), 200);
    QVERIFY(views.find("/259.tan"));
    // Older than a year.
    QDateTime then = QDateTime::currentDateTime().addDays(-366);
    for (const QString& name : files.entryList({"*.tansession"}, QDir::Files)) {
        QFile file(files.filePath(name));
        QVERIFY(file.open(QIODevice::ReadWrite) && file.setFileTime(then, QFileDevice::FileModificationTime));
    }
    views.keep("/new.tan", document);
    QTRY_VERIFY(views.idle());
    QCOMPARE(files.entryList({"*.tansession"}, QDir::Files).size(), 1);
}

void SessionDocumentTest::whatCannotBeKeptIsToldOnce()
{
    std::mt19937 random(1);
    const SessionDocument document = randomDocument(random);
    KeptViews views("/proc/nowhere");
    const QSignalSpy failed(&views, &KeptViews::failed);
    for (int time = 0; time < 2; ++time) {
        views.keep("/a.tan", document);
        QTRY_VERIFY(views.idle());
    }
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed.first().first().toString().contains("/proc/nowhere"));
    // What is damaged is no view, and no harm.
    const QTemporaryDir home;
    KeptViews others(filePath(home.path()));
    others.keep("/a.tan", document);
    QTRY_VERIFY(others.idle());
    const QString name = QDir(home.path()).entryList({"*.tansession"}, QDir::Files).value(0);
    QVERIFY(writeTextFile(filePath(home.filePath(name)), "{\"format\": "));
    QVERIFY(!others.find("/a.tan"));
}

QTEST_GUILESS_MAIN(SessionDocumentTest)
#include "session_document_test.moc"
