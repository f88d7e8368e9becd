// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/format_checks.h"
#include "plugins/readers/vtk/checks/metaimage_header.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

/// The library reads every number as a double and takes its whole part.
std::optional<std::int64_t> wholeNumber(std::string_view text)
{
    const auto number = parseNumber<double>(text);
    if (!number || !(*number >= -9e15 && *number <= 9e15))
        return std::nullopt;
    return static_cast<std::int64_t>(*number);
}

struct MetaLayout {
    std::vector<std::uint64_t> size;
    std::uint64_t sampleBytes = 0; ///< of all channels
    std::int64_t headerSize = 0;   ///< bytes before the samples of each file; -1: they are at its end
    std::uint64_t packedSize = 0;  ///< 0: to the end of the file
    bool isText = false;
    bool isPacked = false;

    std::uint64_t samples(std::size_t dimensions) const
    {
        std::uint64_t count = 1;
        for (std::size_t i = 0; i < dimensions; ++i)
            count = boundedProduct(count, size[i]);
        return count;
    }
};

Result<std::uint64_t> typeBytes(std::string_view type)
{
    constexpr std::string_view array = "_ARRAY";
    const std::string_view single = type.ends_with(array) ? type.substr(0, type.size() - array.size()) : type;
    constexpr std::array<std::pair<std::string_view, std::uint64_t>, 8> known = {{{"MET_CHAR", 1},
                                                                                  {"MET_UCHAR", 1},
                                                                                  {"MET_SHORT", 2},
                                                                                  {"MET_USHORT", 2},
                                                                                  {"MET_INT", 4},
                                                                                  {"MET_UINT", 4},
                                                                                  {"MET_FLOAT", 4},
                                                                                  {"MET_DOUBLE", 8}}};
    const auto entry = std::ranges::find(known, single, &std::pair<std::string_view, std::uint64_t>::first);
    if (entry != known.end() && type != "MET_FLOAT_ARRAY" && type != "MET_DOUBLE_ARRAY")
        return entry->second;
    // For VTK a long has 64 bits, for the files 32: half of the samples would be what was in memory.
    return Error{ErrorKind::BadInput,
                 type.empty()
                     ? Message::say("its header does not say its ElementType. It is cut short: copy the file again.")
                     : Message::say("its samples are of the type '%1', which is not read. Write them as "
                                    "MET_INT, MET_FLOAT or MET_DOUBLE.",
                                    printable(type))};
}

Result<MetaLayout> layoutOf(const MetaHeader& header)
{
    MetaLayout layout;
    const auto dimensions = wholeNumber(header.text("NDims"));
    if (!dimensions)
        return wrongHeader(Message::say("its header has no NDims."));
    if (*dimensions < 1 || *dimensions > 3)
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 dimensions. Write a part of it with three.", *dimensions)};
    const auto sizes = metaWords(header.text("DimSize"));
    for (std::int64_t i = 0; i < *dimensions; ++i) {
        const auto size =
            static_cast<std::size_t>(i) < sizes.size() ? wholeNumber(sizes[static_cast<std::size_t>(i)]) : std::nullopt;
        if (!size || *size < 1 || *size > std::int64_t(1) << 31)
            return wrongHeader(Message::say("its DimSize is '%1' and not %2 numbers of points.",
                                            printable(header.text("DimSize")), *dimensions));
        layout.size.push_back(static_cast<std::uint64_t>(*size));
    }
    const auto bytes = typeBytes(header.text("ElementType"));
    if (!bytes)
        return bytes.error();
    const std::string_view channelsText = header.text("ElementNumberOfChannels");
    const auto channels = channelsText.empty() ? std::optional<std::int64_t>(1) : wholeNumber(channelsText);
    if (!channels || *channels < 1 || *channels > 1'000'000)
        return wrongHeader(Message::say("its ElementNumberOfChannels is '%1'.", printable(channelsText)));
    layout.sampleBytes = *bytes * static_cast<std::uint64_t>(*channels);
    layout.isText = !header.text("BinaryData").empty() && !header.isTrue("BinaryData"); // MetaIO: binary without it
    layout.isPacked = header.isTrue("CompressedData") && !layout.isText;
    if (layout.isText && *channels > 1)
        return Error{ErrorKind::BadInput, Message::say("its samples are a text with several channels, of which VTK "
                                                       "reads a part only. Write them with BinaryData = True.")};
    if (const auto text = header.text("HeaderSize"); !text.empty()) {
        const auto size = wholeNumber(text);
        if (!size || *size < -1)
            return wrongHeader(Message::say("its HeaderSize is '%1'.", printable(text)));
        if (*size < 0 && (layout.isPacked || layout.isText))
            return wrongHeader(
                Message::say("its HeaderSize is -1, which says nothing where samples are packed or a text."));
        layout.headerSize = *size;
    }
    if (const auto text = header.text("CompressedDataSize"); !text.empty())
        layout.packedSize = static_cast<std::uint64_t>(std::max<std::int64_t>(0, wholeNumber(text).value_or(0)));
    return layout;
}

