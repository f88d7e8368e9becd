// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be read is refused with a true sentence, quickly and without much memory, and nothing outside of the
// folder is read.
#include "tests/plugins/readers/zarr/zarr_files.h"

#include <QElapsedTimer>
#include <QTest>

#include <random>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

QByteArray metadata(const QByteArray& shape, const QByteArray& chunks, const QByteArray& more,
                    const QByteArray& type = "<u2")
{
    return R"({"zarr_format": 2, "shape": )" + shape + R"(, "chunks": )" + chunks + R"(, "dtype": ")" + type +
           R"(", "order": "C")" + more + "}";
}

const QByteArray plain = R"(, "fill_value": 0, "compressor": null)";
const QByteArray packed = R"(, "fill_value": 0, "compressor": {"id": "zlib", "level": 1})";

/// The text of the refusal; empty if it was read.
std::string refusal(const fs::path& path, const ParameterValues& values = {})
{
    const auto dataset = builtZarrReader().read(path, values, {});
    return dataset ? "" : dataset.error().text();
}

ChunkedArray counted()
{
    return {{4, 4, 4}, {2, 2, 2}, {}, [](const std::vector<int>& at) {
                return chunkNumber(quint16(at[0] + 7 * at[1] + 50 * at[2]), false);
            }};
}

} // namespace

