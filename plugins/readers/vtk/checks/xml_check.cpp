// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/format_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view xmlBlanks = " \t\r\n";

template <class Number, std::size_t Count> std::optional<std::array<Number, Count>> numbersIn(std::string_view text)
{
    std::array<Number, Count> numbers{};
    for (Number& number : numbers) {
        text.remove_prefix(std::min(text.find_first_not_of(xmlBlanks), text.size()));
        const std::string_view word = text.substr(0, text.find_first_of(xmlBlanks));
        const auto parsed = parseNumber<Number>(word);
        if (!parsed || !std::isfinite(static_cast<double>(*parsed)))
            return std::nullopt;
        number = *parsed;
        text.remove_prefix(word.size());
    }
    return text.find_first_not_of(xmlBlanks) == std::string_view::npos ? std::optional(numbers) : std::nullopt;
}

/// The cells of an extent, where an axis with one point counts as one; nothing if it is none.
std::optional<double> cellsIn(std::string_view extent)
{
    const auto numbers = numbersIn<std::int32_t, 6>(extent);
    if (!numbers)
        return std::nullopt;
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double steps = double((*numbers)[2 * axis + 1]) - (*numbers)[2 * axis];
        if (steps < 0)
            return std::nullopt;
        cells *= std::max(1., steps);
    }
    return cells;
}

/// The value of the attribute in a tag; empty without it. What stands in the value of another one is no attribute, and
/// blanks may stand around the '=': what is seen here is what VTK sees.
std::string_view xmlAttribute(std::string_view tag, std::string_view name)
{
    for (auto at = tag.find_first_of(xmlBlanks); at != std::string_view::npos;) {
        at = tag.find_first_not_of(xmlBlanks, at);
        const auto equals = tag.find('=', std::min(at, tag.size()));
        const auto quote = tag.find_first_not_of(xmlBlanks, std::min(equals, tag.size() - 1) + 1);
        if (equals == std::string_view::npos || quote == std::string_view::npos ||
            (tag[quote] != '"' && tag[quote] != '\''))
            break;
        const std::string_view before = tag.substr(at, equals - at);
        const std::string_view found = before.substr(0, before.find_last_not_of(xmlBlanks) + 1);
        const auto end = tag.find(tag[quote], quote + 1);
        if (end == std::string_view::npos || found.find('>') != std::string_view::npos)
            break;
        if (found == name)
            return tag.substr(quote + 1, end - quote - 1);
        at = end + 1;
    }
    return {};
}

Error wrongXml(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("%1 It is damaged, or was written by a faulty program: export it again.", what)};
}

/// The tags of a file, one after the other, without their brackets; comments and declarations are passed over.
class XmlTagList {
public:
    explicit XmlTagList(std::string_view text) : text_(text) {}

    std::optional<std::string_view> next()
    {
        for (auto begin = bracketFrom(at_); begin != std::string_view::npos; begin = bracketFrom(at_)) {
            if (text_.substr(begin).starts_with("<!--")) {
                const auto end = text_.find("-->", begin);
                at_ = end == std::string_view::npos ? text_.size() : end + 3;
                continue;
            }
            const auto end = endOf(begin + 1);
            at_ = end;
            const std::string_view tag = text_.substr(begin + 1, end - begin - 1);
            if (!tag.starts_with('?') && !tag.starts_with('!'))
                return tag;
        }
        return std::nullopt;
    }

private:
    /// Where the next tag begins. A zero byte is no text: what follows is not looked at.
    std::size_t bracketFrom(std::size_t place) const
    {
        constexpr std::size_t step = 1 << 20;
        for (; place < text_.size(); place += step) {
            const std::string_view part = text_.substr(place, step);
            const auto bracket = part.find('<');
            if (part.substr(0, bracket).find('\0') != std::string_view::npos)
                return std::string_view::npos;
            if (bracket != std::string_view::npos)
                return place + bracket;
        }
        return std::string_view::npos;
    }

