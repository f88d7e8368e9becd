// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays of Zarr hold a known function of the indices; chunks are written here, byte by byte, or by numcodecs.
#include "tests/lacks.h"
#include "tests/plugins/readers/zarr/zarr_files.h"

#include <QProcess>
#include <QTest>
#include <qfloat16.h>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

#define VERIFY_OK(result) QVERIFY2((result).ok(), (result).ok() ? "" : (result).error().text().c_str())

constexpr std::array<int, 3> zyx = {5, 4, 7};
const std::vector<int> shape = {5, 4, 7}, chunk = {2, 3, 4};

double value(int i, int j, int k)
{
    return i + 10 * j + 25 * k;
}

template <class T> ChunkedArray numbersOf(bool isBig = false, double shift = 0)
{
    return {shape, chunk, {}, [=](const std::vector<int>& at) {
                return chunkNumber(static_cast<T>(float(value(at[2], at[1], at[0]) + shift)), isBig);
            }};
}

double distance(const Dataset& dataset, double shift = 0)
{
    if (dataset.lattice.size != std::array<std::uint32_t, 3>{zyx[2], zyx[1], zyx[0]})
        return 1e9;
    double largest = 0;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
        const auto [i, j, k] = dataset.lattice.coordinates(point);
        largest = std::max(largest, std::abs(dataset.values.at(point) - shift - value(int(i), int(j), int(k))));
    }
    return largest;
}

/// Metadata of version 2 with other values for some keys.
QByteArray zarray(const QByteArray& type, const QByteArray& more = {}, const QByteArray& compressor = "null")
{
    return R"({"zarr_format": 2, "shape": [5, 4, 7], "chunks": [2, 3, 4], "dtype": ")" + type +
           R"(", "fill_value": 7, "compressor": )" + compressor +
           (more.contains("order") ? QByteArray() : QByteArray(R"(, "order": "C")")) + more + "}";
}

QByteArray zarrJson(const QByteArray& type, const QByteArray& codecs, const QByteArray& more = {},
                    const QByteArray& chunks = "[2, 3, 4]")
{
    return R"({"zarr_format": 3, "node_type": "array", "shape": [5, 4, 7], "data_type": ")" + type +
           R"(", "fill_value": 7, "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": )" + chunks +
           R"(}}, "chunk_key_encoding": {"name": "default"}, "codecs": )" + codecs + more + "}";
}

const QByteArray little = R"({"name": "bytes", "configuration": {"endian": "little"}})";

Result<Dataset> readStore(const fs::path& path, const ParameterValues& values = {})
{
    return builtZarrReader().read(path, values, {});
}

/// CRC-32C by its definition, bit by bit.
quint32 bitwiseChecksum(const QByteArray& bytes)
{
    quint32 rest = 0xffffffff;
    for (const char byte : bytes) {
        rest ^= quint8(byte);
        for (int bit = 0; bit < 8; ++bit)
            rest = (rest & 1) != 0 ? rest >> 1 ^ 0x82f63b78 : rest >> 1;
    }
    return ~rest;
}

} // namespace

class ZarrArraysTest : public QObject {
    Q_OBJECT

private slots:
    void numbersOfAllTypes()
    {
        const auto check = [&]<class T>(T, const QByteArray& two, const QByteArray& three, SampleType type,
                                        double shift = 0) {
            for (const bool isBig : {false, true}) {
                const ZarrStore old, young;
                old.write(".zarray", zarray((isBig ? ">" : "<") + two));
                writeChunks(old, "", '.', numbersOf<T>(isBig, shift));
                young.write("zarr.json",
                            zarrJson(three, QByteArray(R"([{"name": "bytes", "configuration": {"endian": ")") +
                                                (isBig ? "big" : "little") + "\"}}]"));
                writeChunks(young, "c/", '/', numbersOf<T>(isBig, shift));
                for (const fs::path& path : {old.path(), young.path("zarr.json")}) {
                    const auto dataset = readStore(path);
                    if (!dataset.ok() || dataset->values.type() != type || distance(*dataset, shift) != 0)
                        return false;
                }
            }
            return true;
        };
        QVERIFY(check(quint8(), "u1", "uint8", SampleType::UInt8));
        QVERIFY(check(qint8(), "i1", "int8", SampleType::Int8, -100));
        QVERIFY(check(quint16(), "u2", "uint16", SampleType::UInt16));
        QVERIFY(check(qint16(), "i2", "int16", SampleType::Int16));
        QVERIFY(check(quint32(), "u4", "uint32", SampleType::UInt32));
        QVERIFY(check(qint32(), "i4", "int32", SampleType::Int32));
        QVERIFY(check(quint64(), "u8", "uint64", SampleType::Int32));
        QVERIFY(check(qint64(), "i8", "int64", SampleType::Int32));
        QVERIFY(check(qfloat16(), "f2", "float16", SampleType::Float32, -50.5));
        QVERIFY(check(float(), "f4", "float32", SampleType::Float32));
        QVERIFY(check(double(), "f8", "float64", SampleType::Float64));
    }

