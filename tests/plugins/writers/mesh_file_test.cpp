// SPDX-License-Identifier: GPL-3.0-or-later
/// Meshes in files: what VTK reads back is what was written, to the bit; and files that cannot be written.
#include "core/mesh/topology.h"
#include "plugins/host/file_saving.h"
#include "tests/core/base/small_disk.h"
#include "tests/lacks.h"
#include "tests/plugins/plugins_of_this_build.h"
#include "tests/plugins/writers/vtk_reader.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace tetra;

namespace {

/// Random numbers in the shape of a mesh: a writer must not care whether they are one.
struct RandomMesh {
    /// `inDoubles`: coordinates that no float holds.
    RandomMesh(std::size_t vertices, std::size_t cells, bool inDoubles = false)
    {
        std::mt19937 random(static_cast<unsigned>(vertices + 7 * cells));
        std::normal_distribution<float> number(0, 1000);
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
            positions.emplace_back(number(random), number(random), number(random));
            if (inDoubles)
                positions.back() += Eigen::Vector3d(4264212.7, 1e-13, 1e9 / 3);
            values.push_back(number(random));
            sites.push_back(random());
        }
        for (std::size_t cell = 0; cell < cells; ++cell) {
            Tetrahedron corners{};
            for (std::uint32_t& corner : corners)
                corner = static_cast<std::uint32_t>(random() % vertices);
            tetrahedra.push_back(corners);
            levels.push_back(static_cast<std::uint8_t>(random()));
            births.push_back(cell % 3 == 0 ? std::numeric_limits<float>::infinity() : number(random));
            volumes.push_back(std::exp(static_cast<double>(number(random)) / 100));
            kinds.push_back(static_cast<std::uint16_t>(random()));
        }
    }

    MeshContent content() const
    {
        return {.positions = positions,
                .tetrahedra = tetrahedra,
                .pointArrays = {{"density (kg/m³) <&\">", std::span(values)}, {"site", std::span(sites)}},
                .cellArrays = {{"level", std::span(levels)},
                               {"birth_error", std::span(births)},
                               {"volume", std::span(volumes)},
                               {"kind", std::span(kinds)}},
                .facts = {{"error", 0.1}, {"model", "engine \"1\" <&>.tan"}, {"note", std::string(200, 'x')}}};
    }

    std::vector<Eigen::Vector3d> positions;
    std::vector<float> values;
    std::vector<std::uint32_t> sites;
    std::vector<Tetrahedron> tetrahedra;
    std::vector<std::uint8_t> levels;
    std::vector<float> births;
    std::vector<double> volumes;
    std::vector<std::uint16_t> kinds;
};

template <class T> std::vector<T> numbersIn(std::span<const std::byte> bytes)
{
    std::vector<T> numbers(bytes.size() / sizeof(T));
    if (!bytes.empty())
        std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

Status writeMesh(const std::filesystem::path& path, const MeshContent& content, const Progress& progress = {})
{
    const auto saved = saveMesh(pluginsOfThisBuild(), content, path, {}, progress);
    return saved ? Status() : Status(saved.error());
}

} // namespace

