// SPDX-License-Identifier: GPL-3.0-or-later
// Files as their formats' manuals have them, written by hand, with a linear function of the place.
#include "plugins/readers/meshio/meshio_reader.h"
#include "plugins/readers/meshio/meshio_texts.h"
#include "tests/lacks.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace tetra;

namespace {

constexpr const char* scriptPath = TAN_SOURCE_DIR "/plugins/readers/meshio/tan-read-meshio.py";

const char* const gmshText = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                             "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
                             "$Elements\n3\n1 2 2 7 7 1 2 3\n2 4 2 9 9 1 2 3 4\n3 4 2 9 9 2 3 4 5\n$EndElements\n"
                             "$NodeData\n1\n\"heat\"\n1\n0.0\n3\n0\n1\n5\n1 0\n2 1\n3 2\n4 3\n5 6\n$EndNodeData\n"
                             "$NodeData\n1\n\"flow\"\n1\n0.0\n3\n0\n3\n5\n"
                             "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodeData\n";

const char* const xdmfMesh =
    "<Topology TopologyType=\"Tetrahedron\" NumberOfElements=\"2\"><DataItem Format=\"XML\" DataType=\"Int\" "
    "Precision=\"8\" Dimensions=\"2 4\">0 1 2 3 1 2 3 4</DataItem></Topology>"
    "<Geometry GeometryType=\"XYZ\"><DataItem Format=\"XML\" DataType=\"Float\" Precision=\"8\" Dimensions=\"5 3\">"
    "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1</DataItem></Geometry>";

QByteArray xdmfOf(const QByteArray& inside)
{
    return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>" + inside + "</Domain></Xdmf>\n";
}

QByteArray xdmfValues(const QByteArray& values, const char* format = "XML")
{
    return QByteArray("<Attribute Name=\"heat\" AttributeType=\"Scalar\" Center=\"Node\"><DataItem Format=\"") +
           format + "\" DataType=\"Float\" Precision=\"8\" Dimensions=\"5\">" + values + "</DataItem></Attribute>";
}

/// A collection of two times over one mesh, as meshio's own writer lays it out.
QByteArray xdmfSeries()
{
    const auto step = [](const char* time, const char* values) {
        return QByteArray("<Grid><xi:include xmlns:xi=\"http://www.w3.org/2001/XInclude\" "
                          "xpointer=\"xpointer(//Grid[@Name=&quot;mesh&quot;]/*[self::Topology or "
                          "self::Geometry])\"/><Time Value=\"") +
               time + "\"/>" + xdmfValues(values) + "</Grid>";
    };
    return xdmfOf(QByteArray("<Grid Name=\"TimeSeries_meshio\" GridType=\"Collection\" CollectionType=\"Temporal\">") +
                  step("0.0", "0 1 2 3 6") + step("2.5", "10 11 12 13 16") +
                  "</Grid><Grid Name=\"mesh\" GridType=\"Uniform\">" + xdmfMesh + "</Grid>");
}

template <class Number> QByteArray bytesOf(const std::vector<Number>& numbers)
{
    return {reinterpret_cast<const char*>(numbers.data()), qsizetype(numbers.size() * sizeof(Number))};
}

double heatAt(const Eigen::Vector3d& place)
{
    return place.x() + 2 * place.y() + 3 * place.z();
}

} // namespace

