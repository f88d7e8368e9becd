// SPDX-License-Identifier: GPL-3.0-or-later
// MetaImages: where the samples lie, in whatever files and packing they are, what was taken and what was not (D1, D3).
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
#include <fstream>
#include <iterator>
#include <map>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::uint32_t, 3> testSize{3, 4, 5};

QByteArray numbersText(const double* numbers, int count)
{
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? " " : "") + QByteArray::fromStdString(formatNumber(numbers[i]));
    return text;
}

/// The names of the fields that place it.
struct PlaceNames {
    QByteArray matrix = "TransformMatrix", offset = "Offset", spacing = "ElementSpacing";
};

/// With the function of the world as samples; a direction in each row of the matrix.
QByteArray worldImage(const Eigen::Matrix3d& directions, const Eigen::Vector3d& spacing, const Eigen::Vector3d& origin,
                      const PlaceNames& names = {}, const QByteArray& more = "")
{
    return metaHeader(names.matrix + " = " + numbersText(directions.data(), 9) + "\n" + names.offset + " = " +
                      numbersText(origin.data(), 3) + "\n" + names.spacing + " = " + numbersText(spacing.data(), 3) +
                      "\n" + more) +
           samplesOfWorld(testSize, directions * spacing.asDiagonal(), origin, 10);
}

/// Turned about an axis at an angle, and the third one leaning if it is sheared.
Eigen::Matrix3d turned(double angle, double shear)
{
    Eigen::Matrix3d directions = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    directions.col(2) = (directions.col(2) + shear * directions.col(0)).normalized();
    return directions;
}

QByteArray zlibPacked(const QByteArray& bytes)
{
    return qCompress(bytes, 9).mid(4); // without its own length before the zlib stream
}

/// A volume of floats 0 to 59 in one of the ways in which the format lays them down.
struct Arrangement {
    QByteArray opened;                                     ///< the file's content
    std::vector<std::pair<QByteArray, QByteArray>> data{}; ///< other files: names and contents
};

std::map<QByteArray, Arrangement> arrangements()
{
    const QByteArray samples = testSamples(SampleType::Float32), packed = zlibPacked(samples);
    const QByteArray packedFields =
        "CompressedData = True\nCompressedDataSize = " + QByteArray::number(packed.size()) + "\n";
    QByteArray text;
    for (int n = 0; n < testPoints; ++n)
        text += QByteArray::number(n) + (n % 7 == 0 ? "\n" : " ");
    const auto layers = [&](const char* format, int first, int step) {
        std::vector<std::pair<QByteArray, QByteArray>> files;
        for (int k = 0; k < 5; ++k)
            files.emplace_back(QString::asprintf(format, first + k * step).toLatin1(), samples.mid(48 * k, 48));
        return files;
    };
    return {
        {"one file", {metaHeader("") + samples}},
        {"beside", {metaHeader("", "image.raw"), {{"image.raw", samples}}}},
        {"behind a header", {metaHeader("HeaderSize = 7\n", "image.raw"), {{"image.raw", "1234567" + samples}}}},
        {"at the end", {metaHeader("HeaderSize = -1\n", "image.raw"), {{"image.raw", "12345" + samples}}}},
        {"packed in one file", {metaHeader(packedFields) + packed}},
        {"packed, of unknown size", {metaHeader("CompressedData = True\n") + packed}},
        {"packed beside", {metaHeader("CompressedData = True\n", "image.zraw"), {{"image.zraw", packed}}}},
        {"packed by gzip", {metaHeader("", "image.raw"), {{"image.raw.gz", gzipped(samples)}}}},
        {"text", {metaHeader("BinaryData = False\n") + text}},
        {"list",
         {metaHeader("", "LIST") + "layer0.raw\nlayer1.raw\nlayer2.raw\nlayer3.raw\nlayer4.raw\n",
          layers("layer%d.raw", 0, 1)}},
        {"list of one", {metaHeader("", "LIST 3") + "image.raw\n", {{"image.raw", samples}}}},
        {"series", {metaHeader("", "layer%03d.raw 2 10 2"), layers("layer%03d.raw", 2, 2)}},
        {"big endian",
         {metaHeader("BinaryDataByteOrderMSB = True\n") + testSamples(SampleType::Float32, std::endian::big)}},
        {"by its other name",
         {metaHeader("ElementByteOrderMSB = True\n").replace("BinaryDataByteOrderMSB = False\n", "") +
          testSamples(SampleType::Float32, std::endian::big)}},
    };
}

} // namespace

