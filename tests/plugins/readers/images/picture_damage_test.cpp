// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are cut or changed are refused, or read with values that some whole file could hold: never a crash, never
// less than all.
#include "tests/plugins/readers/images/picture_files.h"

#include <QTest>

#include <random>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr int slices = 3;

double function(const Eigen::Vector3d& place)
{
    return 100 + std::round(20 * place.sum());
}

QByteArray slice(int k)
{
    DicomSlice at;
    at.position = {0, 0, double(k)};
    return dicomFile(at.elements(function));
}

QByteArray pages(const TiffWriting& writing)
{
    std::vector<TiffPicture> all(slices);
    for (TiffPicture& page : all)
        for (int n = 0; n < 12; ++n)
            page.bytes += numberBytes(quint16(n), writing.little);
    all[0].description = "ImageJ=1.54f\nimages=3\nslices=3\n";
    return tiffFile(all, writing);
}

} // namespace

class PictureDamageTest : public QObject {
    Q_OBJECT

private slots:
    void cutFiles()
    {
        const PictureFolder folder;
        for (int k = 0; k < slices; ++k)
            folder.write("a" + std::to_string(k) + ".dcm", slice(k));
        const QByteArray whole = slice(1);
        for (int part = 0; part < 12; ++part) {
            folder.write("a1.dcm", whole.left(whole.size() * part / 12));
            for (const char* name : {"a0.dcm", "a1.dcm"}) {
                const auto dataset = builtImagesReader().read(folder.path() / name, {}, {});
                QVERIFY2(!dataset.ok(), (std::string(name) + ", part " + std::to_string(part)).c_str());
                QVERIFY(!dataset.error().text().empty());
            }
        }
        folder.write("a1.dcm", whole);
        QVERIFY(builtImagesReader().read(folder.path() / "a0.dcm", {}, {}).ok());
        for (const bool packed : {true, false}) {
            const QByteArray stack = pages({.packed = packed});
            for (int part = 0; part < 12; ++part)
                QVERIFY(!builtImagesReader()
                             .read(folder.write("pages.tif", stack.left(stack.size() * part / 12)), {}, {})
                             .ok());
        }
    }

    void changedBytes()
    {
        std::mt19937 random(7);
        const PictureFolder folder;
        for (int k = 0; k < slices; ++k)
            folder.write("a" + std::to_string(k) + ".dcm", slice(k));
        const QByteArray dicom = slice(1), tiff = pages({.packed = true});
        for (int change = 0; change < 12; ++change) {
            const auto damaged = [&](QByteArray bytes) {
                for (int byte = 0; byte < 3; ++byte)
                    bytes[qsizetype(random() % std::size_t(bytes.size()))] = char(random());
                return bytes;
            };
            const fs::path one = folder.write("a1.dcm", damaged(dicom)), other = folder.write("b.tif", damaged(tiff));
            for (const fs::path& path : {one, other})
                if (const auto dataset = builtImagesReader().read(path, {}, {}); !dataset)
                    QVERIFY(!dataset.error().text().empty());
        }
    }
};

QTEST_GUILESS_MAIN(PictureDamageTest)
#include "picture_damage_test.moc"
