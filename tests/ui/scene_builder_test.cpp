// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_files.h"
#include "ui/session/scene_builder.h"

#include <tan/query.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

/// From the session's wishes to a scene, in a worker (R17, R19).
class SceneBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theNewestRequestIsTheLastToArrive();
    void theMeshIsExtractedOnlyWhenItChanges();
    void nothingArrivesAfterClear();
    void aFailureIsTold();

private:
    SceneRequest request(double percent, std::vector<Isovalue> isovalues) const;

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    std::shared_ptr<const Model> model_;
};

void SceneBuilderTest::initTestCase()
{
    host_ = hostOfThisBuild();
    const auto model = Model::open(buildSampleModel(*host_, sampleDataset(32), folder_.path().toStdString()));
    QVERIFY(model.ok());
    model_ = *model;
}

SceneRequest SceneBuilderTest::request(double percent, std::vector<Isovalue> isovalues) const
{
    SceneRequest request;
    request.model = model_;
    request.renderer = host_->renderer("isosurface")->plugin;
    request.query.error = percent;
    request.values["isovalues"] = std::move(isovalues);
    return request;
}

void SceneBuilderTest::theNewestRequestIsTheLastToArrive()
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    for (const double percent : {4.0, 2.0, 1.0, 0.5, 0.1})
        builder.request(request(percent, {Isovalue{100}}));
    QVERIFY(builder.busy());
    QTRY_VERIFY(!builder.busy());
    const auto last = ready.last()[0].value<BuiltScene>();
    const MeshSize wanted = meshSizeAt(*model_, {0.1});
    QCOMPARE(last.mesh.vertices, std::uint64_t{wanted.sites});
    QCOMPARE(last.mesh.tetrahedra, wanted.tetrahedra);
    QCOMPARE(last.mesh.wholeTetrahedra, wanted.tetrahedra);
    QVERIFY(last.triangles > 0);
    QCOMPARE(last.scene->surfaces.size(), std::size_t{1});
    // The first had begun when the others came, of which only the last is of interest still.
    QVERIFY2(ready.count() <= 2, qPrintable(QString::number(ready.count())));
}

void SceneBuilderTest::theMeshIsExtractedOnlyWhenItChanges()
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    builder.request(request(1, {Isovalue{100}}));
    QTRY_COMPARE(ready.count(), 1);
    QVERIFY(ready.last()[0].value<BuiltScene>().extractionSeconds > 0);
    builder.request(request(1, {Isovalue{100}, Isovalue{150}}));
    QTRY_COMPARE(ready.count(), 2);
    QCOMPARE(ready.last()[0].value<BuiltScene>().extractionSeconds, 0.0);
    QCOMPARE(ready.last()[0].value<BuiltScene>().scene->surfaces.size(), std::size_t{2});
}

void SceneBuilderTest::nothingArrivesAfterClear()
{
    SceneBuilder builder;
    QSignalSpy ready(&builder, &SceneBuilder::sceneReady);
    builder.request(request(0.1, {Isovalue{100}}));
    builder.clear();
    QVERIFY(!builder.busy());
    builder.request(request(1, {Isovalue{100}}));
    QTRY_VERIFY(!builder.busy());
    QCOMPARE(ready.count(), 1);
    QCOMPARE(ready.last()[0].value<BuiltScene>().mesh.wholeSites, meshSizeAt(*model_, {1}).sites);
}

void SceneBuilderTest::aFailureIsTold()
{
    SceneBuilder builder;
    QSignalSpy failed(&builder, &SceneBuilder::failed);
    Isovalue wrong;
    wrong.opacity = 7;
    builder.request(request(1, {wrong}));
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(!builder.busy());
    QVERIFY(!failed.last()[0].value<Error>().text().empty());
}

QTEST_GUILESS_MAIN(SceneBuilderTest)
#include "scene_builder_test.moc"
