// SPDX-License-Identifier: GPL-3.0-or-later
// Images of OME-Zarr hold a known function of the place in the world.
#include "tests/plugins/readers/zarr/zarr_files.h"

#include "plugins/host/dataset_opening.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

#define VERIFY_OK(result) QVERIFY2((result).ok(), (result).ok() ? "" : (result).error().text().c_str())

const Eigen::Vector3d voxel(0.25, 0.5, 2), corner(10, -20, 30);

/// Linear, so that a level that was made of others by leaving out samples has it too; all exact.
double atPlace(const Eigen::Vector3d& place, int channel = 0, int time = 0)
{
    return place[0] + 8 * place[1] + 16 * place[2] + 1000 * channel + 5000 * time;
}

double distance(const Dataset& dataset, int channel = 0, int time = 0)
{
    double largest = 0;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        largest =
            std::max(largest, std::abs(dataset.values.at(point) - atPlace(dataset.position(point), channel, time)));
    return largest;
}

QByteArray axesText(const QByteArray& names, const QByteArray& unit = "micrometer")
{
    QByteArray text;
    for (const char name : names) {
        const QByteArray kind = name == 't' ? "time" : name == 'c' ? "channel" : "space";
        text += QByteArray(text.isEmpty() ? "" : ", ") + R"({"name": ")" + name + R"(", "type": ")" + kind + "\"" +
                (kind == "space" && !unit.isEmpty() ? R"(, "unit": ")" + unit + "\"" : QByteArray()) +
                (kind == "time" ? R"(, "unit": "second")" : "") + "}";
    }
    return "[" + text + "]";
}

QByteArray transformation(const QByteArray& kind, const std::vector<double>& numbers)
{
    QByteArray text;
    for (const double number : numbers)
        text += (text.isEmpty() ? "" : ", ") + QByteArray::number(number, 'g', 17);
    return R"({"type": ")" + kind + R"(", ")" + kind + "\": [" + text + "]}";
}

/// An image with axes of these names; level n has each 2^n-th sample. Half of the shift is the image's, half the
/// level's.
struct WrittenImage {
    QByteArray axes = "zyx";
    int version = 2, levels = 2, channels = 1, times = 1;
    QByteArray unit = "micrometer", more{};
    std::array<double, 3> signs{1, 1, 1};
};

int sizeOf(char axis, int level, const WrittenImage& image)
{
    constexpr int x = 9, y = 7, z = 5;
    const int whole = axis == 'x' ? x : axis == 'y' ? y : axis == 'z' ? z : 0;
    return axis == 'c' ? image.channels : axis == 't' ? image.times : (whole - 1) / (1 << level) + 1;
}

Eigen::Vector3d placeOf(const WrittenImage& image, const std::vector<int>& at, int level)
{
    Eigen::Vector3d place = corner;
    for (std::size_t axis = 0; axis < at.size(); ++axis)
        if (const auto letter = QByteArray("xyz").indexOf(image.axes[qsizetype(axis)]); letter >= 0)
            place[letter] += voxel[letter] * image.signs[std::size_t(letter)] * at[axis] * (1 << level);
    return place;
}

void writeLevel(const ZarrStore& store, const std::string& path, const WrittenImage& image, int level)
{
    ChunkedArray array;
    QByteArray shape, chunk;
    for (const char axis : image.axes) {
        array.shape.push_back(sizeOf(axis, level, image));
        array.chunk.push_back(axis == 'c' || axis == 't' ? 1 : 3);
        shape += (shape.isEmpty() ? "" : ", ") + QByteArray::number(array.shape.back());
        chunk += (chunk.isEmpty() ? "" : ", ") + QByteArray::number(array.chunk.back());
    }
    array.number = [&](const std::vector<int>& at) {
        const auto c = image.axes.indexOf('c'), t = image.axes.indexOf('t');
        return chunkNumber(
            atPlace(placeOf(image, at, level), c < 0 ? 0 : at[std::size_t(c)], t < 0 ? 0 : at[std::size_t(t)]), false);
    };
    if (image.version == 2)
        store.write(path + "/.zarray", R"({"zarr_format": 2, "shape": [)" + shape + R"(], "chunks": [)" + chunk +
                                           R"(], "dtype": "<f8", "order": "C", "fill_value": 0, "compressor": null,
                                               "filters": null, "dimension_separator": "/"})");
    else
        store.write(path + "/zarr.json", R"({"zarr_format": 3, "node_type": "array", "shape": [)" + shape +
                                             R"(], "data_type": "float64", "fill_value": 0, "chunk_grid": {"name":
            "regular", "configuration": {"chunk_shape": [)" +
                                             chunk + R"(]}}, "chunk_key_encoding": {"name": "default"},
            "codecs": [{"name": "bytes", "configuration": {"endian": "little"}}]})");
    writeChunks(store, path + (image.version == 2 ? "/" : "/c/"), '/', array);
}

