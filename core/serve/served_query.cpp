// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/served_query.h"

#include "core/data/value_scale.h"
#include "core/history/query_words.h"
#include "core/remote/percent_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>
#include <type_traits>

namespace tetra {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t longestQuestion = 7'000; ///< of the 8,192 bytes that a server takes for an address

struct KnownWord {
    std::string_view name;
    bool isRepeatable = false;
};
constexpr std::array knownWords = {KnownWord{"error"},        KnownWord{"warping"},       KnownWord{"focus", true},
                                   KnownWord{"focus-error"},  KnownWord{"falloff"},       KnownWord{"focus-warping"},
                                   KnownWord{"field"},        KnownWord{"warping-field"}, KnownWord{"budget"},
                                   KnownWord{"method"},       KnownWord{"range"},         KnownWord{"births"},
                                   KnownWord{"deaths"},       KnownWord{"window"},        KnownWord{"border"},
                                   KnownWord{"values", true}, KnownWord{"empty"}};

// From a query to words.

class Writer {
public:
    void add(std::string_view name, std::string_view value)
    {
        std::string withoutBlanks(value); // between words they say nothing
        std::erase(withoutBlanks, ' ');
        words_.emplace_back(name, std::move(withoutBlanks));
    }
    void add(std::string_view name, std::initializer_list<double> numbers)
    {
        std::string list;
        for (const double number : numbers)
            list += (list.empty() ? "" : ",") + formatNumber(number);
        add(name, list);
    }
    std::vector<QueryWords::Word> take() { return std::move(words_); }

private:
    std::vector<QueryWords::Word> words_;
};

/// A field that is one number; limits are at most 100.
std::optional<double> numberOf(const ErrorField& field)
{
    if (!field.isConstant())
        return {};
    return std::min(field.bounds().minimum, anyError);
}

Status addRange(const LifeRange& range, bool warps, Writer& words)
{
    words.add("range", {range.one.error, range.other.error});
    const bool asError = range.one.warping == range.one.error && range.other.warping == range.other.error;
    if (warps && !asError && range.one.warping != range.other.warping)
        return Error{ErrorKind::WrongUsage, Message::say("A server cannot extract a range of accuracies whose two ends "
                                                         "have different warpings. Give both the same.")};
    if (warps && !asError)
        words.add("warping", {std::min(range.one.warping, anyWarping)});
    for (const auto& [name, lives] : {std::pair{"births", range.births}, std::pair{"deaths", range.deaths}})
        if (lives.minimum != -infinite || lives.maximum != infinite)
            words.add(name, {std::max(lives.minimum, 0.0), std::max(lives.maximum, 0.0)});
    return {};
}

/// How accurate one mesh is. What says nothing is left out: it would be taken for a contradiction.
void addFields(const MeshQuery& query, bool warps, Writer& words)
{
    const auto error = numberOf(query.error), warping = numberOf(query.warping);
    if (error)
        words.add("error", {*error});
    else
        words.add("field", toText(query.error));
    const bool isApart = warps && query.warping != query.error;
    if (isApart && warping)
        words.add("warping", {*warping});
    else if (isApart)
        words.add("warping-field", toText(query.warping));
    if (query.budget)
        words.add("budget", std::to_string(*query.budget));
    if (query.method != VariableMethod::Automatic && (!error || (isApart && warping)))
        words.add("method", wordOf(methodWords, query.method));
}

// From words to a query.

template <class T> std::string text(T number)
{
    if constexpr (std::is_integral_v<T>)
        return std::to_string(number);
    else
        return formatNumber(number);
}

/// Exactly `count` finite numbers, separated by commas.
template <std::size_t count> std::optional<std::array<double, count>> finiteNumbers(std::string_view list)
{
    std::array<double, count> numbers{};
    for (std::size_t index = 0; index < count; ++index) {
        const bool isLast = index + 1 == count;
        const auto end = isLast ? list.size() : list.find(',');
        if (end == std::string_view::npos)
            return {};
        const auto number = parseNumber<double>(list.substr(0, end));
        if (!number || !std::isfinite(*number))
            return {};
        numbers[index] = *number;
        list.remove_prefix(isLast ? end : end + 1);
    }
    return numbers;
}

std::optional<Box> boxOfText(std::string_view list)
{
    const auto n = finiteNumbers<6>(list);
    if (!n)
        return {};
    const Eigen::Vector3d one((*n)[0], (*n)[1], (*n)[2]), other((*n)[3], (*n)[4], (*n)[5]);
    return Box{one.cwiseMin(other), one.cwiseMax(other)};
}

std::optional<Region> regionOf(std::string_view text)
{
    constexpr std::string_view boxName = "box:", sphereName = "sphere:";
    if (text.starts_with(boxName)) {
        const auto box = boxOfText(text.substr(boxName.size()));
        return box ? std::optional<Region>(*box) : std::nullopt;
    }
    if (text.starts_with(sphereName))
        if (const auto n = finiteNumbers<4>(text.substr(sphereName.size())); n && (*n)[3] > 0)
            return Region(Sphere{{(*n)[0], (*n)[1], (*n)[2]}, (*n)[3]});
    return {};
}

/// Inside of all the regions, each with its own fall-off; where several reach, the smaller number counts.
ErrorField fieldIn(const std::vector<Region>& regions, double inner, double outer, double falloff)
{
    ErrorField field = SpaceRamp{regions.front(), inner, outer, falloff};
    for (std::size_t number = 1; number < regions.size(); ++number)
        field = smallerOf(field, SpaceRamp{regions[number], inner, outer, falloff});
    return field;
}

struct Fields {
    ErrorField error;
    ErrorField warping;
};

class Reader {
public:
    Reader(const QueryWords& words, std::string_view prefix, const PresentView& present)
        : words_(words), prefix_(prefix), present_(present)
    {
    }