class MetaImageReaderTest : public QObject {
    Q_OBJECT

private slots:
    void sharedCasesLieWhereTheySay_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("backwards along x and y") << "flip_xy.mha";
        QTest::newRow("backwards along z") << "flip_z.mha";
    }
    void sharedCasesLieWhereTheySay()
    {
        QFETCH(QString, file);
        const fs::path path = sharedCases() / "metaimage" / file.toStdString();
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        QCOMPARE(dataset->space, std::string("LPS"));
        QVERIFY(dataset->remarks.empty());
    }

    /// Without BinaryData samples are binary.
    void sharedCaseWithoutBinaryData()
    {
        const fs::path folder = sharedCases() / "metaimage";
        if (!fs::exists(folder))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = asLoaded<LatticeReader>().read(folder / "nobinary.mhd", {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        std::ifstream raw(folder / "vol.raw", std::ios::binary);
        const std::string samples{std::istreambuf_iterator<char>(raw), {}};
        const auto bytes = dataset->values.bytes();
        QVERIFY(samples == std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        QVERIFY(dataset->lattice.isAlongAxes());
        QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(1, 2, 3));
    }

    void everyOrderOfAxes()
    {
        const Eigen::Vector3d spacing(0.1, 4, 1.0 / 3), origin(10, -20.5, 1e3);
        for (const Eigen::Matrix3d& directions : signedPermutations()) {
            const auto dataset = read(worldImage(directions, spacing, origin));
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(dataset->lattice.size == testSize);
            QVERIFY(dataset->lattice.spacing == spacing);
            QVERIFY(dataset->lattice.origin == origin);
            QVERIFY(dataset->lattice.directions == directions);
            QVERIFY(distanceFromWorld(*dataset, 10) < 1e-3);
            QCOMPARE(dataset->space, std::string("LPS"));
        }
    }

    void turnedShearedAndNamedOtherwise()
    {
        const Eigen::Vector3d spacing(3, 4, 5), origin(10, -20.5, 100);
        for (const auto& [angle, shear] : {std::pair{2.9, 0.0}, {0.7, 0.4}})
            for (const char* matrix : {"TransformMatrix", "Orientation", "Rotation"})
                for (const char* offset : {"Offset", "Position", "Origin"}) {
                    const auto dataset =
                        read(worldImage(turned(angle, shear), spacing, origin, {matrix, offset, "ElementSize"}));
                    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                    QVERIFY(dataset->lattice.spacing == spacing);
                    QVERIFY(dataset->lattice.origin == origin);
                    QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
                }
        const auto both =
            read(worldImage(turned(1, 0), spacing, origin, {}, "Position = 0 0 0\nElementSize = 9 9 9\n"));
        QVERIFY(both.ok() && distanceFromWorld(*both, 10) < 1e-4);
        QVERIFY(says(both->source.leftOut, "Offset was used, and Position (0 0 0) was not"));
    }

    /// Few digits in a header make lengths that are not quite 1; places are those of the numbers. ITK mirrors where
    /// spacings are negative.
    void directionsOfOtherLengths()
    {
        const Eigen::Matrix3d rounded = (turned(0.5, 0) * 100).array().round() / 100;
        const auto dataset = read(worldImage(rounded, {1, 2, 3}, {4, 5, 6}));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        const auto mirrored = read(worldImage(turned(0.3, 0), {1, -2, 3}, {4, 5, 6}));
        QVERIFY2(mirrored.ok(), mirrored.ok() ? "" : mirrored.error().text().c_str());
        QVERIFY(mirrored->lattice.spacing == Eigen::Vector3d(1, 2, 3));
        QVERIFY(mirrored->lattice.isLeftHanded());
        QVERIFY(distanceFromWorld(*mirrored, 10) < 1e-4);
    }

    void orientationThatContradictsIsTold_data()
    {
        QTest::addColumn<QByteArray>("stated");
        QTest::addColumn<bool>("contradicts");
        QTest::newRow("by where axes begin") << QByteArray("RAI") << false;
        QTest::newRow("by where they end") << QByteArray("LPS") << false;
        QTest::newRow("unknown") << QByteArray("??? ") << false;
        QTest::newRow("another") << QByteArray("RPI") << true;
    }
    void orientationThatContradictsIsTold()
    {
        QFETCH(QByteArray, stated);
        QFETCH(bool, contradicts);
        const auto dataset = read(worldImage(Eigen::Matrix3d::Identity(), {1, 2, 3}, {4, 5, 6}, {},
                                             "AnatomicalOrientation = " + stated + "\nDistanceUnits = um\n"));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        QCOMPARE(dataset->lengthUnit, std::string("um"));
        QCOMPARE(dataset->remarks.size(), std::size_t(contradicts ? 1 : 0));
        if (contradicts)
            QVERIFY(says(dataset->remarks, "'RPI', but by its matrix it is 'RAI'"));
    }

    void theUserSaysWhatTheFileDoesNot()
    {
        const QByteArray samples = testSamples(SampleType::Float32);
        const ParameterValues place{{"spacing", std::string("0.1x0.2x0.3")}, {"origin", std::string("1,2,3")}};
        const QByteArray untold = metaHeader("") + samples;
        const auto stated = readWith(untold, place);
        QVERIFY2(stated.ok(), stated.ok() ? "" : stated.error().text().c_str());
        QVERIFY(stated->lattice.spacing == Eigen::Vector3d(0.1, 0.2, 0.3));
        QVERIFY(stated->lattice.origin == Eigen::Vector3d(1, 2, 3) && stated->remarks.empty());
        const auto assumed = read(untold);
        QVERIFY(assumed.ok() && assumed->remarks.size() == 1 && says(assumed->remarks, "1 x 1 x 1 is assumed"));
        QVERIFY((probe(untold)->untold == std::vector<std::string>{"spacing", "origin", "unit"}));
        const QByteArray told =
            worldImage(Eigen::Matrix3d::Identity(), {1, 1, 1}, {4, 5, 6}, {}, "DistanceUnits = mm\n");
        QVERIFY(read(told)->remarks.empty());
        for (const char* id : {"spacing", "origin", "unit", "size", "skip"}) {
            const ParameterValue value =
                std::string(id) == "skip" ? ParameterValue(std::int64_t(1)) : ParameterValue(std::string("1,2,3"));
            QVERIFY2(readWith(told, {{id, value}}).error().kind == ErrorKind::WrongUsage, id);
        }
    }

    void everyArrangement()
    {
        for (const auto& [name, arrangement] : arrangements()) {
            const TestFolder folder;
            for (const auto& [other, content] : arrangement.data)
                folder.write(other, content);
            const fs::path path = folder.write("image.mhd", arrangement.opened);
            for (const auto& dataset :
                 {asLoaded<LatticeReader>().read(path, {}, {}), openDataset(host_, path, {}, {})}) {
                QVERIFY2(dataset.ok(),
                         dataset.ok() ? QByteArray() : QByteArray(name + ": " + dataset.error().text().c_str()));
                QVERIFY2(holdsTestSamples(dataset->values), name);
                QVERIFY2(dataset->remarks.size() == 1, name); // on the spacing
                QVERIFY2(dataset->source.leftOut.empty(), name);
            }
            QVERIFY2(asLoaded<LatticeReader>().probe(path, {}, {}).ok(), name);
        }
    }

    /// Whatever is cut off, of the header's file or of another one, is missed.
    void cutFilesAreRefused()
    {
        for (const auto& [name, arrangement] : arrangements()) {
            const TestFolder folder;
            for (const auto& [other, content] : arrangement.data)
                folder.write(other, content);
            if (name == "at the end") // a few bytes fewer before the samples make no difference
                continue;
            const bool isHeader = !arrangement.data.empty();
            const QByteArray whole = isHeader ? arrangement.data.back().second : arrangement.opened;
            const QByteArray cutName = isHeader ? arrangement.data.back().first : QByteArray("image.mhd");
            const fs::path path = folder.write("image.mhd", arrangement.opened);
            for (qsizetype size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
                folder.write(cutName, whole.first(size));
                const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
                QVERIFY2(!dataset.ok(), QByteArray(name + ", " + QByteArray::number(size)));
                QVERIFY2(says({dataset.error().message}, cutName.toStdString()), dataset.error().text().c_str());
            }
            folder.write(cutName, whole.chopped(1));
            QVERIFY2(!asLoaded<LatticeReader>().read(path, {}, {}).ok(), name);
        }
    }

    void everyTypeInBothOrders()
    {
        constexpr std::array<std::pair<const char*, SampleType>, 11> types = {{{"MET_UCHAR", SampleType::UInt8},
                                                                               {"MET_CHAR", SampleType::Int8},
                                                                               {"MET_USHORT", SampleType::UInt16},
                                                                               {"MET_SHORT", SampleType::Int16},
                                                                               {"MET_UINT", SampleType::UInt32},
                                                                               {"MET_INT", SampleType::Int32},
                                                                               {"MET_ULONG", SampleType::UInt32},
                                                                               {"MET_LONG", SampleType::Int32},
                                                                               {"MET_FLOAT", SampleType::Float32},
                                                                               {"MET_DOUBLE", SampleType::Float64},
                                                                               {"MET_SHORT_ARRAY", SampleType::Int16}}};
        for (const auto& [name, type] : types)
            for (const std::endian order : {std::endian::little, std::endian::big})
                for (const bool isPacked : {false, true}) {
                    const QByteArray samples = testSamples(type, order);
                    const auto dataset =
                        read(metaHeader(QByteArray("ElementType = ") + name +
                                        "\nBinaryDataByteOrderMSB = " + (order == std::endian::big ? "True" : "False") +
                                        "\nCompressedData = " + (isPacked ? "True" : "False") + "\n") +
                             (isPacked ? zlibPacked(samples) : samples));
                    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                    QVERIFY(dataset->values.type() == type);
                    QVERIFY2(holdsTestSamples(dataset->values), name);
                }
        const auto wide = read(metaHeader("ElementType = MET_LONG_LONG\n") +
                               counted<std::int64_t>(testPoints, std::int64_t(1) << 40));
        QVERIFY(wide.ok() && wide->values.type() == SampleType::Float64);
        QCOMPARE(wide->values.at(1), std::ldexp(1.0, 40) + 1);
        // Longs as some programs of 64 bits wrote them would be noise.
        const auto doubtful = read(metaHeader("ElementType = MET_LONG\n") + counted<std::int64_t>(testPoints, 0));
        QVERIFY(!doubtful.ok() && says({doubtful.error().message}, "MET_LONG_LONG"));
    }

    void channelsAreComponents()
    {
        const QByteArray fields = "ElementNumberOfChannels = 3\nElementType = MET_UCHAR\n";
        const QByteArray file = metaHeader(fields) + counted<std::uint8_t>(3 * testPoints, 0);
        for (int component = 0; component < 3; ++component) {
            const auto one = readWith(file, {{"component", std::to_string(component)}});
            QVERIFY(one.ok() && one->values.type() == SampleType::UInt8);
            for (int n = 0; n < testPoints; ++n)
                QCOMPARE(one->values.at(static_cast<std::uint64_t>(n)), 3. * n + component);
        }
        const auto all = read(file);
        QVERIFY(all.ok() && all->values.type() == SampleType::Float64);
        QCOMPARE(all->values.at(1), std::sqrt(3. * 3 + 4 * 4 + 5 * 5));
        QCOMPARE(takenOf(all->source.taken, TakenPart::Component), std::string("component: magnitude of 3 (a guess)"));
        QVERIFY(readWith(file, {{"component", std::string("3")}}).error().kind == ErrorKind::WrongUsage);
        QVERIFY(readWith(metaHeader("") + testSamples(SampleType::Float32), {{"component", std::string("1")}})
                    .error()
                    .kind == ErrorKind::WrongUsage);
    }

    void stepsAreChosen()
    {
        const QByteArray fields = "NDims = 4\nDimSize = 3 4 5 2\nElementSpacing = 1 2 3 0.5\nOffset = 1 2 3 10\n"
                                  "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n";
        const QByteArray first = counted<float>(testPoints, 0), second = counted<float>(testPoints, 100);
        folder_.write("a.raw", first);
        folder_.write("b.raw", second);
        for (const QByteArray& file : {metaHeader(fields) + first + second,
                                       metaHeader(fields + "CompressedData = True\n") + zlibPacked(first + second),
                                       metaHeader(fields, "LIST") + "a.raw\nb.raw\n"}) {
            const auto dataset = readWith(file, {{"time", std::int64_t(2)}});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->values.at(0), 100.);
            QCOMPARE(dataset->values.at(59), 159.);
            QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(1, 2, 3));
            QVERIFY(dataset->lattice.origin == Eigen::Vector3d(1, 2, 3));
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::TimeStep), std::string("time step: 2 of 2, time 10.5"));
            QVERIFY(says(dataset->source.leftOut, "It holds 2 volumes"));
            QCOMPARE(read(file)->values.at(0), 0.);
            QCOMPARE(probe(file)->timeSteps, (std::vector<double>{10, 10.5}));
            QVERIFY(readWith(file, {{"time", std::int64_t(3)}}).error().kind == ErrorKind::WrongUsage);
        }
        QByteArray mixed = fields;
        mixed.replace("= 1 0 0 0 0 1", "= 1 0 0 1 0 1");
        QVERIFY(says({read(metaHeader(mixed) + first + second).error().message}, "turns space into"));
    }

    void whatIsNotUsedIsTold()
    {
        const QByteArray samples = testSamples(SampleType::Float32);
        const auto told = [&](const QByteArray& fields) {
            const auto dataset = read(metaHeader(fields) + samples);
            return dataset ? dataset->source.leftOut : std::vector<Message>{dataset.error().message};
        };
        QVERIFY(told("CenterOfRotation = 0 0 0\nElementToIntensityFunctionSlope = 1\n").empty());
        QVERIFY(says(told("CenterOfRotation = 0 1 0\n"), "CenterOfRotation was not used"));
        QVERIFY(says(told("ElementToIntensityFunctionSlope = 2\n"), "times 2, plus 0"));
        QByteArray bare = metaHeader("") + samples;
        bare.remove(bare.indexOf("BinaryDataByteOrderMSB"), QByteArray("BinaryDataByteOrderMSB = False\n").size());
        QVERIFY(says(read(bare)->remarks, "little endian"));
        QVERIFY(says(read(metaHeader("") + samples + "xyz")->source.leftOut, "3 bytes after its samples"));
    }

    void refusalsAreTrue_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("words");
        const QByteArray samples = testSamples(SampleType::Float32);
        const auto row = [&](const char* name, const QByteArray& fields, const char* words,
                             const QByteArray& dataFile = "LOCAL") {
            QTest::newRow(name) << metaHeader(fields, dataFile) + samples << QByteArray(words);
        };
        row("no direction", "TransformMatrix = 1 0 0 0 0 0 0 0 1\n", "positive number");
        row("in a plane", "TransformMatrix = 1 0 0 0 1 0 .7071067811865476 .7071067811865476 0\n", "in a plane");
        row("not a number", "TransformMatrix = 1 0 0 0 nan 0 0 0 1\n", "not 9 finite numbers");
        row("without end", "TransformMatrix = 1 0 0 0 inf 0 0 0 1\n", "not 9 finite numbers");
        row("huge", "TransformMatrix = 1e308 1e308 0 0 1 0 0 0 1\n", "");
        row("too few", "TransformMatrix = 1 0 0 0 1 0\n", "not 9 finite numbers");
        row("words", "TransformMatrix = one 0 0 0 1 0 0 0 1\n", "not 9 finite numbers");
        row("offset of two", "Offset = 0 0\n", "not 3 finite numbers");
        row("offset too far", "Offset = 0 1e300 0\n", "too large or small");
        row("no spacing", "ElementSpacing = 1 0 1\n", "positive number");
        row("spacing of two", "ElementSpacing = 1 1\n", "not 3 finite numbers");
        row("two dimensions", "NDims = 2\nDimSize = 3 4\n", "it has 2 dimensions, and a volume has three");
        row("eleven dimensions", "NDims = 11\n", "it has 11 dimensions");
        row("too few sizes", "DimSize = 3 4\n", "not 3 numbers of points");
        row("no points", "DimSize = 3 4 0\n", "not 3 numbers of points");
        row("more than there is", "DimSize = 3 4 6\n", "but there are only");
        row("more than any file", "NDims = 4\nDimSize = 3 4 2000000000 2000000000\nElementSpacing = 1 1 1 1\n", "");
        row("an unknown type", "ElementType = MET_STRING\n", "'MET_STRING', which is not read");
        row("no channels", "ElementNumberOfChannels = 0\n", "ElementNumberOfChannels is '0'");
        row("packed data that are none", "CompressedData = True\n", "compressed data are damaged");
        row("more packed data than there are", "CompressedData = True\nCompressedDataSize = 9999\n", "cut short");
        row("a text that is none", "BinaryData = False\n", "number 1 of its text");
        row("the end of packed data", "CompressedData = True\nHeaderSize = -1\n", "HeaderSize is -1");
        row("another header size", "HeaderSize = -2\n", "HeaderSize is '-2'");
        row("a missing file", "", "its data file 'no where.raw' is missing", "no where.raw");
        row("no file", "", "its data file '' is missing", "");
        row("a file with a zero in its name", "", "characters that no name should contain", QByteArray("a\0b", 3));
        row("a series of too few", "", "for each of its 5 layers", "slice%d.raw 1 4 1");
        row("a series without a number", "", "not a name with a number", "slice%s.raw 1 5 1");
        row("a series without end", "DimSize = 3 4 2000000000\n", "names 2000000000 files", "slice%d.raw");
        row("a list of too few", "", "names 0", "LIST");
        QTest::newRow("no image") << QByteArray("ObjectType = Tube\nNDims = 3\nElementDataFile = LOCAL\n")
                                  << QByteArray("its ObjectType is 'Tube'");
        QTest::newRow("no header") << QByteArray("NDims = 3\n") << QByteArray("no line 'ElementDataFile");
    }
    void refusalsAreTrue()
    {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, words);
        const auto dataset = read(file);
        QVERIFY(!dataset.ok());
        QVERIFY(dataset.error().kind == ErrorKind::BadInput);
        QVERIFY2(dataset.error().text().find(words.constData()) != std::string::npos, dataset.error().text().c_str());
    }

private:
    Result<Dataset> read(const QByteArray& file) { return readWith(file, {}); }
    Result<Dataset> readWith(const QByteArray& file, const ParameterValues& values)
    {
        return asLoaded<LatticeReader>().read(folder_.write("image.mha", file), values, {});
    }
    Result<FileContents> probe(const QByteArray& file)
    {
        return asLoaded<LatticeReader>().probe(folder_.write("image.mha", file), {}, {});
    }

    TestFolder folder_;
    PluginHost host_{{.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}}};
};

QTEST_GUILESS_MAIN(MetaImageReaderTest)
#include "metaimage_reader_test.moc"
