// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM series hold a known function of the place in the world; files are written here, byte by byte.
#include "tests/lacks.h"
#include "tests/plugins/readers/images/picture_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

double world(const Eigen::Vector3d& place)
{
    return std::round(20 * worldFunction(place, 10));
}

/// The largest difference of a value from the function at its place.
double distance(const Dataset& dataset, const std::function<double(const Eigen::Vector3d&)>& function = world)
{
    double largest = 0;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        largest = std::max(largest, std::abs(dataset.values.at(point) - function(dataset.position(point))));
    return largest;
}

/// Slices along a step, written in an order that says nothing.
struct SliceStack {
    DicomSlice slice{};
    Eigen::Vector3d step{0, 0, 0.6};
    int count = 6;
    std::string name = "a";
    std::vector<int> missing{};
    double slope = 1, intercept = 0;
    std::function<void(int, DicomElements&)> change = [](int, DicomElements&) {};
    std::function<double(const Eigen::Vector3d&)> function = world;

    fs::path write(const PictureFolder& folder) const
    {
        fs::path any;
        for (int k = 0; k < count; ++k) {
            if (std::ranges::find(missing, k) != missing.end())
                continue;
            DicomSlice at = slice;
            at.position += k * step;
            at.number = 1 + (k * 5 + 3) % 7;
            DicomElements elements = at.elements(function, slope, intercept);
            change(k, elements);
            any = folder.write(name + std::to_string((k * 5) % 31) + ".dcm", dicomFile(elements));
        }
        return any;
    }
};

Result<Dataset> readFile(const fs::path& path, const ParameterValues& values = {})
{
    return builtImagesReader().read(path, values, {});
}

#define VERIFY_OK(result) QVERIFY2((result).ok(), (result).ok() ? "" : (result).error().text().c_str())

QByteArray functional(quint32 sequence, const QByteArray& element)
{
    return dicomSequence(sequence, {element});
}

/// All slices in one file, with what each says of itself in functional groups.
QByteArray multiFrame(const SliceStack& volume, const std::vector<int>& times)
{
    const DicomSlice& slice = volume.slice;
    DicomElements elements = slice.elements(world);
    QByteArray pixels;
    std::vector<QByteArray> groups;
    for (const int time : times)
        for (int k = volume.count - 1; k >= 0; --k) {
            DicomSlice at = slice;
            at.position += k * volume.step;
            const DicomElements own =
                at.elements([&](const Eigen::Vector3d& place) { return world(place) + 1000 * time; });
            const QByteArray& element = own.at(0x7fe00010);
            pixels += element.right(element.size() - 12);
            groups.push_back(functional(0x00209111, QByteArray::fromHex("20002891") + "UL" + numberBytes(quint16(4)) +
                                                        numberBytes(quint32(time))) +
                             functional(0x00209113, own.at(0x00200032)) + functional(0x00209116, own.at(0x00200037)));
        }
    const QByteArray shared = functional(0x00289110, elements.at(0x00280030));
    for (const quint32 tag : {0x00200032u, 0x00200037u, 0x00280030u, 0x00281052u, 0x00281053u})
        elements.erase(tag);
    elements[0x00080016] = dicomText(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2.1");
    elements[0x00280008] = dicomText(0x00280008, "IS", QByteArray::number(int(groups.size())));
    elements[0x52009229] = dicomSequence(0x52009229, {shared});
    elements[0x52009230] = dicomSequence(0x52009230, groups);
    elements[0x7fe00010] =
        QByteArray::fromHex("e07f1000") + "OW" + QByteArray(2, '\0') + numberBytes(quint32(pixels.size())) + pixels;
    return dicomFile(elements);
}

} // namespace

