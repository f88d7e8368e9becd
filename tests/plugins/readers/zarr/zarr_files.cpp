// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/zarr/zarr_files.h"

#include "plugins/host/plugin_guards.h"

#include <QFile>

#include <zlib.h>
#include <zstd.h>

#include <numeric>

namespace tetra {
namespace {

/// Through all numbers below these, the last fastest.
bool advance(std::vector<int>& numbers, const std::vector<int>& ends)
{
    for (std::size_t axis = numbers.size(); axis-- > 0;) {
        if (++numbers[axis] < ends[axis])
            return true;
        numbers[axis] = 0;
    }
    return false;
}

QByteArray packedBy(const QByteArray& bytes, int windowBits)
{
    z_stream stream{};
    if (deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        qFatal("zlib does not work");
    QByteArray packed(qsizetype(deflateBound(&stream, uLong(bytes.size()))), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.constData()));
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
        qFatal("zlib does not pack");
    packed.chop(qsizetype(stream.avail_out));
    deflateEnd(&stream);
    return packed;
}

} // namespace

const Reader& builtZarrReader()
{
    static const ZarrReader reader(std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-zarr");
    static const auto guard = guarded(reader, {"zarr", [](const Error&) {}});
    return *guard;
}

void ZarrStore::write(const std::string& name, const QByteArray& content) const
{
    std::filesystem::create_directories(path(name).parent_path());
    QFile file(QString::fromStdString(path(name).string()));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write a test file");
}

std::string zarrTexts(const std::vector<Message>& messages)
{
    std::string text;
    for (const Message& message : messages)
        text += message.text() + "\n";
    return text;
}

std::string zarrTaken(const std::vector<Taken>& all, TakenPart part)
{
    const auto found = std::ranges::find(all, part, &Taken::part);
    return found == all.end() ? std::string() : takenText(*found).text();
}

void forEachChunk(const ChunkedArray& array,
                  const std::function<void(const std::vector<int>& numbers, const QByteArray& file)>& take)
{
    const std::size_t axes = array.shape.size();
    std::vector<int> order = array.order, counts, inside;
    if (order.empty()) {
        order.resize(axes);
        std::iota(order.begin(), order.end(), 0);
    }
    for (std::size_t axis = 0; axis < axes; ++axis)
        counts.push_back((array.shape[axis] - 1) / array.chunk[axis] + 1);
    for (const int axis : order)
        inside.push_back(array.chunk[std::size_t(axis)]);
    const QByteArray beyond(array.number(std::vector<int>(axes, 0)).size(), '\0');
    std::vector<int> numbers(axes, 0);
    do {
        QByteArray bytes;
        std::vector<int> place(axes, 0);
        do {
            std::vector<int> element(axes, 0);
            bool isThere = true;
            for (std::size_t at = 0; at < axes; ++at) {
                const auto axis = std::size_t(order[at]);
                element[axis] = numbers[axis] * array.chunk[axis] + place[at];
                isThere = isThere && element[axis] < array.shape[axis];
            }
            bytes += isThere ? array.number(element) : beyond;
        } while (advance(place, inside));
        take(numbers, array.pack ? array.pack(bytes) : bytes);
    } while (advance(numbers, counts));
}

void writeChunks(const ZarrStore& store, const std::string& prefix, char separator, const ChunkedArray& array)
{
    forEachChunk(array, [&](const std::vector<int>& numbers, const QByteArray& file) {
        std::string name;
        for (const int number : numbers)
            name += (name.empty() ? "" : std::string(1, separator)) + std::to_string(number);
        store.write(prefix + name, file);
    });
}

QByteArray packedByZlib(const QByteArray& bytes)
{
    return packedBy(bytes, 15);
}

QByteArray packedByGzip(const QByteArray& bytes)
{
    return packedBy(bytes, 15 + 16);
}

QByteArray packedByZstandard(const QByteArray& bytes)
{
    QByteArray packed(qsizetype(ZSTD_compressBound(std::size_t(bytes.size()))), '\0');
    const std::size_t size =
        ZSTD_compress(packed.data(), std::size_t(packed.size()), bytes.constData(), std::size_t(bytes.size()), 3);
    if (ZSTD_isError(size) != 0)
        qFatal("Zstandard does not pack");
    packed.resize(qsizetype(size));
    return packed;
}

} // namespace tetra
