// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/images_format.h"
#include "plugins/readers/images/slice_names.h"
#include "plugins/readers/images/tiff/image_description.h"
#include "tests/plugins/readers/images/picture_files.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

ImagesFormat guess(const char* name, const QByteArray& bytes)
{
    return guessImagesFormat(name, std::as_bytes(std::span(bytes.constData(), std::size_t(bytes.size())))).format;
}

} // namespace

/// What is known by names and texts alone.
class PictureNamesTest : public QObject {
    Q_OBJECT

private slots:
    void formats()
    {
        QVERIFY(guess("IM0001", QByteArray(128, '\0') + "DICM") == ImagesFormat::Dicom);
        QVERIFY(guess("a.unknown", "II*" + QByteArray(9, '\0')) == ImagesFormat::Tiff);
        QVERIFY(guess("a.unknown", QByteArray("MM\0+", 4) + QByteArray(9, '\0')) == ImagesFormat::Tiff);
        QVERIFY(guess("a.dcm", "anything") == ImagesFormat::Dicom);
        QVERIFY(guess("a.TIFF", "anything") == ImagesFormat::Tiff);
        QVERIFY(guess("a.nrrd", "NRRD0005") == ImagesFormat::None);
    }

    void withoutTheProgram()
    {
        const PictureFolder folder;
        const fs::path path = folder.write("a.dcm", QByteArray(128, '\0') + "DICM");
        const auto dataset = ImagesReader(folder.path() / "tan-read-images").read(path, {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("apt install ./tan-vtk-readers") != std::string::npos,
                 dataset.error().text().c_str());
    }

    void slicesAreFoundByTheirNumbers()
    {
        const PictureFolder folder;
        for (const char* name :
             {"a9.tif", "a10.tif", "a011.tif", "b1.tif", "a9.png", "x1_2.tif", "x1_3.tif", "x2_2.tif", "t1.tif",
              "t2.tif", "f_t1_z1.tif", "f_t1_z2.tif", "f_t2_z1.tif", "f_t2_z2.tif"})
            folder.write(name, "x");
        const auto slices = sliceFiles(folder.path() / "a10.tif");
        QVERIFY((slices.numbers == std::vector<std::uint64_t>{9, 10, 11}));
        QVERIFY(slices.files[2].filename() == "a011.tif");
        QVERIFY((sliceFiles(folder.path() / "x1_3.tif").numbers == std::vector<std::uint64_t>{2, 3}));
        QVERIFY((sliceFiles(folder.path() / "t1.tif").numbers == std::vector<std::uint64_t>{1, 2}));
        QVERIFY(sliceFiles(folder.path() / "b1.tif").files.size() == 1);
        const auto timed = sliceFiles(folder.path() / "f_t2_z1.tif");
        QVERIFY((timed.times == std::vector<std::string>{"t1", "t2"}) && timed.time == 1);
        QVERIFY(timed.files[1].filename() == "f_t2_z2.tif");
        QVERIFY(sliceFiles(folder.path() / "f_t2_z1.tif", {}, 0).files[1].filename() == "f_t1_z2.tif");
    }

    void descriptionsWithoutSense()
    {
        const auto wild = imageJDescription("ImageJ=1\nimages=99999999999999999999\nslices=-3\nchannels=0\nspacing=nan",
                                            {0.0, 0.0}, false);
        QVERIFY(wild.planeCount() == 1 && !wild.spacing[2]);
        const auto refused = [](const char* text) {
            const auto description = omeDescription(text, 0, "a.tif");
            return description.ok() ? std::string() : description.error().text();
        };
        QVERIFY(refused("<OME><Image/></OME>").find("no pixels") != std::string::npos);
        QVERIFY(refused("<OME").find("not understood") != std::string::npos);
        QVERIFY(refused("<OME/>").find("no images") != std::string::npos);
        QVERIFY(refused("<OME><Image><Pixels SizeZ='9' SizeC='1' SizeT='1' DimensionOrder='XYZZT'/></Image></OME>")
                    .find("order of dimensions") != std::string::npos);
        QVERIFY(refused("<OME><Image><Pixels SizeZ='99999999' SizeC='99999' SizeT='99' "
                        "DimensionOrder='XYZCT'/></Image></OME>")
                    .find("slices, channels or times") != std::string::npos);
        QVERIFY(refused("<OME><Image><Pixels SizeZ='2' SizeC='1' SizeT='1' DimensionOrder='XYZCT'><TiffData "
                        "IFD='0'><UUID FileName='../b.tif'/></TiffData></Pixels></Image></OME>")
                    .find("another folder") != std::string::npos);
        QVERIFY(lengthUnitText("micron") == "µm" && lengthUnitText(" \xce\xbcm ") == "µm" &&
                lengthUnitText("mm") == "mm");
    }
};

QTEST_GUILESS_MAIN(PictureNamesTest)
#include "picture_names_test.moc"
