// SPDX-License-Identifier: GPL-3.0-or-later
// A look goes to another model: in the window that opens a session whose model was built anew or that takes over the
// look of another session, and in `tan render`. Values and colours stay, the camera, too, where the domain is the same,
// and what does not is named.
#include "core/picture/text_file.h"
#include "tests/app/program.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

#include "core/picture/session_model.h"

#include <QFileDialog>
#include <QJsonArray>
#include <QPushButton>
#include <QSettings>

using namespace tetra;

class RestoredViewTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theNextStepIsSeenAlike();
    void whatAnotherModelCannotHaveIsNamed();
    void aSessionThatLostSomethingStaysAsItIs();
    void theLookOfASessionIsTakenOver();
    void theLookOfAnotherArrayIsSpread();
    void aKeptViewMayLackDirections();
    void aModelIsLocated();
    void theProgramTakesALook();
    void theProgramSaysWhatDiffers();
    void theProgramNamesToolsThatAreNotThere();
    void theProgramIsStrict();
    void theProgramDrawsABookmark();
    void theProgramFindsAMovedModel();

private:
    Session& session() const { return window_->workbench.session(); }
    QString path(const QString& name) const { return folder_.filePath(name); }
    /// A model of x + y + z on a lattice of so many points along x, times `factor`; other than 0, `mirrored` is where
    /// its first point lies, from which x falls.
    QString build(const QString& name, float factor, std::uint32_t sizeX = 8, double mirrored = 0,
                  const std::string& array = {}) const;
    void open(const QString& file) const;
    /// The session of a model with two isovalues, a transfer function, a camera, a window and a clip plane of their
    /// own.
    QString saveLook(const QString& name, const QString& model) const;
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }
    Run render(const QStringList& words) const
    {
        return tan(QStringList{"render"} + words + QStringList{"--size", "40x30", "--json", "-o", "picture.png"});
    }

    QTemporaryDir folder_;
    std::unique_ptr<WindowFixture> window_;
};

namespace {

constexpr double firstIsovalue = 0.6, secondIsovalue = 0.9;

QStringList differencesOf(const Run& run)
{
    QStringList parts;
    for (const QJsonValue& part : run.json()["session_differs"].toArray())
        parts << part.toString();
    return parts;
}

} // namespace

void RestoredViewTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("restored view");
    QLocale::setDefault(QLocale::c());
}

void RestoredViewTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void RestoredViewTest::cleanup()
{
    window_.reset();
}

QString RestoredViewTest::build(const QString& name, float factor, std::uint32_t sizeX, double mirrored,
                                const std::string& array) const
{
    constexpr std::uint32_t size = 8;
    Dataset dataset = sampleDataset(size);
    dataset.lattice.size[0] = sizeX;
    dataset.lattice.origin[0] = mirrored;
    if (mirrored != 0)
        dataset.lattice.directions(0, 0) = -1;
    std::vector<float> values;
    for (std::uint32_t z = 0; z < size; ++z)
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < sizeX; ++x)
                values.push_back(factor * static_cast<float>(x % size + y + z) / (3 * (size - 1)));
    dataset.values = ScalarField::of(std::move(values));
    dataset.source.hash = contentHash(dataset.values, nullptr);
    dataset.source.valueName = array;
    const auto model = buildSampleModel(*window_->host, dataset, folder_.path().toStdString());
    std::filesystem::create_directories(filePath(path(name)).parent_path());
    std::filesystem::rename(model, filePath(path(name)));
    return path(name);
}

void RestoredViewTest::open(const QString& file) const
{
    const auto before = session().model();
    window_->window.open(file);
    QTRY_VERIFY(session().model() && session().model() != before && window_->settled());
}

QString RestoredViewTest::saveLook(const QString& name, const QString& model) const
{
    open(model);
    ViewValue view = session().view();
    view.isovalues = {{firstIsovalue, 1, 0, 0, 1, true}, {secondIsovalue, 0, 0, 1, 0.5F, true}};
    view.appearance.transfer = transferFunctionFromPoints({{0.2, {1, 0, 0}, 0}, {0.8, {0, 1, 0}, 0.5F}}, 2);
    view.appearance.settings["clip"] = std::string("1,0,0,2");
    view.appearance.settings["slices"] = std::string("z=2");
    view.camera.azimuth = 100;
    view.camera.distance = 15.5;
    view.query.window = {true, {{{1, 1, 1}, {7, 6, 6}}, WindowBorder::Clipped}};
    view.background = Colour{0, 0.5F, 0};
    session().setView(view);
    bool isSaved = false;
    window_->workbench.opening().sessionFile().save(filePath(path(name)),
                                                    *window_->workbench.opening().sessions().document(),
                                                    [&](bool saved) { isSaved = saved; });
    if (!waitFor([&] { return isSaved; }))
        qFatal("the session is not saved");
    window_->find<QAction>("action.close").trigger();
    return path(name);
}

