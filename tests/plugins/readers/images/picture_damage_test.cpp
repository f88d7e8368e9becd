// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are cut or changed are refused, or read with values that some whole file could hold: never a crash, never
// less than all.
#include "tests/plugins/readers/images/picture_files.h"

#include <QTest>

#include <zlib.h>

#include <array>
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

    /// Where ImageJ's text lies at the end, a file that is cut within it has all of its pages, and is something else.
    void cutDescription()
    {
        const PictureFolder folder;
        for (const bool big : {false, true}) {
            const TiffWriting writing{.little = !big, .big = big};
            QByteArray stack = pages(writing);
            const auto begin = stack.indexOf("ImageJ="), end = stack.indexOf('\0', begin) + 1;
            const QByteArray text = stack.mid(begin, end - begin);
            const auto place = [&](qsizetype at) {
                return big ? numberBytes(quint64(at), writing.little) : numberBytes(quint32(at), writing.little);
            };
            const QByteArray field = numberBytes(quint16(2), writing.little) + place(text.size());
            QVERIFY(stack.contains(field + place(begin)));
            stack.replace(field + place(begin), field + place(stack.size()));
            stack.replace(begin, text.size(), QByteArray(text.size(), '\0'));
            stack += text;
            const auto whole = builtImagesReader().probe(folder.write("pages.tif", stack), {}, {});
            QVERIFY(whole.ok());
            for (const auto cut : {text.size(), text.size() / 2, qsizetype(1)}) {
                const auto read =
                    builtImagesReader().read(folder.write("pages.tif", stack.left(stack.size() - cut)), {}, {});
                QVERIFY(!read.ok());
                QVERIFY2(read.error().text().find("cut short") != std::string::npos, read.error().text().c_str());
            }
        }
    }

    /// A file of 400 KB whose only element behind the head unpacks to 400 MB: refused before it takes that memory.
    void deflatedWithoutEnd()
    {
        const QByteArray kind = dicomText(0x00020010, "UI", "1.2.840.10008.1.2.1.99");
        const QByteArray length = dicomText(0x00020000, "UL", numberBytes(quint32(kind.size())));
        QByteArray zeros(1 << 20, '\0'), packed;
        z_stream stream{};
        QCOMPARE(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY), Z_OK);
        std::array<Bytef, 1 << 16> room{};
        for (int part = 0; part < 400; ++part) {
            stream.next_in = reinterpret_cast<Bytef*>(zeros.data());
            stream.avail_in = uInt(zeros.size());
            do {
                stream.next_out = room.data();
                stream.avail_out = room.size();
                deflate(&stream, part == 399 ? Z_FINISH : Z_NO_FLUSH);
                packed.append(reinterpret_cast<const char*>(room.data()), qsizetype(room.size() - stream.avail_out));
            } while (stream.avail_out == 0);
        }
        deflateEnd(&stream);
        const PictureFolder folder;
        const fs::path path = folder.write("a.dcm", QByteArray(128, '\0') + "DICM" + length + kind + packed);
        const auto read = builtImagesReader().read(path, {}, {});
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find("unpacks to more than") != std::string::npos, read.error().text().c_str());
    }

    /// Refused before memory is taken for pages of 800 MB.
    void packedBytesThatCannotHoldAPage()
    {
        const PictureFolder folder;
        TiffPicture page;
        page.size = {20000, 20000};
        page.bytes = QByteArray(1000, '\1');
        const auto read =
            builtImagesReader().read(folder.write("pages.tif", tiffFile({page, page}, {.packed = true})), {}, {});
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find("cannot hold") != std::string::npos, read.error().text().c_str());
    }

    void pagesInACircle()
    {
        const PictureFolder folder;
        QByteArray stack = pages({});
        stack.replace(stack.size() - 4, 4, stack.mid(4, 4)); // the link of the last page: to the first one
        const auto read = builtImagesReader().read(folder.write("pages.tif", stack), {}, {});
        QVERIFY(!read.ok());
        QVERIFY2(read.error().text().find("an earlier one") != std::string::npos, read.error().text().c_str());
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
