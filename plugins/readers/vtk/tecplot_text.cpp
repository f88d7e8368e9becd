// SPDX-License-Identifier: GPL-3.0-or-later
// The format: Tecplot 360 Data Format Guide, ASCII data.
#include "plugins/readers/vtk/tecplot_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace tetra {
namespace {

constexpr std::string_view tecplotSeparators = " \t\r\n=,()";
constexpr std::size_t noVariable = ~std::size_t(0);

std::string tecplotUpper(std::string_view text)
{
    std::string upper(text);
    std::ranges::transform(upper, upper.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return upper;
}

struct TecplotToken {
    std::string_view text;
    bool quoted = false;
    bool endsLine = false; ///< it is the last one of its line

    bool isNumber() const
    {
        if (quoted || text.empty())
            return false;
        const std::string upper = text.size() > 8 ? std::string() : tecplotUpper(text);
        return (text[0] >= '0' && text[0] <= '9') || text[0] == '-' || text[0] == '+' || text[0] == '.' ||
               upper == "NAN" || upper == "INF" || upper == "INFINITY";
    }
};

/// Words, strings and numbers; what stands between them (blanks, commas, =, brackets) and comments are passed over.
class TecplotTokens {
public:
    explicit TecplotTokens(std::string_view text) : text_(text) {}

    /// Nothing at the end.
    std::optional<TecplotToken> next()
    {
        skip();
        if (at_ >= text_.size())
            return std::nullopt;
        TecplotToken token;
        const char first = text_[at_];
        if (first == '"' || first == '\'') {
            const auto end = std::min(text_.find(first, at_ + 1), text_.size());
            token = {text_.substr(at_ + 1, end - at_ - 1), true};
            at_ = std::min(end + 1, text_.size());
        } else {
            const auto end = std::min(text_.find_first_of(tecplotSeparators, at_), text_.size());
            token = {text_.substr(at_, end - at_), false};
            at_ = end;
        }
        const auto behind = std::min(text_.find_first_not_of(" \t=,()", at_), text_.size());
        token.endsLine =
            behind == text_.size() || text_[behind] == '\n' || text_[behind] == '\r' || text_[behind] == '#';
        return token;
    }

    /// What stands in the brackets that come next, "([4-6]=CELLCENTERED)" without the outer ones; else the next word.
    std::string_view bracketed()
    {
        at_ = std::min(text_.find_first_not_of(" \t\r\n=,", at_), text_.size());
        if (at_ == text_.size() || text_[at_] != '(') {
            const auto word = next();
            return word ? word->text : std::string_view();
        }
        const auto end = std::min(text_.find(')', at_), text_.size());
        const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
        at_ = std::min(end + 1, text_.size());
        return inside;
    }

    /// The next token if it is a number; else nothing, and it stays the next one.
    std::string_view nextNumber()
    {
        skip();
        const auto end = std::min(text_.find_first_of(tecplotSeparators, at_), text_.size());
        const TecplotToken token{text_.substr(at_, end - at_)};
        if (!token.isNumber())
            return {};
        at_ = end;
        return token.text;
    }

    void back(const TecplotToken& token)
    {
        at_ = static_cast<std::size_t>(token.text.data() - text_.data()) - token.quoted;
    }
    bool atEnd() const { return at_ >= text_.size(); }

private:
    void skip()
    {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(tecplotSeparators, at_), text_.size());
            if (at_ == text_.size() || text_[at_] != '#')
                return;
            at_ = std::min(text_.find('\n', at_), text_.size());
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

bool isRecord(const TecplotToken& token)
{
    constexpr std::array<std::string_view, 9> records = {
        "TITLE", "FILETYPE", "VARIABLES", "ZONE", "TEXT", "GEOMETRY", "CUSTOMLABELS", "DATASETAUXDATA", "VARAUXDATA"};
    return !token.quoted && std::ranges::find(records, tecplotUpper(token.text)) != records.end();
}

/// Which axis a variable is, by its name: "x", "X (m)", "CoordinateX", "I"; nothing if it is none.
std::optional<std::size_t> axisNamed(std::string_view name)
{
    const std::string upper = tecplotUpper(name.substr(std::min(name.find_first_not_of(" \t"), name.size())));
    const std::string whole = upper.substr(0, upper.find_last_not_of(" \t") + 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const char letter = static_cast<char>('X' + axis);
        if (whole == std::string(1, letter) || whole == std::string("COORDINATE") + letter ||
            whole == std::string(1, static_cast<char>('I' + axis)))
            return axis;
        if (whole.size() < 2 || whole[0] != letter)
            continue;
        const auto unit = whole.find_first_not_of(" \t", 1); // a unit in brackets may follow
        if (unit != std::string::npos && (whole[unit] == '[' || whole[unit] == '(' || whole[unit] == '/'))
            return axis;
    }
    return std::nullopt;
}

/// The header of a zone.
struct ZoneHeader {
    TecplotZone zone;
    std::map<std::string, std::string> words; ///< upper case, of keys with one value
    std::vector<bool> isDouble;
    std::vector<std::size_t> sharedFrom; ///< the zone that a variable is shared with; noVariable: with none
    std::vector<bool> passive;
};

class TecplotReading {
public:
    explicit TecplotReading(std::string_view text) : tokens_(text), textBytes_(text.size()) {}

    Result<TecplotFile> run()
    {
        while (auto token = tokens_.next())
            if (const Status read = record(*token); !read)
                return read.error();
        if (file_.zones.empty())
            return Error{ErrorKind::BadInput, Message::say("it has no zone. It is cut short, or not Tecplot text.")};
        return std::move(file_);
    }

private:
    static Error bad(const Message& what) { return {ErrorKind::BadInput, what}; }
    Message zoneName(const TecplotZone& zone) const
    {
        const std::size_t number = file_.zones.size() + 1;
        return zone.name.empty() ? Message::say("its zone %1", number)
                                 : Message::say("its zone %1 ('%2')", number, printable(zone.name));
    }

    Status record(const TecplotToken& token)
    {
        const std::string word = tecplotUpper(token.text);
        if (token.quoted)
            return {}; // a title without its keyword
        if (word == "VARIABLES")
            return variables();
        if (word == "ZONE")
            return zone();
        if (word == "FILETYPE") {
            const auto kind = tokens_.next();
            if (kind && tecplotUpper(kind->text) != "FULL")
                return bad(Message::say(
                    "it holds '%1', not a grid with its values. Write both into one file (FILETYPE = FULL).",
                    printable(kind->text)));
            return {};
        }
        if (word == "TITLE") {
            tokens_.next();
            return {};
        }
        if (token.isNumber())
            return bad(
                Message::say("it has more numbers than its %1 zones require. Its sizes are wrong, or it is damaged.",
                             file_.zones.size()));
        if (!isRecord(token))
            return bad(Message::say(
                "it has '%1' where a record such as ZONE should begin. It is damaged, or not Tecplot text.",
                printable(token.text)));
        for (auto next = tokens_.next(); next; next = tokens_.next()) // what is drawn beside the data
            if (isRecord(*next) && tecplotUpper(next->text) != "TEXT") {
                tokens_.back(*next);
                return {};
            }
        return {};
    }

    Status variables()
    {
        file_.variables.clear();
        bool quoted = false;
        for (auto token = tokens_.next(); token; token = tokens_.next()) {
            if (isRecord(*token) || (quoted && !token->quoted)) {
                tokens_.back(*token);
                break;
            }
            quoted |= token->quoted;
            file_.variables.emplace_back(token->text);
            if (!token->quoted && token->endsLine)
                break;
        }
        std::array<std::optional<std::size_t>, 3> axes;
        for (std::size_t i = 0; i < file_.variables.size(); ++i)
            if (const auto axis = axisNamed(file_.variables[i]); axis && !axes[*axis])
                axes[*axis] = i;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!axes[axis])
                return bad(Message::say("none of its variables is called %1, so that it has no position in space. Name "
                                        "the coordinates X, Y and Z.",
                                        std::string(1, static_cast<char>('X' + axis))));
            file_.axes[axis] = *axes[axis];
        }
        return {};
    }

    Status zone()
    {
        if (file_.variables.empty())
            return bad(Message::say("it has a zone before its VARIABLES. It is damaged."));
        ZoneHeader header;
        const std::size_t count = file_.variables.size();
        header.zone.perElement.assign(count, false);
        header.zone.values.resize(count);
        header.isDouble.assign(count, false);
        header.sharedFrom.assign(count, noVariable);
        header.passive.assign(count, false);
        if (const Status read = zoneHeader(header); !read)
            return read;
        if (const Status placed = strandAndTime(header); !placed)
            return placed;
        if (const Status shaped = shape(header); !shaped)
            return shaped;
        if (const Status read = zoneValues(header); !read)
            return read;
        if (hasConnectivity(header.zone))
            if (const Status read = connectivity(header); !read)
                return read;
        constexpr std::size_t most = 50'000; // some 6 kB each
        if (file_.zones.size() == most)
            return bad(Message::say("it has more than %1 zones. Write files of fewer zones.", most));
        file_.zones.push_back(std::move(header.zone));
        return {};
    }

    /// KEY = VALUE up to the first number that stands where a key should.
    Status zoneHeader(ZoneHeader& header)
    {
        for (auto token = tokens_.next(); token; token = tokens_.next()) {
            if (token->isNumber() || isRecord(*token)) {
                tokens_.back(*token);
                return {};
            }
            const std::string key = tecplotUpper(token->text);
            if (key == "T") {
                if (const auto name = tokens_.next())
                    header.zone.name = name->text;
            } else if (key == "VARLOCATION") {
                if (const Status read = locations(tokens_.bracketed(), header); !read)
                    return read;
            } else if (key == "DT") {
                types(tokens_.bracketed(), header);
            } else if (key == "VARSHARELIST") {
                if (const Status read = shared(tokens_.bracketed(), header); !read)
                    return read;
            } else if (key == "PASSIVEVARLIST") {
                for (const std::size_t variable : variablesIn(tokens_.bracketed()))
                    header.passive[variable] = true;
            } else if (key == "D") { // variables of the zone before, in the old form
                tokens_.bracketed();
                return bad(Message::say("%1 repeats variables with 'D', which is not read. Write it with VARSHARELIST, "
                                        "or all of its variables.",
                                        zoneName(header.zone)));
            } else if (key == "AUXDATA") {
                tokens_.next(); // its name
                tokens_.next();
            } else if (const auto value = tokens_.next()) {
                header.words[key] = tecplotUpper(value->text);
            }
        }
        return bad(
            Message::say("%1 ends within its header. It is cut short: copy the file again.", zoneName(header.zone)));
    }

    /// The variables of "[1-3,5]" or "4", from 0; those that are there.
    std::vector<std::size_t> variablesIn(std::string_view list) const
    {
        std::vector<std::size_t> variables;
        while (!list.empty()) {
            const auto end = std::min(list.find_first_of(",] \t"), list.size());
            std::string_view entry = list.substr(0, end);
            entry.remove_prefix(std::min(entry.find_first_not_of("[ \t"), entry.size()));
            const auto dash = entry.find('-');
            const auto first = parseNumber<std::size_t>(entry.substr(0, dash));
            const auto last = dash == std::string_view::npos ? first : parseNumber<std::size_t>(entry.substr(dash + 1));
            if (first && last)
                for (std::size_t i = std::max<std::size_t>(*first, 1); i <= std::min(*last, file_.variables.size());
                     ++i)
                    variables.push_back(i - 1);
            list.remove_prefix(std::min(end + 1, list.size()));
        }
        return variables;
    }

    /// "[4-6] = CELLCENTERED, 7=NODAL" as pairs; entries without '=' have an empty list.
    static std::vector<std::pair<std::string_view, std::string_view>> assignments(std::string_view text)
    {
        constexpr std::string_view blanks = " \t\r\n";
        const auto skip = [&](std::string_view passed) {
            text.remove_prefix(std::min(text.find_first_not_of(passed), text.size()));
        };
        const auto take = [&] { // a list in brackets, or a word
            const auto closing = text.starts_with('[') ? text.find(']') : std::string_view::npos;
            const auto end = closing != std::string_view::npos ? closing + 1 : text.find_first_of(" \t\r\n,=");
            const std::string_view taken = text.substr(0, end);
            text.remove_prefix(taken.size());
            return taken;
        };
        std::vector<std::pair<std::string_view, std::string_view>> pairs;
        for (skip(" \t\r\n,"); !text.empty(); skip(" \t\r\n,")) {
            const std::string_view first = take();
            skip(blanks);
            if (!text.starts_with('=')) {
                pairs.emplace_back(std::string_view(), first);
                continue;
            }
            text.remove_prefix(1);
            skip(blanks);
            pairs.emplace_back(first, take());
        }
        return pairs;
    }

    Status locations(std::string_view text, ZoneHeader& header) const
    {
        std::size_t place = 0;
        for (const auto& [list, word] : assignments(text)) {
            const std::string location = tecplotUpper(word);
            if (location != "CELLCENTERED" && location != "NODAL")
                return bad(Message::say("%1 has a VARLOCATION '%2' that is not understood.", zoneName(header.zone),
                                        printable(text)));
            const bool perElement = location == "CELLCENTERED";
            if (!list.empty())
                for (const std::size_t variable : variablesIn(list))
                    header.zone.perElement[variable] = perElement;
            else if (place < header.zone.perElement.size())
                header.zone.perElement[place++] = perElement;
        }
        return {};
    }

    static void types(std::string_view text, ZoneHeader& header)
    {
        std::size_t variable = 0;
        TecplotTokens words(text);
        for (auto word = words.next(); word && variable < header.isDouble.size(); word = words.next())
            header.isDouble[variable++] = tecplotUpper(word->text) == "DOUBLE";
    }

    Status shared(std::string_view text, ZoneHeader& header) const
    {
        for (const auto& [list, word] : assignments(text)) {
            const auto from = list.empty() ? std::optional(file_.zones.size()) : parseNumber<std::size_t>(word);
            if (!from || *from < 1 || *from > file_.zones.size())
                return bad(Message::say("%1 shares variables with zone '%2', which does not come before it. The file "
                                        "is damaged or cut short.",
                                        zoneName(header.zone), printable(word)));
            for (const std::size_t variable : variablesIn(list.empty() ? word : list))
                header.sharedFrom[variable] = *from - 1;
        }
        return {};
    }

    Status strandAndTime(ZoneHeader& header) const
    {
        const auto wrong = [&](const auto& entry) {
            return bad(Message::say("%1 has '%2'. It is damaged or cut short.", zoneName(header.zone),
                                    entry->first + " = " + printable(entry->second)));
        };
        if (const auto entry = header.words.find("STRANDID"); entry != header.words.end()) {
            const auto strand = parseNumber<std::int64_t>(entry->second);
            if (!strand)
                return wrong(entry);
            header.zone.strand = *strand;
        }
        if (const auto entry = header.words.find("SOLUTIONTIME"); entry != header.words.end())
            if (!parse(entry->second, header.zone.time) || !std::isfinite(header.zone.time))
                return wrong(entry);
        return {};
    }

    Result<std::uint64_t> number(const ZoneHeader& header, const char* key, const char* otherKey,
                                 std::uint64_t ifMissing) const
    {
        const auto entry = header.words.contains(key) ? header.words.find(key) : header.words.find(otherKey);
        if (entry == header.words.end())
            return ifMissing;
        constexpr std::uint64_t most = 1'000'000'000'000;
        const auto value = parseNumber<std::uint64_t>(entry->second);
        if (!value || *value < 1 || *value > most)
            return bad(Message::say("%1 has '%2'. It is damaged or cut short.", zoneName(header.zone),
                                    entry->first + " = " + printable(entry->second)));
        return *value;
    }

    Status shape(ZoneHeader& header) const
    {
        const auto word = [&](const char* key) {
            const auto entry = header.words.find(key);
            return entry == header.words.end() ? std::string() : entry->second;
        };
        std::string type = word("ZONETYPE");
        const std::string format = word("F").empty() ? word("DATAPACKING") : word("F");
        if (type.empty() && format.starts_with("FE"))
            type = "FE" + (word("ET").empty() ? std::string("QUADRILATERAL") : word("ET"));
        if (type.empty() || type == "ORDERED")
            return orderedShape(header);
        using enum TecplotElement;
        constexpr std::array<std::pair<std::string_view, TecplotElement>, 6> kinds = {
            {{"FELINESEG", Line},
             {"FETRIANGLE", Triangle},
             {"FEQUADRILATERAL", Quadrilateral},
             {"FETETRAHEDRON", Tetrahedron},
             {"FEBRICK", Brick},
             {"FEPOINT", Point}}};
        const auto kind = std::ranges::find(kinds, type, &std::pair<std::string_view, TecplotElement>::first);
        if (kind == kinds.end())
            return bad(Message::say(
                "%1 is of the type '%2', which is not read. Divide its elements into bricks or tetrahedra.",
                zoneName(header.zone), printable(type)));
        header.zone.element = kind->second;
        const auto nodes = number(header, "N", "NODES", 0);
        const auto elements = number(header, "E", "ELEMENTS", 0);
        if (!nodes || !elements)
            return nodes ? elements.error() : nodes.error();
        if (*nodes == 0 || *elements == 0)
            return bad(Message::say(
                "%1 does not state how many nodes (N) and elements (E) it has. It is damaged or cut short.",
                zoneName(header.zone)));
        header.zone.nodes = *nodes;
        header.zone.elements = *elements;
        return {};
    }

    Status orderedShape(ZoneHeader& header) const
    {
        constexpr std::uint64_t most = 1U << 31U;
        std::uint64_t nodes = 1;
        std::uint64_t cells = 1;
        const char* const keys[] = {"I", "J", "K"};
        const char* const otherKeys[] = {"IMAX", "JMAX", "KMAX"};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto size = number(header, keys[axis], otherKeys[axis], axis == 0 ? 0 : 1);
            if (!size)
                return size.error();
            if (*size < 1 || *size >= most || nodes > (std::uint64_t(1) << 62U) / *size)
                return bad(
                    Message::say("%1 does not state how many points it has (I, J, K). It is damaged or cut short.",
                                 zoneName(header.zone)));
            header.zone.size[axis] = static_cast<std::uint32_t>(*size);
            nodes *= *size;
            cells *= std::max<std::uint64_t>(1, *size - 1);
        }
        header.zone.nodes = nodes;
        header.zone.elements = cells;
        return {};
    }

