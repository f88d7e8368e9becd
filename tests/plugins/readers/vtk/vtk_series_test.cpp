// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of VTK files, .pvd and .vtu.series: their times are steps, their files of one time are parts, and they lead
// only to files in their folder or below it.
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QDir>
#include <QTest>

using namespace tetra;

namespace {

QByteArray dataSet(const QByteArray& time, const QByteArray& file, const QByteArray& more = {})
{
    return "<DataSet timestep=\"" + time + "\" group=\"\" " + more + " file=\"" + file + "\"/>\n";
}

QByteArray pvd(const QByteArray& dataSets)
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" + dataSets +
           "</Collection>\n</VTKFile>\n";
}

} // namespace

class VtkSeriesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(QDir(QString::fromStdString(folder_.path().string())).mkdir("run & more"));
        folder_.write("a.vti", vtiText());
        folder_.write("run & more/b.vti", with(vtiText(), "19 20 21", "19 200 21"));
        folder_.write("mesh.vtu", vtuText());
        folder_.write("mesh.vtk", legacyMeshText());
    }

    /// In the order of times, whatever that of the list.
    void timesOfAListAreSteps_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("pvd") << QByteArray("run.pvd")
                             << pvd(dataSet("1.5", "run &amp; more/b.vti") + dataSet("0.5", "a.vti"));
        QTest::newRow("json") << QByteArray("run.vti.series")
                              << QByteArray("{\"file-series-version\": \"1.0\", \"files\": [{\"name\": \"run & "
                                            "more/b.vti\", \"time\": 1.5}, {\"name\": \"a.vti\", \"time\": 0.5}]}\n");
    }
    void timesOfAListAreSteps()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        const auto path = folder_.write(name, content);
        const auto first = builtVtkReader().read(path, {}, {});
        QVERIFY2(first.ok(), first.ok() ? "" : first.error().text().c_str());
        QVERIFY(first->domain == DomainClass::RegularLattice);
        QCOMPARE(first->lattice.origin, Eigen::Vector3d(1, 2, 3));
        QCOMPARE(first->values.at(20), 20.);
        QCOMPARE(takenOf(first->source.taken),
                 QString("array: value; time step: 1 of 2, time 0.5, file 'a.vti' (a guess)"));
        const auto second = builtVtkReader().read(path, {{"time", std::int64_t(2)}}, {});
        QVERIFY2(second.ok(), second.ok() ? "" : second.error().text().c_str());
        QCOMPARE(second->values.at(20), 200.);
        QCOMPARE(takenOf(second->source.taken),
                 QString("array: value; time step: 2 of 2, time 1.5, file 'run & more/b.vti'"));
        const auto third = builtVtkReader().read(path, {{"time", std::int64_t(3)}}, {});
        QVERIFY(!third.ok() && third.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(third.error().text().find("Give one from 1 to 2") != std::string::npos, third.error().text().c_str());
        const auto contents = builtVtkReader().probe(path, {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->timeSteps, (std::vector<double>{0.5, 1.5}));
        QCOMPARE(takenOf(contents->taken), takenOf(first->source.taken));
        QVERIFY(!contents->arrays.empty());
    }

    void filesOfOneTimeAreParts()
    {
        const auto path = folder_.write(
            "parts.pvd", pvd(dataSet("0", "mesh.vtu", "part=\"0\"") + dataSet("0", "a.vti", "name=\"box\"")));
        const auto contents = builtVtkReader().probe(path, {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->blocks, (std::vector<std::string>{"mesh.vtu", "box"}));
        const auto all = builtVtkReader().read(path, {}, {});
        QVERIFY2(all.ok(), all.ok() ? "" : all.error().text().c_str());
        QCOMPARE(all->tetrahedra->size(), std::size_t(2 + 48));
        QCOMPARE(leftOutOf(all->source.leftOut), QString());
        const auto mesh = builtVtkReader().read(path, {{"part", std::string("mesh.vtu")}}, {});
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->tetrahedra->size(), std::size_t(2));
        QCOMPARE(leftOutOf(mesh->source.leftOut), QString("1 other part is not read: box."));
        const auto box = builtVtkReader().read(path, {{"part", std::string("box")}}, {});
        QVERIFY2(box.ok(), box.ok() ? "" : box.error().text().c_str());
        QCOMPARE(box->values.at(20), 20.);
    }

    void formatsMayDiffer()
    {
        const auto path = folder_.write("kinds.pvd", pvd(dataSet("0", "mesh.vtu") + dataSet("1", "mesh.vtk")));
        for (const std::int64_t step : {1, 2}) {
            const auto mesh = builtVtkReader().read(path, {{"time", step}}, {});
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QCOMPARE(mesh->tetrahedra->size(), std::size_t(2));
        }
    }

    void whatIsWrongIsTold_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* what, const char* name, const QByteArray& content, const char* told) {
            QTest::newRow(what) << QByteArray(name) << content << QByteArray(told);
        };
        row("missing", "a.pvd", pvd(dataSet("0", "no.vti")), "its file 'no.vti' is missing");
        row("above", "a.pvd", pvd(dataSet("0", "below/../../a.vti")), "is not in its folder");
        row("absolute", "a.pvd", pvd(dataSet("0", "/etc/passwd")), "is not in its folder");
        row("above, as JSON", "a.series", "{\"files\": [{\"name\": \"../a.vti\", \"time\": 0}]}",
            "is not in its folder");
        row("no name", "a.pvd", pvd(dataSet("0", "")), "is not in its folder");
        row("no number", "a.pvd", pvd(dataSet("noon", "a.vti")), "the time 'noon'");
        row("infinite", "a.pvd", pvd(dataSet("inf", "a.vti")), "the time 'inf'");
        row("nothing", "a.pvd", pvd(""), "names none");
        row("nothing, as JSON", "a.series", "{\"files\": []}", "names none");
        row("no list", "a.series", "{\"file-series-version\": \"1.0\"}", "no list of 'files'");
        row("no time", "a.series", "{\"files\": [{\"name\": \"a.vti\", \"time\": \"1\"}]}", "file number 1");
        row("cut", "a.series", "{\"files\": [{\"name\": \"a.vti\"", "its JSON breaks at byte");
        row("cut XML", "a.pvd", pvd(dataSet("0", "a.vti")).chopped(12), "its XML ends or breaks");
        row("itself", "a.pvd", pvd(dataSet("0", "a.pvd")), "its file 'a.pvd'");
        row("twice", "a.pvd", pvd(dataSet("0", "good.vti") + dataSet("0", "good.vti")), "twice for one time");
        row("another format", "a.pvd", pvd(dataSet("0", "letter.txt")), "not of VTK's own formats");
        row("a cut file", "a.pvd", pvd(dataSet("0", "cut.vti")), "its file 'cut.vti'");
    }
    void whatIsWrongIsTold()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, told);
        folder_.write("letter.txt", "Dear reader");
        folder_.write("good.vti", vtiText());
        folder_.write("cut.vti", with(vtiText(), "0 2 0 2 0 2\" Origin", "0 2 0 2 0 9\" Origin"));
        const auto dataset = builtVtkReader().read(folder_.write(name, content), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find(told.toStdString()) != std::string::npos, dataset.error().text().c_str());
    }

private:
    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkSeriesTest)
#include "vtk_series_test.moc"