class MeshFileTest : public QObject {
    Q_OBJECT

private slots:
    void vtkReadsWhatWasWritten_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("vertices");
        QTest::addColumn<int>("cells");
        QTest::addColumn<bool>("inDoubles");
        for (const char* ending : {"vtu", "vtk", "VTU"})
            for (const auto& [vertices, cells] : {std::pair{4, 1}, {100, 333}, {30'000, 70'000}, {5, 0}})
                QTest::addRow("%s, %d cells", ending, cells) << QString("mesh.") + ending << vertices << cells << false;
        for (const char* ending : {"vtu", "vtk"})
            QTest::addRow("%s in doubles", ending) << QString("fine.") + ending << 2000 << 3000 << true;
    }
    void vtkReadsWhatWasWritten()
    {
        QFETCH(QString, name);
        QFETCH(int, vertices);
        QFETCH(int, cells);
        QFETCH(bool, inDoubles);
        const RandomMesh mesh(static_cast<std::size_t>(vertices), static_cast<std::size_t>(cells), inDoubles);
        const QString path = folder_.filePath(name);
        const Status written = writeMesh(path.toStdString(), mesh.content());
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        const VtkReader read(path);
        if (read.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(read.ok(), read.messages());
        QCOMPARE(read.told()["points"].toInt(), vertices);
        QCOMPARE(read.told()["cells"].toInt(), cells);
        QCOMPARE(read.told()["cell types"].toArray(), cells > 0 ? QJsonArray{10} : QJsonArray{});
        std::vector<double> places;
        for (const Eigen::Vector3d& position : mesh.positions)
            places.insert(places.end(), {position[0], position[1], position[2]});
        QCOMPARE(read.places(), places);
        QCOMPARE(read.array<double>("points").size() == places.size(), inDoubles);
        QCOMPARE(read.array<std::uint32_t>("cells"),
                 numbersIn<std::uint32_t>(std::as_bytes(std::span(mesh.tetrahedra))));
        const QJsonObject types = read.told()["arrays"].toObject();
        QVERIFY(types.contains("point.density (kg/m³) <&\">"));
        QCOMPARE(read.told()["active point"].toString(), QString("density (kg/m³) <&\">"));
        QCOMPARE(read.told()["active cell"].toString(), QString("level"));
        QCOMPARE(read.array<float>("point.density (kg_m³) <&\">"), mesh.values);
        QCOMPARE(read.array<std::uint32_t>("point.site"), mesh.sites);
        QCOMPARE(read.array<std::uint8_t>("cell.level"), mesh.levels);
        QCOMPARE(read.array<float>("cell.birth_error"), mesh.births);
        QCOMPARE(read.array<double>("cell.volume"), mesh.volumes);
        QCOMPARE(read.array<std::uint16_t>("cell.kind"), mesh.kinds);
    }

    /// Numbers as field data of a .vtu file, texts as comments; in a .vtk file all of it in the title, as far as it
    /// fits.
    void factsStandWhereOthersBearThem()
    {
        const RandomMesh mesh(4, 1);
        MeshContent content = mesh.content();
        content.facts.insert(content.facts.begin() + 2, {"remark", std::string("a--b---\nc-")});
        const QString xml = folder_.filePath("facts.vtu"), legacy = folder_.filePath("facts.vtk");
        QVERIFY(writeMesh(xml.toStdString(), content) && writeMesh(legacy.toStdString(), content));
        QFile file(xml);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray head = file.readAll().left(1000);
        QVERIFY2(head.contains("<!-- model: engine &quot;1&quot; &lt;&amp;&gt;.tan -->\n"
                               "<!-- remark: a- -b- - -\\nc- -->\n<!-- note: xxx"),
                 head);
        QFile other(legacy);
        QVERIFY(other.open(QIODevice::ReadOnly));
        const QByteArray begin = other.readAll();
        QVERIFY(!begin.left(begin.indexOf("POINTS")).contains("FIELD"));
        const QByteArray title = begin.split('\n')[1];
        QCOMPARE(title,
                 QByteArray("tetrahedral mesh by TAn; error: 0.1; model: engine \"1\" <&>.tan; remark: a--b---\\nc-"));
        for (const QString& path : {xml, legacy}) {
            const VtkReader read(path);
            if (read.isMissing())
                QSKIP_WITHOUT("python3-vtk9");
            QVERIFY2(read.ok(), read.messages());
            QCOMPARE(read.told()["cells"].toInt(), 1);
            const QJsonObject facts = read.told()["facts"].toObject();
            QCOMPARE(facts.keys(), path == xml ? QStringList{"error"} : QStringList());
            QCOMPARE(facts["error"].toDouble(), path == xml ? 0.1 : 0.0);
        }
    }

    /// What is not UTF-8, and what XML does not know, is written as an escape: VTK and meshio read no file with it.
    void strangeTextsAreEscaped()
    {
        const RandomMesh mesh(4, 1);
        MeshContent content = mesh.content();
        content.pointArrays[0].name = "caf\xe9";
        content.facts = {{"model", std::string("caf\xe9 \xef\xbf\xbe\x1b[1m.tan")}};
        for (const char* ending : {"vtu", "vtk"}) {
            const QString path = folder_.filePath(QString("strange.") + ending);
            QVERIFY(writeMesh(path.toStdString(), content));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray head = file.read(1000);
            QVERIFY2(head.contains("model: caf\\xe9 \\ufffe\\x1b[1m.tan"), head);
            const VtkReader read(path);
            if (read.isMissing())
                QSKIP_WITHOUT("python3-vtk9");
            QVERIFY2(read.ok(), read.messages());
            QCOMPARE(read.told()["active point"].toString(), QString("caf\\xe9"));
        }
    }

    /// A PLY file has triangles: those of the boundary, with the first array.
    void plyHasTheBoundary()
    {
        RandomMesh mesh(4, 0);
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        MeshContent content = mesh.content();
        const std::vector<Tetrahedron> one = {{0, 1, 2, 3}};
        content.tetrahedra = one;
        content.cellArrays.clear();
        content.facts.emplace_back("two\nlines", "a\nb");
        const QString path = folder_.filePath("mesh.ply");
        QVERIFY(writeMesh(path.toStdString(), content));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        const qsizetype end = bytes.indexOf("end_header\n");
        const QList<QByteArray> expected = {"ply",
                                            "format binary_little_endian 1.0",
                                            "comment boundary of a tetrahedral mesh by TAn",
                                            "comment error: 0.1",
                                            "comment model: engine \"1\" <&>.tan",
                                            "comment note: " + QByteArray(200, 'x'),
                                            "comment two\\nlines: a\\nb",
                                            "element vertex 4",
                                            "property float x",
                                            "property float y",
                                            "property float z",
                                            "property float density_(kg/m__)_<&\">",
                                            "element face 4",
                                            "property list uchar int vertex_indices",
                                            ""};
        QCOMPARE(bytes.first(end).split('\n'), expected);
        QCOMPARE(bytes.size() - end - 11, qsizetype(4 * 16 + 4 * 13));
    }

    void wrongNamesAreRefused_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"mesh.off", "mesh", "vtu", ".vtu", "mesh.vtu.gz", "mesh."})
            QTest::newRow(name) << name;
    }
    void wrongNamesAreRefused()
    {
        QFETCH(QString, name);
        const RandomMesh mesh(4, 1);
        const Status written = writeMesh(folder_.filePath(name).toStdString(), mesh.content());
        QVERIFY(!written);
        QCOMPARE(written.error().kind, ErrorKind::WrongUsage);
        const QString text = QString::fromStdString(written.error().text());
        QVERIFY2(text.contains(".vtk, .vtu; or") && text.contains(name), qPrintable(text));
        QVERIFY(!checkWritable(pluginsOfThisBuild(), WrittenContent::Mesh, name.toStdString()));
        QVERIFY(!QFile::exists(folder_.filePath(name)));
    }

    void arraysMustFit()
    {
        const RandomMesh mesh(4, 1);
        for (int wrong = 0; wrong < 3; ++wrong) {
            MeshContent content = mesh.content();
            if (wrong == 0)
                content.pointArrays[0].values = std::span(mesh.births);
            else if (wrong == 1)
                content.cellArrays[1].values = std::span(mesh.sites);
            else
                content.cellArrays[0].name.clear();
            const Status written = writeMesh(folder_.filePath("unfit.vtu").toStdString(), content);
            QVERIFY(!written);
            QCOMPARE(written.error().kind, ErrorKind::WrongUsage);
        }
        QVERIFY(!QFile::exists(folder_.filePath("unfit.vtu")));
    }

    void foldersThatAreNotThereAreNamed()
    {
        const RandomMesh mesh(4, 1);
        for (const char* name : {"none/mesh.vtu", "none/mesh.vtk"}) {
            const Status written = writeMesh(folder_.filePath(name).toStdString(), mesh.content());
            QVERIFY(!written);
            QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
            QVERIFY(QString::fromStdString(written.error().text()).contains(name));
        }
    }

    void aFullDiskKeepsTheOldFile()
    {
        const SmallDisk disk(64 << 10);
        if (!disk.ok())
            QSKIP("skipped: no right to mount a small disk");
        const RandomMesh small(4, 1);
        const RandomMesh large(5000, 20000);
        for (const char* name : {"mesh.vtu", "mesh.vtk"}) {
            const std::filesystem::path path = disk.folder() / name;
            QVERIFY(writeMesh(path, small.content()));
            const auto size = std::filesystem::file_size(path);
            const Status written = writeMesh(path, large.content());
            QVERIFY(!written);
            QCOMPARE(written.error().kind, ErrorKind::CannotWrite);
            QVERIFY2(QString::fromStdString(written.error().text()).contains("Free some space"),
                     written.error().text().c_str());
            QCOMPARE(std::filesystem::file_size(path), size);
            QVERIFY(std::filesystem::remove(path));
            QVERIFY2(std::filesystem::is_empty(disk.folder()), "nothing is left behind");
        }
    }

    /// Progress grows to the end; after a request to stop, at most one more piece is written, and nothing is left.
    void progressAndCancellation_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"mesh.vtu", "mesh.vtk"})
            QTest::newRow(name) << name;
    }
    void progressAndCancellation()
    {
        QFETCH(QString, name);
        const RandomMesh mesh(50'000, 100'000);
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(name).toStdString();
        std::vector<double> fractions;
        const auto note = [&](double fraction, const Message&) { fractions.push_back(fraction); };
        QVERIFY(writeMesh(path, mesh.content(), Progress({}, note)));
        QVERIFY(fractions.size() > 10);
        QVERIFY(std::ranges::is_sorted(fractions));
        QVERIFY2(fractions.back() > 0.99 && fractions.back() <= 1, qPrintable(QString::number(fractions.back())));

        QVERIFY(std::filesystem::remove(path));
        std::stop_source source;
        int calls = 0;
        const auto stop = [&](double fraction, const Message&) {
            ++calls;
            if (fraction > 0.5 && !source.stop_requested()) {
                source.request_stop();
                calls = 0;
            }
        };
        const Status written = writeMesh(path, mesh.content(), Progress(source.get_token(), stop));
        QVERIFY(!written);
        QCOMPARE(written.error().kind, ErrorKind::Cancelled);
        QCOMPARE(calls, 0);
        QVERIFY(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

private:
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(MeshFileTest)
#include "mesh_file_test.moc"