    /// Where the bracket stands that closes it, which may also stand in the value of an attribute.
    std::size_t endOf(std::size_t place) const
    {
        char quote = 0;
        for (; place < text_.size(); ++place) {
            const char c = text_[place];
            if (quote != 0)
                quote = c == quote ? '\0' : quote;
            else if (c == '"' || c == '\'')
                quote = c;
            else if (c == '>')
                return place;
        }
        return text_.size();
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

bool isNamed(std::string_view tag, std::string_view name)
{
    return tag.starts_with(name) && (tag.size() == name.size() || tag[name.size()] == '/' ||
                                     xmlBlanks.find(tag[name.size()]) != std::string_view::npos);
}

constexpr std::uint64_t mostPacking = 1032; ///< that zlib reaches
constexpr int blocksOfPieces = 3;           ///< how deep files name others: blocks of blocks, of pieces

/// The files that belong to the one that was opened.
struct XmlFiles {
    fs::path home; ///< the folder of that one
    /// Of those that were begun how many files VTK reads for it, itself and what it names each time that it is named; 0
    /// of those that are not looked through yet.
    std::map<fs::path, std::uint64_t> readings;
};

class XmlCheck {
public:
    /// `depth`: how deep files may name others.
    XmlCheck(const fs::path& path, int depth, XmlFiles& files)
        : path_(path), type_(xmlType(path)), filesWithin_(depth), files_(files)
    {
    }

    Result<CheckedFile> run()
    {
        const fs::path self = path_.lexically_normal();
        files_.readings[self] = 0;
        const auto file = MappedFile::open(path_);
        if (!file)
            return file.error();
        if (const Status fine = lookThrough((*file)->bytes()); !fine)
            return fine.error();
        files_.readings[self] = readings_;
        return checked_;
    }

private:
    Status lookThrough(std::span<const std::byte> bytes)
    {
        checked_.bytes = bytes.size();
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        XmlTagList tags(text);
        while (const auto tag = tags.next()) {
            if (isNamed(*tag, "AppendedData")) {
                // VTK stops here with what it takes for text, and fills arrays that are cut with zeros.
                if (!text.substr(0, text.find_last_not_of(xmlBlanks) + 1).ends_with("</VTKFile>"))
                    return Error{
                        ErrorKind::BadInput,
                        Message::say("it ends within its appended data. It is cut short: copy the file again.")};
                break;
            }
            if (const Status fine = look(*tag); !fine)
                return fine;
        }
        if (type_ == "Collection")
            return Error{ErrorKind::BadInput,
                         named_.empty() ? Message::say("it is a list of files, one for each time step or part. Open "
                                                       "one of its files.")
                                        : Message::say("it is a list of files, one for each time step or part. Open "
                                                       "one of its files, such as '%1'.",
                                                       printable(named_))};
        if (isGridType() && !isGrid_)
            return wrongXml(Message::say("its element %1 is missing.", type_));
        if (isGrid_ && (!whole_ || covered_ < *whole_))
            return wrongXml(Message::say("the pieces in it do not fill the WholeExtent that it names."));
        return {};
    }

    Status look(std::string_view tag)
    {
        // More than any program writes. VTK needs time by the square of the one, and memory for each of the others.
        constexpr std::ptrdiff_t mostAttributes = 5000;
        constexpr std::uint64_t mostTags = 1'000'000;
        constexpr std::int64_t deepest = 256;
        if (++tags_ > mostTags)
            return wrongXml(Message::say("it has more than %1 elements.", mostTags));
        if (tag.starts_with('/')) {
            --level_;
            return {};
        }
        level_ += tag.ends_with('/') ? 0 : 1;
        if (level_ > deepest)
            return wrongXml(Message::say("its elements are nested more than %1 levels deep.", deepest));
        if (std::ranges::count(tag, '=') > mostAttributes)
            return wrongXml(Message::say("an element has more than %1 attributes.", mostAttributes));
        if (isNamed(tag, "DataArray") || isNamed(tag, "PDataArray"))
            return array(tag);
        for (const std::string_view section : {"PointData", "CellData", "Points", "Cells"})
            if (isNamed(tag, section))
                section_ = section;
        if (isNamed(tag, "Piece"))
            return piece(tag);
        if (isNamed(tag, "DataSet"))
            return fileNamed(xmlAttribute(tag, "file"));
        if (isGridType() && isNamed(tag, type_)) {
            isGrid_ = true;
            whole_ = cellsIn(xmlAttribute(tag, "WholeExtent"));
            for (const std::string_view name : {"Spacing", "Origin"})
                if (const auto value = xmlAttribute(tag, name); !value.empty() && !numbersIn<double, 3>(value))
                    return wrongXml(Message::say("its %1 is '%2' and not three numbers.", name, printable(value)));
            const auto directions = xmlAttribute(tag, "Direction");
            if (!directions.empty() && !numbersIn<double, 9>(directions))
                return wrongXml(Message::say("its Direction is '%1' and not nine numbers.", printable(directions)));
        }
        return {};
    }

    Status array(std::string_view tag)
    {
        constexpr std::int64_t most = 1'000'000; // VTK asks for the name of each
        const std::string_view text = xmlAttribute(tag, "NumberOfComponents");
        const auto components = text.empty() ? std::optional<std::int64_t>(1) : parseNumber<std::int64_t>(text);
        if (components && *components >= 0 && *components <= most) {
            addUnpacked(xmlAttribute(tag, "type"), static_cast<std::uint64_t>(*components));
            return {};
        }
        return wrongXml(
            Message::say("its array '%1' has '%2' components.", printable(xmlAttribute(tag, "Name")), printable(text)));
    }

    /// What the array of a piece unpacks to, at most as much as packed data can.
    void addUnpacked(std::string_view type, std::uint64_t components)
    {
        constexpr std::uint64_t corners = 8; // of a cell, roughly
        const bool ofCells = section_ == "CellData" || section_ == "Cells";
        const std::uint64_t bytes = type.ends_with("64") ? 8 : type.ends_with("8") ? 1 : type.ends_with("16") ? 2 : 4;
        const std::uint64_t each = section_ == "Cells" ? corners * bytes : components * bytes;
        checked_.unpackedBytes =
            std::min(boundedSum(checked_.unpackedBytes, boundedProduct(ofCells ? cells_ : points_, each)),
                     boundedProduct(checked_.bytes, mostPacking));
    }

    Status piece(std::string_view tag)
    {
        const auto count = [&](std::string_view name) {
            return parseNumber<std::uint64_t>(xmlAttribute(tag, name)).value_or(0);
        };
        const double cells = cellsIn(xmlAttribute(tag, "Extent")).value_or(0);
        covered_ += cells;
        const auto ofGrid = static_cast<std::uint64_t>(std::min(cells, 1e18)); // of points hardly more
        points_ = isGridType() ? ofGrid : count("NumberOfPoints");
        cells_ = isGridType() ? ofGrid : count("NumberOfCells");
        for (const std::uint64_t number : {points_, cells_})
            if (number > boundedProduct(mostPacking, checked_.bytes) && xmlAttribute(tag, "Source").empty())
                return wrongXml(Message::say("it claims to have %1 points or cells, more than %2 bytes can hold.",
                                             number, checked_.bytes));
        return fileNamed(xmlAttribute(tag, "Source"));
    }

    /// Another file that belongs to this one.
    Status fileNamed(std::string_view name)
    {
        if (name.empty())
            return {};
        if (named_.empty())
            named_ = name;
        if (type_ == "Collection")
            return {};
        const auto path = fileBelow(files_.home, path_.parent_path(), std::string(name));
        if (!path)
            return path.error();
        if (filesWithin_ == 0)
            return wrongXml(Message::say("its files refer to each other more than %1 levels deep.", blocksOfPieces));
        std::error_code ignored;
        if (!fs::exists(*path, ignored))
            return Error{ErrorKind::BadInput,
                         Message::say("its file '%1' is missing. Copy it into the same folder: they belong together.",
                                      printable(name))};
        if (const auto begun = files_.readings.find(*path); begun != files_.readings.end()) {
            readings_ = boundedSum(readings_, begun->second);
            return begun->second > 0 ? Status()
                                     : Status(wrongXml(Message::say(
                                           "it refers to the file '%1', which refers back to it.", printable(name))));
        }
        const auto checked = XmlCheck(*path, filesWithin_ - 1, files_).run();
        if (!checked)
            return Error{checked.error().kind,
                         Message::say("its file '%1': %2", printable(name), checked.error().message)};
        readings_ = boundedSum(readings_, files_.readings[*path]);
        checked_.bytes = boundedSum(checked_.bytes, checked->bytes);
        checked_.unpackedBytes = boundedSum(checked_.unpackedBytes, checked->unpackedBytes);
        return {};
    }

    bool isGridType() const { return type_ == "ImageData" || type_ == "RectilinearGrid" || type_ == "StructuredGrid"; }

    fs::path path_;
    std::string type_;
    int filesWithin_;
    XmlFiles& files_;
    CheckedFile checked_;
    std::uint64_t readings_ = 1; ///< XmlFiles::readings
    std::uint64_t tags_ = 0;
    std::int64_t level_ = 0;
    std::string named_; ///< the first file that it names
    bool isGrid_ = false;
    std::optional<double> whole_;
    double covered_ = 0;
    std::string_view section_; ///< of a piece: PointData ...
    std::uint64_t points_ = 0; ///< of the piece
    std::uint64_t cells_ = 0;
};

} // namespace

std::string xmlType(const fs::path& path)
{
    constexpr std::size_t mostBytes = 4096;
    const auto file = MappedFile::open(path);
    if (!file)
        return {};
    const std::span<const std::byte> bytes = (*file)->bytes();
    const std::string start(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), mostBytes));
    const auto element = start.find("<VTKFile");
    return element == std::string::npos ? "" : std::string(xmlAttribute(start.substr(element), "type"));
}

Result<CheckedFile> checkXml(const fs::path& path)
{
    constexpr std::uint64_t mostTimes = 100; // that a file is named, on average: VTK reads it each time anew
    XmlFiles files{.home = path.parent_path(), .readings = {}};
    auto checked = XmlCheck(path, blocksOfPieces, files).run();
    const std::uint64_t readings = files.readings[path.lexically_normal()], there = files.readings.size();
    if (checked && readings > boundedProduct(mostTimes, there))
        return wrongXml(Message::say("it lists %1 files %2 times in all.", there - 1, readings - 1));
    return checked;
}

} // namespace tetra