/// How much zlib (or gzip) data unpack to, at most `wanted` bytes of it; nothing if they are damaged before that.
std::optional<std::uint64_t> unpackedBytes(std::string_view packed, std::uint64_t wanted)
{
    constexpr int zlibOrGzip = 47;
    constexpr std::size_t step = 1 << 16;
    z_stream stream{};
    if (inflateInit2(&stream, zlibOrGzip) != Z_OK)
        throw std::bad_alloc();
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> owner(&stream, inflateEnd);
    std::array<Bytef, step> out{};
    std::uint64_t count = 0;
    for (int state = Z_OK; state != Z_STREAM_END;) {
        if (stream.avail_in == 0) {
            const auto piece = packed.substr(0, std::size_t(1) << 30);
            packed.remove_prefix(piece.size());
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(piece.data()));
            stream.avail_in = static_cast<uInt>(piece.size());
        }
        stream.next_out = out.data();
        stream.avail_out = step;
        const bool atEnd = stream.avail_in == 0;
        state = inflate(&stream, Z_NO_FLUSH);
        const std::uint64_t made = step - stream.avail_out;
        count += made;
        if (state < 0 && state != Z_BUF_ERROR)
            return std::nullopt;
        if (atEnd && made == 0 && state != Z_STREAM_END)
            return std::nullopt; // the check sum at its end is missing
        if (count > wanted)
            return wanted;
    }
    return count;
}

/// Whether `wanted` numbers stand in a text, read as the library does: each ends with one character of any kind. The
/// last one must end as well, or a part of it may be missing.
bool hasNumbers(std::string_view text, std::uint64_t wanted)
{
    for (std::uint64_t count = 0; count < wanted; ++count) {
        text.remove_prefix(std::min(text.find_first_not_of(metaBlanks), text.size()));
        text.remove_prefix(text.starts_with('+') ? 1 : 0);
        double number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc::invalid_argument || end == text.data() + text.size())
            return false;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    }
    return true;
}

