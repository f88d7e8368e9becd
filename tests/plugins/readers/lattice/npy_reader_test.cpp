// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays of NumPy, written byte by byte as its format says: every type, both orders of bytes and of axes.
#include "tests/lacks.h"
#include "tests/plugins/readers/lattice/format_files.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace tetra;

namespace {

/// A file of version 1 whose numbers begin at a multiple of 64 bytes, as NumPy writes it.
QByteArray npy(const QByteArray& dictionary, const QByteArray& numbers, char version = 1)
{
    const int lengthBytes = version == 1 ? 2 : 4;
    QByteArray text = dictionary;
    while ((8 + lengthBytes + text.size() + 1) % 64 != 0)
        text += ' ';
    text += '\n';
    QByteArray file("\x93NUMPY", 6);
    file += version;
    file += '\0';
    for (int i = 0; i < lengthBytes; ++i)
        file += static_cast<char>(text.size() >> (8 * i) & 0xff);
    return file + text + numbers;
}

QByteArray dictionaryOf(const QByteArray& type, const QByteArray& shape, bool firstFastest = false)
{
    return "{'descr': '" + type + "', 'fortran_order': " + (firstFastest ? "True" : "False") + ", 'shape': " + shape +
           ", }";
}

const ParameterValues lastIsX = {{"axes", std::string("zyx")}};

/// The numbers from 0 to 59.
template <class Number> QByteArray counting(std::endian order)
{
    QByteArray bytes;
    for (int n = 0; n < testPoints; ++n)
        bytes += numberBytes(static_cast<Number>(n), order);
    return bytes;
}

} // namespace