/// Of the same domain and of nearly the same range, as the next step of a computation is.
void RestoredViewTest::theNextStepIsSeenAlike()
{
    const QString model = build("step.tan", 1);
    const QString look = saveLook("step.tansession", model);
    build("step.tan", 1.02F);
    open(look);
    const ViewValue& view = session().view();
    QCOMPARE(view.isovalues.size(), std::size_t(2));
    QCOMPARE(view.isovalues[0], (Isovalue{firstIsovalue, 1, 0, 0, 1, true}));
    QVERIFY(view.appearance.transfer == transferFunctionFromPoints({{0.2, {1, 0, 0}, 0}, {0.8, {0, 1, 0}, 0.5F}}, 2));
    QCOMPARE(view.camera.azimuth, 100.0);
    QCOMPARE(view.camera.distance, 15.5);
    QVERIFY(view.query.window.enabled);
    QVERIFY(view.query.window.window.box.largest == Eigen::Vector3d(7, 6, 6));
    QCOMPARE(window_->messages().size(), 1); // that it is another one
    QVERIFY2(window_->messages().first().contains("has changed since"), qPrintable(window_->messages().first()));
    QCOMPARE(window_->workbench.opening().sessionFile().path(), filePath(look)); // nothing was lost
}

void RestoredViewTest::whatAnotherModelCannotHaveIsNamed()
{
    const QString model = build("other.tan", 1);
    const QString look = saveLook("other.tansession", model);
    build("other.tan", 0.8F, 6); // a shorter domain without one of the isovalues
    open(look);
    const ViewValue& view = session().view();
    QCOMPARE(view.isovalues.size(), std::size_t(1));
    QCOMPARE(view.isovalues[0].value, firstIsovalue);
    QCOMPARE(view.camera.azimuth, 100.0); // from the same direction
    QCOMPARE(view.camera, fitted(view.camera, session().model()->description().bounds, session().shape()));
    QVERIFY(!view.query.window.enabled && !view.appearance.settings.contains("clip") &&
            !view.appearance.settings.contains("slices"));
    QVERIFY(view.background == (Colour{0, 0.5F, 0}));
    QCOMPARE(window_->messages().size(), 1);
    const QString told = window_->messages().first();
    for (const char* named : {"1 of 2 isovalues", "camera", "crop box", "clipped", "slices", "other.tansession"})
        QVERIFY2(told.contains(named), qPrintable(told));
}

/// Saving does not put what is left of the look in the place of all of it.
void RestoredViewTest::aSessionThatLostSomethingStaysAsItIs()
{
    const QString model = build("kept.tan", 1);
    const QString look = saveLook("kept.tansession", model);
    const auto before = readTextFile(filePath(look));
    build("kept.tan", 0.8F, 6);
    open(look);
    session().setError(3);
    QVERIFY(!window_->window.isWindowModified());
    window_->find<QAction>("action.saveSession").trigger();
    auto& dialog = window_->find<QFileDialog>("sessionDialog");
    QVERIFY(dialog.isVisible()); // for another file
    dialog.reject();
    QVERIFY(before && *readTextFile(filePath(look)) == *before);
}