/// Whether `bytes`, from `begin` on, hold so many samples; `what` is what they are called in an error.
Status checkSamples(const Message& what, std::string_view bytes, std::size_t begin, const MetaLayout& layout,
                    std::uint64_t samples)
{
    const std::uint64_t needed = boundedProduct(samples, layout.sampleBytes);
    if (layout.headerSize > 0)
        begin = static_cast<std::size_t>(layout.headerSize);
    if (begin > bytes.size())
        return cutShort(what, bytes.size(), boundedSum(begin, needed));
    if (layout.isPacked) {
        if (layout.packedSize == 0)
            begin = 0; // as the library does
        std::string_view packed = bytes.substr(begin);
        if (layout.packedSize > packed.size())
            return cutShort(what, bytes.size(), boundedSum(begin, layout.packedSize));
        if (layout.packedSize > 0)
            packed = packed.substr(0, layout.packedSize);
        const auto unpacked = unpackedBytes(packed, needed);
        if (unpacked && *unpacked == needed)
            return {};
        return Error{ErrorKind::BadInput,
                     unpacked ? Message::say("%1 unpacks to %2 bytes, and its header asks for %3. It is damaged or cut "
                                             "short: copy the file again.",
                                             what, *unpacked, needed)
                              : Message::say("%1 cannot be unpacked to its end. It is damaged or cut short: copy the "
                                             "file again.",
                                             what)};
    }
    if (layout.isText)
        return hasNumbers(bytes.substr(begin), samples)
                   ? Status()
                   : Status(Error{
                         ErrorKind::BadInput,
                         Message::say("%1 has not the %2 numbers that its header asks for, each with a blank or an end "
                                      "of line behind it. It is cut short or damaged: copy the file again.",
                                      what, samples)});
    if (layout.headerSize < 0)
        begin = 0;
    return bytes.size() - begin >= needed ? Status() : cutShort(what, bytes.size(), boundedSum(begin, needed));
}

/// "slice%03d.raw" with a number in place of its one directive for whole numbers; nothing if it has another one.
std::optional<std::string> numberedName(std::string_view pattern, std::int64_t number)
{
    const auto percent = pattern.find('%');
    const auto end = pattern.find_first_not_of("0123456789", percent + 1);
    if (percent == std::string_view::npos || end == std::string_view::npos || end - percent > 4 ||
        (pattern[end] != 'd' && pattern[end] != 'i' && pattern[end] != 'u') ||
        pattern.find('%', end) != std::string_view::npos)
        return std::nullopt;
    const std::string_view widthText = pattern.substr(percent + 1, end - percent - 1);
    const auto width = static_cast<std::size_t>(widthText.empty() ? 0 : parseNumber<int>(widthText).value_or(0));
    std::string digits = std::to_string(number);
    if (digits.size() < width)
        digits.insert(0, width - digits.size(), widthText.starts_with('0') ? '0' : ' ');
    return std::string(pattern.substr(0, percent)) + digits + std::string(pattern.substr(end + 1));
}

class MetaImageCheck {
public:
    explicit MetaImageCheck(const fs::path& path) : path_(path) {}