    /// The next number, a repetition as "12*0.5" unrolled.
    bool nextValue(double& value)
    {
        if (repeated_ == 0) {
            std::string_view word = tokens_.nextNumber();
            if (word.empty())
                return false;
            keepLength(word);
            repeated_ = 1;
            if (const auto star = word.find('*'); star != std::string_view::npos) {
                const auto times = parseNumber<std::uint64_t>(word.substr(0, star));
                if (!times || *times == 0)
                    return false;
                repeated_ = *times;
                word.remove_prefix(star + 1);
            }
            if (!parse(word, repeatedValue_))
                return false;
        }
        --repeated_;
        value = repeatedValue_;
        return true;
    }

    static bool parse(std::string_view word, double& value)
    {
        if (word.starts_with('+'))
            word.remove_prefix(1);
        auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc() && end == word.data() + word.size())
            return true;
        if (error == std::errc::result_out_of_range) { // of subnormal numbers, too
            value =
                word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos ? 0 : HUGE_VAL;
            return true;
        }
        std::string fortran(word); // 1.5D+03
        std::ranges::replace(fortran, 'D', 'E');
        std::ranges::replace(fortran, 'd', 'e');
        const auto again = parseNumber<double>(fortran);
        value = again.value_or(0);
        return again.has_value();
    }

    /// Numbers all as long as one another, their signs left out, show of the last one whether it is whole.
    void keepLength(std::string_view word)
    {
        const std::size_t length = word.size() - (word.starts_with('-') || word.starts_with('+') ? 1 : 0);
        shortest_ = std::min(shortest_, length);
        longest_ = std::max(longest_, length);
    }

    /// `what` is how many there should be: "8 points".
    Error missing(const ZoneHeader& header, const Message& what) const
    {
        return bad(
            tokens_.atEnd()
                ? Message::say("%1 ends before the last of its %2. It is cut short: copy the file again.",
                               zoneName(header.zone), what)
                : Message::say(
                      "%1 has something other than a number among its %2. Its sizes are wrong, or it is damaged.",
                      zoneName(header.zone), what));
    }

    Status whole(const ZoneHeader& header) const
    {
        constexpr std::size_t formatted = 8; // as by "%12.5e"; short ones are alike by chance
        if (!tokens_.atEnd() || (shortest_ == longest_ && longest_ >= formatted))
            return {};
        return bad(Message::say("%1 ends directly after its last number, or within it. If the file is complete, add an "
                                "end of line; otherwise copy the file again.",
                                zoneName(header.zone)));
    }

    static bool hasConnectivity(const TecplotZone& zone) { return cornersOf(zone.element) > 1; }

    static std::uint64_t countOf(const TecplotZone& zone, std::size_t variable)
    {
        return zone.perElement[variable] ? zone.elements : zone.nodes;
    }

    Status zoneValues(ZoneHeader& header)
    {
        TecplotZone& zone = header.zone;
        std::vector<std::size_t> own;
        for (std::size_t i = 0; i < zone.values.size(); ++i)
            if (header.sharedFrom[i] != noVariable) {
                const TecplotZone& other = file_.zones[header.sharedFrom[i]];
                zone.perElement[i] = other.perElement[i];
                zone.values[i] = other.values[i];
                if (zone.values[i] && zone.values[i]->size() != countOf(zone, i))
                    return bad(Message::say("%1 shares values with a zone of another size. The file is damaged.",
                                            zoneName(zone)));
            } else if (!header.passive[i]) {
                own.push_back(i);
            }
        const auto format =
            header.words.contains("DATAPACKING") ? header.words.find("DATAPACKING") : header.words.find("F");
        const std::string packing = format == header.words.end() ? "POINT" : format->second;
        if (packing != "POINT" && packing != "FEPOINT" && packing != "BLOCK" && packing != "FEBLOCK")
            return bad(Message::say("%1 has the unknown packing '%2'.", zoneName(zone), printable(packing)));
        shortest_ = ~std::size_t(0);
        longest_ = 0;
        repeated_ = 0;
        std::vector<std::shared_ptr<TecplotValues>> values;
        for (const std::size_t i : own) {
            values.push_back(std::make_shared<TecplotValues>());
            // A header may ask for more than the file has: room for what comes is taken as it comes.
            const auto room = static_cast<std::size_t>(std::min<std::uint64_t>(countOf(zone, i), textBytes_));
            header.isDouble[i] ? values.back()->doubles.reserve(room) : values.back()->singles.reserve(room);
        }
        const auto take = [&](std::size_t place) {
            double value = 0;
            if (!nextValue(value))
                return false;
            if (header.isDouble[own[place]])
                values[place]->doubles.push_back(value);
            else
                values[place]->singles.push_back(static_cast<float>(value));
            return true;
        };
        if (packing.ends_with("POINT")) {
            if (std::ranges::any_of(own, [&](std::size_t i) { return zone.perElement[i]; }))
                return bad(Message::say("%1 has values of elements, which must be packed by blocks. It is damaged.",
                                        zoneName(zone)));
            for (std::uint64_t node = 0; node < zone.nodes; ++node)
                for (std::size_t place = 0; place < own.size(); ++place)
                    if (!take(place))
                        return missing(header, Message::say("%1 points", zone.nodes));
        } else {
            for (std::size_t place = 0; place < own.size(); ++place)
                for (std::uint64_t i = countOf(zone, own[place]); i > 0; --i)
                    if (!take(place))
                        return missing(header, Message::say("%1 values of '%2'", countOf(zone, own[place]),
                                                            printable(file_.variables[own[place]])));
        }
        if (repeated_ > 0)
            return bad(Message::say("%1 has more numbers than it should. Its sizes are wrong, or it is damaged.",
                                    zoneName(zone)));
        if (!hasConnectivity(zone))
            if (const Status ends = whole(header); !ends)
                return ends;
        for (std::size_t place = 0; place < own.size(); ++place)
            zone.values[own[place]] = values[place];
        for (const std::size_t axis : file_.axes)
            if (!zone.values[axis] || zone.perElement[axis])
                return bad(
                    Message::say("%1 has no positions of its points. Write it with all coordinates.", zoneName(zone)));
        return {};
    }

    Status connectivity(ZoneHeader& header)
    {
        TecplotZone& zone = header.zone;
        if (const auto from = header.words.find("CONNECTIVITYSHAREZONE"); from != header.words.end()) {
            const auto number = parseNumber<std::size_t>(from->second);
            if (!number || *number < 1 || *number > file_.zones.size() ||
                file_.zones[*number - 1].element != zone.element ||
                file_.zones[*number - 1].elements != zone.elements || file_.zones[*number - 1].nodes != zone.nodes)
                return bad(Message::say("%1 shares its elements with a zone that does not fit. The file is damaged.",
                                        zoneName(zone)));
            zone.connectivity = file_.zones[*number - 1].connectivity;
            return whole(header);
        }
        const std::size_t corners = cornersOf(zone.element);
        auto nodes = std::make_shared<std::vector<std::int64_t>>();
        nodes->reserve(static_cast<std::size_t>(std::min<std::uint64_t>(zone.elements * corners, textBytes_)));
        shortest_ = ~std::size_t(0);
        longest_ = 0;
        for (std::uint64_t i = 0; i < zone.elements * corners; ++i) {
            const std::string_view word = tokens_.nextNumber();
            const auto node = parseNumber<std::uint64_t>(word);
            if (!node || *node < 1 || *node > zone.nodes)
                return word.empty()
                           ? missing(header, Message::say("%1 elements", zone.elements))
                           : bad(Message::say("%1 has an element with node '%2', and it has %3. It is damaged.",
                                              zoneName(zone), printable(word), zone.nodes));
            keepLength(word);
            nodes->push_back(static_cast<std::int64_t>(*node - 1));
        }
        zone.connectivity = std::move(nodes);
        return whole(header);
    }

    TecplotTokens tokens_;
    std::size_t textBytes_;
    TecplotFile file_;
    std::uint64_t repeated_ = 0; ///< how often the last value is still to be taken
    double repeatedValue_ = 0;
    std::size_t shortest_ = 0, longest_ = 0;
};

} // namespace

