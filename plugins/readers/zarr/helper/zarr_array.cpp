// SPDX-License-Identifier: GPL-3.0-or-later
// The formats: https://zarr-specs.readthedocs.io (core protocol, versions 2 and 3; codecs; sharding).
#include "plugins/readers/zarr/helper/zarr_array.h"

#include "plugins/readers/zarr/helper/zarr_json.h"

#include <QJsonArray>

#include <algorithm>
#include <limits>
#include <numeric>

namespace tetra {
namespace {

/// Metadata that cannot be read, of the array at `path`.
Error badArray(const std::string& path, const Message& what)
{
    return {ErrorKind::BadInput, path.empty() ? what : Message::say("its array '%1': %2", printable(path), what)};
}

Error lacks(const char* key)
{
    return {ErrorKind::BadInput, Message::say("its metadata have no usable '%1'. Copy or export it again.", key)};
}

Error isNotRead(const Message& what, const Message& instead)
{
    return {ErrorKind::BadInput, Message::say("%1, which TAn does not read. %2", what, instead)};
}

const Message& writeWithUsual()
{
    static const Message text = Message::say("Write it with Blosc, Zstandard, gzip or zlib.");
    return text;
}

std::string nameOf(const QJsonValue& value)
{
    return printable(jsonText(value).value_or("?"));
}

/// Sizes from 1 of one chunk along each axis, of not more bytes than memory can be asked for.
Status checkChunkShape(const std::vector<std::uint64_t>& shape, std::size_t axes, std::size_t numberSize)
{
    if (shape.size() != axes)
        return Error{ErrorKind::BadInput,
                     Message::say("its chunks have %1 axes, and it has %2. It is damaged.", shape.size(), axes)};
    std::uint64_t bytes = numberSize;
    for (const std::uint64_t size : shape) {
        if (size == 0)
            return Error{ErrorKind::BadInput, Message::say("its chunks have no size. It is damaged.")};
        if (size > std::uint64_t(std::numeric_limits<std::int64_t>::max()) / bytes)
            return Error{ErrorKind::BadInput,
                         Message::say("its chunks would have more bytes than any machine. It is damaged.")};
        bytes *= size;
    }
    return {};
}

std::vector<std::size_t> orderOf(std::size_t axes, bool isReversed)
{
    std::vector<std::size_t> order(axes);
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (isReversed)
        std::ranges::reverse(order);
    return order;
}

/// The names that xarray gives the axes.
std::vector<std::string> namesOfAxes(const QJsonValue& value, std::size_t axes)
{
    const QJsonArray list = value.toArray();
    std::vector<std::string> names;
    for (const QJsonValue entry : list)
        names.push_back(jsonText(entry).value_or(std::string()));
    const bool isAny = std::ranges::any_of(names, [](const std::string& name) { return !name.empty(); });
    return names.size() == axes && isAny ? names : std::vector<std::string>();
}

/// Each is undone for each chunk, and may have made it longer: nobody takes more than a few.
Status checkCodecs(const ZarrChunks& chunks)
{
    constexpr std::size_t most = 32;
    if (chunks.codecs.size() <= most)
        return {};
    return isNotRead(Message::say("its chunks were passed through %1 codecs, more than %2", chunks.codecs.size(), most),
                     writeWithUsual());
}

// Version 2.

/// The compressor of version 2.
Status addCompressor(const QJsonValue& value, ZarrArray& array)
{
    if (value.isNull() || value.isUndefined())
        return {};
    const std::string id = jsonText(value.toObject().value("id")).value_or("?");
    ZarrCodec codec;
    if (id == "zlib")
        codec.kind = ZarrCodec::Kind::Zlib;
    else if (id == "gzip")
        codec.kind = ZarrCodec::Kind::Gzip;
    else if (id == "zstd")
        codec.kind = ZarrCodec::Kind::Zstd;
    else if (id == "blosc")
        codec.kind = ZarrCodec::Kind::Blosc;
    else
        return isNotRead(Message::say("its chunks are packed by '%1'", printable(id)), writeWithUsual());
    array.chunks.codecs.push_back(codec);
    return {};
}

/// A filter of version 2, if it leaves numbers of the array's type.
Status addFilter(const QJsonObject& filter, const std::string& type, ZarrArray& array)
{
    const std::string id = jsonText(filter.value("id")).value_or("?");
    const auto isOfType = [&](const char* key) {
        return filter.value(key).isUndefined() || jsonText(filter.value(key)) == type;
    };
    ZarrCodec codec;
    if (id == "bitround" || (id == "quantize" && isOfType("dtype") && isOfType("astype")))
        return {}; // rounded when it was written: nothing to undo
    if (id == "shuffle") {
        const qint64 size = filter.value("elementsize").toInteger(4);
        if (size < 1 || size > 1024)
            return lacks("elementsize");
        codec.kind = ZarrCodec::Kind::Shuffle;
        codec.elementSize = static_cast<std::size_t>(size);
    } else if (id == "delta" && isOfType("dtype") && isOfType("astype")) {
        codec.kind = ZarrCodec::Kind::Delta;
        codec.number = array.number;
        codec.elementSize = storedSize(array.number);
        codec.isBigEndian = array.chunks.isBigEndian;
    } else {
        return isNotRead(Message::say("its numbers were passed through the filter '%1'", printable(id)),
                         Message::say("Write it without filters."));
    }
    array.chunks.codecs.push_back(codec);
    return {};
}

Status readCoding2(const QJsonObject& metadata, const std::string& type, ZarrArray& array)
{
    for (const QJsonValue filter : metadata.value("filters").toArray())
        if (const Status added = addFilter(filter.toObject(), type, array); !added)
            return added;
    if (const Status added = addCompressor(metadata.value("compressor"), array); !added)
        return added;
    if (const Status few = checkCodecs(array.chunks); !few)
        return few;
    const std::string order = jsonText(metadata.value("order")).value_or("C");
    if (order != "C" && order != "F")
        return lacks("order");
    array.chunks.order = orderOf(array.shape.size(), order == "F");
    const QJsonValue separator = metadata.value("dimension_separator");
    array.separatorIsSaid = !separator.isUndefined() && !separator.isNull();
    const std::string separatorText = jsonText(separator).value_or(".");
    if (separatorText != "." && separatorText != "/")
        return lacks("dimension_separator");
    array.separator = separatorText[0];
    return {};
}

Status readFill(const QJsonValue& value, ZarrArray& array)
{
    array.fillIsSaid = !value.isNull() && !value.isUndefined();
    const auto fill = keptNumber(array.number, array.fillIsSaid ? value : QJsonValue(0));
    if (!fill)
        return lacks("fill_value");
    array.fill = *fill;
    return {};
}

Result<ZarrArray> arrayOfVersion2(const std::string& path, const ZarrNode& node)
{
    ZarrArray array;
    array.path = path;
    array.attributes = node.attributes;
    const auto shape = jsonCounts(node.metadata.value("shape"));
    if (!shape)
        return lacks("shape");
    array.shape = *shape;
    const QJsonValue typeValue = node.metadata.value("dtype");
    if (!typeValue.isString() && !typeValue.isArray())
        return lacks("dtype");
    const std::string type = jsonText(typeValue).value_or("");
    const auto number = zarrNumberOfVersion2(type);
    if (!number)
        return isNotRead(type.empty() ? Message::say("its elements are records of several fields")
                                      : Message::say("its elements are of the type '%1'", printable(type)),
                         Message::say("Write whole numbers, or floating-point numbers of 16, 32 or 64 bits."));
    array.number = number->number;
    array.chunks.isBigEndian = number->isBigEndian;
    const auto chunks = jsonCounts(node.metadata.value("chunks"));
    if (!chunks)
        return lacks("chunks");
    array.chunks.shape = *chunks;
    if (const Status sound = checkChunkShape(*chunks, shape->size(), storedSize(array.number)); !sound)
        return sound.error();
    if (const Status understood = readCoding2(node.metadata, type, array); !understood)
        return understood.error();
    if (const Status understood = readFill(node.metadata.value("fill_value"), array); !understood)
        return understood.error();
    array.axisNames = namesOfAxes(node.attributes.value("_ARRAY_DIMENSIONS"), array.shape.size());
    return array;
}

// Version 3.

/// What a codec, a grid or an encoding of version 3 is called: an object with a name, or the name alone.
std::string namedOf(const QJsonValue& value)
{
    return jsonText(value.isString() ? value : value.toObject().value("name")).value_or("?");
}

QJsonObject configurationOf(const QJsonValue& value)
{
    return value.toObject().value("configuration").toObject();
}

Status readEndian(const QJsonObject& configuration, ZarrNumber number, bool& isBigEndian)
{
    const QJsonValue endian = configuration.value("endian");
    const auto text = jsonText(endian);
    const bool isNeeded = storedSize(number) > 1;
    if (text ? *text != "big" && *text != "little" : isNeeded)
        return lacks("endian");
    isBigEndian = text == "big";
    return {};
}

/// Applies the codec 'transpose' to the axes as they lie so far.
Status transpose(const QJsonObject& configuration, std::vector<std::size_t>& order)
{
    const QJsonValue said = configuration.value("order");
    if (said == QJsonValue("C"))
        return {};
    if (said == QJsonValue("F")) {
        std::ranges::reverse(order);
        return {};
    }
    const auto wanted = jsonCounts(said);
    if (!wanted || wanted->size() != order.size())
        return lacks("order");
    std::vector<std::size_t> result;
    std::vector<bool> isUsed(order.size());
    for (const std::uint64_t axis : *wanted) {
        if (axis >= order.size() || isUsed[axis])
            return lacks("order");
        isUsed[axis] = true;
        result.push_back(order[axis]);
    }
    order = std::move(result);
    return {};
}

/// A codec that makes bytes of bytes; nothing if it is another one.
std::optional<ZarrCodec::Kind> packingOf(const std::string& name)
{
    if (name == "gzip")
        return ZarrCodec::Kind::Gzip;
    if (name == "zstd")
        return ZarrCodec::Kind::Zstd;
    if (name == "blosc")
        return ZarrCodec::Kind::Blosc;
    if (name == "crc32c")
        return ZarrCodec::Kind::Checksum;
    return std::nullopt;
}

/// The codecs up to the bytes, and those of the bytes. `shards` gets the configuration of sharding_indexed if that
/// stands in the place of the bytes.
Status readCodecs(const QJsonValue& list, ZarrNumber number, ZarrChunks& chunks, std::optional<QJsonObject>* shards)
{
    bool areBytes = false;
    for (const QJsonValue codec : list.toArray()) {
        const std::string name = namedOf(codec);
        const auto packing = packingOf(name);
        Status understood;
        if (areBytes && packing && (shards == nullptr || !*shards)) {
            chunks.codecs.push_back({.kind = *packing});
        } else if (!areBytes && name == "transpose") {
            understood = transpose(configurationOf(codec), chunks.order);
        } else if (!areBytes && (name == "bytes" || name == "endian")) {
            areBytes = true;
            understood = readEndian(configurationOf(codec), number, chunks.isBigEndian);
        } else if (!areBytes && name == "sharding_indexed" && shards != nullptr &&
                   std::ranges::is_sorted(chunks.order)) {
            areBytes = true;
            *shards = configurationOf(codec);
        } else {
            const bool isKnown = packing || name == "transpose" || name == "bytes" || name == "sharding_indexed";
            understood = isKnown
                             ? isNotRead(Message::say("its codec '%1' is in an unusual place", printable(name)),
                                         writeWithUsual())
                             : isNotRead(Message::say("its chunks were passed through the codec '%1'", printable(name)),
                                         writeWithUsual());
        }
        if (!understood)
            return understood;
    }
    return areBytes ? Status() : lacks("codecs");
}

/// Chunks within shards: the shape that the grid gives is the shards'.
Status readShards(const QJsonObject& configuration, ZarrArray& array)
{
    ZarrShards shards{array.chunks.shape};
    const auto shape = jsonCounts(configuration.value("chunk_shape"));
    if (!shape)
        return lacks("chunk_shape");
    if (const Status sound = checkChunkShape(*shape, array.shape.size(), storedSize(array.number)); !sound)
        return sound;
    for (std::size_t axis = 0; axis < shape->size(); ++axis)
        if (shards.shape[axis] % (*shape)[axis] != 0)
            return Error{ErrorKind::BadInput,
                         Message::say("its shards are not a whole number of chunks. It is damaged.")};
    array.chunks.shape = *shape;
    if (const Status read = readCodecs(configuration.value("codecs"), array.number, array.chunks, nullptr); !read)
        return read;
    ZarrChunks index;
    if (const Status read = readCodecs(configuration.value("index_codecs"), ZarrNumber::UInt64, index, nullptr); !read)
        return read;
    const bool isPlain =
        index.codecs.empty() || (index.codecs.size() == 1 && index.codecs[0].kind == ZarrCodec::Kind::Checksum);
    if (!isPlain)
        return isNotRead(Message::say("the index of its shards is packed"), Message::say("Write it unpacked."));
    shards.indexHasChecksum = !index.codecs.empty();
    shards.indexIsBigEndian = index.isBigEndian;
    const std::string location = jsonText(configuration.value("index_location")).value_or("end");
    if (location != "start" && location != "end")
        return lacks("index_location");
    shards.indexIsFirst = location == "start";
    array.shards = std::move(shards);
    return {};
}

Status readNaming3(const QJsonObject& metadata, ZarrArray& array)
{
    const QJsonValue encoding = metadata.value("chunk_key_encoding");
    const std::string name = encoding.isUndefined() ? "default" : namedOf(encoding);
    if (name != "default" && name != "v2")
        return isNotRead(Message::say("the names of its chunks are of the kind '%1'", printable(name)),
                         Message::say("Write it with the names 'default'."));
    array.namesBeginWithC = name == "default";
    const std::string separator =
        jsonText(configurationOf(encoding).value("separator")).value_or(array.namesBeginWithC ? "/" : ".");
    if (separator != "." && separator != "/")
        return lacks("separator");
    array.separator = separator[0];
    return {};
}

/// Extensions that may be passed over say so.
Status checkTransformers(const QJsonObject& metadata)
{
    const QJsonArray transformers = metadata.value("storage_transformers").toArray();
    if (transformers.isEmpty())
        return {};
    return isNotRead(Message::say("it has the storage transformer '%1'", printable(namedOf(transformers.first()))),
                     Message::say("Write it without one."));
}

Result<ZarrArray> arrayOfVersion3(const std::string& path, const ZarrNode& node)
{
    ZarrArray array;
    array.path = path;
    array.version = 3;
    array.attributes = node.attributes;
    const QJsonObject& metadata = node.metadata;
    const auto shape = jsonCounts(metadata.value("shape"));
    if (!shape)
        return lacks("shape");
    array.shape = *shape;
    const std::string type = namedOf(metadata.value("data_type"));
    const auto number = zarrNumberOfVersion3(type);
    if (!number)
        return isNotRead(Message::say("its elements are of the type '%1'", printable(type)),
                         Message::say("Write whole numbers, or floating-point numbers of 16, 32 or 64 bits."));
    array.number = *number;
    const QJsonValue grid = metadata.value("chunk_grid");
    if (namedOf(grid) != "regular")
        return isNotRead(Message::say("its chunks lie in a grid of the kind '%1'", printable(namedOf(grid))),
                         Message::say("Write it in chunks of one size."));
    const auto chunks = jsonCounts(configurationOf(grid).value("chunk_shape"));
    if (!chunks)
        return lacks("chunk_shape");
    array.chunks.shape = *chunks;
    array.chunks.order = orderOf(shape->size(), false);
    std::optional<QJsonObject> shards;
    for (const Status& read :
         {checkChunkShape(*chunks, shape->size(), storedSize(array.number)),
          readCodecs(metadata.value("codecs"), array.number, array.chunks, &shards), readNaming3(metadata, array),
          readFill(metadata.value("fill_value"), array), checkTransformers(metadata)})
        if (!read)
            return read.error();
    if (shards)
        if (const Status read = readShards(*shards, array); !read)
            return read.error();
    if (const Status few = checkCodecs(array.chunks); !few)
        return few.error();
    const QJsonValue names = metadata.value("dimension_names");
    array.axisNames = namesOfAxes(names.isArray() ? names : node.attributes.value("_ARRAY_DIMENSIONS"), shape->size());
    return array;
}

Result<ZarrNode> nodeOfVersion3(const QJsonObject& metadata)
{
    ZarrNode node;
    node.version = 3;
    const qint64 version = metadata.value("zarr_format").toInteger(-1);
    if (version != 3)
        return isNotRead(Message::say("it is of version %1 of Zarr's format", version),
                         Message::say("TAn reads the versions 2 and 3."));
    const std::string kind = nameOf(metadata.value("node_type"));
    if (kind != "array" && kind != "group")
        return lacks("node_type");
    node.kind = kind == "array" ? ZarrNode::Kind::Array : ZarrNode::Kind::Group;
    node.metadata = metadata;
    node.attributes = metadata.value("attributes").toObject();
    return node;
}

} // namespace

Result<ZarrNode> zarrNode(const ZarrFolder& folder, const std::string& path)
{
    const auto whole = folder.json(zarrPath(path, "zarr.json"));
    if (!whole)
        return whole.error();
    if (*whole) {
        auto node = nodeOfVersion3(**whole);
        return node ? node : badArray(path, node.error().message);
    }
    ZarrNode node;
    const auto array = folder.json(zarrPath(path, ".zarray"));
    if (!array)
        return array.error();
    const auto group = folder.json(zarrPath(path, ".zgroup"));
    if (!group)
        return group.error();
    const auto attributes = folder.json(zarrPath(path, ".zattrs"));
    if (!attributes)
        return attributes.error();
    if (*array || *group || *attributes)
        node.kind = *array ? ZarrNode::Kind::Array : ZarrNode::Kind::Group;
    node.metadata = array->value_or(group->value_or(QJsonObject()));
    node.attributes = attributes->value_or(QJsonObject());
    const qint64 version = node.metadata.value("zarr_format").toInteger(node.metadata.isEmpty() ? 2 : -1);
    if (version != 2)
        return badArray(path, isNotRead(Message::say("it is of version %1 of Zarr's format", version),
                                        Message::say("TAn reads the versions 2 and 3."))
                                  .message);
    return node;
}

Result<ZarrArray> zarrArray(const std::string& path, const ZarrNode& node)
{
    auto array = node.version == 3 ? arrayOfVersion3(path, node) : arrayOfVersion2(path, node);
    return array ? array : badArray(path, array.error().message);
}

std::string chunkName(const ZarrArray& array, const std::vector<std::uint64_t>& numbers)
{
    std::string name = array.namesBeginWithC ? "c" : "";
    for (const std::uint64_t number : numbers) {
        if (!name.empty())
            name += array.separator;
        name += std::to_string(number);
    }
    return name.empty() ? "0" : name;
}

} // namespace tetra