void writeImage(const ZarrStore& store, const std::string& folder, const WrittenImage& image)
{
    const std::string inside = folder.empty() ? "" : folder + "/";
    QByteArray datasets;
    for (int level = 0; level < image.levels; ++level) {
        writeLevel(store, inside + "s" + std::to_string(level), image, level);
        std::vector<double> scale, shift;
        for (const char axis : image.axes) {
            const auto letter = QByteArray("xyz").indexOf(axis);
            scale.push_back(letter < 0 ? 1 : voxel[letter] * image.signs[std::size_t(letter)] * (1 << level) / 2);
            shift.push_back(letter < 0 ? 0 : corner[letter] / 4);
        }
        datasets += QByteArray(level > 0 ? ", " : "") + R"({"path": "s)" + QByteArray::number(level) +
                    R"(", "coordinateTransformations": [)" + transformation("scale", scale) + ", " +
                    transformation("translation", shift) + "]}";
    }
    std::vector<double> doubled, rest;
    for (const char axis : image.axes) {
        const auto letter = QByteArray("xyz").indexOf(axis);
        doubled.push_back(letter < 0 ? 0.5 : 2); // half a second between times
        rest.push_back(letter < 0 ? 0 : corner[letter] / 2);
    }
    const QByteArray text = R"("multiscales": [{"version": "0.4", "axes": )" + axesText(image.axes, image.unit) +
                            R"(, "datasets": [)" + datasets + R"(], "coordinateTransformations": [)" +
                            transformation("scale", doubled) + ", " + transformation("translation", rest) + "]}]" +
                            image.more;
    if (image.version == 2) {
        store.write(inside + ".zgroup", R"({"zarr_format": 2})");
        store.write(inside + ".zattrs", "{" + text + "}");
    } else {
        store.write(inside + "zarr.json",
                    R"({"zarr_format": 3, "node_type": "group", "attributes": {"ome": {"version": "0.5", )" + text +
                        "}}}");
    }
}

const QByteArray channelNames =
    R"(, "omero": {"channels": [{"label": "DAPI"}, {"label": "GFP", "window": {"max": NaN}}]})";

Result<Dataset> readStore(const fs::path& path, const ParameterValues& values = {})
{
    return builtZarrReader().read(path, values, {});
}

} // namespace

class ZarrImagesTest : public QObject {
    Q_OBJECT

private slots:
    void versions_data()
    {
        QTest::addColumn<int>("version");
        QTest::addColumn<QByteArray>("axes");
        for (const int version : {2, 3})
            for (const char* axes : {"zyx", "xyz", "tczyx"})
                QTest::addRow("%d %s", version, axes) << version << QByteArray(axes);
    }
    void versions()
    {
        QFETCH(int, version);
        QFETCH(QByteArray, axes);
        const bool isSeries = axes.size() > 3;
        const ZarrStore store;
        writeImage(store, "",
                   {.axes = axes,
                    .version = version,
                    .channels = 2,
                    .times = 3,
                    .more = isSeries ? channelNames : QByteArray()});
        const auto finest = readStore(store.path());
        VERIFY_OK(finest);
        QCOMPARE(distance(*finest), 0.0);
        QVERIFY((finest->lattice.size == std::array<std::uint32_t, 3>{9, 7, 5}) && finest->lengthUnit == "µm");
        QVERIFY(zarrTaken(finest->source.taken, TakenPart::Block).find("0 of 0 to 1, s0 (a guess)") !=
                std::string::npos);
        for (const char* level : {"1", "s1"}) {
            const auto coarse = readStore(store.path(), {{"part", std::string(level)}});
            VERIFY_OK(coarse);
            QCOMPARE(distance(*coarse), 0.0);
            QVERIFY((coarse->lattice.size == std::array<std::uint32_t, 3>{5, 4, 3}));
        }
        const auto contents = builtZarrReader().probe(store.path(), {}, {});
        VERIFY_OK(contents);
        QVERIFY((contents->blocks == std::vector<std::string>{"s0", "s1"}));
        QVERIFY(contents->taken == finest->source.taken && contents->leftOut == finest->source.leftOut);
        if (!isSeries)
            return;
        const auto other = readStore(store.path(), {{"channel", std::string("GFP")}, {"time", std::int64_t(3)}});
        VERIFY_OK(other);
        QCOMPARE(distance(*other, 1, 2), 0.0);
        QVERIFY(zarrTaken(other->source.taken, TakenPart::Channel).find("2 of 2, GFP") != std::string::npos);
        QVERIFY(zarrTaken(other->source.taken, TakenPart::TimeStep).find("3 of 3, time 1 second") != std::string::npos);
        QVERIFY((contents->channels == std::vector<std::string>{"DAPI", "GFP"}));
        QVERIFY((contents->timeSteps == std::vector<double>{0, 0.5, 1}));
        QVERIFY(!readStore(store.path(), {{"channel", std::string("3")}}).ok());
        QVERIFY(!readStore(store.path(), {{"time", std::int64_t(4)}}).ok());
        QVERIFY(!readStore(store.path(), {{"part", std::string("2")}}).ok());
        QVERIFY(!readStore(store.path(), {{"spacing", std::string("1x1x1")}}).ok());
    }

