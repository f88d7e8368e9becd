// SPDX-License-Identifier: GPL-3.0-or-later
/// Surfaces in files: what VTK reads back is what was written, to the bit; and files that cannot be written.
#include "core/mesh/boundary.h"
#include "plugins/host/file_saving.h"
#include "tests/core/base/small_disk.h"
#include "tests/lacks.h"
#include "tests/plugins/plugins_of_this_build.h"
#include "tests/plugins/writers/random_surfaces.h"
#include "tests/plugins/writers/vtk_reader.h"

#include <tan/base.h>

#include <QDir>
#include <QJsonArray>
#include <QTest>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <map>

using namespace tetra;

namespace {

Status writeSurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress = {})
{
    const auto saved = saveSurface(pluginsOfThisBuild(), content, path, {}, progress);
    return saved ? Status() : Status(saved.error());
}

const QStringList endings = {"vtp", "vtk", "vtu", "ply", "stl", "obj", "glb"};

/// All parts as one list of what a reader should find.
struct Expected {
    explicit Expected(const SurfaceContent& content)
    {
        for (const SurfacePart& part : content.parts) {
            const auto first = static_cast<std::uint32_t>(positions.size());
            for (const Eigen::Vector3d& position : part.positions)
                positions.emplace_back(position.cast<float>());
            normals.insert(normals.end(), part.normals.begin(), part.normals.end());
            const auto* each = std::get_if<std::span<const float>>(&part.values);
            for (std::size_t i = 0; i < part.positions.size(); ++i)
                values.push_back(each != nullptr ? (*each)[i] : std::get<float>(part.values));
            for (const auto& triangle : part.triangles)
                for (const std::uint32_t corner : triangle)
                    corners.push_back(first + corner);
        }
    }
    std::vector<Eigen::Vector3f> positions, normals;
    std::vector<float> values;
    std::vector<std::uint32_t> corners;
};

std::vector<Eigen::Vector3f> vectorsOf(const std::vector<float>& numbers)
{
    std::vector<Eigen::Vector3f> vectors;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
        vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return vectors;
}

/// What glTF's y up makes of a vector.
std::vector<Eigen::Vector3f> turned(std::vector<Eigen::Vector3f> vectors)
{
    for (Eigen::Vector3f& v : vectors)
        v = {v[0], v[2], -v[1]};
    return vectors;
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

template <class T> T numberAt(const QByteArray& bytes, qsizetype offset)
{
    T number{};
    if (offset + qsizetype(sizeof number) <= bytes.size())
        std::memcpy(static_cast<void*>(&number), bytes.constData() + offset, sizeof number);
    return number;
}

} // namespace

class SurfaceFileTest : public QObject {
    Q_OBJECT

private slots:
    void vtkReadsWhatWasWritten_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("vertices");
        QTest::addColumn<bool>("valued");
        for (const QString& ending : endings)
            for (const int vertices : {3, 200, 20'000})
                for (const bool valued : {false, true})
                    QTest::addRow("%s, %d%s", qPrintable(ending), vertices, valued ? ", valued" : "")
                        << ending << vertices << valued;
    }
    void vtkReadsWhatWasWritten()
    {
        QFETCH(QString, ending);
        QFETCH(int, vertices);
        QFETCH(bool, valued);
        const auto count = static_cast<std::size_t>(vertices);
        const RandomSurface one(count, 2 * count, 1), other(count + 7, count / 3, 2);
        SurfaceContent content = contentOf(one.part("isovalue 1.5", valued), other.part("isovalue 2", valued));
        const QString path = folder_.filePath("surface." + ending);
        const Status written = writeSurface(path.toStdString(), content);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        const VtkReader read(path);
        if (read.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(read.ok(), read.messages());
        compare(read, Expected(content), ending, valued);
    }

    /// Coordinates that no float holds: formats that have doubles keep every bit of them, the others a number that is
    /// told and what is left, in floats.
    void doublesAreKept_data()
    {
        QTest::addColumn<QString>("ending");
        for (const QString& ending : endings)
            QTest::newRow(qPrintable(ending)) << ending;
    }
    void doublesAreKept()
    {
        QFETCH(QString, ending);
        RandomSurface far(300, 500, 1);
        for (Eigen::Vector3d& position : far.positions)
            position =
                position.cwiseProduct(Eigen::Vector3d(1e-5, 1e-5, 300)) + Eigen::Vector3d(339385.3, 4264212.7, 1e9 / 3);
        const QString path = folder_.filePath("far." + ending);
        const Status written = writeSurface(path.toStdString(), contentOf(far.part("far"), far.part("again")));
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        const QByteArray bytes = bytesOf(path);
        Eigen::Vector3d shift(0, 0, 0);
        const double step =
            ending == "stl" || ending == "glb" ? 1e-7 : 0; // of doubles at 3e8, and more than of floats up to 0.2
        if (ending == "stl") {
            QVERIFY2(bytes.startsWith("add "), bytes.first(80).constData());
            const QList<QByteArray> words = bytes.first(80).mid(4).split(' ');
            for (int axis = 0; axis < 3; ++axis)
                shift[axis] = QString(words[axis]).remove(',').toDouble();
            QCOMPARE(numberAt<std::uint32_t>(bytes, 80), 1000U);
            for (std::size_t triangle = 0; triangle < 500; ++triangle)
                for (std::size_t corner = 0; corner < 3; ++corner)
                    for (int axis = 0; axis < 3; ++axis) {
                        const double read =
                            shift[axis] +
                            double(numberAt<float>(bytes, qsizetype(84 + 50 * triangle + 12 + 12 * corner) + 4 * axis));
                        QVERIFY(std::abs(read - far.positions[far.triangles[triangle][corner]][axis]) <= step);
                    }
            return;
        }
        const VtkReader read(path);
        if (read.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(read.ok(), read.messages());
        if (ending == "obj" || ending == "glb" || ending == "ply") // VTK reads these in floats
            QVERIFY(compareFar(bytes, ending, far.positions, step));
        else
            for (std::size_t i = 0; i < 3 * far.positions.size(); ++i)
                QCOMPARE(read.places()[i], far.positions[i / 3][int(i % 3)]);
    }

    /// Two vertices that are one float make no triangle without area; nothing else is left out, and it is told.
    void roundingMakesNoTriangleFlat_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("times");
        for (const char* ending : {"stl", "glb"})
            for (const int times : {0, 1, 2})
                QTest::addRow("%s, %d", ending, times) << QString(ending) << times;
    }
    void roundingMakesNoTriangleFlat()
    {
        QFETCH(QString, ending);
        QFETCH(int, times);
        RandomSurface one(6, 0, 1), flat(3, 0, 1);
        one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + 1e-12, 0, 0}, {1, 1, 0}, {0, 0, 0}};
        one.triangles = {{0, 1, 2}, {3, 4, 2}, {0, 5, 1}}; // the last one has no area in doubles either
        one.triangles.insert(one.triangles.begin() + 1, std::size_t(times), {1, 3, 2});
        flat.positions = {{0, 0, 0}, {1, 0, 0}, {1 + 1e-12, 0, 0}};
        if (times > 0) // nothing is left of a part
            flat.triangles.assign(std::size_t(times), {0, 1, 2});
        const SurfaceContent content = contentOf(one.part("thin"), flat.part("flat"));
        const QString path = folder_.filePath("thin." + ending);
        const auto saved = saveSurface(pluginsOfThisBuild(), content, std::filesystem::path(path.toStdString()));
        QVERIFY(saved);
        std::vector<std::string> remarks;
        for (const Message& remark : *saved)
            remarks.push_back(remark.text());
        if (times == 0)
            QVERIFY(remarks.empty());
        else
            QCOMPARE(remarks,
                     std::vector{"In '" + path.toStdString() + "' " + std::to_string(2 * times) +
                                 " triangles are left out, because two corners of each coincide in single precision."});
        QCOMPARE(leftOutInFloats(1, "a.stl").text(),
                 std::string(
                     "In 'a.stl' one triangle is left out, because two of its corners coincide in single precision."));
        const QByteArray bytes = bytesOf(path);
        if (ending == "stl") {
            QCOMPARE(numberAt<std::uint32_t>(bytes, 80), 3U);
            QCOMPARE(bytes.size(), 84 + 3 * 50);
            return;
        }
        const QJsonObject json = QJsonDocument::fromJson(bytes.mid(20, numberAt<std::uint32_t>(bytes, 12))).object();
        QCOMPARE(json["meshes"].toArray().size(), 1);
        QCOMPARE(json["accessors"].toArray().last().toObject()["count"].toInt(), 9);
        const std::vector<std::uint32_t> corners = {0, 1, 2, 3, 4, 2, 0, 5, 1};
        QCOMPARE(bytes.last(36), QByteArray(reinterpret_cast<const char*>(corners.data()), 36));
    }

