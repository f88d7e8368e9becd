// SPDX-License-Identifier: GPL-3.0-or-later
// The format: EnSight User Manual, chapter 11. Where VTK 9.1 reads something else than the manual says, what VTK reads
// is counted (vtkEnSightGoldReader.cxx, vtkEnSight6Reader.cxx).
#include "plugins/readers/vtk/checks/format_checks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view enSightBlanks = " \t\r\n\v\f";
constexpr std::size_t valueWidth = 12; ///< of a number in the files, by the format
constexpr std::size_t indexWidth = 10;

std::string_view withoutLeadingBlanks(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(enSightBlanks), text.size()));
    return text;
}

std::vector<std::string> enSightWords(std::string_view text)
{
    std::vector<std::string> words;
    for (text = withoutLeadingBlanks(text); !text.empty(); text = withoutLeadingBlanks(text)) {
        words.emplace_back(text.substr(0, text.find_first_of(enSightBlanks)));
        text.remove_prefix(words.back().size());
    }
    return words;
}

/// Takes a number of at most `width` characters off the front, as scanf does; nothing if none stands there.
template <class Number> std::optional<Number> takeNumber(std::string_view& text, std::size_t width)
{
    text = withoutLeadingBlanks(text);
    std::string_view word = text.substr(0, std::min(text.find_first_of(enSightBlanks), width));
    const std::size_t length = word.size();
    if (word.starts_with('+'))
        word.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc::invalid_argument || end != word.data() + word.size())
        return std::nullopt;
    text.remove_prefix(length);
    return number;
}

std::optional<std::int64_t> leadingInteger(std::string_view text)
{
    text = withoutLeadingBlanks(text);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() ? std::optional(number) : std::nullopt;
}

std::size_t countIntegers(std::string_view text)
{
    std::size_t count = 0;
    while (takeNumber<std::int64_t>(text, std::string_view::npos))
        ++count;
    return count;
}

/// What a refusal inside of the walk through a file carries out of it. (It does not leave this file.)
struct EnSightProblem {
    Message text;
};

