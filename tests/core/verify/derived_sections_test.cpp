// SPDX-License-Identifier: GPL-3.0-or-later
// What a file tells beside the arrays that every model has (FORMAT.md, sections 4 and 48 to 53) is what follows from
// them; the checker finds what is not, and does without.
#include "core/base/rounding.h"
#include "core/history/derived_sections.h"
#include "core/history/file_layout.h"
#include "tests/core/history/model_fixture.h"

#include <tan/build.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace tetra;
using format::SectionId;

namespace {

struct Kind {
    const char* name;
    Dataset dataset;
    std::uint32_t block;
};

const std::vector<Kind>& kinds()
{
    static const std::vector<Kind> all = {
        {"lattice", bumps(SampleType::UInt8, {7, 6, 8}), 0},
        {"lattice in blocks", bumps(SampleType::Float32, {10, 5, 9}), 4},
        {"grid", bentBumps(SampleType::Float32, {7, 5, 6}), 0},
        {"grid in blocks", bentBumps(SampleType::Int16, {9, 5, 6}, true, true), 3},
        {"grid with faults", faultyGrid(), 0},
    };
    return all;
}

} // namespace

class DerivedSectionsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(!kinds().empty());
        for (const Kind& kind : kinds()) {
            const auto report = buildModel(kind.dataset, path(kind.name), Refinement{.block = kind.block});
            QVERIFY2(report.ok(), report.ok() ? "" : report.error().text().c_str());
        }
    }

    void theyFollowFromTheRest_data() { everyKind(); }
    void theyFollowFromTheRest()
    {
        QFETCH(int, kind);
        const auto opened = Model::open(path(kinds()[std::size_t(kind)].name));
        QVERIFY(opened.ok());
        const Model& model = **opened;
        const DerivedSections derived = derivedSections(model);
        const double weight = model.description().warpingWeight;
        std::size_t batch = 0;
        std::vector<float> keys;
        for (std::uint32_t sites = 1; sites <= model.siteCount(); ++sites) {
            if (!endsBatch(model, sites))
                continue;
            QVERIFY(batch < derived.batchEnds.size());
            QCOMPARE(derived.batchEnds[batch], sites - 1);
            keys.push_back(sites < model.siteCount() ? model.runningKeys()[sites] : model.finalKey());
            if (weight > 0) {
                double error = 0, warping = 0;
                for (std::uint32_t site = 0; site < sites; ++site)
                    for (std::uint64_t t = model.starOffsets()[site]; t < model.starOffsets()[site + 1]; ++t)
                        if (model.destroyers()[t] >= sites) {
                            error = std::max(error, model.ownError(t));
                            warping = std::max(warping, model.ownWarping(t));
                        }
                const auto key = static_cast<double>(keys.back());
                QCOMPARE(derived.batchErrors[batch], roundedUp(std::min(key, error)));
                QCOMPARE(derived.batchWarpings[batch], roundedUp(std::min(key / weight, warping)));
                const double both =
                    std::max(double(derived.batchErrors[batch]), weight * double(derived.batchWarpings[batch]));
                QVERIFY(std::abs(both - key) <= 1e-6 * key); // no more and no less than the key says
            }
            ++batch;
        }
        QCOMPARE(derived.batchEnds.size(), batch);
        QCOMPARE(derived.batchErrors.size(), weight > 0 ? batch : 0);
        QCOMPARE(derived.batchWarpings.size(), weight > 0 ? batch : 0);
        compareLevels(model, derived, keys);
    }

    void theIndexLiesInTheFirst16KiB_data() { everyKind(); }
    void theIndexLiesInTheFirst16KiB()
    {
        QFETCH(int, kind);
        const auto model = Model::open(path(kinds()[std::size_t(kind)].name));
        const auto layout = readLayout((*model)->fileBytes(), (*model)->path());
        QCOMPARE(layout->sections.front().id, std::uint32_t(SectionId::LevelIndex));
        QVERIFY(layout->sections.front().offset + layout->sections.front().bytes <= 16384);
        QVERIFY(layout->sections[1].offset >= layout->sections[0].offset + 256 * 32); // whatever its length is
    }

    void blocksAndFaultsAreTold()
    {
        const auto told = [this](const char* name) {
            const auto model = Model::open(path(name));
            const DerivedSections derived = derivedSections(**model);
            const std::vector<std::uint32_t> cells(derived.blockCells.begin(), derived.blockCells.end());
            std::map<std::uint32_t, std::vector<std::uint64_t>> faults;
            for (const format::Fault& fault : derived.faults.value_or(std::span<const format::Fault>()))
                faults[fault.kind].push_back(fault.number);
            return std::tuple(cells, derived.faults.has_value(), faults);
        };
        using Cells = std::vector<std::uint32_t>;
        QVERIFY(std::get<0>(told("lattice")).empty() && !std::get<1>(told("lattice")));
        QVERIFY(std::get<0>(told("lattice in blocks")) == Cells({4, 4, 4}));
        QVERIFY(std::get<0>(told("grid in blocks")) == Cells({3, 3, 3}));
        const auto [none, hasFaults, noFaults] = told("grid");
        QVERIFY(none.empty() && hasFaults && noFaults.empty());
        auto [cells, has, faults] = told("grid with faults");
        QVERIFY(has);
        // Below the point (2, 1, 2), x fastest in 4 x 3 x 4 cells.
        QVERIFY(faults[1] == std::vector<std::uint64_t>({13, 14, 17, 18}));
        QVERIFY(faults[2] == std::vector<std::uint64_t>({44}));
        const auto verdict = verdictOf(readBytes(path("grid with faults")), faultyGrid(), {{0, 0}});
        QVERIFY(verdict.levels[0].inverted > 0);
        QCOMPARE(std::uint64_t(faults[3].size()), verdict.levels[0].inverted);
    }

    /// C10: the same cells with their places: all of them where every point is a site, else those that the model knows.
    void faultyCellsOfGridsHavePlaces()
    {
        QCOMPARE(faultyCellCount(**Model::open(path("grid"))), std::uint64_t(0));
        const Dataset grid = faultyGrid();
        const auto model = Model::open(path("grid with faults"));
        QCOMPARE(faultyCellCount(**model), std::uint64_t(5));
        const auto cells = faultyCells(**model);
        QVERIFY2(cells.ok(), cells ? "" : cells.error().text().c_str());
        constexpr std::array<std::uint32_t, 8> across{0, 1, 1, 0, 0, 1, 1, 0}, along{0, 0, 1, 1, 0, 0, 1, 1};
        std::vector<FaultyCell> expected;
        for (const std::uint32_t number : {13, 14, 17, 18, 44}) {
            FaultyCell& cell = expected.emplace_back();
            cell = {number, number == 44 ? CellFault::NoVolume : CellFault::Folded, {}};
            for (std::uint32_t corner = 0; corner < 8; ++corner)
                cell.corners.push_back(grid.position(grid.lattice.index(
                    number % 4 + across[corner], number / 4 % 3 + along[corner], number / 12 + corner / 4)));
        }
        QVERIFY(*cells == expected);
        const auto coarse = buildModel(grid, path("coarse"), Refinement{.error = 30, .block = 0});
        QVERIFY2(coarse.ok(), coarse.ok() ? "" : coarse.error().text().c_str());
        const auto few = faultyCells(**Model::open(path("coarse")));
        QVERIFY(few.ok() && few->size() == 5);
        for (std::size_t i = 0; i < few->size(); ++i)
            QVERIFY((*few)[i].corners.empty() || (*few)[i] == expected[i]);
        QVERIFY(std::ranges::any_of(*few, [](const FaultyCell& cell) { return cell.corners.empty(); }));
    }

    void theyAreProved_data() { everyKind(); }
    void theyAreProved()
    {
        QFETCH(int, kind);
        const auto& [name, dataset, block] = kinds()[std::size_t(kind)];
        const auto verdict = verdictOf(readBytes(path(name)), dataset, {{10, 10}, {2, 2}, {0, 0}});
        QVERIFY2(verdict.ok(), qPrintable(textOf(verdict)));
    }

    void damageIsFound_data();
    void damageIsFound();

    /// Such are older files.
    void filesWithoutThemAreRight_data() { everyKind(); }
    void filesWithoutThemAreRight()
    {
        QFETCH(int, kind);
        const auto& [name, dataset, block] = kinds()[std::size_t(kind)];
        FileParts parts(readBytes(path(name)));
        for (format::Section& section : parts.sections())
            if (section.id == 4 || section.id >= 48)
                section.id += 1000; // what no reader knows
        parts.repairChecksums();
        const auto verdict = verdictOf(parts.content, dataset, {{2, 2}});
        QVERIFY2(verdict.ok(), qPrintable(textOf(verdict)));
        const auto without = Model::open(path("file.tan"));
        const DerivedSections derived = derivedSections(**without);
        QVERIFY(derived.levels.empty() && derived.batchEnds.empty() && derived.batchErrors.empty() &&
                derived.batchWarpings.empty() && derived.blockCells.empty() && !derived.faults);
    }

    void sizesThatCannotBeAreRefused_data()
    {
        QTest::addColumn<int>("section");
        QTest::newRow("level index") << 4;
        QTest::newRow("batch ends") << 48;
        QTest::newRow("batch errors") << 49;
        QTest::newRow("batch warpings") << 50;
        QTest::newRow("blocks") << 51;
    }
    void sizesThatCannotBeAreRefused()
    {
        QFETCH(int, section);
        FileParts parts(readBytes(path("grid in blocks")));
        parts.section(SectionId(section)).bytes -= 4;
        parts.repairChecksums();
        writeBytes(path("file.tan"), parts.content);
        const auto model = Model::open(path("file.tan"));
        QVERIFY(!model.ok());
        QVERIFY2(QString::fromStdString(model.error().text()).contains("is damaged: section '"),
                 model.error().text().c_str());
    }

