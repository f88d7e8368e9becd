// SPDX-License-Identifier: GPL-3.0-or-later
// HDF5 files that cannot be read are refused with the true reason, and at once; no other file is ever opened; cut and
// damaged ones never give other values than the whole (S6, S20).
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/hdf5/hdf5_test_files.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include <random>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

const std::vector<hsize_t> cube = {3, 3, 4};

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

/// Passes bytes on, in the name of a filter that this library does not bring.
std::size_t passOn(unsigned, std::size_t, const unsigned[], std::size_t bytes, std::size_t*, void**)
{
    return bytes;
}

void addFiltered(const Hdf5TestFile& file, H5Z_filter_t number, const char* name)
{
    const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, number, 1, 1, name, nullptr, nullptr, passOn};
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(3, cube.data(), nullptr);
    mustBeDone(H5Zregister(&filter) >= 0 && H5Pset_chunk(creation, 3, cube.data()) >= 0 &&
               H5Pset_filter(creation, number, 0, 0, nullptr) >= 0);
    const hid_t array = H5Dcreate2(file.id(), "/a", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    const auto values = steps<float>(36, 0, 1);
    mustBeDone(array >= 0 && H5Dwrite(array, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    H5Dclose(array);
    H5Sclose(space);
    H5Pclose(creation);
}

} // namespace

class Hdf5RefusalsTest : public QObject {
    Q_OBJECT

private slots:
    void reasonsAreTrue_data()
    {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("words");
        int which = 0;
        for (const char* words :
             {"does not begin like an HDF5 file", "it is empty", "it holds no arrays",
              "'/flat' (12 x 12, float), '/names' (3 x 3 x 4, text)", "nothing was written to its array '/a'",
              "nothing was written to its array '/a' (10000 x 10000 x 10000, double)",
              "only 1 of the 8 chunks of its array '/a' were written, and it has no fill value",
              "packed with the filter Blosc (number 32001)", "packed with the filter own (number 400)",
              "it is a MINC 2 file", "it is a file of CGNS", "it is a file of VTK HDF", "it is a file of NetCDF-4",
              "has fewer than three dimensions of space", "none of its arrays"})
            QTest::newRow(words) << which++ << words;
    }
    void reasonsAreTrue()
    {
        QFETCH(int, which);
        QFETCH(QString, words);
        const fs::path path = folder_.path("refused.h5");
        write(path, which);
        for (const bool probes : {false, true}) {
            const std::string text =
                probes ? errorOf(builtHdf5Reader().probe(path, {}, {})) : errorOf(builtHdf5Reader().read(path, {}, {}));
            QVERIFY2(text.find(words.toStdString()) != std::string::npos, text.c_str());
            QVERIFY2(which == 0 || text.find("damaged") == std::string::npos, text.c_str());
        }
    }

    void withoutTheProgramItSaysWhatToInstall()
    {
        const Hdf5Reader reader(folder_.path("tan-read-hdf5"));
        writeGood(folder_.path("good.h5"));
        const auto dataset = reader.read(folder_.path("good.h5"), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("libhdf5-dev") != std::string::npos, dataset.error().text().c_str());
    }

    void filesAreKnownByTheirBeginning()
    {
        const auto score = [](const char* name, const QByteArray& start) {
            return builtHdf5Reader().score(name,
                                           std::as_bytes(std::span(start.constData(), std::size_t(start.size()))));
        };
        const QByteArray hdf5("\x89HDF\r\n\x1a\n", 8);
        for (const char* name : {"a.h5", "A.HDF5", "a.hdf", "a.nxs", "a.he5"})
            QCOMPARE(score(name, hdf5), 0.65);
        QVERIFY(score("any name", hdf5) > 0.3 && score("a.mat", QByteArray(512, ' ') + hdf5) > 0.6);
        QVERIFY(score("a.hdf", hdf5 + "VTKHDF") < 0.2 && score("a.cgns", hdf5) < 0.5 && score("a.nc", hdf5) < 0.5);
        QCOMPARE(score("a.csv", "x,y,z"), 0.);
    }

    /// Neither links nor the storage of an array lead out of the file.
    void otherFilesAreNeverOpened()
    {
        const fs::path path = folder_.path("leads.h5"), secret = folder_.path("secret.h5"),
                       raw = folder_.path("secret.raw");
        writeGood(secret);
        writeContent(raw, QByteArray(4 * 36, 'x'));
        {
            Hdf5TestFile file(path);
            mustBeDone(H5Lcreate_external(secret.c_str(), "/a", file.id(), "/linked", H5P_DEFAULT, H5P_DEFAULT) >= 0);
            const hid_t external = H5Pcreate(H5P_DATASET_CREATE), virtual_ = H5Pcreate(H5P_DATASET_CREATE);
            const hid_t space = H5Screate_simple(3, cube.data(), nullptr);
            mustBeDone(H5Pset_external(external, raw.c_str(), 0, 4 * 36) >= 0 &&
                       H5Pset_virtual(virtual_, space, secret.c_str(), "/a", space) >= 0);
            H5Dclose(H5Dcreate2(file.id(), "/external", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, external, H5P_DEFAULT));
            H5Dclose(H5Dcreate2(file.id(), "/virtual", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, virtual_, H5P_DEFAULT));
            H5Sclose(space);
            H5Pclose(external);
            H5Pclose(virtual_);
        }
        for (const char* name : {"/external", "/virtual"}) {
            const std::string text = errorOf(builtHdf5Reader().read(path, {{"array", std::string(name)}}, {}));
            QVERIFY2(text.find("lie in other files or arrays, which are not opened") != std::string::npos,
                     text.c_str());
        }
        QVERIFY(!builtHdf5Reader().read(path, {{"array", std::string("/linked")}}, {}).ok());
        QVERIFY(!builtHdf5Reader().read(path, {}, {}).ok());
        {
            Hdf5TestFile file(path);
            mustBeDone(H5Lcreate_external(secret.c_str(), "/a", file.id(), "/linked", H5P_DEFAULT, H5P_DEFAULT) >= 0);
            file.add<float>("/own", cube, steps<float>(36, 0, 1));
        }
        const auto own = builtHdf5Reader().read(path, {}, {});
        QVERIFY2(own.ok(), own.ok() ? "" : own.error().text().c_str());
        QVERIFY(textOf(own->source.leftOut).find("Its links into other files are not followed: '/linked'") !=
                std::string::npos);
    }

    /// Neither sizes in headers, nor nests and rings of groups, are reasons to take memory or time.
    void bombs()
    {
        QElapsedTimer clock;
        clock.start();
        const fs::path path = folder_.path("bomb.h5");
        {
            Hdf5TestFile file(path);
            file.define("/a", {1'000'000, 1'000, 1'000}, {.type = H5T_NATIVE_DOUBLE, .chunk = {1, 8, 8}});
            const hid_t array = H5Dopen2(file.id(), "/a", H5P_DEFAULT);
            const auto chunk = steps<double>(64, 0, 1);
            const hsize_t first[] = {0, 0, 0};
            mustBeDone(H5Dwrite_chunk(array, H5P_DEFAULT, 0, first, 512, chunk.data()) >= 0);
            H5Dclose(array);
        }
        std::string text = errorOf(builtHdf5Reader().read(path, {}, {}));
        QVERIFY2(text.find("of memory, and this machine can spare") != std::string::npos, text.c_str());
        {
            Hdf5TestFile file(path);
            std::string nest;
            for (int depth = 0; depth < 300; ++depth)
                file.group(nest += "/g");
            mustBeDone(H5Lcreate_hard(file.id(), "/", file.id(), (nest + "/top").c_str(), H5P_DEFAULT, H5P_DEFAULT) >=
                       0);
            file.add<float>("/a", cube, steps<float>(36, 0, 1));
        }
        const auto nested = builtHdf5Reader().read(path, {}, {});
        QVERIFY2(nested.ok(), nested.ok() ? "" : nested.error().text().c_str());
        QVERIFY(textOf(nested->source.leftOut).find("groups nested more than 64 levels deep") != std::string::npos);
        QVERIFY(clock.elapsed() < 60'000);
    }

    void checksumsAreHeld()
    {
        const fs::path path = folder_.path("sum.h5");
        writeGood(path);
        QByteArray content = contentOf(path);
        const std::array<float, 3> run = {7, 8, 9};
        const auto at = content.indexOf(QByteArray(reinterpret_cast<const char*>(run.data()), 12));
        QVERIFY(at > 0);
        content[at] = static_cast<char>(content[at] ^ 1);
        writeContent(path, content);
        const std::string text = errorOf(builtHdf5Reader().read(path, {}, {}));
        QVERIFY2(text.find("Fletcher32") != std::string::npos, text.c_str());
    }

    /// Wherever a file is cut or changed: the same values, or a refusal, and no crash that is not told as one.
    void cutAndDamagedFiles()
    {
        const fs::path path = folder_.path("cut.h5");
        writeGood(path);
        const auto whole = builtHdf5Reader().read(path, {}, {});
        QVERIFY2(whole.ok(), whole.ok() ? "" : whole.error().text().c_str());
        const QByteArray content = contentOf(path);
        for (int part = 1; part < 8; ++part) {
            writeContent(path, content.left(content.size() * part / 8));
            const auto read = builtHdf5Reader().read(path, {}, {});
            QVERIFY(!read.ok());
            QVERIFY2(read.error().text().find("cut.h5") != std::string::npos, read.error().text().c_str());
        }
        std::mt19937 random(7);
        std::uniform_int_distribution<int> place(8, int(content.size()) - 1);
        for (int change = 0; change < 12; ++change) {
            QByteArray changed = content;
            for (int byte = 0; byte < 3; ++byte)
                changed[place(random)] = static_cast<char>(random());
            writeContent(path, changed);
            const auto read = complete(builtHdf5Reader().read(path, {}, {}));
            if (read)
                QVERIFY(read->pointCount() > 0 && read->values.notFiniteCount() == 0);
            else
                QVERIFY2(read.error().text().find("cut.h5") != std::string::npos, read.error().text().c_str());
        }
    }

private:
    template <class Value> static std::string errorOf(const Result<Value>& result)
    {
        return result ? "" : result.error().text();
    }

    /// With checksums, one chunk.
    static void writeGood(const fs::path& path)
    {
        Hdf5TestFile file(path);
        const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(3, cube.data(), nullptr);
        mustBeDone(H5Pset_chunk(creation, 3, cube.data()) >= 0 && H5Pset_fletcher32(creation) >= 0);
        const hid_t array = H5Dcreate2(file.id(), "/a", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, creation, H5P_DEFAULT);
        const auto values = steps<float>(36, 0, 1);
        mustBeDone(H5Dwrite(array, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
        H5Dclose(array);
        H5Sclose(space);
        H5Pclose(creation);
    }

    static void write(const fs::path& path, int which)
    {
        if (which < 2)
            return writeContent(path, which == 0 ? QByteArray("\x89HDD nothing of the kind") : QByteArray());
        Hdf5TestFile file(path);
        const Hdf5Storage doubles{.type = H5T_NATIVE_DOUBLE};
        switch (which) {
        case 3: {
            file.add<float>("/flat", {12, 12}, steps<float>(144, 0, 1));
            file.define("/names", cube, {.type = H5T_C_S1});
            break;
        }
        case 4: file.define("/a", cube, doubles); break;
        case 5: file.define("/a", {10'000, 10'000, 10'000}, doubles); break;
        case 6: writePart(file); break;
        case 7: addFiltered(file, 32001, "any name"); break;
        case 8: addFiltered(file, 400, "own"); break;
        case 9: file.group("/minc-2.0"); break;
        case 10: {
            file.group("/ format");
            file.group("/ hdf5version");
            break;
        }
        case 11: file.group("/VTKHDF"); break;
        case 12: file.texts("/", "_NCProperties", {"version=2"}); break;
        case 13: {
            file.add<float>("/pictures", cube, steps<float>(36, 0, 1));
            file.texts("/pictures", "DIMENSION_LABELS", {"time", "y", "x"});
            break;
        }
        case 14: file.add<float>("/one_row", {3, 1, 4}, steps<float>(12, 0, 1)); break;
        default: break;
        }
    }

    static void writePart(Hdf5TestFile& file)
    {
        file.define("/a", {4, 4, 4}, {.type = H5T_NATIVE_FLOAT, .chunk = {2, 2, 2}, .isFilled = false});
        const hid_t array = H5Dopen2(file.id(), "/a", H5P_DEFAULT);
        const auto values = steps<float>(8, 1, 1);
        const hsize_t first[] = {0, 0, 0};
        mustBeDone(H5Dwrite_chunk(array, H5P_DEFAULT, 0, first, 32, values.data()) >= 0);
        H5Dclose(array);
    }

    Hdf5Folder folder_;
};

QTEST_GUILESS_MAIN(Hdf5RefusalsTest)
#include "hdf5_refusals_test.moc"