/// The lines of a file as VTK sees them.
class EnSightLines {
public:
    EnSightLines(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    /// False at the end of the file.
    bool next()
    {
        if (at_ >= text_.size())
            return false;
        const auto end = text_.find('\n', at_);
        line_ = text_.substr(at_, end == std::string_view::npos ? end : end - at_);
        ends_ = end != std::string_view::npos || line_.ends_with('\r');
        at_ = end == std::string_view::npos ? text_.size() : end + 1;
        ++number_;
        return true;
    }

    /// The next one that is neither blank nor a comment.
    bool nextData()
    {
        while (next())
            if (!line_.starts_with('#') && !line_.starts_with("maximum time steps:") &&
                line_.find_first_not_of(enSightBlanks) != std::string_view::npos)
                return true;
        line_ = {};
        return false;
    }

    std::string_view line() const { return line_; }
    /// False if the file ends in this line, of which more may have stood there.
    bool lineEnds() const { return ends_; }
    bool startsWith(std::string_view word) const { return line_.starts_with(word); }

    void needNext(MarkedText what)
    {
        if (!next())
            endsBefore(what);
    }
    void needData(MarkedText what)
    {
        if (!nextData())
            endsBefore(what);
    }

    /// This line must begin with so many numbers.
    template <class Number> void numbers(std::size_t count, MarkedText what)
    {
        constexpr bool whole = std::is_integral_v<Number>;
        std::string_view rest = line_;
        for (std::size_t i = 0; i < count; ++i)
            if (!takeNumber<Number>(rest, whole || count == 1 ? std::string_view::npos : valueWidth))
                refuse(Message::say("has no %1 in line %2, but '%3'. It is damaged, or of another version of the "
                                    "format: export it again.",
                                    what, number_, printable(line_)));
        // A number that nothing ends may be a part of one. The format gives each a width.
        if (!ends_ && rest.empty() && line_.size() < count * (whole ? indexWidth : valueWidth))
            endsBefore(what);
    }

    /// The next `count` values, so many in each line.
    void values(std::uint64_t count, std::uint64_t perLine, MarkedText what)
    {
        for (; count > 0; count -= std::min(count, perLine)) {
            needData(what);
            numbers<double>(static_cast<std::size_t>(std::min(count, perLine)), what);
        }
    }

    std::uint64_t size(MarkedText what)
    {
        needData(what);
        const auto number = leadingInteger(line_);
        if (!number || *number < 0)
            refuse(Message::say("has no %1 in line %2, but '%3'. It is damaged: export it again.", what, number_,
                                printable(line_)));
        // Each of them takes two bytes at least.
        if (static_cast<std::uint64_t>(*number) > text_.size())
            endsBefore(what);
        return static_cast<std::uint64_t>(*number);
    }

    [[noreturn]] void endsBefore(MarkedText what) const
    {
        refuse(
            Message::say("ends in line %1, before the last %2. It is cut short: copy the file again.", number_, what));
    }
    /// `what` goes on behind the file's name.
    [[noreturn]] void refuse(const Message& what) const
    {
        throw EnSightProblem{Message::say("its file '%1' %2", name_, what)};
    }

private:
    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    std::string_view line_;
    bool ends_ = true;
    std::uint64_t number_ = 0;
};

/// Elements with a fixed number of nodes; those of longer names first, because names are told by their beginning.
struct ElementKind {
    std::string_view name;
    std::size_t nodes;
    std::size_t corners;
};
constexpr std::array<ElementKind, 14> elementKinds = {{{"bar2", 2, 2},
                                                       {"bar3", 3, 3},
                                                       {"tria3", 3, 3},
                                                       {"tria6", 6, 3},
                                                       {"quad4", 4, 4},
                                                       {"quad8", 8, 4},
                                                       {"tetra4", 4, 4},
                                                       {"tetra10", 10, 4},
                                                       {"pyramid5", 5, 5},
                                                       {"pyramid13", 13, 5},
                                                       {"hexa8", 8, 8},
                                                       {"hexa20", 20, 8},
                                                       {"penta6", 6, 6},
                                                       {"penta15", 15, 6}}};

const ElementKind* elementKindOf(std::string_view line)
{
    const auto found =
        std::ranges::find_if(elementKinds, [&](const ElementKind& k) { return line.starts_with(k.name); });
    return found == elementKinds.end() ? nullptr : &*found;
}

/// The name of the elements that a line announces, of all kinds; empty if it announces none.
std::string_view elementName(std::string_view line)
{
    for (const std::string_view name : {"point", "nsided", "nfaced"})
        if (line.starts_with(name))
            return name;
    const ElementKind* kind = elementKindOf(line);
    return kind == nullptr ? std::string_view() : kind->name;
}

struct EnSightPart {
    bool isBlock = false;
    std::uint64_t points = 0;
    std::uint64_t cells = 0;
    std::map<std::string_view, std::uint64_t> elements{};
};

struct EnSightGeometry {
    std::map<std::int64_t, EnSightPart> parts;
    std::uint64_t globalPoints = 0; ///< of EnSight 6, whose unstructured parts share them
    std::uint64_t measuredPoints = 0;
};

struct EnSightVariable {
    int components = 1;
    bool perElement = false;
    bool measured = false;
    std::int64_t timeSet = 1;
    std::optional<std::int64_t> fileSet{};
    std::vector<std::string> files{}; ///< two of complex ones
};

struct EnSightTimeSet {
    std::vector<float> times;
    std::vector<std::int64_t> fileNumbers;
};

struct EnSightFileSet {
    std::vector<std::int64_t> fileNumbers;
    std::vector<std::int64_t> steps;
};

struct EnSightCase {
    bool gold = false;
    EnSightVariable geometry;
    EnSightVariable measured;
    std::vector<EnSightVariable> variables;
    std::map<std::int64_t, EnSightTimeSet> timeSets;
    std::map<std::int64_t, EnSightFileSet> fileSets;
};

/// The case file, as far as it says which files there are.
class CaseFile {
public:
    CaseFile(std::string_view text, const std::string& name) : lines_(text, name) {}

    EnSightCase read()
    {
        lines_.needData(Message::marked("line 'FORMAT'"));
        if (!lines_.startsWith("FORMAT"))
            lines_.refuse(Message::say("does not begin with FORMAT. It is damaged, or not an EnSight case."));
        lines_.needData(Message::marked("line 'type:'"));
        const auto type = enSightWords(lines_.line());
        if (type.size() > 1 && type[1] == "master_server")
            throw EnSightProblem{Message::say("it is a list of EnSight cases, which VTK 9.1 does not read. Open one of "
                                              "the cases that it names.")};
        case_.gold = type.size() > 2 && type[2] == "gold";
        for (bool more = lines_.nextData(); more;) {
            if (lines_.startsWith("GEOMETRY"))
                more = geometry();
            else if (lines_.startsWith("VARIABLE"))
                more = variables();
            else if (lines_.startsWith("TIME"))
                more = times();
            else if (lines_.startsWith("FILE"))
                more = files();
            else // VTK would look at this line for ever
                lines_.refuse(
                    Message::say("has a section '%1', which VTK cannot skip. Remove it, or put it after the variables.",
                                 printable(lines_.line())));
        }
        if (case_.geometry.files.empty())
            lines_.refuse(Message::say("names no geometry ('model:'). It is cut short or damaged."));
        return std::move(case_);
    }

private:
    bool atSection() const
    {
        return lines_.startsWith("FORMAT") || lines_.startsWith("GEOMETRY") || lines_.startsWith("VARIABLE") ||
               lines_.startsWith("TIME") || lines_.startsWith("FILE");
    }

