// SPDX-License-Identifier: GPL-3.0-or-later
/// S5, C10: of grids with folded cells, models of every builder are proved at every level, and of meshes of any other
/// query: inverted are those tetrahedra that may be, as a slow search over all cells finds, and no others.
#include "core/data/grid_handedness.h"
#include "core/mesh/decimation/decimation.h"
#include "core/mesh/decimation/lattice_tetrahedra.h"
#include "core/mesh/lifted_grid.h"
#include "core/model/lifted_original.h"
#include "core/model/model_writer.h"
#include "core/model/queries/mesh_extractor.h"
#include "core/model/verify_mesh.h"
#include "tests/core/mesh/bent_grids.h"
#include "tests/core/model/model_fixture.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace tetra;

namespace {

using GridPlace = std::array<std::int64_t, 3>;
using GridTetrahedron = std::array<GridPlace, 4>;

std::int64_t determinantOf(const GridPlace& a, const GridPlace& b, const GridPlace& c, const GridPlace& d)
{
    GridPlace u{}, v{}, w{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        u[axis] = b[axis] - a[axis];
        v[axis] = c[axis] - a[axis];
        w[axis] = d[axis] - a[axis];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Whether a tetrahedron and a cell have an inner point in common: no plane through three of their corners divides
/// them.
bool meetSlowly(const GridTetrahedron& tetrahedron, const GridPlace& cell)
{
    std::vector<GridPlace> corners(tetrahedron.begin(), tetrahedron.end());
    for (std::int64_t number = 0; number < 8; ++number)
        corners.push_back({cell[0] + (number & 1), cell[1] + (number >> 1 & 1), cell[2] + (number >> 2)});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto beyond = [&](std::int64_t plane, bool above) {
            return std::ranges::all_of(tetrahedron, [&](const GridPlace& corner) {
                return above ? corner[axis] >= plane : corner[axis] <= plane;
            });
        };
        if (beyond(cell[axis] + 1, true) || beyond(cell[axis], false))
            return false;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i + 1; j < corners.size(); ++j)
            for (std::size_t k = j + 1; k < corners.size(); ++k) {
                std::array<std::int64_t, 4> sides{}; // of the tetrahedron the least and the largest, then of the cell
                for (std::size_t corner = 0; corner < corners.size(); ++corner) {
                    const std::int64_t side = determinantOf(corners[i], corners[j], corners[k], corners[corner]);
                    const std::size_t body = corner < 4 ? 0 : 2;
                    if (corner == 0 || corner == 4)
                        sides[body] = sides[body + 1] = side;
                    sides[body] = std::min(sides[body], side);
                    sides[body + 1] = std::max(sides[body + 1], side);
                }
                if ((sides[1] <= 0 && sides[2] >= 0 && sides[0] < 0) ||
                    (sides[0] >= 0 && sides[3] <= 0 && sides[1] > 0))
                    return false;
            }
    return true;
}

/// A grid with what a slow search says of it.
class SlowGrid {
public:
    explicit SlowGrid(const BentGrid& grid) : grid_(grid)
    {
        std::int64_t balance = 0;
        forEachCorner([&](const GridPlace&, std::int64_t volume) { balance += (volume > 0) - (volume < 0); });
        hand_ = balance < 0 ? -1 : 1;
        forEachCorner([&](const GridPlace& cell, std::int64_t volume) {
            if (hand_ * volume < 0 && (folded_.empty() || folded_.back() != cell))
                folded_.push_back(cell);
        });
    }

    std::size_t foldedCells() const { return folded_.size(); }

    /// Of points, positive in computational space.
    bool isInverted(const std::array<std::uint32_t, 4>& points) const
    {
        return hand_ * determinantOf(lifted(points[0]), lifted(points[1]), lifted(points[2]), lifted(points[3])) < 0;
    }
    bool mayBeInverted(const std::array<std::uint32_t, 4>& points) const
    {
        GridTetrahedron tetrahedron{};
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto place = grid_.place(points[corner]);
            tetrahedron[corner] = {place[0], place[1], place[2]};
        }
        bool ofOneCell = true;
        for (const GridPlace& a : tetrahedron)
            for (const GridPlace& b : tetrahedron)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    ofOneCell = ofOneCell && std::abs(a[axis] - b[axis]) <= 1;
        return ofOneCell ||
               std::ranges::any_of(folded_, [&](const GridPlace& cell) { return meetSlowly(tetrahedron, cell); });
    }

private:
    GridPlace lifted(std::uint64_t point) const
    {
        const Eigen::Vector3d scaled = 64 * grid_.positions[point];
        return {std::lround(scaled.x()), std::lround(scaled.y()), std::lround(scaled.z())};
    }
    template <class Visit> void forEachCorner(const Visit& visit) const
    {
        const auto& size = grid_.size;
        const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
            return lifted(static_cast<std::uint64_t>((z * size[1] + y) * size[0] + x));
        };
        for (std::int64_t z = 0; z + 1 < size[2]; ++z)
            for (std::int64_t y = 0; y + 1 < size[1]; ++y)
                for (std::int64_t x = 0; x + 1 < size[0]; ++x)
                    for (std::int64_t dz = 0; dz < 2; ++dz)
                        for (std::int64_t dy = 0; dy < 2; ++dy)
                            for (std::int64_t dx = 0; dx < 2; ++dx)
                                visit(GridPlace{x, y, z},
                                      (1 - 2 * dx) * (1 - 2 * dy) * (1 - 2 * dz) *
                                          determinantOf(at(x + dx, y + dy, z + dz), at(x + 1 - dx, y + dy, z + dz),
                                                        at(x + dx, y + 1 - dy, z + dz),
                                                        at(x + dx, y + dy, z + 1 - dz)));
    }