    void mirroredAxes()
    {
        const ZarrStore store;
        writeImage(store, "", {.signs = {-1, 1, -1}});
        const auto dataset = readStore(store.path());
        VERIFY_OK(dataset);
        QCOMPARE(distance(*dataset), 0.0);
        QVERIFY(!dataset->lattice.isAlongAxes());
    }

    /// Units of length that differ become one.
    void mixedUnits()
    {
        const ZarrStore store;
        writeImage(store, "", {.levels = 1});
        QByteArray axes = axesText("zyx");
        axes.replace(axes.indexOf("micrometer"), 10, "nanometer");
        const QByteArray datasets =
            R"([{"path": "s0", "coordinateTransformations": [)" + transformation("scale", {1000, 2, 3}) + "]}]";
        store.write(".zattrs", R"({"multiscales": [{"axes": )" + axes + R"(, "datasets": )" + datasets + "}]}");
        const auto dataset = readStore(store.path());
        VERIFY_OK(dataset);
        QVERIFY((dataset->lattice.spacing - Eigen::Vector3d(3, 2, 1)).norm() < 1e-12 && dataset->lengthUnit == "µm");
        QVERIFY(zarrTexts(dataset->remarks).find("converted to µm") != std::string::npos);
    }

    /// The first versions name five axes nowhere, and say nothing of places.
    void withoutPlaces()
    {
        const ZarrStore store;
        writeImage(store, "", {.axes = "tczyx", .levels = 1});
        store.write(".zattrs", R"({"multiscales": [{"version": "0.1", "datasets": [{"path": "s0"}]}]})");
        const auto dataset = readStore(store.path(), {{"spacing", std::string("0.25x0.5x2")},
                                                      {"origin", std::string("10,-20,30")},
                                                      {"unit", std::string("mm")}});
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset) == 0 && dataset->lengthUnit == "mm");
        const auto contents = builtZarrReader().probe(store.path(), {}, {});
        QVERIFY(contents.ok() && contents->untold.size() == 3);
    }

    /// As bioformats2raw writes them, with labels beside one.
    void severalImages()
    {
        const ZarrStore store;
        store.write(".zattrs", R"({"bioformats2raw.layout": 3})");
        store.write(".zgroup", R"({"zarr_format": 2})");
        writeImage(store, "0", {.levels = 1});
        writeImage(store, "1", {.axes = "czyx", .levels = 1, .channels = 2});
        writeImage(store, "0/labels/cells", {.levels = 1});
        const auto first = readStore(store.path());
        VERIFY_OK(first);
        QVERIFY(zarrTaken(first->source.taken, TakenPart::Series).find("1 of 2: 0") != std::string::npos);
        QVERIFY(zarrTexts(first->source.leftOut).find("labels") != std::string::npos);
        const auto second = readStore(store.path(), {{"series", std::string("2")}, {"channel", std::string("2")}});
        VERIFY_OK(second);
        QCOMPARE(distance(*second, 1), 0.0);
        const auto labels = readStore(store.path(), {{"array", std::string("0/labels/cells")}});
        VERIFY_OK(labels);
        QCOMPARE(distance(*labels), 0.0);
    }

    void certainOfFolders()
    {
        const ZarrStore store;
        QCOMPARE(builtZarrReader().score(store.path(), {}), 0.0);
        writeImage(store, "", {.levels = 1});
        QCOMPARE(builtZarrReader().score(store.path(), {}), 1.0);
        const QByteArray text = "{\"multiscales\": 1}";
        const auto bytes = std::as_bytes(std::span(text.constData(), std::size_t(text.size())));
        QVERIFY(builtZarrReader().score(store.path(".zattrs"), bytes) > 0.8);
        QCOMPARE(builtZarrReader().score(store.path("other.json"), bytes), 0.0);
        const auto dataset = readStore(store.path(".zattrs"));
        VERIFY_OK(dataset);
        QCOMPARE(dataset->source.name, store.path().parent_path().filename().string());
    }

    /// The program gives a folder to the reader that is certain of it, and refuses others.
    void openedByTheProgram()
    {
        const ZarrStore store, other;
        writeImage(store, "cells.ome.zarr", {.levels = 1});
        other.write("plain/values.txt", "1");
        PluginHost host({.folders = {fs::path(TAN_BINARY_DIR) / "lib/tan/plugins"}});
        for (const char* opened : {"cells.ome.zarr", "cells.ome.zarr/", "cells.ome.zarr/.zattrs"}) {
            const auto dataset = openDataset(host, store.path(opened));
            VERIFY_OK(dataset);
            QCOMPARE(distance(*dataset), 0.0);
            QCOMPARE(dataset->source.name, std::string("cells.ome.zarr"));
        }
        QVERIFY(openDataset(host, store.path("cells.ome.zarr"), {.reader = "zarr"}).ok());
        const auto refused = openDataset(host, other.path("plain"));
        QVERIFY(!refused.ok() && refused.error().text().find("is a folder") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(ZarrImagesTest)
#include "zarr_images_test.moc"