    /// "[time set] [file set] words ...", from a word on: the sets, and the first word that is none.
    static std::size_t takeSets(const std::vector<std::string>& words, std::size_t from, EnSightVariable& variable)
    {
        std::vector<std::int64_t> sets;
        while (from + 1 < words.size() && sets.size() < 2) {
            const auto set = parseNumber<std::int64_t>(words[from]);
            if (!set)
                break;
            sets.push_back(*set);
            ++from;
        }
        if (!sets.empty())
            variable.timeSet = sets[0];
        if (sets.size() > 1)
            variable.fileSet = sets[1];
        return from;
    }

    bool geometry()
    {
        bool more = lines_.nextData();
        for (; more && (lines_.startsWith("m") || lines_.startsWith("boundary:") || lines_.startsWith("rigid_body:"));
             more = lines_.nextData())
            for (EnSightVariable* variable : {&case_.geometry, &case_.measured})
                if (lines_.startsWith(variable == &case_.geometry ? "model:" : "measured:")) {
                    const auto words = enSightWords(lines_.line());
                    if (const std::size_t name = takeSets(words, 1, *variable); name < words.size())
                        variable->files = {words[name]};
                }
        return more;
    }

    bool variables()
    {
        constexpr std::size_t most = 5000; // VTK looks through all of them for each
        bool more = lines_.nextData();
        for (; more && !atSection(); more = lines_.nextData())
            if (auto variable = variableOf(enSightWords(lines_.line()))) {
                if (case_.variables.size() == most)
                    lines_.refuse(
                        Message::say("names more than %1 variables. Take out those that are not needed.", most));
                case_.variables.push_back(*std::move(variable));
            }
        return more;
    }

    /// "complex scalar per measured node: [time set] [file set] description file [file] ..."
    static std::optional<EnSightVariable> variableOf(const std::vector<std::string>& words)
    {
        EnSightVariable variable;
        std::size_t at = 0;
        const auto is = [&](std::string_view word) { return at < words.size() && words[at] == word; };
        const bool complex = is("complex");
        at += complex ? 1 : 0;
        if (is("scalar"))
            variable.components = 1;
        else if (is("vector"))
            variable.components = 3;
        else if (is("tensor"))
            variable.components = 6;
        else
            return std::nullopt;
        if (++at; is("asym")) {
            variable.components = 9;
            ++at;
        } else if (is("symm")) {
            ++at;
        }
        at += is("per") ? 1 : 0;
        variable.measured = is("measured");
        at += variable.measured ? 1 : 0;
        if (!is("node:") && !is("element:"))
            return std::nullopt;
        variable.perElement = is("element:");
        const std::size_t first = takeSets(words, at + 1, variable) + 1; // behind the description
        for (std::size_t file = first; file < words.size() && file < first + (complex ? 2 : 1); ++file)
            variable.files.push_back(words[file]);
        return variable;
    }

    /// The numbers behind the colon of this line and in the lines below it, up to a line without one.
    template <class Number> std::vector<Number> list(std::uint64_t count)
    {
        std::vector<Number> numbers;
        std::string_view rest = lines_.line().substr(std::min(lines_.line().find(':'), lines_.line().size() - 1) + 1);
        while (numbers.size() < count) {
            if (const auto number = takeNumber<Number>(rest, std::string_view::npos)) {
                numbers.push_back(*number);
                continue;
            }
            if (!lines_.nextData())
                break;
            rest = lines_.line();
            if (std::string_view probe = rest; !takeNumber<double>(probe, std::string_view::npos))
                break;
        }
        return numbers;
    }

    std::int64_t behindColon(MarkedText what)
    {
        const auto place = lines_.line().find(':');
        const auto number =
            place == std::string_view::npos ? std::nullopt : leadingInteger(lines_.line().substr(place + 1));
        if (!number)
            lines_.refuse(Message::say("has no %1. It is cut short or damaged.", what));
        return *number;
    }

    bool times()
    {
        constexpr std::int64_t most = 10'000'000;
        bool more = lines_.nextData();
        while (more && !atSection()) {
            EnSightTimeSet& set = case_.timeSets[behindColon(Message::marked("number of a time set"))];
            lines_.needData(Message::marked("line 'number of steps:'"));
            const std::int64_t steps = behindColon(Message::marked("number of time steps"));
            if (steps < 1 || steps > most)
                lines_.refuse(Message::say("states that there are %1 time steps.", steps));
            const auto count = static_cast<std::uint64_t>(steps);
            lines_.needData(Message::marked("line 'time values:'"));
            if (lines_.startsWith("filename numbers"))
                set.fileNumbers = list<std::int64_t>(count);
            else if (lines_.startsWith("filename start")) {
                const std::int64_t first = behindColon(Message::marked("first number of its files"));
                lines_.needData(Message::marked("line 'filename increment:'"));
                const std::int64_t step = behindColon(Message::marked("increment of its files' numbers"));
                for (std::int64_t i = 0; i < steps; ++i) // without signs: numbers that no file has may overflow
                    set.fileNumbers.push_back(
                        static_cast<std::int64_t>(static_cast<std::uint64_t>(first) +
                                                  static_cast<std::uint64_t>(i) * static_cast<std::uint64_t>(step)));
            }
            while (!lines_.startsWith("time values"))
                lines_.needData(Message::marked("line 'time values:'"));
            set.times = list<float>(count);
            if (set.times.size() < count)
                lines_.refuse(
                    Message::say("has %1 of %2 time values. It is cut short or damaged.", set.times.size(), count));
            do
                more = lines_.nextData();
            while (more && !lines_.startsWith("time set") && !atSection());
        }
        return more;
    }

