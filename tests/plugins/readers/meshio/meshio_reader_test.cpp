// SPDX-License-Identifier: GPL-3.0-or-later
// Files as their formats' manuals have them, written by hand, with a linear function of the place.
#include "plugins/readers/meshio/meshio_reader.h"
#include "plugins/readers/meshio/meshio_texts.h"
#include "tests/lacks.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

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
        QCOMPARE(text.count("raise Refusal(") + 2, raised); // and two sentences that are no refusals
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
            << QByteArray("does not lie in its folder");
    }
    void whatCannotBeReadIsRefused()
    {
        if (!hasMeshio())
            QSKIP_WITHOUT("meshio");
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, told);
        const auto dataset = reader_.read(write(name, content), {}, {});
        QVERIFY(!dataset.ok());
        const QByteArray text = QByteArray::fromStdString(dataset.error().text());
        QVERIFY2(text.contains(told) && text.contains(name), text);
        QCOMPARE(int(dataset.error().kind), int(ErrorKind::BadInput));
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
