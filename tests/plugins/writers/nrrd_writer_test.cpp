// SPDX-License-Identifier: GPL-3.0-or-later
// What is written is read back bit for bit, and a write that fails leaves the target as it was.
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/samples/samples.h"
#include "tests/core/base/small_disk.h"
#include "tests/plugins/plugins_of_this_build.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

#include <unistd.h>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

Dataset volume(SampleType type, std::uint32_t size = 9)
{
    SampleRequest request{"noise", size, type, 7};
    Result<Dataset> made = makeSample(request);
    return *std::move(made);
}

ParameterValues encoded(const char* encoding)
{
    return {{"encoding", std::string(encoding)}};
}

bool identical(const Dataset& a, const Dataset& b)
{
    return a.lattice.size == b.lattice.size && a.lattice.spacing == b.lattice.spacing &&
           a.lattice.origin == b.lattice.origin && a.lattice.directions == b.lattice.directions && a.space == b.space &&
           a.lengthUnit == b.lengthUnit && a.values.type() == b.values.type() &&
           std::ranges::equal(a.values.bytes(), b.values.bytes());
}

Status saveNrrd(const Dataset& dataset, const fs::path& path, const ParameterValues& values, const Progress& progress)
{
    const auto saved = saveDataset(pluginsOfThisBuild(), dataset, path, values, progress);
    return saved ? Status() : Status(saved.error());
}

QByteArray content(const fs::path& path)
{
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

int filesIn(const fs::path& folder)
{
    return static_cast<int>(std::distance(fs::directory_iterator(folder), {}));
}

} // namespace

class NrrdWriterTest : public QObject {
    Q_OBJECT

private slots:
    void roundTrip_data();
    void roundTrip();
    void anyPlaceSurvives();
    void anyFrameSurvives();
    void gzipIsSmaller();
    void anyNameIsOneLine();
    void overwritesAtTheEndOnly();
    void leavesNothingBehindOnAFullDisk();
    void refusesWhatCannotBeWritten();
    void refusesUnknownEncodings();
    void endingsChooseTheWriter();
};

void NrrdWriterTest::roundTrip_data()
{
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<QByteArray>("encoding");
    for (int number = 0; number < 8; ++number)
        for (const char* encoding : {"raw", "gzip"}) {
            const auto type = static_cast<SampleType>(number);
            QTest::newRow(QByteArray(sampleTypeName(type).data()) + " " + encoding) << type << QByteArray(encoding);
        }
}

void NrrdWriterTest::roundTrip()
{
    QFETCH(SampleType, type);
    QFETCH(QByteArray, encoding);
    const TestFolder folder;
    Dataset dataset = volume(type);
    dataset.lattice.spacing = {0.1, 1.0 / 3, 3e-7};
    dataset.lattice.origin = {-1e-300, 12345.678, -0.1};
    const fs::path path = folder.path() / "volume.nrrd";
    const Status written = saveNrrd(dataset, path, encoded(encoding), {});
    QVERIFY2(written.ok(), written.ok() ? "" : written.error().text().c_str());
    const Result<Dataset> again = openDataset(pluginsOfThisBuild(), path);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
    QVERIFY(identical(*again, dataset));
    QCOMPARE(quint64(again->source.hash), quint64(dataset.source.hash));
    QCOMPARE(again->mappedFile != nullptr, encoding == "raw"); // its samples are aligned
    QCOMPARE(filesIn(folder.path()), 1);
}

/// Spacings and origins with all their digits.
void NrrdWriterTest::anyPlaceSurvives()
{
    const TestFolder folder;
    Dataset dataset = volume(SampleType::UInt8, 2);
    for (int i = 1; i < 60; ++i) {
        dataset.lattice.spacing = {std::sqrt(i), std::exp(i * 0.5), 1 / (i + 0.7)};
        dataset.lattice.origin = {-std::sqrt(i * 3), std::sin(i), i / 7.0};
        const fs::path path = folder.path() / "place.nrrd";
        QVERIFY(saveNrrd(dataset, path, {}, {}).ok());
        const Result<Dataset> again = openDataset(pluginsOfThisBuild(), path);
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
        QVERIFY(identical(*again, dataset));
    }
}