    /// What floats cannot hold is refused, not written as infinity or zero.
    void coordinatesBeyondFloatsAreRefused()
    {
        for (const double scale : {1e40, 1e-41})
            for (const char* ending : {"stl", "glb", "vtp"}) {
                RandomSurface one(30, 40, 1);
                for (Eigen::Vector3d& position : one.positions)
                    position *= scale;
                const Status written = writeSurface(folder_.filePath(QString("beyond.") + ending).toStdString(),
                                                    contentOf(one.part("one"), SurfacePart{}));
                QCOMPARE(written.ok(), QString(ending) == "vtp");
                if (!written)
                    QVERIFY2(written.error().text().find(".vtp") != std::string::npos, written.error().text().c_str());
            }
    }

    /// Parts that are empty, and nothing but those.
    void nothingIsASurface_data()
    {
        QTest::addColumn<QString>("ending");
        for (const QString& ending : endings)
            QTest::newRow(qPrintable(ending)) << ending;
    }
    void nothingIsASurface()
    {
        QFETCH(QString, ending);
        const RandomSurface none(3, 0, 1), some(3, 1, 2);
        const SurfacePart empty{.name = "empty", .positions = {}, .normals = {}, .triangles = {}};
        for (const bool only : {true, false}) {
            const SurfaceContent content = contentOf(empty, only ? empty : some.part("some"));
            const QString path = folder_.filePath("empty." + ending);
            QVERIFY(writeSurface(path.toStdString(), content));
            const VtkReader read(path);
            if (read.isMissing())
                QSKIP_WITHOUT("python3-vtk9");
            QCOMPARE(read.told()["cells"].toInt(-1), only ? 0 : 1);
        }
    }