    void largeWholeNumbers()
    {
        const ZarrStore store;
        store.write(".zarray", zarray("<i8"));
        ChunkedArray array = numbersOf<qint64>();
        array.number = [](const std::vector<int>& at) {
            return chunkNumber(qint64(at[0] + at[1] + at[2] == 0 ? (1LL << 53) + 1 : 5'000'000'000LL * at[2]), false);
        };
        writeChunks(store, "", '.', array);
        const auto rounded = readStore(store.path());
        VERIFY_OK(rounded);
        QVERIFY(rounded->values.type() == SampleType::Float64 && rounded->values.at(2) == 1e10);
        QVERIFY(zarrTexts(rounded->remarks).find("1 whole numbers of 64 bits were rounded") != std::string::npos);
    }

    void waysOfPacking_data()
    {
        QTest::addColumn<QByteArray>("compressor");
        QTest::addColumn<QByteArray>("codec");
        QTest::addColumn<int>("way");
        QTest::newRow("zlib") << QByteArray(R"({"id": "zlib", "level": 1})") << QByteArray() << 0;
        QTest::newRow("gzip") << QByteArray(R"({"id": "gzip", "level": 1})") << QByteArray(R"({"name": "gzip"})") << 1;
        QTest::newRow("gzip in two members")
            << QByteArray(R"({"id": "gzip", "level": 1})") << QByteArray(R"({"name": "gzip"})") << 2;
        QTest::newRow("zstd") << QByteArray(R"({"id": "zstd", "level": 1})")
                              << QByteArray(R"({"name": "zstd", "configuration": {"level": 3}})") << 3;
        QTest::newRow("crc32c") << QByteArray() << QByteArray(R"({"name": "crc32c"})") << 4;
        QTest::newRow("zstd, crc32c") << QByteArray() << QByteArray(R"({"name": "zstd"}, {"name": "crc32c"})") << 5;
    }
    void waysOfPacking()
    {
        QFETCH(QByteArray, compressor);
        QFETCH(QByteArray, codec);
        QFETCH(int, way);
        ChunkedArray array = numbersOf<quint16>();
        const auto checked = [](const QByteArray& bytes) { return bytes + chunkNumber(bitwiseChecksum(bytes), false); };
        array.pack = [&](const QByteArray& bytes) {
            switch (way) {
            case 0: return packedByZlib(bytes);
            case 1: return packedByGzip(bytes);
            case 2: return packedByGzip(bytes.first(10)) + packedByGzip(bytes.sliced(10));
            case 3: return packedByZstandard(bytes);
            case 4: return checked(bytes);
            default: return checked(packedByZstandard(bytes));
            }
        };
        if (!compressor.isEmpty()) {
            const ZarrStore store;
            store.write(".zarray", zarray("<u2", R"(, "dimension_separator": "/")", compressor));
            writeChunks(store, "", '/', array);
            const auto dataset = readStore(store.path(".zarray"));
            VERIFY_OK(dataset);
            QCOMPARE(distance(*dataset), 0.0);
        }
        if (codec.isEmpty())
            return;
        const ZarrStore store;
        store.write("zarr.json", zarrJson("uint16", "[" + little + ", " + codec + "]"));
        writeChunks(store, "c/", '/', array);
        const auto dataset = readStore(store.path());
        VERIFY_OK(dataset);
        QCOMPARE(distance(*dataset), 0.0);
    }

    void ordersOfAxes()
    {
        const ZarrStore old, young;
        old.write(".zarray", zarray("<f4", R"(, "order": "F")"));
        ChunkedArray array = numbersOf<float>();
        array.order = {2, 1, 0};
        writeChunks(old, "", '.', array);
        const auto first = readStore(old.path());
        VERIFY_OK(first);
        QCOMPARE(distance(*first), 0.0);
        young.write(
            "zarr.json",
            zarrJson("float32", R"([{"name": "transpose", "configuration": {"order": [1, 2, 0]}}, )" + little + "]"));
        array.order = {1, 2, 0};
        writeChunks(young, "c/", '/', array);
        const auto second = readStore(young.path());
        VERIFY_OK(second);
        QCOMPARE(distance(*second), 0.0);
    }

    /// Old writers nest their chunks and do not say so.
    void separatorThatNobodySays()
    {
        const ZarrStore store;
        store.write(".zarray", zarray("<f4"));
        writeChunks(store, "", '/', numbersOf<float>());
        const auto dataset = readStore(store.path());
        VERIFY_OK(dataset);
        QCOMPARE(distance(*dataset), 0.0);
    }

    /// Of a chunk that nobody wrote the values are the fill value.
    void missingChunks()
    {
        const ZarrStore store;
        store.write(".zarray", zarray("<f4"));
        writeChunks(store, "", '.', numbersOf<float>());
        fs::remove(store.path("2.1.1"));
        const auto dataset = readStore(store.path());
        VERIFY_OK(dataset);
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
            const auto [i, j, k] = dataset->lattice.coordinates(point);
            const bool isLost = i >= 4 && j >= 3 && k >= 4;
            QCOMPARE(dataset->values.at(point), isLost ? 7 : value(int(i), int(j), int(k)));
        }
        QVERIFY(zarrTexts(dataset->remarks).find("1 of its 12 chunks are missing") != std::string::npos);
    }

    /// Chunks of chunks in one file, one of which nobody wrote.
    void shards_data()
    {
        QTest::addColumn<bool>("isFirst");
        QTest::newRow("index at the end") << false;
        QTest::newRow("index at the start") << true;
    }
    void shards()
    {
        QFETCH(bool, isFirst);
        const ZarrStore store;
        const QByteArray innerCodecs = "[" + little + R"(, {"name": "gzip"}])";
        const QByteArray indexCodecs = "[" + little + R"(, {"name": "crc32c"}])";
        const QByteArray sharding =
            R"([{"name": "sharding_indexed", "configuration": {"chunk_shape": [2, 2, 4], "codecs": )" + innerCodecs +
            ", \"index_codecs\": " + indexCodecs + ", \"index_location\": \"" + (isFirst ? "start" : "end") + "\"}}]";
        store.write("zarr.json", zarrJson("float32", sharding, {}, "[4, 4, 8]"));
        for (int shard = 0; shard < 2; ++shard) {
            ChunkedArray inner = numbersOf<float>();
            inner.shape = {4, 4, 8};
            inner.chunk = {2, 2, 4};
            inner.number = [&](const std::vector<int>& at) {
                return chunkNumber(float(value(at[2], at[1], at[0] + 4 * shard)), false);
            };
            inner.pack = packedByGzip;
            QByteArray index, content;
            const qsizetype before = isFirst ? 8 * 16 + 4 : 0;
            forEachChunk(inner, [&](const std::vector<int>& numbers, const QByteArray& file) {
                const bool isLost = shard == 0 && numbers == std::vector<int>{0, 1, 1};
                index += isLost ? QByteArray(16, '\xff')
                                : chunkNumber(quint64(before + content.size()), false) +
                                      chunkNumber(quint64(file.size()), false);
                content += isLost ? QByteArray() : file;
            });
            index += chunkNumber(bitwiseChecksum(index), false);
            store.write("c/" + std::to_string(shard) + "/0/0", isFirst ? index + content : content + index);
        }
        const auto dataset = readStore(store.path());
        VERIFY_OK(dataset);
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
            const auto [i, j, k] = dataset->lattice.coordinates(point);
            QCOMPARE(dataset->values.at(point), i >= 4 && j >= 2 && k < 2 ? 7 : value(int(i), int(j), int(k)));
        }
        QVERIFY(zarrTexts(dataset->remarks).find("1 of its 12 chunks") != std::string::npos);
    }