void NrrdWriterTest::gzipIsSmaller()
{
    const TestFolder folder;
    const Result<Dataset> dataset = makeSample({"c60", 40, {}, 1});
    QVERIFY(saveNrrd(*dataset, folder.path() / "raw.nrrd", {}, {}).ok());
    QVERIFY(saveNrrd(*dataset, folder.path() / "gzip.nrrd", encoded("gzip"), {}).ok());
    QVERIFY(fs::file_size(folder.path() / "gzip.nrrd") < fs::file_size(folder.path() / "raw.nrrd") * 3 / 4);
}

/// Exactly where axes run along those of the world; directions at an angle but for a rounding.
void NrrdWriterTest::anyFrameSurvives()
{
    const TestFolder folder;
    const fs::path path = folder.path() / "frame.nrrd";
    Dataset dataset = volume(SampleType::UInt8, 3);
    dataset.lattice.spacing = {0.1, 1.0 / 3, 3e-7};
    dataset.lattice.origin = {-1e-3, 12345.678, -0.1};
    const std::array<const char*, 4> spaces{"", "RAS", "LAS", "LPS"};
    std::size_t frame = 0;
    for (const Eigen::Matrix3d& directions : signedPermutations()) {
        dataset.lattice.directions = directions;
        dataset.space = spaces[frame++ % spaces.size()];
        dataset.lengthUnit = frame % 3 == 0 ? "" : "\xc2\xb5m";
        QVERIFY(saveNrrd(dataset, path, {}, {}).ok());
        const Result<Dataset> again = openDataset(pluginsOfThisBuild(), path);
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
        QVERIFY(identical(*again, dataset));
    }
    for (int i = 0; i < 50; ++i) {
        Eigen::Matrix3d& directions = dataset.lattice.directions;
        directions = Eigen::AngleAxisd(i * 0.7 + 0.1, Eigen::Vector3d(i, 1, 3).normalized()).toRotationMatrix();
        directions.col(1) = (directions.col(1) + i % 5 * 0.2 * directions.col(2)).normalized();
        QVERIFY(saveNrrd(dataset, path, {}, {}).ok());
        const Result<Dataset> again = openDataset(pluginsOfThisBuild(), path);
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
        QVERIFY(again->lattice.directions.isApprox(directions, 1e-14));
        QVERIFY(again->lattice.spacing.isApprox(dataset.lattice.spacing, 1e-14));
        QVERIFY(again->lattice.origin == dataset.lattice.origin);
    }
}

void NrrdWriterTest::anyNameIsOneLine()
{
    const TestFolder folder;
    Dataset dataset = volume(SampleType::UInt8, 3);
    dataset.source.name = "two\n\nlines: \xff " + std::string(1000, 'x');
    const fs::path path = folder.path() / "name.nrrd";
    QVERIFY(saveNrrd(dataset, path, {}, {}).ok());
    const Result<Dataset> again = openDataset(pluginsOfThisBuild(), path);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
    QVERIFY(identical(*again, dataset));
}

void NrrdWriterTest::overwritesAtTheEndOnly()
{
    const TestFolder folder;
    const fs::path path = folder.write("old.nrrd", "the old content");
    const Dataset dataset = volume(SampleType::Float64, 100);
    for (const char* encoding : {"raw", "gzip"}) {
        std::stop_source stop;
        const Progress cancelling(stop.get_token(), [&](double fraction, const Message&) {
            if (fraction > 0.1) // in the midst of it
                stop.request_stop();
        });
        const Status cancelled = saveNrrd(dataset, path, encoded(encoding), cancelling);
        QVERIFY(!cancelled.ok());
        QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
        QCOMPARE(content(path), QByteArray("the old content"));
        QCOMPARE(filesIn(folder.path()), 1);
    }
    QVERIFY(saveNrrd(dataset, path, {}, {}).ok());
    QVERIFY(content(path).startsWith("NRRD0004\n"));
}

