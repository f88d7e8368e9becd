// SPDX-License-Identifier: GPL-3.0-or-later
// Packed models of lattices (R16, S19): byte for byte what they were, and every prefix a model that is proved (R2).
#include "core/packed/packed_file.h"
#include "core/packed/range_coder.h"
#include "core/packed/replay_coders.h"
#include "tests/core/packed/packed_damage.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/soak.h"

#include <tan/build.h>
#include <tan/packed.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

using namespace tetra;

namespace {

std::vector<char> contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::filesystem::path& path, const std::vector<char>& content)
{
    std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

/// Waves with noise, which some values of an integer type clip.
template <class T> Dataset waves(const std::array<std::uint32_t, 3>& size, double noise, unsigned seed,
                                 const Eigen::Vector3d& spacing = {1, 1, 1})
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<T> values;
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const double value =
                    std::sin(0.5 * x) * std::cos(0.4 * y) + 0.3 * std::sin(0.7 * z) + noise * any(random);
                if constexpr (std::is_integral_v<T>) {
                    constexpr double low = std::numeric_limits<T>::min(), high = std::numeric_limits<T>::max();
                    values.push_back(
                        static_cast<T>(std::clamp((low + high) / 2 + value * (high - low) / 2.5, low, high)));
                } else {
                    values.push_back(static_cast<T>(value * 1e3));
                }
            }
    Lattice lattice;
    lattice.size = size;
    lattice.spacing = spacing;
    return *latticeDataset(lattice, ScalarField::of(std::move(values)), "waves");
}

Dataset wavesOf(SampleType type, const std::array<std::uint32_t, 3>& size, double noise, unsigned seed,
                const Eigen::Vector3d& spacing = {1, 1, 1})
{
    return visitSampleType(type, [&]<class T>() { return waves<T>(size, noise, seed, spacing); });
}

const char* textOf(const auto& result)
{
    static std::string kept;
    kept = result ? "" : result.error().text();
    return kept.c_str();
}

} // namespace

