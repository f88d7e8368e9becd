// SPDX-License-Identifier: GPL-3.0-or-later
// The header is the text of a Python dictionary, {'descr': '<f4', 'fortran_order': False, 'shape': (5, 4, 3), }: a
// parser for the few kinds of values that NumPy writes there takes it apart; nothing is evaluated.
#include "plugins/readers/lattice/arrays/npy_file.h"

#include "plugins/api/placement_parameters.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tetra {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view firstDimensionIsX = Message::marked("xyz"), lastDimensionIsX = Message::marked("zyx");

constexpr std::string_view npyMagic = "\x93NUMPY"sv;

Error npyDamaged(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("its header is not that of a NumPy array: %1. Save the array again with numpy.save().", what)};
}

/// What the header says.
struct NpyHeader {
    std::string type;          ///< "<f4"
    bool hasFields = false;    ///< the type is a list of fields
    bool firstFastest = false; ///< Fortran's order
    std::vector<std::uint64_t> shape;
    std::uint64_t bytes = 0; ///< up to the numbers
};

/// The text of a Python dictionary of texts, truth values and tuples of whole numbers.
class NpyDictionary {
public:
    explicit NpyDictionary(std::string_view text) : rest_(text) {}

    Result<NpyHeader> parse()
    {
        if (!take('{'))
            return npyDamaged(Message::say("it has no dictionary"));
        while (!take('}')) {
            const auto key = takeText();
            if (!key || !take(':') || !takeValue(*key))
                return npyDamaged(Message::say("'%1' is not understood", printable(rest_)));
            if (!take(',') && !next('}'))
                return npyDamaged(Message::say("'%1' is not understood", printable(rest_)));
        }
        if (!hasType_ || !hasOrder_ || !hasShape_)
            return npyDamaged(Message::say("'descr', 'fortran_order' or 'shape' is missing"));
        return header_;
    }

private:
    void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }
    bool next(char wanted)
    {
        skipBlanks();
        return rest_.starts_with(wanted);
    }
    bool take(char wanted)
    {
        const bool isThere = next(wanted);
        rest_.remove_prefix(isThere ? 1 : 0);
        return isThere;
    }
    bool takeWord(std::string_view word)
    {
        skipBlanks();
        const bool isThere = rest_.starts_with(word);
        rest_.remove_prefix(isThere ? word.size() : 0);
        return isThere;
    }
    std::optional<std::string> takeText()
    {
        skipBlanks();
        const char mark = rest_.empty() ? ' ' : rest_.front();
        const std::size_t end = mark == '\'' || mark == '"' ? rest_.find(mark, 1) : std::string_view::npos;
        if (end == std::string_view::npos)
            return {};
        std::string text(rest_.substr(1, end - 1));
        rest_.remove_prefix(end + 1);
        return text;
    }
    bool takeValue(const std::string& key)
    {
        if (key == "descr")
            return takeType();
        if (key == "fortran_order") {
            header_.firstFastest = next('T');
            hasOrder_ = takeWord(header_.firstFastest ? "True" : "False");
            return hasOrder_;
        }
        return key == "shape" && takeShape();
    }
    bool takeType()
    {
        hasType_ = true;
        if (next('[') || next('(')) {
            header_.hasFields = true;
            return skipNested();
        }
        const auto text = takeText();
        header_.type = text.value_or("");
        return text.has_value();
    }
    bool takeShape()
    {
        hasShape_ = take('(');
        while (hasShape_ && !take(')')) {
            skipBlanks();
            const auto number = parseNumber<std::uint64_t>(rest_.substr(0, rest_.find_first_not_of("0123456789")));
            constexpr std::size_t mostDimensions = 64; // as NumPy has them
            if (!number || header_.shape.size() == mostDimensions)
                return false;
            rest_.remove_prefix(std::min(rest_.find_first_not_of("0123456789"), rest_.size()));
            header_.shape.push_back(*number);
            take('L'); // as Python 2 wrote long ones
            if (!take(',') && !next(')'))
                return false;
        }
        return hasShape_;
    }
    /// Goes past a list with what it holds; texts in it have no brackets.
    bool skipNested()
    {
        std::size_t depth = 0;
        do {
            if (rest_.empty())
                return false;
            if (rest_.starts_with('[') || rest_.starts_with('('))
                ++depth;
            if (rest_.starts_with(']') || rest_.starts_with(')'))
                --depth;
            rest_.remove_prefix(1);
        } while (depth > 0);
        return true;
    }

    std::string_view rest_;
    NpyHeader header_;
    bool hasType_ = false;
    bool hasOrder_ = false;
    bool hasShape_ = false;
};