void NrrdWriterTest::leavesNothingBehindOnAFullDisk()
{
    const SmallDisk disk(65536);
    if (!disk.ok())
        QSKIP("skipped: this user may not mount a disk");
    const Dataset dataset = volume(SampleType::Float64, 64);
    for (const char* encoding : {"raw", "gzip"}) {
        const Status written = saveNrrd(dataset, disk.folder() / "volume.nrrd", encoded(encoding), {});
        QVERIFY(!written.ok());
        QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
        QVERIFY(written.error().text().find("volume.nrrd") != std::string::npos);
        QCOMPARE(filesIn(disk.folder()), 0);
    }
}

void NrrdWriterTest::refusesWhatCannotBeWritten()
{
    const TestFolder folder;
    const Dataset dataset = volume(SampleType::UInt8, 3);
    const fs::path missing = folder.path() / "no folder" / "volume.nrrd";
    fs::create_directory(folder.path() / "folder.nrrd");
    for (const fs::path& path : {missing, folder.path() / "folder.nrrd"}) {
        const Status written = saveNrrd(dataset, path, {}, {});
        QVERIFY(!written.ok());
        QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
    }
    const fs::path protectedFile = folder.write("protected.nrrd", "old");
    fs::permissions(protectedFile, fs::perms::owner_read);
    const Status written = saveNrrd(dataset, protectedFile, {}, {});
    QVERIFY(!written.ok());
    QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
    QCOMPARE(content(protectedFile), QByteArray("old"));
}

void NrrdWriterTest::refusesUnknownEncodings()
{
    const TestFolder folder;
    const Status written = saveNrrd(volume(SampleType::UInt8, 3), folder.path() / "x.nrrd", encoded("zip"), {});
    QVERIFY(!written.ok());
    QCOMPARE(written.error().kind, ErrorKind::WrongUsage);
    QCOMPARE(filesIn(folder.path()), 0);
}

/// In small or in capital letters; and what there is to choose from is told.
void NrrdWriterTest::endingsChooseTheWriter()
{
    PluginHost& host = pluginsOfThisBuild();
    for (const char* name : {"a.nrrd", "a.NRRD"})
        QVERIFY2(checkWritable(host, WrittenContent::Dataset, name, encoded("gzip")).ok(), name);
    for (const char* name : {"a.nrrd.gz", "nrrd", "a.csv"}) // the table has no encoding
        QCOMPARE(checkWritable(host, WrittenContent::Dataset, name, encoded("gzip")).error().kind,
                 ErrorKind::WrongUsage);
    QVERIFY(checkWritable(host, WrittenContent::Dataset, "a.csv").ok());
    QVERIFY(!checkWritable(host, WrittenContent::Mesh, "a.nrrd").ok());
    QCOMPARE(writableEndings(host, WrittenContent::Dataset),
             (std::vector<std::string>{".csv", ".nrrd", ".vtu", ".xyz"}));
    QCOMPARE(writableEndings(host, WrittenContent::Mesh), writableEndings(host, WrittenContent::Surface));
    QVERIFY(isSurfaceFileOnly(host, "a.STL") && !isSurfaceFileOnly(host, "a.vtk") && !isSurfaceFileOnly(host, "a.b"));
    const auto meshes = writableFormats(host, WrittenContent::Mesh);
    QCOMPARE(meshes.size(), std::size_t(2)); // without those that hold a boundary alone
    QVERIFY(std::ranges::is_sorted(meshes, {}, &FileFormat::name));
    const auto parameters = writerParameters(host, WrittenContent::Dataset);
    QCOMPARE(parameters.size(), std::size_t(1));
    QCOMPARE(parameters.front().id, std::string("encoding"));
    QVERIFY(writerParameters(host, WrittenContent::Mesh).empty());
}

QTEST_GUILESS_MAIN(NrrdWriterTest)
#include "nrrd_writer_test.moc"