    Result<MeshQuery> query() const
    {
        MeshQuery query;
        const auto range = this->range();
        if (!range)
            return range.error();
        query.range = *range;
        const auto fields = query.range ? Result<Fields>(Fields{0, anyWarping}) : this->fields();
        if (!fields)
            return fields.error();
        query.error = fields->error;
        query.warping = fields->warping;
        const auto budget = bounded<std::int64_t>("budget", words_.value("budget"), 1, 1, mostBudget, "a whole number");
        if (!budget)
            return budget.error();
        if (words_.has("budget"))
            query.budget = static_cast<std::uint64_t>(*budget);
        auto values = this->values();
        if (!values)
            return values.error();
        query.values = *std::move(values);
        const auto window = this->window();
        if (!window)
            return window.error();
        query.window = *window;
        const auto method = chosen<VariableMethod>("method", methodWords);
        if (!method)
            return method.error();
        query.method = *method;
        if (words_.has("method") && query.error.isConstant() && query.warping == query.error)
            return wrong(named("method") + " is for meshes whose accuracy varies: specify where with " +
                         named("focus") + " or " + named("field") + ", or give " + named("error") + " and " +
                         named("warping") + " limits of their own.");
        return query;
    }

private:
    static constexpr std::int64_t mostBudget = 1'000'000'000'000;
    static constexpr double defaultError = 1;

    static Error wrong(std::string text) { return {ErrorKind::WrongUsage, std::move(text)}; }
    std::string named(std::string_view word) const { return "'" + std::string(prefix_) + std::string(word) + "'"; }
    Error doesNotFit(std::string_view word, std::string_view given, std::string_view form) const
    {
        return wrong("'" + std::string(given) + "' does not fit " + named(word) + ": it takes " + std::string(form) +
                     ".");
    }
    Error doesNotGo(std::string_view reason, std::string_view word) const
    {
        return wrong(std::string(reason) + ", so " + named(word) + " cannot be combined with it.");
    }

