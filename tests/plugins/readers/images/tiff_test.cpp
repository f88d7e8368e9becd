// SPDX-License-Identifier: GPL-3.0-or-later
// TIFF stacks hold a known function of the indices; files are written here, byte by byte.
#include "tests/lacks.h"
#include "tests/plugins/readers/images/picture_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr int columns = 4, rows = 3;

double value(int i, int j, int k)
{
    return i + 10 * j + 25 * k;
}

/// A layer of numbers of one type, moved by `shift`.
template <class T> TiffPicture layer(int k, double shift = 0, bool little = true)
{
    TiffPicture page;
    page.bits = 8 * int(sizeof(T));
    page.format = std::is_floating_point_v<T> ? 3 : std::is_signed_v<T> ? 2 : 1;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            page.bytes += numberBytes(static_cast<T>(value(i, j, k) + shift), little);
    return page;
}

double distance(const Dataset& dataset, double shift = 0, double perLayer = 1)
{
    double largest = 0;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
        const auto [i, j, k] = dataset.lattice.coordinates(point);
        largest =
            std::max(largest, std::abs(dataset.values.at(point) - value(int(i), int(j), int(k * perLayer)) - shift));
    }
    return largest;
}

Result<Dataset> readFile(const fs::path& path, const ParameterValues& values = {})
{
    return builtImagesReader().read(path, values, {});
}

#define VERIFY_OK(result) QVERIFY2((result).ok(), (result).ok() ? "" : (result).error().text().c_str())

QByteArray omeText(const QByteArray& attributes, const QByteArray& inner)
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\">"
           "<Image ID=\"Image:0\" Name=\"cells\"><Pixels ID=\"Pixels:0\" Type=\"uint16\" SizeX=\"4\" SizeY=\"3\" " +
           attributes + ">" + inner + "</Pixels></Image></OME>";
}

} // namespace

class TiffTest : public QObject {
    Q_OBJECT

private slots:
    void numbersOfAllTypes()
    {
        const PictureFolder folder;
        const auto check = [&]<class T>(T, SampleType type, const TiffWriting& writing) {
            std::vector<TiffPicture> pages;
            for (int k = 0; k < 4; ++k)
                pages.push_back(layer<T>(k, 1, writing.little));
            const auto dataset = readFile(folder.write("pages.tif", tiffFile(pages, writing)));
            return dataset.ok() && dataset->values.type() == type && distance(*dataset, 1) == 0 &&
                   dataset->lattice.size == std::array<std::uint32_t, 3>{columns, rows, 4};
        };
        QVERIFY(check(quint8(), SampleType::UInt8, {}));
        QVERIFY(check(qint8(), SampleType::Int8, {}));
        QVERIFY(check(quint16(), SampleType::UInt16, {.little = false}));
        QVERIFY(check(qint16(), SampleType::Int16, {.packed = true}));
        QVERIFY(check(quint32(), SampleType::UInt32, {.big = true}));
        QVERIFY(check(qint32(), SampleType::Int32, {.little = false, .big = true}));
        QVERIFY(check(qint64(), SampleType::Float64, {}));
        QVERIFY(check(float(), SampleType::Float32, {.little = false, .packed = true}));
        QVERIFY(check(double(), SampleType::Float64, {.little = false}));
    }

    void halfPrecision()
    {
        TiffPicture page = layer<quint16>(0);
        page.format = 3;
        page.bytes = {};
        for (int n = 0; n < rows * columns; ++n)
            page.bytes += numberBytes(quint16(n == 0 ? 0xc100 : 0x3c00)); // -2.5, 1
        const PictureFolder folder;
        const auto dataset = readFile(folder.write("half.tif", tiffFile({page, page})));
        VERIFY_OK(dataset);
        QVERIFY(dataset->values.at(0) == -2.5 && dataset->values.at(1) == 1);
    }

