// SPDX-License-Identifier: GPL-3.0-or-later
// NIfTI-1, NIfTI-2 and Analyze 7.5: where the samples lie, what they are, what was taken and what was not (D1, D3).
// Files are written byte by byte; each sample is a known function of its place, or its number.
#include "plugins/host/dataset_opening.h"
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/header_files.h"
#include "tests/plugins/readers/lattice/told.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/plugins/readers/world_function.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::uint32_t, 3> testSize{3, 4, 5};

QByteArray worldOf(const Eigen::Matrix3d& steps, const Eigen::Vector3d& origin)
{
    return samplesOfWorld(testSize, steps, origin, 10);
}

} // namespace

class NiftiReaderTest : public QObject {
    Q_OBJECT

private slots:
    void sharedCasesLieWhereTheySay_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* name : {"plain_s.nii.gz", "oblique.nii.gz", "pair.hdr", "pair.img"})
            QTest::newRow(name) << QString(name);
    }
    void sharedCasesLieWhereTheySay()
    {
        QFETCH(QString, file);
        const fs::path path = sharedCases() / "nifti" / file.toStdString();
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = openDataset(host_, path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        QCOMPARE(dataset->space, std::string("RAS"));
        QCOMPARE(dataset->source.path, path);
    }

    void everyOrderOfAxesBySform()
    {
        const Eigen::Vector3d lengths(0.5, 4, 0.25), origin(10, -20.5, 1e3);
        for (const Eigen::Matrix3d& directions : signedPermutations())
            for (const int version : {1, 2}) {
                const Eigen::Matrix3d steps = directions * lengths.asDiagonal();
                NiftiFields fields = niftiBySteps(steps, origin);
                fields.version = version;
                const auto dataset = read(niftiHeader(fields) + worldOf(steps, origin));
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(dataset->lattice.size == testSize);
                QVERIFY(dataset->lattice.spacing == lengths);
                QVERIFY(dataset->lattice.origin == origin);
                QVERIFY(dataset->lattice.directions == directions);
                QVERIFY(distanceFromWorld(*dataset, 10) < 1e-3);
                QCOMPARE(dataset->lengthUnit, std::string("mm"));
                QVERIFY(dataset->remarks.empty() && dataset->source.leftOut.empty());
                QCOMPARE(takenOf(dataset->source.taken, TakenPart::Frame),
                         std::string("frame: sform, coordinates of the scanner"));
            }
    }

    void shearedAndTurned()
    {
        Eigen::Matrix3d steps;
        steps << 1, 0.25, -0.5, 0.125, 2, 0, 0.75, 0, -1;
        const Eigen::Vector3d origin(1, 2, 3);
        const auto dataset = read(niftiHeader(niftiBySteps(steps, origin)) + worldOf(steps, origin));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-5);
        QVERIFY(dataset->domain == DomainClass::RegularLattice);
    }

    /// Also half turns, where the first part of the quaternion is 0, and mirrored by qfac.
    void qformsAreQuaternions()
    {
        const Eigen::Vector3d lengths(0.5, 4, 0.25), origin(10, -20.5, 30);
        for (const double angle : {0.0, 0.3, 1.5, 2.9, std::numbers::pi})
            for (const double qfac : {-1.0, 1.0, 0.0}) {
                const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 2) / 3));
                const Eigen::Vector3d signs(1, 1, qfac < 0 ? -1 : 1);
                const Eigen::Matrix3d steps =
                    turn.toRotationMatrix() * lengths.cwiseProduct(signs).asDiagonal().toDenseMatrix();
                NiftiFields fields;
                fields.version = 2;
                fields.qform = 3;
                fields.quaternion = turn.vec() * (turn.w() < 0 ? -1 : 1);
                fields.qOffset = origin;
                fields.pixdim = {qfac, lengths[0], lengths[1], lengths[2], 0, 0, 0, 0};
                const auto dataset = read(niftiHeader(fields) + worldOf(steps, origin));
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
                QVERIFY(dataset->lattice.spacing.isApprox(lengths, 1e-12));
                QCOMPARE(dataset->lattice.isLeftHanded(), qfac < 0);
                QCOMPARE(takenOf(dataset->source.taken, TakenPart::Frame),
                         std::string("frame: qform, coordinates of Talairach"));
                fields.version = 1;
                const auto inSingle = read(niftiHeader(fields) + worldOf(steps, origin));
                QVERIFY(inSingle.ok() && distanceFromWorld(*inSingle, 10) < 1e-4);
            }
    }

    void whatWasTakenIsTold()
    {
        const Eigen::Matrix3d steps = Eigen::Vector3d(2, 3, 4).asDiagonal();
        NiftiFields fields = niftiBySteps(steps, {1, 2, 3});
        fields.qform = 1;
        fields.qOffset = {1, 2, 3};
        const auto both = read(niftiHeader(fields) + worldOf(steps, {1, 2, 3}));
        QVERIFY(both.ok() && both->source.leftOut.empty()); // they agree
        fields.qOffset = {1, 2, 13};
        const auto moved = read(niftiHeader(fields) + worldOf(steps, {1, 2, 3}));
        QVERIFY(moved.ok() && distanceFromWorld(*moved, 10) < 1e-4);
        QVERIFY(says(moved->source.leftOut, "qform would place it elsewhere, up to 10 away"));
        fields.pixdim[0] = -1;
        QVERIFY(says(read(niftiHeader(fields) + worldOf(steps, {1, 2, 3}))->source.leftOut, "mirrored"));
        fields.pixdim[1] = 5;
        QVERIFY(says(read(niftiHeader(fields) + worldOf(steps, {1, 2, 3}))->source.leftOut, "5 x 3 x 4 apart"));
        NiftiFields flat = niftiBySteps(Eigen::Matrix3d::Zero(), {0, 0, 0}); // as some programs leave it
        flat.pixdim = {1, 2, 3, 4, 0, 0, 0, 0};
        const auto bare = read(niftiHeader(flat) + worldOf(steps, {0, 0, 0}));
        QVERIFY2(bare.ok(), bare.ok() ? "" : bare.error().text().c_str());
        QVERIFY(distanceFromWorld(*bare, 10) < 1e-4);
        QVERIFY(bare->space.empty() && says(bare->source.leftOut, "sform is unusable"));
        QCOMPARE(takenOf(bare->source.taken, TakenPart::Frame),
                 std::string("frame: distances alone (pixdim) (a guess)"));
        flat.qform = 2;
        flat.qOffset = {5, 6, 7};
        const auto byQform = read(niftiHeader(flat) + worldOf(steps, {5, 6, 7}));
        QVERIFY(byQform.ok() && distanceFromWorld(*byQform, 10) < 1e-4);
        const auto contents = probe(niftiHeader(flat) + worldOf(steps, {5, 6, 7}));
        QVERIFY(contents.ok());
        QVERIFY(contents->taken == byQform->source.taken && contents->leftOut == byQform->source.leftOut);
    }

    void theUserSaysWhatTheHeaderDoesNot()
    {
        NiftiFields fields;
        fields.units = 0;
        fields.pixdim = {};
        const QByteArray file = niftiHeader(fields) + testSamples(SampleType::Float32);
        const auto assumed = read(file);
        QVERIFY2(assumed.ok(), assumed.ok() ? "" : assumed.error().text().c_str());
        QVERIFY(says(assumed->remarks, "1 x 1 x 1 is assumed"));
        QVERIFY((probe(file)->untold == std::vector<std::string>{"spacing", "origin", "unit"}));
        const auto placed = readWith(
            file, {{"spacing", std::string("1,2,3")}, {"origin", std::string("4,5,6")}, {"unit", std::string("um")}});
        QVERIFY2(placed.ok(), placed.ok() ? "" : placed.error().text().c_str());
        QVERIFY(placed->lattice.spacing == Eigen::Vector3d(1, 2, 3));
        QVERIFY(placed->lattice.origin == Eigen::Vector3d(4, 5, 6));
        QCOMPARE(placed->lengthUnit, std::string("um"));
        const QByteArray told =
            niftiHeader(niftiBySteps(Eigen::Matrix3d::Identity(), {0, 0, 0})) + testSamples(SampleType::Float32);
        for (const char* id : {"spacing", "origin", "unit", "size"})
            QVERIFY2(readWith(told, {{id, std::string("1,2,3")}}).error().kind == ErrorKind::WrongUsage, id);
    }

    void unitsOfLength()
    {
        for (const auto& [code, unit] : {std::pair{1, "m"}, {2, "mm"}, {3, "um"}, {2 + 8, "mm"}, {0, ""}}) {
            NiftiFields fields;
            fields.units = code;
            QCOMPARE(read(niftiHeader(fields) + testSamples(SampleType::Float32))->lengthUnit, std::string(unit));
        }
    }

    void everyPlainTypeInBothOrders()
    {
        constexpr std::array<std::pair<int, SampleType>, 8> types = {{{2, SampleType::UInt8},
                                                                      {256, SampleType::Int8},
                                                                      {512, SampleType::UInt16},
                                                                      {4, SampleType::Int16},
                                                                      {768, SampleType::UInt32},
                                                                      {8, SampleType::Int32},
                                                                      {16, SampleType::Float32},
                                                                      {64, SampleType::Float64}}};
        for (const auto& [code, type] : types)
            for (const std::endian order : {std::endian::little, std::endian::big})
                for (const int version : {1, 2}) {
                    NiftiFields fields{.version = version, .order = order, .type = code};
                    fields.extension = QByteArray(32, 'x');
                    const auto dataset = read(niftiHeader(fields) + testSamples(type, order));
                    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                    QVERIFY(dataset->values.type() == type);
                    QVERIFY(holdsTestSamples(dataset->values));
                    QCOMPARE(dataset->mappedFile != nullptr, order == std::endian::native || sampleSize(type) == 1);
                }
    }

    void wideIntegersBecomeWhatHoldsThem()
    {
        const auto of = [&](int code, const QByteArray& samples) {
            return read(niftiHeader({.type = code}) + samples);
        };
        const auto small = of(1024, counted<std::int64_t>(testPoints, -3));
        QVERIFY(small.ok() && small->values.type() == SampleType::Int32 && small->values.at(0) == -3);
        const auto middle = of(1280, counted<std::uint64_t>(testPoints, 4'000'000'000));
        QVERIFY(middle.ok() && middle->values.type() == SampleType::UInt32 && middle->values.at(1) == 4'000'000'001);
        const auto wide = of(1024, counted<std::int64_t>(testPoints, std::int64_t(1) << 40));
        QVERIFY(wide.ok() && wide->values.type() == SampleType::Float64 && wide->remarks.empty());
        QCOMPARE(wide->values.at(59), std::ldexp(1.0, 40) + 59);
        const auto lossy = of(1280, counted<std::uint64_t>(testPoints, std::uint64_t(1) << 63));
        QVERIFY(lossy.ok() && says(lossy->remarks, "53 bits"));
        QCOMPARE(lossy->values.at(0), std::ldexp(1.0, 63));
        QVERIFY(!probe(niftiHeader({.type = 1024}) + counted<std::int64_t>(testPoints, 0))->type);
    }

    void samplesAreScaled()
    {
        for (const auto& [code, stored, type] : {std::tuple{4, SampleType::Int16, SampleType::Float32},
                                                 {2, SampleType::UInt8, SampleType::Float32},
                                                 {8, SampleType::Int32, SampleType::Float64},
                                                 {64, SampleType::Float64, SampleType::Float64}}) {
            const auto dataset = read(niftiHeader({.type = code, .slope = 0.5, .intercept = -7}) + testSamples(stored));
            QVERIFY(dataset.ok() && dataset->values.type() == type);
            for (int n = 0; n < testPoints; ++n)
                QCOMPARE(dataset->values.at(static_cast<std::uint64_t>(n)), n * 0.5 - 7);
            QVERIFY(says(dataset->remarks, "multiplied by 0.5, and -7 was added"));
        }
        // A float holds no hundredths beside a million.
        const auto fine = read(niftiHeader({.version = 2, .type = 4, .slope = 0.01, .intercept = 1e6}) +
                               testSamples(SampleType::Int16));
        QVERIFY(fine.ok() && fine->values.type() == SampleType::Float64);
        QCOMPARE(fine->values.at(7), 7 * 0.01 + 1e6);
        for (const double slope : {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
            const auto plain = read(niftiHeader({.type = 4, .slope = slope}) + testSamples(SampleType::Int16));
            QVERIFY(plain.ok() && plain->values.type() == SampleType::Int16 && plain->remarks.empty());
        }
    }

    void volumesAreChosen()
    {
        NiftiFields fields{.dim = {5, 3, 4, 5, 2, 3, 1, 1}};
        fields.pixdim[4] = 0.5;
        fields.timeOffset = 10;
        const QByteArray file = niftiHeader(fields) + counted<float>(6 * testPoints, 0);
        for (std::int64_t time = 1; time <= 6; ++time) {
            const auto dataset = readWith(file, {{"time", time}});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->values.at(0), static_cast<double>((time - 1) * testPoints));
            QCOMPARE(dataset->values.at(59), static_cast<double>(time * testPoints - 1));
            QVERIFY(says(dataset->source.leftOut, "It holds 6 volumes; the others are not read."));
        }
        QCOMPARE(takenOf(readWith(file, {{"time", std::int64_t(2)}})->source.taken, TakenPart::TimeStep),
                 std::string("time step: 2 of 6, time 10.5"));
        QCOMPARE(probe(file)->timeSteps.size(), std::size_t(6));
        for (const std::int64_t time : {0, 7})
            QVERIFY(readWith(file, {{"time", time}}).error().kind == ErrorKind::WrongUsage);
        QVERIFY(!readWith(niftiHeader({}) + testSamples(SampleType::Float32), {{"time", std::int64_t(2)}}).ok());
    }

    void vectorsColoursAndComplexNumbersHaveComponents()
    {
        // Vectors: the fifth dimension, each component a volume of its own.
        NiftiFields vectors{.dim = {5, 3, 4, 5, 1, 3, 1, 1}, .intent = 1007};
        const QByteArray file = niftiHeader(vectors) + counted<float>(3 * testPoints, 0);
        const auto second = readWith(file, {{"component", std::string("1")}});
        QVERIFY2(second.ok(), second.ok() ? "" : second.error().text().c_str());
        QCOMPARE(second->values.at(5), 65.0);
        const auto length = read(file);
        QVERIFY(length.ok() && length->values.type() == SampleType::Float32);
        QCOMPARE(length->values.at(5),
                 static_cast<double>(static_cast<float>(std::sqrt(5. * 5 + 65 * 65 + 125 * 125))));
        QCOMPARE(takenOf(length->source.taken, TakenPart::Component),
                 std::string("component: magnitude of 3 (a guess)"));
        QCOMPARE(probe(file)->arrays.at(0).components, 3);
        // Others stand side by side.
        const auto red = readWith(niftiHeader({.type = 128, .slope = 3}) + counted<std::uint8_t>(3 * testPoints, 0),
                                  {{"component", std::string("2")}});
        QVERIFY(red.ok() && red->values.type() == SampleType::UInt8);
        QCOMPARE(red->values.at(10), 32.0);
        const auto imaginary =
            readWith(niftiHeader({.type = 32}) + counted<float>(2 * testPoints, 0), {{"component", std::string("1")}});
        QVERIFY(imaginary.ok());
        QCOMPARE(imaginary->values.at(10), 21.0);
        for (const char* component : {"3", "-1", "x"})
            QVERIFY(readWith(file, {{"component", std::string(component)}}).error().kind == ErrorKind::WrongUsage);
    }

    void pairsOpenFromEitherFile()
    {
        for (const int version : {1, 2}) {
            const fs::path header =
                folder_.write("pair.hdr", niftiHeader({.version = version, .isPair = true, .type = 4}));
            const fs::path samples = folder_.write("pair.img", testSamples(SampleType::Int16));
            for (const fs::path& path : {header, samples}) {
                const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(holdsTestSamples(dataset->values));
                QCOMPARE(dataset->source.path, path);
                QVERIFY(dataset->mappedFile != nullptr);
            }
        }
        const fs::path lonely = folder_.write("lonely.hdr", niftiHeader({.isPair = true}));
        QVERIFY(
            says({asLoaded<LatticeReader>().read(lonely, {}, {}).error().message}, "'lonely.img', which is missing"));
    }

    void packedFilesAreUnpackedByTheProgram()
    {
        const QByteArray file = niftiHeader({.type = 4}) + testSamples(SampleType::Int16);
        const auto one = openDataset(host_, folder_.write("packed.nii.gz", gzipped(file)), {}, {});
        QVERIFY2(one.ok(), one.ok() ? "" : one.error().text().c_str());
        QVERIFY(holdsTestSamples(one->values));
        folder_.write("both.img.gz", gzipped(testSamples(SampleType::Int16)));
        const auto pair =
            openDataset(host_, folder_.write("both.hdr.gz", gzipped(niftiHeader({.isPair = true, .type = 4}))), {}, {});
        QVERIFY2(pair.ok(), pair.ok() ? "" : pair.error().text().c_str());
        QVERIFY(holdsTestSamples(pair->values));
    }

    void analyzeSaysLittle()
    {
        NiftiFields fields{.version = 0, .order = std::endian::big, .type = 4};
        fields.pixdim = {0, 2, 3, 4, 0, 0, 0, 0};
        folder_.write("old.img", testSamples(SampleType::Int16, std::endian::big));
        const auto old = asLoaded<LatticeReader>().read(folder_.write("old.hdr", niftiHeader(fields)), {}, {});
        QVERIFY2(old.ok(), old.ok() ? "" : old.error().text().c_str());
        QVERIFY(holdsTestSamples(old->values));
        QVERIFY(old->lattice.spacing == Eigen::Vector3d(2, 3, 4) && old->lattice.isAlongAxes());
        QVERIFY(old->space.empty() && says(old->source.leftOut, "which side of it is the left one"));
        fields.originator = {2, 1, 3};
        fields.slope = 0.5;
        const auto ofSpm = asLoaded<LatticeReader>().read(folder_.write("old.hdr", niftiHeader(fields)), {}, {});
        QVERIFY(ofSpm.ok() && ofSpm->lattice.origin == Eigen::Vector3d(-2, 0, -8));
        QCOMPARE(ofSpm->values.at(7), 3.5);
        QCOMPARE(ofSpm->lengthUnit, std::string("mm"));
    }

    void refusalsAreTrue_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("words");
        const QByteArray samples = testSamples(SampleType::Float32);
        const auto row = [&](const char* name, const NiftiFields& fields, const char* words) {
            QTest::newRow(name) << niftiHeader(fields) + samples << QByteArray(words);
        };
        row("128 bits", {.type = 1536}, "128 bits");
        row("bits", {.type = 1}, "single bits");
        row("an unknown type", {.type = 17}, "type 17");
        row("a picture", {.dim = {2, 3, 4, 1, 1, 1, 1, 1}}, "at least 2 along each axis");
        row("no dimensions", {.dim = {0, 3, 4, 5, 1, 1, 1, 1}}, "0 dimensions");
        row("eight dimensions", {.version = 2, .dim = {8, 3, 4, 5, 1, 1, 1, 1}}, "8 dimensions");
        row("negative", {.dim = {3, 3, -4, 5, 1, 1, 1, 1}}, "-4 points");
        row("more than there is", {.dim = {3, 3, 4, 6, 1, 1, 1, 1}}, "288 bytes, but there are only 240 bytes");
        row("more than any file", {.version = 2, .dim = {7, 3, 4, 5, 1 << 30, 1 << 30, 1 << 30, 1 << 30}},
            "more samples than any file");
        row("huge", {.version = 2, .dim = {3, 1LL << 62, 4, 5, 1, 1, 1, 1}}, "points");
        QTest::newRow("text") << QByteArray(400, 'x') << QByteArray("does not begin like a header of NIfTI");
        QTest::newRow("short") << QByteArray("n+1") << QByteArray("it has 3 bytes");
        QByteArray early = niftiHeader({}) + samples;
        early.replace(108, 4, numberBytes(100.F));
        QTest::newRow("samples in the header") << early << QByteArray("begin at byte 100");
        early.replace(108, 4, numberBytes(std::numeric_limits<float>::quiet_NaN()));
        QTest::newRow("samples nowhere") << early << QByteArray("which is impossible");
    }
    void refusalsAreTrue()
    {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, words);
        const auto dataset = read(file);
        QVERIFY(!dataset.ok());
        QVERIFY(dataset.error().kind == ErrorKind::BadInput);
        QVERIFY2(dataset.error().text().find(words.constData()) != std::string::npos, dataset.error().text().c_str());
        QVERIFY(probe(file).error().text() == dataset.error().text());
    }

    void cutFilesAreRefused()
    {
        const QByteArray file = niftiHeader({.type = 4}) + testSamples(SampleType::Int16);
        for (qsizetype size = 0; size < file.size(); ++size)
            QVERIFY2(!read(file.first(size)).ok(), QByteArray::number(size));
        const auto longer = read(file + "xyz");
        QVERIFY(longer.ok() && says(longer->source.leftOut, "3 bytes after its samples were not read."));
        QVERIFY(probe(file + "xyz")->leftOut == longer->source.leftOut);
    }

    void otherHeadersAreNotTakenForThese()
    {
        const LatticeReader reader;
        const auto score = [&](const char* name, const QByteArray& bytes) {
            return reader.score(name,
                                std::as_bytes(std::span(bytes.constData(), static_cast<std::size_t>(bytes.size()))));
        };
        QVERIFY(score("a.hdr", "ENVI\ndescription = {}") < 0.3);
        QVERIFY(score("a.hdr", niftiHeader({.version = 0})) > 0.9);
        QVERIFY(score("a.dat", niftiHeader({.version = 0})) < 0.5);
        QVERIFY(score("a.dat", niftiHeader({})) > 0.9);
        QCOMPARE(score("a.nii.gz", "\x1f\x8b"), 0.);
        QVERIFY(score("a.img", "xx") < 0.5);
    }

private:
    Result<Dataset> read(const QByteArray& file) { return readWith(file, {}); }
    Result<Dataset> readWith(const QByteArray& file, const ParameterValues& values)
    {
        return asLoaded<LatticeReader>().read(folder_.write("volume.nii", file), values, {});
    }
    Result<FileContents> probe(const QByteArray& file)
    {
        return asLoaded<LatticeReader>().probe(folder_.write("volume.nii", file), {}, {});
    }

    TestFolder folder_;
    PluginHost host_{{.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}}};
};

QTEST_GUILESS_MAIN(NiftiReaderTest)
#include "nifti_reader_test.moc"