    template <class T> Result<T> bounded(std::string_view word, const std::optional<std::string>& given, T byDefault,
                                         T least, T most, std::string_view what) const
    {
        if (!given)
            return byDefault;
        const auto number = parseNumber<T>(*given);
        if (number && *number >= least && *number <= most) // a NaN is not
            return *number;
        return doesNotFit(word, *given, std::string(what) + " from " + text(least) + " to " + text(most));
    }
    /// A limit on error or warping, in %: anyError (which is anyWarping) for "none".
    Result<double> limit(std::string_view word, double byDefault) const
    {
        static_assert(anyError == anyWarping);
        const auto given = words_.value(word);
        return given == "none" ? anyError : bounded<double>(word, given, byDefault, 0, anyError, "'none' or a number");
    }
    template <class Choice, std::size_t count>
    Result<Choice> chosen(std::string_view word, const std::array<const char*, count>& choices) const
    {
        const auto given = words_.value(word);
        if (!given)
            return Choice();
        if (const auto choice = choiceOf<Choice>(choices, *given))
            return *choice;
        std::string names;
        for (const char* choice : choices)
            names += (names.empty() ? "" : ", ") + std::string(choice);
        return doesNotFit(word, *given, "one of " + names);
    }
    /// Two numbers, the smaller one first, each in the words that `read` takes.
    Result<ValueRange> orderedPair(std::string_view word, const std::string& given, double least, double most,
                                   std::optional<double> (*read)(std::string_view) = parseNumber<double>) const
    {
        const std::size_t comma = given.find(',');
        const auto one = read(std::string_view(given).substr(0, comma));
        const auto other = comma == std::string::npos ? std::nullopt : read(std::string_view(given).substr(comma + 1));
        if (!one || !other || !(*one >= least && *one <= *other && *other <= most))
            return doesNotFit(word, given, "two numbers, the smaller one first: LO,HI");
        return ValueRange{*one, *other};
    }

    /// `field`, which says all of the error.
    Result<Fields> writtenField() const
    {
        for (const char* word : {"error", "focus", "focus-error", "focus-warping", "falloff"})
            if (words_.has(word))
                return doesNotGo(named("field") + " sets the error allowed at each place", word);
        const auto error = parseErrorField(*words_.value("field"), present_);
        if (!error)
            return wrong(named("field") + ": " + error.error().text());
        const auto warping = limit("warping", anyWarping);
        if (!warping)
            return warping.error();
        return Fields{*error, words_.has("warping") ? ErrorField(*warping) : *error};
    }

    Result<Fields> withFocus(double error, double warping) const
    {
        if (!words_.has("focus")) {
            for (const char* word : {"focus-error", "focus-warping", "falloff"})
                if (words_.has(word))
                    return wrong(named(word) + " needs a focus: specify it with " + named("focus") + ".");
            return Fields{error, warping};
        }
        if (!words_.has("focus-error"))
            return wrong(named("focus") + " needs " + named("focus-error") + ", the largest error within the focus.");
        std::vector<Region> regions;
        for (const std::string& given : words_.values("focus")) {
            const auto region = regionOf(given);
            if (!region)
                return doesNotFit("focus", given,
                                  "box:x0,y0,z0,x1,y1,z1 or sphere:x,y,z,r, with numbers and a radius above 0");
            regions.push_back(*region);
        }
        const auto innerError = limit("focus-error", 0);
        if (!innerError)
            return innerError.error();
        // Unless it is asked for, a limit that holds everywhere is not relaxed in the focus.
        const auto innerWarping = limit("focus-warping", std::min(*innerError, warping));
        if (!innerWarping)
            return innerWarping.error();
        const auto falloff =
            bounded<double>("falloff", words_.value("falloff"), 0, 0, std::numeric_limits<double>::max(), "a number");
        if (!falloff)
            return falloff.error();
        for (const auto& [what, inner, outer] : {std::tuple{std::string("error"), *innerError, error},
                                                 std::tuple{std::string("warping"), *innerWarping, warping}})
            if (inner > outer)
                return wrong("The " + what + " in the focus, " + formatNumber(inner) + " %, is larger than the " +
                             formatNumber(outer) + " % elsewhere. Exchange " + named("focus-" + what) + " and " +
                             named(what) + ", or write what you mean with " + named("field") + ".");
        return Fields{fieldIn(regions, *innerError, error, *falloff),
                      *innerWarping < warping ? fieldIn(regions, *innerWarping, warping, *falloff)
                                              : ErrorField(warping)};
    }

