// SPDX-License-Identifier: GPL-3.0-or-later
// A file that was cut short is refused, wherever it was cut; if what was cut off says nothing, the same dataset is read
// as from the whole. For each format that VTK reads: those that VTK or its libraries look through by
// themselves stay so.
#include "plugins/readers/netcdf/classic_check.h"
#include "plugins/readers/vtk/checks/file_check.h"
#include "tests/lacks.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"
#include "tests/plugins/readers/vtk/written_files.h"
#include "tests/soak.h"

#include <QProcess>
#include <QTest>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

using namespace tetra;

namespace {

VtkRequest requestOf(const std::filesystem::path& path)
{
    const QByteArray content = contentOf(path).left(4096);
    VtkRequest request;
    request.path = path.string();
    request.format =
        guessVtkFormat(path, std::as_bytes(std::span(content.constData(), std::size_t(content.size())))).format;
    return request;
}

/// Whether what looks at a file before a library reads it lets it pass.
bool passesChecks(const VtkRequest& request)
{
    if (request.format == VtkFormat::None) // of NetCDF, or too short to be told
        return checkClassicNetCdf(request.path).ok();
    return checkBeforeVtk(request).ok();
}

bool isSame(const Dataset& a, const Dataset& b)
{
    const auto samePositions = [&] {
        return a.positions == nullptr ? b.positions == nullptr : b.positions != nullptr && *a.positions == *b.positions;
    };
    const auto sameTetrahedra = [&] {
        return a.tetrahedra == nullptr ? b.tetrahedra == nullptr
                                       : b.tetrahedra != nullptr && *a.tetrahedra == *b.tetrahedra;
    };
    return a.domain == b.domain && a.lattice.size == b.lattice.size && a.lattice.spacing == b.lattice.spacing &&
           a.lattice.origin == b.lattice.origin && a.lattice.directions == b.lattice.directions &&
           a.values.type() == b.values.type() && std::ranges::equal(a.values.bytes(), b.values.bytes()) &&
           samePositions() && sameTetrahedra();
}

/// The same, or it says what it lacks: a part without values, a last number that may be cut.
bool isSameOrTold(const Dataset& read, const Dataset& whole)
{
    return isSame(read, whole) || read.remarks.size() > whole.remarks.size() ||
           read.source.leftOut.size() > whole.source.leftOut.size();
}

/// At the ends and between them, at most `most` of them, from the end to the beginning.
std::vector<qsizetype> placesIn(qsizetype size, int most)
{
    std::set<qsizetype> places{0, 1, size / 2, size - 2, size - 1};
    for (int i = 0; i < most; ++i)
        places.insert(size * i / most);
    std::erase_if(places, [&](qsizetype place) { return place < 0 || place >= size; });
    return {places.rbegin(), places.rend()};
}

/// Reads what is left after each cut of a file that the checks before VTK let pass, which are quick, and of one that
/// they refuse, as the reader, which has a program of its own for it, has to refuse it for them. A file that was
/// accepted must be the same dataset. What was accepted wrongly, and how many were the same.
QStringList wronglyAccepted(const std::filesystem::path& opened, const Dataset& whole, const std::filesystem::path& cut,
                            int most, int* same)
{
    const Reader& reader = readerOf(opened);
    const QByteArray content = contentOf(cut);
    const VtkRequest request = requestOf(opened);
    QStringList wrong;
    bool wasRefused = false;
    for (const qsizetype place : placesIn(content.size(), most)) {
        std::filesystem::resize_file(cut, std::uintmax_t(place)); // to write it anew each time takes much longer
        if (!passesChecks(request) && std::exchange(wasRefused, true))
            continue;
        const auto read = reader.read(opened, {}, {});
        const auto isNamed = [&](const std::filesystem::path& file) {
            return read.error().text().find(file.filename().string()) != std::string::npos;
        };
        if (!read && !isNamed(opened) && !isNamed(cut))
            wrong << QString::number(place) +
                         ": the error does not name the file: " + QString::fromStdString(read.error().text());
        if (read && !isSameOrTold(*read, whole))
            wrong << QString("%1 of %2 bytes").arg(place).arg(content.size());
        *same += read && isSame(*read, whole) ? 1 : 0;
    }
    writeContent(cut, content);
    return wrong;
}

/// Two tetrahedra over five points, whose numbers follow the text as they are in memory.
QByteArray rawAppendedMesh()
{
    QByteArray numbers, arrays;
    const auto add = [&](const char* what, const char* type, auto values, int components = 1) {
        arrays +=
            QString(
                "<DataArray type=\"%1\" Name=\"%2\" NumberOfComponents=\"%3\" format=\"appended\" offset=\"%4\"/>\n")
                .arg(type, what)
                .arg(components)
                .arg(numbers.size())
                .toLatin1();
        const std::uint32_t bytes = std::uint32_t(values.size() * sizeof(values[0]));
        numbers.append(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
        numbers.append(reinterpret_cast<const char*>(values.data()), bytes);
        return std::exchange(arrays, {});
    };
    const QByteArray values = add("value", "Float32", std::array{1.f, 2.f, 3.f, 4.f, 5.f});
    const QByteArray points = add(
        "Points", "Float32", std::array{0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 1.f, 1.f, 1.f}, 3);
    const QByteArray cells = add("connectivity", "Int32", std::array{0, 1, 2, 3, 1, 2, 3, 4}) +
                             add("offsets", "Int32", std::array{4, 8}) +
                             add("types", "UInt8", std::array<std::uint8_t, 2>{10, 10});
    return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
           "<Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">\n<PointData Scalars=\"value\">\n" +
           values + "</PointData>\n<Points>\n" + points + "</Points>\n<Cells>\n" + cells +
           "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + numbers +
           "\n</AppendedData>\n</VTKFile>\n";
}

} // namespace

class VtkCutFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { formats_ = writeFormats(folder_.path() / "own"); }