    void groupsOfArrays()
    {
        const ZarrStore store;
        store.write(".zgroup", R"({"zarr_format": 2})");
        for (const std::string name : {"density", "more/heat"}) {
            store.write(name + "/.zarray", zarray("<f4"));
            ChunkedArray array = numbersOf<float>();
            if (name != "density")
                array.number = [](const std::vector<int>& at) { return chunkNumber(float(at[2] - at[0]), false); };
            writeChunks(store, name + "/", '.', array);
        }
        store.write("more/.zgroup", R"({"zarr_format": 2})");
        store.write("x/.zarray", R"({"zarr_format": 2, "shape": [7], "chunks": [7], "dtype": "<f4", "order": "C",
            "fill_value": 0, "compressor": null})");
        const auto first = readStore(store.path(".zgroup"));
        VERIFY_OK(first);
        QCOMPARE(distance(*first), 0.0);
        QVERIFY(zarrTaken(first->source.taken, TakenPart::Array).find("density (a guess)") != std::string::npos);
        QVERIFY(first->source.valueName == "density");
        const auto second = readStore(store.path(), {{"array", std::string("more/heat")}});
        VERIFY_OK(second);
        QCOMPARE(second->values.at(6), 6.0);
        const auto contents = builtZarrReader().probe(store.path(), {}, {});
        VERIFY_OK(contents);
        QVERIFY(contents->arrays.size() == 2 && contents->arrays[1].name == "more/heat");
        QVERIFY(contents->taken == first->source.taken && contents->leftOut == first->source.leftOut);
        QVERIFY(!readStore(store.path(), {{"array", std::string("pressure")}}).ok());
    }

    /// An axis beyond the three is chosen by its name; where names say which axes x, y and z are, that counts.
    void axesByName()
    {
        const ZarrStore store;
        store.write("zarr.json",
                    R"({"zarr_format": 3, "node_type": "array", "shape": [3, 2, 4, 5], "data_type": "int16",
            "fill_value": 0, "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [2, 2, 2, 2]}},
            "chunk_key_encoding": {"name": "v2"}, "dimension_names": ["x", "angle", "z", "y"],
            "codecs": [)" +
                        little + "]}");
        ChunkedArray array{{3, 2, 4, 5}, {2, 2, 2, 2}, {}, [](const std::vector<int>& at) {
                               return chunkNumber(qint16(at[0] + 10 * at[3] + 100 * at[2] + 1000 * at[1]), false);
                           }};
        writeChunks(store, "", '.', array);
        const auto dataset = readStore(store.path(), {{"index", std::string("angle=2")}});
        VERIFY_OK(dataset);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{3, 5, 4}));
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
            const auto [i, j, k] = dataset->lattice.coordinates(point);
            QCOMPARE(dataset->values.at(point), double(i + 10 * j + 100 * k + 1000));
        }
        const auto first = readStore(store.path());
        QVERIFY(first.ok() && first->values.at(0) == 0);
        QVERIFY(zarrTexts(first->source.leftOut).find("'angle'") != std::string::npos);
        QVERIFY(!readStore(store.path(), {{"index", std::string("angle=3")}}).ok());
        QVERIFY(!readStore(store.path(), {{"index", std::string("member=1")}}).ok());
    }

    /// Stores that zarr and numcodecs write, with their ways of packing and filters.
    void otherWriters()
    {
        const ZarrStore store;
        QProcess python;
        python.start("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/plugins/readers/zarr/make_zarr_files.py",
                                          QString::fromStdString(store.path().string())});
        QVERIFY(python.waitForFinished(120'000));
        if (python.exitCode() == 77)
            QSKIP_WITHOUT("python3-zarr");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
        int count = 0;
        for (const auto& entry : fs::directory_iterator(store.path())) {
            const auto dataset = readStore(entry.path());
            QVERIFY2(dataset.ok(),
                     (entry.path().string() + (dataset.ok() ? "" : ": " + dataset.error().text())).c_str());
            QVERIFY2(distance(*dataset) == 0, entry.path().c_str());
            ++count;
        }
        QVERIFY2(count >= 20, std::to_string(count).c_str());
    }
};

QTEST_GUILESS_MAIN(ZarrArraysTest)
#include "zarr_arrays_test.moc"