    const BentGrid& grid_;
    int hand_ = 1;
    std::vector<GridPlace> folded_;
};

/// A bend of an arc, smooth but for the points that are pulled elsewhere: (x, y, z), and by how many cells along x.
BentGrid pulled(const std::vector<std::array<double, 4>>& points, bool mirrored = false)
{
    return bentGrid({9, 8, 7}, [&](double x, double y, double z) {
        double along = x;
        for (const auto& point : points)
            if (x == point[0] && (y == point[1] || point[1] < 0) && (z == point[2] || point[2] < 0))
                along += point[3];
        const double angle = 0.25 * y, radius = 4 + along;
        return Eigen::Vector3d((mirrored ? -1 : 1) * radius * std::cos(angle), radius * std::sin(angle),
                               z + 0.05 * along * y);
    });
}

BentGrid foldedGridNamed(const std::string& name)
{
    if (name == "inside")
        return pulled({{4, 4, 3, 1.5}});
    if (name == "one cell")
        return pulled({{0, 0, 0, 2.5}});
    if (name == "on the boundary")
        return pulled({{0, 4, 3, 1.6}});
    if (name == "at a face of blocks")
        return pulled({{3, 3, 3, -1.7}});
    if (name == "two neighbours")
        return pulled({{4, 4, 3, 1.4}, {5, 4, 3, -1.2}});
    if (name == "two places")
        return pulled({{2, 2, 2, 1.4}, {6, 6, 5, -1.6}});
    if (name == "a plane")
        return pulled({{4, -1, -1, 1.5}});
    if (name == "left-handed")
        return pulled({{4, 4, 3, 1.5}}, true);
    if (name == "turned back")
        return bentGrid({9, 6, 6}, [](double x, double y, double z) {
            return Eigen::Vector3d(std::abs(x - 4) + 0.1 * y, y + 0.05 * x * z, z + 0.1 * x);
        });
    if (name == "long") // 60,000 cells along an axis, and some of them folded
        return bentGrid({3, 2, 60001}, [](double x, double y, double z) {
            const bool isPulled = x == 1 && y == 1 && static_cast<int>(z) % 7001 == 13;
            return Eigen::Vector3d(x + (isPulled ? 1.5 : 0), y, z);
        });
    if (name == "bent cells") // none is folded, yet some tetrahedra of their corners are inverted
        return shakenGrid({8, 8, 8}, 0.24, 12);
    if (name == "wrapped") // an O-grid, of which coarse tetrahedra turn over, and a point of it pulled
        return bentGrid({6, 13, 5}, [](double x, double y, double z) {
            const double angle = 2 * 3.14159265358979 / 12 * std::fmod(y, 12);
            const double radius = 1 + x + (x == 4 && y == 5 && z == 2 ? 1.4 : 0);
            return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
        });
    const auto seed = static_cast<unsigned>(name.back() - '0');
    return shakenGrid({7, 8, 6}, 0.3 + 0.1 * seed, seed);
}