private:
    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }

    static void everyKind()
    {
        QTest::addColumn<int>("kind");
        for (std::size_t kind = 0; kind < kinds().size(); ++kind)
            QTest::newRow(kinds()[kind].name) << int(kind);
    }

    static QString textOf(const VerificationReport& verdict)
    {
        QStringList texts;
        for (const std::string& text : verdict.failures)
            texts << QString::fromStdString(text);
        for (const LevelReport& level : verdict.levels)
            for (const std::string& text : level.failures)
                texts << QString::fromStdString(text);
        return texts.join('\n');
    }

    VerificationReport verdictOf(std::span<const std::byte> bytes, const Dataset& dataset,
                                 const std::vector<Accuracy>& levels) const
    {
        writeBytes(path("file.tan"), bytes);
        const auto model = Model::open(path("file.tan"));
        const auto verdict = model ? verify(**model, dataset, levels) : Result<VerificationReport>(model.error());
        if (!verdict)
            qFatal("%s", verdict.error().text().c_str());
        return *verdict;
    }

    /// By a search for each of the thresholds, as a reader without the index would.
    static void compareLevels(const Model& model, const DerivedSections& derived, const std::vector<float>& keys)
    {
        std::vector<std::size_t> batches{0};
        for (int i = 1; i <= 254; ++i)
            for (std::size_t batch = 0; batch < keys.size(); ++batch)
                if (double(keys[batch]) <= std::pow(2, -i / 8.0) * double(keys[0])) {
                    batches.push_back(batch);
                    break;
                }
        batches.push_back(keys.size() - 1);
        batches.erase(std::unique(batches.begin(), batches.end()), batches.end());
        QCOMPARE(derived.levels.size(), batches.size());
        for (std::size_t number = 0; number < batches.size(); ++number) {
            const format::LevelEntry& level = derived.levels[number];
            const std::size_t batch = batches[number];
            QCOMPARE(level.key, keys[batch]);
            QCOMPARE(level.sites, derived.batchEnds[batch] + 1);
            QCOMPARE(std::uint64_t(level.tetrahedra), meshSizeOf(model, level.sites).tetrahedra);
            QCOMPARE(level.created, model.starOffsets()[level.sites]);
            const bool warps = model.description().warpingWeight > 0;
            QCOMPARE(level.error, warps ? derived.batchErrors[batch] : keys[batch]);
            QCOMPARE(level.warping, warps ? derived.batchWarpings[batch] : 0.0F);
        }
    }

    QTemporaryDir folder_;
};

