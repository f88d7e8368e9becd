// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions of earlier programs open for ever, and views that these lost are offered: the files in old_sessions were
// written by the programs of their time.
//
//     first.tansession        by c057bee, the first that had sessions
//     recovery                what that one left behind when it was killed
//     with_film.tansession    by 3930fd9: with annotations, a film, a mask and groups of points
//     with_domain.tansession  by c035d89: with the model's domain and range, before views had a size and cameras an
//                             upright axis
#include "core/picture/session_document.h"
#include "core/picture/text_file.h"
#include "ui/opening/kept_views.h"
#include "ui/session/files.h"

#include <QDir>
#include <QLockFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

namespace {

const std::filesystem::path oldSessionsFolder = TAN_SOURCE_DIR "/tests/ui/old_sessions";
constexpr const char* lostView = "658dd15b-51e1-48a5-9e5b-3140763c1930";

/// What all of them show.
SessionDocument firstDocument()
{
    SessionDocument document;
    document.model = "/data/lattice.tan";
    document.identity = 0xd3fb3bdc2ab4d8b5;
    document.view.query.error = 2.5;
    document.view.query.budget = 250'000;
    document.view.query.focus = {FocusState::Shape::Sphere, {2.5, 2, 3}, {1, 1.25, 1.5}, 1.75, 0.25, 0.5};
    document.view.query.window = {true, {{{0, 0, 0.5}, {5, 3.75, 5}}, WindowBorder::Clipped}};
    document.view.query.values = {false, 60, 170};
    document.view.appearance.mode = "hybrid";
    document.view.appearance.transfer = transferFunctionFromPoints({{40, {0.25F, 0.5F, 1}, 0},
                                                                    {90, {0.25F, 0.5F, 1}, 0.125F},
                                                                    {90, {1, 0.75F, 0}, 0.5F},
                                                                    {190, {1, 0, 0}, 0.875F}},
                                                                   0.4);
    document.view.appearance.settings = {{"shaded", true}, {"outline", false}};
    document.view.isovalues = {{64, 0.5F, 0.75F, 0.25F, 0.5F, true}, {150.5, 1, 0.5F, 0, 1, false}};
    Camera camera;
    camera.target = {2.5, 2, 2.5};
    camera.distance = 14.25;
    camera.azimuth = 123.5;
    camera.elevation = -12.25;
    camera.fieldOfView = 40;
    camera.perspective = false;
    camera.roll = 0; // as it was before cameras could be rolled, and before another axis could be upright
    camera.up = UpAxis::Z;
    camera.trackball = false;
    document.view.camera = camera;
    document.hasCamera = true;
    document.view.background = Colour{0, 0.25F, 0.5F};
    return document;
}

SessionDocument documentWithFilm()
{
    SessionDocument document = firstDocument();
    document.view.appearance.transfer.mask = TransferMask{50, 180.5};
    for (const std::size_t point : {1, 2}) {
        document.view.appearance.transfer.colours[point].group = 3;
        document.view.appearance.transfer.opacities[point].group = 3;
    }
    document.view.annotations[AnnotationKind::ScaleBar] = {true, Corner::TopLeft};
    document.view.annotations[AnnotationKind::Axes].shown = false;
    document.view.animation.kind = Animation::Kind::KeyFrames;
    document.view.animation.framesPerSecond = 12.5;
    document.view.animation.turntable = {Turntable::Axis::Horizontal, 180, 90};
    FilmFrame frame{
        document.view.camera, document.view.appearance.transfer, document.view.isovalues, 5, false, 300'000};
    document.view.animation.keys.push_back({0, frame});
    frame.camera.azimuth = 150;
    frame.byBudget = true;
    frame.budget = 4000;
    document.view.animation.keys.push_back({2, frame});
    return document;
}

SessionDocument documentWithDomain()
{
    SessionDocument document = documentWithFilm();
    document.bounds = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 4, 5));
    document.range = ValueRange{32, 193};
    return document;
}

void compareDocuments(const SessionDocument& read, const SessionDocument& expected)
{
    QCOMPARE(read.model, expected.model);
    QCOMPARE(read.identity, expected.identity);
    QCOMPARE(read.bounds.isEmpty(), expected.bounds.isEmpty());
    QVERIFY(read.bounds.isEmpty() || read.bounds.isApprox(expected.bounds, 0));
    QCOMPARE(read.range.has_value(), expected.range.has_value());
    QVERIFY(!read.range ||
            (read.range->minimum == expected.range->minimum && read.range->maximum == expected.range->maximum));
    QVERIFY(read.view == expected.view);
    QCOMPARE(read.hasCamera, expected.hasCamera);
    QVERIFY(read.viewSize == expected.viewSize);
    QVERIFY(read.file.empty());
}

} // namespace

class OldSessionsTest : public QObject {
    Q_OBJECT
private slots:
    void sessionsAreReadToTheLetter_data();
    void sessionsAreReadToTheLetter();
    void aViewThatTheFirstProgramLostIsOffered();
};

void OldSessionsTest::sessionsAreReadToTheLetter_data()
{
    QTest::addColumn<QString>("name");
    for (const QString& name : QDir(oldSessionsFolder).entryList({"*.tansession"}, QDir::Files))
        QTest::newRow(qPrintable(name)) << name;
}

void OldSessionsTest::sessionsAreReadToTheLetter()
{
    QFETCH(QString, name);
    const std::map<QString, SessionDocument> expected = {{"first.tansession", firstDocument()},
                                                         {"with_film.tansession", documentWithFilm()},
                                                         {"with_domain.tansession", documentWithDomain()}};
    QVERIFY(expected.contains(name));
    const auto text = readTextFile(oldSessionsFolder / name.toStdString());
    QVERIFY(text.ok());
    const auto read = sessionFromText(*text, "/data");
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    compareDocuments(*read, expected.at(name));
    // And when it is saved by this program.
    const auto again = sessionFromText(sessionToText(*read, "/data"), "/data");
    QVERIFY(again.ok());
    compareDocuments(*again, expected.at(name));
}

/// That one kept its sessions in a folder 'recovery', where the views are beside now.
void OldSessionsTest::aViewThatTheFirstProgramLostIsOffered()
{
    const QTemporaryDir home;
    const std::filesystem::path views = home.filePath("views").toStdString();
    const QString left = home.filePath(QString("recovery/") + lostView + ".tansession");
    QVERIFY(QDir(home.path()).mkdir("recovery"));
    QVERIFY(QFile::copy(QString::fromStdString((oldSessionsFolder / "recovery" / lostView).string()) + ".tansession",
                        left));
    {
        QLockFile running(left + ".lock");
        QVERIFY(running.tryLock());
        QVERIFY(KeptViews(views).lost().empty());
        QVERIFY(QFile::exists(left));
    }
    for (int start = 0; start < 2; ++start) { // it is offered until it is restored or declined
        const std::vector<LostView> lost = KeptViews(views).lost();
        QCOMPARE(lost.size(), std::size_t(1));
        compareDocuments(lost.front().document, firstDocument());
        QCOMPARE(lost.front().path.parent_path(), views);
    }
    const KeptViews kept(views);
    kept.removeLost(kept.lost().front().path);
    QVERIFY(kept.lost().empty());
    QVERIFY(QDir(home.filePath("recovery")).isEmpty());
}

QTEST_GUILESS_MAIN(OldSessionsTest)
#include "old_sessions_test.moc"
