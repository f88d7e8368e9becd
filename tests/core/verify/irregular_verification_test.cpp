// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of irregular models (B3, R4, R5, S12): what decimation makes is proved, and each kind of lie is found.
#include "core/decimate/lattice_tetrahedra.h"
#include "core/geometry/orientation.h"
#include "core/history/batch_builder.h"
#include "tests/core/data/cells/damaged_cells.h"
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/core/verify/slow_errors.h"
#include "tests/verdict_text.h"

#include <tan/data.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>
#include <limits>

using namespace tetra;

using testing::textOf;

namespace {

const std::vector<Accuracy> levels = {{100, anyWarping}, {30, 30}, {10, 10}, {3, 3}, {1, 1}, {0, 0}};

using Lie = std::function<void(FileParts&)>;
using Cube = std::array<std::uint32_t, 3>;
using Domain = std::function<bool(const Cube&)>;

/// Unit cubes, cut in five each, at those places of a grid of 4 x 4 x 3 that `holds`; points in the grid's order.
std::vector<std::array<std::uint32_t, 4>> cubes(const Domain& holds)
{
    std::vector<std::array<std::uint32_t, 4>> kept;
    const auto all = latticeTetrahedra({5, 5, 4}, LatticeCut::Five);
    for (std::uint32_t cube = 0; cube < 48; ++cube)
        if (holds(std::array{cube % 4, cube / 4 % 4, cube / 16}))
            kept.insert(kept.end(), all.begin() + 5 * cube, all.begin() + 5 * cube + 5);
    return kept;
}

/// The points that the tetrahedra use, in their order, with a value that is linear: no mesh of them has an error.
Dataset datasetOfCubes(const std::vector<std::array<std::uint32_t, 4>>& tetrahedra)
{
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) {
                positions.emplace_back(x, y, z);
                values.push_back(x + 2 * y - z);
            }
    return withoutUnused(datasetOfTetrahedra(positions, values, tetrahedra));
}

/// Cubes cut in five each, `n` along each edge of one of edge 1 with its first corner at `corner`, appended.
void addBlock(std::vector<Eigen::Vector3d>& positions, std::vector<std::array<std::uint32_t, 4>>& tetrahedra,
              std::uint32_t n, const Eigen::Vector3d& corner)
{
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (auto cell : latticeTetrahedra({n + 1, n + 1, n + 1}, LatticeCut::Five)) {
        for (std::uint32_t& point : cell)
            point += first;
        tetrahedra.push_back(cell);
    }
    for (std::uint32_t z = 0; z <= n; ++z)
        for (std::uint32_t y = 0; y <= n; ++y)
            for (std::uint32_t x = 0; x <= n; ++x)
                positions.emplace_back(corner + Eigen::Vector3d(x, y, z) / n);
}

/// Two blocks that were meshed apart and touch in the plane x = 1, where the values jump: 4 points of the first one lie
/// on faces of the second, and 9 of the second on faces of the first. Linear in each, but for one point of the contact.
Dataset blocksInContact()
{
    std::vector<Eigen::Vector3d> positions;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    addBlock(positions, tetrahedra, 2, {0, 0, 0});
    const std::size_t firstOfSecond = positions.size();
    addBlock(positions, tetrahedra, 3, {1, 0.1, 0.1});
    std::vector<double> values;
    for (std::size_t point = 0; point < positions.size(); ++point) {
        const Eigen::Vector3d& place = positions[point];
        values.push_back(point < firstOfSecond ? place.x() + 2 * place.y() : 5 - place.z());
        if (place == Eigen::Vector3d(1, 0.5, 0.5))
            values.back() += 0.5;
    }
    return datasetOfTetrahedra(positions, values, tetrahedra);
}

