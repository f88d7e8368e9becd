// SPDX-License-Identifier: GPL-3.0-or-later
// OpenDX: fields on regular positions, as text and as bytes, in the file and beside it.
#include "tests/lacks.h"
#include "tests/plugins/readers/lattice/format_files.h"

#include <QtTest>

using namespace tetra;

namespace {

QByteArray dxGrid(const WorldVolume& world)
{
    QByteArray text = "object 1 class gridpositions counts";
    for (const std::uint32_t count : world.size)
        text += " " + QByteArray::number(count);
    text += "\norigin " + threeNumbers(world.origin) + "\n";
    for (int axis = 0; axis < 3; ++axis)
        text += "delta " + threeNumbers(world.steps.col(axis)) + "\n";
    return text + "object 2 class gridconnections counts 4 5 6\n";
}

QByteArray dxArray(std::uint64_t items, const QByteArray& type, const QByteArray& place)
{
    return "object 3 class array type " + type + " items " + QByteArray::number(qulonglong(items)) + " " + place;
}

const QByteArray dxField = "attribute \"dep\" string \"positions\"\n"
                           "object \"density\" class field\ncomponent \"positions\" value 1\n"
                           "component \"connections\" value 2\ncomponent \"data\" value 3\n";

/// A turned and sheared volume of 4 x 5 x 6 points.
WorldVolume obliqueWorld()
{
    WorldVolume world;
    world.steps << 0.4, 0.1, 0, 0, 0.5, -0.2, 0.05, 0, 0.6;
    world.origin = {1, -2, 3};
    return world;
}

template <class Number> QByteArray wholeBytes(const WorldVolume& world, std::endian order)
{
    return world.lastFastest([order](double value) { return numberBytes(static_cast<Number>(5 * value), order); });
}

} // namespace

class DxReaderTest : public QObject {
    Q_OBJECT

private slots:
    void liesWhereItSays_data()
    {
        QTest::addColumn<Eigen::Matrix3d>("steps");
        int number = 0;
        for (const Eigen::Matrix3d& permutation : signedPermutations())
            QTest::addRow("permutation %d", number++)
                << Eigen::Matrix3d(permutation * Eigen::Vector3d(0.4, 0.3, 0.7).asDiagonal());
        QTest::newRow("oblique") << obliqueWorld().steps;
    }
    void liesWhereItSays()
    {
        QFETCH(Eigen::Matrix3d, steps);
        const WorldVolume world{{4, 5, 6}, steps, {1, -2, 3}, 1};
        const auto dataset = read(dxGrid(world) + dxArray(120, "double rank 0", "data follows\n") +
                                  world.lastFastest(textNumber) + "\n" + dxField);
        QVERIFY2(dataset, text_);
        QVERIFY((dataset->lattice.size == world.size));
        QVERIFY(distanceFromWorld(*dataset, 1) < 1e-12);
        QCOMPARE(dataset->values.type(), SampleType::Float64);
        QCOMPARE(dataset->source.valueName, std::string("density"));
        QVERIFY(dataset->source.taken.empty() && dataset->source.leftOut.empty() && dataset->remarks.empty());
    }

