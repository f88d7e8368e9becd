// SPDX-License-Identifier: GPL-3.0-or-later
// Packed models of lattices (R16, S19): byte for byte what they were, and every prefix a model that is proved (R2).
#include "core/packed/packed_file.h"
#include "core/packed/range_coder.h"
#include "core/packed/replay_coders.h"

#include <tan/build.h>
#include <tan/packed.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
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
        const Dataset dataset = wavesOf(SampleType(type), {13, 11, 9}, noise, 7, spacing);
        Refinement method;
        method.error = error;
        method.block = block;
        const auto built = buildModel(dataset, path("a.tan"), method);
        QVERIFY2(built.ok(), textOf(built));
        const auto model = *Model::open(path("a.tan"));
        const auto report = packModel(*model, path("a.packed.tan"));
        QVERIFY2(report.ok(), textOf(report));
        QVERIFY(isPacked(path("a.packed.tan")) && !isPacked(path("a.tan")));
        QCOMPARE(report->method,
                 error > 0 && model->samples().empty() ? PackMethod::StoredByParts : PackMethod::Replayed);
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

private:
    void provePrefixes(const PackedModel& packed, const Dataset& dataset)
    {
        const auto levels = packed.levels();
        QVERIFY(levels.size() > 3);
        QCOMPARE(levels.back().sites, packed.siteCount());
        for (std::size_t level = 0; level < levels.size(); level += level + 2 < levels.size() ? 2 : 1) {
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
    }

    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(PackedModelTest)
#include "packed_model_test.moc"