    bool files()
    {
        bool more = lines_.nextData();
        while (more && !atSection()) {
            EnSightFileSet& set = case_.fileSets[behindColon(Message::marked("number of a file set"))];
            lines_.needData(Message::marked("line 'number of steps:'"));
            if (!lines_.startsWith("filename")) {
                set.steps.push_back(behindColon(Message::marked("number of time steps in a file")));
                more = lines_.nextData();
                continue;
            }
            for (more = true; more && lines_.startsWith("filename"); more = lines_.nextData()) {
                set.fileNumbers.push_back(behindColon(Message::marked("number of a file")));
                lines_.needData(Message::marked("line 'number of steps:'"));
                set.steps.push_back(behindColon(Message::marked("number of time steps in a file")));
            }
        }
        return more;
    }

    EnSightLines lines_;
    EnSightCase case_;
};

/// Geometry and variables of both versions. Everything throws EnSightProblem.
class EnSightWalk {
public:
    EnSightWalk(EnSightLines& lines, EnSightGeometry& geometry, bool gold)
        : lines_(lines), geometry_(geometry), gold_(gold)
    {
    }

    /// To the step (from 1) of a file that holds several; not at all for 0.
    void moveToStep(std::int64_t step)
    {
        constexpr const char* mark = "BEGIN TIME STEP";
        for (std::int64_t found = 0; found < step;) {
            lines_.needNext(Message::marked("time step"));
            found += withoutLeadingBlanks(lines_.line()).starts_with(mark) ? 1 : 0;
        }
    }

    void geometryFile()
    {
        lines_.needNext(Message::marked("line of its description")); // the second one
        const auto id = [&](MarkedText what) {
            lines_.needData(what);
            const auto words = enSightWords(lines_.line());
            return words.size() > 2 && (words[2].starts_with("given") || words[2].starts_with("ignore"));
        };
        const bool nodeIds = id(Message::marked("line 'node id'"));
        elementIds_ = id(Message::marked("line 'element id'"));
        if (!gold_)
            globalPoints(nodeIds);
        more_ = lines_.nextData();
        if (gold_ && more_ && lines_.startsWith("extents"))
            for (int i = 0; i < 4; ++i)
                more_ = lines_.nextData();
        while (more_ && !atStepEnd())
            gold_ ? goldPart() : oldPart();
        if (geometry_.parts.empty())
            lines_.endsBefore(Message::marked("part"));
    }

    void measuredFile()
    {
        lines_.needNext(Message::marked("line 'particle coordinates'"));
        lines_.needNext(Message::marked("number of points"));
        const auto count = leadingInteger(lines_.line());
        if (!count || *count < 0)
            lines_.refuse(Message::say("does not state how many measured points it has. It is damaged."));
        geometry_.measuredPoints = static_cast<std::uint64_t>(*count);
        for (std::uint64_t i = 0; i < geometry_.measuredPoints; ++i) {
            lines_.needNext(Message::marked("measured point"));
            pointWithId();
        }
    }

    void variableFile(const EnSightVariable& variable)
    {
        if (gold_)
            lines_.needData(Message::marked("line of its description"));
        else
            lines_.needNext(Message::marked("line of its description"));
        const auto components = static_cast<std::uint64_t>(variable.components);
        if (variable.measured) {
            lines_.values(geometry_.measuredPoints * components, 6, Message::marked("value"));
            return;
        }
        more_ = lines_.nextData();
        if (!more_ || atStepEnd())
            lines_.endsBefore(Message::marked("value"));
        if (!gold_ && !variable.perElement && !atPart())
            globalValues(components);
        while (more_ && !atStepEnd()) {
            const EnSightPart& part = variablePart();
            gold_ ? goldValues(variable, part, components) : oldValues(variable, part, components);
        }
    }

private:
    bool atPart() const { return withoutLeadingBlanks(lines_.line()).starts_with("part"); }
    bool atStepEnd() const { return withoutLeadingBlanks(lines_.line()).starts_with("END TIME STEP"); }