Dataset datasetOfGrid(const BentGrid& grid)
{
    Dataset dataset;
    dataset.domain = DomainClass::Curvilinear;
    dataset.lattice.size = grid.size;
    dataset.positions = std::make_shared<std::vector<Eigen::Vector3d>>(grid.positions);
    const auto values = std::make_shared<std::vector<double>>(grid.values);
    dataset.values =
        ScalarField(SampleType::Float64, values->size(), {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.source.hash = contentHash(dataset.values, dataset.positions);
    return dataset;
}

/// Hands a history on, but claims of each mesh that is not consistent that it is, and nearer to the data than the one
/// before.
struct LyingSink final : HistorySink {
    HistorySink& sink;
    float key;

    LyingSink(HistorySink& to, double extent) : sink(to), key(static_cast<float>(extent)) {}
    Status begin(const HistoryTraits& traits) override { return sink.begin(traits); }
    Status add(const HistoryStep& step) override
    {
        HistoryStep lie = step;
        constexpr std::uint32_t corners = 8;
        if (++sites <= corners)
            return sink.add(lie);
        key = std::isinf(step.keyBefore) ? 0.995F * key : std::min(key, step.keyBefore);
        lie.keyBefore = key;
        return sink.add(lie);
    }
    Status finish(float finalKey) override { return sink.finish(finalKey); }

private:
    std::uint32_t sites = 0;
};

/// What a build counts as inverted in the finest mesh.
Result<std::uint64_t> buildFolded(const std::string& builder, const BentGrid& grid, HistorySink& sink)
{
    if (builder.starts_with("decimation")) {
        std::vector<Eigen::Vector3d> places;
        for (std::size_t point = 0; point < grid.positions.size(); ++point)
            places.emplace_back(grid.place(point)[0], grid.place(point)[1], grid.place(point)[2]);
        const auto tetrahedra = latticeTetrahedra(grid.size, LatticeCut::Six);
        DecimationMesh mesh;
        mesh.positions = places;
        mesh.lifted = grid.positions;
        mesh.leftHanded = isLeftHanded(datasetOfGrid(grid));
        mesh.values = grid.values;
        mesh.tetrahedra = tetrahedra;
        mesh.box = true;
        DecimationOptions options;
        options.warpingWeight = grid.options().warpingWeight;
        if (builder.ends_with("rounds"))
            options.order = DecimationOrder::IndependentRounds;
        if (const auto done = decimate(mesh, options, sink); !done)
            return done.error();
        return static_cast<std::uint64_t>(std::ranges::count_if(
            tetrahedra, [slow = SlowGrid(grid)](const auto& points) { return slow.isInverted(points); }));
    }
    CurvilinearRefinementOptions options = grid.options(builder.find("blocks") != std::string::npos ? 3 : 0);
    if (builder.starts_with("paper"))
        options.selection = CurvilinearSelection::Paper;
    const auto result = grid.refine(options, sink);
    if (!result)
        return result.error();
    return result->inverted;
}

QString failuresOf(const LevelVerdict& level)
{
    QString text = QString::number(level.asked.error) + " %:";
    for (const std::string& failure : level.failures)
        text += " " + QString::fromStdString(failure);
    return text;
}

const std::vector<Accuracy> allLevels = {{5, 5}, {4, 4}, {3, 3}, {2, 2}, {1, 1}, {.5, .5}, {.2, .2}, {.1, .1}, {0, 0}};

} // namespace

class FoldedGridsTest : public QObject {
    Q_OBJECT

private slots:
    /// Both ways to find out whether a tetrahedron meets a folded cell, the builder's and the verifier's, against the
    /// slow one: cells that are touched only, far ones along a long axis, cells held whole.
    void meetingIsExact_data()
    {
        QTest::addColumn<QString>("grid");
        for (const char* grid :
             {"inside", "one cell", "a plane", "left-handed", "turned back", "bent cells", "random 1", "long"})
            QTest::newRow(grid) << QString(grid);
    }
    void meetingIsExact()
    {
        QFETCH(QString, grid);
        const BentGrid bent = foldedGridNamed(grid.toStdString());
        const Dataset dataset = datasetOfGrid(bent);
        const SlowGrid slow(bent);
        const LiftedGrid lifted(bent.size, bent.positions, LatticeSamples(std::span<const double>(bent.values)));
        std::vector<std::string> failures;
        const auto original = LiftedOriginal::make(dataset, isLeftHanded(dataset), failures, {});
        QVERIFY(original.ok() && failures.empty());
        QCOMPARE(lifted.foldedCells().count(), slow.foldedCells());
        QCOMPARE(original->foldedCells(), slow.foldedCells());
        std::mt19937 random(20241122);
        int met = 0, missed = 0;
        while (met + missed < 4000) {
            std::array<std::uint32_t, 4> points{};
            for (std::uint32_t& point : points)
                point = random() % static_cast<std::uint32_t>(bent.values.size());
            CellCorners corners{};
            std::array<PackedPoint, 4> packed{};
            for (std::size_t corner = 0; corner < 4; ++corner) {
                auto place = bent.place(points[corner]);
                for (std::size_t axis = 0; axis < 3 && corner > 0 && met % 2 == 0; ++axis) // a small one
                    place[axis] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(
                        corners[0][axis] + std::int64_t(random() % 5) - 2, 0, bent.size[axis] - 1));
                points[corner] = (place[2] * bent.size[1] + place[1]) * bent.size[0] + place[0];
                corners[corner] = {place[0], place[1], place[2]};
                packed[corner] = lifted.lattice().pack(place[0], place[1], place[2]);
            }
            if (sixVolumes(corners) == 0)
                continue;
            const bool expected = slow.mayBeInverted(points);
            QCOMPARE(lifted.bears(packed), expected);
            QCOMPARE(original->bears(corners), expected);
            ++(expected ? met : missed);
        }
        QVERIFY(missed > 40 && (met > 40 || grid == "bent cells"));
    }

    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void modelsAreProvedAtEveryLevel_data()
    {
        QTest::addColumn<QString>("grid");
        QTest::addColumn<QString>("builder");
        for (const char* grid :
             {"inside", "one cell", "on the boundary", "at a face of blocks", "two neighbours", "two places", "a plane",
              "left-handed", "turned back", "bent cells", "random 1", "random 2", "random 3", "random 6"})
            for (const char* builder :
                 {"whole", "blocks", "paper", "paper, blocks", "decimation", "decimation in rounds"})
                QTest::addRow("%s, %s", grid, builder) << QString(grid) << QString(builder);
    }
    void modelsAreProvedAtEveryLevel()
    {
        QFETCH(QString, grid);
        QFETCH(QString, builder);
        const BentGrid bent = foldedGridNamed(grid.toStdString());
        const SlowGrid slow(bent);
        QCOMPARE(slow.foldedCells() == 0, grid == "bent cells");
        const Dataset dataset = datasetOfGrid(bent);
        const std::uint64_t inverted = build(dataset, builder.toStdString(), bent);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        const auto verdict = verify(**model, dataset, allLevels);
        QVERIFY(verdict.ok() && verdict->failures.empty());
        QCOMPARE(verdict->foldedCells, slow.foldedCells());
        for (const LevelVerdict& level : verdict->levels) {
            QVERIFY2(level.ok(), qPrintable(failuresOf(level)));
            std::uint64_t found = 0;
            forEachTetrahedron(**model, level.sites, [&](const std::array<std::uint32_t, 4>& points) {
                if (!slow.isInverted(points))
                    return;
                ++found;
                QVERIFY(slow.mayBeInverted(points));
            });
            QCOMPARE(level.inverted, found);
            QCOMPARE(level.invertedInData, found);
        }
        QCOMPARE(verdict->levels.back().inverted, inverted);
        if (grid != "one cell" && !(grid == "bent cells" && builder.startsWith("decimation")))
            QVERIFY(inverted > 0);
        // Keys mean something: what is folded in a few places needs no more than that for a coarse mesh.
        if (grid.contains("inside") || grid == "one cell" || grid == "two places" || grid == "on the boundary")
            QVERIFY2(verdict->levels.front().sites < bent.values.size() * 3 / 4,
                     qPrintable(QString::number(verdict->levels.front().sites)));
    }

    /// Meshes of a focus, by insertion and as closed sets, near values, of a budget, and of bounds on one of the two.
    void otherMeshesAreProved_data()
    {
        QTest::addColumn<QString>("grid");
        QTest::addColumn<QString>("builder");
        for (const char* grid : {"inside", "at a face of blocks", "a plane", "left-handed", "bent cells", "random 3"})
            for (const char* builder : {"whole", "blocks", "paper", "decimation"})
                QTest::addRow("%s, %s", grid, builder) << QString(grid) << QString(builder);
    }
    void otherMeshesAreProved()
    {
        QFETCH(QString, grid);
        QFETCH(QString, builder);
        const BentGrid bent = foldedGridNamed(grid.toStdString());
        const SlowGrid slow(bent);
        const Dataset dataset = datasetOfGrid(bent);
        build(dataset, builder.toStdString(), bent);
        const auto opened = Model::open(path());
        QVERIFY(opened.ok());
        const std::shared_ptr<const Model>& model = *opened;
        const Eigen::AlignedBox3d bounds = dataset.bounds();
        const double length = bounds.diagonal().norm();
        const double middle = dataset.values.range().minimum + dataset.values.range().extent() / 2;
        const SpaceRamp sharp{Sphere{bent.positions[bent.positions.size() / 2], length / 5}, 0.5, 10, 0};
        const SpaceRamp graded{Sphere{bent.positions[bent.positions.size() / 2], length / 6}, 0.5, 20, length / 4};
        const ErrorField nearMiddle =
            ErrorField::nearValues(std::array{middle}, 1, 30, dataset.values.range().extent() / 9);
        std::vector<MeshQuery> queries;
        for (const ErrorField& field : {ErrorField(sharp), ErrorField(graded), nearMiddle, ErrorField(3.0)})
            for (const double warping : {3.0, 100.0}) {
                MeshQuery query;
                query.error = field;
                query.warping = warping;
                queries.push_back(query);
                query.budget = model->tetrahedronCount() / 4;
                queries.push_back(query);
            }
        MeshExtractor extractor(model);
        std::size_t answered = 0;
        for (MeshQuery& query : queries)
            for (const VariableMethod method :
                 {VariableMethod::Automatic, VariableMethod::ClosedSet, VariableMethod::Insertion}) {
                query.method = method;
                const auto mesh = extractor.extract(query);
                if (!mesh) {
                    QVERIFY2(method == VariableMethod::Insertion && mesh.error().kind == ErrorKind::WrongUsage,
                             mesh.error().text.c_str());
                    continue;
                }
                ++answered;
                const auto level = verifyMesh(*model, dataset, query, **mesh);
                QVERIFY(level.ok());
                QVERIFY2(level->ok(), qPrintable(failuresOf(*level)));
                QCOMPARE(level->inverted, level->invertedInData);
            }
        QVERIFY(answered >= 2 * queries.size());
    }

    /// A model that claims of its first meshes to be consistent: what is inverted there away from the folded cells is a
    /// failure, what meets them is none.
    void invertedElsewhereIsAFailure()
    {
        const BentGrid bent = foldedGridNamed("wrapped");
        const SlowGrid slow(bent);
        QVERIFY(slow.foldedCells() > 0 && slow.foldedCells() < 10);
        const Dataset dataset = datasetOfGrid(bent);
        build(dataset, "whole", bent);
        QVERIFY(verdictOf(dataset, allLevels).ok());
        build(dataset, "lie", bent);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        std::vector<Accuracy> levels;
        for (std::uint32_t site = 8; site < (*model)->siteCount(); ++site) {
            const double percent = 100 * double((*model)->runningErrors()[site]) / bent.valueExtent();
            if (percent < (levels.empty() ? 100 : levels.back().error))
                levels.push_back({percent, 100});
        }
        const Verdict verdict = verdictOf(dataset, levels);
        QVERIFY(verdict.failures.empty());
        int rejected = 0, mixed = 0;
        for (const LevelVerdict& level : verdict.levels) {
            std::uint64_t inverted = 0, borne = 0;
            forEachTetrahedron(**model, level.sites, [&](const std::array<std::uint32_t, 4>& points) {
                inverted += slow.isInverted(points) ? 1 : 0;
                borne += slow.isInverted(points) && slow.mayBeInverted(points) ? 1 : 0;
            });
            QCOMPARE(level.inverted, inverted);
            QCOMPARE(level.invertedInData, borne);
            QCOMPARE(failuresOf(level).contains("is inverted in physical space"), inverted > borne);
            rejected += inverted > borne ? 1 : 0;
            mixed += inverted > borne && borne > 0 ? 1 : 0;
        }
        QVERIFY(rejected > 2 && mixed > 0);
        QVERIFY(verdict.levels.back().ok());
    }

    /// Nor is a model believed that says of itself that the grid has the other hand.
    void aWrongHandIsAFailure()
    {
        for (const char* name : {"inside", "left-handed"}) {
            const BentGrid bent = foldedGridNamed(name);
            const Dataset dataset = datasetOfGrid(bent);
            build(dataset, "whole", bent);
            FileParts file(readBytes(path()));
            file.header().leftHanded = 1 - file.header().leftHanded;
            file.repairChecksums();
            writeBytes(path(), file.content);
            const Verdict verdict = verdictOf(dataset, allLevels);
            QCOMPARE(verdict.failures.size(), std::size_t(1));
            QVERIFY2(QString::fromStdString(verdict.failures[0]).contains("-handed"), verdict.failures[0].c_str());
        }
    }

private:
    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }

    std::uint64_t build(const Dataset& dataset, const std::string& builder, const BentGrid& grid) const
    {
        ModelDescription description;
        description.builder = builder;
        if (builder.find("blocks") != std::string::npos)
            description.parameters = {{"block", "3"}};
        const auto writer = ModelWriter::create(path(), dataset, description);
        if (!writer)
            qFatal("%s", writer.error().text.c_str());
        LyingSink liar(**writer, grid.valueExtent());
        const auto inverted = buildFolded(builder, grid, builder == "lie" ? static_cast<HistorySink&>(liar) : **writer);
        if (!inverted)
            qFatal("%s", inverted.error().text.c_str());
        return *inverted;
    }

    Verdict verdictOf(const Dataset& dataset, const std::vector<Accuracy>& levels) const
    {
        const auto model = Model::open(path());
        const auto verdict = model ? verify(**model, dataset, levels) : Result<Verdict>(model.error());
        if (!verdict)
            qFatal("%s", verdict.error().text.c_str());
        return *verdict;
    }

    /// By its definition: created by one of the first sites, destroyed by none; the numbers of the dataset's points.
    template <class Visit> static void forEachTetrahedron(const Model& model, std::uint32_t sites, const Visit& visit)
    {
        for (std::uint32_t creator = 0; creator < sites; ++creator)
            for (std::uint64_t t = model.starOffsets()[creator]; t < model.starOffsets()[creator + 1]; ++t)
                if (model.destroyers()[t] >= sites) {
                    const auto& [a, b, c] = model.otherSites()[t];
                    visit({model.points()[creator], model.points()[a], model.points()[b], model.points()[c]});
                }
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(FoldedGridsTest)
#include "folded_grids_test.moc"