    void wholeFilesAreRead_data() { eachFormat(); }
    void wholeFilesAreRead()
    {
        const WrittenFiles& files = format();
        const Dataset* dataset = wholeOf(files.opened, readerOf(files.opened));
        QVERIFY(dataset != nullptr);
        QCOMPARE(dataset->pointCount(), std::uint64_t(files.points));
        if (files.perCell)
            return;
        std::vector<double> values;
        for (std::uint64_t i = 0; i < files.points; ++i)
            values.push_back(dataset->values.at(i));
        if (isOnLattice(dataset->domain)) {
            for (std::size_t i = 0; i < files.points; ++i)
                QCOMPARE(values[i], double(i));
        }
        std::ranges::sort(values);
        for (std::size_t i = 0; i < files.points; ++i)
            QCOMPARE(values[i], double(i));
    }

    /// At every single place, by the checks alone, which is quick; what they let pass is read, at a few places.
    void cutFilesAreRefused_data() { eachFormat(); }
    void cutFilesAreRefused()
    {
        const WrittenFiles& files = format();
        const VtkRequest request = requestOf(files.opened);
        const Dataset* whole = wholeOf(files.opened, readerOf(files.opened));
        QVERIFY(whole != nullptr);
        QStringList wrong;
        int tried = 0, passed = 0;
        for (const std::filesystem::path& file : {files.data.front(), files.data.back()}) {
            if (tried > 0 && files.data.size() == 1)
                break;
            const QByteArray content = contentOf(file);
            const qsizetype step = std::max<qsizetype>(1, content.size() / 1000);
            for (qsizetype place = content.size() - 1; place >= 0; place -= place > 200 ? step : 1) {
                std::filesystem::resize_file(file, std::uintmax_t(place));
                ++tried;
                if (!passesChecks(request) || ++passed > timesOf(2, 8))
                    continue;
                const auto read = readerOf(files.opened).read(files.opened, {}, {});
                if (read && !isSameOrTold(*read, *whole))
                    wrong << QString("%1 of %2 bytes of ").arg(place).arg(content.size()) +
                                 QString::fromStdString(file.filename().string());
            }
            writeContent(file, content);
        }
        QVERIFY2(wrong.isEmpty(),
                 qPrintable(QString("%1 of %2 cuts: ").arg(wrong.size()).arg(tried) + wrong.join(", ")));
        QVERIFY2(tried >= 50, "too few places");
    }

    /// The reader itself: few places of each. ./dev soak tries thousands.
    void theReaderRefusesThem_data() { eachFormat(); }
    void theReaderRefusesThem()
    {
        const WrittenFiles& files = format();
        const bool every = files.data.size() <= 5; // of different kinds
        const Dataset* whole = wholeOf(files.opened, readerOf(files.opened));
        QVERIFY(whole != nullptr);
        for (const std::filesystem::path& file : files.data) {
            if (!every && file != files.data.back())
                continue;
            int same = 0;
            const QStringList wrong = wronglyAccepted(files.opened, *whole, file, timesOf(0, 6), &same);
            QVERIFY2(wrong.isEmpty(),
                     qPrintable(QString::fromStdString(file.filename().string()) + ": " + wrong.join("; ")));
            QVERIFY2(same < 8, "most cuts lose something"); // half of a file of two times
        }
    }

