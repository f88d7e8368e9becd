// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/column_names.h"

#include "plugins/readers/points/delimited_text.h"
#include "plugins/readers/points/small_letters.h"
#include "plugins/readers/points/units.h"

#include <algorithm>
#include <vector>

namespace tetra {

namespace {

/// Words that stand beside a coordinate and say nothing else.
constexpr std::string_view fillers[] = {
    "coordinate", "coordinates", "coord",  "coords",  "coor",    "location", "loc",    "position",
    "positions",  "pos",         "point",  "points",  "node",    "nodes",    "vertex", "vertices",
    "centroid",   "centroids",   "center", "centre",  "centers", "centres",  "cell",   "element",
    "axis",       "utm",         "wgs",    "84",      "world",   "global",   "local",  "gps",
    "decimal",    "dd",          "site",   "station", "sample",  "hole"};
constexpr std::string_view numberedOnes[] = {"coordinate", "coordinates", "coord", "coords", "coor",   "location",
                                             "position",   "positions",   "pos",   "points", "centers"};
constexpr std::string_view eastings[] = {"easting", "eastings", "east", "rechtswert"};
constexpr std::string_view northings[] = {"northing", "northings", "north", "hochwert"};
constexpr std::string_view longitudes[] = {"longitude", "lon", "long", "lng", "decimallongitude"};
constexpr std::string_view latitudes[] = {"latitude", "lat", "decimallatitude"};
constexpr std::string_view heights[] = {"z",     "elevation", "elev",   "height",  "altitude", "alt",  "depth",
                                        "level", "lev",       "depths", "heights", "rl",       "hoehe"};
/// Words by which a longer name is certainly one of these: "minus depth", "station longitude".
constexpr std::string_view certainOnes[] = {"easting", "northing", "longitude", "latitude"};
constexpr std::string_view certainHeights[] = {"elevation", "height", "altitude", "depth"};
constexpr std::string_view times[] = {"time",      "timestep",  "date", "datetime",
                                      "timestamp", "timevalue", "step", "iteration"};
/// Of what a vector's x, y and z are no places.
constexpr std::string_view vectors[] = {
    "velocity",     "vel",           "v",       "u",           "speed",    "force",        "forces",
    "displacement", "displacements", "disp",    "deformation", "gradient", "grad",         "stress",
    "strain",       "normal",        "normals", "momentum",    "mom",      "acceleration", "acc",
    "moment",       "vorticity",     "flux",    "component",   "field",    "magnetic",     "rotation",
    "shear",        "wall",          "heat",    "current"};
constexpr std::string_view countedThings[] = {"node",   "point",    "cell",    "element", "elem",   "block",
                                              "row",    "object",   "sample",  "hole",    "part",   "process",
                                              "global", "original", "feature", "record",  "vertex", "particle",
                                              "atom",   "station",  "global",  "zone",    "region", "body"};
constexpr std::string_view countingWords[] = {"id",  "ids", "number", "numbers",  "index",
                                              "idx", "no",  "nr",     "partition"};
constexpr std::string_view counters[] = {
    "",        "#",           "id",       "ids",        "index",     "idx",           "number", "num",      "no",
    "nr",      "counter",     "row",      "rows",       "node",      "nodes",         "point",  "cell",     "element",
    "elem",    "block",       "record",   "serial",     "obs",       "nodenumber",    "nodeid", "nodeno",   "pointid",
    "pointno", "pointnumber", "cellid",   "cellnumber", "elementid", "elementnumber", "elemid", "objectid", "fid",
    "oid",     "rownames",    "partition"};

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isCapital(char c)
{
    return c >= 'A' && c <= 'Z';
}

/// "vtkOriginalPointIds" is four words, "coord_x1" three.
std::vector<std::string> wordsOf(std::string_view name)
{
    std::vector<std::string> words;
    for (std::size_t at = 0; at < name.size();) {
        std::size_t end = at;
        if (isLetter(name[at])) {
            while (end < name.size() && isLetter(name[end]) &&
                   (end == at || !isCapital(name[end]) || isCapital(name[end - 1])))
                ++end;
        } else {
            while (end < name.size() && isDigit(name[end]))
                ++end;
        }
        if (end > at)
            words.emplace_back(name.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    return words;
}

/// A name for the search of places: its words in small letters, without a unit behind them ("x_mm").
struct PlaceWords {
    std::vector<std::string> all;
    std::vector<std::string> core; ///< without fillers, "xcoord" as "x"
};

/// "x" of "xcoord" and "coordsx"; the word itself of others.
std::string withoutGluedFiller(const std::string& word)
{
    for (const char axis : {'x', 'y', 'z'})
        if ((word.front() == axis && isAmong(std::string_view(word).substr(1), fillers)) ||
            (word.back() == axis && isAmong(std::string_view(word).substr(0, word.size() - 1), fillers)))
            return {axis};
    return word;
}

/// How many words of a name at its end are a unit of a place: "x_mm", "longitude_deg". Units in brackets are gone.
std::size_t unitWords(const std::vector<std::string>& words)
{
    const std::string_view last = words.empty() ? std::string_view() : words.back();
    return words.size() > 1 && (isLengthUnit(last) || isAngleUnit(last)) ? 1 : 0;
}

PlaceWords placeWordsOf(const ColumnName& name)
{
    PlaceWords words;
    std::vector<std::string> found = wordsOf(name.quantity);
    found.resize(found.size() - unitWords(found));
    for (const std::string& word : found) {
        words.all.push_back(inSmallLetters(word));
        if (const std::string plain = withoutGluedFiller(words.all.back()); !isAmong(plain, fillers))
            words.core.push_back(plain);
    }
    return words;
}

/// How well a name fits: 0 not at all, 1 with other words, 2 alone.
int fit(const PlaceWords& words, std::span<const std::string_view> wanted, std::span<const std::string_view> certain)
{
    if (words.core.size() == 1 && isAmong(words.core[0], wanted))
        return 2;
    return std::ranges::any_of(
        words.core, [&](const std::string& word) { return isAmong(word, wanted) && isAmong(word, certain); });
}

int heightFit(const PlaceWords& words)
{
    return fit(words, heights, certainHeights);
}

int cartesianFit(const PlaceWords& words, int axis)
{
    return words.core.size() == 1 && words.core[0] == std::string(1, "xyz"[axis]) ? 2 : 0;
}

int numberedFit(const PlaceWords& words, int number)
{
    const bool isNumbered =
        std::ranges::any_of(words.all, [](const std::string& w) { return isAmong(w, numberedOnes); });
    return isNumbered && words.core.size() == 1 && words.core[0] == std::to_string(number) ? 2 : 0;
}

/// The first column that fits best, and whether others fit as well.
template <class Fit> std::optional<std::size_t> best(std::span<const PlaceWords> names, Fit&& fitOf, bool& several)
{
    std::optional<std::size_t> found;
    int most = 0, equal = 0;
    for (std::size_t column = 0; column < names.size(); ++column) {
        const int fits = fitOf(names[column]);
        if (fits > most) {
            found = column;
            most = fits;
            equal = 1;
        } else if (fits > 0 && fits == most) {
            ++equal;
        }
    }
    several = several || equal > 1;
    return found;
}

template <class X, class Y, class Z>
std::optional<NamedPlaces> placesBy(std::span<const PlaceWords> names, X&& x, Y&& y, Z&& z)
{
    NamedPlaces places;
    const auto first = best(names, x, places.guessed), second = best(names, y, places.guessed),
               third = best(names, z, places.guessed);
    if (!first || !second || !third || first == second || second == third || first == third)
        return {};
    places.columns = {*first, *second, *third};
    return places;
}

/// The axis of a column that is called by x, y or z with a word before or behind it, and that word.
struct Weak {
    int axis;
    std::string rest;
};

std::optional<Weak> weakFit(const PlaceWords& words)
{
    const auto axisOf = [](const std::string& word) {
        return word.size() == 1 ? static_cast<int>(std::string_view("xyz").find(word[0])) : -1;
    };
    if (words.core.size() == 1 && words.core[0].size() == 2) {
        const std::string& word = words.core[0];
        for (const std::size_t at : {std::size_t(0), std::size_t(1)})
            if (const int axis = axisOf(word.substr(at, 1)); axis >= 0 && word[1 - at] == 'c')
                return Weak{axis, at == 0 ? "_c" : "c_"};
        return {};
    }
    if (words.core.size() < 2 ||
        std::ranges::any_of(words.core, [](const std::string& word) { return isAmong(word, vectors); }))
        return {};
    const int first = axisOf(words.core.front()), last = axisOf(words.core.back());
    std::string rest;
    for (const std::string& word : words.core)
        rest += (&word == &words.core.front() && first >= 0) || (&word == &words.core.back() && first < 0) ? "_ "
                                                                                                           : word + " ";
    return first >= 0 || last >= 0 ? std::optional(Weak{first >= 0 ? first : last, rest}) : std::nullopt;
}

std::optional<NamedPlaces> weakPlaces(std::span<const PlaceWords> names)
{
    constexpr int most = 100; // of names that look like that: tables of thousands of columns are no points
    int tried = 0;
    for (const PlaceWords& name : names) {
        const auto wanted = tried < most ? weakFit(name) : std::nullopt;
        if (!wanted)
            continue;
        ++tried;
        const auto fits = [&](int axis) {
            return [axis, rest = wanted->rest](const PlaceWords& words) {
                const auto found = weakFit(words);
                return int(found && found->axis == axis && found->rest == rest);
            };
        };
        if (auto places = placesBy(names, fits(0), fits(1), fits(2))) {
            places->guessed = true;
            return places;
        }
    }
    return {};
}

bool isCounter(const std::vector<std::string>& words, std::string_view whole)
{
    if (words.empty()) // "", "#"
        return whole.empty() || whole == "#";
    if (words.size() == 1)
        return isAmong(words[0], counters);
    const bool counts = isAmong(words.back(), countingWords);
    const bool ofThings =
        std::ranges::any_of(words, [](const std::string& word) { return isAmong(word, countedThings); });
    return (counts && ofThings) || words[0] == "unnamed" || (words[0] == "row" && words[1] == "names");
}

bool isDerivedFromPlaces(const std::vector<std::string>& words)
{
    const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
    return (words.size() == 2 && has("points") && has("magnitude")) || (has("arc") && has("length")) ||
           (has("structured") && has("coordinates"));
}

} // namespace

ColumnName parseColumnName(std::string_view name)
{
    name = withoutBlanks(name);
    ColumnName parsed{std::string(name), std::string(name), {}};
    const auto cutOff = [&](std::size_t begin, std::string_view unit) {
        const std::string_view quantity = withoutBlanks(name.substr(0, begin));
        unit = withoutBlanks(unit);
        const bool isNone = unit.empty() || unit == "-";
        if (quantity.empty() || !(isNone || isUnit(unit)))
            return false;
        parsed.quantity = quantity;
        parsed.unit = isNone ? std::string_view() : unit;
        return true;
    };
    for (const char* brackets : {"()", "[]"}) {
        const std::size_t open = name.rfind(brackets[0]);
        if (!name.ends_with(brackets[1]) || open == std::string_view::npos)
            continue;
        const std::string_view inside = name.substr(open + 1, name.size() - open - 2);
        if (open == 0 && !withoutBlanks(inside).empty()) {
            parsed = parseColumnName(inside);
            parsed.whole = name;
            return parsed;
        }
        if (cutOff(open, inside))
            return parsed;
    }
    for (const std::string_view mark : {" / ", " in "})
        if (const std::size_t at = name.rfind(mark); at != std::string_view::npos)
            if (cutOff(at, name.substr(at + mark.size())))
                return parsed;
    if (const auto words = wordsOf(name); unitWords(words) == 1 && kindOf(parsed) == ColumnKind::Coordinate)
        parsed.unit = words.back();
    else if (unitWords(words) == 1 && heightFit(placeWordsOf(parsed)) > 0)
        parsed.unit = words.back();
    return parsed;
}

ColumnKind kindOf(const ColumnName& name)
{
    const PlaceWords words = placeWordsOf(name);
    if (isCounter(words.all, name.quantity))
        return ColumnKind::Counter;
    for (int axis = 0; axis < 3; ++axis)
        if (cartesianFit(words, axis) > 0 || numberedFit(words, axis) > 0)
            return ColumnKind::Coordinate;
    if (fit(words, eastings, certainOnes) + fit(words, northings, certainOnes) + fit(words, longitudes, certainOnes) +
            fit(words, latitudes, certainOnes) >
        0)
        return ColumnKind::Coordinate;
    if (isDerivedFromPlaces(words.all))
        return ColumnKind::Coordinate;
    const bool isTime = !words.all.empty() && isAmong(words.all[0], times);
    return isTime || heightFit(words) == 2 ? ColumnKind::HeightOrTime : ColumnKind::Quantity;
}

bool isDepth(const ColumnName& name)
{
    const std::vector<std::string> words = placeWordsOf(name).all;
    const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
    return (has("depth") || has("depths")) && !has("minus") && !has("negative");
}

std::optional<NamedPlaces> findPlaces(std::span<const ColumnName> names)
{
    std::vector<PlaceWords> words;
    for (const ColumnName& name : names)
        words.push_back(placeWordsOf(name));
    const auto cartesian = [](int axis) { return [axis](const PlaceWords& name) { return cartesianFit(name, axis); }; };
    const auto numbered = [](int n) { return [n](const PlaceWords& name) { return numberedFit(name, n); }; };
    const auto called = [](std::span<const std::string_view> wanted) {
        return [wanted](const PlaceWords& name) { return fit(name, wanted, certainOnes); };
    };
    if (auto places = placesBy(words, cartesian(0), cartesian(1), cartesian(2)))
        return places;
    for (const int first : {0, 1})
        if (auto places = placesBy(words, numbered(first), numbered(first + 1), numbered(first + 2)))
            return places;
    if (auto places = placesBy(words, cartesian(0), cartesian(1), heightFit))
        return places;
    if (auto places = placesBy(words, called(eastings), called(northings), heightFit))
        return places;
    if (auto places = placesBy(words, called(longitudes), called(latitudes), heightFit))
        return places;
    return weakPlaces(words);
}

} // namespace tetra
