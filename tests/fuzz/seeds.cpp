// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what the fuzzers start from: small valid inputs, a folder for each fuzzer in the folder that is named.
#include "plugins/host/file_saving.h"
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/some_models.h"
#include "tests/fuzz/small_part.h"
#include "tests/plugins/plugins_of_this_build.h"
#include "tests/plugins/readers/cells/vtu_text.h"
#include "tests/plugins/readers/lattice/header_files.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/plugins/readers/plot3d/plot3d_files.h"

#include <tan/build.h>
#include <tan/packed.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <cstdio>

namespace {

using namespace tetra;

/// A folder of seeds, numbered.
class Seeds {
public:
    Seeds(const QString& folder, const char* fuzzer) : folder_(folder + "/" + fuzzer) { QDir().mkpath(folder_); }

    QString next() { return folder_ + "/seed" + QString::number(count_++); }
    void add(const QByteArray& content)
    {
        QFile file(next());
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
    }
    void add(const std::string& content) { add(QByteArray::fromStdString(content)); }
    void add(const char* content) { add(QByteArray(content)); }

private:
    QString folder_;
    int count_ = 0;
};

QList<QByteArray> volumes()
{
    const QByteArray space = "space directions: (0.5,0,0) (0,0.1,0) (0,0,3)\nspace origin: (1,2,-3)\n";
    return {nrrdHeader("spacings: 1 2 3\naxis mins: 0 0 0\n# note\nkey:=value\n") + testSamples(SampleType::UInt8),
            nrrdHeader(space + "endian: big\ntype: short\nline skip: 1\nbyte skip: 2\n") + "x\nab" +
                testSamples(SampleType::Int16, std::endian::big),
            nrrdHeader(space + "endian: little\ntype: double\nencoding: gzip\n") +
                gzipped(testSamples(SampleType::Float64)),
            nrrdHeader("type: float\nencoding: ascii\nsizes: 2 2 2\ncenters: cell cell node\n") +
                "1 2.5 -3 4e2 5 6 7 8",
            nrrdHeader("dimension: 4\nsizes: 3 1 4 5\nbyte skip: -1\nkinds: domain vector domain domain\n") +
                testSamples(SampleType::UInt8)};
}

void addAnswers(const QString& folder)
{
    Seeds seeds(folder, "http");
    const std::string head = "HTTP/1.1 206 Partial Content\r\nContent-Type: application/octet-stream\r\n"
                             "ETag: \"5f\"\r\nLast-Modified: Wed, 01 Oct 2025 10:00:00 GMT\r\n";
    seeds.add(head + "Content-Length: 16384\r\nContent-Range: bytes 0-16383/70000\r\n\r\n" + head +
              "Content-Length: 49152\r\nContent-Range: bytes 16384-65535/70000\r\n\r\n");
    seeds.add("HTTP/2 302 \r\nlocation: /log-in\r\n\r\nHTTP/2 200 \r\ncontent-type: text/html\r\n\r\n<!DOCTYPE html>");
    seeds.add("HTTP/1.1 416 x\nContent-Range: bytes */0\nContent-Encoding: gzip\n\n");
    seeds.add("https://me:secret@example.org/a.tan?key=secret#x");
}

void addVolumes(const QString& folder)
{
    Seeds nrrd(folder, "nrrd");
    for (const QByteArray& volume : volumes())
        nrrd.add(volume);
    Seeds raw(folder, "raw");
    raw.add("3x4x5|uint8|little|1x1x1|0,0,0|0\n" + testSamples(SampleType::UInt8));
    raw.add("3 4 5|int16|big|1x2x2.5|-1,0,1e3|7\n" + QByteArray(7, 'h') +
            testSamples(SampleType::Int16, std::endian::big));
    raw.add("3,4,5|double|little|0.1,0.1,0.1|0,0,0|0\n" + testSamples(SampleType::Float64));
    raw.add("|float|little|1x1x1|0,0,0|0\n" + testSamples(SampleType::Float32));
    raw.add(nrrdHeader("data file: samples.raw\n") + testSamples(SampleType::UInt8));
    raw.add(nrrdHeader("data file: samples.raw\nencoding: gzip\n") + gzipped(testSamples(SampleType::UInt8)));
}

/// A byte for the name, one for the time step, two for the length of the first file, and two files.
void addHeaders(const QString& folder)
{
    Seeds seeds(folder, "headers");
    const QByteArray samples = testSamples(SampleType::Float32);
    const auto add = [&](char name, const QByteArray& first, const QByteArray& second = {}) {
        const char length[] = {static_cast<char>(first.size() % 256), static_cast<char>(first.size() / 256)};
        seeds.add(QByteArray(1, name) + QByteArray(1, '\1') + QByteArray(length, 2) + first + second);
    };
    add('\0', metaHeader("TransformMatrix = 0 1 0 1 0 0 0 0 1\nOffset = 1 2 3\n") + samples);
    add('\0', metaHeader("CompressedData = True\n", "image.raw"), gzipped(samples));
    add('\0', metaHeader("BinaryData = False\nElementNumberOfChannels = 3\n", "LIST 3") + "image.raw\n", "1 2 3 ");
    NiftiFields nifti = niftiBySteps(Eigen::Matrix3d::Identity(), {1, 2, 3});
    nifti.qform = 1;
    add('\1', niftiHeader(nifti) + samples);
    nifti.version = 2;
    nifti.dim = {5, 3, 4, 5, 1, 2, 1, 1};
    add('\1', niftiHeader(nifti) + samples + samples);
    add('\2', niftiHeader({.version = 0, .order = std::endian::big}), samples);
    add('\3', mrcHeader({.start = {1, 2, 3}, .angles = {90, 90, 120}, .axes = {3, 2, 1}}) + samples);
    add('\3', mrcHeader({.order = std::endian::big, .mode = 0, .imodFlags = 1}) + samples);
}

void addDescribedVolumes(const QString& folder)
{
    Seeds npy(folder, "npy");
    for (const char* const header : {"{'descr': '|u1', 'fortran_order': False, 'shape': (5, 4, 3), }          \n",
                                     "{'descr': '<f2', 'fortran_order': True, 'shape': (3, 2, 5, 1), }       \n",
                                     "{'descr': '>i8', 'fortran_order': False, 'shape': (2, 2, 2), }         \n"})
        npy.add(QByteArray("\x93NUMPY\1\0", 8) + static_cast<char>(qstrlen(header)) + '\0' + header +
                QByteArray(64, '\1'));
    Seeds cube(folder, "cube");
    const QByteArray axes = "2 0.4 0 0\n2 0.1 0.5 0\n2 0 0 0.6\n";
    cube.add("a\nb\n1 -1 2 .5\n" + axes + "6 6. 0.1 0.2 0.3\n1 2.5 -3 4D-02 0.5-101\n 6 7 8\n");
    cube.add("a\nb\n-1 -1 2 .5\n" + QByteArray(axes).replace("2 0", "-2 0") +
             "6 6. 0 0 0\n2 21 22\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n");
    cube.add("a\nb\n0 0 0 0 2\n" + axes + "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n");
    Seeds dx(folder, "dx");
    const QByteArray grid = "# dx\nobject 1 class gridpositions counts 2 2 2\norigin 0 0 0\ndelta 1 0 0\ndelta 0 1 0\n"
                            "delta 0 0 1\nobject 2 class gridconnections counts 2 2 2\n";
    const QByteArray field = "attribute \"dep\" string \"positions\"\nobject \"a\" class field\n"
                             "component \"positions\" value 1\ncomponent \"data\" value 3\n";
    dx.add(grid + "object 3 class array type double rank 0 items 8 data follows\n1 2 3 4 5 6 7 8\n" + field);
    dx.add(grid + "object 3 class array type short rank 1 shape 2 items 8 msb ieee data follows\n" +
           QByteArray(32, '\1') + field);
    dx.add("data mode lsb binary\n" + grid + "object 3 class array type ubyte items 1 data 2\n" + field +
           "end\n12345678");
    dx.add(grid + "object 3 class array type byte items 8 binary data file \"volume.dx\",4\n" + field +
           "object 4 class field component \"positions\" 1 component \"data\" 3\n");
    Seeds bov(folder, "bov");
    const QByteArray brick = "TIME: 0\nDATA_SIZE: 2 2 2\nVARIABLE: v\nDATA_ENDIAN: BIG\nBRICK_ORIGIN: 0 1 2\n"
                             "BRICK_SIZE: 1 2 3\n";
    bov.add(brick + "DATA_FILE: volume.values\nDATA_FORMAT: SHORT\nCENTERING: zonal\nBYTE_OFFSET: 1\n\n" +
            QByteArray(17, '\1'));
    bov.add(brick + "DATA_FILE: volume.values.gz\nDATA_FORMAT: BYTE\nDATA_COMPONENTS: 2\nVARIABLE_MIN: -1\n\n" +
            gzipped(QByteArray(16, '\1')));
}

/// A byte for the kind, and the text.
void addPictureTexts(const QString& folder)
{
    Seeds seeds(folder, "picture-texts");
    for (const char kind : {'\0', '\2'})
        seeds.add(kind +
                  QByteArray("ImageJ=1.54f\nimages=30\nchannels=2\nslices=5\nframes=3\nhyperstack=true\nunit=\\u00B5m\n"
                             "spacing=-2.5\nfinterval=0.5\ncf=0\nc0=-32768.0\nc1=1.0\nvunit=gray value\n"));
    const QByteArray pixels =
        "<OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"><Image ID=\"Image:0\" "
        "Name=\"one\"><Pixels ID=\"Pixels:0\" DimensionOrder=\"XYCZT\" Type=\"uint16\" SizeX=\"4\" "
        "SizeY=\"3\" SizeZ=\"5\" SizeC=\"2\" SizeT=\"1\" PhysicalSizeX=\"0.5\" "
        "PhysicalSizeZ=\"2\" PhysicalSizeZUnit=\"nm\"><Channel ID=\"Channel:0:0\" Name=\"DAPI\" "
        "SamplesPerPixel=\"1\"/><Channel ID=\"Channel:0:1\"/>";
    const QByteArray end = "</Pixels></Image></OME>";
    seeds.add('\1' + pixels + "<TiffData/>" + end);
    seeds.add('\1' + pixels +
              "<TiffData FirstC=\"1\" FirstZ=\"2\" IFD=\"3\" PlaneCount=\"1\"><UUID "
              "FileName=\"b.tif\">urn</UUID></TiffData>" +
              end);
    seeds.add('\x41' + QByteArray(pixels + end).replace("</OME>", "<Image><Pixels SizeZ=\"2\"/></Image></OME>"));
}

/// A dimension of records and another one, an attribute, and a variable of both.
void addNetCdfHeaders(const QString& folder)
{
    Seeds seeds(folder, "netcdf-header");
    for (const char version : {'\1', '\2', '\5'}) {
        const auto number = [](qint64 value, int bytes) {
            QByteArray text;
            for (int byte = bytes - 1; byte >= 0; --byte)
                text += static_cast<char>(value >> 8 * byte & 0xff);
            return text;
        };
        const auto count = [&](qint64 value) { return number(value, version == '\5' ? 8 : 4); };
        const auto name = [&](const char* letter) { return count(1) + QByteArray(letter).leftJustified(4, '\0'); };
        constexpr int dimensions = 10, variables = 11, attributes = 12, characters = 2, singles = 5;
        QByteArray head = QByteArray("CDF") + version + count(2) + number(dimensions, 4) + count(2) + name("t") +
                          count(0) + name("x") + count(3);
        head +=
            number(attributes, 4) + count(1) + name("u") + number(characters, 4) + count(2) + QByteArray("mm\0\0", 4);
        head += number(variables, 4) + count(1) + name("v") + count(2) + count(0) + count(1) + number(0, 4) + count(0) +
                number(singles, 4) + count(12);
        head += number(head.size() + (version == '\1' ? 4 : 8), version == '\1' ? 4 : 8);
        seeds.add(head + QByteArray(24, '\1'));
    }
}

/// Two bytes for the room, and a block: bytes as they are, a repetition, one that reaches into itself.
void addLzf(const QString& folder)
{
    Seeds seeds(folder, "lzf");
    seeds.add(QByteArray("\x28\0\4hello\x20\4\xe0\5\4", 13));
    seeds.add(QByteArray("\x2c\1\0a\xe0\xff\0", 7));
}

/// A byte for what the metadata are of, two for their length, the metadata, and a chunk.
void addZarr(const QString& folder)
{
    Seeds seeds(folder, "zarr");
    const auto add = [&](char kind, const QByteArray& metadata, const QByteArray& chunk) {
        const char length[] = {static_cast<char>(metadata.size() % 256), static_cast<char>(metadata.size() / 256)};
        seeds.add(QByteArray(1, kind) + QByteArray(length, 2) + metadata + chunk);
    };
    const QByteArray bytes(48, '\1');
    const auto array2 = [](const QByteArray& type, const QByteArray& more) {
        return "{\"zarr_format\": 2, \"shape\": [2, 3, 4], \"chunks\": [2, 3, 4], \"dtype\": \"" + type + "\", " +
               more + "}";
    };
    const QByteArray whole = "\"order\": \"C\", \"fill_value\": 0, ";
    add('\0', array2("<u2", whole + "\"compressor\": null, \"filters\": null"), bytes);
    add('\0', array2(">i8", "\"order\": \"F\", \"fill_value\": \"NaN\", \"compressor\": {\"id\": \"gzip\"}"),
        gzipped(QByteArray(192, '\1')));
    add('\0',
        array2("<u2",
               whole +
                   "\"compressor\": null, \"filters\": [{\"id\": \"shuffle\", \"elementsize\": 2}, {\"id\": \"delta\", "
                   "\"dtype\": \"<u2\"}]"),
        bytes);
    const auto array3 = [](const QByteArray& codecs) {
        return "{\"zarr_format\": 3, \"node_type\": \"array\", \"shape\": [2, 3, 4], \"data_type\": \"uint16\", "
               "\"fill_value\": 0, "
               "\"chunk_grid\": {\"name\": \"regular\", \"configuration\": {\"chunk_shape\": [2, 3, 4]}}, \"codecs\": "
               "[" +
               codecs + "], \"dimension_names\": [\"z\", \"y\", \"x\"]}";
    };
    const QByteArray little = "{\"name\": \"bytes\", \"configuration\": {\"endian\": \"little\"}}";
    add('\1', array3(little + ", {\"name\": \"gzip\"}"), gzipped(bytes));
    add('\1',
        array3("{\"name\": \"sharding_indexed\", \"configuration\": {\"chunk_shape\": [2, 3, 4], \"codecs\": [" +
               little + "], \"index_codecs\": [" + little + "], \"index_location\": \"start\"}}"),
        QByteArray("\x10\0\0\0\0\0\0\0\x30\0\0\0\0\0\0\0", 16) + bytes);
    const QByteArray image =
        "\"multiscales\": [{\"axes\": [{\"name\": \"z\", \"type\": \"space\", \"unit\": \"micrometer\"}, "
        "{\"name\": \"y\", \"type\": \"space\", \"unit\": \"nanometer\"}, {\"name\": \"x\"}], \"datasets\": "
        "[{\"path\": \"0\", \"coordinateTransformations\": [{\"type\": \"scale\", \"scale\": [2, -1, .5]}, "
        "{\"type\": \"translation\", \"translation\": [1, 2, 3]}]}]}], \"omero\": {\"channels\": [{\"label\": "
        "\"DAPI\"}]}";
    add('\2', "{" + image + "}", bytes.first(24));
    add('\3', "{\"zarr_format\": 3, \"node_type\": \"group\", \"attributes\": {\"ome\": {" + image + "}}}",
        bytes.first(24));
}

void addGrids(const QString& folder)
{
    Seeds seeds(folder, "plot3d");
    for (const Plot3dStyle& style :
         {Plot3dStyle{}, Plot3dStyle{.order = std::endian::big, .marks = true}, Plot3dStyle{.doubles = true},
          Plot3dStyle{.marks = true, .multiGrid = true, .iblank = true, .grids = 2}}) {
        const QByteArray grid = testFile(style, false);
        const char length[] = {static_cast<char>(grid.size() % 256), static_cast<char>(grid.size() / 256)};
        for (const char name : {'\0', '\6', '\xff'})
            seeds.add(QByteArray(1, name) + QByteArray(1, style.grids > 1 ? '\2' : '\0') + QByteArray(length, 2) +
                      grid + testFile(style, true));
        const QByteArray text = testText(style, false);
        const char textLength[] = {static_cast<char>(text.size() % 256), static_cast<char>(text.size() / 256)};
        seeds.add(QByteArray(1, '\xff') + QByteArray(1, style.grids > 1 ? '\2' : '\0') + QByteArray(textLength, 2) +
                  text + testText(style, true));
    }
}

void addPoints(const QString& folder)
{
    Seeds seeds(folder, "points");
    const QByteArray numbers = "0,0,0,1\n1,0,0,2\n0,1,0,-3e1\n0,0,1,.5\n1,1,1,7\n";
    seeds.add("automatic|automatic|\nx,y,z,value\n" + numbers);
    seeds.add("automatic|automatic|+\n# measured\r\n\"x\";y;z;\"a; b\"\r\n" + QByteArray(numbers).replace(',', ';') +
              "2;;2;2\r\n");
    seeds.add("b,c,d|a|\na\tb\tc\td\te\n1\t0\t0\t0\tx\n2\t1\t0\t0\ty\n3\t0\t1\t0\tz\n4\t0\t0\t1\t\n");
    seeds.add("1,2,3|4|\n" + QByteArray(numbers).replace(',', ' '));
    seeds.add("automatic|automatic|\n3\nwater\nO 0 0 0\nH 1 0 0\nH 0 1 0\n");
}

void addModels(const QString& folder)
{
    Seeds seeds(folder, "model");
    writeModel(seeds.next().toStdString(), bumps(SampleType::UInt8, {3, 3, 3}));
    writeModel(seeds.next().toStdString(), bumps(SampleType::Float32, {4, 3, 2}));
    writeModel(seeds.next().toStdString(), bentBumps(SampleType::Float32, {3, 3, 3}));
    writeModel(seeds.next().toStdString(), bentBumps(SampleType::Int16, {3, 2, 3}, true, true));
    scatteredModel(seeds.next().toStdString(), 20, 5);
    const Dataset part = smallPart();
    modelOf(seeds.next().toStdString(), part, decimated(part));
}

void addPacked(const QString& folder)
{
    Seeds seeds(folder, "packed");
    const QTemporaryDir models;
    const auto addPackedOf = [&](const std::filesystem::path& path) {
        const auto model = Model::open(path);
        if (!model || !packModel(**model, seeds.next().toStdString()).ok())
            qFatal("a seed cannot be packed");
    };
    const std::filesystem::path path = models.filePath("model.tan").toStdString();
    for (const Dataset& dataset : {bumps(SampleType::UInt8, {3, 3, 3}), bumps(SampleType::Float32, {4, 3, 2})}) {
        if (!buildModel(dataset, path).ok())
            qFatal("a seed cannot be built");
        addPackedOf(path);
    }
    scatteredModel(path.string(), 20, 5);
    addPackedOf(path);
}

void addCells(const QString& folder)
{
    Seeds seeds(folder, "cells");
    seeds.add(VtuText().text());
    const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const Dataset two = datasetOfTetrahedra(corners, {1, 2, 3, 4, 5}, {{0, 1, 2, 3}, {1, 2, 3, 4}});
    if (const auto written = saveDataset(pluginsOfThisBuild(), two, (seeds.next() + ".vtu").toStdString()); !written)
        qFatal("%s", written.error().text().c_str());
    seeds.add(std::string("# cells\n9 3 1 1 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
                          "9 .5 .5 2\n1 0 hex 1 2 3 4 5 6 7 8\n2 0 pyr 5 6 7 8 9\n3 0 tet 1 2 3 9\n1 1\nheat, K\n"
                          "1 1\n2 2\n3 3\n4 4\n5 5\n6 6\n7 7\n8 8\n9 9\n1 1\nstress, Pa\n1 .1\n2 .2\n3 .3\n"));
}

void addTexts(const QString& folder)
{
    Seeds transfer(folder, "transfer");
    transfer.add(transferFunctionToText({.colours = {{1, {0, 0.5f, 0}}, {1, {1, 1, 1}}, {2.5, {1, 0, 0}}},
                                         .opacities = {{1, 0}, {1, 1}, {2.5, 0.25f}},
                                         .unitDistance = 3}));
    transfer.add(transferFunctionToText({}));

    Seeds fields(folder, "error-field");
    for (const char* text :
         {"4", "box(1,2,3, 4,5,6; 1, 8, 2.5)", "sphere(8,8,8, 3; 0.5, 8)", "halfspace(1,2,-3, 4; inf, 2, 1)",
          "camera(1,2,3; 1, 9, 100)", "values(10:1, 20:0.5)", "isovalues(120, 140; 0.5, 8, 20)",
          "opacity(0:0, 100:1; 1, 10)", "min(max(1, box(0,0,0,1,1,1;1,2)), sum(3, product(2, values(1:2, 1:3))))"})
        fields.add(std::string(text));

    Seeds weights(folder, "weights");
    weights.add(std::string("point:8,8,8,6"));
    weights.add(std::string("box:0,0,0,1,2,3,0,0.5; value:100,20 ; point:-1,2e3,.5,1,1e-6"));

    Seeds view(folder, "view");
    view.add(cameraToText(Camera()));
    view.add(std::string("{\"azimuth\": 30, \"perspective\": false, \"target\": [1, 2, 3]}"));
    view.add(std::string("1,0,0,3.5; 0,-1,2e3,-4"));
}

} // namespace

int main(int count, char** words)
{
    if (count != 2) {
        std::fputs("tan-fuzz-seeds FOLDER: writes seeds for the fuzzers\n", stderr);
        return 2;
    }
    const QString folder = QString::fromLocal8Bit(words[1]);
    addAnswers(folder);
    addVolumes(folder);
    addHeaders(folder);
    addDescribedVolumes(folder);
    addPictureTexts(folder);
    addNetCdfHeaders(folder);
    addLzf(folder);
    addZarr(folder);
    addGrids(folder);
    addPoints(folder);
    addModels(folder);
    addPacked(folder);
    addCells(folder);
    addTexts(folder);
    return 0;
}
