// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a model on a server is read (R28): within a number of bytes, and as an accuracy needs it.
#include "tests/core/remote/http_server.h"

#include <tan/build.h>
#include <tan/open.h>
#include <tan/packed.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

using namespace tetra;

namespace {

Dataset waves()
{
    constexpr std::uint32_t side = 16;
    std::vector<float> values;
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x)
                values.push_back(std::sin(0.5f * float(x)) * std::cos(0.4f * float(y)) + std::sin(0.7f * float(z)));
    Lattice lattice;
    lattice.size = {side, side, side};
    return *latticeDataset(lattice, ScalarField::of(std::move(values)), "waves");
}

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class ModelOpeningTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(buildModel(waves(), path("explicit.tan"), Refinement{}).ok());
        const auto model = Model::open(path("explicit.tan"));
        QVERIFY(model.ok() && packModel(**model, path("packed.tan")).ok());
    }

    void noMoreThanSoManyBytesAreRead_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("explicit") << "explicit.tan";
        QTest::newRow("packed") << "packed.tan";
    }
    /// The finest level that the file holds within them; the coarsest if none is.
    void noMoreThanSoManyBytesAreRead()
    {
        QFETCH(QString, file);
        const FaultyHttpServer server(contentOf(path(file.toStdString())));
        QVERIFY(server.isUp());
        const auto facts = modelFacts(server.address());
        QVERIFY2(facts.ok(), facts ? "" : facts.error().text().c_str());
        const std::vector<LevelInFile>& levels = facts->levels;
        QVERIFY2(levels.size() >= 4, qPrintable(QString::number(levels.size())));
        const auto read = [&](std::uint64_t mostBytes, const std::optional<Accuracy>& accuracy = {}) {
            OpenOptions options;
            options.accuracy = accuracy;
            options.mostBytes = mostBytes;
            options.cacheFolder = path("cache");
            const auto found = openModel(server.address(), options);
            return found ? *found : FoundModel();
        };
        const auto finestWithin = [&](std::uint64_t mostBytes) { // several may end in the same piece of the file
            std::size_t finest = 0;
            for (std::size_t level = 0; level < levels.size(); ++level)
                if (levels[level].bytes <= mostBytes)
                    finest = level;
            return finest;
        };
        constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
        int borders = 0;
        for (std::size_t level = 1; level < levels.size(); ++level) {
            for (const std::uint64_t bytes : {levels[level].bytes, levels[level].bytes - 1}) {
                const FoundModel found = read(bytes);
                QVERIFY(found.model);
                const std::size_t expected = finestWithin(bytes);
                QCOMPARE(found.model->siteCount(), levels[expected].sites);
                QCOMPARE(found.readBytes, levels[expected].bytes);
                QCOMPARE(found.isWhole, expected + 1 == levels.size());
            }
            borders += finestWithin(levels[level].bytes) != finestWithin(levels[level].bytes - 1) ? 1 : 0;
            // The accuracy that a level keeps needs no more of the file than that.
            const FoundModel kept = read(all, Accuracy{levels[level].error, levels[level].warping});
            QVERIFY(kept.model && kept.model->siteCount() <= levels[level].sites);
        }
        QVERIFY(borders >= 3);
        QCOMPARE(read(1).model->siteCount(), levels.front().sites);
        QCOMPARE(read(all).model->siteCount(), facts->sites);
    }

private:
    std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(ModelOpeningTest)
#include "model_opening_test.moc"