class PackedModelTest : public QObject {
    Q_OBJECT

private slots:
    void models_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("error");
        QTest::addColumn<int>("block");
        QTest::addColumn<double>("noise");
        for (int type = 0; type < 8; ++type)
            for (const double error : {0.0, 3.0})
                for (const int block : {0, 5})
                    QTest::addRow("%s to %g in %d", sampleTypeName(SampleType(type)).data(), error, block)
                        << type << error << block << (type % 2 == 0 ? 0.02 : 0.3);
        QTest::newRow("without noise") << 0 << 0.0 << 0 << 0.0;
    }

    /// R16, S19: the file that comes out is the one that went in; each level is a proved model of its own.
    void models()
    {
        QFETCH(int, type);
        QFETCH(double, error);
        QFETCH(int, block);
        QFETCH(double, noise);
        const Eigen::Vector3d spacing = block > 0 ? Eigen::Vector3d(1, 1.25, 2) : Eigen::Vector3d(1, 1, 1);
        Dataset dataset = wavesOf(SampleType(type), {13, 11, 9}, noise, 7, spacing);
        if (type % 2 == 1)
            dataset.source.valueName = "pressure";
        Refinement method;
        method.error = error;
        method.block = block;
        const auto built = buildModel(dataset, path("a.tan"), method);
        QVERIFY2(built.ok(), textOf(built));
        const auto model = *Model::open(path("a.tan"));
        const auto report = packModel(*model, path("a.packed.tan"));
        QVERIFY2(report.ok(), textOf(report));
        QVERIFY(isPacked(path("a.packed.tan")) && !isPacked(path("a.tan")));
        QCOMPARE(report->method, PackMethod::Replayed);
        QCOMPARE(report->fileBytes, std::filesystem::file_size(path("a.packed.tan")));
        QVERIFY(!Model::open(path("a.packed.tan")).ok());
        const auto packed = PackedModel::open(path("a.packed.tan"));
        QVERIFY2(packed.ok(), textOf(packed));
        QCOMPARE((*packed)->unpackedBytes(), model->fileSize());
        QCOMPARE((*packed)->siteCount(), model->siteCount());
        const auto unpacked = unpackModel(**packed, path("b.tan"));
        QVERIFY2(unpacked.ok(), textOf(unpacked));
        QVERIFY(unpacked->derived.empty());
        QVERIFY(contentOf(path("a.tan")) == contentOf(path("b.tan")));
        provePrefixes(**packed, dataset);
    }

    /// C16, B5: what is packed and what comes out does not depend on the threads that share the regions of a lattice:
    /// neither the model nor those of its levels, which are proved.
    void threadsMakeNoDifference_data()
    {
        QTest::addColumn<int>("type");
        QTest::newRow("integers") << int(SampleType::UInt8);
        QTest::newRow("floats") << int(SampleType::Float32);
    }
    void threadsMakeNoDifference()
    {
        QFETCH(int, type);
        const Dataset dataset = wavesOf(SampleType(type), {67, 4, 66}, 0.2, 5, {1, 1.25, 2});
        QVERIFY(buildModel(dataset, path("a.tan"), Refinement{.block = 4u}).ok());
        std::vector<std::vector<char>> made;
        constexpr std::size_t files = 4;
        for (const int threads : {1, 2, 7}) {
            const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                              static_cast<std::size_t>(threads));
            tbb::task_arena arena(threads);
            const auto packed = arena.execute([&] { return packModel(**Model::open(path("a.tan")), path("p.tan")); });
            QVERIFY2(packed.ok(), textOf(packed));
            QCOMPARE(packed->method, PackMethod::Replayed);
            made.push_back(contentOf(path("p.tan")));
            const auto opened = *PackedModel::open(path("p.tan"));
            QVERIFY(arena.execute([&] { return unpackModel(*opened, path("b.tan")).ok(); }));
            QVERIFY(contentOf(path("b.tan")) == contentOf(path("a.tan")));
            const std::size_t levels = opened->levels().size();
            for (const std::size_t level : {std::size_t(0), levels / 2, levels - 1}) {
                QVERIFY(arena.execute([&] { return unpackPrefix(*opened, level, path("l.tan")).ok(); }));
                made.push_back(contentOf(path("l.tan")));
                if (threads == 2)
                    proveLevel(*opened, level, dataset);
            }
            QCOMPARE(made.size() % files, 0u);
        }
        for (std::size_t i = files; i < made.size(); ++i)
            QVERIFY(made[i] == made[i - files]);
    }

    /// Nothing read is trusted: what is damaged gives an error with a sentence, or what it should; with right sums, as
    /// somebody may make them, a sound model at most. `./dev soak --only packed` does more of this.
    void damagedFilesAreRefused_data()
    {
        QTest::addColumn<bool>("replayed");
        QTest::addColumn<QList<unsigned>>("size");
        QTest::addColumn<int>("damages");
        QTest::newRow("replayed") << true << QList<unsigned>{9, 8, 7} << 400;
        QTest::newRow("in regions") << true << QList<unsigned>{67, 3, 66} << 100;
        QTest::newRow("by parts") << false << QList<unsigned>{9, 8, 7} << 400;
    }
    void damagedFilesAreRefused()
    {
        QFETCH(bool, replayed);
        QFETCH(QList<unsigned>, size);
        QFETCH(int, damages);
        const Dataset dataset = wavesOf(SampleType::UInt16, {size[0], size[1], size[2]}, 0.1, 3);
        if (replayed)
            QVERIFY(buildModel(dataset, path("a.tan"), Refinement{.block = 4u}).ok());
        else
            QVERIFY(buildModel(dataset, path("a.tan"), Decimation{}).ok());
        QVERIFY(packModel(**Model::open(path("a.tan")), path("a.packed.tan")).ok());
        const FuzzFolder work; // in memory: unpacking waits for the disk
        DamageJudge judge(path("a.packed.tan"), work.path());
        std::mt19937_64 random(1);
        std::array<int, 3> outcomes{};
        for (int i = 0; i < damages; ++i)
            ++outcomes[static_cast<std::size_t>(judge.judge(random))];
        for (const std::string& failure : judge.failures())
            QFAIL(failure.c_str());
        QVERIFY(outcomes[static_cast<std::size_t>(DamageOutcome::Refused)] > damages * 3 / 4);
    }

    /// A few points that claim to be a model of petabytes are damage, with all checksums right, and not a lack of room.
    void sizesThatNoModelOfItsCountsHasAreRefused()
    {
        const Dataset dataset = wavesOf(SampleType::UInt16, {9, 8, 7}, 0.1, 3);
        QVERIFY(buildModel(dataset, path("a.tan"), Refinement{.block = 4u}).ok());
        QVERIFY(packModel(**Model::open(path("a.tan")), path("a.packed.tan")).ok());
        const std::vector<char> whole = contentOf(path("a.packed.tan"));
        const format::PackedFacts facts = (*PackedModel::open(path("a.packed.tan")))->file().facts();
        const auto opened = [&](std::uint64_t claimed) {
            const auto* bytes = reinterpret_cast<const char*>(&facts);
            std::vector<char> changed = whole;
            const auto found = std::search(changed.begin(), changed.end(), bytes, bytes + sizeof facts);
            format::PackedFacts other = facts;
            other.fileBytes = claimed;
            std::copy_n(reinterpret_cast<const char*>(&other), sizeof other, found);
            repairPackedChecksums(std::as_writable_bytes(std::span(changed)));
            write(path("d.tan"), changed);
            return PackedModel::open(path("d.tan"));
        };
        QVERIFY(opened(facts.fileBytes).ok());
        for (const std::uint64_t claimed : {std::uint64_t(1) << 62, ~std::uint64_t(0), std::uint64_t(1) << 40}) {
            const auto refused = opened(claimed);
            QVERIFY(!refused.ok());
            QCOMPARE(refused.error().kind, ErrorKind::BadInput);
            QVERIFY(QString::fromStdString(refused.error().text()).contains("is damaged"));
        }
    }

    /// Levels that end where no step of the sites ends, with all checksums right: nothing is read or kept beyond them.
    void levelsThatEndWithinAStepAreRefused()
    {
        const Dataset dataset = wavesOf(SampleType::UInt16, {9, 8, 7}, 0.1, 3);
        QVERIFY(buildModel(dataset, path("a.tan"), Refinement{.block = 4u}).ok());
        QVERIFY(packModel(**Model::open(path("a.tan")), path("a.packed.tan")).ok());
        const std::vector<char> whole = contentOf(path("a.packed.tan"));
        const auto packed = *PackedModel::open(path("a.packed.tan"));
        std::size_t refused = 0;
        for (std::size_t level = 1; level < packed->levels().size(); ++level) {
            format::PackedLevelEntry entry = packed->file().levels()[level];
            const auto* bytes = reinterpret_cast<const char*>(&entry);
            std::vector<char> changed = whole;
            const auto found = std::search(changed.begin(), changed.end(), bytes, bytes + sizeof entry);
            QVERIFY(found != changed.end());
            --entry.sites;
            std::copy(bytes, bytes + sizeof entry, found);
            repairPackedChecksums(std::as_writable_bytes(std::span(changed)));
            write(path("d.tan"), changed);
            const auto opened = PackedModel::open(path("d.tan"));
            if (!opened.ok()) // no longer rising
                continue;
            const Status made = unpackPrefix(**opened, level, path("e.tan"));
            // A step of one site ends there, too.
            QVERIFY(made.ok() || made.error().kind == ErrorKind::BadInput);
            refused += made.ok() ? 0 : 1;
        }
        QVERIFY(refused > 0);
    }

    /// B5: asked to, it stops within a second, and leaves nothing behind.
    void canBeCancelled()
    {
        const Dataset dataset = wavesOf(SampleType::UInt8, {24, 24, 24}, 0.3, 3);
        QVERIFY(buildModel(dataset, path("a.tan")).ok());
        const auto model = *Model::open(path("a.tan"));
        QVERIFY(packModel(*model, path("a.packed.tan")).ok());
        const auto packed = *PackedModel::open(path("a.packed.tan"));
        const auto before = QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden);
        for (const auto& [packs, least] : {std::pair(true, 0.0), {true, 0.6}, {false, 0.0}, {false, 0.2}}) {
            std::stop_source stop;
            std::chrono::steady_clock::time_point asked;
            double last = 0;
            bool falls = false;
            const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
                falls |= fraction < last;
                last = fraction;
                if (fraction < least || stop.stop_requested())
                    return;
                asked = std::chrono::steady_clock::now();
                stop.request_stop();
            });
            const Error stopped = packs ? packModel(*model, path("n.tan"), progress).error()
                                        : unpackModel(*packed, path("n.tan"), progress).error();
            QCOMPARE(stopped.kind, ErrorKind::Cancelled);
            QVERIFY(!falls);
            QVERIFY(std::chrono::steady_clock::now() - asked < std::chrono::milliseconds(soon(10'000)));
            QCOMPARE(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
        }
    }

    /// C16: a model that its text and its samples do not make again is stored by parts, and comes back all the same.
    void whatCannotBeReplayedIsStoredByParts()
    {
        const Dataset dataset = wavesOf(SampleType::UInt8, {9, 8, 7}, 0.3, 3);
        const auto build = [&](HistorySink& history) {
            BuildTarget target{.history = history};
            const auto built = buildInto(dataset, Refinement{.error = 20, .block = 0u}, target, {});
            return built ? Status() : built.error();
        };
        QVERIFY(writeModel(dataset, path("a.tan"), "refinement", build).ok()); // without saying at which error it ends
        double last = 0;
        bool falls = false;
        const Progress progress({}, [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        const auto report = packModel(**Model::open(path("a.tan")), path("a.packed.tan"), progress);
        QVERIFY2(report.ok(), textOf(report));
        QCOMPARE(report->method, PackMethod::StoredByParts);
        QVERIFY(!falls);
        const auto unpacked = unpackModel(**PackedModel::open(path("a.packed.tan")), path("b.tan"));
        QVERIFY2(unpacked.ok(), textOf(unpacked));
        QVERIFY(contentOf(path("a.tan")) == contentOf(path("b.tan")));
    }

    /// Other files are not overwritten, and a level that is not there is not unpacked.
    void wrongUsageIsRefused()
    {
        const Dataset dataset = wavesOf(SampleType::UInt8, {5, 5, 5}, 0.3, 3);
        QVERIFY(buildModel(dataset, path("a.tan")).ok());
        const auto model = *Model::open(path("a.tan"));
        write(path("notes.txt"), {'a', 'b'});
        QCOMPARE(packModel(*model, path("notes.txt")).error().kind, ErrorKind::WrongUsage);
        QVERIFY(packModel(*model, path("a.packed.tan")).ok());
        const auto packed = *PackedModel::open(path("a.packed.tan"));
        QCOMPARE(unpackModel(*packed, path("notes.txt")).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(unpackPrefix(*packed, packed->levels().size(), path("b.tan")).error().kind, ErrorKind::WrongUsage);
        QVERIFY(!PackedModel::open(path("a.tan")).ok());
        QVERIFY(!PackedModel::open(path("none.tan")).ok());
        QVERIFY(!isPacked(path("none.tan")));
    }

    /// S19: what is decoded is what was coded, in about as many bytes as its entropy says.
    void theRangeCoderIsLossless()
    {
        std::mt19937_64 random(5);
        for (const double ones : {0.0, 0.01, 0.3, 0.5, 0.99, 1.0}) {
            std::vector<bool> bits;
            for (int i = 0; i < 20000; ++i)
                bits.push_back(static_cast<double>(random() % 10000) < ones * 10000);
            RangeEncoder encoder;
            BitModel model;
            NumberModel numbers;
            std::vector<std::uint64_t> coded;
            for (std::size_t i = 0; i < bits.size(); ++i) {
                encoder.bit(model, bits[i]);
                if (i % 100 != 0)
                    continue;
                coded.push_back(i % 200 == 0 ? random() >> 1 >> random() % 63 : 5);
                numbers.code(encoder, coded.back());
                encoder.raw(coded.back(), 63);
            }
            const std::vector<std::byte> bytes = encoder.finish();
            const double entropy =
                ones > 0 && ones < 1 ? -ones * std::log2(ones) - (1 - ones) * std::log2(1 - ones) : 0;
            QVERIFY(static_cast<double>(bytes.size()) < bits.size() * (entropy * 1.06 + 0.01) / 8 + 200 * 8 + 200 * 8);
            RangeDecoder decoder(bytes);
            BitModel again;
            NumberModel numbersAgain;
            std::size_t next = 0;
            for (std::size_t i = 0; i < bits.size(); ++i) {
                QCOMPARE(decoder.bit(again), bool(bits[i]));
                if (i % 100 != 0)
                    continue;
                QCOMPARE(numbersAgain.code(decoder, 0), coded[next]);
                QCOMPARE(decoder.raw(63), coded[next++]);
            }
            QVERIFY(!decoder.overrun());
            for (int i = 0; i < 100; ++i)
                decoder.raw(64);
            QVERIFY(decoder.overrun());
        }
    }

    /// Every value of every type, whatever was expected.
    void everyValueIsCoded()
    {
        for (int number = 0; number < 8; ++number)
            visitSampleType(SampleType(number), []<class T>() {
                std::mt19937_64 random(9);
                std::vector<T> values = {0, 1, std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(),
                                         std::numeric_limits<T>::min()};
                std::vector<double> expected = {0, 1e300, -1e300, 0.5, static_cast<double>(values[3])};
                for (int i = 0; i < 2000; ++i) {
                    values.push_back(std::is_integral_v<T> ? static_cast<T>(random())
                                                           : static_cast<T>(static_cast<double>(random()) / 1e9));
                    expected.push_back(i % 3 == 0 ? static_cast<double>(random()) / 1e9
                                                  : static_cast<double>(values.back()) + 0.3);
                }
                RangeEncoder encoder;
                ValueCoder<T> coder;
                for (std::size_t i = 0; i < values.size(); ++i)
                    coder.code(encoder, expected[i], values[i]);
                const std::vector<std::byte> bytes = encoder.finish();
                RangeDecoder decoder(bytes);
                ValueCoder<T> again;
                for (std::size_t i = 0; i < values.size(); ++i)
                    QCOMPARE(again.code(decoder, expected[i], T()), values[i]);
            });
    }

    /// The one number of steps that has no absolute value comes of damage alone (proved with the sanitizers).
    void everyNumberOfStepsIsTaken()
    {
        constexpr std::uint64_t farthest = std::uint64_t(1) << 63;
        RangeEncoder encoder;
        BitModel isOther, isDownwards;
        NumberModel distances;
        encoder.bit(isOther, true);
        encoder.bit(isDownwards, true);
        distances.code(encoder, farthest - 1);
        const std::vector<std::byte> bytes = encoder.finish();
        for (const double expected : {0.0, -0.25}) {
            RangeDecoder decoder(bytes);
            QCOMPARE(ValueCoder<std::int32_t>().code(decoder, expected, 0), 0);
        }
    }

private:
    void provePrefixes(const PackedModel& packed, const Dataset& dataset)
    {
        const auto levels = packed.levels();
        QVERIFY(levels.size() > 3);
        const bool isInteger = tetra::isInteger(packed.description().sampleType);
        QVERIFY(levels.back().error <= std::max(3.0, isInteger ? 50 / dataset.values.range().extent() : 0.01) + 1e-6);
        for (std::size_t level = 0; level < levels.size(); level += level + 2 < levels.size() ? 2 : 1)
            proveLevel(packed, level, dataset);
    }

    void proveLevel(const PackedModel& packed, std::size_t level, const Dataset& dataset)
    {
        const auto levels = packed.levels();
        const Status made = unpackPrefix(packed, level, path("p.tan"));
        QVERIFY2(made.ok(), textOf(made));
        const auto prefix = Model::open(path("p.tan"));
        QVERIFY2(prefix.ok(), textOf(prefix));
        QCOMPARE((*prefix)->siteCount(), levels[level].sites);
        std::vector<Accuracy> asked;
        for (std::size_t i = 0; i <= level; i += 3)
            asked.push_back({.error = levels[i].error});
        asked.push_back({.error = levels[level].error});
        const auto verdict = verify(**prefix, dataset, asked);
        QVERIFY2(verdict.ok(), textOf(verdict));
        for (const std::string& failure : verdict->failures)
            QFAIL(failure.c_str());
        for (const LevelReport& found : verdict->levels) {
            for (const std::string& failure : found.failures)
                QFAIL(failure.c_str());
            QVERIFY(found.conforming && found.covers);
        }
        QCOMPARE(verdict->levels.back().sites, levels[level].sites);
    }

    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(PackedModelTest)
#include "packed_model_test.moc"