    Result<Fields> errorAndWarping() const
    {
        if (words_.has("field"))
            return writtenField();
        // A budget alone asks for the best mesh that it allows.
        const bool isBudgetAlone = words_.has("budget") && !words_.has("error") && !words_.has("focus");
        const auto error = limit("error", isBudgetAlone ? 0 : defaultError);
        if (!error)
            return error.error();
        const auto warping = limit("warping", *error);
        if (!warping)
            return warping.error();
        return withFocus(*error, *warping);
    }

    Result<Fields> fields() const
    {
        auto fields = errorAndWarping();
        const auto given = words_.value("warping-field");
        if (!fields || !given)
            return fields;
        for (const char* word : {"warping", "focus-warping"})
            if (words_.has(word))
                return doesNotGo(named("warping-field") + " sets the warping allowed at each place", word);
        const auto warping = parseErrorField(*given, present_);
        if (!warping)
            return wrong(named("warping-field") + ": " + warping.error().text());
        fields->warping = *warping;
        return fields;
    }

    Status checkRangeStandsAlone() const
    {
        for (const char* word : {"error", "focus", "focus-error", "focus-warping", "falloff", "field", "warping-field",
                                 "budget", "method"})
            if (words_.has(word))
                return doesNotGo(named("range") + " requests tetrahedra of many accuracies", word);
        if (words_.value("border") == "clipped")
            return wrong("'" + std::string(prefix_) + (prefix_.empty() ? "border=" : "border ") +
                         "clipped' cannot be combined with " + named("range") +
                         ": a cut piece is not a tetrahedron of the model. Use intersecting or contained.");
        return {};
    }

    /// Two errors, in any order.
    Result<std::optional<LifeRange>> range() const
    {
        for (const char* word : {"births", "deaths"})
            if (words_.has(word) && !words_.has("range"))
                return wrong(named(word) + " selects from a range of accuracies: specify it with " + named("range") +
                             ".");
        const auto given = words_.value("range");
        if (!given)
            return std::optional<LifeRange>();
        if (const Status alone = checkRangeStandsAlone(); !alone)
            return alone.error();
        const auto errors = finiteNumbers<2>(*given);
        if (!errors || !std::ranges::all_of(*errors, [](double error) { return error >= 0 && error <= anyError; }))
            return doesNotFit("range", *given, "two errors in % from 0 to 100, such as 4,1");
        LifeRange range;
        for (std::size_t end = 0; end < 2; ++end) {
            const auto warping = limit("warping", (*errors)[end]);
            if (!warping)
                return warping.error();
            (end == 0 ? range.one : range.other) = {.error = (*errors)[end], .warping = *warping};
        }
        for (const auto& [word, lives] : {std::pair{"births", &range.births}, std::pair{"deaths", &range.deaths}})
            if (const auto text = words_.value(word)) {
                const auto ends = orderedPair(word, *text, 0, infinite);
                if (!ends)
                    return ends.error();
                *lives = *ends;
            }
        return std::optional(range);
    }

    Result<std::optional<Window>> window() const
    {
        const auto given = words_.value("window");
        if (!given && words_.has("border"))
            return wrong(named("border") + " needs a crop box: specify it with " + named("window") + ".");
        if (!given)
            return std::optional<Window>();
        const auto box = boxOfText(*given);
        if (!box)
            return doesNotFit("window", *given, "two opposite corners: x0,y0,z0,x1,y1,z1");
        const auto border = chosen<WindowBorder>("border", borderWords);
        if (!border)
            return border.error();
        return std::optional(Window{*box, *border});
    }