    void pointWithId()
    {
        std::string_view rest = lines_.line();
        bool good = takeNumber<std::int64_t>(rest, 8).has_value();
        for (int axis = 0; good && axis < 3; ++axis)
            good = takeNumber<double>(rest, valueWidth).has_value();
        if (!good)
            lines_.refuse(
                Message::say("has no point in the line '%1'. It is cut short or damaged.", printable(lines_.line())));
        lines_.numbers<double>(1, Message::marked("position")); // and is it whole
    }

    void globalPoints(bool withIds)
    {
        lines_.needData(Message::marked("line 'coordinates'"));
        geometry_.globalPoints = lines_.size(Message::marked("number of points"));
        for (std::uint64_t i = 0; i < geometry_.globalPoints; ++i) {
            lines_.needData(Message::marked("position"));
            if (withIds)
                pointWithId();
            else
                lines_.numbers<double>(3, Message::marked("position"));
        }
    }

    EnSightPart& newPart(std::int64_t number) { return geometry_.parts[number]; }

    std::int64_t partNumber(std::string_view text)
    {
        const auto number = leadingInteger(text);
        if (!number)
            lines_.refuse(Message::say("has a part without a number, in the line '%1'. It is damaged.",
                                       printable(lines_.line())));
        return *number;
    }

    void needPart()
    {
        if (!atPart())
            lines_.refuse(Message::say("has '%1' where a part should begin; VTK skips this and all that follows. It is "
                                       "damaged, or of another version of the format: export it again.",
                                       printable(lines_.line())));
    }

    std::array<std::uint64_t, 3> dimensions()
    {
        lines_.needData(Message::marked("size of a block"));
        lines_.numbers<std::int64_t>(3, Message::marked("size of a block"));
        std::array<std::uint64_t, 3> size{};
        std::string_view rest = lines_.line();
        for (std::uint64_t& points : size) {
            const std::int64_t number = takeNumber<std::int64_t>(rest, std::string_view::npos).value_or(0);
            if (number < 1)
                lines_.refuse(Message::say("has a block of the size '%1'. It is damaged.", printable(lines_.line())));
            points = static_cast<std::uint64_t>(number);
        }
        return size;
    }

    /// Beginning at the line "block ...".
    void block(EnSightPart& part)
    {
        part.isBlock = true;
        const auto words = enSightWords(lines_.line());
        const auto word = [&](std::size_t i) { return i < words.size() ? std::string_view(words[i]) : ""; };
        const auto size = dimensions();
        part.points = boundedProduct(boundedProduct(size[0], size[1]), size[2]);
        part.cells = 1;
        for (const std::uint64_t points : size)
            part.cells = boundedProduct(part.cells, std::max<std::uint64_t>(1, points - 1));
        const bool rectilinear = gold_ && word(1).starts_with("rectilinear");
        const bool uniform = gold_ && word(1).starts_with("uniform");
        const std::uint64_t perLine = gold_ ? 1 : 6;
        if (rectilinear)
            lines_.values(boundedSum(size[0] + size[1], size[2]), 1, Message::marked("coordinate of a block"));
        else if (uniform)
            lines_.values(6, 1, Message::marked("origin or spacing of a block"));
        else
            for (int axis = 0; axis < 3; ++axis)
                lines_.values(part.points, perLine, Message::marked("position"));
        if (word(rectilinear || uniform ? 2 : 1).starts_with("iblanked"))
            blanking(part.points);
        more_ = lines_.nextData();
    }

    void blanking(std::uint64_t points)
    {
        const std::uint64_t perLine = gold_ ? 1 : 10;
        for (; points > 0; points -= std::min(points, perLine)) {
            lines_.needData(Message::marked("mark of a blanked point"));
            lines_.numbers<std::int64_t>(static_cast<std::size_t>(std::min(points, perLine)),
                                         Message::marked("mark of a blanked point"));
        }
    }

    void integers(std::uint64_t count, MarkedText what)
    {
        for (; count > 0; --count) {
            lines_.needData(what);
            lines_.numbers<std::int64_t>(1, what);
        }
    }

    void goldPart()
    {
        needPart();
        lines_.needData(Message::marked("number of a part"));
        EnSightPart& part = newPart(partNumber(lines_.line()));
        lines_.needData(Message::marked("name of a part"));
        lines_.needData(Message::marked("kind of a part"));
        if (lines_.startsWith("block"))
            return block(part);
        more_ = true;
        while (more_ && !atPart() && !atStepEnd())
            goldSection(part);
        if (part.elements.empty())
            lines_.endsBefore(Message::marked("element"));
    }