Result<NpyHeader> npyHeader(std::string_view file)
{
    constexpr std::size_t lengthAt = 8;
    if (!looksLikeNpy(file))
        return npyDamaged(Message::say("its first bytes are different"));
    const auto byteAt = [&](std::size_t place) { return static_cast<std::uint8_t>(file[place]); };
    const unsigned version = file.size() > npyMagic.size() ? byteAt(npyMagic.size()) : 0;
    if (version > 3)
        return Error{ErrorKind::BadInput, Message::say("it has version %1 of NumPy's format, and versions 1 to 3 are "
                                                       "read. Save it again with numpy.save() of an earlier NumPy.",
                                                       version)};
    const std::size_t lengthBytes = version == 1 ? 2 : 4;
    if (version == 0 || file.size() < lengthAt + lengthBytes)
        return npyDamaged(Message::say("it is cut short"));
    std::uint64_t length = 0;
    for (std::size_t i = lengthBytes; i-- > 0;)
        length = length << 8 | byteAt(lengthAt + i);
    const std::uint64_t begin = lengthAt + lengthBytes;
    if (length > file.size() - begin)
        return npyDamaged(Message::say("it is cut short"));
    auto header = NpyDictionary(file.substr(begin, length)).parse();
    if (header)
        header->bytes = begin + length;
    return header;
}

struct NpyType {
    std::string_view name;
    StoredType type;
    std::uint32_t components;
};
constexpr std::array<NpyType, 14> npyTypes{{{"b1", StoredType::UInt8, 1},
                                            {"u1", StoredType::UInt8, 1},
                                            {"i1", StoredType::Int8, 1},
                                            {"u2", StoredType::UInt16, 1},
                                            {"i2", StoredType::Int16, 1},
                                            {"u4", StoredType::UInt32, 1},
                                            {"i4", StoredType::Int32, 1},
                                            {"u8", StoredType::UInt64, 1},
                                            {"i8", StoredType::Int64, 1},
                                            {"f2", StoredType::Float16, 1},
                                            {"f4", StoredType::Float32, 1},
                                            {"f8", StoredType::Float64, 1},
                                            {"c8", StoredType::Float32, 2},
                                            {"c16", StoredType::Float64, 2}}};

Result<NpyType> npyType(const NpyHeader& header, std::endian& order)
{
    if (header.hasFields)
        return Error{ErrorKind::BadInput, Message::say("its elements are records of several fields. Save one field on "
                                                       "its own: numpy.save(name, array['field']).")};
    const std::string_view all = header.type;
    if (all.substr(0, 2) == "|O" || all == "O")
        return Error{ErrorKind::BadInput, Message::say("its elements are Python objects, which only Python can read. "
                                                       "Save an array of numbers: array.astype('float32').")};
    const bool hasOrder = !all.empty() && std::string_view("<>|=").find(all.front()) != std::string_view::npos;
    const std::string_view name = all.substr(hasOrder ? 1 : 0);
    const auto* const found = std::ranges::find(npyTypes, name, &NpyType::name);
    if (found == npyTypes.end())
        return Error{ErrorKind::BadInput,
                     Message::say("its elements have the type '%1', which is not read. Save numbers of a usual type: "
                                  "array.astype('float64').",
                                  printable(all))};
    order = !hasOrder || all.front() == '=' || all.front() == '|' ? std::endian::native
            : all.front() == '>'                                  ? std::endian::big
                                                                  : std::endian::little;
    return *found;
}