/// Whether a picture of the model's boundary and volume, coarse and fine, shows anything. Empty: all do.
QString pictureFault(const Model& model)
{
    for (const double error : {5.0, 0.0}) {
        auto extracted = extractPrefix(model, meshSizeAt(model, {error, anyWarping}).sites);
        if (!extracted)
            return QString::fromStdString(extracted.error().text());
        const auto mesh = std::make_shared<const TetrahedralMesh>(*std::move(extracted));
        const auto boundary = BoundaryCache(mesh).plain({.opacity = 0.5F});
        const TransferFunction function{
            .colours = {{-2, {0, 0, 1}}, {2, {1, 0.5F, 0}}}, .opacities = {{-2, 0.2F}, {2, 0.9F}}, .unitDistance = 1};
        const auto volume = VolumeCache(mesh).update(function, false);
        if (!boundary || !volume)
            return "no boundary or no volume";
        Scene scene;
        for (const Eigen::Vector3d& position : mesh->positions)
            scene.bounds.extend(position.cast<double>());
        scene.drawables.push_back({.id = "boundary", .shape = *boundary});
        scene.drawables.push_back({.id = "volume", .shape = *volume});
        const auto picture = makeCpuBackend()->render(scene, fitted({}, scene.bounds),
                                                      {.width = 48, .height = 48, .background = {0, 0, 0}});
        if (!picture)
            return QString::fromStdString(picture.error().text());
        if (std::ranges::count_if(picture->pixels, [](const auto& p) { return int(p[0]) + p[1] + p[2] > 60; }) < 300)
            return "the picture shows next to nothing";
    }
    return {};
}

/// A model whose only mesh are these tetrahedra of the grid, whatever the dataset's are.
RecordedSteps oneMesh(const Dataset& dataset, const std::vector<std::array<std::uint32_t, 4>>& tetrahedra)
{
    RecordedSteps history;
    history.traits = {1, false};
    history.finalKey = 0;
    history.steps.resize(dataset.pointCount());
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
        history.steps[point].point = point;
        history.steps[point].keyBefore = std::numeric_limits<float>::infinity();
    }
    for (auto sites : tetrahedra) {
        for (std::uint32_t& site : sites) { // numbers of the grid
            const Eigen::Vector3d place(site % 5, site / 5 % 5, site / 25);
            const auto found = std::ranges::find(*dataset.positions, place);
            if (found == dataset.positions->end())
                std::abort();
            site = static_cast<std::uint32_t>(found - dataset.positions->begin());
        }
        sites = latestFirst(sites);
        history.steps[sites[0]].star.push_back({{sites[1], sites[2], sites[3]}, 0, 0});
    }
    return history;
}

/// The blocks in contact by one mesh, which has of the first one the eight corners alone, and claims this error.
RecordedSteps withCoarseBlock(const Dataset& dataset, float claimed)
{
    RecordedSteps history;
    history.traits = {1, false};
    history.finalKey = claimed;
    std::vector<std::uint32_t> siteOf(dataset.pointCount());
    for (std::uint32_t point = 0; point < dataset.pointCount(); ++point) {
        const bool isCorner = point % 3 != 1 && point / 3 % 3 != 1 && point / 9 != 1;
        if (point >= 27 || isCorner) {
            siteOf[point] = static_cast<std::uint32_t>(history.steps.size());
            history.steps.push_back({point, std::numeric_limits<float>::infinity(), {}, {}});
        }
    }
    std::vector<std::array<std::uint32_t, 4>> cells;
    for (auto cell : latticeTetrahedra({2, 2, 2}, LatticeCut::Five)) {
        for (std::uint32_t& corner : cell)
            corner = siteOf[2 * (corner % 2) + 6 * (corner / 2 % 2) + 18 * (corner / 4)];
        cells.push_back(cell);
    }
    for (auto cell : *dataset.tetrahedra)
        if (std::ranges::all_of(cell, [](std::uint32_t point) { return point >= 27; })) {
            std::ranges::transform(cell, cell.begin(), [&](std::uint32_t point) { return siteOf[point]; });
            cells.push_back(cell);
        }
    for (const auto& cell : cells) {
        const auto sites = latestFirst(cell);
        history.steps[sites[0]].star.push_back({{sites[1], sites[2], sites[3]}, claimed, 0});
    }
    return history;
}

} // namespace

