// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {
namespace {

// The numbers of glTF 2.0 (ISO/IEC 12113), 3.6.2 and 4.4.
constexpr std::uint32_t magic = 0x46546c67;
constexpr std::uint32_t jsonChunk = 0x4e4f534a;
constexpr std::uint32_t binaryChunk = 0x004e4942;
constexpr int floatType = 5126;
constexpr int unsignedIntType = 5125;
constexpr int vertexTarget = 34962;
constexpr int indexTarget = 34963;

/// glTF's colours are linear.
float linear(float channel)
{
    return channel <= 0.04045F ? channel / 12.92F : std::pow((channel + 0.055F) / 1.055F, 2.4F);
}

/// glTF's factors are from 0 to 1; what is not a number is 0.
float factor(float channel)
{
    return channel > 0 ? std::min(channel, 1.0F) : 0.0F;
}

std::string triple(const Eigen::Vector3f& vector)
{
    return "[" + formatNumber(vector[0]) + "," + formatNumber(vector[1]) + "," + formatNumber(vector[2]) + "]";
}

/// How many bytes the letter at the front of a text has in UTF-8; 0 if it is none.
std::size_t letterBytes(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0), second = byte(1);
    std::size_t bytes = 1;
    if (first >= 0x80)
        bytes = first < 0xc2 || first > 0xf4 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    for (std::size_t i = 1; i < bytes; ++i)
        if ((byte(i) & 0xc0U) != 0x80)
            return 0;
    const bool isTooLong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool isNoLetter = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    return isTooLong || isNoLetter ? 0 : bytes;
}

