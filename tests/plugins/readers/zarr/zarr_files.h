// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/zarr/zarr_reader.h"

#include <tan/data.h>

#include <QByteArray>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tetra {

/// The reader with the program of this build, as the program has it.
const Reader& builtZarrReader();

/// A folder for files that live as long as the test; folders are made as names ask for them.
class ZarrStore {
public:
    std::filesystem::path path(const std::string& name = "") const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    void write(const std::string& name, const QByteArray& content) const;

private:
    QTemporaryDir folder_;
};

/// All sentences in a row, to look for words in them.
std::string zarrTexts(const std::vector<Message>& messages);
/// What was taken of one part; empty if nothing is said of it.
std::string zarrTaken(const std::vector<Taken>& all, TakenPart part);

/// A number as it stands in a chunk.
template <class T> QByteArray chunkNumber(T value, bool isBig)
{
    QByteArray bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (isBig)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// The numbers of an array of this shape, cut into chunks, each with what lies beyond the array as 0: `number` makes
/// the bytes of an element; `order` names the axes from the slowest to the fastest; `pack` makes a file of a chunk;
/// `name` names it by the chunk's numbers.
struct ChunkedArray {
    std::vector<int> shape, chunk;
    std::vector<int> order; ///< empty: as they are
    std::function<QByteArray(const std::vector<int>&)> number{};
    std::function<QByteArray(const QByteArray&)> pack{};
};
void forEachChunk(const ChunkedArray& array,
                  const std::function<void(const std::vector<int>& numbers, const QByteArray& file)>& take);

/// Writes the chunks into a folder of the store, "0/1/2" or "0.1.2" behind `prefix`.
void writeChunks(const ZarrStore& store, const std::string& prefix, char separator, const ChunkedArray& array);

QByteArray packedByZlib(const QByteArray& bytes);
QByteArray packedByGzip(const QByteArray& bytes);
QByteArray packedByZstandard(const QByteArray& bytes);

} // namespace tetra
