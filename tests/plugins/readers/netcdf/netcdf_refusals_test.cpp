// SPDX-License-Identifier: GPL-3.0-or-later
// NetCDF files that cannot be read are refused with the true reason; cut and damaged ones never give other values than
// the whole (S6, S20).
#include "plugins/readers/netcdf/classic_check.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/netcdf/netcdf_test_files.h"

#include <QFile>
#include <QTest>

#include <random>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

QByteArray contentOf(const fs::path& path)
{
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeContent(const fs::path& path, const QByteArray& content)
{
    QFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write a test file");
}

/// Coordinates and a variable at two times.
void writeGood(const fs::path& path, int mode)
{
    NetCdfTestFile file(path, mode);
    const int t = file.dimension("time", 0), z = file.dimension("z", 3), y = file.dimension("y", 3),
              x = file.dimension("x", 4);
    file.add("z", {z}, std::vector<double>{0, 1, 3}, "m");
    file.add("q", {t, z, y, x}, steps<float>(72, 1, 1), "K");
}

} // namespace

class NetCdfRefusalsTest : public QObject {
    Q_OBJECT

private slots:
    void reasonsAreTrue_data()
    {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("words");
        QTest::newRow("not NetCDF") << 0 << "does not begin like a NetCDF file";
        QTest::newRow("two dimensions") << 1 << "'sst' (time, lat, lon)";
        QTest::newRow("one level") << 2 << "'t' (level, lat, lon)";
        QTest::newRow("text") << 3 << "'names' (z, y, x)";
        QTest::newRow("UGRID") << 4 << "conventions UGRID";
        QTest::newRow("MPAS") << 5 << "conventions MPAS";
        QTest::newRow("no time step") << 6 << "nothing was written along its dimension 'time'";
        QTest::newRow("coordinates alone") << 7 << "no variables other than coordinates";
        QTest::newRow("empty") << 8 << "it is empty";
    }
    void reasonsAreTrue()
    {
        QFETCH(int, which);
        QFETCH(QString, words);
        const fs::path path = folder_.path("refused.nc");
        write(path, which);
        for (const bool probes : {false, true}) {
            const std::string text = probes ? errorOf(builtNetCdfReader().probe(path, {}, {}))
                                            : errorOf(builtNetCdfReader().read(path, {}, {}));
            QVERIFY2(text.find(words.toStdString()) != std::string::npos, text.c_str());
            QVERIFY2(which == 0 || text.find("damaged") == std::string::npos, text.c_str());
        }
    }

    void withoutTheProgramItSaysWhatToInstall()
    {
        const NetCdfReader reader(folder_.path("tan-read-netcdf"));
        writeGood(folder_.path("good.nc"), NC_64BIT_OFFSET);
        const auto dataset = reader.read(folder_.path("good.nc"), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("libnetcdf-dev") != std::string::npos, dataset.error().text().c_str());
    }

    void filesAreKnownByTheirBeginningAndName()
    {
        const auto score = [](const char* name, const QByteArray& start) {
            return builtNetCdfReader().score(name,
                                             std::as_bytes(std::span(start.constData(), std::size_t(start.size()))));
        };
        const QByteArray hdf5("\x89HDF\r\n\x1a\n", 8);
        QVERIFY(score("any name", QByteArray("CDF\1", 4)) > 0.8);
        QVERIFY(score("wrfout_d01_2000-01-01", QByteArray("CDF\2", 4)) > 0.8);
        QVERIFY(score("a.nc", hdf5) > 0.6 && score("MESH.EXO", hdf5) > 0.6 && score("wrfout_d01", hdf5) > 0.6);
        QCOMPARE(score("a.h5", hdf5), 0.);
        QVERIFY(score("a.h5", hdf5 + "_NCProperties") > 0.65); // more than the reader of arrays in HDF5
        QVERIFY(score("a.g", "PLOT3D?") < 0.2);
        QCOMPARE(score("a.csv", "x,y,z"), 0.);
    }