    void goldSection(EnSightPart& part)
    {
        const bool ghost = lines_.startsWith("g_");
        const std::string_view line = lines_.line().substr(ghost ? 2 : 0);
        if (lines_.startsWith("coordinates"))
            return goldCoordinates(part);
        const std::string_view name = elementName(line);
        if (name.empty())
            lines_.refuse(Message::say("has '%1' where elements should begin. It is damaged, or of another version of "
                                       "the format: export it again.",
                                       printable(lines_.line())));
        const ElementKind* kind = elementKindOf(name);
        const std::uint64_t count = lines_.size(Message::marked("number of elements"));
        if (kind != nullptr)
            goldElements(count, kind->nodes);
        else if (name == "point")
            goldPoints(count);
        else
            goldPolygons(count, name == "nfaced");
        if (!ghost) {
            part.elements[name] += count;
            part.cells += count;
        }
    }

    void goldCoordinates(EnSightPart& part)
    {
        part.points = lines_.size(Message::marked("number of points"));
        lines_.values(boundedProduct(3, part.points), 1, Message::marked("position"));
        more_ = lines_.nextData();
        std::string_view probe = lines_.line();
        if (more_ && part.points > 0 &&
            takeNumber<double>(probe, std::string_view::npos)) { // the numbers of the nodes came first
            lines_.values(part.points - 1, 1, Message::marked("position"));
            more_ = lines_.nextData();
        }
    }

    void goldElements(std::uint64_t count, std::size_t nodes)
    {
        more_ = lines_.nextData();
        if (count == 0)
            return;
        if (more_ && countIntegers(lines_.line()) < nodes) { // their numbers come first
            lines_.numbers<std::int64_t>(1, Message::marked("element"));
            integers(count - 1, Message::marked("element"));
            more_ = lines_.nextData();
        }
        for (std::uint64_t i = 0; i < count; ++i, more_ = lines_.nextData()) {
            if (!more_)
                lines_.endsBefore(Message::marked("element"));
            lines_.numbers<std::int64_t>(nodes, Message::marked("element"));
        }
    }

    void goldPoints(std::uint64_t count)
    {
        integers(count, Message::marked("element"));
        more_ = lines_.nextData();
        if (count == 0 || !more_ || !leadingInteger(lines_.line()))
            return;
        integers(count - 1, Message::marked("element"));
        more_ = lines_.nextData();
    }

    /// Polygons, and polyhedra made of such.
    void goldPolygons(std::uint64_t count, bool solid)
    {
        if (elementIds_)
            integers(count, Message::marked("element"));
        std::uint64_t polygons = count;
        if (solid)
            polygons = sizes(count, Message::marked("number of faces"), nullptr);
        std::vector<std::uint32_t> corners;
        sizes(polygons, Message::marked("number of corners"), &corners);
        for (const std::uint32_t nodes : corners) {
            lines_.needData(Message::marked("element"));
            lines_.numbers<std::int64_t>(nodes, Message::marked("element"));
        }
        more_ = lines_.nextData();
    }