    void glbIsAsTheStandardSays()
    {
        const RandomSurface one(50, 100, 1), other(20, 30, 2);
        SurfaceContent content = contentOf(one.part("isovalue \"1\""), other.part("isovalue 2"));
        content.parts[1].colour = {0.5F, 0, 1, 0.25F};
        const QString path = folder_.filePath("surface.glb");
        QVERIFY(writeSurface(path.toStdString(), content));
        const QByteArray bytes = bytesOf(path);
        QCOMPARE(bytes.first(4), QByteArray("glTF"));
        QCOMPARE(numberAt<std::uint32_t>(bytes, 4), 2U);
        QCOMPARE(numberAt<std::uint32_t>(bytes, 8), static_cast<std::uint32_t>(bytes.size()));
        const qsizetype jsonBytes = numberAt<std::uint32_t>(bytes, 12);
        QCOMPARE(jsonBytes % 4, 0);
        QCOMPARE(bytes.mid(16, 4), QByteArray("JSON"));
        const QJsonObject json = QJsonDocument::fromJson(bytes.mid(20, jsonBytes)).object();
        QCOMPARE(json["asset"].toObject()["version"].toString(), QString("2.0"));
        const qsizetype binary = 20 + jsonBytes + 8;
        QCOMPARE(bytes.mid(binary - 4, 4), QByteArray("BIN\0", 4));
        const qint64 bufferBytes = json["buffers"].toArray()[0].toObject()["byteLength"].toInteger();
        QCOMPARE(numberAt<std::uint32_t>(bytes, binary - 8), static_cast<std::uint32_t>(bufferBytes));
        QCOMPARE(bytes.size(), binary + bufferBytes);
        const QJsonArray meshes = json["meshes"].toArray();
        QCOMPARE(meshes.size(), 2);
        QCOMPARE(meshes[0].toObject()["name"].toString(), QString("isovalue \"1\""));
        QCOMPARE(meshes[0].toObject()["extras"].toObject()["isovalue"].toDouble(), 1.5);
        QCOMPARE(json["scenes"].toArray()[0].toObject()["extras"].toObject()["error"].toDouble(), 0.5);
        for (const bool second : {false, true}) {
            const RandomSurface& surface = second ? other : one;
            const QJsonObject primitive = meshes[second].toObject()["primitives"].toArray()[0].toObject();
            const auto accessor = [&](const QJsonValue& number) {
                return json["accessors"].toArray()[number.toInt(-1)].toObject();
            };
            const auto offset = [&](const QJsonObject& of) {
                return binary +
                       json["bufferViews"].toArray()[of["bufferView"].toInt(-1)].toObject()["byteOffset"].toInteger(-1);
            };
            const QJsonObject positions = accessor(primitive["attributes"].toObject()["POSITION"]);
            QCOMPARE(positions["count"].toInteger(), static_cast<qint64>(surface.positions.size()));
            const QJsonObject indices = accessor(primitive["indices"]);
            QCOMPARE(indices["count"].toInteger(), static_cast<qint64>(3 * surface.triangles.size()));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                auto least = float(surface.positions[0][long(axis)]), most = least;
                for (std::size_t vertex = 0; vertex < surface.positions.size(); ++vertex) {
                    const auto number = numberAt<float>(bytes, offset(positions) + qsizetype(12 * vertex + 4 * axis));
                    QCOMPARE(number, float(surface.positions[vertex][long(axis)]));
                    least = std::min(least, number);
                    most = std::max(most, number);
                }
                QCOMPARE(static_cast<float>(positions["min"].toArray()[qsizetype(axis)].toDouble()), least);
                QCOMPARE(static_cast<float>(positions["max"].toArray()[qsizetype(axis)].toDouble()), most);
            }
            QCOMPARE(numberAt<std::uint32_t>(bytes, offset(indices) + 8), surface.triangles[0][2]);
        }
        const QJsonObject material = json["materials"].toArray()[1].toObject();
        QCOMPARE(material["alphaMode"].toString(), QString("BLEND"));
        const QJsonArray colour = material["pbrMetallicRoughness"].toObject()["baseColorFactor"].toArray();
        QVERIFY(std::abs(colour[0].toDouble() - 0.21404) < 1e-4); // sRGB 0.5 as linear light
        QCOMPARE(colour[3].toDouble(), 0.25);
    }

    /// An isovalue beyond floats, a fact without bound and a colour that is none: JSON has no infinity, nor can VTK
    /// read one from text.
    void infinityBreaksNoFile()
    {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const RandomSurface one(5, 4, 1);
        SurfaceContent content = contentOf(one.part("isovalue 1e+39"), one.part("isovalue 2"));
        content.parts[0].values = infinity;
        content.parts[1].colour = {infinity, std::numeric_limits<float>::quiet_NaN(), 0, 1};
        content.facts.emplace_back("scale", static_cast<double>(infinity));
        const QString glb = folder_.filePath("infinite.glb"), vtp = folder_.filePath("infinite.vtp");
        QVERIFY(writeSurface(glb.toStdString(), content) && writeSurface(vtp.toStdString(), content));
        const QByteArray bytes = bytesOf(glb);
        const QJsonObject json =
            QJsonDocument::fromJson(bytes.mid(20, numberAt<std::uint32_t>(bytes, 12))).object(); // empty if it is none
        const QJsonArray meshes = json["meshes"].toArray();
        QCOMPARE(meshes.size(), 2);
        QVERIFY(!meshes[0].toObject().contains("extras"));
        QCOMPARE(meshes[1].toObject()["extras"].toObject()["isovalue"].toDouble(), 2.0);
        QCOMPARE(json["scenes"].toArray()[0].toObject()["extras"].toObject()["scale"].toString(), QString("inf"));
        QCOMPARE(
            json["materials"].toArray()[1].toObject()["pbrMetallicRoughness"].toObject()["baseColorFactor"].toArray(),
            QJsonArray({1, 0, 0, 1}));
        const VtkReader read(vtp);
        if (read.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(read.ok(), read.messages());
        QVERIFY(bytesOf(vtp).contains("<!-- scale: inf -->"));
        QCOMPARE(read.told()["facts"].toObject().keys(), QStringList{"error"});
        QCOMPARE(read.array<float>("point.isovalue").front(), infinity);
    }

    /// One part has colours of its vertices, the other one colour: where the file has no parts, all vertices have some.
    void coloursAreThoseOfTheVertices_data()
    {
        QTest::addColumn<QString>("ending");
        for (const QString& ending : endings)
            if (ending != "stl")
                QTest::newRow(qPrintable(ending)) << ending;
    }
    void coloursAreThoseOfTheVertices()
    {
        QFETCH(QString, ending);
        const RandomSurface one(500, 900, 1), other(20, 30, 2);
        SurfaceContent content = contentOf(one.part("slice", true), other.part("plain", true));
        content.parts[0].colours = one.colours;
        content.parts[0].colour = {0, 0, 0, 1};
        content.parts[1].colour = {0.5F, 0, 1, 1};
        const QString path = folder_.filePath("coloured." + ending);
        QVERIFY(writeSurface(path.toStdString(), content));
        const QByteArray bytes = bytesOf(path);
        if (ending == "glb") {
            compareGlbColours(bytes, one);
        } else if (ending == "obj") {
            compareObjColours(bytes, one, other.positions.size());
        } else if (ending == "ply") {
            QVERIFY(bytes.contains("property uchar red\nproperty uchar green\nproperty uchar blue\n"));
            const qsizetype body = bytes.indexOf("end_header\n") + 11;
            constexpr qsizetype vertexBytes = 4 * sizeof(float) + 3;
            std::vector<std::uint8_t> read;
            for (std::size_t vertex = 0; vertex < 520; ++vertex)
                for (qsizetype channel = 0; channel < 3; ++channel)
                    read.push_back(
                        numberAt<std::uint8_t>(bytes, body + qsizetype(vertex) * vertexBytes + 16 + channel));
            QCOMPARE(read, expectedBytes(content));
        } else {
            const VtkReader read(path);
            if (read.isMissing())
                QSKIP_WITHOUT("python3-vtk9");
            QVERIFY2(read.ok(), read.messages());
            QCOMPARE(read.array<std::uint8_t>("point.colour"), expectedBytes(content));
            QCOMPARE(read.told()["active point"].toString(), QString("isovalue"));
            QCOMPARE(read.array<float>("point.isovalue").size(), std::size_t(520));
        }
    }

    /// meshio reads no file with something behind the list of a face; what is left out is told.
    void plyLeavesOutValuesOfTriangles()
    {
        const RandomSurface one(5, 4, 1), other(5, 3, 2);
        SurfaceContent content = contentOf(one.part("a", true), other.part("b", true));
        const std::vector<std::uint16_t> kinds(7);
        const std::vector<float> births(7);
        content.cellArrays = {{"kind", std::span(kinds)}, {"birth_error", std::span(births)}};
        const std::string path = folder_.filePath("kinds.ply").toStdString();
        const auto saved = saveSurface(pluginsOfThisBuild(), content, std::filesystem::path(path));
        QVERIFY(saved);
        QCOMPARE(saved->size(), std::size_t(1));
        QCOMPARE(saved->front().text(),
                 "'" + path +
                     "' does not contain the triangles' values (kind, birth_error), because many programs cannot read "
                     "a PLY file with such values. To keep them, write a .vtp file.");
        const QByteArray bytes = bytesOf(QString::fromStdString(path));
        const QByteArray end = "element face 7\nproperty list uchar int vertex_indices\nend_header\n";
        QVERIFY(bytes.contains(end));
        constexpr qsizetype vertexBytes = 4 * sizeof(float), faceBytes = 1 + 3 * sizeof(std::int32_t);
        QCOMPARE(bytes.size() - bytes.indexOf(end) - end.size(), 10 * vertexBytes + 7 * faceBytes);
    }

    /// What the dataset calls its values is the name of their array, as far as the format and its readers bear it.
    void valuesHaveTheirOwnName_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("ply");
        QTest::addColumn<QByteArray>("glb");
        QTest::newRow("plain") << QByteArray("density") << QByteArray("density") << QByteArray("_DENSITY");
        QTest::newRow("unit") << QByteArray("p (N/m²)") << QByteArray("p_(N/m__)") << QByteArray("_P__N_M___");
        QTest::newRow("a coordinate") << QByteArray("x") << QByteArray("value_x") << QByteArray("_X");
        QTest::newRow("a colour") << QByteArray("red") << QByteArray("value_red") << QByteArray("_RED");
        for (const char* taken : {"r", "a", "opacity", "tx", "texture_v", "diffuse_green", "specular_alpha"})
            QTest::newRow(taken) << QByteArray(taken) << "value_" + QByteArray(taken)
                                 << "_" + QByteArray(taken).toUpper();
        QTest::newRow("a texture once it is a word")
            << QByteArray("texture u") << QByteArray("value_texture_u") << QByteArray("_TEXTURE_U");
        QTest::newRow("only begins like a colour")
            << QByteArray("diffuse_flux") << QByteArray("diffuse_flux") << QByteArray("_DIFFUSE_FLUX");
    }
    void valuesHaveTheirOwnName()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, ply);
        QFETCH(QByteArray, glb);
        const RandomSurface one(5, 4, 1);
        SurfaceContent content = contentOf(one.part("a", true), one.part("b", true));
        content.valueName = valueArrayName(name.toStdString());
        const auto written = [&](const QString& file) {
            const QString path = folder_.filePath(file);
            return writeSurface(path.toStdString(), content) ? bytesOf(path) : QByteArray();
        };
        QVERIFY(written("named.ply").contains("property float " + ply + "\n"));
        QVERIFY(written("named.glb").contains('"' + glb + "\":"));
        QVERIFY(written("named.vtp").contains("Scalars=\"" + name + "\""));
        QVERIFY(written("named.vtk").contains("SCALARS " + name.toPercentEncoding("()/") + " float 1\n"));
        QCOMPARE(valueArrayName(""), std::string("value"));
        QCOMPARE(valueArrayName("site"), std::string("value_site"));
    }

    /// In four digits, rounded up, and whole or not at all: behind a shift there is less room.
    void stlTellsTheDeviation_data()
    {
        QTest::addColumn<double>("deviation");
        QTest::addColumn<double>("place");
        QTest::addColumn<QByteArray>("head");
        QTest::newRow("few digits") << 0.0625 << 0.0 << QByteArray("binary STL, deviation 0.0625, isosurfaces by TAn ");
        QTest::newRow("none") << 0.0 << 0.0 << QByteArray("binary STL, deviation 0, isosurfaces by TAn ");
        QTest::newRow("many digits") << 0.123412345678912345 << 0.0
                                     << QByteArray("binary STL, deviation 0.1235, isosurfaces by TAn ");
        QTest::newRow("one more digit") << 9.9991e-7 << 0.0
                                        << QByteArray("binary STL, deviation 1e-06, isosurfaces by TAn ");
        QTest::newRow("not finite") << std::numeric_limits<double>::infinity() << 0.0
                                    << QByteArray("binary STL, isosurfaces by TAn ");
        QTest::newRow("far away") << 1.2345678901234567e-05 << 4264212.75
                                  << QByteArray(
                                         "add 4264212 4264212 4264212, deviation 1.235e-05, isosurfaces by TAn ");
        QTest::newRow("without room") << 1.2345678901234567e-05 << 1 - std::ldexp(1, -52)
                                      << QByteArray("add 0.9999999999999996 0.9999999999999996 0.9999999999999996, "
                                                    "isosurfaces by TAn");
    }
    void stlTellsTheDeviation()
    {
        QFETCH(double, deviation);
        QFETCH(double, place);
        QFETCH(QByteArray, head);
        const double edge = place > 1 ? 1 : std::ldexp(1, -51);
        const std::vector<Eigen::Vector3d> positions = {Eigen::Vector3d::Constant(place),
                                                        Eigen::Vector3d::Constant(place) + Eigen::Vector3d(edge, 0, 0),
                                                        Eigen::Vector3d::Constant(place) + Eigen::Vector3d(0, edge, 0)};
        const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}};
        const SurfaceContent content{"isosurfaces",
                                     "isovalue",
                                     {{.name = "a", .positions = positions, .normals = {}, .triangles = triangles}},
                                     {{"deviation", deviation}}};
        const QString path = folder_.filePath("deviation.stl");
        QVERIFY(writeSurface(path.toStdString(), content));
        const QByteArray written = bytesOf(path).first(80);
        QVERIFY2(written.startsWith(head), written.constData());
    }

    void objNamesItsGroups()
    {
        const RandomSurface one(5, 2, 1), other(5, 2, 2);
        SurfaceContent content = contentOf(one.part("isovalue 1.5\nf 1 2 3"), other.part("isovalue 2"));
        const QString path = folder_.filePath("surface.obj");
        QVERIFY(writeSurface(path.toStdString(), content));
        const QList<QByteArray> lines = bytesOf(path).split('\n');
        QCOMPARE(lines[0], QByteArray("# isosurfaces by TAn"));
        QCOMPARE(lines[1], QByteArray("# error: 0.5"));
        QVERIFY(lines.contains("g isovalue_1.5\\nf_1_2_3"));
        QVERIFY(lines.contains("g isovalue_2"));
        QVERIFY(lines.contains("# isovalue 1.5"));
        QCOMPARE(std::ranges::count_if(lines, [](const QByteArray& line) { return line.startsWith("f "); }), 4);
    }

    /// What is not UTF-8, and what XML does not know, is written as an escape: VTK and meshio read no file with it.
    void strangeTextsAreEscaped_data()
    {
        QTest::addColumn<QString>("ending");
        for (const QString& ending : endings)
            QTest::newRow(qPrintable(ending)) << ending;
    }
    void strangeTextsAreEscaped()
    {
        QFETCH(QString, ending);
        const std::string strange = "caf\xe9 \xef\xbf\xbe\x1b[1m";
        const RandomSurface one(5, 4, 1);
        SurfaceContent content = contentOf(one.part(strange, true), one.part("b", true));
        content.valueName = strange;
        content.facts.emplace_back("source", strange);
        const QString path = folder_.filePath("strange." + ending);
        QVERIFY(writeSurface(path.toStdString(), content));
        const QByteArray bytes = bytesOf(path);
        QVERIFY(!bytes.contains(strange.c_str()) && !bytes.contains("\xef\xbf\xbd")); // nor a replacement
        QByteArray shown = "caf\\xe9 \\ufffe\\x1b[1m";
        if (ending != "stl")
            QVERIFY(
                bytes.contains(ending == "glb" ? "\"source\":\"caf\\\\xe9 \\\\ufffe\\\\x1b[1m\"" : "source: " + shown));
        if (ending == "obj")
            QVERIFY(bytes.contains("\ng " + shown.replace(' ', '_') + "\n"));
        const VtkReader read(path);
        if (read.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(read.ok(), read.messages());
        QCOMPARE(read.told()["cells"].toInt(), 8);
    }

    void stlIsNotTakenForText()
    {
        const RandomSurface one(5, 2, 1);
        SurfaceContent content = contentOf(one.part("a"), one.part("b"));
        content.title = "solid";
        const QString path = folder_.filePath("surface.stl");
        QVERIFY(writeSurface(path.toStdString(), content));
        const QByteArray bytes = bytesOf(path);
        QVERIFY(!bytes.startsWith("solid"));
        QCOMPARE(numberAt<std::uint32_t>(bytes, 80), 4U);
        QCOMPARE(bytes.size(), 84 + 4 * 50);
        const Eigen::Vector3f normal(numberAt<float>(bytes, 84), numberAt<float>(bytes, 88),
                                     numberAt<float>(bytes, 92));
        const auto corner = [&](int i) { return one.positions[one.triangles[0][std::size_t(i)]]; };
        QVERIFY(std::abs(normal.norm() - 1) < 1e-6F);
        QVERIFY((corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(normal.cast<double>()) > 0);
        for (qsizetype triangle = 0; triangle < 4; ++triangle) { // both parts have the same two
            const qsizetype at = 84 + 50 * triangle;
            for (qsizetype i = 0; i < 9; ++i)
                QCOMPARE(numberAt<float>(bytes, at + 12 + 4 * i),
                         float(one.positions[one.triangles[std::size_t(triangle % 2)][std::size_t(i / 3)]][i % 3]));
            QCOMPARE(numberAt<std::uint16_t>(bytes, at + 48), std::uint16_t(0)); // programs take others for colours
        }
    }

    /// A float has 24 bits: far from the origin coordinates are told from a corner, and the file and the writer say so.
    void farSurfacesAreToldFromACorner_data()
    {
        QTest::addColumn<double>("place");
        QTest::addColumn<double>("edge");
        QTest::addColumn<double>("shift");
        QTest::newRow("at the origin") << 0.0 << 1e-3 << 0.0;
        QTest::newRow("a float step of a hundredth of the thousandth") << 100.0 << 1.0 << 0.0;
        QTest::newRow("far") << 4264212.75 << 1.0 << 4264212.0;
        QTest::newRow("far and large") << 42642124.75 << 1000.0 << 42641920.0;
        QTest::newRow("far and fine") << -1e9 << 1e-3 << -1e9;
        QTest::newRow("fine near 1") << 0.7 << 1e-9 << std::ldexp(std::floor(std::ldexp(0.7, 30)), -30);
    }
    void farSurfacesAreToldFromACorner()
    {
        QFETCH(double, place);
        QFETCH(double, edge);
        QFETCH(double, shift);
        std::vector<Eigen::Vector3d> positions;
        for (int i = 0; i < 4; ++i)
            positions.push_back(Eigen::Vector3d(place, place, 0) + edge * Eigen::Vector3d(i & 1, i >> 1, 0));
        const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {2, 1, 3}};
        SurfaceContent content{
            "boundary", "value", {{.name = "a", .positions = positions, .normals = {}, .triangles = triangles}}, {}};
        QCOMPARE(floatShift(content), Eigen::Vector3d(shift, shift, 0));
        for (const char* ending : {"stl", "glb", "obj", "ply", "vtp"}) {
            const QString path = folder_.filePath(QString("far.") + ending);
            const auto saved = saveSurface(pluginsOfThisBuild(), content, std::filesystem::path(path.toStdString()));
            QVERIFY(saved);
            const bool isTold = shift != 0 && (ending == QByteArray("stl") || ending == QByteArray("glb"));
            QCOMPARE(saved->size(), std::size_t(isTold ? 1 : 0));
            const QByteArray bytes = bytesOf(path);
            const QByteArray number = QByteArray::fromStdString(formatNumber(shift));
            if (!isTold)
                continue;
            const std::string& remark = saved->front().text();
            QVERIFY2(remark.starts_with("In '" + path.toStdString() + "' x, y and z are smaller than in the data by " +
                                        number.toStdString() + ", " + number.toStdString() + " and 0, because"),
                     remark.c_str());
            if (ending == QByteArray("stl")) {
                QVERIFY(bytes.startsWith("add " + number + " " + number + " 0, boundary by TAn"));
                for (qsizetype corner = 0; corner < 3; ++corner)
                    for (qsizetype axis = 0; axis < 3; ++axis) {
                        const double told =
                            double(numberAt<float>(bytes, 96 + 12 * corner + 4 * axis)) + (axis < 2 ? shift : 0);
                        QVERIFY(std::abs(told - positions[std::size_t(corner)][axis]) <=
                                1e-6 * edge + 1e-15 * std::abs(place));
                    }
            } else {
                QVERIFY(bytes.contains("\"matrix\":[1,0,0,0,0,0,-1,0,0,1,0,0," + number + ",0," +
                                       QByteArray::fromStdString(formatNumber(-shift)) + ",1]"));
            }
        }
    }

    /// A layer so thin that floats would make its sides one, though the mean edge is long; and one that is at the wrong
    /// end, where no corner would help.
    void thinLayersAreToldFromACorner()
    {
        const auto shiftOf = [](double wall, double away) {
            std::vector<Eigen::Vector3d> positions;
            for (const double y : {wall, wall + 1e-7 * away, wall + away})
                for (const double x : {0, 1})
                    positions.emplace_back(x, y, 0);
            const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
            return floatShift({"boundary",
                               "value",
                               {{.name = "a", .positions = positions, .normals = {}, .triangles = triangles}},
                               {}});
        };
        QCOMPARE(shiftOf(0, 1), Eigen::Vector3d(0, 0, 0));
        QCOMPARE(shiftOf(10, 1), Eigen::Vector3d(0, 10, 0));
        QCOMPARE(shiftOf(1, -1), Eigen::Vector3d(0, 0, 0));
    }

    void wrongUseIsRefused()
    {
        const RandomSurface one(5, 2, 1);
        const auto refused = [&](const QString& name, const SurfacePart& part, const char* text) {
            const Status written =
                writeSurface(folder_.filePath(name).toStdString(), contentOf(one.part("whole"), part));
            return !written && written.error().kind == ErrorKind::WrongUsage &&
                   QString::fromStdString(written.error().text()).contains(text) &&
                   !QFile::exists(folder_.filePath(name));
        };
        for (const char* name : {"wrong.gltf", "wrong", "stl", "wrong.stl.gz"})
            QVERIFY2(refused(name, one.part("x"), ".glb, .obj, .ply, .stl, .vtk, .vtp, .vtu"), name);
        SurfacePart part = one.part("odd one");
        part.normals = part.normals.first(4);
        QVERIFY(refused("wrong.stl", part, "odd one"));
        part = one.part("odd one");
        part.values = std::span<const float>(one.values).first(4);
        QVERIFY(refused("wrong.stl", part, "odd one"));
        part = one.part("odd one");
        part.positions = part.positions.first(4);
        part.normals = part.normals.first(4);
        QVERIFY(refused("wrong.stl", part, "odd one"));
        part = one.part("odd one");
        part.colours = std::span<const Colour>(one.colours).first(4);
        QVERIFY(refused("wrong.ply", part, "not one colour"));
    }

    /// The numbers alone are looked at: nothing as large as the surface is.
    void whatTheFormatCannotNumberIsRefused_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QString>("part");
        QTest::newRow("ply") << "ply"
                             << "2147483647 vertices";
        QTest::newRow("vtk") << "vtk"
                             << "legacy VTK";
        QTest::newRow("glb") << "glb"
                             << "4 GiB";
    }
    void whatTheFormatCannotNumberIsRefused()
    {
        QFETCH(QString, ending);
        QFETCH(QString, part);
        const std::size_t count = 30'000'000;
        const Buffer<Eigen::Vector3d> positions(count); // memory that nobody touches
        const std::vector<std::array<std::uint32_t, 3>> triangle(1);
        const SurfacePart large{.name = "large", .positions = positions, .normals = {}, .triangles = triangle};
        SurfaceContent content{"isosurfaces", "isovalue", std::vector<SurfacePart>(80, large), {}};
        const Status written = writeSurface(folder_.filePath("large." + ending).toStdString(), content);
        QVERIFY(!written);
        QCOMPARE(written.error().kind, ErrorKind::OutOfResource);
        QVERIFY2(QString::fromStdString(written.error().text()).contains(part), written.error().text().c_str());
        QVERIFY(!QFile::exists(folder_.filePath("large." + ending)));
    }

    void aFullDiskKeepsTheOldFile()
    {
        const SmallDisk disk(64 << 10);
        if (!disk.ok())
            QSKIP("skipped: no right to mount a small disk");
        const RandomSurface small(4, 1, 1), large(5000, 20000, 2);
        QVERIFY(!endings.empty());
        for (const QString& ending : endings) {
            const std::filesystem::path path = disk.folder() / ("surface." + ending.toStdString());
            QVERIFY(writeSurface(path, contentOf(small.part("a"), small.part("b"))));
            const auto size = std::filesystem::file_size(path);
            const Status written = writeSurface(path, contentOf(large.part("a"), large.part("b")));
            QVERIFY(!written);
            QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
            QCOMPARE(std::filesystem::file_size(path), size);
            QVERIFY(std::filesystem::remove(path));
            QVERIFY2(std::filesystem::is_empty(disk.folder()), "nothing is left behind");
        }
    }

    void progressAndCancellation()
    {
        const RandomSurface one(50'000, 100'000, 1);
        const SurfaceContent content = contentOf(one.part("a"), one.part("b"));
        QVERIFY(!endings.empty());
        for (const QString& ending : endings) {
            const QTemporaryDir folder;
            const std::filesystem::path path = folder.filePath("surface." + ending).toStdString();
            std::vector<double> fractions;
            const auto note = [&](double fraction, const Message&) { fractions.push_back(fraction); };
            QVERIFY(writeSurface(path, content, Progress({}, note)));
            QVERIFY(fractions.size() > 10 && std::ranges::is_sorted(fractions));
            QVERIFY2(fractions.back() > 0.8 && fractions.back() <= 1, qPrintable(ending));
            QVERIFY(std::filesystem::remove(path));
            std::stop_source source;
            const auto stop = [&](double fraction, const Message&) {
                if (fraction > 0.5)
                    source.request_stop();
            };
            const Status written = writeSurface(path, content, Progress(source.get_token(), stop));
            QVERIFY(!written && written.error().kind == ErrorKind::Cancelled);
            QVERIFY(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
        }
    }

    /// A cube of six tetrahedra, and one tetrahedron apart: closed, outwards, with the cube's volume.
    void theBoundaryOfAMesh()
    {
        std::vector<Eigen::Vector3d> corners;
        for (int i = 0; i < 8; ++i)
            corners.emplace_back(i & 1, i >> 1 & 1, i >> 2);
        corners.insert(corners.end(), {{9, 9, 9}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6}});
        std::vector<std::array<std::uint32_t, 4>> tetrahedra = {{9, 10, 11, 12}};
        for (const auto& [a, b] : {std::pair{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}})
            tetrahedra.push_back({0, std::uint32_t(a), std::uint32_t(b), 7});
        const BoundaryFaces boundary = boundaryFaces(corners.size(), tetrahedra);
        QCOMPARE(boundary.triangles.size(), std::size_t(4 + 12));
        QCOMPARE(boundary.vertices.size(), std::size_t(12)); // corner 8 is in no tetrahedron
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        double volume = 0;
        for (const auto& t : boundary.triangles) {
            const auto at = [&](std::size_t corner) { return corners[boundary.vertices[t[corner]]]; };
            volume += at(0).dot(at(1).cross(at(2))) / 6;
            for (std::size_t side = 0; side < 3; ++side) {
                ++sides[{t[side], t[(side + 1) % 3]}];
                --sides[{t[(side + 1) % 3], t[side]}];
            }
        }
        QVERIFY(std::ranges::all_of(sides, [](const auto& side) { return side.second == 0; }));
        QVERIFY(std::abs(volume - (1 + 1. / 6)) < 1e-12);
    }

