// SPDX-License-Identifier: GPL-3.0-or-later
// R10, R25: what a history's meshes are is seen in them, not in who made them: foci are found in models whose meshes
// are not Delaunay, too, and damage is told from that.
#include "core/history/query/region_refiner.h"
#include "core/verify/verify_mesh.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/lattice_models.h"
#include "tests/core/history/query/split_model.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class OtherBuildersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        dataset_ = randomLattice(LatticeKind::Smooth, {6, 7, 6}, 2);
        model_ = splitModel(dataset_, folder() / "split.tan");
        const auto verdict = verify(*model_, dataset_, {{5}, {0}});
        QVERIFY2(verdict->ok(), verdict->failures.empty() ? "a level" : verdict->failures[0].c_str());
        QVERIFY(RegionRefiner::fits(*model_));
        query_.error = SpaceRamp{Sphere{dataset_.lattice.bounds().center(), 0.8}, 0, 20, 0};
    }

    void theAutomaticChoiceTakesClosedSets()
    {
        MeshExtractor extractor(model_);
        for (int round = 0; round < 2; ++round) {
            const auto mesh = extractor.extract(query_);
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QCOMPARE((*mesh)->method, VariableMethod::ClosedSet);
            QVERIFY(verifyMesh(*model_, dataset_, query_, **mesh)->ok());
        }
    }

    void insertionIsRefused()
    {
        MeshQuery query = query_;
        query.method = VariableMethod::Insertion;
        const auto mesh = MeshExtractor(model_).extract(query);
        QVERIFY(!mesh.ok());
        QCOMPARE(mesh.error().kind, ErrorKind::WrongUsage);
    }

    /// A coarse mesh that does not fit together is damaged, whatever the builder.
    void damageIsNotHidden()
    {
        FileParts parts(readBytes(model_->path()));
        const auto others = parts.elements<std::array<std::uint32_t, 3>>(format::SectionId::OtherSites);
        std::swap(others[0][0], others[0][1]); // inverted
        parts.repairChecksums();
        writeBytes(folder() / "damaged.tan", parts.content);
        MeshQuery query = query_;
        query.error = SpaceRamp{Sphere{dataset_.lattice.bounds().center(), 0.8}, 0, 100, 0};
        const auto mesh = MeshExtractor(Model::open(folder() / "damaged.tan").value()).extract(query);
        QVERIFY(!mesh.ok());
        QCOMPARE(mesh.error().kind, ErrorKind::BadInput);
        QVERIFY(mesh.error().text().find("damaged") != std::string::npos);
    }

private:
    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    QTemporaryDir folder_;
    Dataset dataset_;
    std::shared_ptr<const Model> model_;
    MeshQuery query_;
};

QTEST_GUILESS_MAIN(OtherBuildersTest)
#include "other_builders_test.moc"