    /// The sum of so many numbers, a line each.
    std::uint64_t sizes(std::uint64_t count, MarkedText what, std::vector<std::uint32_t>* kept)
    {
        std::uint64_t sum = 0;
        for (; count > 0; --count) {
            const std::uint64_t size = lines_.size(what);
            sum += size;
            if (kept != nullptr)
                kept->push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(size, UINT32_MAX)));
        }
        return sum;
    }

    void oldPart()
    {
        needPart();
        EnSightPart& part = newPart(partNumber(withoutLeadingBlanks(lines_.line()).substr(4)));
        lines_.needNext(Message::marked("name of a part"));
        lines_.needData(Message::marked("kind of a part"));
        if (withoutLeadingBlanks(lines_.line()).starts_with("block"))
            return block(part);
        part.points = geometry_.globalPoints;
        more_ = true;
        while (more_ && !atPart() && !atStepEnd()) {
            const std::string_view line = withoutLeadingBlanks(lines_.line());
            const std::string_view name = elementName(line);
            const ElementKind* kind = elementKindOf(line);
            if (name.empty() || (kind == nullptr && name != "point")) // VTK would look at this line for ever
                lines_.refuse(Message::say("has '%1' where elements should begin, which VTK does not recognise. It is "
                                           "damaged, or of another version of the format: export it again.",
                                           printable(line)));
            const std::uint64_t count = lines_.size(Message::marked("number of elements"));
            for (std::uint64_t i = 0; i < count; ++i) {
                lines_.needData(Message::marked("element"));
                lines_.numbers<std::int64_t>(kind == nullptr ? 1 : kind->corners, Message::marked("element"));
                if (kind != nullptr && countIntegers(lines_.line()) < kind->nodes)
                    lines_.refuse(Message::say("has an element with too few corners: '%1'. It is cut short or damaged.",
                                               printable(lines_.line())));
            }
            part.elements[name] += count;
            part.cells += count;
            more_ = lines_.nextData();
        }
        if (part.elements.empty())
            lines_.endsBefore(Message::marked("element"));
    }

    const EnSightPart& variablePart()
    {
        needPart();
        if (gold_)
            lines_.needData(Message::marked("number of a part"));
        const std::string_view line = withoutLeadingBlanks(lines_.line());
        const auto found = geometry_.parts.find(partNumber(gold_ ? line : line.substr(4)));
        if (found == geometry_.parts.end())
            lines_.refuse(Message::say("has values of part '%1', which the geometry does not have. One of the two is "
                                       "cut short, or they do not belong together.",
                                       printable(line)));
        return found->second;
    }

    void globalValues(std::uint64_t components)
    {
        std::uint64_t left = geometry_.globalPoints * components;
        const auto line = [&] {
            const std::uint64_t here = std::min<std::uint64_t>(left, 6);
            lines_.numbers<double>(static_cast<std::size_t>(here), Message::marked("value"));
            left -= here;
        };
        if (left > 0)
            line();
        while (left > 0) {
            lines_.needData(Message::marked("value"));
            line();
        }
        more_ = lines_.nextData();
    }

    /// "undef" and a value, or "partial" and a list of those that have one, may stand behind a keyword: how many values
    /// follow for each component.
    std::uint64_t valuesBehindKeyword(std::uint64_t all)
    {
        const auto words = enSightWords(lines_.line());
        if (words.size() < 2)
            return all;
        if (words[1] == "undef")
            lines_.values(1, 1, Message::marked("value"));
        if (words[1] != "partial")
            return all;
        const std::uint64_t some = lines_.size(Message::marked("number of values"));
        integers(some, Message::marked("place of a value"));
        return some;
    }

    /// Those of a part, kind by kind in any order; `read` goes through the values of so many elements.
    template <class Read> void valuesOfElements(const EnSightPart& part, const Read& read)
    {
        auto missing = part.elements;
        while (more_ && !atPart() && !atStepEnd()) {
            const std::string_view name = elementName(lines_.line());
            const auto found = part.elements.find(name);
            if (found == part.elements.end())
                lines_.refuse(Message::say("has values of '%1', which the part does not have. It is damaged, or does "
                                           "not belong to the geometry.",
                                           printable(lines_.line())));
            read(found->second);
            missing.erase(name);
            more_ = lines_.nextData();
        }
        // VTK leaves what was in memory in the place of those.
        for (const auto& [name, count] : missing)
            if (count > 0)
                lines_.refuse(Message::say("has no values of the elements '%1' of a part. It is cut short, or "
                                           "incomplete: export it again.",
                                           name));
    }

    void goldValues(const EnSightVariable& variable, const EnSightPart& part, std::uint64_t components)
    {
        more_ = lines_.nextData();
        if ((variable.perElement ? part.cells : part.points) == 0)
            return;
        if (!more_)
            lines_.endsBefore(Message::marked("value"));
        if (!variable.perElement || lines_.startsWith("block")) {
            const std::uint64_t count = valuesBehindKeyword(variable.perElement ? part.cells : part.points);
            lines_.values(boundedProduct(count, components), 1, Message::marked("value"));
            more_ = lines_.nextData();
            return;
        }
        valuesOfElements(part, [&](std::uint64_t all) {
            lines_.values(boundedProduct(valuesBehindKeyword(all), components), 1, Message::marked("value"));
        });
    }

    void oldValues(const EnSightVariable& variable, const EnSightPart& part, std::uint64_t components)
    {
        lines_.needData(Message::marked("value"));
        if (part.isBlock && components > 1 && !variable.perElement)
            lines_.refuse(Message::say("has vectors of a block in the text format of EnSight 6, which VTK reads "
                                       "wrongly. Write the case as EnSight Gold, or the data as .vts."));
        if (part.isBlock || !variable.perElement) {
            for (std::uint64_t component = 0; component < components; ++component)
                lines_.values(variable.perElement ? part.cells : part.points, 6, Message::marked("value"));
            more_ = lines_.nextData();
            return;
        }
        more_ = true;
        valuesOfElements(part, [&](std::uint64_t all) {
            lines_.values(boundedProduct(all, components), 6, Message::marked("value"));
        });
    }

    EnSightLines& lines_;
    EnSightGeometry& geometry_;
    bool gold_;
    bool elementIds_ = false;
    bool more_ = true; ///< the lines have not ended, and a next one is at hand
};

/// "run.heat**" with the number in place of the stars.
std::string withNumber(const std::string& name, std::int64_t number)
{
    const auto first = name.find('*');
    if (first == std::string::npos)
        return name;
    const std::size_t stars = std::min(name.find_first_not_of('*', first), name.size()) - first;
    std::string digits = std::to_string(number);
    if (digits.size() < stars)
        digits.insert(0, stars - digits.size(), '0');
    std::string result = name.substr(0, first) + digits + name.substr(first + stars);
    std::erase(result, '*');
    return result;
}

class EnSightCheck {
public:
    EnSightCheck(const fs::path& path, std::int64_t timeStep) : path_(path), timeStep_(timeStep) {}

