// SPDX-License-Identifier: GPL-3.0-or-later
/// Files that are packed as a whole open like what is in them, or the text says what to do; where a reader cannot work,
/// another one does; and a lack of files is told as that.
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/input_file.h"
#include "plugins/host/packed_file.h"
#include "plugins/samples/samples.h"
#include "tests/plugins/host/gzipped.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;

namespace {

namespace fs = std::filesystem;

/// With the folder that it is in, which goes with it.
std::optional<std::pair<UnpackedFiles, fs::path>> unpackedFile(const fs::path& packed)
{
    const auto folder = UnpackedFiles::make(packed);
    const auto file = folder ? folder->unpack(packed, "file", {}) : Result<fs::path>(folder.error());
    return file ? std::optional(std::pair(*folder, *file)) : std::nullopt;
}

const QByteArray pointTable = "x,y,z,heat\n0,0,0,1\n1,0,0,2\n0,1,0,3\n0,0,1,4\n1,1,1,5\n";

} // namespace

class PackedFileTest : public QObject {
    Q_OBJECT

private:
    fs::path path(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    fs::path write(const std::string& name, const QByteArray& bytes) const
    {
        QFile file(QString::fromStdString(path(name).string()));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write a test file");
        return path(name);
    }
    QByteArray nrrd() const
    {
        const auto saved = saveDataset(
            *host_, *makeSample({.name = "noise", .size = 8, .type = std::nullopt, .seed = 1}), path("noise.nrrd"));
        QFile file(QString::fromStdString(path("noise.nrrd").string()));
        return saved && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Folders of unpacked files that were left.
    static std::ptrdiff_t left()
    {
        return std::ranges::count_if(fs::directory_iterator(fs::temp_directory_path()), [](const auto& entry) {
            return entry.path().filename().string().starts_with("tan-unpacked-");
        });
    }

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;

private slots:
    void initTestCase()
    {
        qputenv("TMPDIR", folder_.path().toUtf8()); // of this test's own
        host_ = PluginHost::standard();
    }
    void cleanup() { QCOMPARE(left(), 0); }

    void whatAKilledProgramUnpackedIsRemoved()
    {
        const fs::path packed = write("killed.csv.gz", gzipped(pointTable));
        const pid_t killed = fork();
        if (killed == 0) {
            const auto unpacked = unpackedFile(packed);
            raise(SIGKILL);
        }
        QCOMPARE(waitpid(killed, nullptr, 0), killed);
        QCOMPARE(left(), 1); // or there is nothing to remove
        const fs::path mine = fs::temp_directory_path() / "tan-unpacked-letter";
        fs::create_directory(mine);
        {
            const auto first = unpackedFile(packed);
            QVERIFY(first);
            const auto second = unpackedFile(packed);
            QVERIFY(second && fs::exists(first->second));
            QCOMPARE(left(), 3);
        }
        QVERIFY(fs::remove(mine));
    }

    void whatIsInItIsRead_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("reader");
        QTest::newRow("table") << pointTable << "points.csv"
                               << "points";
        QTest::newRow("volume") << nrrd() << "noise.nrrd"
                                << "lattice";
        QTest::newRow("no such name, but a signature") << nrrd() << "noise"
                                                       << "lattice";
    }
    void whatIsInItIsRead()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, name);
        QFETCH(QString, reader);
        const auto plain = openDataset(*host_, write("plain-" + name.toStdString(), content));
        QVERIFY2(plain, plain ? "" : plain.error().text().c_str());
        const fs::path packed = write(name.toStdString() + ".gz", gzipped(content));
        const auto chosen = chooseReader(*host_, packed);
        QVERIFY2(chosen, chosen ? "" : chosen.error().text().c_str());
        QCOMPARE(QString::fromStdString(chosen->id), reader);
        const auto read = openDataset(*host_, packed);
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(std::ranges::equal(read->values.bytes(), plain->values.bytes()));
        QCOMPARE(read->source.hash, plain->source.hash);
        QCOMPARE(read->source.path, packed);
        QVERIFY(probeDataset(*host_, packed));
        const auto named = openDataset(*host_, packed, {.reader = reader.toStdString()});
        QVERIFY2(named, named ? "" : named.error().text().c_str());
    }

    /// Samples that would stay in their file outlive it.
    void samplesThatStayInTheirFileCanBeRead()
    {
        const QByteArray samples(64 * 64 * 64, '\7');
        const ImportOptions options{.reader = "lattice", .values = {{"size", std::string("64x64x64")}}};
        const auto read = openDataset(*host_, write("cube.raw.gz", gzipped(samples)), options);
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(left(), 0);
        QCOMPARE(read->values.at(64 * 64 * 64 - 1), 7.);
        QVERIFY(read->checkIntact());
    }

    void damagedOnesAreRefused()
    {
        const QByteArray packed = gzipped(pointTable);
        for (qsizetype size = 3; size < packed.size(); ++size) {
            const auto read = openDataset(*host_, write("cut.csv.gz", packed.left(size)));
            QVERIFY2(!read, qPrintable(QString::number(size)));
            QCOMPARE(read.error().kind, ErrorKind::BadInput);
            QVERIFY2(read.error().text().find("cut.csv.gz") != std::string::npos, read.error().text().c_str());
        }
        QByteArray changed = gzipped(nrrd());
        changed[changed.size() - 6] = static_cast<char>(changed[changed.size() - 6] + 1); // of its checksum
        const auto read = openDataset(*host_, write("changed.nrrd.gz", changed));
        QVERIFY(!read);
        QVERIFY2(read.error().text().find("damaged or cut short") != std::string::npos, read.error().text().c_str());
    }

    void anErrorNamesTheFileThatTheUserHas()
    {
        const auto read = openDataset(*host_, write("bad.csv.gz", gzipped("x,y,z,v\n1,2,3,4\n1,2,three,4\n")));
        QVERIFY(!read);
        QVERIFY2(read.error().text().find("bad.csv.gz'") != std::string::npos, read.error().text().c_str());
        QVERIFY2(read.error().text().find("tan-unpacked") == std::string::npos, read.error().text().c_str());
    }

    void unpackingCanBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto read =
            openDataset(*host_, write("points.csv.gz", gzipped(pointTable)), {}, Progress(stop.get_token(), {}));
        QVERIFY(!read);
        QCOMPARE(read.error().kind, ErrorKind::Cancelled);
    }

    void withoutRoomItSaysWhatToDo()
    {
        qputenv("TMPDIR", "/nowhere");
        const auto read = openDataset(*host_, write("points.csv.gz", gzipped(pointTable)));
        qputenv("TMPDIR", folder_.path().toUtf8());
        QVERIFY(!read);
        QCOMPARE(read.error().kind, ErrorKind::CannotWrite);
        QVERIFY2(read.error().text().find("TMPDIR") != std::string::npos, read.error().text().c_str());
    }

    void whatIsUnknownIsToldInASentence_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("told");
        QTest::newRow("a letter") << "letter.odt" << QByteArray("Dear Sir") << "has an unknown format";
        QTest::newRow("a packed letter") << "letter.odt.gz" << gzipped("Dear Sir") << "has an unknown format";
        QTest::newRow("what is read instead") << "letter.odt" << QByteArray("Dear Sir") << ".nrrd";
        QTest::newRow("a picture") << "photo.png" << QByteArray("\x89PNG\r\n") << "is a picture";
        QTest::newRow("a picture by another name") << "photo.tmp" << QByteArray("\xff\xd8\xff\xe0") << "is a picture";
        QTest::newRow("a surface") << "part.stl" << QByteArray(84, '\0') << "holds a surface";
        QTest::newRow("a surface in text") << "PART.OBJ" << QByteArray("v 0 0 0\n") << "holds a surface";
        QTest::newRow("MINC") << "brain.mnc" << QByteArray("CDF\1....") << "'mnc2nii'";
        QTest::newRow("FreeSurfer") << "brain.MGZ" << gzipped("brain") << "'mri_convert'";
        QTest::newRow("AVS") << "flow.fld" << QByteArray("# AVS field file\n") << "an AVS field";
        QTest::newRow("OpenVDB") << "smoke.vdb" << QByteArray(" BDV\0\0\0", 7) << "OpenVDB";
        QTest::newRow("Amira") << "cell.am" << QByteArray("# AmiraMesh\n") << "Amira";
        QTest::newRow("MATLAB") << "array.mat" << QByteArray("MATLAB 5.0 MAT-file") << "niftiwrite";
        QTest::newRow("a microscope's") << "cells.czi" << QByteArray("ZISRAWFILE") << "OME-TIFF";
        QTest::newRow("xz") << "a.vti.xz"
                            << QByteArray("\xfd"
                                          "7zXZ\0\0\4",
                                          8)
                            << "'unxz'";
        QTest::newRow("bzip2") << "a.vti.bz2" << QByteArray("BZh91AY&SY") << "'bunzip2'";
        QTest::newRow("zstd") << "a.vti.zst" << QByteArray("\x28\xb5\x2f\xfd....") << "'unzstd'";
        QTest::newRow("zip") << "all.zip" << QByteArray("PK\3\4......") << "'unzip'";
        QTest::newRow("tar") << "all.tar" << QByteArray("a.vti").leftJustified(257, '\0') + "ustar"
                             << "'tar -xf'";
    }
    void whatIsUnknownIsToldInASentence()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, told);
        const auto read = openDataset(*host_, write(name.toStdString(), content));
        QVERIFY(!read);
        QCOMPARE(read.error().kind, ErrorKind::BadInput);
        const QString text = QString::fromStdString(read.error().text());
        QVERIFY2(text.contains(told) && text.contains(name), qPrintable(text));
        QVERIFY2(text.size() < 300 + folder_.path().size() && !text.contains("*."), qPrintable(text));
    }

    void tooManyFilesAreToldAsThat()
    {
        const fs::path file = write("points.csv", pointTable);
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_NOFILE, &before), 0);
        const rlimit few{3, before.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &few);
        const auto bytes = firstBytesOf(file);
        ::setrlimit(RLIMIT_NOFILE, &before);
        QVERIFY(!bytes);
        QCOMPARE(bytes.error().kind, ErrorKind::OutOfResource);
    }

    /// Meshes in .vtu are read without VTK, also where its helper program cannot start.
    void meshesNeedNoVtk()
    {
        const fs::path built = fs::path(TAN_BINARY_DIR) / "lib/tan/plugins";
        if (!fs::exists(built / "libtan-reader-vtk.so"))
            QSKIP("skipped: no such plugin here");
        const fs::path plugins = path("plugins");
        fs::create_directory(plugins);
        for (const char* name : {"libtan-reader-vtk.so", "libtan-reader-cells.so"})
            fs::copy_file(built / name, plugins / name);
        write("plugins/tan-read-vtk", "\x7f"
                                      "ELF, as it were");
        fs::permissions(plugins / "tan-read-vtk", fs::perms::owner_all);
        PluginHost host({.folders = {plugins}});
        const fs::path mesh = write(
            "mesh.vtu",
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">"
            "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><PointData Scalars=\"a\">"
            "<DataArray type=\"Float64\" Name=\"a\" format=\"ascii\">1 2 3 4</DataArray></PointData><Points>"
            "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 "
            "1</DataArray></Points>"
            "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
            "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
            "<DataArray type=\"UInt8\" Name=\"types\" "
            "format=\"ascii\">10</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n");
        const auto chosen = chooseReader(host, mesh);
        QVERIFY2(chosen, chosen ? "" : chosen.error().text().c_str());
        QCOMPARE(chosen->id, std::string("cells"));
        const auto read = openDataset(host, mesh);
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(read->pointCount(), std::uint64_t(4));
    }
};

QTEST_GUILESS_MAIN(PackedFileTest)
#include "packed_file_test.moc"