std::string shapeText(const std::vector<std::uint64_t>& shape)
{
    constexpr std::size_t mostSizes = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(shape.size(), mostSizes); ++i)
        text += (i == 0 ? "" : " x ") + std::to_string(shape[i]);
    return text + (shape.size() > mostSizes ? " ..." : "");
}

/// The three dimensions of the array, its first one first.
Result<std::array<std::uint64_t, 3>> npySize(const NpyHeader& header)
{
    std::vector<std::uint64_t> shape = header.shape;
    if (shape.size() > 3)
        std::erase(shape, std::uint64_t(1));
    if (shape.size() != 3)
        return Error{
            ErrorKind::BadInput,
            Message::say("its array has the shape (%1), and a volume needs three dimensions of more than one element. "
                         "Save a part that has them, such as array[0] or array[..., 0].",
                         shapeText(header.shape))};
    return std::array{shape[0], shape[1], shape[2]};
}

/// Sets the size and the strides: the dimensions are x, y and z as they are indexed, or the other way round. Which of
/// them runs fastest in the file says nothing of that.
Status setNpyAxes(const NpyHeader& header, const ParameterValues& values, StoredVolume& volume)
{
    auto size = npySize(header);
    if (!size)
        return size.error();
    const bool lastIsX = parameterValue<std::string>({npyAxesParameter()}, values, npyAxesId) == lastDimensionIsX;
    if (lastIsX)
        std::ranges::reverse(*size);
    if (const Status set = setStoredSize(volume, *size, 1); !set)
        return set;
    const bool firstIsX = !lastIsX;
    setStrides(volume, volume.components, header.firstFastest != firstIsX);
    const bool isSaid = values.contains(npyAxesId);
    volume.taken.push_back(
        {TakenPart::Places,
         lastIsX ? Message::say("the array's dimensions are z, y, x")
         : isSaid
             ? Message::say("the array's dimensions are x, y, z")
             : Message::say(
                   "the array's dimensions are x, y, z; give '--axes zyx' if they are z, y, x, as in stacks of images"),
         !isSaid});
    return {};
}

} // namespace

Parameter npyAxesParameter()
{
    Parameter axes;
    axes.id = npyAxesId;
    axes.label = Message::marked("Axes");
    axes.explanation =
        Message::marked("NumPy arrays: whether they are indexed as array[x, y, z], or as array[z, y, x], as stacks of "
                        "images by scikit-image, imageio and tifffile are.");
    axes.defaultValue = std::string(firstDimensionIsX);
    axes.choices = {std::string(firstDimensionIsX), std::string(lastDimensionIsX)};
    return axes;
}

bool looksLikeNpy(std::string_view beginning)
{
    return beginning.starts_with(npyMagic);
}

Result<StoredVolume> describeNpy(const VolumeRequest& request)
{
    const auto header = npyHeader(request.text());
    if (!header)
        return header.error();
    StoredVolume volume;
    const auto type = npyType(*header, volume.order);
    if (!type)
        return type.error();
    volume.type = type->type;
    volume.components = type->components;
    volume.arrays = {{.name = "", .components = static_cast<int>(type->components)}};
    if (const Status set = setNpyAxes(*header, request.values, volume); !set)
        return set.error();
    if (const auto array = takeArray(volume, request.values); !array)
        return array.error();
    if (const Status taken = takeComponent(volume, request.values); !taken)
        return taken.error();
    volume.untold = untoldPlacement(false, false, false);
    volume.untold.emplace_back(npyAxesId);
    volume.files = {{request.path}};
    volume.offset = header->bytes;
    return volume;
}

} // namespace tetra