    Result<CheckedFile> run()
    try {
        const auto file = MappedFile::open(path_);
        if (!file)
            return file.error();
        checked_.bytes = (*file)->bytes().size();
        case_ = CaseFile(asText(**file), printable(path_.filename().string())).read();
        chooseTime();
        EnSightGeometry geometry;
        walk(case_.geometry, geometry, [](EnSightWalk& walk) { walk.geometryFile(); });
        if (!case_.measured.files.empty())
            walk(case_.measured, geometry, [](EnSightWalk& walk) { walk.measuredFile(); });
        for (const EnSightVariable& variable : case_.variables)
            walk(variable, geometry, [&](EnSightWalk& walk) { walk.variableFile(variable); });
        return checked_;
    } catch (const EnSightProblem& problem) {
        return Error{ErrorKind::BadInput, problem.text};
    }

private:
    static std::string_view asText(const MappedFile& file)
    {
        return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
    }

    /// The time that VTK would be asked for: the steps of all sets, put together.
    void chooseTime()
    {
        std::vector<float> times;
        for (const auto& [id, set] : case_.timeSets)
            times.insert(times.end(), set.times.begin(), set.times.end());
        std::ranges::sort(times);
        times.erase(std::unique(times.begin(), times.end()), times.end());
        if (timeStep_ >= 1 && static_cast<std::size_t>(timeStep_) <= times.size())
            time_ = times[static_cast<std::size_t>(timeStep_ - 1)];
    }

    struct Place {
        std::optional<std::int64_t> number{}; ///< that stands in the file's name
        std::int64_t step = 0;                ///< in the file; 0: it holds one only
    };

    /// Nothing if the variable has no values yet at the time.
    std::optional<Place> placeOf(const EnSightVariable& variable, bool isGeometry) const
    {
        const auto set = case_.timeSets.find(variable.timeSet);
        if (set == case_.timeSets.end())
            return Place{};
        std::int64_t step = std::ranges::count_if(set->second.times, [&](float time) { return time <= time_; });
        if (isGeometry)
            step = std::max<std::int64_t>(1, step);
        if (step == 0)
            return std::nullopt;
        Place place;
        const auto files = case_.fileSets.find(variable.fileSet.value_or(1));
        if (case_.fileSets.empty() || files == case_.fileSets.end()) {
            if (static_cast<std::size_t>(step) <= set->second.fileNumbers.size())
                place.number = set->second.fileNumbers[static_cast<std::size_t>(step - 1)];
            return place;
        }
        std::size_t file = 0;
        while (file + 1 < files->second.steps.size() && step > files->second.steps[file])
            step -= files->second.steps[file++];
        if (file < files->second.fileNumbers.size())
            place.number = files->second.fileNumbers[file];
        place.step = step;
        return place;
    }

    template <class Work> void walk(const EnSightVariable& variable, EnSightGeometry& geometry, const Work& work)
    {
        const bool isGeometry = &variable == &case_.geometry || &variable == &case_.measured;
        const auto place = placeOf(variable, isGeometry);
        for (const std::string& pattern : variable.files) {
            if (!place)
                continue;
            const std::string name = place->number ? withNumber(pattern, *place->number) : pattern;
            const auto below = fileBelow(path_.parent_path(), path_.parent_path(), name);
            if (!below)
                throw EnSightProblem{below.error().message};
            const fs::path& path = *below;
            std::error_code ignored;
            if (!fs::exists(path, ignored))
                throw EnSightProblem{Message::say(
                    "its file '%1' is missing. Copy it into the same folder: they belong together.", printable(name))};
            const auto file = MappedFile::open(path);
            if (!file)
                throw EnSightProblem{file.error().message};
            const std::string_view text = asText(**file);
            checked_.bytes = boundedSum(checked_.bytes, text.size());
            if (&variable == &case_.geometry)
                isBinary_ = text.substr(0, 84).find("inary") != std::string_view::npos;
            if (isBinary_)
                continue;
            EnSightLines lines(text, printable(name));
            EnSightWalk walk(lines, geometry, case_.gold);
            walk.moveToStep(place->step);
            if (isGeometry)
                lines.needNext(Message::marked("line of its description"));
            work(walk);
            if (!lines.lineEnds())
                checked_.remarks.push_back(
                    Message::say("Its file '%1' ends without an end of line: if it was cut short there, its last "
                                 "number is wrong.",
                                 printable(name)));
        }
    }

    fs::path path_;
    std::int64_t timeStep_;
    EnSightCase case_;
    CheckedFile checked_;
    float time_ = 0;
    bool isBinary_ = false;
};

} // namespace

Result<CheckedFile> checkEnSight(const fs::path& path, std::int64_t timeStep)
{
    return EnSightCheck(path, timeStep).run();
}

} // namespace tetra