/// What was said of the speed is not said of the pressure, and its colours are those of the same shares of the range.
void RestoredViewTest::theLookOfAnotherArrayIsSpread()
{
    const QString model = build("speed.tan", 1, 8, 0, "speed");
    saveLook("speed.tansession", model);
    open(path("speed.tansession"));
    ViewValue named = session().view();
    named.annotations.title = "Speed";
    named.annotations.quantity = "Speed";
    named.annotations.unit = "m/s";
    named.annotations.barEnds = BarEnds{0, 2};
    named.query.values = {true, 0.25, 0.5};
    named = withBookmark(named, "one");
    session().setView(named);
    bool isSaved = false;
    window_->workbench.opening().sessionFile().save(filePath(path("speed.tansession")),
                                                    *window_->workbench.opening().sessions().document(),
                                                    [&](bool saved) { isSaved = saved; });
    QTRY_VERIFY(isSaved);
    build("pressure.tan", 10, 8, 0, "pressure");
    const Run run = render({"speed.tansession", "--model", "pressure.tan"});
    QVERIFY2(run.exitCode == 0, run.messages);
    QCOMPARE(differencesOf(run), QStringList{"annotations"});
    QVERIFY2(run.messages.contains("'speed'") && run.messages.contains("'pressure'"), run.messages);
    build("step.tan", 10, 8, 0, "speed"); // of the same array nothing is moved
    QCOMPARE(differencesOf(render({"speed.tansession", "--model", "step.tan"})), QStringList());

    open(path("pressure.tan"));
    window_->workbench.opening().sessions().applyLook(filePath(path("speed.tansession")));
    QTRY_COMPARE(session().undoStack().count(), 1);
    const ViewValue& view = session().view();
    QCOMPARE(view.isovalues[0].value, 10 * firstIsovalue);
    QCOMPARE(view.isovalues[1].value, 10 * secondIsovalue);
    QCOMPARE(view.appearance.transfer.opacities.front().value, 2.0);
    QCOMPARE(view.appearance.transfer.opacities.back().value, 8.0);
    QCOMPARE(view.query.values.largest, 5.0);
    QVERIFY(view.annotations.title.empty() && view.annotations.quantity.empty() && view.annotations.unit.empty() &&
            !view.annotations.barEnds);
    QCOMPARE(view.camera.azimuth, 100.0);
    QCOMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains("'speed'"), qPrintable(window_->messages().first()));
}

void RestoredViewTest::theLookOfASessionIsTakenOver()
{
    const QString look = saveLook("look.tansession", build("look.tan", 1));
    open(build("target.tan", 1.1F));
    const ViewValue start = session().view();
    window_->find<QAction>("action.applyLook").trigger();
    auto& dialog = window_->find<QFileDialog>("lookDialog");
    emit dialog.fileSelected(look);
    dialog.reject();
    QTRY_COMPARE(session().undoStack().count(), 1);
    QCOMPARE(session().view().isovalues.size(), std::size_t(2));
    QCOMPARE(session().view().camera.distance, 15.5);
    QCOMPARE(session().model()->path(), filePath(path("target.tan")));
    QCOMPARE(window_->messages(), QStringList());
    QVERIFY(window_->workbench.opening().sessionFile().path().empty());
    session().undoStack().undo();
    QVERIFY(session().view() == start);

    open(build("small.tan", 0.8F, 6));
    ViewValue measured = session().view();
    measured.tools["ruler"] = "0,0,0 1,1,1";
    session().setView(measured);
    window_->workbench.opening().sessions().applyLook(filePath(look));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains("1 of 2 isovalues"), qPrintable(window_->messages().first()));
    QCOMPARE(session().view().camera.azimuth, 100.0);
    QVERIFY(session().view().tools == measured.tools); // what was measured in these data
}

/// What was kept of a model that was built before directions were read is not taken for one of the same places, even if
/// they fill the same box.
void RestoredViewTest::aKeptViewMayLackDirections()
{
    for (const double first : {7.0, 7.5}) {
        const QString model = build("again.tan", 1);
        open(model);
        ViewValue view = session().view();
        view.query.window = {true, {{{1, 1, 1}, {7, 6, 6}}, WindowBorder::Clipped}};
        session().setView(view);
        window_->find<QAction>("action.close").trigger();
        QTRY_VERIFY(window_->workbench.opening().views().idle());
        build("again.tan", 1, 8, first);
        open(model);
        QVERIFY(!session().view().query.window.enabled);
        QTRY_COMPARE(window_->messages().size(), 1);
        QVERIFY2(window_->messages().last().contains("TAn up to version 0.1"), qPrintable(window_->messages().last()));
        window_->find<QAction>("action.close").trigger();
        QTRY_VERIFY(window_->workbench.opening().views().idle());
        open(model); // as it was seen since
        QCOMPARE(window_->messages(), QStringList());
        window_->find<QAction>("action.close").trigger();
        QTRY_VERIFY(window_->workbench.opening().views().idle());
        QVERIFY(QFile::remove(model));
        window_->workbench.opening().views().forget(filePath(model));
    }
}