    /// More digits may have stood there.
    void aNumberThatNothingEndsIsTold()
    {
        const auto gold = std::ranges::find(formats_, "EnSight, Gold", &WrittenFiles::what);
        QVERIFY(gold != formats_.end());
        const QByteArray content = contentOf(gold->data.back());
        writeContent(gold->data.back(), content.chopped(1));
        const auto read = readerOf(gold->opened).read(gold->opened, {}, {});
        writeContent(gold->data.back(), content);
        QVERIFY(read);
        QVERIFY(std::ranges::any_of(read->remarks, [](const Message& remark) {
            return remark.text().find("without an end of line") != std::string::npos;
        }));
    }

    /// VTK reads zeros in place of numbers that are cut off behind such a file's text.
    void rawAppendedDataAreWhole()
    {
        const std::filesystem::path path = folder_.write("raw.vtu", rawAppendedMesh());
        int same = 0;
        const Dataset* whole = wholeOf(path, readerOf(path));
        QVERIFY(whole != nullptr);
        const QStringList wrong = wronglyAccepted(path, *whole, path, timesOf(8, 60), &same);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("; ")));
        QVERIFY2(same < 3, "most cuts lose something"); // but the last end of line
    }

    /// Written by VTK, from Python.
    void filesOfVtkAreRefused_data()
    {
        QTest::addColumn<QString>("opened");
        QTest::addColumn<QString>("cut");
        const auto row = [](const char* opened, const char* cut = nullptr) {
            QTest::newRow(cut == nullptr ? opened : cut) << QString(opened) << QString(cut == nullptr ? opened : cut);
        };
        for (const char* name : {"ascii.vti", "binary.vts", "appended.vtu", "appended.vtr", "binary.vtp", "points0.vtk",
                                 "structured1.vtk", "tetrahedra0.vtk", "tetrahedra1.vtk", "cloud1.vtk", "image4.nii",
                                 "image10.mha", "mesh.ex2", "block.tec", "map.mrc", "image.vtkhdf", "grid.cgns"})
            row(name);
        row("halves.pvti", "halves_1.vti");
        row("pieces.pvtu", "pieces_0.vtu");
        row("blocks.vtm", "blocks/blocks_0.vts");
        row("one.xyz");
        row("one.xyz", "one.q");
        row("image4.mhd", "image4.zraw");
    }
    void filesOfVtkAreRefused()
    {
        QFETCH(QString, opened);
        QFETCH(QString, cut);
        const std::filesystem::path folder = folder_.path() / "vtk";
        if (!std::filesystem::exists(folder)) {
            std::filesystem::create_directory(folder);
            QProcess python;
            python.start("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/plugins/readers/vtk/make_vtk_files.py",
                                              QString::fromStdString(folder.string())});
            hasVtk_ = python.waitForFinished(120'000) && python.exitCode() == 0;
        }
        if (!hasVtk_)
            QSKIP_WITHOUT("python3-vtk9");
        int same = 0;
        const std::filesystem::path path = folder / opened.toStdString();
        const Dataset* whole = wholeOf(path, readerOf(path));
        QVERIFY(whole != nullptr);
        const QStringList wrong = wronglyAccepted(path, *whole, folder / cut.toStdString(), timesOf(3, 12), &same);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("; ")));
        QVERIFY2(same < 10, "most cuts lose something");
    }

private:
    void eachFormat()
    {
        QTest::addColumn<int>("number");
        for (std::size_t i = 0; i < formats_.size(); ++i)
            QTest::newRow(formats_[i].what.c_str()) << int(i);
    }
    const WrittenFiles& format() const
    {
        QFETCH(int, number);
        return formats_[std::size_t(number)];
    }

    /// What a file gives that is not cut, read once: starting VTK takes long. Nothing, and why, if it is refused.
    const Dataset* wholeOf(const std::filesystem::path& opened, const Reader& reader)
    {
        const std::pair key(&reader, opened);
        if (!whole_.contains(key)) {
            auto read = reader.read(opened, {}, {});
            if (!read) {
                qWarning("%s", read.error().text().c_str());
                return nullptr;
            }
            whole_.emplace(key, *std::move(read));
        }
        return &whole_.at(key);
    }

    VtkFolder folder_;
    std::vector<WrittenFiles> formats_;
    std::map<std::pair<const Reader*, std::filesystem::path>, Dataset> whole_;
    bool hasVtk_ = false;
};

QTEST_GUILESS_MAIN(VtkCutFilesTest)
#include "vtk_cut_files_test.moc"