class NpyReaderTest : public QObject {
    Q_OBJECT

private slots:
    void readsEveryType_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QByteArray>("numbers");
        QTest::addColumn<SampleType>("becomes");
        const auto both = [](const char* name, auto number, SampleType becomes) {
            using Number = decltype(number);
            QTest::newRow(QByteArray("<") + name)
                << QByteArray("<") + name << counting<Number>(std::endian::little) << becomes;
            QTest::newRow(QByteArray(">") + name)
                << QByteArray(">") + name << counting<Number>(std::endian::big) << becomes;
        };
        both("i2", std::int16_t(0), SampleType::Int16);
        both("u2", std::uint16_t(0), SampleType::UInt16);
        both("i4", std::int32_t(0), SampleType::Int32);
        both("u4", std::uint32_t(0), SampleType::UInt32);
        both("i8", std::int64_t(0), SampleType::Int32);
        both("u8", std::uint64_t(0), SampleType::Int32);
        both("f4", float(0), SampleType::Float32);
        both("f8", double(0), SampleType::Float64);
        for (const char* const name : {"|u1", "<u1", "u1"})
            QTest::newRow(name) << QByteArray(name) << counting<std::uint8_t>(std::endian::little) << SampleType::UInt8;
        QTest::newRow("|i1") << QByteArray("|i1") << counting<std::int8_t>(std::endian::little) << SampleType::Int8;
        QTest::newRow("=f4") << QByteArray("=f4") << counting<float>(std::endian::native) << SampleType::Float32;
    }
    void readsEveryType()
    {
        QFETCH(QByteArray, type);
        QFETCH(QByteArray, numbers);
        for (const bool firstFastest : {false, true})
            for (const char version : {1, 2, 3}) {
                const QByteArray shape = firstFastest ? "(3, 4, 5)" : "(5, 4, 3)";
                const auto dataset = read(npy(dictionaryOf(type, shape, firstFastest), numbers, version),
                                          firstFastest ? ParameterValues() : lastIsX);
                QVERIFY2(dataset, text_);
                QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{3, 4, 5}));
                QVERIFY(holdsTestSamples(dataset->values));
                QTEST(dataset->values.type(), "becomes");
                QVERIFY(dataset->source.leftOut.empty());
            }
    }

    /// array[i, j, k] is point (i, j, k), whatever runs fastest in the file, unless the user says that it is (k, j, i).
    void isIndexedAsNumPyIndexesIt()
    {
        const WorldVolume world{{35, 18, 21}, Eigen::Matrix3d::Identity(), {0, 0, 0}, 10};
        const QByteArray lastFastest = world.lastFastest(littleFloat), firstFastest = world.firstFastest(littleFloat);
        struct Way {
            QByteArray shape, numbers;
            bool isFortran;
            ParameterValues values;
            QByteArray taken;
        };
        const QByteArray guess = "places: the array's dimensions are x, y, z; give '--axes zyx' if they are z, y, x, "
                                 "as in stacks of images (a guess)\n";
        const ParameterValues firstIsX = {{"axes", std::string("xyz")}};
        const std::vector<Way> ways = {
            {"(35, 18, 21)", lastFastest, false, {}, guess},
            {"(35, 18, 21)", firstFastest, true, {}, guess},
            {"(35, 18, 21)", lastFastest, false, firstIsX, "places: the array's dimensions are x, y, z\n"},
            {"(21, 18, 35)", firstFastest, false, lastIsX, "places: the array's dimensions are z, y, x\n"},
            {"(21, 18, 35)", lastFastest, true, lastIsX, "places: the array's dimensions are z, y, x\n"}};
        for (const Way& way : ways) {
            const auto dataset = read(npy(dictionaryOf("<f4", way.shape, way.isFortran), way.numbers), way.values);
            QVERIFY2(dataset, text_);
            QVERIFY(dataset->lattice.size == world.size);
            QVERIFY(distanceFromWorld(*dataset, world.scale) < 1e-5);
            QCOMPARE(takenWords(dataset->source.taken), way.taken);
            QCOMPARE(dataset->mappedFile != nullptr, way.numbers == firstFastest); // where x runs fastest
        }
    }

    void liesWhereTheUserSays()
    {
        const WorldVolume world{{4, 5, 6}, Eigen::Vector3d(0.5, 0.25, 2).asDiagonal(), {1, -2, 3}, 2};
        const QByteArray file = npy(dictionaryOf("<f4", "(4, 5, 6)"), world.lastFastest(littleFloat));
        const auto placed = read(
            file,
            {{"spacing", std::string("0.5x0.25x2")}, {"origin", std::string("1,-2,3")}, {"unit", std::string("um")}});
        QVERIFY2(placed, text_);
        QVERIFY(distanceFromWorld(*placed, 2) < 1e-5);
        QCOMPARE(placed->lengthUnit, std::string("um"));
        QVERIFY(placed->remarks.empty());
        const auto assumed = read(file);
        QVERIFY2(assumed, text_);
        QVERIFY(sentences(assumed->remarks).contains("1 x 1 x 1 is assumed"));
    }

    void staysInItsFileWhereItCan()
    {
        for (const char* const type : {"<f4", ">f4", "<u4"}) {
            const bool isBig = type[0] == '>';
            const auto dataset = read(npy(dictionaryOf(type, "(3, 4, 5)", true),
                                          counting<std::uint32_t>(isBig ? std::endian::big : std::endian::little)));
            QVERIFY2(dataset, text_);
            QCOMPARE(dataset->mappedFile != nullptr, !isBig);
        }
    }

    void truthValuesAreBytes()
    {
        QByteArray bytes;
        for (int n = 0; n < testPoints; ++n)
            bytes += static_cast<char>(n % 2);
        const auto dataset = read(npy(dictionaryOf("|b1", "(3, 4, 5)", true), bytes));
        QVERIFY2(dataset, text_);
        QCOMPARE(dataset->values.type(), SampleType::UInt8);
        for (std::uint64_t n = 0; n < testPoints; ++n)
            QCOMPARE(dataset->values.at(n), double(n % 2));
    }

    void halfPrecision()
    {
        const std::array<std::uint16_t, 8> bits{0x3c00, 0xc000, 0x7bff, 0x0001, 0x83ff, 0x3555, 0x8000, 0x4248};
        const std::array<double, 8> numbers{
            1, -2, 65504, std::ldexp(1., -24), -1023 * std::ldexp(1., -24), 0.333251953125, -0., 3.140625};
        for (const std::endian order : {std::endian::little, std::endian::big}) {
            QByteArray bytes;
            for (const std::uint16_t number : bits)
                bytes += numberBytes(number, order);
            const auto dataset =
                read(npy(dictionaryOf(order == std::endian::little ? "<f2" : ">f2", "(2, 2, 2)", true), bytes));
            QVERIFY2(dataset, text_);
            QCOMPARE(dataset->values.type(), SampleType::Float32);
            for (std::uint64_t n = 0; n < bits.size(); ++n)
                QCOMPARE(dataset->values.at(n), numbers[n]);
        }
        QByteArray bytes;
        for (const int number : {0x7c00, 0xfc00, 0x7e01, 0x3c00, 0x3c00, 0x3c00, 0x3c00, 0x3c00})
            bytes += numberBytes(static_cast<std::uint16_t>(number));
        const auto dataset = read(npy(dictionaryOf("<f2", "(2, 2, 2)", true), bytes));
        QVERIFY2(dataset, text_);
        QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(3));
        QVERIFY(std::isinf(dataset->values.at(0)) && dataset->values.at(1) < 0 && std::isnan(dataset->values.at(2)));
    }

    void largeIntegersBecomeDoubles()
    {
        const std::array<std::int64_t, 8> numbers{0, 1, -1, std::int64_t(1) << 40, -(std::int64_t(1) << 53) - 1,
                                                  5, 6, 7};
        QByteArray bytes;
        for (const std::int64_t number : numbers)
            bytes += numberBytes(number, std::endian::big);
        const auto dataset = read(npy(dictionaryOf(">i8", "(2, 2, 2)", true), bytes));
        QVERIFY2(dataset, text_);
        QCOMPARE(dataset->values.type(), SampleType::Float64);
        for (std::uint64_t n = 0; n < numbers.size(); ++n)
            QCOMPARE(dataset->values.at(n), double(numbers[n]));
        QVERIFY(sentences(dataset->remarks).contains("53 bits"));
        const auto most = read(npy(dictionaryOf("<u8", "(2, 2, 2)"), QByteArray(64, '\xff')));
        QVERIFY2(most, text_);
        QCOMPARE(most->values.at(0), std::ldexp(1., 64));
    }

    void complexNumbersHaveTwoComponents()
    {
        QByteArray bytes;
        for (int n = 0; n < 8; ++n)
            bytes += numberBytes(3.0 * n) + numberBytes(-4.0 * n);
        const QByteArray file = npy(dictionaryOf("<c16", "(2, 2, 2)", true), bytes);
        for (const auto& [component, factor] :
             std::map<std::string, double>{{"", 5}, {"magnitude", 5}, {"0", 3}, {"1", -4}}) {
            ParameterValues values;
            if (!component.empty())
                values["component"] = component;
            const auto dataset = read(file, values);
            QVERIFY2(dataset, text_);
            for (std::uint64_t n = 0; n < 8; ++n)
                QCOMPARE(dataset->values.at(n), factor * double(n));
            QVERIFY(takenWords(dataset->source.taken).contains("component: "));
        }
        QCOMPARE(refusalFault(write(file), {"'2'", "from 0 to 1"}, {{"component", std::string("2")}}), QByteArray());
    }

    void dimensionsOfOneElementAreNone()
    {
        const QByteArray numbers = counting<std::uint8_t>(std::endian::little);
        for (const char* const shape :
             {"(1, 5, 4, 3)", "(5, 4, 3, 1)", "(5, 1, 4, 1, 3)", "(5L, 4L, 3L)", "(5,4,3,)"}) {
            const auto dataset = read(npy(dictionaryOf("|u1", shape), numbers), lastIsX);
            QVERIFY2(dataset, text_);
            QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{3, 4, 5}));
            QVERIFY(holdsTestSamples(dataset->values));
        }
    }

    void whatFollowsIsTold()
    {
        const auto dataset =
            read(npy(dictionaryOf("|u1", "(3, 4, 5)", true), counting<std::uint8_t>(std::endian::little) + "second"));
        QVERIFY2(dataset, text_);
        QVERIFY(holdsTestSamples(dataset->values));
        QVERIFY(sentences(dataset->source.leftOut).contains("6 bytes after"));
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QList<QByteArray>>("words");
        const QByteArray numbers = counting<std::uint8_t>(std::endian::little);
        const auto row = [](const char* name, const QByteArray& file, const QList<QByteArray>& words) {
            QTest::newRow(name) << file << words;
        };
        const auto type = [&](const char* name, const QByteArray& word, const QList<QByteArray>& words) {
            row(name, npy(dictionaryOf(word, "(5, 4, 3)"), numbers), words);
        };
        const auto shape = [&](const char* name, const QByteArray& word, const QList<QByteArray>& words) {
            row(name, npy(dictionaryOf("|u1", word), numbers), words);
        };
        const auto dictionary = [&](const char* name, const QByteArray& text, const QList<QByteArray>& words) {
            row(name, npy(text, numbers), words);
        };
        row("no array", "something else", {"first bytes"});
        row("magic alone", QByteArray("\x93NUMPY", 6), {"cut short"});
        row("a later version", npy(dictionaryOf("|u1", "(5, 4, 3)"), numbers, 4), {"version 4"});
        row("a header that is cut", npy(dictionaryOf("|u1", "(5, 4, 3)"), "").left(50), {"cut short"});
        row("an endless header", QByteArray("\x93NUMPY\x02\x00\xff\xff\xff\xff{", 13), {"cut short"});
        type("objects", "|O", {"Python objects", "astype"});
        type("texts", "<U5", {"'<U5'", "astype"});
        type("dates", "<M8[ns]", {"'<M8[ns]'"});
        type("long doubles", "<f16", {"'<f16'", "astype"});
        type("no type", "", {"''"});
        dictionary("records",
                   "{'descr': [('a', '<f4'), ('b', [('c', '<i2', (3,))])], 'fortran_order': False, "
                   "'shape': (60,), }",
                   {"records", "array['field']"});
        dictionary("records without end", "{'descr': [('a', '<f4'", {"not understood"});
        dictionary("no dictionary", "import os", {"dictionary"});
        dictionary("code", "{'descr': __import__('os'), 'fortran_order': False, 'shape': (5, 4, 3), }",
                   {"not understood"});
        dictionary("no type at all", "{'fortran_order': False, 'shape': (5, 4, 3), }", {"'descr'", "missing"});
        dictionary("no shape", "{'descr': '|u1', 'fortran_order': False, }", {"missing"});
        dictionary("an order that is none", "{'descr': '|u1', 'fortran_order': 1, 'shape': (5, 4, 3), }",
                   {"not understood"});
        dictionary("no end", "{'descr': '|u1', 'fortran_order': False, 'shape': (5, 4, 3)", {"not understood"});
        shape("no dimensions", "()", {"shape ()"});
        shape("one dimension", "(60,)", {"shape (60)", "array[0]"});
        shape("two dimensions", "(12, 5)", {"shape (12 x 5)"});
        shape("colours", "(5, 2, 2, 3)", {"shape (5 x 2 x 2 x 3)", "array[..., 0]"});
        shape("a slice", "(1, 12, 5)", {"1 x 12 x 5", "at least 2"});
        shape("nothing", "(0, 4, 5)", {"at least 2"});
        shape("negative", "(-5, 4, 3)", {"not understood"});
        shape("a number that is none", "(5, 4, 3e1)", {"not understood"});
        shape("too large", "(4000000000, 4000000000, 4000000000)", {"more than any machine"});
        shape("larger than numbers", "(99999999999999999999, 4, 3)", {"not understood"});
        shape("many times what there is", "(65536, 65536, 1024)", {"65536 x 65536 x 1024", "only 60 bytes"});
        shape("more than there is", "(5, 4, 4)", {"5 x 4 x 4", "only 60 bytes", "cut short"});
        shape("endless dimensions", "(" + QByteArray("1, ").repeated(20000) + ")", {"not understood"});
    }
    void refuses()
    {
        QFETCH(QByteArray, file);
        QFETCH(QList<QByteArray>, words);
        QCOMPARE(refusalFault(write(file), words), QByteArray());
    }

    void refusesWhatTheHeaderTells()
    {
        const auto path = write(npy(dictionaryOf("|u1", "(5, 4, 3)"), counting<std::uint8_t>(std::endian::little)));
        QCOMPARE(refusalFault(path, {"'--size'"}, {{"size", std::string("3x4x5")}}), QByteArray());
        QCOMPARE(refusalFault(path, {"'pressure'", "only one array"}, {{"array", std::string("pressure")}}),
                 QByteArray());
        QCOMPARE(refusalFault(path, {"one number for each sample"}, {{"component", std::string("1")}}), QByteArray());
        QCOMPARE(refusalFault(path, {"Give three numbers"}, {{"spacing", std::string("1x2")}}), QByteArray());
        QVERIFY(readFormat(path, text_, {{"array", std::string()}, {"component", std::string("magnitude")}}));
    }

    void cutFilesAreRefused()
    {
        const QByteArray file = npy(dictionaryOf("<i2", "(5, 4, 3)"), counting<std::int16_t>(std::endian::little));
        for (qsizetype bytes = 1; bytes < file.size(); ++bytes)
            QCOMPARE(refusalFault(write(file.left(bytes)), {"volume.npy"}), QByteArray());
    }

    void probesWithoutTheNumbers()
    {
        const auto contents = asLoaded<LatticeReader>().probe(
            write(npy(dictionaryOf("<i8", "(5, 4, 3)"), counting<std::int64_t>(std::endian::little))), {}, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->points, std::uint64_t(60));
        QVERIFY(!contents->type); // it depends on the numbers
        QVERIFY((contents->untold == std::vector<std::string>{"spacing", "origin", "unit", "axes"}));
    }

    void theSharedCase()
    {
        const auto path = sharedCases() / "other" / "vol.npy";
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = readFormat(path, text_);
        QVERIFY2(dataset, text_);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{9, 11, 13}));
        QVERIFY(distanceFromWorld(*dataset, 3) < 1e-5);
    }

private:
    std::filesystem::path write(const QByteArray& file) { return folder_.write("volume.npy", file); }
    std::optional<Dataset> read(const QByteArray& file, const ParameterValues& values = {})
    {
        return readFormat(write(file), text_, values);
    }

    TestFolder folder_;
    QByteArray text_;
};

QTEST_GUILESS_MAIN(NpyReaderTest)
#include "npy_reader_test.moc"