void RestoredViewTest::aModelIsLocated()
{
    const QString look = saveLook("lost.tansession", build("lost.tan", 1));
    QVERIFY(QDir(folder_.path()).mkpath("far/away"));
    QVERIFY(QFile::rename(path("lost.tan"), path("far/away/renamed.tan")));
    window_->window.open(look);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains("lost.tan"), qPrintable(window_->messages().first()));
    window_->find<QPushButton>("message.answer").click();
    auto& dialog = window_->find<QFileDialog>("locateDialog");
    emit dialog.fileSelected(path("far/away/renamed.tan"));
    dialog.reject();
    QTRY_VERIFY(session().model() != nullptr);
    QCOMPARE(session().view().camera.distance, 15.5);
    QCOMPARE(window_->workbench.opening().sessionFile().path(), filePath(look));
    QVERIFY(window_->window.isWindowModified()); // the file says another place
    window_->find<QAction>("action.saveSession").trigger();
    QTRY_VERIFY(!window_->window.isWindowModified());
    QTRY_VERIFY(!window_->workbench.opening().sessionFile().saving().running());
    QCOMPARE(readSession(filePath(look))->model, filePath(path("far/away/renamed.tan")));
}

void RestoredViewTest::theProgramTakesALook()
{
    saveLook("first.tansession", build("first.tan", 1));
    build("second.tan", 1.02F);
    const Run run = render({"first.tansession", "--model", "second.tan", "--strict"});
    QVERIFY2(run.exitCode == 0, run.messages);
    QCOMPARE(differencesOf(run), QStringList());
    QVERIFY2(run.messages.isEmpty(), run.messages);
    QVERIFY(run.json()["triangles"].toInt() > 0);
    // It is the picture of the session, as far as the values go.
    QVERIFY(render({"first.tansession"}).json()["triangles"].toInt() != run.json()["triangles"].toInt());
    for (const char* option : {"--model", "--strict"}) {
        const QStringList words =
            option == std::string("--model") ? QStringList{option, "first.tan"} : QStringList{option};
        const Run refused = render(QStringList{"second.tan"} + words);
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains(option), refused.messages);
    }
}

void RestoredViewTest::theProgramSaysWhatDiffers()
{
    saveLook("before.tansession", build("before.tan", 1));
    QCOMPARE(differencesOf(render({"before.tansession"})), QStringList());
    build("before.tan", 1.02F);
    const Run anew = render({"before.tansession"});
    QCOMPARE(differencesOf(anew), QStringList{"model"});
    QVERIFY2(anew.messages.contains("has changed since"), anew.messages);
    build("smaller.tan", 0.8F, 6);
    const Run other = render({"before.tansession", "--model", "smaller.tan"});
    QVERIFY2(other.exitCode == 0, other.messages);
    QCOMPARE(differencesOf(other), (QStringList{"camera", "window", "clip", "slices", "isovalues"}));
    QVERIFY2(other.messages.contains("1 of 2 isovalues"), other.messages);
    QVERIFY(!render({"smaller.tan"}).json().contains("session_differs"));
    // Its places are within those of the other model, and not the same.
    build("directed.tan", 1, 8, 7.5);
    const Run directed = render({"before.tansession", "--model", "directed.tan"});
    QCOMPARE(differencesOf(directed), (QStringList{"camera", "window", "clip", "slices"}));
    QVERIFY2(directed.messages.contains("TAn up to version 0.1"), directed.messages);
    // One of a series that has none of the values: no other surface takes the place of theirs.
    build("faint.tan", 0.01F);
    const Run faint = render({"before.tansession", "--model", "faint.tan"});
    QVERIFY2(faint.exitCode == 0, faint.messages);
    QVERIFY(differencesOf(faint).contains("isovalues"));
    QVERIFY2(faint.messages.contains("so their surfaces are empty"), faint.messages);
    QCOMPARE(faint.json()["triangles"].toInt(-1), 0);
}

void RestoredViewTest::theProgramNamesToolsThatAreNotThere()
{
    const QString session = saveLook("measured.tansession", build("measured.tan", 1));
    QFile file(session);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray text = file.readAll();
    text.replace(text.indexOf('{'), 1, R"({"tools": {"ruler": "0,0,0 1,1,1", "example.gone": "kept"},)");
    QVERIFY(file.resize(0) && file.seek(0) && file.write(text) == text.size());
    file.close();
    const Run run = render({"measured.tansession"});
    QVERIFY2(run.exitCode == 0, run.messages);
    QCOMPARE(differencesOf(run), QStringList{"tools"});
    QVERIFY2(run.messages.contains("'example.gone'") && !run.messages.contains("ruler"), run.messages);
    QCOMPARE(render({"measured.tansession", "--strict"}).exitCode, 3);
}