private:
    static SurfaceContent contentOf(SurfacePart one, SurfacePart other)
    {
        if (std::holds_alternative<float>(one.values))
            one.values = 1.5F;
        if (std::holds_alternative<float>(other.values))
            other.values = 2.0F;
        return {"isosurfaces", "isovalue", {std::move(one), std::move(other)}, {{"error", 0.5}}};
    }

    static void compare(const VtkReader& read, const Expected& expected, const QString& ending, bool valued)
    {
        QCOMPARE(read.told()["cells"].toInteger(), static_cast<qint64>(expected.corners.size() / 3));
        QCOMPARE(read.told()["cell types"].toArray(), QJsonArray{5});
        const auto points = vectorsOf(read.array<float>("points"));
        const auto corners = read.array<std::uint32_t>("cells");
        QCOMPARE(corners.size(), expected.corners.size());
        const auto positions = ending == "glb" ? turned(expected.positions) : expected.positions;
        if (ending == "stl") {
            for (std::size_t i = 0; i < corners.size(); ++i)
                QCOMPARE(points[corners[i]], positions[expected.corners[i]]);
            return;
        }
        QCOMPARE(points, positions);
        QCOMPARE(corners, expected.corners);
        if (!valued)
            compareNormals(vectorsOf(read.array<float>("point." + read.told()["active normals"].toString())),
                           ending == "glb" ? turned(expected.normals) : expected.normals);
        if (ending.startsWith("vt")) {
            QCOMPARE(read.told()["active point"].toString(), QString("isovalue"));
            QCOMPARE(read.array<float>("point.isovalue"), expected.values);
            if (ending != "vtk")
                QCOMPARE(read.told()["facts"].toObject()["error"].toDouble(), 0.5);
        }
    }
    /// VTK may have made them of length 1 once more.
    static void compareNormals(const std::vector<Eigen::Vector3f>& read, const std::vector<Eigen::Vector3f>& expected)
    {
        QCOMPARE(read.size(), expected.size());
        for (std::size_t i = 0; i < read.size(); ++i)
            QVERIFY((read[i] - expected[i]).norm() < 1e-6F);
    }

    static std::vector<std::uint8_t> expectedBytes(const SurfaceContent& content)
    {
        std::vector<std::uint8_t> bytes;
        for (const SurfacePart& part : content.parts)
            for (std::size_t vertex = 0; vertex < part.positions.size(); ++vertex) {
                const Colour colour = part.colours.empty() ? Colour{part.colour[0], part.colour[1], part.colour[2]}
                                                           : part.colours[vertex];
                for (const float channel : {colour.red, colour.green, colour.blue})
                    bytes.push_back(static_cast<std::uint8_t>(std::lround(channel * 255)));
            }
        return bytes;
    }
    /// Linear light, by glTF 2.0; the material's colour, by which they are multiplied, is white.
    /// Whether the first vertices in a file that VTK reads in floats are these, within `step`.
    static bool compareFar(const QByteArray& bytes, const QString& ending,
                           const std::vector<Eigen::Vector3d>& positions, double step)
    {
        std::vector<Eigen::Vector3d> read;
        if (ending == "obj") {
            for (const QByteArray& line : bytes.split('\n'))
                if (line.startsWith("v ")) {
                    const QList<QByteArray> words = line.split(' ');
                    read.emplace_back(words[1].toDouble(), words[2].toDouble(), words[3].toDouble());
                }
        } else if (ending == "ply") {
            const qsizetype body = bytes.indexOf("end_header\n") + 11;
            constexpr qsizetype vertexBytes = 3 * sizeof(double) + 4 * sizeof(float);
            for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
                read.push_back(numberAt<Eigen::Vector3d>(bytes, body + qsizetype(vertex) * vertexBytes));
        } else {
            const qsizetype jsonBytes = numberAt<std::uint32_t>(bytes, 12);
            const QJsonObject json = QJsonDocument::fromJson(bytes.mid(20, jsonBytes)).object();
            const QJsonArray matrix = json["nodes"].toArray()[0].toObject()["matrix"].toArray();
            // The node's matrix makes y of z, so it adds the shift turned in this way.
            const Eigen::Vector3d shift(matrix[12].toDouble(), -matrix[14].toDouble(), matrix[13].toDouble());
            const qsizetype first =
                20 + jsonBytes + 8 +
                json["bufferViews"].toArray()[0].toObject()["byteOffset"].toInteger(-1); // positions come first
            for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
                read.emplace_back(shift +
                                  numberAt<Eigen::Vector3f>(bytes, first + qsizetype(12 * vertex)).cast<double>());
        }
        return read.size() >= positions.size() &&
               std::ranges::equal(positions, std::span(read).first(positions.size()),
                                  [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
                                      return (one - other).cwiseAbs().maxCoeff() <= step;
                                  });
    }
    static void compareGlbColours(const QByteArray& bytes, const RandomSurface& surface)
    {
        const qsizetype jsonBytes = numberAt<std::uint32_t>(bytes, 12);
        const QJsonObject json = QJsonDocument::fromJson(bytes.mid(20, jsonBytes)).object();
        const auto attributes = [&](qsizetype mesh) {
            return json["meshes"]
                .toArray()[mesh]
                .toObject()["primitives"]
                .toArray()[0]
                .toObject()["attributes"]
                .toObject();
        };
        const auto baseColour = [&](qsizetype material) {
            return json["materials"]
                .toArray()[material]
                .toObject()["pbrMetallicRoughness"]
                .toObject()["baseColorFactor"]
                .toArray();
        };
        QCOMPARE(baseColour(0), QJsonArray({1, 1, 1, 1}));
        QVERIFY(!attributes(1).contains("COLOR_0"));
        QVERIFY(std::abs(baseColour(1)[0].toDouble() - 0.21404) < 1e-4);
        const QJsonObject accessor = json["accessors"].toArray()[attributes(0)["COLOR_0"].toInt(-1)].toObject();
        QCOMPARE(accessor["type"].toString(), QString("VEC3"));
        QCOMPARE(accessor["componentType"].toInt(), 5126);
        QCOMPARE(accessor["count"].toInteger(), static_cast<qint64>(surface.colours.size()));
        const QJsonObject view = json["bufferViews"].toArray()[accessor["bufferView"].toInt(-1)].toObject();
        const qsizetype first = 20 + jsonBytes + 8 + view["byteOffset"].toInteger();
        for (std::size_t vertex = 0; vertex < surface.colours.size(); ++vertex) {
            const Colour& colour = surface.colours[vertex];
            const std::array channels = {colour.red, colour.green, colour.blue};
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double given = static_cast<double>(channels[channel]);
                const double light = given <= 0.04045 ? given / 12.92 : std::pow((given + 0.055) / 1.055, 2.4);
                const auto read = numberAt<float>(bytes, first + qsizetype(12 * vertex + 4 * channel));
                QVERIFY(std::abs(static_cast<double>(read) - light) < 1e-5);
            }
        }
    }
    /// To the bit behind the coordinates of the part that has some, and nothing there in the other.
    static void compareObjColours(const QByteArray& bytes, const RandomSurface& surface, std::size_t plain)
    {
        std::vector<Colour> read;
        std::size_t without = 0;
        for (const QByteArray& line : bytes.split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (words[0] != "v")
                continue;
            if (words.size() == 7)
                read.push_back({words[4].toFloat(), words[5].toFloat(), words[6].toFloat()});
            else
                without += words.size() == 4 ? 1 : 0;
        }
        QVERIFY(read == surface.colours);
        QCOMPARE(without, plain);
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(SurfaceFileTest)
#include "surface_file_test.moc"