    /// Wherever a file is cut: the same values, or a refusal.
    void cutFiles_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("classic") << 0;
        QTest::newRow("64-bit offset") << NC_64BIT_OFFSET;
        QTest::newRow("CDF-5") << NC_64BIT_DATA;
        QTest::newRow("NetCDF-4") << NC_NETCDF4;
    }
    void cutFiles()
    {
        QFETCH(int, mode);
        const fs::path path = folder_.path("cut.nc");
        writeGood(path, mode);
        const auto whole = builtNetCdfReader().read(path, {}, {});
        QVERIFY2(whole.ok(), whole.ok() ? "" : whole.error().text().c_str());
        const QByteArray content = contentOf(path);
        int checked = 0;
        for (qsizetype place = content.size() - 1; mode != NC_NETCDF4 && place > 0; --place, ++checked) {
            writeContent(path, content.left(place));
            QVERIFY2(!checkClassicNetCdf(path).ok() || !isClassicNetCdf(bytesOf(content.left(place))),
                     qPrintable(QString::number(place)));
        }
        for (int part = 1; part < 8; ++part) {
            writeContent(path, content.left(content.size() * part / 8));
            const auto read = builtNetCdfReader().read(path, {}, {});
            if (read)
                QVERIFY(std::ranges::equal(read->values.bytes(), whole->values.bytes()));
            else
                QVERIFY2(read.error().text().find("cut.nc") != std::string::npos, read.error().text().c_str());
        }
        QVERIFY(mode == NC_NETCDF4 || checked > 400);
    }

    /// Bytes of the header changed: an error or a dataset, and no crash that is not told as one.
    void damagedFiles()
    {
        std::mt19937 random(7);
        const fs::path path = folder_.path("damaged.nc");
        for (const int mode : {NC_64BIT_OFFSET, NC_NETCDF4}) {
            writeGood(path, mode);
            const QByteArray content = contentOf(path);
            std::uniform_int_distribution<int> place(4, std::min(900, int(content.size()) - 1));
            for (int change = 0; change < 12; ++change) {
                QByteArray changed = content;
                for (int byte = 0; byte < 3; ++byte)
                    changed[place(random)] = static_cast<char>(random());
                writeContent(path, changed);
                const auto read = complete(builtNetCdfReader().read(path, {}, {}));
                if (read)
                    QVERIFY(read->pointCount() > 0 && read->values.notFiniteCount() == 0);
                else
                    QVERIFY2(read.error().text().find("damaged.nc") != std::string::npos, read.error().text().c_str());
            }
        }
    }

    /// A dimension of more points than there are is no reason to take their memory.
    void hostileSizes()
    {
        const fs::path path = folder_.path("huge.nc");
        {
            NetCdfTestFile file(path, NC_NETCDF4);
            const int z = file.dimension("z", 100'000), y = file.dimension("y", 100'000),
                      x = file.dimension("x", 100'000);
            file.define("q", NC_DOUBLE, {z, y, x});
        }
        const auto read = builtNetCdfReader().read(path, {}, {});
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find("damaged") == std::string::npos, read.error().text().c_str());
    }

private:
    static std::span<const std::byte> bytesOf(const QByteArray& content)
    {
        return std::as_bytes(std::span(content.constData(), std::size_t(content.size())));
    }
    template <class Value> static std::string errorOf(const Result<Value>& result)
    {
        return result ? "" : result.error().text();
    }

    static void write(const fs::path& path, int which)
    {
        if (which == 0 || which == 8)
            return writeContent(path, which == 0 ? QByteArray("\x89HDD nothing of the kind") : QByteArray());
        NetCdfTestFile file(path);
        if (which == 4) {
            const int one = file.dimension("one", 1), faces = file.dimension("faces", 5);
            file.text(file.add("mesh", {one}, std::vector<int>{0}), "cf_role", "mesh_topology");
            file.add("q", {faces}, steps<float>(5, 0, 1));
        } else if (which == 5) {
            const int cells = file.dimension("nCells", 5), levels = file.dimension("nVertLevels", 3);
            file.dimension("nVertices", 8);
            file.add("q", {cells, levels}, steps<float>(15, 0, 1));
        } else if (which == 6) {
            const int t = file.dimension("time", 0);
            file.define("q", NC_FLOAT, {t, file.dimension("z", 2), file.dimension("y", 2), file.dimension("x", 2)});
        } else if (which == 7) {
            const int x = file.dimension("x", 3);
            file.add("x", {x}, steps<double>(3, 0, 1));
        } else {
            const int t = file.dimension("time", 4), level = file.dimension("level", 1), z = file.dimension("z", 2),
                      y = file.dimension(which == 3 ? "y" : "lat", 3), x = file.dimension(which == 3 ? "x" : "lon", 5);
            if (which == 1)
                file.add("sst", {t, y, x}, steps<float>(60, 0, 1));
            else if (which == 2)
                file.add("t", {level, y, x}, steps<float>(15, 0, 1));
            else
                file.add("names", {z, y, x}, std::vector<char>(30, 'a'));
        }
    }

    NetCdfFolder folder_;
};

QTEST_GUILESS_MAIN(NetCdfRefusalsTest)
#include "netcdf_refusals_test.moc"
