// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"

#include <QTest>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

using namespace tetra;

class ChecksumTest : public QObject {
    Q_OBJECT

private slots:
    /// The values that the authors of XXH3 publish, with how they make the bytes: of each of its ways, which the length
    /// chooses. Files stay readable.
    void isXxh3_data()
    {
        QTest::addColumn<quint32>("length");
        QTest::addColumn<quint64>("expected");
        const auto row = [](quint32 length, quint64 expected) {
            QTest::addRow("%u bytes", length) << length << expected;
        };
        row(0, 0x2d06800538d394c2);
        row(1, 0xc44bdff4074eecdb);
        row(6, 0x27b56a84cd2d7325);
        row(12, 0xa713daf0dfbb77e7);
        row(24, 0xa3fe70bf9d3510eb);
        row(48, 0x397da259ecba1f11);
        row(80, 0xbcdefbbb2c47c90a);
        row(195, 0xcd94217ee362ec3a);
        row(403, 0xcdeb804d65c6dea4);
        row(512, 0x617e49599013cb6b);
        row(2048, 0xdd59e2c3a5f038e0);
        row(2240, 0x6e73a90539cf2948);
        row(2367, 0xcb37aeb9e5d361ed);
    }
    void isXxh3()
    {
        QFETCH(quint32, length);
        QFETCH(quint64, expected);
        std::vector<std::byte> bytes(length);
        std::uint64_t generator = 2654435761;
        for (std::byte& byte : bytes) {
            byte = std::byte(generator >> 56);
            generator *= 11400714785074694797u;
        }
        QCOMPARE(checksum(bytes), expected);
        Checksum pieces;
        pieces.add(bytes);
        QCOMPARE(pieces.value(), expected);
    }

    void piecesGiveTheSameAsTheWhole()
    {
        std::vector<std::byte> bytes(100'000);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::byte>(i * i >> 3);
        for (const std::size_t piece : {1u, 63u, 1024u, 99'999u}) {
            Checksum pieces;
            for (std::size_t at = 0; at < bytes.size(); at += piece)
                pieces.add(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)));
            QCOMPARE(pieces.value(), checksum(bytes));
        }
    }

    void oneBitChangesIt()
    {
        std::vector<std::byte> bytes(1000);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::byte>(i * i >> 2);
        std::set<std::uint64_t> sums{checksum(bytes)};
        for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
            bytes[bit / 8] ^= std::byte(1u << bit % 8);
            QVERIFY(sums.insert(checksum(bytes)).second); // each in its own way
            bytes[bit / 8] ^= std::byte(1u << bit % 8);
        }
        std::swap(bytes[3], bytes[700]);
        QVERIFY(sums.insert(checksum(bytes)).second);
    }
};

QTEST_GUILESS_MAIN(ChecksumTest)
#include "checksum_test.moc"