using DerivedDamage = void (*)(FileParts&);

void DerivedSectionsTest::damageIsFound_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<DerivedDamage>("damage");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, int kind, DerivedDamage damage, const char* says) {
        QTest::newRow(name) << kind << damage << QString(says);
    };
    enum { Lattice, LatticeBlocks, Grid, GridBlocks, Faulty };
    using Level = format::LevelEntry;
    using format::Fault;
    row(
        "batch end", Lattice, [](FileParts& f) { ++f.elements<std::uint32_t>(SectionId::BatchEnds)[5]; },
        "Batch 5 ends with site");
    row(
        "batches", Lattice,
        [](FileParts& f) { // one fewer: the section may end early
            f.section(SectionId::BatchEnds).bytes -= 4;
        },
        "batches, and there are");
    row(
        "level key", Lattice, [](FileParts& f) { f.elements<Level>(SectionId::LevelIndex)[1].key *= 1.0001F; },
        "Entry 1 of the level index");
    row(
        "level error", Lattice, [](FileParts& f) { f.elements<Level>(SectionId::LevelIndex)[2].error = 0; },
        "Entry 2 of the level index");
    row(
        "level warping", LatticeBlocks, [](FileParts& f) { f.elements<Level>(SectionId::LevelIndex)[2].warping = 1; },
        "Entry 2 of the level index");
    row(
        "level sites", Grid, [](FileParts& f) { ++f.elements<Level>(SectionId::LevelIndex)[3].sites; },
        "Entry 3 of the level index");
    row(
        "level tetrahedra", Grid, [](FileParts& f) { --f.elements<Level>(SectionId::LevelIndex)[3].tetrahedra; },
        "Entry 3 of the level index");
    row(
        "level created", Grid, [](FileParts& f) { ++f.elements<Level>(SectionId::LevelIndex)[0].created; },
        "Entry 0 of the level index");
    row(
        "level reserved", Grid, [](FileParts& f) { f.elements<Level>(SectionId::LevelIndex)[0].reserved = 1; },
        "Entry 0 of the level index");
    row(
        "missing level", Grid,
        [](FileParts& f) {
            const auto levels = f.elements<Level>(SectionId::LevelIndex);
            levels.back() = {};
            f.section(SectionId::LevelIndex).bytes -= sizeof(Level);
        },
        "The level index has");
    row(
        "small error", Grid, [](FileParts& f) { f.elements<float>(SectionId::BatchErrors)[4] *= 0.999F; },
        "The error at the end of batch 4 is");
    row(
        "error rounded down", Grid,
        [](FileParts& f) {
            float& error = f.elements<float>(SectionId::BatchErrors)[4];
            error = std::nextafter(error, 0.0F);
        },
        "The error at the end of batch 4 is");
    row(
        "large error", Grid, [](FileParts& f) { f.elements<float>(SectionId::BatchErrors)[4] *= 1.001F; },
        "The error at the end of batch 4 is");
    row(
        "warping", GridBlocks, [](FileParts& f) { f.elements<float>(SectionId::BatchWarpings)[0] = NAN; },
        "The warping at the end of batch 0 is");
    row(
        "small warpings", GridBlocks,
        [](FileParts& f) {
            for (float& warping : f.elements<float>(SectionId::BatchWarpings))
                warping /= 16;
        },
        "more than the claimed");
    row(
        "small blocks", LatticeBlocks, [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Blocks)[0] = 3; },
        "lies in more than one block");
    row(
        "blocks of a grid", GridBlocks, [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Blocks)[2] = 4; },
        "lies in more than one block");
    row(
        "no blocks", GridBlocks, [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Blocks)[1] = 0; },
        "3 x 0 x 3 cells are impossible");
    row(
        "one block", LatticeBlocks,
        [](FileParts& f) {
            std::ranges::copy(std::array{9U, 4U, 8U}, f.elements<std::uint32_t>(SectionId::Blocks).begin());
        },
        "Blocks of 9 x 4 x 8 cells are impossible");
    row(
        "folded cell", Faulty, [](FileParts& f) { f.elements<Fault>(SectionId::Faults)[0].number = 12; },
        "The file says that cell 12 is folded, which is not so.");
    row(
        "unfolded cell", Faulty, [](FileParts& f) { f.elements<Fault>(SectionId::Faults)[0].number = 12; },
        "The file does not say that cell 13 is folded.");
    row(
        "cell with volume", Faulty, [](FileParts& f) { ++f.elements<Fault>(SectionId::Faults)[4].number; },
        "cell 45 has no volume, which is not so");
    row(
        "inverted tetrahedron", Faulty, [](FileParts& f) { --f.elements<Fault>(SectionId::Faults)[5].number; },
        "is inverted, which is not so");
    row(
        "kind of fault", Faulty, [](FileParts& f) { f.elements<Fault>(SectionId::Faults)[5].kind = 9; },
        "there is a fault of kind 9");
    row(
        "reserved", Faulty, [](FileParts& f) { f.elements<Fault>(SectionId::Faults)[1].reserved = 9; },
        "Reserved fields of the list of faults");
    row(
        "order of faults", Faulty,
        [](FileParts& f) {
            const auto faults = f.elements<Fault>(SectionId::Faults);
            std::swap(faults[0], faults[1]);
        },
        "not in the order of their kinds");
}

void DerivedSectionsTest::damageIsFound()
{
    QFETCH(int, kind);
    QFETCH(DerivedDamage, damage);
    QFETCH(QString, says);
    const auto& [name, dataset, block] = kinds()[std::size_t(kind)];
    FileParts parts(readBytes(path(name)));
    damage(parts);
    parts.repairChecksums();
    const auto verdict = verdictOf(parts.content, dataset, {{20, 20}, {5, 5}});
    QVERIFY(!verdict.ok());
    QVERIFY2(textOf(verdict).contains(says), qPrintable(textOf(verdict)));
}

QTEST_GUILESS_MAIN(DerivedSectionsTest)
#include "derived_sections_test.moc"
