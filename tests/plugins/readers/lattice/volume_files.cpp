// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/lattice/volume_files.h"

#include <QFile>

#include <zlib.h>

#include <algorithm>
#include <array>

namespace tetra {

QByteArray testSamples(SampleType type, std::endian order)
{
    QByteArray bytes;
    visitSampleType(type, [&]<class T>() {
        for (int n = 0; n < testPoints; ++n) {
            auto sample = std::bit_cast<std::array<char, sizeof(T)>>(static_cast<T>(n));
            if (order != std::endian::native)
                std::ranges::reverse(sample);
            bytes.append(sample.data(), sizeof(T));
        }
    });
    return bytes;
}

QByteArray gzipped(const QByteArray& content)
{
    z_stream state{};
    if (::deflateInit2(&state, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        return {};
    QByteArray packed(static_cast<qsizetype>(::deflateBound(&state, static_cast<uLong>(content.size()))), 0);
    state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    state.avail_in = static_cast<uInt>(content.size());
    state.next_out = reinterpret_cast<Bytef*>(packed.data());
    state.avail_out = static_cast<uInt>(packed.size());
    ::deflate(&state, Z_FINISH);
    packed.resize(static_cast<qsizetype>(state.total_out));
    ::deflateEnd(&state);
    return packed;
}

QByteArray nrrdHeader(const QByteArray& fields)
{
    QByteArray header = "NRRD0004\n" + fields;
    const auto addUnlessGiven = [&](const QByteArray& name, const QByteArray& value) {
        if (!header.contains("\n" + name + ":"))
            header += name + ": " + value + "\n";
    };
    addUnlessGiven("dimension", "3");
    addUnlessGiven("sizes", "3 4 5");
    addUnlessGiven("type", "uint8");
    addUnlessGiven("encoding", "raw");
    return header + "\n";
}

bool holdsTestSamples(const ScalarField& values)
{
    if (values.count() != testPoints)
        return false;
    for (std::uint64_t n = 0; n < testPoints; ++n)
        if (values.at(n) != static_cast<double>(n))
            return false;
    return true;
}

std::filesystem::path TestFolder::write(const QByteArray& name, const QByteArray& content) const
{
    QFile file(folder_.filePath(QString::fromUtf8(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        return {};
    return file.fileName().toStdString();
}

} // namespace tetra
