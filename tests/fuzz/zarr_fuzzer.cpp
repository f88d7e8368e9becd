// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of Zarr: a byte for what the metadata are of, an array or an image of version 2 or 3, two for their
// length, the metadata, and the bytes of the first chunk.
#include "plugins/readers/zarr/helper/zarr_choice.h"
#include "plugins/readers/zarr/helper/zarr_samples.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

#include <array>

namespace {

using namespace tetra;

/// Where the metadata go, and what else there is: of an image its only level.
struct Store {
    std::string folder, metadata, level, levelText;
};

const std::array<Store, 4>& stores()
{
    static const std::array<Store, 4> all = {
        {{"array2", ".zarray", "", ""},
         {"array3", "zarr.json", "", ""},
         {"image2", ".zattrs", "0/.zarray",
          R"({"zarr_format": 2, "shape": [2, 3, 4], "chunks": [2, 3, 4], "dtype": "|u1", "order": "C",)"
          R"( "fill_value": 0, "compressor": null, "filters": null})"},
         {"image3", "zarr.json", "0/zarr.json",
          R"({"zarr_format": 3, "node_type": "array", "shape": [2, 3, 4], "data_type": "uint8", "fill_value": 0,)"
          R"( "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [2, 3, 4]}},)"
          R"( "chunk_key_encoding": {"name": "default"}, "codecs": [{"name": "bytes"}]})"}}};
    return all;
}

void writeStore(const FuzzFolder& folder, const Store& store, std::span<const std::byte> metadata,
                std::span<const std::byte> chunk)
{
    const std::string array = store.folder + (store.level.empty() ? "/" : "/0/");
    std::filesystem::create_directories(folder.path() / (array + "c/0/0"));
    folder.write(store.folder + "/" + store.metadata, metadata);
    if (!store.level.empty())
        folder.write(store.folder + "/" + store.level, asBytes(store.levelText));
    for (const char* const name : {"0.0.0", "0.0.0.0", "c/0/0/0"})
        folder.write(array + name, chunk);
}

bool isSmall(const ZarrChoice& choice)
{
    constexpr std::uint64_t mostPoints = 4096, mostBytes = std::uint64_t(1) << 22U;
    return choice.lattice.pointCount() <= mostPoints &&
           choice.array.chunks.numberCount() <= mostBytes / storedSize(choice.array.number);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    constexpr std::size_t headBytes = 3;
    if (size < headBytes)
        return 0;
    static const FuzzFolder folder;
    const Store& store = stores()[bytes[0] % stores().size()];
    const auto rest = std::as_bytes(std::span(bytes, size)).subspan(headBytes);
    const std::size_t metadataBytes = std::min<std::size_t>(bytes[1] + 256 * bytes[2], rest.size());
    writeStore(folder, store, rest.first(metadataBytes), rest.subspan(metadataBytes));

    ZarrRequest request;
    request.folder = (folder.path() / store.folder).string();
    const auto opened = ZarrFolder::open(request.folder);
    require(opened.ok(), "a folder is opened");
    const auto choice = chooseZarr(*opened, request);
    if (!choice) {
        requireText(choice.error());
        return 0;
    }
    require((choice->lattice.spacing.array() > 0).all(), "spacings are positive");
    for (const Taken& taken : choice->taken)
        requireText({ErrorKind::BadInput, Message::say("it is taken: %1", taken.what)});
    if (!isSmall(*choice))
        return 0;
    const auto read = readZarrSamples(*opened, choice->array, choice->selection, [](double) {});
    if (read)
        require(read->samples.size() == choice->lattice.pointCount() * sampleSize(read->type), "one sample a point");
    else
        requireText(read.error());
    return 0;
}