/// In quotes. What is no UTF-8, such as an old file's name, becomes U+FFFD.
std::string jsonString(std::string_view text)
{
    constexpr std::string_view special = "\"\\\b\f\n\r\t", names = "\"\\bfnrt", digits = "0123456789abcdef";
    std::string quoted = "\"";
    while (!text.empty()) {
        const std::size_t bytes = letterBytes(text);
        const auto first = static_cast<unsigned char>(text[0]);
        if (const auto found = special.find(text[0]); found != std::string_view::npos)
            quoted += {'\\', names[found]};
        else if (first < 0x20)
            quoted += {'\\', 'u', '0', '0', digits[first / 16], digits[first % 16]};
        else
            quoted += bytes > 0 ? text.substr(0, bytes) : "\xef\xbf\xbd";
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return quoted + '"';
}

void append(std::string& list, const std::string& entry)
{
    (list += list.empty() ? "" : ",") += entry;
}

/// The triangles of each part.
using KeptTriangles = std::vector<TrianglesInFloats>;

/// The JSON part, and where each array will lie in the binary one. Parts without triangles are left out: glTF has no
/// empty arrays.
class Head {
public:
    /// Positions are less than the data's by `shift`, which the node above all adds.
    Head(const SurfaceContent& content, const KeptTriangles& kept, const Eigen::Vector3d& shift) : shift_(shift)
    {
        for (std::size_t part = 0; part < kept.size(); ++part)
            if (kept[part].count() > 0)
                add(content.parts[part], kept[part].count(), content.valueName);
        text_ = R"({"asset":{"version":"2.0","generator":"TAn"},"scene":0,"scenes":[{"name":)" +
                jsonString(content.title) + extras(content.facts) + (meshes_.empty() ? "}]" : R"(,"nodes":[0]}])");
        if (!meshes_.empty())
            addTree();
        text_ += "}";
        text_.resize((text_.size() + 3) / 4 * 4, ' ');
    }
    const std::string& text() const { return text_; }
    std::uint64_t binaryBytes() const { return offset_; }

private:
    /// In the data z points up, in glTF y: a node above all others turns them.
    void addTree()
    {
        std::string children;
        for (int child = 1; child <= count_; ++child)
            append(children, std::to_string(child));
        // Column by column; the last one adds the shift, turned likewise.
        const std::string moved =
            formatNumber(shift_[0]) + "," + formatNumber(shift_[2]) + "," + formatNumber(0 - shift_[1]);
        text_ += R"(,"nodes":[{"name":"z up","matrix":[1,0,0,0,0,0,-1,0,0,1,0,0,)" + moved + R"(,1],"children":[)" +
                 children + "]}," + nodes_ + R"(],"meshes":[)" + meshes_ + R"(],"materials":[)" + materials_ +
                 R"(],"accessors":[)" + accessors_ + R"(],"bufferViews":[)" + views_ +
                 R"(],"buffers":[{"byteLength":)" + std::to_string(offset_) + "}]";
    }

    static std::string extras(const MeshFacts& facts)
    {
        std::string list;
        for (const auto& [name, fact] : facts) {
            const auto* number = std::get_if<double>(&fact);
            const bool finite = number != nullptr && std::isfinite(*number);
            append(list, jsonString(name) + ":" + (finite ? formatNumber(*number) : jsonString(factText(fact))));
        }
        return list.empty() ? "" : ",\"extras\":{" + list + "}";
    }

    /// The number of the new accessor.
    std::string accessor(std::uint64_t count, std::size_t components, int type, int target, const std::string& more)
    {
        const std::uint64_t bytes = count * components * 4;
        append(views_, R"({"buffer":0,"byteOffset":)" + std::to_string(offset_) + R"(,"byteLength":)" +
                           std::to_string(bytes) + R"(,"target":)" + std::to_string(target) + "}");
        append(accessors_, R"({"bufferView":)" + std::to_string(viewCount_) + R"(,"componentType":)" +
                               std::to_string(type) + R"(,"count":)" + std::to_string(count) + R"(,"type":)" +
                               (components == 3 ? "\"VEC3\"" : "\"SCALAR\"") + more + "}");
        offset_ += bytes;
        return std::to_string(viewCount_++);
    }

    void add(const SurfacePart& part, std::uint64_t triangles, const std::string& valueName)
    {
        Eigen::Vector3d least = part.positions[0];
        Eigen::Vector3d most = least;
        for (const Eigen::Vector3d& position : part.positions) {
            least = least.cwiseMin(position);
            most = most.cwiseMax(position);
        }
        const std::uint64_t count = part.positions.size();
        const auto vectors = [&](const std::string& more) { return accessor(count, 3, floatType, vertexTarget, more); };
        std::string attributes = R"("POSITION":)" + vectors(R"(,"min":)" + triple((least - shift_).cast<float>()) +
                                                            R"(,"max":)" + triple((most - shift_).cast<float>()));
        if (!part.normals.empty())
            attributes += R"(,"NORMAL":)" + vectors("");
        if (!part.colours.empty())
            attributes += R"(,"COLOR_0":)" + vectors("");
        const float* const one = std::get_if<float>(&part.values);
        if (one == nullptr)
            attributes +=
                "," + jsonString("_" + upper(valueName)) + ":" + accessor(count, 1, floatType, vertexTarget, "");
        const std::string indices = accessor(3 * triangles, 1, unsignedIntType, indexTarget, "");
        append(meshes_,
               R"({"name":)" + jsonString(part.name) +
                   (one != nullptr && std::isfinite(*one) // JSON has no infinity
                        ? ",\"extras\":{" + jsonString(valueName) + ":" + formatNumber(*one) + "}"
                        : "") +
                   R"(,"primitives":[{"attributes":{)" + attributes + R"(},"indices":)" + indices + R"(,"material":)" +
                   std::to_string(count_) + "}]}");
        append(nodes_, R"({"name":)" + jsonString(part.name) + R"(,"mesh":)" + std::to_string(count_) + "}");
        append(materials_, materialOf(part));
        ++count_;
    }

    /// In the letters that names of attributes have.
    static std::string upper(std::string name)
    {
        for (char& c : name) {
            const bool isSmall = c >= 'a' && c <= 'z';
            const bool isUsual = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
            c = isSmall ? static_cast<char>(c - 'a' + 'A') : isUsual ? c : '_';
        }
        return name;
    }

    static std::string materialOf(const SurfacePart& part)
    {
        // The colours of the vertices are multiplied by the material's.
        std::string colour;
        for (std::size_t channel = 0; channel < 3; ++channel)
            append(colour, part.colours.empty() ? formatNumber(linear(factor(part.colour[channel]))) : "1");
        append(colour, formatNumber(factor(part.colour[3])));
        return R"({"name":)" + jsonString(part.name) + R"(,"doubleSided":true)" +
               (part.colour[3] < 1 ? R"(,"alphaMode":"BLEND")" : "") +
               R"(,"pbrMetallicRoughness":{"baseColorFactor":[)" + colour +
               R"(],"metallicFactor":0,"roughnessFactor":0.6}})";
    }

    Eigen::Vector3d shift_;
    std::string text_;
    std::string nodes_, meshes_, materials_, accessors_, views_;
    int count_ = 0; ///< of meshes, and of materials
    int viewCount_ = 0;
    std::uint64_t offset_ = 0;
};

Status writeNumbers(OutputFile& file, std::initializer_list<std::uint32_t> numbers)
{
    return file.bytes(std::as_bytes(std::span(numbers.begin(), numbers.size())));
}

Status writeArrays(OutputFile& file, const SurfacePart& part, TrianglesInFloats triangles, const Eigen::Vector3d& shift)
{
    const auto position = [&part, &shift](std::uint64_t index, std::byte* where) {
        for (const double coordinate : (part.positions[index] - shift).eval())
            putNumber(where, static_cast<float>(coordinate));
    };
    if (const Status written = file.records(part.positions.size(), 3 * sizeof(float), position); !written)
        return written;
    if (const Status written = file.bytes(std::as_bytes(part.normals)); !written)
        return written;
    const auto colour = [&part](std::uint64_t index, std::byte* where) {
        const Colour& given = part.colours[index];
        for (const float channel : {given.red, given.green, given.blue})
            putNumber(where, linear(channel));
    };
    if (const Status written = file.records(part.colours.size(), 3 * sizeof(float), colour); !written)
        return written;
    if (const auto* each = std::get_if<std::span<const float>>(&part.values))
        if (const Status written = file.bytes(std::as_bytes(*each)); !written)
            return written;
    const auto triangle = [&triangles](std::uint64_t, std::byte* where) { putNumber(where, triangles.next()); };
    return file.records(triangles.count(), sizeof part.triangles[0], triangle);
}

Error tooLarge(const OutputFile& file)
{
    return {
        ErrorKind::OutOfResource,
        Message::say("'%1' would hold more than the 4 GiB that a .glb file can. Write a .vtp file, or a surface of a "
                     "larger error.",
                     file.target().string())};
}

} // namespace