class IrregularVerificationTest : public QObject {
    Q_OBJECT

private slots:
    void decimatedModelsAreProved()
    {
        int coarser = 0;
        for (std::uint32_t seed = 0; seed < 40; ++seed) {
            const Dataset dataset = randomIrregular(seed);
            const auto model = modelOf(path(), dataset, decimated(dataset));
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(QString("seed %1\n").arg(seed) + textOf(verdict)));
            for (const LevelReport& level : verdict->levels) {
                QVERIFY(level.conforming && level.covers && level.inverted == 0);
                QVERIFY(level.twoSidedWarping && *level.twoSidedWarping <= level.twoSidedBound);
                QVERIFY(*level.twoSidedWarping >= level.measured.warping.largest);
                coarser += level.measured.warping.largest > 0 ? 1 : 0;
            }
            const LevelReport& finest = verdict->levels.back();
            QCOMPARE(finest.measured.error.largest, 0.0);
            QCOMPARE(finest.measured.warping.largest, 0.0);
            QCOMPARE(finest.twoSidedBound, 0.0);
        }
        QVERIFY(coarser > 40);
    }

    /// C10: meshes damaged at random in up to a thousandth of their cells, and with parts that only touch, are opened,
    /// built, verified at eight accuracies, and pictured. `./dev soak --only meshes` does so with many, and larger
    /// ones.
    void damagedMeshesAreProved()
    {
        const std::vector<Accuracy> eight = {{100, anyWarping}, {30, 30}, {10, 10}, {4, 4}, {2, 2}, {1, 1},
                                             {.2, .2},          {0, 0}};
        for (std::uint32_t seed = 0; seed < 3; ++seed) {
            const DamagedCells damaged(9, 1000 + seed);
            const auto dataset = irregularDataset(damaged.complex(), damaged.values(), {"damaged", {}, 0});
            const QString name = QString("seed %1\n").arg(seed);
            QVERIFY2(dataset.ok(), qPrintable(name + (dataset ? "" : dataset.error().text().c_str())));
            const auto model = modelOf(path(), *dataset, decimated(*dataset));
            const auto verdict = verify(*model, *dataset, eight);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(name + textOf(verdict)));
            QVERIFY2(pictureFault(*model).isEmpty(), qPrintable(name + pictureFault(*model)));
        }
    }

    /// C10: where the data touch themselves, in an edge, a point or with faces that do not fit together, a mesh may and
    /// must do so, and nowhere else.
    void touchingIsAsInTheData_data()
    {
        QTest::addColumn<Domain>("data");
        QTest::addColumn<Domain>("mesh");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const Domain& data, const Domain& mesh, const char* says) {
            QTest::newRow(name) << data << mesh << QString(says);
        };
        // All of the same points.
        const Domain block = [](const Cube& p) { return p[0] < 3 && p[1] < 3; };
        const Domain columns = [=](const Cube& p) { return block(p) && (p[0] + p[1]) % 2 == 0; };
        const Domain corners = [=](const Cube& p) { return block(p) && p[0] % 2 == p[1] % 2 && p[0] % 2 == p[2] % 2; };
        row("right: columns", columns, columns, "");
        row("right: corners", corners, corners, "");
        row("edges closed", columns, block, "and that of the mesh does not in the same way");
        row("edges made", block, columns, "which is not so in the data");
        row("corners closed", corners, block, "and that of the mesh does not in the same way");
        row("corners made", block, corners, "touches itself at point");
        row("edges for corners", corners, columns, "which is not so in the data");
    }
    void touchingIsAsInTheData()
    {
        QFETCH(Domain, data);
        QFETCH(Domain, mesh);
        QFETCH(QString, says);
        const Dataset dataset = datasetOfCubes(cubes(data));
        const auto model = modelOf(path(), dataset, oneMesh(dataset, cubes(mesh)));
        const auto verdict = verify(*model, dataset, {{0, 0}});
        const bool right = QString(QTest::currentDataTag()).startsWith("right");
        QVERIFY2(verdict.ok() && verdict->ok() == right, qPrintable(textOf(verdict)));
        QVERIFY2(textOf(verdict).contains(says), qPrintable(textOf(verdict)));
    }

    /// C11, S13: a model that says so keeps the distance from both sides; one built for a single side is found out.
    void twoSidesAreKept()
    {
        const std::vector<std::pair<std::string, std::string>> claim = {{"distance", "two-sided"}};
        int found = 0, fewer = 0;
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            const Dataset dataset = randomIrregular(seed);
            const auto model = modelOf(path(), dataset, decimated(dataset, {}, true), claim);
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(QString("seed %1\n").arg(seed) + textOf(verdict)));
            for (const LevelReport& level : verdict->levels)
                QVERIFY(*level.twoSidedWarping <= std::max(level.asked.warping, level.asked.error));
            const auto oneSided = modelOf(path(), dataset, decimated(dataset), claim);
            const auto refuted = verify(*oneSided, dataset, levels);
            QVERIFY(refuted.ok());
            found += textOf(refuted).contains("away from that of the data, more than the claimed") ? 1 : 0;
            fewer += refuted->levels[3].sites < verdict->levels[3].sites ? 1 : 0;
        }
        QVERIFY2(found > 2 && fewer > 2, qPrintable(QString("%1 found, %2 fewer").arg(found).arg(fewer)));
    }

    /// Points outside of the mesh are measured at the nearest place, too, whatever the claim: as looking at every
    /// tetrahedron and every face of the boundary finds it.
    void theErrorAtTheNearestPlaceIsMeasured()
    {
        std::uint64_t outside = 0;
        int larger = 0;
        for (std::uint32_t seed = 0; seed < 12; ++seed) {
            const Dataset dataset = randomIrregular(seed);
            const auto model = modelOf(path(), dataset, decimated(dataset));
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(QString("seed %1\n").arg(seed) + textOf(verdict)));
            for (const LevelReport& level : verdict->levels) {
                const testing::SlowErrors slow(dataset, *model, level.sites);
                const auto& atNearest = level.measured.errorAtNearest;
                QVERIFY2(atNearest && testing::areSame(*atNearest, slow.percents),
                         qPrintable(QString("seed %1, %2 %").arg(seed).arg(level.asked.error)));
                QVERIFY(atNearest->largest >= level.measured.error.largest);
                outside += level.measured.errorInSpace.outside;
                larger += atNearest->largest > 1.01 * level.measured.error.largest ? 1 : 0;
            }
        }
        QVERIFY2(outside > 100 && larger > 0, qPrintable(QString("%1 outside, %2 larger").arg(outside).arg(larger)));
    }

    /// Straight edges of the boundary that rounding bends: removed points of theirs lie outside, if only by rounding,
    /// and may count for a cell that has no more of the boundary than the edge.
    void edgesBentByRoundingAreProved()
    {
        const Eigen::Matrix3d turned = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) *
                                        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()))
                                           .toRotationMatrix();
        for (std::uint32_t seed = 0; seed < 120; seed += 3) { // these have no points moved about
            const Dataset straight = randomIrregular(seed);
            std::vector<Eigen::Vector3d> positions = *straight.positions;
            std::vector<double> values;
            for (std::size_t point = 0; point < positions.size(); ++point) {
                positions[point] = turned * positions[point];
                values.push_back(straight.values.at(point));
            }
            const Dataset dataset = datasetOfTetrahedra(std::move(positions), values, *straight.tetrahedra);
            const auto model = modelOf(path(), dataset, decimated(dataset));
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(QString("seed %1\n").arg(seed) + textOf(verdict)));
        }
    }

    /// A part that lies in a notch of another: the mesh in which the notch is filled holds it twice.
    void partsOnOneAnotherAreFound_data()
    {
        QTest::addColumn<double>("top");
        QTest::addColumn<QString>("says");
        QTest::newRow("inside") << 3.8 << "Cells lie on one another";
        QTest::newRow("through") << 4.5 << "The boundary meets itself";
        QTest::newRow("touching") << 4.0 << "The boundary meets itself";
    }
    void partsOnOneAnotherAreFound()
    {
        QFETCH(double, top);
        QFETCH(QString, says);
        const Domain notched = [](const Cube& p) { return !(p[0] == 1 && p[1] == 3 && p[2] == 1); };
        const Dataset block = datasetOfCubes(cubes(notched));
        std::vector<Eigen::Vector3d> positions = *block.positions;
        std::vector<std::array<std::uint32_t, 4>> tetrahedra = *block.tetrahedra;
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (const Eigen::Vector3d& place : {Eigen::Vector3d(1.3, 3.2, 1.3), Eigen::Vector3d(1.7, 3.2, 1.3),
                                             Eigen::Vector3d(1.5, 3.2, 1.7), Eigen::Vector3d(1.5, top, 1.5)})
            positions.push_back(place);
        tetrahedra.push_back({first, first + 2, first + 1, first + 3});
        std::vector<double> values;
        for (const Eigen::Vector3d& place : positions)
            values.push_back(place.sum());
        const Dataset dataset = datasetOfTetrahedra(positions, values, tetrahedra);
        for (const bool filled : {false, true}) {
            RecordedSteps history = oneMesh(dataset, filled ? cubes([](const Cube&) { return true; }) : cubes(notched));
            const auto sites = latestFirst({first, first + 2, first + 1, first + 3});
            history.steps[sites[0]].star.push_back({{sites[1], sites[2], sites[3]}, 0, 0});
            const auto verdict = verify(*modelOf(path(), dataset, history), dataset, {{0, 0}});
            QVERIFY2(verdict.ok() && verdict->ok() == !filled, qPrintable(textOf(verdict)));
            QVERIFY2(!filled || textOf(verdict).contains(says), qPrintable(textOf(verdict)));
        }
    }

    /// S12: decimation does not fill a notch over a part that lies in it, touching nothing or in an edge, though the
    /// boundaries would not meet.
    void partsInNotchesAreKept()
    {
        const Domain notched = [](const Cube& p) { return !(p[0] == 1 && p[1] == 3 && p[2] == 1); };
        for (const bool touching : {false, true}) {
            const Dataset block = datasetOfCubes(cubes(notched));
            std::vector<Eigen::Vector3d> positions = *block.positions;
            std::vector<std::array<std::uint32_t, 4>> tetrahedra = *block.tetrahedra;
            const auto first = static_cast<std::uint32_t>(positions.size());
            for (const Eigen::Vector3d& place : {Eigen::Vector3d(1.3, 3.2, 1.3), Eigen::Vector3d(1.7, 3.2, 1.3),
                                                 Eigen::Vector3d(1.5, 3.2, 1.7), Eigen::Vector3d(1.5, 3.8, 1.5)})
                positions.push_back(place);
            const auto number = [&](const Eigen::Vector3d& place) {
                return static_cast<std::uint32_t>(std::ranges::find(positions, place) - positions.begin());
            };
            tetrahedra.push_back({first, first + 2, first + 1, first + 3});
            if (touching) // in an edge of the notch's floor
                tetrahedra.back() = {number({1, 3, 1}), number({2, 3, 1}), first + 3, first + 2};
            if (orientation(positions, tetrahedra.back()) < 0)
                std::swap(tetrahedra.back()[2], tetrahedra.back()[3]);
            std::vector<double> values;
            for (const Eigen::Vector3d& place : positions)
                values.push_back(place.sum());
            const Dataset dataset = withoutUnused(datasetOfTetrahedra(positions, values, tetrahedra));
            const auto model = modelOf(path(), dataset, decimated(dataset));
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        }
    }

    /// What a site's tetrahedra stand on it must destroy, or closed sets have no mesh.
    void openFacesAreFound()
    {
        const Dataset dataset = randomIrregular(4);
        RecordedSteps history = decimated(dataset);
        const auto right = verify(*modelOf(path(), dataset, history), dataset, {});
        QVERIFY2(right.ok() && right->ok(), qPrintable(textOf(right)));
        const auto splits = std::ranges::find_if(
            history.steps, [](const RecordedSteps::Step& step) { return step.destroyed.size() > 1; });
        splits->destroyed.pop_back();
        const auto verdict = verify(*modelOf(path(), dataset, history), dataset, {});
        QVERIFY2(textOf(verdict).contains("not every closed set with it has a mesh"), qPrintable(textOf(verdict)));
    }

    /// At a contact that was meshed apart the data have two values at one place: none of them is an error of the mesh,
    /// but what is far from both is.
    void partsThatTouchHaveValuesOfTheirOwn()
    {
        const Dataset dataset = blocksInContact();
        const auto model = modelOf(path(), dataset, decimated(dataset));
        const auto verdict = verify(*model, dataset, levels);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        QCOMPARE(verdict->touchingPoints, std::uint64_t(4 + 9));
        QCOMPARE(verdict->levels.back().measured.error.largest, 0.0);

        // The first block by its corners alone is off by 0.5 at that point, and by more in the second one's cells.
        for (const float claimed : {0.4F, 0.6F}) {
            const auto coarse = modelOf(path(), dataset, withCoarseBlock(dataset, claimed));
            const auto judged = verify(*coarse, dataset, {{100, anyWarping}});
            QVERIFY(judged.ok());
            QCOMPARE(textOf(judged).contains("in every cell that holds it"), claimed < 0.5F);
        }
    }

    /// Weighted errors and warpings are compared with weighted claims (R6).
    void weightsCount()
    {
        const Dataset dataset = randomIrregular(4);
        const Eigen::Vector3d middle = dataset.bounds().center();
        const std::string text = "point:" + std::to_string(middle.x()) + "," + std::to_string(middle.y()) + "," +
                                 std::to_string(middle.z()) + ",1";
        const auto weighting = parseWeighting(text);
        QVERIFY(weighting.ok());
        const auto weights = pointWeights(*weighting, dataset, {});
        QVERIFY(weights.ok());
        const RecordedSteps history = decimated(dataset, *weights);
        const auto right = verify(*modelOf(path(), dataset, history, {{"weights", text}}), dataset, levels);
        QVERIFY2(right.ok() && right->ok(), qPrintable(textOf(right)));
        const auto without = verify(*modelOf(path(), dataset, history), dataset, levels);
        QVERIFY2(textOf(without).contains("more than the claimed"), qPrintable(textOf(without)));
    }

    void liesAreFound_data()
    {
        QTest::addColumn<Lie>("lie");
        QTest::addColumn<QString>("says");
        using format::SectionId;
        const auto row = [](const char* name, const Lie& lie, const char* says) {
            QTest::newRow(name) << lie << QString(says);
        };
        row(
            "smaller own errors",
            [](FileParts& parts) {
                for (std::uint16_t& half : parts.elements<std::uint16_t>(SectionId::OwnErrors))
                    half = 0;
            },
            "larger than the own ones");
        row(
            "smaller own warpings",
            [](FileParts& parts) {
                for (std::uint16_t& half : parts.elements<std::uint16_t>(SectionId::OwnWarpings))
                    half = 0;
            },
            "larger than the own ones");
        row(
            "smaller running errors",
            [](FileParts& parts) {
                for (float& error : parts.elements<float>(SectionId::SiteRunningKeys))
                    error *= 0.6F;
            },
            "more than the claimed");
        row(
            "smaller errors by a larger weight of warpings",
            [](FileParts& parts) { parts.header().warpingWeight *= 3; }, "The warping at point");
        row(
            "turned tetrahedron",
            [](FileParts& parts) {
                auto& sites = parts.elements<std::array<std::uint32_t, 3>>(SectionId::OtherSites).back();
                std::swap(sites[0], sites[1]);
            },
            "is inverted");
        row(
            "other corner",
            [](FileParts& parts) {
                auto& sites = parts.elements<std::array<std::uint32_t, 3>>(SectionId::OtherSites).back();
                for (std::uint32_t& site : sites)
                    if (std::ranges::find(sites, 1U) == sites.end()) {
                        site = 1;
                        return;
                    }
            },
            "");
        row(
            "lost tetrahedron",
            [](FileParts& parts) {
                parts.elements<std::uint32_t>(SectionId::Destroyers).back() = parts.header().siteCount - 1;
            },
            "");
        row(
            "later end",
            [](FileParts& parts) {
                for (std::uint32_t& destroyer : parts.elements<std::uint32_t>(SectionId::Destroyers))
                    if (destroyer != Model::never && destroyer + 1 < parts.header().siteCount) {
                        ++destroyer;
                        return;
                    }
            },
            "");
        row(
            "moved site",
            [](FileParts& parts) {
                parts.content[static_cast<std::size_t>(parts.section(SectionId::SitePositions).offset) + 6] ^=
                    std::byte(1);
            },
            "does not lie where the original has point");
        row(
            "other tetrahedra", [](FileParts& parts) { parts.header().sourceHash ^= 1; },
            "built from other samples or positions");
    }
    void liesAreFound()
    {
        QFETCH(Lie, lie);
        QFETCH(QString, says);
        for (const std::uint32_t seed : {1U, 4U}) {
            const Dataset dataset = randomIrregular(seed);
            modelOf(path(), dataset, decimated(dataset));
            FileParts parts(readBytes(path()));
            lie(parts);
            parts.repairChecksums();
            writeBytes(path(), parts.content);
            const auto model = Model::open(path());
            QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
            const auto verdict = verify(**model, dataset, levels);
            QVERIFY2(verdict.ok() && !verdict->ok() && textOf(verdict).contains(says), qPrintable(textOf(verdict)));
        }
    }

    /// C10: a model lists the cells that were left out of its mesh, with their places; the judge knows better, and does
    /// without.
    void faultyCellsAreTold()
    {
        using format::SectionId;
        const Dataset sound = randomIrregular(4), dataset = withFaultyCells(sound);
        QCOMPARE(faultyCellCount(*modelOf(path(), sound, decimated(sound))), std::uint64_t(0));
        const auto model = modelOf(path(), dataset, decimated(dataset));
        const auto told = faultyCells(*model);
        QVERIFY2(told.ok(), told ? "" : told.error().text().c_str());
        QCOMPARE(faultyCellCount(*model), std::uint64_t(2)); // a hole by its value is no faulty shape
        QVERIFY(*told == std::vector<FaultyCell>(dataset.faultyCells->begin() + 1, dataset.faultyCells->end()));
        QCOMPARE(edgesOf((*told)[0]).size(), std::size_t(6));
        QCOMPARE(edgesOf((*told)[1]).size(), std::size_t(12));
        const auto proved = verify(*model, dataset, {{0, 0}});
        QVERIFY2(proved.ok() && proved->ok(), qPrintable(textOf(proved)));
        const auto other = verify(*model, sound, {{0, 0}});
        QVERIFY2(textOf(other).contains("lists 2 faulty cells, and there are 0"), qPrintable(textOf(other)));

        const std::vector<std::byte> bytes = readBytes(path());
        const auto damaged = [&](const Lie& lie) {
            FileParts parts(bytes);
            lie(parts);
            parts.repairChecksums();
            writeBytes(path(), parts.content);
            return Model::open(path());
        };
        const auto moved = damaged([](FileParts& parts) {
            parts.elements<format::FaultyCell>(SectionId::FaultyCells)[1].places[6][0] += 0.1;
        });
        const auto verdict = verify(**moved, dataset, {{0, 0}});
        QVERIFY2(textOf(verdict).contains("cell 20 was left out, with 8 corners"), qPrintable(textOf(verdict)));
        const auto unlisted = damaged([](FileParts& parts) { parts.section(SectionId::FaultyCells).id = 1053; });
        QCOMPARE(faultyCellCount(**unlisted), std::uint64_t(0));
        const auto without = verify(**unlisted, dataset, {{0, 0}});
        QVERIFY2(without.ok() && without->ok(), qPrintable(textOf(without)));
        const auto nonsense = damaged(
            [](FileParts& parts) { parts.elements<format::FaultyCell>(SectionId::FaultyCells)[0].corners = 9; });
        QVERIFY(!faultyCells(**nonsense).ok());
        const auto cutShort = damaged([](FileParts& parts) { parts.section(SectionId::FaultyCells).bytes -= 8; });
        QVERIFY(!cutShort.ok());
    }

    /// Meshes that conform, whose cells are positive and whose errors and warpings are zero, but for their domain.
    void otherDomainsAreFound_data()
    {
        QTest::addColumn<Domain>("data");
        QTest::addColumn<Domain>("mesh");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const Domain& data, const Domain& mesh, const char* says) {
            QTest::newRow(name) << data << mesh << QString(says);
        };
        const auto block = [](const Cube& p) { return p[0] < 3 && p[1] < 3; };
        const auto ring = [=](const Cube& p) { return block(p) && !(p[0] == 1 && p[1] == 1); };
        const auto hollow = [=](const Cube& p) { return block(p) && !(p[0] == 1 && p[1] == 1 && p[2] == 1); };
        const auto two = [](const Cube& p) { return p[2] != 1; };
        const auto notched = [](const Cube& p) { return !(p[0] == 1 && p[1] == 3 && p[2] == 1); };
        row("right: block", block, block, "");
        row("right: ring", ring, ring, "");
        row("right: hollow", hollow, hollow, "");
        row("right: two parts", two, two, "");
        row("right: notched", notched, notched, "");
        row("hole closed", ring, block, "a hole was opened or closed");
        row("hole opened", block, ring, "a hole was opened or closed");
        row("cavity filled", hollow, block, "The boundary has 1 surfaces, and that of the data has 2.");
        row("cavity made", block, hollow, "The boundary goes through point");
        row(
            "parts joined", two, [](const Cube&) { return true; }, "The mesh has 1 components, and the data have 2.");
        row(
            "bridge", two, [](const Cube& p) { return p[2] != 1 || (p[0] == 1 && p[1] == 1); },
            "The mesh has 1 components, and the data have 2.");
        row(
            "notch filled", notched, [](const Cube&) { return true; }, "");
    }
    void otherDomainsAreFound()
    {
        QFETCH(Domain, data);
        QFETCH(Domain, mesh);
        QFETCH(QString, says);
        const Dataset dataset = datasetOfCubes(cubes(data));
        const auto model = modelOf(path(), dataset, oneMesh(dataset, cubes(mesh)));
        const auto verdict = verify(*model, dataset, {{0, 0}});
        const bool right = QString(QTest::currentDataTag()).startsWith("right") ||
                           QString(QTest::currentDataTag()) == "notch filled"; // no vertex tells: it is one-sided (S13)
        QVERIFY2(verdict.ok() && verdict->ok() == right, qPrintable(textOf(verdict)));
        QVERIFY2(textOf(verdict).contains(says), qPrintable(textOf(verdict)));
    }

private:
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(IrregularVerificationTest)
#include "irregular_verification_test.moc"
