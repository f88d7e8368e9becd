// SPDX-License-Identifier: GPL-3.0-or-later
// Where sites lie.
#include "core/history/site_positions.h"

#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/some_models.h"

#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class SitePlacesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        models_ = someModels(folder_.path().toStdString());
        QVERIFY(!models_.empty());
    }

    void aPrefixIsWhereItsSitesAre()
    {
        for (const auto& [name, model] : models_)
            for (const std::uint32_t sites : {0u, 1u, model->siteCount() / 2, model->siteCount()}) {
                Buffer<Eigen::Vector3d> positions(3);
                QVERIFY(placeSites(*model, sites, positions).ok());
                QCOMPARE(positions.size(), std::size_t(sites));
                for (std::uint32_t site = 0; site < sites; ++site)
                    QVERIFY2(positions[site] == model->position(site), name.c_str());
            }
    }

    void pointsOutsideTheLatticeAreAnError()
    {
        const std::filesystem::path path = folder_.filePath("damaged.tan").toStdString();
        FileParts parts(readBytes(models_.front().model->path()));
        parts.elements<std::uint32_t>(format::SectionId::SitePoints)[12] = 7 * 6 * 5;
        parts.repairChecksums();
        writeBytes(path, parts.content);
        const auto model = Model::open(path);
        QVERIFY(model.ok());
        Buffer<Eigen::Vector3d> positions;
        QVERIFY(placeSites(**model, 12, positions).ok());
        QVERIFY(!placeSites(**model, 13, positions).ok());
    }

    void onlyLeftHandedTetrahedraAreTurned()
    {
        for (const auto& [name, model] : models_) {
            std::vector<std::array<std::uint32_t, 4>> tetrahedra = {{1, 2, 3, 4}};
            turnToPhysicalSpace(*model, tetrahedra);
            QCOMPARE(tetrahedra[0] == (std::array<std::uint32_t, 4>{1, 2, 4, 3}), name == "mirrored");
        }
    }

private:
    QTemporaryDir folder_;
    std::vector<SomeModel> models_;
};

QTEST_GUILESS_MAIN(SitePlacesTest)
#include "site_places_test.moc"