    void imageJTellsVoxelsAndChannels()
    {
        const QByteArray text =
            "ImageJ=1.54f\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\nunit=\\u00B5m\n"
            "spacing=0.5\nfinterval=30.0\n";
        std::vector<TiffPicture> pages;
        for (int t = 0; t < 2; ++t)
            for (int k = 0; k < 3; ++k)
                for (int c = 0; c < 2; ++c)
                    pages.push_back(layer<quint16>(k, 1000 * c + 5000 * t));
        pages[0].description = text;
        pages[0].pixelsPerUnit = 10;
        pages[0].resolutionUnit = 1;
        const PictureFolder folder;
        const fs::path path = folder.write("stack.tif", tiffFile(pages));
        const auto first = readFile(path);
        VERIFY_OK(first);
        QVERIFY(distance(*first) == 0);
        QVERIFY((first->lattice.spacing - Eigen::Vector3d(0.1, 0.1, 0.5)).norm() < 1e-7);
        QVERIFY(first->lengthUnit == "µm" && first->remarks.empty());
        QVERIFY(takenOf(first->source.taken, TakenPart::Channel).find("1 of 2") != std::string::npos);
        QVERIFY(takenOf(first->source.taken, TakenPart::TimeStep).find("1 of 2") != std::string::npos);
        const auto last = readFile(path, {{"channel", std::string("2")}, {"time", std::int64_t(2)}});
        QVERIFY(last.ok() && distance(*last, 6000) == 0);
        QCOMPARE(takenOf(last->source.taken, TakenPart::TimeStep), std::string("time step: 2 of 2, 30 s"));
        // Who has chosen is not told to choose.
        QVERIFY(allText(first->source.leftOut).find("Choose one with '--time'") != std::string::npos);
        QVERIFY(allText(last->source.leftOut).find("2 channels; the others are not read.") != std::string::npos);
        QVERIFY(allText(last->source.leftOut).find("Choose") == std::string::npos);
        QVERIFY(!readFile(path, {{"channel", std::string("3")}}).ok());
        QVERIFY(!readFile(path, {{"spacing", std::string("1x1x1")}}).ok());
        const auto contents = builtImagesReader().probe(path, {}, {});
        QVERIFY(contents.ok() && contents->channels.size() == 2 && contents->timeSteps == std::vector<double>({0, 30}));
        QVERIFY(contents->taken == first->source.taken && contents->leftOut == first->source.leftOut);
    }

    /// One page is described, and the others follow it.
    void imageJsLargeStack()
    {
        for (const bool little : {true, false}) {
            TiffPicture page = layer<quint16>(0, 0, little);
            page.description = "ImageJ=1.54f\nimages=5\nslices=5\nunit=micron\n";
            QByteArray bytes = tiffFile({page}, {.little = little});
            QByteArray pixels;
            for (int k = 0; k < 5; ++k)
                pixels += layer<quint16>(k, 0, little).bytes;
            const auto entry = bytes.indexOf(numberBytes(quint16(273), little) + numberBytes(quint16(4), little));
            bytes.replace(entry + 8, 4, numberBytes(quint32(bytes.size()), little)); // where the pixels are
            const PictureFolder folder;
            const auto dataset = readFile(folder.write("large.tif", bytes + pixels));
            VERIFY_OK(dataset);
            QVERIFY(distance(*dataset) == 0 && dataset->lattice.size[2] == 5);
            const auto cut = readFile(folder.write("cut.tif", (bytes + pixels).chopped(2)));
            QVERIFY(!cut.ok() && cut.error().text().find("cut short") != std::string::npos);
        }
    }

