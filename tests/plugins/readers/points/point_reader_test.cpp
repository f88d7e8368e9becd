// SPDX-License-Identifier: GPL-3.0-or-later
/// R1, S20: tables of points are read whatever separates them, or refused with the line.
#include "plugins/host/file_saving.h"
#include "plugins/readers/points/point_reader.h"
#include "plugins/readers/points/point_table.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/plugins_of_this_build.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <random>

using namespace tetra;

namespace {

QString mistakeIn(const QByteArray& text, const PointTableRequest& request = {"automatic", "automatic", false})
{
    const auto table = readPointTable(std::string_view(text.data(), std::size_t(text.size())), request);
    return table ? QString() : QString::fromStdString(table.error().text());
}

} // namespace

class PointReaderTest : public QObject {
    Q_OBJECT

private:
    Result<Dataset> read(const QByteArray& content, const ParameterValues& values = {}, const char* name = "points.csv")
    {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(path));
        file.close();
        return asLoaded<PointReader>().read(path.toStdString(), values, {});
    }

    QTemporaryDir folder_;

private slots:
    void columnsAreProbed()
    {
        QVERIFY(read("T,x,y,z,p\n1,2,3,4,5\n"));
        const auto path = folder_.filePath("points.csv").toStdString();
        const auto contents = asLoaded<PointReader>().probe(path, {}, {});
        QVERIFY(contents);
        QCOMPARE(contents->domain, std::optional(DomainClass::Scattered));
        QCOMPARE(contents->arrays.size(), std::size_t(2));
        QCOMPARE(contents->arrays[0].name, std::string("T"));
        QCOMPARE(contents->arrays[1].name, std::string("p"));
        const auto others = asLoaded<PointReader>().probe(path, {{"positions", std::string("1,3,4")}}, {});
        QVERIFY(others);
        QCOMPARE(others->arrays[0].name, std::string("x"));
        QVERIFY(!asLoaded<PointReader>().probe(path, {{"array", std::string("q")}}, {}));
        QVERIFY(!read("a,b\n1,2\n"));
        QVERIFY(!asLoaded<PointReader>().probe(path, {}, {}));
    }

    void allKindsOfTablesAreRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("names") << QByteArray("x,y,z,t\n1,2,3,10\n4,5,6,20\n") << QByteArray("t");
        QTest::newRow("no names") << QByteArray("1,2,3,10\n4,5,6,20") << QByteArray("");
        QTest::newRow("other order, units") << QByteArray("T (K),z_m,X [m],y\n10,3,1,2\n20,6,4,5\n") << QByteArray("T");
        QTest::newRow("ParaView") << QByteArray("\"Temp\",\"Points:0\",\"Points:1\",\"Points:2\"\n10,1,2,3\n20,4,5,6\n")
                                  << QByteArray("Temp");
        QTest::newRow("unknown names") << QByteArray("lon,lat,depth,magnitude\n1,2,3,10\n4,5,6,20\n")
                                       << QByteArray("magnitude");
        QTest::newRow("tabs") << QByteArray("x\ty\tz\tv\r\n1\t2\t3\t10\r\n4\t5\t6\t20\r\n") << QByteArray("v");
        QTest::newRow("semicolons, blanks")
            << QByteArray(" x ; y ; z ; v \n 1 ; 2 ; 3 ; 10 \n4;5;6;20\n") << QByteArray("v");
        QTest::newRow("blanks") << QByteArray("  1 2   3 10\n4  5 6\t20  \n") << QByteArray("");
        QTest::newRow("comments, empty lines")
            << QByteArray("# made by hand\n\n// x\n1,2,3,10\n% no\n\n4,5,6,20\n\n") << QByteArray("");
        QTest::newRow("names in a comment") << QByteArray("# y x z v\n2 1 3 10\n5 4 6 20\n") << QByteArray("v");
        QTest::newRow("quotes") << QByteArray("\"x\",y,z,\"a \"\"b\"\", c\"\n\"1\",2,\"3\",10\n4,5,6,\"20\"\n")
                                << QByteArray("a \"b\", c");
        QTest::newRow("byte-order mark, CR")
            << QByteArray("\xef\xbb\xbfx,y,z,v\r1,2,3,10\r4,5,6,20\r") << QByteArray("v");
        QTest::newRow("exponents, signs") << QByteArray("+1e0,0.2e1,3.,1E1\n4,5,6,20\n") << QByteArray("");
        QTest::newRow("more columns") << QByteArray("x,y,z,v,name\n1,2,3,10,a\n4,5,6,20,b\n") << QByteArray("v");
    }
    void allKindsOfTablesAreRead()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, name);
        const auto dataset = read(text);
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->source.valueName, name.toStdString());
        QCOMPARE(dataset->domain, DomainClass::Scattered);
        QCOMPARE(dataset->pointCount(), std::uint64_t(2));
        QCOMPARE(dataset->position(0), Eigen::Vector3d(1, 2, 3));
        QCOMPARE(dataset->position(1), Eigen::Vector3d(4, 5, 6));
        QCOMPARE(dataset->values.at(0), 10.0);
        QCOMPARE(dataset->values.at(1), 20.0);
        QVERIFY(dataset->remarks.empty());
    }

    void columnsCanBeChosen()
    {
        const QByteArray text = "a,b,c,d,e\n1,2,3,4,5\n";
        const auto byName = read(text, {{"positions", std::string("c,b,a")}, {"array", std::string("E")}});
        QCOMPARE(byName->position(0), Eigen::Vector3d(3, 2, 1));
        QCOMPARE(byName->values.at(0), 5.0);
        const auto byNumber = read(text, {{"positions", std::string("2, 3, 4")}, {"array", std::string("1")}});
        QCOMPARE(byNumber->position(0), Eigen::Vector3d(2, 3, 4));
        QCOMPARE(byNumber->values.at(0), 1.0);
        const auto first = read(text, {{"positions", std::string("2,3,4")}});
        QCOMPARE(first->values.at(0), 1.0);
    }

    void badTablesAreRefusedWithTheLine_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("reason");
        QTest::newRow("empty") << QByteArray() << "holds no points";
        QTest::newRow("names only") << QByteArray("x,y,z,v\n") << "holds no points";
        QTest::newRow("three columns") << QByteArray("x,y,z\n1,2,3\n") << "has 3 columns";
        QTest::newRow("short line") << QByteArray("x,y,z,v\n1,2,3,4\n1,2,3\n") << "line 3 has 3 columns";
        QTest::newRow("text") << QByteArray("x,y,z,v\n#\n1,2,3,hot\n") << "line 3, v: 'hot' is not a finite number";
        QTest::newRow("nan") << QByteArray("1,2,3,4\n1,2,nan,4\n") << "line 2, column 3: 'nan' is not a finite number";
        QTest::newRow("infinite") << QByteArray("x,y,z,v\n1,2,3,1e999\n") << "line 2, v: '1e999'";
        QTest::newRow("missing") << QByteArray("x,y,z,v\n1,2,,4\n") << "line 2, z: a number is missing";
        QTest::newRow("decimal comma") << QByteArray("x;y;z;v\n1,5;2;3;4\n")
                                       << "line 2, x: '1,5' is not a number. "
                                          "Numbers need a decimal point";
        QTest::newRow("open quote") << QByteArray("x,y,z,v\n1,2,3,\"4\n") << "line 2 has a double quote";
        QTest::newRow("huge") << QByteArray("x,y,z,v\n1e200,2,3,4\n") << "too large for a position";
        QTest::newRow("binary") << QByteArray("x,y\0,z,v\n", 9) << "is not text";
        QTest::newRow("chemical") << QByteArray("3\nwater 1 2 3 4\nO 0 0 0\nH 0 1 0\nH 1 0 0\n")
                                  << "is a chemical structure";
        QTest::newRow("chemical, no comment")
            << QByteArray(" 60\r\n\r\n  Cl1  0.1 -2 3e0 0.5\r\n") << "is a chemical structure";
        QTest::newRow("one number") << QByteArray("7") << "has 1 column";
        QTest::newRow("nothing but separators") << QByteArray(",,,\n,,,\n") << "line";
        QTest::newRow("two points in a number") << QByteArray("1.2.3,4,5,6\n") << "1.2.3";
        QTest::newRow("a page of the web") << QByteArray("<html><body a=\"b\">\n<p>1,2,3,4</p>\n") << "column";
        QTest::newRow("a megabyte of digits") << QByteArray("x,y,z,v\n1,2,3,") + QByteArray(1 << 20, '9') << "99...'";
        QTest::newRow("control characters") << QByteArray("x,y,z,v\n1,2,3,\x1b[2J\n") << "'\\x1b[2J'";
        QTest::newRow("a name that controls terminals")
            << QByteArray("x,y,z,\x1bt\n1,2,3,hot\n") << "line 2, \\x1bt: 'hot'";
        QTest::newRow("UTF-16") << QByteArray("\xff\xfex\0,\0", 6) << "UTF-16";
        QTest::newRow("names without end") << "x,y,z" + QByteArray(",v").repeated(65'534) + "\n1,2,3\n"
                                           << "line 1 has 65537 columns, and at most 65536 are read";
        QTest::newRow("a row without end") << "x,y,z,v\n1,2,3" + QByteArray(",4").repeated(65'534) + "\n"
                                           << "line 2 has 65537 columns";
        QTest::newRow("a name without end") << "x,y,z," + QByteArray((16 << 20) + 1, 'v') + "\n1,2,3,4\n"
                                            << "line 1 or a comment before it is longer than 16777216 bytes";
        QTest::newRow("a comment without end") << "#" + QByteArray((16 << 20) + 1, 'v') + "\n1,2,3,4\n"
                                               << "line 2 or a comment before it";
    }
    void badTablesAreRefusedWithTheLine()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, reason);
        QVERIFY2(mistakeIn(text).contains(reason), qPrintable(mistakeIn(text)));
    }

    void wrongColumnsAreRefused()
    {
        const QByteArray text = "x,y,z,v\n1,2,3,4\n";
        QVERIFY(mistakeIn(text, {"x,y", "automatic", false}).contains("does not name the three columns"));
        QVERIFY(mistakeIn(text, {"x,y,x", "automatic", false}).contains("the same column twice"));
        QVERIFY(mistakeIn(text, {"x,y,w", "automatic", false}).contains("there is no column 'w'; there are 'x', 'y'"));
        QVERIFY(mistakeIn(text, {"automatic", "5", false}).contains("there is no column '5'"));
    }

    void incompleteRowsCanBeSkipped()
    {
        const auto dataset = read("x,y,z,v\n1,2,3,NA\n4,5,6,7\n,,,\n", {{"skip-incomplete", true}});
        QVERIFY(dataset.ok());
        QCOMPARE(dataset->pointCount(), std::uint64_t(1));
        QCOMPARE(dataset->remarks.size(), std::size_t(1));
        QCOMPARE(dataset->remarks[0].text(), std::string("2 incomplete rows were skipped."));
    }

    /// C10
    void pointsWithoutAFiniteValueAreLeftOut()
    {
        const auto dataset = read("x,y,z,v\n1,2,3,nan\n4,5,6,7\n0,0,0,-inf\n");
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), std::uint64_t(1));
        QCOMPARE(dataset->remarks.size(), std::size_t(1));
        QCOMPARE(dataset->remarks[0].text(), std::string("2 points without a finite value were left out."));
        const auto none = read("x,y,z,v\n1,2,3,nan\n");
        QVERIFY(!none.ok());
        QVERIFY2(none.error().text().find("none of its values") != std::string::npos, none.error().text().c_str());
    }

    void pointsOnOnePlaceAreMergedAndTold()
    {
        const auto dataset = read("1,2,3,10\n4,5,6,7\n1,2,3,10\n4,5,6,8\n0,0,0,1\n-0,0,0,1\n4,5,6,9\n");
        QVERIFY(dataset.ok());
        QCOMPARE(dataset->pointCount(), std::uint64_t(3));
        QCOMPARE(dataset->values.at(0), 10.0);
        QCOMPARE(dataset->values.at(1), 8.0);
        QCOMPARE(dataset->remarks.size(), std::size_t(1));
        QCOMPARE(dataset->remarks[0].text(), std::string("4 points at the same place as another were merged with it. 1 "
                                                         "place had several different values and got their mean."));
    }

    void numbersDoNotFollowTheLocale()
    {
        const char* before = std::setlocale(LC_ALL, "de_DE.UTF-8");
        const auto dataset = read("1.5,2,3,4.25\n");
        std::setlocale(LC_ALL, "C");
        if (before == nullptr)
            QSKIP_WITHOUT("locale de_DE.UTF-8");
        QCOMPARE(dataset->position(0), Eigen::Vector3d(1.5, 2, 3));
        QCOMPARE(dataset->values.at(0), 4.25);
    }

    void filesAreKnownByNameAndContent()
    {
        const Reader& reader = asLoaded<PointReader>();
        const auto score = [&](const char* name, const QByteArray& text) {
            return reader.score(name, std::as_bytes(std::span(text.data(), std::size_t(text.size()))));
        };
        QCOMPARE(score("a.csv", "x,y,z,v\n1,2,3,4\n"), 1.0);
        QVERIFY(score("a.CSV", "nonsense") > 0.5);
        QVERIFY(score("a.txt", "1 2 3 4\n") > 0.5);
        QCOMPARE(score("a.txt", "Dear reader\n"), 0.0);
        QCOMPARE(score("a.dat", QByteArray("1 2 3 4\0", 8)), 0.0);
    }

    /// What the writer writes is the same dataset again, bit for bit.
    void writtenTablesComeBack()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> number(-1e3, 1e3);
        QByteArray text;
        for (int i = 0; i < 500; ++i) {
            for (int column = 0; column < 4; ++column)
                text += QByteArray::number(number(random) * std::pow(10.0, i % 30 - 15), 'g', 17) + ",";
            text.back() = '\n';
        }
        const auto dataset = read(text);
        QVERIFY(dataset.ok());
        const std::filesystem::path path = folder_.filePath("written.csv").toStdString();
        QVERIFY(saveDataset(pluginsOfThisBuild(), *dataset, path).ok());
        const auto again = asLoaded<PointReader>().read(path, {}, {});
        QVERIFY(again.ok());
        QVERIFY(*again->positions == *dataset->positions);
        QCOMPARE(again->source.hash, dataset->source.hash);
    }

    void mutatedTablesAreReadOrRefused()
    {
        const QByteArray valid = "\"x\",y,z,\"v, w\"\n# c\n1.5,2e3,\"-3\",4\r\n5, 6,7\t,8\n9,10,11,12\n";
        const QByteArray characters("\"\n\r,;\t #%/.-+e0\0\xff"
                                    "1n",
                                    19);
        std::mt19937 random(1);
        int read = 0;
        for (int attempt = 0; attempt < 30000; ++attempt) {
            QByteArray text = valid;
            for (unsigned change = random() % 6; change > 0; --change) {
                const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(text.size()));
                if (random() % 4 == 0)
                    text.remove(at, static_cast<qsizetype>(random() % 12));
                else
                    text[at] = characters[static_cast<qsizetype>(random() % 19)];
                if (text.isEmpty())
                    break;
            }
            const std::string_view view(text.data(), std::size_t(text.size()));
            const auto table = readPointTable(view, {"automatic", "automatic", attempt % 2 == 0});
            if (table) {
                ++read;
                QCOMPARE(table->positions.size(), table->values.size());
                QVERIFY(!table->values.empty());
            } else {
                QVERIFY(!table.error().text().empty());
            }
        }
        QVERIFY(read > 1000);
    }

    void realTablesAreRead_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("points");
        QTest::newRow("probes") << "forge_probes.csv" << 245;
        QTest::newRow("quakes") << "fiji_quakes.csv" << 1000;
        QTest::newRow("disk") << "disk_out_ref_points.csv" << 8499;
    }
    void realTablesAreRead()
    {
        QFETCH(QString, file);
        QFETCH(int, points);
        const QString path = TAN_SOURCE_DIR "/../shared/data/scattered/" + file;
        if (!QFile::exists(path))
            QSKIP_WITHOUT("data");
        const auto dataset = asLoaded<PointReader>().read(path.toStdString(), {}, {});
        QVERIFY(dataset.ok());
        QCOMPARE(dataset->pointCount(), std::uint64_t(points));
        QVERIFY(dataset->remarks.empty());
    }
};

QTEST_GUILESS_MAIN(PointReaderTest)
#include "point_reader_test.moc"
