// SPDX-License-Identifier: GPL-3.0-or-later
// The window's mode that blends a focus (R24).
#include "tests/core/render/scene_parts.h"
#include "tests/ui/window_fixture.h"

#include <tan/query.h>

#include <QFile>
#include <QSignalSpy>

using namespace tetra;

class FocusModeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aFocusIsBlendedInItsMode();
    void aBlendedFocusIsSavedAsOneMesh();

private:
    Session& session() const { return window_->workbench.session(); }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void FocusModeTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("focus mode");
    QSettings().clear();
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(16), folder_.path().toStdString()).string());
}

void FocusModeTest::init()
{
    window_ = std::make_unique<WindowFixture>();
    window_->window.resize(700, 500);
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
}

void FocusModeTest::cleanup()
{
    window_.reset();
}

void FocusModeTest::aFocusIsBlendedInItsMode()
{
    window_->find<QAction>("action.mode.focus").trigger();
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).volume);
    QVERIFY(!testing::partsOf(*window_->viewport().scene()).focus);
    FocusState focus = session().view().query.focus;
    focus.shape = FocusState::Shape::Sphere;
    focus.falloff = 1.5;
    session().setFocus(focus);
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).focus);
    const testing::FinePart shown = *testing::partsOf(*window_->viewport().scene()).focus;
    QCOMPARE(shown.border, 1.5);
    QCOMPARE(std::get<Sphere>(shown.region).radius, session().view().query.focus.radius);
    // C5: isosurfaces of both meshes, too.
    session().setSetting("shows", std::string("both"));
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).surfaces.size() == 2);
    const testing::SceneParts both = testing::partsOf(*window_->viewport().scene());
    QVERIFY(both.focus && !both.surfaces[0].share->fine && both.surfaces[1].share->fine);
    session().setSetting("shows", std::string("volume"));
    focus = session().view().query.focus;
    focus.others = {Sphere{focus.centre + Eigen::Vector3d(1, 2, 3), 2}};
    session().setFocus(focus);
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).focus->more.size() == 1);
    focus = session().view().query.focus;
    focus.others.clear();
    session().setFocus(focus);
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).focus->more.empty());
    focus = session().view().query.focus;
    focus.shape = FocusState::Shape::Box;
    session().setFocus(focus);
    QTRY_VERIFY(window_->settled() &&
                std::holds_alternative<Box>(testing::partsOf(*window_->viewport().scene()).focus->region));
    window_->find<QAction>("action.mode.volume").trigger();
    QTRY_VERIFY(window_->settled() && !testing::partsOf(*window_->viewport().scene()).focus);
}

void FocusModeTest::aBlendedFocusIsSavedAsOneMesh()
{
    window_->find<QAction>("action.mode.focus").trigger();
    FocusState focus = session().view().query.focus;
    focus.shape = FocusState::Shape::Sphere;
    session().setFocus(focus);
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).focus);
    const auto asked = MeshExtractor(session().model()).extract(session().shown()->query);
    QVERIFY(asked.ok());
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    const QString path = folder_.filePath("focus.vtu");
    window_->workbench.exporting().saveMesh(path.toStdString());
    QTRY_COMPARE(saved.count(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString cells = QString("NumberOfCells=\"%1\"").arg((*asked)->mesh.tetrahedra.size());
    QVERIFY2(file.read(4096).contains(cells.toUtf8()), qPrintable(cells));
}

QTEST_MAIN(FocusModeTest)
#include "focus_mode_test.moc"
