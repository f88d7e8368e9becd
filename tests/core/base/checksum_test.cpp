// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"

#include <QTest>

#include <string_view>
#include <vector>

using namespace tetra;

class ChecksumTest : public QObject {
    Q_OBJECT

private slots:
    /// The value that the XXH3 specification gives for no bytes at all: files stay readable.
    void isXxh3() { QCOMPARE(checksum({}), 0x2d06800538d394c2ull); }

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
        const std::uint64_t before = checksum(bytes);
        for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
            bytes[bit / 8] ^= std::byte(1u << bit % 8);
            QVERIFY(checksum(bytes) != before);
            bytes[bit / 8] ^= std::byte(1u << bit % 8);
        }
    }
};

QTEST_GUILESS_MAIN(ChecksumTest)
#include "checksum_test.moc"