class ZarrRefusalsTest : public QObject {
    Q_OBJECT

private slots:
    void metadataThatAreNotRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<std::string>("said");
        const auto row = [](const char* name, const QByteArray& text, const char* said) {
            QTest::newRow(name) << text << std::string(said);
        };
        row("no JSON", "{\"zarr_format\": 2, ", "is not JSON");
        row("no object", "[1, 2]", "no JSON object");
        row("version 4", R"({"zarr_format": 4})", "version 4 of Zarr's format");
        row("no shape", R"({"zarr_format": 2, "dtype": "<u2"})", "'shape'");
        row("a negative size", metadata("[4, -4, 4]", "[2, 2, 2]", plain), "'shape'");
        row("a size that is no number", metadata("[4, \"4\", 4]", "[2, 2, 2]", plain), "'shape'");
        row("a size of 0", metadata("[4, 0, 4]", "[2, 2, 2]", plain), "holds no values");
        row("chunks without size", metadata("[4, 4, 4]", "[2, 0, 2]", plain), "chunks have no size");
        row("chunks of other axes", metadata("[4, 4, 4]", "[2, 2]", plain), "have 2 axes, and it has 3");
        row("huge chunks", metadata("[4, 4, 4]", "[4294967296, 4294967296, 4294967296]", plain), "any machine");
        row("huge", metadata("[1000000, 1000000, 1000000]", "[100000, 100000, 100000]", plain), "any machine");
        row("huge, many chunks", metadata("[1000000, 1000000, 1000000]", "[1, 1, 1]", plain), "any machine");
        row("many chunks", metadata("[400, 400, 400]", "[1, 1, 1]", plain), "larger chunks");
        row("many chunks, which take minutes to look for", metadata("[256, 256, 256]", "[1, 1, 1]", plain),
            "larger chunks");
        row("many codecs",
            metadata("[4, 4, 4]", "[2, 2, 2]",
                     ", \"filters\": [" + QByteArray("{\"id\": \"shuffle\"}, ").repeated(1000) +
                         "{\"id\": \"shuffle\"}]"),
            "1001 codecs");
        row("no chunks", metadata("[4, 4, 4]", "[2, 2, 2]", plain), "none of the 8 files");
        row("texts", metadata("[4, 4, 4]", "[2, 2, 2]", plain, "<U5"), "type '<U5'");
        row("complex numbers", metadata("[4, 4, 4]", "[2, 2, 2]", plain, "<c8"), "type '<c8'");
        row("a picture", metadata("[40, 40]", "[2, 2]", plain), "array with 2 axes");
        row("LZMA", metadata("[4, 4, 4]", "[2, 2, 2]", R"(, "fill_value": 0, "compressor": {"id": "lzma"})"), "'lzma'");
        row("a filter", metadata("[4, 4, 4]", "[2, 2, 2]", R"(, "filters": [{"id": "fixedscaleoffset"}])"),
            "'fixedscaleoffset'");
        row("a fill value that does not fit", metadata("[4, 4, 4]", "[2, 2, 2]", R"(, "fill_value": 70000)"),
            "'fill_value'");
    }
    void metadataThatAreNotRead()
    {
        QFETCH(QByteArray, text);
        QFETCH(std::string, said);
        const ZarrStore store;
        store.write(".zarray", text);
        QElapsedTimer timer;
        timer.start();
        const std::string refused = refusal(store.path());
        QVERIFY2(refused.find(said) != std::string::npos, refused.c_str());
        QVERIFY(timer.elapsed() < 20'000);
    }

    void codecsThatAreNotRead()
    {
        const auto refusedCodecs = [](const QByteArray& codecs) {
            const ZarrStore store;
            store.write("zarr.json", R"({"zarr_format": 3, "node_type": "array", "shape": [4, 4, 4],
                "data_type": "uint16", "fill_value": 0, "chunk_grid": {"name": "regular", "configuration":
                {"chunk_shape": [2, 2, 2]}}, "chunk_key_encoding": {"name": "default"}, "codecs": )" +
                                         codecs + "}");
            return refusal(store.path());
        };
        const QByteArray bytes = R"({"name": "bytes", "configuration": {"endian": "little"}})";
        QVERIFY(refusedCodecs("[" + bytes + R"(, {"name": "numcodecs.lz4"}])").find("'numcodecs.lz4'") !=
                std::string::npos);
        QVERIFY(refusedCodecs(R"([{"name": "bytes"}])").find("'endian'") != std::string::npos);
        QVERIFY(refusedCodecs("[]").find("'codecs'") != std::string::npos);
        QVERIFY(refusedCodecs("[" + bytes + ", " + bytes + "]").find("unusual place") != std::string::npos);
        QVERIFY(refusedCodecs(R"([{"name": "transpose", "configuration": {"order": [0, 0, 1]}}, )" + bytes + "]")
                    .find("'order'") != std::string::npos);
    }

    void damagedChunks()
    {
        const ZarrStore store;
        store.write(".zarray", metadata("[4, 4, 4]", "[2, 2, 2]", packed));
        ChunkedArray array = counted();
        array.pack = packedByZlib;
        writeChunks(store, "", '.', array);
        QCOMPARE(refusal(store.path()), std::string());
        const auto refusedChunk = [&](const QByteArray& content) {
            store.write("1.0.1", content);
            return refusal(store.path());
        };
        const QByteArray right(16, 'a');
        QVERIFY(refusedChunk(packedByZlib(right).chopped(6)).find("'1.0.1': it is damaged: it is cut short") !=
                std::string::npos);
        QVERIFY(refusedChunk("no zlib").find("cannot be unpacked") != std::string::npos);
        QVERIFY(refusedChunk(packedByZlib(right.first(14))).find("14 bytes of numbers instead of 16") !=
                std::string::npos);
        QVERIFY(refusedChunk(packedByZlib(QByteArray(5'000'000, '\0')))
                    .find("unpacks to more than the expected 16 bytes") != std::string::npos);
        QVERIFY(refusedChunk(QByteArray(1'000'000, 'x')).find("more than its 16 bytes") != std::string::npos);
        QVERIFY(refusedChunk({}).find("cut short") != std::string::npos);
        QCOMPARE(refusedChunk(packedByZlib(right)), std::string());
    }

    void damagedShards()
    {
        const ZarrStore store;
        store.write("zarr.json", R"({"zarr_format": 3, "node_type": "array", "shape": [4, 4, 4], "data_type": "uint8",
            "fill_value": 0, "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [4, 4, 4]}},
            "chunk_key_encoding": {"name": "default"}, "codecs": [{"name": "sharding_indexed", "configuration": {
            "chunk_shape": [4, 4, 2], "codecs": [{"name": "bytes"}], "index_codecs": [{"name": "bytes",
            "configuration": {"endian": "little"}}]}}]})");
        const auto refusedShard = [&](const std::vector<quint64>& index) {
            QByteArray file;
            for (int number = 0; number < 64; ++number)
                file += char(number * number % 50);
            for (const quint64 number : index)
                file += chunkNumber(number, false);
            store.write("c/0/0/0", file);
            return refusal(store.path());
        };
        constexpr quint64 none = ~quint64(0);
        QCOMPARE(refusedShard({0, 32, 32, 32}), std::string());
        QVERIFY(refusedShard({0, 32, 90, 32}).find("beyond its end") != std::string::npos);
        QVERIFY(refusedShard({0, 32, none - 16, 32}).find("beyond its end") != std::string::npos);
        QVERIFY(refusedShard({0, 32, 0, 31}).find("31 bytes of numbers instead of 32") != std::string::npos);
        QVERIFY(refusedShard({none, none, none, none}).find("none of its 2 chunks was written") != std::string::npos);
        store.write("c/0/0/0", "short");
        QVERIFY(refusal(store.path()).find("shorter than the index") != std::string::npos);
    }

    /// Names and links that lead elsewhere are refused, whoever made them.
    /// What a file says reaches no terminal as it is.
    void namesOfAxesAreShownSafely()
    {
        ZarrStore store;
        QByteArray text = metadata("[4, 4, 4]", "[2, 2, 2]", plain);
        store.write("a.zarr/.zarray", text);
        store.write("a.zarr/.zattrs", "{\"_ARRAY_DIMENSIONS\": [\"z\", \"\x1b[31m\", \"x\"]}");
        const auto contents = builtZarrReader().probe(store.path("a.zarr"), {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        const std::string places = zarrTaken(contents->taken, TakenPart::Places);
        QVERIFY2(places.find("along its axes") != std::string::npos, places.c_str());
        QVERIFY(places.find('\x1b') == std::string::npos);
    }

    void nothingOutside()
    {
        const ZarrStore store;
        const auto writeArray = [&](const std::string& folder) {
            store.write(folder + "/.zarray", metadata("[4, 4, 4]", "[2, 2, 2]", plain));
            writeChunks(store, folder + "/", '.', counted());
        };
        writeArray("outside");
        writeArray("in.zarr/0");
        const auto names = [&](const std::string& path) {
            store.write("in.zarr/.zattrs", R"({"multiscales": [{"axes": ["z", "y", "x"], "datasets": [{"path": ")" +
                                               QByteArray::fromStdString(path) + R"("}]}]})");
            return refusal(store.path("in.zarr"));
        };
        QCOMPARE(names("0"), std::string());
        for (const std::string& path : {std::string("../outside"), std::string("0/../../outside"), std::string("."),
                                        store.path("outside").string(), std::string("0//x")})
            QVERIFY2(names(path).find("not a path inside the folder") != std::string::npos, path.c_str());
        fs::create_directory_symlink("../outside", store.path("in.zarr/link"));
        QVERIFY(names("link").find("leads out of the folder") != std::string::npos);
        fs::create_directory_symlink("0", store.path("in.zarr/same"));
        QCOMPARE(names("same"), std::string());

        const fs::path chunk = store.path("in.zarr/0/1.1.1");
        fs::remove(chunk);
        fs::create_symlink(store.path("outside/1.1.1"), chunk);
        QVERIFY(names("0").find("'0/1.1.1' is a link that leads out of the folder") != std::string::npos);
        fs::remove(chunk);
        fs::create_symlink("nowhere", chunk);
        QVERIFY(names("0").find("is a link to something that does not exist") != std::string::npos);
        fs::remove(chunk);
        fs::create_directory(chunk);
        QVERIFY(names("0").find("is not a file") != std::string::npos);
        QVERIFY(refusal(store.path("in.zarr"), {{"array", std::string("../outside")}}).find("not a path inside") !=
                std::string::npos);
    }

    void imagesThatAreNotRead()
    {
        const ZarrStore store;
        store.write("0/.zarray", metadata("[4, 4, 4]", "[2, 2, 2]", plain));
        writeChunks(store, "0/", '.', counted());
        const auto refused = [&](const QByteArray& multiscale) {
            store.write(".zattrs", "{\"multiscales\": [" + multiscale + "]}");
            return refusal(store.path());
        };
        const QByteArray axes = R"("axes": ["z", "y", "x"], )";
        const auto placed = [&](const QByteArray& transformations) {
            return refused("{" + axes + R"("datasets": [{"path": "0", "coordinateTransformations": [)" +
                           transformations + "]}]}");
        };
        QCOMPARE(placed(R"({"type": "scale", "scale": [1, 2, 3]})"), std::string());
        QVERIFY(placed(R"({"type": "scale", "scale": [1, 2]})").find("each of its 3 axes") != std::string::npos);
        QVERIFY(placed(R"({"type": "scale", "scale": [1, 0, 3]})").find("scale along an axis") != std::string::npos);
        QVERIFY(placed(R"({"type": "affine"})").find("'affine'") != std::string::npos);
        QVERIFY(placed(R"({"type": "scale", "path": "s"})").find("separate array") != std::string::npos);
        QVERIFY(refused("{" + axes + "\"datasets\": []}").find("names no levels") != std::string::npos);
        QVERIFY(refused(R"({"datasets": [{"path": "0"}]})").find("has 3 axes, and it describes 5") !=
                std::string::npos);
        QVERIFY(refused("{" + axes + R"("datasets": [{"path": "7"}]})").find("'7' is missing") != std::string::npos);
        QVERIFY(refused(R"({"axes": ["t", "y", "x"], "datasets": [{"path": "0"}]})").find("pictures, not volumes") !=
                std::string::npos);
        QVERIFY(refused("").find("is empty") != std::string::npos);
    }

    /// Metadata with bytes changed anywhere never end the program, and never make it read for long.
    void changedMetadata()
    {
        const ZarrStore store;
        const QByteArray right = metadata("[4, 4, 4]", "[2, 2, 2]", packed);
        ChunkedArray array = counted();
        array.pack = packedByZlib;
        writeChunks(store, "", '.', array);
        std::mt19937 chance(5); // the same each time
        for (int round = 0; round < 30; ++round) {
            QByteArray text = right;
            for (int change = 0; change < 2; ++change)
                text[qsizetype(chance() % std::size_t(text.size()))] = "0192-[]{}\",: <>fue"[chance() % 18];
            store.write(".zarray", text);
            const std::string refused = refusal(store.path());
            QVERIFY2(refused.find("crashed") == std::string::npos, (text.toStdString() + refused).c_str());
        }
    }

    void withoutItsProgram()
    {
        const ZarrStore store;
        store.write(".zarray", metadata("[4, 4, 4]", "[2, 2, 2]", plain));
        const ZarrReader reader(store.path("tan-read-zarr"));
        const auto dataset = reader.read(store.path(), {}, {});
        QVERIFY(!dataset.ok() && dataset.error().text().find("libblosc-dev") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(ZarrRefusalsTest)
#include "zarr_refusals_test.moc"