class MeshioReaderTest : public QObject {
    Q_OBJECT
private slots:
    void formatsAreKnownByNameAndBeginning_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("beginning");
        QTest::addColumn<QByteArray>("format");
        const auto row = [](const char* name, const char* beginning, const char* format) {
            QTest::addRow("%s %.5s", name, beginning)
                << QByteArray(name) << QByteArray(beginning) << QByteArray(format);
        };
        row("a.msh", "$MeshFormat\n", "gmsh");
        row("a.MSH", "\n $MeshFormat\n", "gmsh");
        row("a.msh", "(0 \"GAMBIT to Fluent File\")", ""); // Fluent's
        row("a.inp", "*HEADING\n", "abaqus");
        row("a.inp", "8 2 1 0 0\n", ""); // AVS UCD
        row("a.xdmf", "<?xml", "xdmf");
        row("a.med", "\x89HDF", "med");
        row("a.bdf", "$ any\n", "nastran");
        row("a.mesh", "MeshVersionFormatted 2", "medit");
        row("a.mesh", "solid", "");
        row("mesh", "$MeshFormat", "");
    }
    void formatsAreKnownByNameAndBeginning()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, beginning);
        QTEST(QByteArray::fromStdString(meshioFormat(name.toStdString(), beginning.toStdString())), "format");
    }

    /// Sentences of the program in Python are known here, for translators.
    void itsSentencesAreKnown()
    {
        QFile script(scriptPath);
        QVERIFY(script.open(QIODevice::ReadOnly));
        const QByteArray text = script.readAll().simplified().replace("\" \"", ""); // parts of a string are joined
        int raised = 0;
        for (const MarkedText sentence : meshioTexts) {
            QVERIFY2(text.contains(QByteArray(sentence.text)), sentence.text);
            ++raised;
        }
        QCOMPARE(text.count("raise Refusal(") + 4, raised); // and four sentences that are no refusals
    }

    /// A later meshio may have other parts inside.
    void itTakesNoPrivatePartOfMeshio()
    {
        QFile script(scriptPath);
        QVERIFY(script.open(QIODevice::ReadOnly));
        const QByteArray text = script.readAll();
        QVERIFY(!QRegularExpression("meshio(\\.\\w+)*\\._|import _").match(text).hasMatch());
    }

    void aGmshMeshIsRead()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        const auto path = write("a.msh", gmshText);
        const auto dataset = reader_.read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), std::uint64_t(5));
        QCOMPARE(dataset->tetrahedra->size(), std::size_t(2));
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point)
            QCOMPARE(dataset->values.at(point), heatAt(dataset->position(point)));
        QCOMPARE(dataset->source.valueName, std::string("heat"));
        QCOMPARE(dataset->source.taken.size(), std::size_t(1));
        QVERIFY(dataset->source.taken[0] == (Taken{TakenPart::Array, std::string("heat"), true}));

        const auto contents =
            reader_.probe(path, {{"array", std::string("flow")}, {"component", std::string("1")}}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->points, std::uint64_t(5));
        QCOMPARE(contents->cells, std::uint64_t(2));
        QCOMPARE(contents->arrays[0].name, std::string("heat"));
        QCOMPARE(contents->arrays[0].range->maximum, 6.);
        QCOMPARE(contents->arrays[1].components, 3);
        QVERIFY(contents->taken == (std::vector<Taken>{{TakenPart::Array, std::string("flow"), false},
                                                       {TakenPart::Component, std::string("1"), false}}));
        const auto magnitude = reader_.probe(path, {{"array", std::string("flow")}}, {});
        QVERIFY(magnitude && magnitude->taken.back() == (Taken{TakenPart::Component, std::string("magnitude"), true}));
    }

    /// Nodes and elements have numbers of any kind, and views name them in any order and not all of them.
    void gmshValuesAreThoseOfTheirNumbers()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        const QByteArray views =
            "$NodeData\n1\n\"heat\"\n1\n0.0\n3\n0\n1\n5\n50 6\n20 1\n40 3\n10 0\n30 2\n$EndNodeData\n"
            "$ElementData\n1\n\"load\"\n1\n0.0\n3\n0\n1\n2\n9 8\n8 8\n$EndElementData\n"
            "$ElementData\n1\n\"load\"\n1\n1.0\n3\n1\n1\n2\n9 3\n8 1\n$EndElementData\n";
        const QByteArray places = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n";
        const QByteArray old =
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n"
            "50 1 1 1\n$EndNodes\n$Elements\n3\n7 2 2 7 7 10 20 30\n8 4 2 9 9 10 20 30 40\n"
            "9 4 2 9 9 20 30 40 50\n$EndElements\n";
        const QByteArray recent =
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 0\n$EndEntities\n"
            "$Nodes\n1 5 10 50\n3 1 0 5\n10\n20\n30\n40\n50\n" +
            places +
            "$EndNodes\n$Elements\n2 3 7 9\n3 1 2 1\n7 10 20 30\n3 1 4 2\n8 10 20 30 40\n"
            "9 20 30 40 50\n$EndElements\n";
        for (const QByteArray& mesh : {old, recent}) {
            const auto path = write("numbers.msh", mesh + views);
            const auto heat = reader_.read(path, {{"array", std::string("heat")}}, {});
            QVERIFY2(heat.ok(), heat.ok() ? "" : heat.error().text().c_str());
            for (std::uint64_t point = 0; point < heat->pointCount(); ++point)
                QCOMPARE(heat->values.at(point), heatAt(heat->position(point)));
            // Of cells, the mean: 1 where only the first tetrahedron is, 3 at the far corner of the second.
            const auto load = reader_.read(path, {{"array", std::string("load")}}, {});
            QVERIFY2(load.ok(), load.ok() ? "" : load.error().text().c_str());
            QCOMPARE(load->pointCount(), std::uint64_t(5));
            for (std::uint64_t point = 0; point < load->pointCount(); ++point) {
                const double sum = load->position(point).sum();
                QCOMPARE(load->values.at(point), sum < 0.5 ? 1. : sum > 2 ? 3. : 2.);
            }
            QCOMPARE(load->source.leftOut.size(), std::size_t(1));
            QCOMPARE(load->source.leftOut[0].text(), std::string("'load' has 2 steps; the last one is read."));
            const auto astray =
                reader_.read(write("astray.msh", mesh + QByteArray(views).replace("\n9 3", "\n5 3")), {}, {});
            QVERIFY(!astray.ok() && astray.error().text().find("a node or an element 5") != std::string::npos);
        }
    }

    /// Numbers of elements of any kind, and views that name not all and in any order.
    void gmshInBinaryHasItsValues_data()
    {
        QTest::addColumn<QByteArray>("mesh");
        const std::vector<double> places = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
        QByteArray nodes;
        for (int node = 0; node < 5; ++node)
            nodes += bytesOf<std::int32_t>({node + 1}) +
                     bytesOf<double>({places[3 * node], places[3 * node + 1], places[3 * node + 2]});
        QTest::newRow("2.2") << "$MeshFormat\n2.2 1 8\n" + bytesOf<std::int32_t>({1}) +
                                    "\n$EndMeshFormat\n$Nodes\n5\n" + nodes + "\n$EndNodes\n$Elements\n3\n" +
                                    bytesOf<std::int32_t>({2, 1, 2, 7, 7, 7, 1, 2, 3, 4, 1, 2, 8, 9, 9, 1, 2, 3, 4}) +
                                    bytesOf<std::int32_t>({4, 1, 2, 9, 9, 9, 2, 3, 4, 5}) + "\n$EndElements\n";
        QTest::newRow("4.1") << "$MeshFormat\n4.1 1 8\n" + bytesOf<std::int32_t>({1}) + "\n$EndMeshFormat\n$Nodes\n" +
                                    bytesOf<std::uint64_t>({1, 5, 1, 5}) + bytesOf<std::int32_t>({3, 1, 0}) +
                                    bytesOf<std::uint64_t>({5, 1, 2, 3, 4, 5}) + bytesOf(places) +
                                    "\n$EndNodes\n$Elements\n" + bytesOf<std::uint64_t>({2, 3, 7, 9}) +
                                    bytesOf<std::int32_t>({3, 1, 2}) + bytesOf<std::uint64_t>({1, 7, 1, 2, 3}) +
                                    bytesOf<std::int32_t>({3, 1, 4}) +
                                    bytesOf<std::uint64_t>({2, 8, 1, 2, 3, 4, 9, 2, 3, 4, 5}) + "\n$EndElements\n";
    }
    void gmshInBinaryHasItsValues()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        QFETCH(QByteArray, mesh);
        const auto view = [](const char* section, const char* name, const std::vector<std::pair<int, double>>& rows) {
            QByteArray all = QByteArray("$") + section + "\n1\n\"" + name + "\"\n1\n0.0\n3\n0\n1\n" +
                             QByteArray::number(int(rows.size())) + "\n";
            for (const auto& [number, value] : rows)
                all += bytesOf<std::int32_t>({number}) + bytesOf<double>({value});
            return all + "\n$End" + section + "\n";
        };
        const QByteArray views = view("NodeData", "heat", {{5, 6}, {2, 1}, {4, 3}, {1, 0}, {3, 2}}) +
                                 view("ElementData", "load", {{9, 3}, {8, 1}}) +
                                 "$ElementNodeData\n1\n\"corner\"\n0\n3\n0\n1\n0\n\n$EndElementNodeData\n";
        const auto path = write("binary.msh", mesh + views);
        const QStringList before = QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden);
        const auto heat = reader_.read(path, {{"array", std::string("heat")}}, {});
        QVERIFY2(heat.ok(), heat.ok() ? "" : heat.error().text().c_str());
        for (std::uint64_t point = 0; point < heat->pointCount(); ++point)
            QCOMPARE(heat->values.at(point), heatAt(heat->position(point)));
        QCOMPARE(heat->source.leftOut.size(), std::size_t(1));
        QVERIFY(heat->source.leftOut[0].text().starts_with("Its values 'corner' at the corners of elements"));
        const auto load = reader_.read(path, {{"array", std::string("load")}}, {});
        QVERIFY2(load.ok(), load.ok() ? "" : load.error().text().c_str());
        for (std::uint64_t point = 0; point < load->pointCount(); ++point) {
            const double sum = load->position(point).sum();
            QCOMPARE(load->values.at(point), sum < 0.5 ? 1. : sum > 2 ? 3. : 2.);
        }
        QCOMPARE(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
    }

    void aStepOfAnXdmfIsRead()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        const auto path = write("series.xdmf", xdmfSeries());
        const auto dataset = reader_.read(path, {{"time", std::int64_t(2)}}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point)
            QCOMPARE(dataset->values.at(point), heatAt(dataset->position(point)) + 10);
        QCOMPARE(dataset->source.taken.back().what.text(), std::string("2 of 2, time 2.5"));
        QVERIFY(!dataset->source.taken.back().guessed);
        const auto first = reader_.read(path, {{"time", std::int64_t(1)}}, {}), unasked = reader_.read(path, {}, {});
        QVERIFY(first && unasked);
        QVERIFY(!first->source.taken.back().guessed && unasked->source.taken.back().guessed);
    }

    void whatCannotBeReadIsRefused_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("no values") << QByteArray("a.inp")
                                   << QByteArray("*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
                                                 "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n")
                                   << QByteArray("no values");
        QTest::newRow("cut") << QByteArray("a.msh") << QByteArray(gmshText).left(200)
                             << QByteArray("does not understand");
        QTest::newRow("names another's file")
            << QByteArray("a.xdmf")
            << xdmfOf(QByteArray("<Grid Name=\"Grid\">") + xdmfMesh + xdmfValues("/etc/passwd:/a", "HDF") + "</Grid>")
            << QByteArray("is not in its folder");
        QTest::newRow("names a pipe") << QByteArray("b.xdmf")
                                      << xdmfOf(QByteArray("<Grid Name=\"Grid\">") + xdmfMesh +
                                                xdmfValues("pipe", "Binary") + "</Grid>")
                                      << QByteArray("not a regular file");
        QTest::newRow("includes another's file")
            << QByteArray("b.inp") << QByteArray("*NODE\n1, 0, 0, 0\n*Include, input=/etc/passwd\n")
            << QByteArray("is not in its folder");
        QTest::newRow("includes what never ends")
            << QByteArray("c.inp") << QByteArray("*INCLUDE, INPUT=/dev/zero\n") << QByteArray("is not in its folder");
    }
    void whatCannotBeReadIsRefused()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        ::mkfifo(QFile::encodeName(folder_.filePath("pipe")).constData(), 0600);
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, told);
        const auto dataset = reader_.read(write(name, content), {}, {});
        QVERIFY(!dataset.ok());
        const QByteArray text = QByteArray::fromStdString(dataset.error().text());
        QVERIFY2(text.contains(told) && text.contains(name), text);
        QCOMPARE(int(dataset.error().kind), int(ErrorKind::BadInput));
    }

    /// By links of HDF5 and by what it calls virtual or external.
    void arraysInOtherFilesAreNotRead_data()
    {
        QTest::addColumn<QString>("made");
        QTest::newRow("a link") << "file['values'] = h5py.ExternalLink('other.h5', '/values')";
        QTest::newRow("values elsewhere")
            << "file.create_dataset('values', (4,), 'f8', external=[('other.h5', 0, 32)])";
        QTest::newRow("a virtual array")
            << "layout = h5py.VirtualLayout((4,), 'f8'); layout[:] = h5py.VirtualSource("
               "'other.h5', 'values', (4,)); file.create_virtual_dataset('values', layout)";
    }
    void arraysInOtherFilesAreNotRead()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        QFETCH(QString, made);
        const QString script =
            "import h5py\nfile = h5py.File('other.h5', 'w')\nfile['values'] = [1., 2, 3, 4]\nfile.close()\n"
            "file = h5py.File('a.h5', 'w')\n" +
            made + "\nfile.close()\nimport shutil\nshutil.copy('a.h5', 'a.med')\n";
        QProcess python;
        python.setWorkingDirectory(folder_.path());
        python.start("/usr/bin/python3", {"-I", "-c", script});
        if (!python.waitForFinished() || python.exitCode() != 0)
            QSKIP_WITHOUT("h5py");
        const auto xdmf = write("h.xdmf", xdmfOf(QByteArray("<Grid Name=\"Grid\">") + xdmfMesh +
                                                 xdmfValues("a.h5:/values", "HDF") + "</Grid>"));
        for (const std::filesystem::path& path :
             {xdmf, std::filesystem::path(folder_.filePath("a.med").toStdString())}) {
            const auto dataset = reader_.read(path, {}, {});
            QVERIFY(!dataset.ok());
            QVERIFY2(dataset.error().text().find("'/values' lie in other files") != std::string::npos,
                     dataset.error().text().c_str());
        }
    }

private:
    std::filesystem::path write(const QByteArray& name, const QByteArray& content)
    {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write");
        return file.fileName().toStdString();
    }

    static bool hasMeshio()
    {
        static const bool isThere = QProcess::execute("/usr/bin/python3", {"-I", "-c", "import meshio"}) == 0;
        return isThere;
    }

    QTemporaryDir folder_;
    const MeshioReader reader_{scriptPath};
};

QTEST_GUILESS_MAIN(MeshioReaderTest)
#include "meshio_reader_test.moc"
