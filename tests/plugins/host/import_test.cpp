// SPDX-License-Identifier: GPL-3.0-or-later
/// Opening parts of datasets, what models keep of it, and what a build is expected to take.
#include "plugins/host/build_estimate.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/model_building.h"
#include "plugins/host/time_choice.h"
#include "plugins/samples/samples.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <limits>

using namespace tetra;

namespace {

Dataset sample(const char* name, std::uint32_t size)
{
    return *makeSample({.name = name, .size = size, .type = std::nullopt, .seed = 1});
}

} // namespace

class ImportTest : public QObject {
    Q_OBJECT

private:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;

private slots:
    void initTestCase()
    {
        host_ = PluginHost::standard();
        QVERIFY(saveDataset(*host_, sample("c60", 12), path("c60.nrrd")).ok());
        QVERIFY(saveDataset(*host_, sample("scattered", 8), path("points.csv")).ok());
    }

    /// As of every reader: by its place, or by the time that the file says.
    void aTimeStepIsNamedByPlaceOrTime()
    {
        std::ofstream(path("steps.nrrd")) << "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 2 2 2 4\n"
                                             "kinds: domain domain domain time\nspacings: 1 1 1 0.25\n"
                                             "axis mins: 0 0 0 1.5\nencoding: text\n\n"
                                             "0 0 0 0 0 0 0 1\n1 1 1 1 1 1 1 2\n2 2 2 2 2 2 2 3\n3 3 3 3 3 3 3 4\n";
        const auto numberOf = [&](const char* file, const char* text) {
            const auto number = timeStepOf(*host_, path(file), {.values = {{"time", std::int64_t(99)}}}, text);
            return number ? std::to_string(*number) : number.error().text();
        };
        QCOMPARE(numberOf("steps.nrrd", "first"), std::string("1"));
        QCOMPARE(numberOf("steps.nrrd", "last"), std::string("4"));
        QCOMPARE(numberOf("steps.nrrd", "t=2"), std::string("3"));
        QCOMPARE(numberOf("steps.nrrd", "t=1.5"), std::string("1"));
        QCOMPARE(numberOf("c60.nrrd", "last"), std::string("1"));
        QVERIFY(numberOf("steps.nrrd", "t=1.9").ends_with("no time step at 1.9. The nearest one is number 3, at 2."));
        QVERIFY(numberOf("c60.nrrd", "t=1").ends_with("it has one time step, and states no time. Leave '--time' out."));
        for (const char* const text : {"later", "0.5", "t=", "t=nan", "t=1x", ""}) {
            QVERIFY(numberOf("steps.nrrd", text).starts_with("'" + std::string(text) + "' for '--time'"));
            QVERIFY(isTimeInWords(text));
        }
        QVERIFY(!isTimeInWords("3") && !isTimeInWords("-1"));
    }