    Result<CheckedFile> run()
    {
        const auto file = MappedFile::open(path_);
        if (!file)
            return file.error();
        const std::string_view bytes(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
        auto header = metaHeaderOf(bytes);
        if (!header)
            return header.error();
        const auto layout = layoutOf(*header);
        if (!layout)
            return layout.error();
        layout_ = *layout;
        const Status fits = checkData(*header, bytes);
        if (!fits)
            return fits.error();
        const std::uint64_t unpacked = boundedProduct(layout_.samples(layout_.size.size()), layout_.sampleBytes);
        return CheckedFile{.bytes = bytes.size(), .unpackedBytes = unpacked};
    }

private:
    Status checkData(const MetaHeader& header, std::string_view bytes)
    {
        const std::string name(header.text("ElementDataFile"));
        const std::uint64_t samples = layout_.samples(layout_.size.size());
        if (name == "LOCAL" || name == "Local" || name == "local") {
            if (layout_.isPacked && layout_.packedSize == 0)
                return wrongHeader(Message::say("its header does not say the CompressedDataSize."));
            return checkSamples(Message::say("it"), bytes, header.end, layout_, samples);
        }
        if (name.starts_with("LIST"))
            return checkList(name, bytes.substr(header.end));
        if (name.find('%') != std::string::npos)
            return checkSeries(name);
        return checkFile(name, samples);
    }

    Status checkFile(const std::string& name, std::uint64_t samples) const
    {
        MetaLayout layout = layout_;
        fs::path path = path_.parent_path() / name;
        for (const char* ending : {".gz", ".Z"})
            if (std::error_code ignored; !fs::exists(path, ignored) && fs::exists(path.string() + ending, ignored)) {
                path += ending;
                layout.isPacked = true;
                layout.isText = false;
            }
        std::error_code ignored;
        if (name.empty() || !fs::exists(path, ignored))
            return Error{
                ErrorKind::BadInput,
                Message::say(
                    "its data file %1 is missing. Copy it into the folder of this one: the two belong together.",
                    nameOf(name))};
        const auto file = MappedFile::open(path);
        if (!file)
            return file.error();
        return checkSamples(Message::say("its data file %1", nameOf(path)),
                            {reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size()}, 0,
                            layout, samples);
    }

    /// The names stand below the header, one a line, each for a part of so many dimensions.
    Status checkList(const std::string& name, std::string_view lines) const
    {
        const auto words = metaWords(name);
        const auto last = static_cast<std::int64_t>(layout_.size.size()) - 1;
        std::int64_t dimensions = words.size() > 1 ? wholeNumber(words[1]).value_or(last) : last;
        if (dimensions <= 0 || dimensions > last + 1)
            dimensions = last;
        std::uint64_t files = 1;
        for (auto i = static_cast<std::size_t>(dimensions); i < layout_.size.size(); ++i)
            files = boundedProduct(files, layout_.size[i]);
        for (std::uint64_t i = 0; i < files; ++i) {
            const auto end = lines.find('\n');
            if (end == std::string_view::npos) // the library passes over a last line that does not end
                return Error{ErrorKind::BadInput,
                             Message::say("it should name %1 data files, each in a line of its own that ends, and "
                                          "names %2. It is cut short: copy the file again.",
                                          files, i)};
            const Status fits = checkFile(std::string(strippedOfBlanks(lines.substr(0, end))),
                                          layout_.samples(static_cast<std::size_t>(dimensions)));
            if (!fits)
                return fits;
            lines.remove_prefix(end + 1);
        }
        return {};
    }

    /// "slice%03d.raw FIRST LAST STEP": a file for each layer.
    Status checkSeries(const std::string& name) const
    {
        constexpr std::size_t longestWord = 79; // that the library has room for
        auto words = metaWords(name);
        const auto layers = static_cast<std::int64_t>(layout_.size.back());
        while (words.size() > 4) { // blanks in the name
            words[0] += " " + words[1];
            words.erase(words.begin() + 1);
        }
        std::array<std::int64_t, 3> numbers{1, layers, 1};
        for (std::size_t i = 1; i < words.size(); ++i) {
            const auto number = wholeNumber(words[i]);
            if (!number || std::abs(*number) > 1'000'000'000)
                return wrongHeader(Message::say("its ElementDataFile is '%1'.", printable(name)));
            numbers[i - 1] = *number;
        }
        if (words.size() == 2)
            numbers[1] = numbers[0] + layers - 1;
        if (words.size() == 3)
            numbers[2] = (numbers[1] - numbers[0]) / layers;
        const auto [first, end, step] = numbers;
        if (step < 1 || 1 + (end - first) / step < layers)
            return Error{ErrorKind::BadInput,
                         Message::say("its ElementDataFile '%1' does not name a file for each of its %2 layers. Write "
                                      "the numbers of the first, the last and the step behind the name.",
                                      printable(name), layers)};
        for (std::int64_t layer = 0; layer < layers; ++layer) {
            const auto file = numberedName(words[0], first + layer * step);
            if (!file || words[0].size() > longestWord)
                return wrongHeader(
                    Message::say("its ElementDataFile '%1' is no name with a number as '%03d'.", printable(name)));
            if (const Status fits = checkFile(*file, layout_.samples(layout_.size.size() - 1)); !fits)
                return fits;
        }
        return {};
    }

    fs::path path_;
    MetaLayout layout_;
};

} // namespace

Result<CheckedFile> checkMetaImage(const fs::path& path)
{
    return MetaImageCheck(path).run();
}

} // namespace tetra
