// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays that wait in a file: what comes out is what went in, in order; the file has no name; a full disk is an error.
#include "core/base/scratch_file.h"
#include "tests/core/base/small_disk.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <vector>

using namespace tetra;

namespace {

template <class T> std::vector<T> contentOf(const SpooledArray<T>& array)
{
    std::vector<T> content;
    const Status read = array.forEachChunk([&](std::span<const T> chunk) -> Status {
        content.insert(content.end(), chunk.begin(), chunk.end());
        return {};
    });
    return read ? content : std::vector<T>();
}

} // namespace

class SpooledArrayTest : public QObject {
    Q_OBJECT

private slots:
    void givesBackWhatItGot_data()
    {
        QTest::addColumn<std::size_t>("count");
        for (const std::size_t count : {0u, 1u, 16'383u, 16'384u, 16'385u, 100'000u})
            QTest::addRow("%zu", count) << count;
    }
    /// Two arrays share a file without disturbing each other.
    void givesBackWhatItGot()
    {
        QFETCH(std::size_t, count);
        const QTemporaryDir folder;
        SpoolFile file(folder.path().toStdString());
        SpooledArray<std::uint64_t> numbers(file);
        SpooledArray<std::uint8_t> bytes(file);
        std::vector<std::uint64_t> expectedNumbers;
        std::vector<std::uint8_t> expectedBytes;
        for (std::size_t i = 0; i < count; ++i) {
            numbers.push_back(i * i);
            bytes.push_back(static_cast<std::uint8_t>(i % 251));
            expectedNumbers.push_back(i * i);
            expectedBytes.push_back(static_cast<std::uint8_t>(i % 251));
        }
        QCOMPARE(numbers.size(), count);
        QVERIFY(contentOf(numbers) == expectedNumbers);
        QVERIFY(contentOf(bytes) == expectedBytes);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    /// Elements that are appended together lie as if one by one, wherever chunks end.
    void takesManyAtOnce()
    {
        const QTemporaryDir folder;
        SpoolFile file(folder.path().toStdString());
        SpooledArray<std::uint32_t> numbers(file);
        std::vector<std::uint32_t> expected;
        for (const std::uint32_t count : {0u, 3u, 16'381u, 1u, 40'000u, 0u, 16'384u, 7u}) {
            std::vector<std::uint32_t> some;
            for (std::uint32_t i = 0; i < count; ++i)
                some.push_back(static_cast<std::uint32_t>(expected.size()) + i);
            numbers.append(some);
            expected.insert(expected.end(), some.begin(), some.end());
        }
        QCOMPARE(numbers.size(), expected.size());
        QVERIFY(contentOf(numbers) == expected);
    }

    void stopsWhereTheReaderStops()
    {
        const QTemporaryDir folder;
        SpoolFile file(folder.path().toStdString());
        SpooledArray<int> numbers(file);
        for (int i = 0; i < 40'000; ++i)
            numbers.push_back(i);
        int visits = 0;
        const Status read = numbers.forEachChunk([&](std::span<const int>) -> Status {
            ++visits;
            return Error{ErrorKind::CannotWrite, "enough"};
        });
        QCOMPARE(visits, 1);
        QCOMPARE(read.error().text(), std::string("enough"));
    }

    void aFullDiskIsAnError()
    {
        const SmallDisk disk(256 << 10);
        if (!disk.ok())
            QSKIP("skipped: mounting is not allowed here");
        SpoolFile file(disk.folder());
        SpooledArray<std::uint64_t> numbers(file);
        for (std::uint64_t i = 0; i < 100'000; ++i)
            numbers.push_back(i);
        QVERIFY(!file.status());
        QCOMPARE(file.status().error().kind, ErrorKind::CannotWrite);
        QVERIFY(contentOf(numbers).empty());
    }

    void aFolderThatIsNotThereIsAnError()
    {
        SpoolFile file("/no/such/folder");
        QVERIFY(!file.append(std::as_bytes(std::span("x"))));
        QVERIFY(file.status().error().text().find("/no/such/folder") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(SpooledArrayTest)
#include "spooled_array_test.moc"