std::size_t cornersOf(TecplotElement element) noexcept
{
    constexpr std::array<std::size_t, 7> corners = {0, 1, 2, 3, 4, 4, 8};
    return corners[static_cast<std::size_t>(element)];
}

Result<TecplotFile> readTecplot(std::string_view text)
{
    return TecplotReading(text).run();
}

std::vector<double> tecplotTimes(const TecplotFile& file)
{
    std::vector<double> times;
    for (const TecplotZone& zone : file.zones)
        if (zone.strand > 0)
            times.push_back(zone.time);
    std::ranges::sort(times);
    const auto repeated = std::ranges::unique(times);
    times.erase(repeated.begin(), repeated.end());
    return times;
}

bool isThereAt(const TecplotZone& zone, double time)
{
    return zone.strand <= 0 || zone.time == time;
}

bool looksLikeTecplot(std::string_view firstBytes)
{
    TecplotTokens tokens(firstBytes);
    const auto first = tokens.next();
    if (!first || first->quoted)
        return false;
    const std::string_view behind =
        firstBytes.substr(static_cast<std::size_t>(first->text.data() + first->text.size() - firstBytes.data()));
    const auto sign = behind.find_first_not_of(" \t");
    if (sign == std::string_view::npos || behind[sign] != '=')
        return false;
    const std::string word = tecplotUpper(first->text);
    return word == "VARIABLES" ||
           ((word == "TITLE" || word == "FILETYPE") && tecplotUpper(firstBytes).find("VARIABLES") != std::string::npos);
}

} // namespace tetra
