// SPDX-License-Identifier: GPL-3.0-or-later
// The literature's volumes, with the sizes, types and ranges that ../shared/data/README.md states.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"

#include <QTest>

#include <filesystem>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

const fs::path dataFolder = fs::path(TAN_SOURCE_DIR) / ".." / "shared" / "data";

} // namespace

class RealVolumesTest : public QObject {
    Q_OBJECT

private slots:
    void areRead_data();
    void areRead();
    void areReadAsRawFiles();
};

void RealVolumesTest::areRead_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QList<int>>("size");
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<QList<double>>("range");
    QTest::addColumn<QList<double>>("spacing");
    const auto row = [](const char* file, const QList<int>& size, SampleType type, const QList<double>& range,
                        const QList<double>& spacing = {1, 1, 1}) {
        QTest::newRow(file) << file << size << type << range << spacing;
    };
    row("buckyball/bucky_32x32x32_uint8.nhdr", {32, 32, 32}, SampleType::UInt8, {0, 255});
    row("buckyball/c60large_128x128x128_uint8.nhdr", {128, 128, 128}, SampleType::UInt8, {0, 255});
    row("sod/sod_97x97x116_uint8.nhdr", {97, 97, 116}, SampleType::UInt8, {0, 255});
    row("sod/sod_sub_32x32x32_uint8.nhdr", {32, 32, 32}, SampleType::UInt8, {0, 255});
    row("regular/engine_256x256x128_uint8.nrrd", {256, 256, 128}, SampleType::UInt8, {0, 255});
    row("regular/aneurism_256x256x256_uint8.nrrd", {256, 256, 256}, SampleType::UInt8, {0, 255});
    row("regular/bonsai_256x256x256_uint8.nrrd", {256, 256, 256}, SampleType::UInt8, {0, 255});
    row("regular/lobster_120x120x34_uint8.nrrd", {120, 120, 34}, SampleType::UInt8, {0, 255});
    row("regular/neghip_64x64x64_uint8.nhdr", {64, 64, 64}, SampleType::UInt8, {0, 255});
    row("regular/hydrogen_64x64x64_float.nrrd", {64, 64, 64}, SampleType::Float32, {0, 1});
    row("regular/headsq_64x64x93_int16.nrrd", {64, 64, 93}, SampleType::Int16, {0, 3926}, {3.2, 3.2, 1.5});
}

void RealVolumesTest::areRead()
{
    QFETCH(QString, file);
    QFETCH(QList<int>, size);
    QFETCH(SampleType, type);
    QFETCH(QList<double>, range);
    QFETCH(QList<double>, spacing);
    const fs::path path = dataFolder / file.toStdString();
    if (!fs::exists(path))
        QSKIP_WITHOUT("data");
    const Result<Dataset> dataset = asLoaded<LatticeReader>().read(path, {}, {});
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    for (int axis = 0; axis < 3; ++axis) {
        QCOMPARE(static_cast<int>(dataset->lattice.size[static_cast<std::size_t>(axis)]), size[axis]);
        QCOMPARE(dataset->lattice.spacing[axis], spacing[axis]);
        QCOMPARE(dataset->lattice.origin[axis], 0.0);
    }
    QCOMPARE(dataset->values.type(), type);
    QCOMPARE(dataset->values.count(), dataset->lattice.pointCount());
    QCOMPARE(dataset->values.range().minimum, range[0]);
    QCOMPARE(dataset->values.range().maximum, range[1]);
    QCOMPARE(dataset->source.path, path);
    QCOMPARE(dataset->source.name, path.filename().string());
    QVERIFY(dataset->source.hash != 0);
}

/// The molecule's file without a header gives what its cropped NRRD twin gives.
void RealVolumesTest::areReadAsRawFiles()
{
    const fs::path path = dataFolder / "sod" / "Molecule_U8_X100_Y100_Z120.binary";
    if (!fs::exists(path))
        QSKIP_WITHOUT("data");
    const Result<Dataset> raw = asLoaded<LatticeReader>().read(path, {{"size", std::string("100x100x120")}}, {});
    QVERIFY2(raw.ok(), raw.ok() ? "" : raw.error().text().c_str());
    const Result<Dataset> cropped =
        asLoaded<LatticeReader>().read(dataFolder / "sod" / "sod_97x97x116_uint8.nhdr", {}, {});
    QVERIFY(cropped.ok());
    for (std::uint64_t point = 0; point < cropped->values.count(); ++point) {
        const auto [i, j, k] = cropped->lattice.coordinates(point);
        QCOMPARE(cropped->values.at(point), raw->values.at(raw->lattice.index(i, j, k)));
    }
}

QTEST_GUILESS_MAIN(RealVolumesTest)
#include "real_volumes_test.moc"