    void imageJsSignedNumbers()
    {
        std::vector<TiffPicture> pages = {layer<quint16>(0, 32768 - 40), layer<quint16>(1, 32768 - 40)};
        pages[0].description = "ImageJ=1.54f\nimages=2\nslices=2\ncf=0\nc0=-32768.0\nc1=1.0\nvunit=HU\n";
        const PictureFolder folder;
        const auto dataset = readFile(folder.write("signed.tif", tiffFile(pages)));
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset, -40) == 0 && dataset->values.type() == SampleType::Int16);
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Unit).find("HU") != std::string::npos);
    }

    void omeTellsVoxelsAndChannels()
    {
        std::vector<TiffPicture> pages;
        for (int c = 0; c < 2; ++c)
            for (int k = 0; k < 3; ++k)
                pages.push_back(layer<quint16>(k, 1000 * c));
        pages[0].description =
            omeText("SizeZ=\"3\" SizeC=\"2\" SizeT=\"1\" DimensionOrder=\"XYZCT\" PhysicalSizeX=\"0.1\" "
                    "PhysicalSizeY=\"200\" PhysicalSizeYUnit=\"nm\" PhysicalSizeZ=\"0.3\"",
                    "<Channel ID=\"a\" Name=\"DAPI\"/><Channel ID=\"b\" Name=\"GFP\"/><TiffData/>");
        const PictureFolder folder;
        const fs::path path = folder.write("a.ome.tif", tiffFile(pages));
        const auto first = readFile(path);
        VERIFY_OK(first);
        QVERIFY(distance(*first) == 0 && first->lengthUnit == "µm");
        QVERIFY((first->lattice.spacing - Eigen::Vector3d(0.1, 0.2, 0.3)).norm() < 1e-12);
        QVERIFY(takenOf(first->source.taken, TakenPart::Channel).find("1 of 2, DAPI") != std::string::npos);
        const auto second = readFile(path, {{"channel", std::string("GFP")}});
        QVERIFY(second.ok() && distance(*second, 1000) == 0);
        for (const ParameterValues& wrong :
             {ParameterValues{{"channel", std::string("RFP")}}, ParameterValues{{"time", std::int64_t(2)}}}) {
            const auto none = readFile(path, wrong);
            QVERIFY(!none.ok() && none.error().kind == ErrorKind::WrongUsage);
            const char* told =
                wrong.contains("channel") ? "'DAPI', 'GFP'" : "it has one time step, and number 2 was requested";
            QVERIFY2(none.error().text().find(told) != std::string::npos, none.error().text().c_str());
        }
    }

    void omeTellsTimes()
    {
        std::vector<TiffPicture> pages;
        for (int t = 0; t < 4; ++t)
            for (int k = 0; k < 3; ++k)
                pages.push_back(layer<quint16>(k, 1000 * t));
        pages[0].description = omeText("SizeZ=\"3\" SizeC=\"1\" SizeT=\"4\" DimensionOrder=\"XYZCT\" "
                                       "TimeIncrement=\"0.1\" TimeIncrementUnit=\"min\"",
                                       "<TiffData/>");
        const PictureFolder folder;
        const fs::path path = folder.write("a.ome.tif", tiffFile(pages));
        const auto last = readFile(path, {{"time", std::int64_t(4)}});
        VERIFY_OK(last);
        QVERIFY(distance(*last, 3000) == 0);
        QCOMPARE(takenOf(last->source.taken, TakenPart::TimeStep), std::string("time step: 4 of 4, 0.3 min"));
        const auto contents = builtImagesReader().probe(path, {}, {});
        QVERIFY(contents.ok() && contents->timeSteps == std::vector<double>({0, 0.1, 0.2, 0.3}));
        const auto none = readFile(path, {{"channel", std::string("2")}});
        QVERIFY(!none.ok() && none.error().text().find("Leave 'channel' out") != std::string::npos);
    }

    /// Planes in an order of their own, one of them in another file.
    void omeTellsWherePlanesAre()
    {
        const QByteArray text =
            omeText("SizeZ=\"3\" SizeC=\"1\" SizeT=\"1\" DimensionOrder=\"XYZCT\"",
                    "<TiffData IFD=\"1\" FirstZ=\"0\"/><TiffData IFD=\"0\" FirstZ=\"1\"/>"
                    "<TiffData IFD=\"0\" FirstZ=\"2\"><UUID FileName=\"b.ome.tif\">x</UUID></TiffData>");
        std::vector<TiffPicture> pages = {layer<quint16>(1), layer<quint16>(0)};
        pages[0].description = text;
        const PictureFolder folder;
        const fs::path path = folder.write("a.ome.tif", tiffFile(pages));
        const auto lacking = readFile(path);
        QVERIFY(!lacking.ok() && lacking.error().text().find("b.ome.tif") != std::string::npos);
        folder.write("b.ome.tif", tiffFile({layer<quint16>(2)}));
        const auto dataset = readFile(path);
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset) == 0);
    }

    void filesOfAStack()
    {
        const PictureFolder folder;
        for (int k = 0; k < 12; ++k)
            folder.write("img" + std::to_string(k + 1) + ".tif", tiffFile({layer<quint16>(k)}));
        const auto dataset = readFile(folder.path() / "img7.tif");
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset) == 0 && dataset->domain == DomainClass::RegularLattice);
        QVERIFY(dataset->lattice.size[2] == 12);
        QVERIFY(fs::remove(folder.path() / "img6.tif"));
        const auto gap = readFile(folder.path() / "img7.tif",
                                  {{"spacing", std::string("0.1x0.2x0.5")}, {"origin", std::string("1,2,3")}});
        VERIFY_OK(gap);
        QVERIFY(gap->domain == DomainClass::Curvilinear);
        for (std::uint64_t point = 0; point < gap->pointCount(); ++point) {
            const Eigen::Vector3d at =
                (gap->position(point) - Eigen::Vector3d(1, 2, 3)).cwiseQuotient(Eigen::Vector3d(0.1, 0.2, 0.5));
            QVERIFY(std::abs(gap->values.at(point) - value(0, 0, 0) - at.dot(Eigen::Vector3d(1, 10, 25))) < 1e-6);
        }
        QVERIFY2(allText(gap->remarks).find("missing among its numbered files: 1 (6)") != std::string::npos,
                 allText(gap->remarks).c_str());
    }

    void channelsInNames()
    {
        const PictureFolder folder;
        for (int k = 0; k < 3; ++k)
            for (int c = 1; c < 3; ++c)
                folder.write("cell_z0" + std::to_string(k) + "_c" + std::to_string(c) + ".tif",
                             tiffFile({layer<quint16>(k, 1000 * c)}));
        const fs::path path = folder.path() / "cell_z01_c2.tif";
        const auto dataset = readFile(path);
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset, 2000) == 0 && dataset->lattice.size[2] == 3);
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Channel).find("2 of 2, c2") != std::string::npos);
        const auto other = readFile(path, {{"channel", std::string("c1")}});
        QVERIFY(other.ok() && distance(*other, 1000) == 0);
    }

    void colours()
    {
        TiffPicture page;
        page.bits = 8;
        page.samples = 3;
        page.photometric = 2;
        for (int pixel = 0; pixel < rows * columns; ++pixel)
            page.bytes += numberBytes(quint8(2 + pixel)) + numberBytes(quint8(3)) + numberBytes(quint8(6));
        const PictureFolder folder;
        const fs::path path = folder.write("colours.tif", tiffFile({page, page}));
        const auto all = readFile(path);
        VERIFY_OK(all);
        QVERIFY(all->values.at(0) == 7);
        QVERIFY(takenOf(all->source.taken, TakenPart::Component).find("guess") != std::string::npos);
        const auto blue = readFile(path, {{"component", std::string("2")}});
        QVERIFY(blue.ok() && blue->values.at(5) == 6);
        QVERIFY(!readFile(path, {{"component", std::string("3")}}).ok());
    }

    void resolutionOfPages()
    {
        std::vector<TiffPicture> pages = {layer<quint8>(0), layer<quint8>(1)};
        pages[0].pixelsPerUnit = 100;
        pages[0].resolutionUnit = 3;
        pages.push_back(layer<quint8>(0));
        pages.back().kind = 1; // a smaller copy
        const PictureFolder folder;
        const auto dataset = readFile(folder.write("pages.tif", tiffFile(pages)));
        VERIFY_OK(dataset);
        QVERIFY((dataset->lattice.spacing - Eigen::Vector3d(0.1, 0.1, 0.1)).norm() < 1e-7);
        QVERIFY(dataset->lengthUnit == "mm" && dataset->lattice.size[2] == 2);
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Frame).find("guess") != std::string::npos);
        QVERIFY(allText(dataset->source.leftOut).find("smaller copies") != std::string::npos);
        QVERIFY(readFile(folder.path() / "pages.tif", {{"spacing", std::string("1x1x2")}}).ok());
    }

    void whatIsNoVolumeIsRefused()
    {
        const PictureFolder folder;
        const auto refusal = [&](const std::vector<TiffPicture>& pages) {
            const auto dataset = readFile(folder.write("pages.tif", tiffFile(pages)));
            return dataset.ok() ? std::string() : dataset.error().text();
        };
        QVERIFY(refusal({layer<quint8>(0)}).find("one slice") != std::string::npos);
        TiffPicture palette = layer<quint8>(0);
        palette.photometric = 3;
        QVERIFY(refusal({palette, palette}).find("palette") != std::string::npos);
        TiffPicture wide = layer<quint8>(0);
        wide.size = {2, 6};
        QVERIFY(refusal({layer<quint8>(0), wide}).find("another size") != std::string::npos);
        TiffPicture huge = layer<quint8>(0);
        huge.size = {65000, 65000};
        const std::string ofHuge = refusal({huge, huge});
        QVERIFY2(ofHuge.find("cut short") != std::string::npos, ofHuge.c_str());
        TiffPicture complex = layer<quint64>(0);
        complex.format = 6;
        QVERIFY(refusal({complex, complex}).find("SampleFormat") != std::string::npos);
    }

    void sharedCases_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("isMeasured");
        QTest::newRow("imagej_spacing") << "imagej_spacing.tif" << true;
        QTest::newRow("ome") << "ome.ome.tif" << true;
        QTest::newRow("imagej_2channels") << "imagej_2channels.tif" << false;
        QTest::newRow("f64") << "f64.tif" << false;
        QTest::newRow("channels") << "channels/cell_z04_c1.tif" << false;
    }
    void sharedCases()
    {
        QFETCH(QString, file);
        QFETCH(bool, isMeasured);
        const fs::path path = tetra::sharedCases() / "tiff" / file.toStdString();
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = readFile(path);
        VERIFY_OK(dataset);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{9, 11, 13}));
        if (isMeasured)
            QVERIFY((dataset->lattice.spacing - Eigen::Vector3d(0.1, 0.1, 0.3)).norm() < 1e-6);
    }
};

QTEST_GUILESS_MAIN(TiffTest)
#include "tiff_test.moc"