void RestoredViewTest::theProgramIsStrict()
{
    saveLook("strict.tansession", build("strict.tan", 1));
    QCOMPARE(render({"strict.tansession", "--strict"}).exitCode, 0);
    QVERIFY(QFile::remove(path("picture.png")));
    build("unlike.tan", 0.8F, 6);
    const Run run = render({"strict.tansession", "--model", "unlike.tan", "--strict"});
    QCOMPARE(run.exitCode, 3);
    QVERIFY2(run.messages.contains("isovalues") && run.messages.contains("--strict"), run.messages);
    build("strict.tan", 1.02F);
    QCOMPARE(render({"strict.tansession", "--strict"}).exitCode, 3);
    QVERIFY(!QFile::exists(path("picture.png")));
}

/// Of another model's bookmarks those are told that are not what they were.
void RestoredViewTest::theProgramDrawsABookmark()
{
    const QString model = build("marked.tan", 1);
    saveLook("marked.tansession", model);
    open(path("marked.tansession"));
    ViewValue view = session().view();
    view = withBookmark(view, "as saved");
    view.isovalues = {{0.3, 1, 0, 0, 1, true}};
    view.appearance.settings.erase("clip");
    view.appearance.settings.erase("slices");
    view.query.window.enabled = false;
    session().setView(withBookmark(view, "plain"));
    bool isSaved = false;
    window_->workbench.opening().sessionFile().save(filePath(path("marked.tansession")),
                                                    *window_->workbench.opening().sessions().document(),
                                                    [&](bool saved) { isSaved = saved; });
    QTRY_VERIFY(isSaved);
    const auto pictureOf = [this](const QStringList& words) {
        const Run run = render(QStringList{"marked.tansession"} + words);
        QFile file(path("picture.png"));
        return run.exitCode == 0 && file.open(QIODevice::ReadOnly) ? file.readAll() : run.messages;
    };
    const QByteArray seen = pictureOf({}), saved = pictureOf({"--bookmark", "as saved"});
    QVERIFY(seen.startsWith("\x89PNG") && saved.startsWith("\x89PNG"));
    QVERIFY(QImage::fromData(seen) != QImage::fromData(saved));
    QCOMPARE(QImage::fromData(pictureOf({"--bookmark", "plain"})), QImage::fromData(seen));
    const Run unknown = render({"marked.tansession", "--bookmark", "other"});
    QCOMPARE(unknown.exitCode, 2);
    QVERIFY2(unknown.messages.contains("'as saved', 'plain'"), unknown.messages);
    QCOMPARE(render({model, "--bookmark", "plain"}).exitCode, 2);
    build("shorter.tan", 0.8F, 6);
    QVERIFY(differencesOf(render({"marked.tansession", "--model", "shorter.tan"})).contains("camera"));
    window_->find<QAction>("action.close").trigger();
    build("marked.tan", 0.8F, 6);
    open(path("marked.tansession"));
    QCOMPARE(session().view().bookmarks.size(), std::size_t(2));
    QVERIFY2(window_->messages().first().contains("2 of 2 bookmarks"), qPrintable(window_->messages().join('\n')));
    QVERIFY(session().view().bookmarks[0].view.isovalues.size() < view.bookmarks[0].view.isovalues.size());
}

void RestoredViewTest::theProgramFindsAMovedModel()
{
    build("project/data/m.tan", 1);
    QVERIFY(QDir(folder_.path()).mkpath("project/looks"));
    saveLook("project/looks/one.tansession", path("project/data/m.tan"));
    QVERIFY(QFile::rename(path("project"), path("moved")));
    QCOMPARE(render({"moved/looks/one.tansession", "--strict"}).exitCode, 0);
    QVERIFY(QFile::remove(path("moved/data/m.tan")));
    const Run gone = render({"moved/looks/one.tansession"});
    QCOMPARE(gone.exitCode, 3);
    QVERIFY2(gone.messages.contains("m.tan") && gone.messages.contains("--model"), gone.messages);
}

QTEST_MAIN(RestoredViewTest)
#include "restored_view_test.moc"