    void numbersStandInManyWays_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("beside");
        const WorldVolume world = obliqueWorld();
        const QByteArray grid = dxGrid(world);
        const auto bigFloat = [](double value) { return numberBytes(static_cast<float>(value), std::endian::big); };
        const auto bigDouble = [](double value) { return numberBytes(value, std::endian::big); };
        const QByteArray text = world.lastFastest(textNumber), little = world.lastFastest(littleFloat),
                         big = world.lastFastest(bigFloat), doubles = world.lastFastest(bigDouble);
        const auto row = [](const char* name, const QByteArray& file, const QByteArray& beside = {}) {
            QTest::newRow(name) << file << beside;
        };
        row("text", grid + dxArray(120, "float rank 0", "data follows\n") + text + dxField);
        row("text, commented", "# one\n" + grid + "# two\n" + dxArray(120, "float", "ascii data follows\n") + text +
                                   "\n# three: object\n" + dxField + "end\n");
        row("text, in Fortran's way",
            grid + dxArray(120, "double", "data follows\n") + QByteArray(text).replace('e', 'D') + dxField);
        row("text, commas",
            grid + dxArray(120, "double", "data follows\r\n") + QByteArray(text).replace(" ", ",\r\n") + dxField);
        row("lsb", grid + dxArray(120, "float rank 0", "lsb binary data follows\n") + little + "\n" + dxField);
        row("msb", grid + dxArray(120, "float rank 0", "msb ieee data follows\n") + big + dxField);
        row("doubles", grid + dxArray(120, "\"double\" rank 0", "binary msb data follows\n") + doubles + dxField);
        row("mode", "data mode msb binary\n" + grid + dxArray(120, "float", "data follows\n") + big + dxField);
        row("mode behind another object", grid + "data mode msb ieee\n" + dxArray(120, "float", "data follows\n") +
                                              big + "\ndata mode text\n" + dxField);
        row("behind the header",
            grid + dxArray(120, "float", "lsb binary data 7\n") + dxField + "end\n" + "1234567" + little);
        row("text behind the header", grid + dxArray(120, "float", "data 3\n") + dxField + "end\n1 \n" + text + " 5 6");
        row("in another file", grid + dxArray(120, "float", "lsb binary data file volume.bin,5\n") + dxField,
            "12345" + little + "more");
        row("in another file from its beginning",
            grid + dxArray(120, "double", "msb binary data file \"volume.bin\"\n") + dxField, doubles);
        row("text in another file", grid + dxArray(120, "float", "data file volume.bin\n") + dxField, text);
        row("without a field", grid + dxArray(120, "float", "data follows\n") + text);
        row("with a field without components",
            grid + dxArray(120, "float", "data follows\n") + text + "object \"density\" class field\n");
        row("objects before what they refer to",
            "object \"density\" class field component \"data\" 3 component \"positions\" 1\n" + grid +
                dxArray(120, "float", "data follows\n") + text);
        row("another array before it", grid +
                                           "object \"more\" class array type int rank 1 shape 2 items 2 data "
                                           "follows 1\n 2\n3 4\nobject 9 class array type float rank 2 shape 2 2 "
                                           "items 1 lsb binary data follows\n" +
                                           QByteArray(16, 'o') + "\n" + dxArray(120, "float", "data follows\n") + text +
                                           dxField);
    }
    void numbersStandInManyWays()
    {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, beside);
        if (!beside.isEmpty())
            QVERIFY(!folder_.write("volume.bin", beside).empty());
        const auto dataset = read(file);
        QVERIFY2(dataset, text_);
        QVERIFY(distanceFromWorld(*dataset, 1) < 1e-5);
        QVERIFY(dataset->remarks.empty());
    }

    void everyType_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QByteArray>("little");
        QTest::addColumn<QByteArray>("big");
        QTest::addColumn<SampleType>("becomes");
        WorldVolume world;
        world.steps *= 0.3; // values from 2 to 21
        const auto row = [&](const char* type, auto number, SampleType becomes) {
            using Number = decltype(number);
            QTest::newRow(type) << QByteArray(type) << wholeBytes<Number>(world, std::endian::little)
                                << wholeBytes<Number>(world, std::endian::big) << becomes;
        };
        row("byte", std::uint8_t(), SampleType::UInt8);
        row("ubyte", std::uint8_t(), SampleType::UInt8);
        row("unsigned byte", std::uint8_t(), SampleType::UInt8);
        row("char", std::uint8_t(), SampleType::UInt8);
        row("signed byte", std::int8_t(), SampleType::Int8);
        row("short", std::int16_t(), SampleType::Int16);
        row("ushort", std::uint16_t(), SampleType::UInt16);
        row("unsigned short", std::uint16_t(), SampleType::UInt16);
        row("int", std::int32_t(), SampleType::Int32);
        row("uint", std::uint32_t(), SampleType::UInt32);
        row("unsigned int", std::uint32_t(), SampleType::UInt32);
        row("float", float(), SampleType::Float32);
        row("double", double(), SampleType::Float64);
    }
    void everyType()
    {
        QFETCH(QByteArray, type);
        QFETCH(QByteArray, little);
        QFETCH(QByteArray, big);
        WorldVolume world;
        world.steps *= 0.3;
        const bool isWhole = type != "float" && type != "double";
        const auto textOf = [isWhole](double value) {
            return isWhole ? QByteArray::number(static_cast<int>(5 * value)) + "\n" : textNumber(5 * value);
        };
        for (const auto& [place, numbers] :
             std::map<QByteArray, QByteArray>{{"lsb binary data follows\n", little},
                                              {"msb binary data follows\n", big},
                                              {"data follows\n", world.lastFastest(textOf)}}) {
            const auto dataset = read(dxGrid(world) + dxArray(120, type + " rank 0", place) + numbers + "\n" + dxField);
            QVERIFY2(dataset, text_);
            QTEST(dataset->values.type(), "becomes");
            for (std::uint64_t n = 0; n < dataset->pointCount(); ++n) {
                const double value = 5 * worldFunction(dataset->position(n), 1);
                QVERIFY(isWhole ? dataset->values.at(n) == std::trunc(value)
                                : std::abs(dataset->values.at(n) - value) < 1e-5);
            }
        }
    }

    void valuesOfCells()
    {
        WorldVolume world = obliqueWorld();
        const QByteArray grid = dxGrid(world);
        world.origin += world.steps * Eigen::Vector3d(0.5, 0.5, 0.5);
        world.size = {3, 4, 5};
        const auto dataset =
            read(grid + dxArray(60, "double", "data follows\n") + world.lastFastest(textNumber) +
                 QByteArray(dxField).replace("dep\" string \"positions", "dep\" string \"connections"));
        QVERIFY2(dataset, text_);
        QVERIFY((dataset->lattice.size == world.size));
        QVERIFY(distanceFromWorld(*dataset, 1) < 1e-12);
        QCOMPARE(takenWords(dataset->source.taken), QByteArray("places: the middles of the cells\n"));
    }

    void vectors()
    {
        const WorldVolume world = obliqueWorld();
        const QByteArray file = dxGrid(world) + dxArray(120, "float rank 1 shape 3", "data follows\n") +
                                world.lastFastest([](double value) {
                                    return textNumber(3 * value) + textNumber(value) + textNumber(4 * value);
                                }) +
                                dxField;
        const auto second = read(file, {{"component", std::string("1")}});
        QVERIFY2(second, text_);
        QVERIFY(distanceFromWorld(*second, 1) < 1e-5);
        QCOMPARE(takenWords(second->source.taken), QByteArray("component: 1 of 3, counted from 0\n"));
        QCOMPARE(second->source.valueName, std::string("density (component 1)"));
        const auto magnitude = read(file);
        QVERIFY2(magnitude, text_);
        QCOMPARE(takenWords(magnitude->source.taken), QByteArray("component: magnitude of 3 (a guess)\n"));
        const double first = std::sqrt(26.) * std::abs(world.at(0, 0, 0));
        QVERIFY(std::abs(magnitude->values.at(0) - first) < 1e-5 * first);
        QCOMPARE(refusal(file, {"'3'", "from 0 to 2"}, {{"component", std::string("3")}}), QByteArray());
    }

    void oneOfSeveralFields()
    {
        const WorldVolume world = obliqueWorld();
        const QByteArray file =
            dxGrid(world) + dxArray(120, "float", "data follows\n") +
            world.lastFastest([](double value) { return textNumber(100 - value); }) +
            "object \"early\" class field component \"positions\" value 1 component \"data\" value 3\n"
            "object 4 class array type float rank 0 items 120 data follows\n" +
            world.lastFastest(textNumber) +
            "object \"late\" class field component \"positions\" value 1 component \"data\" value 4\n"
            "object \"film\" class series member 0 value \"early\" position 0 member 1 value \"late\" position 0.5\n";
        const auto late = read(file, {{"array", std::string("late")}});
        QVERIFY2(late, text_);
        QVERIFY(distanceFromWorld(*late, 1) < 1e-5);
        QCOMPARE(takenWords(late->source.taken), QByteArray("array: late, number 2 of 2\n"));
        QCOMPARE(sentences(late->source.leftOut), QByteArray("It holds 2 fields; the others are not read.\n"));
        const auto first = read(file);
        QVERIFY2(first, text_);
        QCOMPARE(takenWords(first->source.taken), QByteArray("array: early, number 1 of 2 (a guess)\n"));
        QVERIFY(std::abs(first->values.at(0) - (100 - world.at(0, 0, 0))) < 1e-4);
    }

    void anAssumedByteOrderIsTold()
    {
        const WorldVolume world = obliqueWorld();
        const QByteArray native =
            world.lastFastest([](double value) { return numberBytes(static_cast<float>(value), std::endian::native); });
        const auto dataset = read(dxGrid(world) + dxArray(120, "float", "binary data follows\n") + native + dxField);
        QVERIFY2(dataset, text_);
        QVERIFY(distanceFromWorld(*dataset, 1) < 1e-5);
        QVERIFY(sentences(dataset->remarks).contains("byte order"));
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QList<QByteArray>>("words");
        const WorldVolume world = obliqueWorld();
        const QByteArray grid = dxGrid(world), text = world.lastFastest(textNumber);
        const QByteArray array = dxArray(120, "float", "data follows\n") + text;
        const auto row = [](const char* name, const QByteArray& file, const QList<QByteArray>& words) {
            QTest::newRow(name) << file << words;
        };
        row("no DX", "##TITLE= a spectrum\n##JCAMP-DX= 4.24\n", {"no OpenDX field"});
        row("nothing", "# empty\n", {"no OpenDX field"});
        row("object alone", "object", {"no OpenDX field"});
        row("no positions", array + dxField, {"no positions"});
        row("irregular positions",
            "object 1 class array type float rank 1 shape 3 items 120 data follows\n" + text + text + text + array +
                dxField,
            {"class 'array'", "regular grid", ".vtu"});
        row("a product of positions", "object 1 class productarray terms 5 6\n" + array + dxField, {"'productarray'"});
        row("two dimensions", QByteArray(grid).replace("counts 4 5 6\norigin", "counts 4 5\norigin") + array + dxField,
            {"its grid is 2"});
        row("no counts", QByteArray(grid).replace("counts 4 5 6\norigin", "counts\norigin") + array + dxField,
            {"its grid is 0"});
        row("endless counts",
            QByteArray(grid).replace("counts 4 5 6\norigin", "counts 4000000000 4000000000 4000000000\norigin") +
                array + dxField,
            {"more than any machine"});
        row("two steps",
            QByteArray(grid).replace("delta", "dolta").replace("dolta", "delta").left(grid.indexOf("delta")) +
                "delta 1 0 0\ndelta 0 1 0\n" + array + dxField,
            {"three 'delta'"});
        row("steps in a plane",
            grid.left(grid.indexOf("delta")) + "delta 1 0 0\ndelta 0 1 0\ndelta 1 1 0\n" + array + dxField, {"plane"});
        row("an origin that is none", QByteArray(grid).replace("origin ", "origin nan nan nan #") + array + dxField,
            {"finite"});
        row("too few items", grid + dxArray(119, "float", "data follows\n") + text + dxField,
            {"119 items", "120 points"});
        row("too few numbers",
            grid + dxArray(120, "float", "data follows\n") + text.left(text.size() - 30) + "\n" + dxField,
            {"only 119 numbers"});
        row("too many numbers", grid + dxArray(120, "float", "data follows\n") + text + "5\n" + dxField,
            {"more than the 120 numbers"});
        row("too few bytes", grid + dxArray(120, "float", "lsb binary data follows\n") + "1234", {"cut short"});
        row("endless items",
            grid + "object 3 class array type double rank 1 shape 9000000000000000000 items 9000000000000000000 lsb "
                   "binary data follows\n1",
            {"cut short"});
        row("an offset beyond the end",
            grid + dxArray(120, "float", "lsb binary data 18446744073709551615\n") + dxField, {"only 0 bytes"});
        row("no place", grid + dxArray(120, "float", "") + dxField, {"where its data are"});
        row("nothing behind 'data'", grid + dxArray(120, "byte", "binary data"), {"after 'data'"});
        row("a place that is none", grid + dxArray(120, "float", "data here\n") + dxField, {"'here'"});
        row("items that are none", grid + "object 3 class array items many data follows\n" + text, {"'many'"});
        row("a file that is not there", grid + dxArray(120, "float", "data file missing.bin,0\n") + dxField,
            {"missing.bin", "volume.dx"});
        row("texts", grid + dxArray(120, "string", "data follows\n") + text + dxField, {"'string'"});
        row("complex", grid + dxArray(120, "float category complex", "data follows\n") + text + dxField, {"'complex'"});
        row("shape of no numbers", grid + dxArray(120, "float rank 1 shape 0", "data follows\n") + text + dxField,
            {"shape 0"});
        row("rank without shape", grid + dxArray(120, "float rank 1", "data follows\n") + text + dxField, {"rank 1"});
        row("a number that does not fit", grid + dxArray(120, "byte", "data follows\n") + "256 " + text + dxField,
            {"number 1", "'256'"});
        row("a number that is not whole", grid + dxArray(120, "int", "data follows\n") + "1.5 " + text + dxField,
            {"number 1", "'1.5'"});
    }
    void refuses()
    {
        QFETCH(QByteArray, file);
        QFETCH(QList<QByteArray>, words);
        QCOMPARE(refusal(file, words), QByteArray());
    }

    void cutFilesAreReadOrRefused()
    {
        WorldVolume world;
        world.size = {2, 2, 2};
        const QByteArray grid = dxGrid(world);
        for (const QByteArray& array :
             {dxArray(8, "int", "data follows\n") + "1 2 3 4 5 6 7 8\n",
              dxArray(8, "short", "msb binary data follows\n") + QByteArray(16, 'd') + "\n"}) {
            const QByteArray file = grid + array + dxField;
            for (qsizetype bytes = 1; bytes < file.size(); ++bytes) {
                const auto dataset = read(file.left(bytes));
                QVERIFY2(!dataset || dataset->pointCount() == 8, QByteArray::number(bytes));
                QVERIFY2(bytes >= grid.size() + array.size() - 2 || !dataset, QByteArray::number(bytes));
            }
        }
    }

    void longHostileHeadersEnd()
    {
        QCOMPARE(refusal("object 1 class array " + QByteArray("data follows ").repeated(200000), {"OpenDX"}),
                 QByteArray());
        QCOMPARE(refusal("object 1 class field " + QByteArray("a ").repeated(1'100'000), {"more than 1000000 words"}),
                 QByteArray());
        QCOMPARE(refusal(QByteArray("object 1 class x ").repeated(110'000), {"more than 100000 objects"}),
                 QByteArray());
    }

    void theSharedCase()
    {
        const auto path = sharedCases() / "other" / "apbs.dx";
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = readFormat(path, text_);
        QVERIFY2(dataset, text_);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{6, 7, 8}));
        QVERIFY(distanceFromWorld(*dataset, 1) < 6e-5); // it has six digits
        QVERIFY(dataset->source.valueName.empty());
    }

private:
    std::optional<Dataset> read(const QByteArray& file, const ParameterValues& values = {})
    {
        return readFormat(folder_.write("volume.dx", file), text_, values);
    }
    QByteArray refusal(const QByteArray& file, const QList<QByteArray>& words, const ParameterValues& values = {})
    {
        return refusalFault(folder_.write("volume.dx", file), words, values);
    }

    TestFolder folder_;
    QByteArray text_;
};

QTEST_GUILESS_MAIN(DxReaderTest)
#include "dx_reader_test.moc"