    Result<std::vector<ValueRange>> values() const
    {
        constexpr double most = std::numeric_limits<double>::max();
        std::vector<ValueRange> ranges;
        for (const std::string& given : words_.values("values")) {
            const auto ends = orderedPair("values", given, -most, most, parseFieldValue);
            if (!ends)
                return ends.error();
            ranges.push_back(*ends);
        }
        return ranges;
    }

    const QueryWords& words_;
    std::string_view prefix_;
    const PresentView& present_;
};

} // namespace

bool QueryWords::has(std::string_view name) const
{
    return std::ranges::find(words_, name, &Word::first) != words_.end();
}

std::optional<std::string> QueryWords::value(std::string_view name) const
{
    const auto found = std::ranges::find(words_, name, &Word::first);
    return found == words_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> QueryWords::values(std::string_view name) const
{
    std::vector<std::string> all;
    for (const auto& [word, value] : words_)
        if (word == name)
            all.push_back(value);
    return all;
}

Result<QueryWords> QueryWords::of(const MeshQuery& query, bool warps)
{
    Writer words;
    if (query.range) {
        if (const Status added = addRange(*query.range, warps, words); !added)
            return added.error();
    } else {
        addFields(query, warps, words);
    }
    for (const ValueRange& range : query.values)
        words.add("values", {range.minimum, range.maximum});
    if (query.window) {
        const Eigen::Vector3d &least = query.window->box.least, &largest = query.window->box.largest;
        words.add("window", {least.x(), least.y(), least.z(), largest.x(), largest.y(), largest.z()});
        words.add("border", wordOf(borderWords, query.window->border));
    }
    QueryWords written(words.take());
    if (const std::size_t size = written.toUrl().size(); size > longestQuestion)
        return Error{ErrorKind::WrongUsage,
                     Message::say("The error field is too long for a server request: %1 of at most %2 characters. Use "
                                  "fewer regions, isovalues or points of the transfer function.",
                                  size, longestQuestion)};
    return written;
}

Result<QueryWords> QueryWords::fromUrl(std::string_view text)
{
    QueryWords read;
    while (!text.empty()) {
        const std::size_t end = text.find('&');
        const auto word = percentDecoded(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (!word)
            return Error{ErrorKind::WrongUsage, "The query is not encoded correctly: '%' and two hexadecimal digits."};
        if (word->empty())
            continue;
        const std::size_t sign = word->find('=');
        const std::string name = word->substr(0, sign);
        const auto known = std::ranges::find(knownWords, name, &KnownWord::name);
        if (known == knownWords.end()) {
            std::string names;
            for (const KnownWord& one : knownWords)
                names += (names.empty() ? "" : ", ") + std::string(one.name);
            return Error{ErrorKind::WrongUsage,
                         "'" + printable(name) + "' is not a query parameter. Available: " + names + "."};
        }
        if (sign == std::string::npos)
            return Error{ErrorKind::WrongUsage, "'" + name + "' needs a value: " + name + "=..."};
        if (!known->isRepeatable && read.has(name))
            return Error{ErrorKind::WrongUsage, "'" + name + "' is given twice. Leave one of them out."};
        if (name == "empty" && word->substr(sign + 1) != "yes" && word->substr(sign + 1) != "no")
            return Error{ErrorKind::WrongUsage, "'empty' is 'yes' or 'no': whether a mesh without tetrahedra is an "
                                                "answer, or a refusal."};
        read.words_.emplace_back(name, word->substr(sign + 1));
    }
    return read;
}

std::string QueryWords::toUrl() const
{
    std::string text;
    for (const auto& [name, value] : words_)
        text += (text.empty() ? "" : "&") + name + "=" + percentEncoded(value);
    return text;
}

Result<MeshQuery> QueryWords::query(std::string_view prefix, const PresentView& present) const
{
    return Reader(*this, prefix, present).query();
}

} // namespace tetra