class DicomTest : public QObject {
    Q_OBJECT

private slots:
    void placesAreThoseOfTheFiles_data()
    {
        QTest::addColumn<double>("turn");
        QTest::addColumn<double>("tilt");
        QTest::addColumn<bool>("isBackwards");
        QTest::newRow("along the axes") << 0.0 << 0.0 << false;
        QTest::newRow("mirrored") << 0.0 << 0.0 << true;
        QTest::newRow("oblique") << 0.4 << 0.0 << false;
        QTest::newRow("gantry tilt") << 0.0 << 0.2 << false;
    }
    void placesAreThoseOfTheFiles()
    {
        QFETCH(double, turn);
        QFETCH(double, tilt);
        QFETCH(bool, isBackwards);
        const Eigen::Matrix3d turned =
            Eigen::AngleAxisd(turn, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        SliceStack volume;
        volume.slice.position = {10, -20, 30};
        volume.slice.row = turned.col(0) * (isBackwards ? -1 : 1);
        volume.slice.column = turned.col(1);
        volume.step = 0.6 * turned.col(2) + tilt * turned.col(1);
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        VERIFY_OK(dataset);
        QVERIFY(dataset->domain == DomainClass::RegularLattice);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{4, 3, 6}));
        QVERIFY2(distance(*dataset) < 1e-3, std::to_string(distance(*dataset)).c_str());
        QVERIFY((dataset->lattice.spacing - Eigen::Vector3d(0.5, 0.7, volume.step.norm())).norm() < 1e-6);
        QVERIFY(dataset->space == "LPS" && dataset->lengthUnit == "mm");
        QVERIFY(dataset->values.type() == SampleType::Int16);
        QVERIFY2(dataset->remarks.empty(), allText(dataset->remarks).c_str());
    }

    void aMissingSliceStaysAGap()
    {
        SliceStack volume;
        volume.missing = {3};
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        VERIFY_OK(dataset);
        QVERIFY(dataset->domain == DomainClass::Curvilinear);
        QVERIFY(distance(*dataset) < 1e-3);
        QVERIFY2(allText(dataset->remarks).find("1 slice is missing between the others.") != std::string::npos &&
                     allText(dataset->remarks).find("after slice 3") != std::string::npos,
                 allText(dataset->remarks).c_str());
    }

    void unevenSlicesStayWhereTheyAre()
    {
        SliceStack volume;
        volume.change = [](int k, DicomElements& elements) {
            if (k != 2)
                return;
            DicomSlice at;
            at.position = {0, 0, 1.0};
            const DicomElements moved = at.elements(world);
            elements[0x00200032] = moved.at(0x00200032);
            elements[0x7fe00010] = moved.at(0x7fe00010);
        };
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        VERIFY_OK(dataset);
        QVERIFY(dataset->domain == DomainClass::Curvilinear && distance(*dataset) < 1e-3);
        QVERIFY(allText(dataset->remarks).find("unevenly") != std::string::npos);
    }

    void theSeriesOfTheOpenedFile()
    {
        SliceStack first, second;
        second.name = "b";
        second.slice.series = "1.2.4";
        second.function = [](const Eigen::Vector3d& place) { return -world(place); };
        const PictureFolder folder;
        const fs::path one = first.write(folder), other = second.write(folder);
        const auto a = readFile(one), b = readFile(other);
        VERIFY_OK(a);
        VERIFY_OK(b);
        QVERIFY(distance(*a) < 1e-3 && distance(*b, second.function) < 1e-3);
        QVERIFY(takenOf(a->source.taken, TakenPart::Series).find("1 of 2") != std::string::npos);
        QVERIFY(allText(a->source.leftOut).find("6 pictures. Choose it with 'series'") != std::string::npos);
        const auto chosen = readFile(one, {{"series", std::string("2")}});
        VERIFY_OK(chosen);
        QVERIFY(distance(*chosen, second.function) < 1e-3);
        const auto named = readFile(one, {{"series", std::string("1.2.4")}});
        QVERIFY(named.ok() && distance(*named, second.function) < 1e-3);
        const auto none = readFile(one, {{"series", std::string("3")}});
        QVERIFY(!none.ok() && none.error().kind == ErrorKind::WrongUsage);
        const auto contents = builtImagesReader().probe(one, {}, {});
        QVERIFY(contents.ok() && contents->series.size() == 2 && contents->taken == a->source.taken);
    }

    /// People know series by their descriptions; SeriesNumber is no number of the list.
    void seriesByTheirDescriptions()
    {
        SliceStack first, second;
        first.change = [](int, DicomElements& elements) {
            elements[0x0008103e] = dicomText(0x0008103e, "LO", "Thorax, native ");
            elements[0x00200011] = dicomText(0x00200011, "IS", "2 ");
        };
        second.name = "b";
        second.slice.series = "1.2.4";
        second.function = [](const Eigen::Vector3d& place) { return -world(place); };
        second.change = [](int, DicomElements& elements) {
            elements[0x0008103e] = dicomText(0x0008103e, "LO", "Bone");
            elements[0x00200011] = dicomText(0x00200011, "IS", "5 ");
        };
        const PictureFolder folder;
        const fs::path one = first.write(folder);
        second.write(folder);
        const auto bone = readFile(one, {{"series", std::string("Bone")}});
        VERIFY_OK(bone);
        QVERIFY(distance(*bone, second.function) < 1e-3);
        QCOMPARE(takenOf(bone->source.taken, TakenPart::Series),
                 std::string("series: 2 of 2: Bone (SeriesNumber 5, CT, 6 pictures)"));
        QCOMPARE(allText(bone->source.leftOut),
                 std::string("Next to it is series 1: Thorax, native (SeriesNumber 2, CT, 6 pictures).\n"));
        const auto none = readFile(one, {{"series", std::string("5")}});
        QVERIFY(!none.ok());
        QVERIFY2(none.error().text().find("1: Thorax, native (SeriesNumber 2, CT, 6 pictures); 2: Bone (Series") !=
                     std::string::npos,
                 none.error().text().c_str());
    }

    void overviewsAndCopiesAreLeftOut()
    {
        SliceStack volume;
        volume.change = [](int k, DicomElements& elements) {
            elements[0x00080018] = dicomText(0x00080018, "UI", "9." + QByteArray::number(k));
        };
        const PictureFolder folder;
        const fs::path path = volume.write(folder);
        DicomSlice overview;
        overview.row = {0, 1, 0};
        overview.column = {0, 0, -1};
        const fs::path single = folder.write("overview.dcm", dicomFile(overview.elements(world)));
        QVERIFY(fs::copy_file(path, path.parent_path() / "copy of a slice"));
        folder.write("notes.txt", "no picture");
        const auto dataset = readFile(path);
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset) < 1e-3 && dataset->lattice.size[2] == 6);
        QVERIFY2(allText(dataset->source.leftOut).find("as overviews") != std::string::npos &&
                     allText(dataset->source.leftOut).find("copies of others") != std::string::npos,
                 allText(dataset->source.leftOut).c_str());
        const auto alone = readFile(single);
        QVERIFY(!alone.ok() && alone.error().text().find("single picture") != std::string::npos);
    }

    /// Two echoes on one place, which the files tell apart, and two that they do not.
    void severalVolumesOnOnePlace()
    {
        for (const bool areMarked : {true, false}) {
            SliceStack first, second;
            second.name = "b";
            second.function = [](const Eigen::Vector3d& place) { return world(place) + 1000; };
            if (areMarked) {
                first.change = [](int, DicomElements& e) { e[0x00180081] = dicomText(0x00180081, "DS", "4.6"); };
                second.change = [](int, DicomElements& e) { e[0x00180081] = dicomText(0x00180081, "DS", "10"); };
            } else {
                second.change = [](int, DicomElements& e) { e[0x00200013] = dicomText(0x00200013, "IS", "100"); };
            }
            const PictureFolder folder;
            first.write(folder);
            const fs::path opened = second.write(folder);
            const auto dataset = readFile(opened);
            VERIFY_OK(dataset);
            QVERIFY(distance(*dataset, second.function) < 1e-3);
            const std::string taken = takenOf(dataset->source.taken, TakenPart::TimeStep);
            QVERIFY2(taken.find(areMarked ? "2 of 2, echo 10" : "number 2 of each place") != std::string::npos,
                     taken.c_str());
            const auto other = readFile(opened, {{"time", std::int64_t(1)}});
            QVERIFY(other.ok() && distance(*other) < 1e-3);
            QVERIFY(!readFile(opened, {{"time", std::int64_t(3)}}).ok());
        }
    }

    void onePlaceTwiceIsRefused()
    {
        SliceStack volume;
        const PictureFolder folder;
        const fs::path path = volume.write(folder);
        DicomSlice twice;
        twice.number = 50;
        folder.write("twice.dcm", dicomFile(twice.elements([](const Eigen::Vector3d&) { return 0; })));
        const auto dataset = readFile(path);
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("lie at one place") != std::string::npos, dataset.error().text().c_str());
    }

    void valuesAreScaled()
    {
        const auto lowered = [](const Eigen::Vector3d& place) { return world(place) - 200; }; // below 0 in part
        SliceStack volume;
        volume.function = lowered;
        volume.slope = 0.25;
        volume.intercept = -100;
        volume.change = [&](int k, DicomElements& elements) {
            if (k % 2 == 0)
                return;
            DicomSlice at; // another slope in every other slice
            at.position = {0, 0, 0.6 * k};
            const DicomElements other = at.elements(lowered, 0.5, 20);
            for (const quint32 tag : {0x00281052u, 0x00281053u, 0x7fe00010u})
                elements[tag] = other.at(tag);
        };
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        VERIFY_OK(dataset);
        QVERIFY(dataset->values.type() == SampleType::Float32);
        QVERIFY2(distance(*dataset, lowered) <= 0.25, std::to_string(distance(*dataset, lowered)).c_str());
        QVERIFY(dataset->values.range().minimum < 0);
    }

    /// Bits above those that count hold something else.
    void fewerBitsThanTheyTake()
    {
        SliceStack volume;
        volume.function = [](const Eigen::Vector3d& place) { return std::round(world(place) / 4) - 100; };
        volume.change = [](int, DicomElements& elements) {
            QByteArray& pixels = elements[0x7fe00010];
            for (qsizetype at = 13; at < pixels.size(); at += 2)
                pixels[at] = char((pixels[at] & 0x0f) | 0x70);
            elements[0x00280101] = dicomShort(0x00280101, 12);
            elements[0x00280102] = dicomShort(0x00280102, 11);
            elements[0x00280120] = dicomText(0x00280120, "SS", QByteArray("\x30\xf8"));
            elements[0x00281054] = dicomText(0x00281054, "LO", "HU");
            elements[0x00280004] = dicomText(0x00280004, "CS", "MONOCHROME1");
        };
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        VERIFY_OK(dataset);
        QVERIFY2(distance(*dataset, volume.function) < 1e-3,
                 std::to_string(distance(*dataset, volume.function)).c_str());
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Unit).find("HU") != std::string::npos);
        QVERIFY(allText(dataset->source.leftOut).find("value -2000 (PixelPaddingValue)") != std::string::npos);
        QVERIFY(allText(dataset->source.leftOut).find("MONOCHROME1") != std::string::npos);
    }

    void framesOfOneFile()
    {
        const PictureFolder folder;
        SliceStack volume;
        volume.slice.row = {0, 1, 0};
        volume.slice.column = {0, 0, -1};
        volume.step = {-0.6, 0, 0};
        const auto one = readFile(folder.write("one.dcm", multiFrame(volume, {0})));
        VERIFY_OK(one);
        QVERIFY(distance(*one) < 1e-3 && one->domain == DomainClass::RegularLattice);
        volume.slice.series = "1.2.5";
        const fs::path path = folder.write("two.dcm", multiFrame(volume, {1, 2}));
        const auto second = readFile(path, {{"time", std::int64_t(2)}});
        VERIFY_OK(second);
        QVERIFY(distance(*second, [](const Eigen::Vector3d& place) { return world(place) + 2000; }) < 1e-3);
        const auto first = readFile(path);
        QVERIFY(first.ok());
        QVERIFY2(takenOf(first->source.taken, TakenPart::TimeStep).find("1 of 2, temporal position 1") !=
                     std::string::npos,
                 takenOf(first->source.taken, TakenPart::TimeStep).c_str());
    }

    /// Without positions slices follow their numbers, and their thickness is a guess.
    void slicesWithoutPlaces()
    {
        SliceStack volume;
        volume.change = [](int k, DicomElements& elements) {
            elements.erase(0x00200032);
            elements[0x00180050] = dicomText(0x00180050, "DS", "0.6");
            elements[0x00200013] = dicomText(0x00200013, "IS", QByteArray::number(k + 1));
        };
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        VERIFY_OK(dataset);
        QVERIFY(distance(*dataset) < 1e-3);
        const std::string frame = takenOf(dataset->source.taken, TakenPart::Frame);
        QVERIFY2(frame.find("SliceThickness") != std::string::npos && frame.find("guess") != std::string::npos,
                 frame.c_str());
    }

    void whatIsNoVolumeIsRefused_data()
    {
        QTest::addColumn<quint32>("tag");
        QTest::addColumn<QByteArray>("element");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, quint32 tag, const QByteArray& element, const char* said) {
            QTest::newRow(name) << tag << element << QString(said);
        };
        row("colours", 0x00280004, dicomText(0x00280004, "CS", "PALETTE COLOR"), "in colour");
        row("mosaic", 0x00080008, dicomText(0x00080008, "CS", "ORIGINAL\\PRIMARY\\MOSAIC"), "mosaic");
        row("segmentation", 0x00080016, dicomText(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4"), "segmentation");
        row("no picture", 0x7fe00010, {}, "holds no picture");
        row("bits", 0x00280101, dicomShort(0x00280101, 99), "99 of 16 bits");
        row("more rows than pixels", 0x00280010, dicomShort(0x00280010, 60000), "bytes of pixels");
        row("frames", 0x00280008, dicomText(0x00280008, "IS", "123456789"), "number of frames");
    }
    void whatIsNoVolumeIsRefused()
    {
        QFETCH(quint32, tag);
        QFETCH(QByteArray, element);
        QFETCH(QString, said);
        SliceStack volume;
        volume.change = [&](int, DicomElements& elements) { elements[tag] = element; };
        const PictureFolder folder;
        const auto dataset = readFile(volume.write(folder));
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find(said.toStdString()) != std::string::npos, dataset.error().text().c_str());
    }

    void sharedCases_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("scale");
        for (const char* file : {"ct_two/aa004.dcm", "ct_gap/one003.dcm", "ct_overlap/one003.dcm"})
            QTest::newRow(file) << file << 20.0;
    }
    void sharedCases()
    {
        QFETCH(QString, file);
        QFETCH(double, scale);
        const fs::path path = tetra::sharedCases() / "dicom" / file.toStdString();
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = readFile(path);
        VERIFY_OK(dataset);
        const double far =
            distance(*dataset, [&](const Eigen::Vector3d& place) { return scale * worldFunction(place, 10); });
        QVERIFY2(far <= 1, std::to_string(far).c_str());
    }

    /// A file of frames without places says how large pixels are, and how thick slices.
    void sharedFrames()
    {
        const fs::path path = tetra::sharedCases() / "dicom" / "multiframe" / "a.dcm";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = readFile(path);
        VERIFY_OK(dataset);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{9, 11, 13}));
        QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(0.3, 0.3, 0.3));
        QVERIFY(dataset->values.at(0) == 1039);
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Frame).find("guess") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(DicomTest)
#include "dicom_test.moc"