/// `.glb`, glTF 2.0 in one binary file: a mesh with a material for each part, and linear colours of the vertices
/// (COLOR_0).
class GlbWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Surface, Message::marked("Binary glTF files"), {".glb"}}};
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        constexpr std::uint64_t mostBytes = std::numeric_limits<std::uint32_t>::max();
        if (12 * (content.vertexCount() + content.triangleCount()) > mostBytes)
            return tooLarge(file);
        const Eigen::Vector3d shift = floatShift(content);
        if (const Status reached = checkFloatsReach(content, shift, file.target().string()); !reached)
            return reached;
        KeptTriangles kept;
        for (const SurfacePart& part : content.parts)
            kept.emplace_back(part, shift);
        const Head head(content, kept, shift);
        constexpr std::uint64_t chunkHeadBytes = 8;
        const std::uint64_t binary = head.binaryBytes();
        const std::uint64_t bytes =
            12 + chunkHeadBytes + head.text().size() + (binary > 0 ? chunkHeadBytes + binary : 0);
        if (bytes > mostBytes)
            return tooLarge(file);
        file.expect(bytes);
        if (const Status written = writeNumbers(file, {magic, 2, static_cast<std::uint32_t>(bytes),
                                                       static_cast<std::uint32_t>(head.text().size()), jsonChunk});
            !written)
            return written;
        if (const Status written = file.text(head.text()); !written)
            return written;
        if (binary > 0)
            if (const Status written = writeNumbers(file, {static_cast<std::uint32_t>(binary), binaryChunk}); !written)
                return written;
        std::uint64_t leftOut = 0;
        for (std::size_t part = 0; part < kept.size(); ++part) {
            leftOut += kept[part].leftOut();
            if (kept[part].count() > 0)
                if (const Status written = writeArrays(file, content.parts[part], kept[part], shift); !written)
                    return written;
        }
        if (!shift.isZero(0))
            file.remark(Message::say(
                "In '%1' x, y and z are smaller than in the data by %2, %3 and %4, because single precision is too "
                "coarse so far from the origin; the first node of the file adds these numbers.",
                file.target().string(), formatNumber(shift[0]), formatNumber(shift[1]), formatNumber(shift[2])));
        if (leftOut > 0)
            file.remark(leftOutInFloats(leftOut, file.target().string()));
        return {};
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::GlbWriter, tetra::Writer)