    void aModelIsVerifiedAgainstThePartThatItKeeps_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("region");
        QTest::addColumn<QString>("stride");
        QTest::newRow("region") << "c60.nrrd"
                                << "1,2,3,9,8,10"
                                << "";
        QTest::newRow("stride") << "c60.nrrd"
                                << ""
                                << "2,1,3";
        QTest::newRow("both") << "c60.nrrd"
                              << "0,0,2,11,10,11"
                              << "2";
        QTest::newRow("points") << "points.csv"
                                << "-1,-0.5,-1,1,1,0.5"
                                << "";
    }

    void aModelIsVerifiedAgainstThePartThatItKeeps()
    {
        QFETCH(QString, file);
        QFETCH(QString, region);
        QFETCH(QString, stride);
        const auto input = path(qPrintable(file));
        const ImportOptions options{
            .part = {.region = *parseRegion(region.toStdString()), .stride = *parseStride(stride.toStdString())}};
        const auto part = openDataset(*host_, input, options);
        QVERIFY2(part, part ? "" : part.error().text().c_str());
        QVERIFY(part->pointCount() < openDataset(*host_, input)->pointCount());
        const auto built = buildModel(*host_, *part, {}, {}, path("part.tan"), {},
                                      {.live = nullptr, .keepWhenCancelled = nullptr, .imported = options});
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        const auto model = Model::open(path("part.tan"));
        QVERIFY(model);
        const auto kept = importOf((*model)->description(), {});
        QVERIFY(kept);
        const auto again = openDataset(*host_, input, *kept);
        QVERIFY(again);
        const auto proved = verify(**model, *again, {{1, 1}, {0, 0}});
        QVERIFY(proved && proved->ok());
        const auto whole = verify(**model, *openDataset(*host_, input), {{1, 1}});
        QVERIFY(!whole || !whole->ok());
    }

    void optionsAreKeptAsTexts()
    {
        const auto parameters = host_->reader("lattice")->plugin->parameters();
        const ImportOptions options{
            .reader = "lattice",
            .values = {{"size", std::string("3x4x5")}, {"skip", std::int64_t(12)}},
            .part = {.region = Eigen::AlignedBox3d(Eigen::Vector3d(0.25, -1, 1e-9), Eigen::Vector3d(1, 2, 3)),
                     .stride = {1, 1, 4}}};
        ModelDescription description;
        description.parameters = importTexts(options);
        const auto read = importOf(description, parameters);
        QVERIFY(read);
        QCOMPARE(read->reader, options.reader);
        QVERIFY(read->values == options.values);
        QVERIFY(read->part.region->min() == options.part.region->min());
        QVERIFY(read->part.region->max() == options.part.region->max());
        QCOMPARE(read->part.stride, options.part.stride);
        QVERIFY(importOf(description, {})->values.empty());
        QVERIFY(importTexts({}).empty());
        description.parameters = {{"import.region", "nonsense"}};
        QVERIFY(!importOf(description, parameters));
    }

    void aReaderIsChosenById()
    {
        std::ofstream(path("table.dat")) << "1 2 3 4\n5 6 7 8\n9 8 7 1\n1 1 1 1\n0 0 1 3\n";
        QCOMPARE(chooseReader(*host_, path("table.dat"))->id, std::string("points"));
        const ImportOptions raw{.reader = "lattice", .values = {{"size", std::string("2x2x10")}}};
        const auto opened = openDataset(*host_, path("table.dat"), raw);
        QVERIFY2(opened, opened ? "" : opened.error().text().c_str());
        const auto unknown = openDataset(*host_, path("table.dat"), {.reader = "magic"});
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().kind, ErrorKind::WrongUsage);
        QVERIFY(!openDataset(*host_, path("no.dat"), {.reader = "lattice"}));
    }

    void filesAreProbed()
    {
        const auto contents = probeDataset(*host_, path("c60.nrrd"));
        QVERIFY(contents);
        QCOMPARE(contents->points, std::uint64_t(12 * 12 * 12));
        QVERIFY(!probeDataset(*host_, path("c60.nrrd"), {.values = {{"colour", 1.0}}}));
        QVERIFY(!probeDataset(*host_, path("missing.nrrd")));
    }

    void estimatesAreWithinAFactorOfTwo_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("size");
        QTest::addColumn<QString>("builder");
        QTest::addColumn<double>("error");
        const auto add = [](const char* name, int size, const char* builder, std::initializer_list<double> errors) {
            for (const double error : errors)
                QTest::addRow("%s, %s, %g", name, builder, error) << name << size << builder << error;
        };
        add("c60", 32, "refinement", {0, 0.1, 1});
        add("noise", 32, "refinement", {0, 0.1, 1});
        add("hydrogen", 32, "refinement", {0, 0.1, 1});
        add("marschner-lobb", 32, "refinement", {0, 0.1, 1});
        add("blunt-body", 24, "refinement", {0, 0.1, 1});
        add("scattered", 16, "refinement", {0, 0.1, 1});
        add("stretched", 20, "refinement", {0, 0.1});
        add("scattered", 14, "decimation", {0, 0.1, 1});
        add("part", 24, "decimation", {0, 0.1, 1});
    }

    /// Of the file, which is the same every time; memory and time are in docs/lab/performance.md.
    void estimatesAreWithinAFactorOfTwo()
    {
        QFETCH(QString, name);
        QFETCH(int, size);
        QFETCH(QString, builder);
        QFETCH(double, error);
        const Dataset dataset = sample(qPrintable(name), static_cast<std::uint32_t>(size));
        const auto plugin = host_->builder(builder.toStdString());
        QVERIFY(plugin);
        ParameterValues values = plugin->plugin->detail(error, dataset.domain);
        QVERIFY(!values.empty());
        std::erase_if(values, [&, known = plugin->plugin->parameters()](const auto& value) { // as forms do
            return !matters(*std::ranges::find(known, value.first, &Parameter::id), known,
                            {{domainId, domainNameOf(dataset)}});
        });
        const auto built = buildModel(*host_, dataset, builder.toStdString(), values, path("estimated.tan"));
        QVERIFY(built);
        const BuildSize needed = buildSizeOf(dataset);
        const auto estimate = plugin->plugin->estimate(needed, values, 1);
        QVERIFY(estimate);
        const double ratio = static_cast<double>(estimate->modelBytes) / static_cast<double>(built->fileBytes);
        qInfo("model %.2f, seconds %.2f of what it took; %.1f us a site, share %.3f of %.3f, %.0f bytes a site", ratio,
              estimate->seconds / built->seconds, built->seconds / static_cast<double>(built->report.sites) * 1e6,
              needed.density.share(error / 100),
              static_cast<double>(built->report.sites) / static_cast<double>(dataset.pointCount()),
              static_cast<double>(built->fileBytes) / static_cast<double>(built->report.sites));
        QVERIFY2(ratio > 0.5 && ratio < 2, qPrintable(QString::number(ratio)));
    }

    void lessDetailTakesLess_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("builder");
        QTest::newRow("lattice, refined") << "c60"
                                          << "refinement";
        QTest::newRow("lattice, decimated") << "c60"
                                            << "decimation";
        QTest::newRow("grid, refined") << "blunt-body"
                                       << "refinement";
        QTest::newRow("grid, decimated") << "blunt-body"
                                         << "decimation";
        QTest::newRow("points, refined") << "scattered"
                                         << "refinement";
        QTest::newRow("mesh, decimated") << "part"
                                         << "decimation";
    }

    /// The model keeps the error that was asked for as its finest one, is smaller, and true.
    void lessDetailTakesLess()
    {
        QFETCH(QString, name);
        QFETCH(QString, builder);
        const Dataset dataset = sample(qPrintable(name), 16);
        const auto plugin = host_->builder(builder.toStdString());
        QVERIFY(plugin);
        std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
        for (const double percent : {0.0, 1.0, 5.0}) {
            const auto file = path("detail.tan");
            const auto built = buildModel(*host_, dataset, builder.toStdString(),
                                          plugin->plugin->detail(percent, dataset.domain), file);
            QVERIFY2(built, built ? "" : built.error().text().c_str());
            QVERIFY(built->fileBytes < last);
            last = built->fileBytes;
            const auto model = Model::open(file);
            QVERIFY(model);
            QCOMPARE(std::uint64_t((*model)->siteCount()), built->report.sites);
            QVERIFY((*model)->finalKey() <= percent / 100 * dataset.values.range().extent() * 1.000001);
            const auto verdict = verify(**model, dataset, {}, {});
            QVERIFY2(verdict, verdict ? "" : verdict.error().text().c_str());
            QVERIFY(verdict->ok());
        }
    }

    void moreDataNeedMore()
    {
        for (const DomainClass domain :
             {DomainClass::RegularLattice, DomainClass::Curvilinear, DomainClass::Irregular, DomainClass::Scattered}) {
            BuildEstimate before;
            for (std::uint64_t points = 1000; points < 1'000'000'000; points *= 4) {
                const BuildEstimate now =
                    *quickestEstimate(*host_, {.domain = domain, .points = points, .tetrahedra = 5 * points}, 2);
                QVERIFY(now.diskBytes >= now.modelBytes && now.memoryBytes > 0 && now.seconds > 0);
                if (points > 2'000'000 && before.seconds > 0) { // where what does not depend on them no longer counts
                    const double growth = double(now.modelBytes) / double(before.modelBytes);
                    QVERIFY(growth > 3 && growth < 5);
                    // Blocks, which large data are built in, take more of the disk and less memory.
                    QVERIFY(now.diskBytes > 2 * before.diskBytes && now.seconds > before.seconds);
                }
                before = now;
            }
        }
    }

    /// C8: a builder knows of its own work only, and in blocks other than as a whole.
    void theEstimateIsOfTheBuilder()
    {
        const auto estimate = [this](const char* builder, const BuildSize& size, const ParameterValues& values = {}) {
            return host_->builder(builder)->plugin->estimate(size, values, 2);
        };
        const BuildSize lattice{.domain = DomainClass::RegularLattice, .points = 1'000'000};
        const BuildSize points{.domain = DomainClass::Scattered, .points = 1000};
        QVERIFY(estimate("decimation", points)->memoryBytes > estimate("refinement", points)->memoryBytes);
        BuildSize mesh{.domain = DomainClass::Irregular, .points = 1000, .tetrahedra = 5000};
        QVERIFY(!estimate("refinement", mesh));
        mesh.convex = true; // C6: refined as its points
        QCOMPARE(estimate("refinement", mesh)->memoryBytes, estimate("refinement", points)->memoryBytes);
        BuildSize grid{.domain = DomainClass::Curvilinear, .points = 1000, .convex = true};
        QCOMPARE(estimate("refinement", grid)->memoryBytes, estimate("refinement", points)->memoryBytes);
        const ParameterValues asGrid{{"space", std::string("computational")}, {"error-in", std::string("grid")}};
        const ParameterValues inSpace{{"space", std::string("computational")}, {"error-in", std::string("space")}};
        QVERIFY(estimate("refinement", grid, asGrid)->seconds < estimate("refinement", grid)->seconds);
        QVERIFY(estimate("refinement", grid, inSpace)->seconds > 5 * estimate("refinement", grid, asGrid)->seconds);
        QVERIFY(estimate("decimation", lattice)->memoryBytes > estimate("refinement", lattice)->memoryBytes);
        QVERIFY(estimate("refinement", lattice, {{"block", std::string("32")}})->memoryBytes <
                estimate("refinement", lattice, {{"block", std::string("none")}})->memoryBytes / 2);
        QVERIFY(estimate("refinement", lattice, {{"block", std::string("32")}})->diskBytes >
                estimate("refinement", lattice)->diskBytes);
    }
};

QTEST_GUILESS_MAIN(ImportTest)
#include "import_test.moc"
