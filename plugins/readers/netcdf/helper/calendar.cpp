// SPDX-License-Identifier: GPL-3.0-or-later
// A date is a count of days by its calendar and the seconds of its day; a time moves the seconds on.
#include "plugins/readers/netcdf/helper/calendar.h"

#include <tan/base.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tetra {
namespace {

using Days = std::int64_t;

constexpr Days secondsOfDay = 86400;

struct Date {
    std::int64_t year = 0, month = 1, day = 1;
};

enum class Calendar : std::uint8_t { Mixed, Gregorian, Julian, NoLeap, AllLeap, Days360 };

constexpr Days floorDivided(Days number, Days by)
{
    return number / by - (number % by < 0 ? 1 : 0);
}

std::string inSmallLetters(std::string_view text)
{
    std::string small(text);
    std::ranges::transform(small, small.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return small;
}

std::optional<Calendar> calendarNamed(std::string_view name)
{
    const std::string small = inSmallLetters(name);
    if (small.empty() || small == "standard" || small == "gregorian")
        return Calendar::Mixed;
    if (small == "proleptic_gregorian")
        return Calendar::Gregorian;
    if (small == "julian")
        return Calendar::Julian;
    if (small == "noleap" || small == "365_day")
        return Calendar::NoLeap;
    if (small == "all_leap" || small == "366_day")
        return Calendar::AllLeap;
    return small == "360_day" ? std::optional(Calendar::Days360) : std::nullopt;
}

/// The days before the first of March of a year that begins with it, and those before a month of it: leap days are
/// last. The months from March on have 31, 30, 31, 30, 31 days, and again.
Days daysBeforeMonth(std::int64_t monthFromMarch)
{
    return (153 * monthFromMarch + 2) / 5;
}

Days leapDays(std::int64_t year, bool isJulian)
{
    return floorDivided(year, 4) - (isJulian ? 2 : floorDivided(year, 100) - floorDivided(year, 400));
}

/// Counted so that a day has one number in both calendars.
Days daysOf(const Date& date, bool isJulian)
{
    const bool isEarly = date.month < 3;
    const std::int64_t year = date.year - (isEarly ? 1 : 0), month = date.month + (isEarly ? 9 : -3);
    return 365 * year + leapDays(year, isJulian) + daysBeforeMonth(month) + date.day - 1;
}

Date dateOfDays(Days days, bool isJulian)
{
    std::int64_t year = floorDivided(days, 366);
    while (daysOf({year + 1, 3, 1}, isJulian) <= days)
        ++year;
    const Days ofYear = days - daysOf({year, 3, 1}, isJulian);
    const std::int64_t month = (5 * ofYear + 2) / 153;
    return {year + (month > 9 ? 1 : 0), month + (month > 9 ? -9 : 3), ofYear - daysBeforeMonth(month) + 1};
}

/// Of calendars whose years are alike: the days before each month.
std::array<Days, 13> monthsOf(Calendar calendar)
{
    std::array<Days, 13> before{};
    constexpr std::array<Days, 12> usual = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    for (std::size_t month = 0; month < 12; ++month)
        before[month + 1] = before[month] + (calendar == Calendar::Days360                 ? 30
                                             : calendar == Calendar::AllLeap && month == 1 ? 29
                                                                                           : usual[month]);
    return before;
}

/// The first day of the mixed calendar that is Gregorian.
Days reform()
{
    return daysOf({1582, 10, 15}, false);
}

bool isAlikeEachYear(Calendar calendar)
{
    return calendar == Calendar::NoLeap || calendar == Calendar::AllLeap || calendar == Calendar::Days360;
}

Days daysOf(const Date& date, Calendar calendar)
{
    if (isAlikeEachYear(calendar)) {
        const auto before = monthsOf(calendar);
        return date.year * before.back() + before[static_cast<std::size_t>(date.month - 1)] + date.day - 1;
    }
    const Days gregorian = daysOf(date, false);
    const bool isJulian = calendar == Calendar::Julian || (calendar == Calendar::Mixed && gregorian < reform());
    return isJulian ? daysOf(date, true) : gregorian;
}

Date dateOfDays(Days days, Calendar calendar)
{
    if (isAlikeEachYear(calendar)) {
        const auto before = monthsOf(calendar);
        const std::int64_t year = floorDivided(days, before.back());
        const Days ofYear = days - year * before.back();
        const auto next = std::ranges::upper_bound(before, ofYear);
        const auto month = next - before.begin();
        return {year, month, ofYear - before[static_cast<std::size_t>(month - 1)] + 1};
    }
    return dateOfDays(days, calendar == Calendar::Julian || (calendar == Calendar::Mixed && days < reform()));
}

std::optional<double> secondsOf(std::string_view unit)
{
    constexpr std::array<std::pair<std::string_view, double>, 19> units = {{{"d", 86400},
                                                                            {"day", 86400},
                                                                            {"days", 86400},
                                                                            {"h", 3600},
                                                                            {"hr", 3600},
                                                                            {"hrs", 3600},
                                                                            {"hour", 3600},
                                                                            {"hours", 3600},
                                                                            {"min", 60},
                                                                            {"mins", 60},
                                                                            {"minute", 60},
                                                                            {"minutes", 60},
                                                                            {"s", 1},
                                                                            {"sec", 1},
                                                                            {"secs", 1},
                                                                            {"second", 1},
                                                                            {"seconds", 1},
                                                                            {"week", 604800},
                                                                            {"weeks", 604800}}};
    const auto found = std::ranges::find(units, unit, &std::pair<std::string_view, double>::first);
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

/// What dates are read from, piece by piece.
struct Text {
    std::string_view rest;

    bool take(char wanted)
    {
        const bool isThere = rest.starts_with(wanted);
        rest.remove_prefix(isThere ? 1 : 0);
        return isThere;
    }
    void skipBlanks() { rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size())); }
    /// A whole number of few digits.
    std::optional<std::int64_t> number()
    {
        constexpr std::size_t mostDigits = 4;
        const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
        const auto found =
            digits > mostDigits ? std::nullopt : parseNumber<std::int64_t>(std::string(rest.substr(0, digits)));
        rest.remove_prefix(digits);
        return found;
    }
};

struct Moment {
    Date date;
    double seconds = 0; ///< of the day
};

/// "12:30:00.0", or less; nothing if it is something else.
std::optional<double> clockOf(Text& text)
{
    double seconds = 0, unit = 3600;
    for (int part = 0; part < 3; ++part, unit /= 60) {
        const auto number = text.number();
        if (!number || *number > (part == 0 ? 24 : 60))
            return std::nullopt;
        seconds += static_cast<double>(*number) * unit;
        if (part < 2 && !text.take(':'))
            break;
    }
    if (text.take('.'))
        text.rest.remove_prefix(std::min(text.rest.find_first_not_of("0123456789"), text.rest.size()));
    return seconds;
}

/// "1900-01-01", "1900-1-1 12:30:00.0", "1900-01-01T00:00:00Z".
std::optional<Moment> momentOf(Text text)
{
    Moment moment;
    const auto year = text.number();
    const bool hasMonth = text.take('-');
    const auto month = hasMonth ? text.number() : std::nullopt;
    const bool hasDay = month && text.take('-');
    const auto day = hasDay ? text.number() : std::nullopt;
    if (!year || !month || !day || *month < 1 || *month > 12 || *day < 1 || *day > 31)
        return std::nullopt;
    moment.date = {*year, *month, *day};
    if (!text.take('T'))
        text.skipBlanks();
    if (!text.rest.empty() && text.rest.front() >= '0' && text.rest.front() <= '9') {
        const auto clock = clockOf(text);
        if (!clock)
            return std::nullopt;
        moment.seconds = *clock;
    }
    text.skipBlanks();
    const std::string zone = inSmallLetters(text.rest);
    const bool isUtc = zone.empty() || zone == "z" || zone == "utc" || zone == "gmt" || zone == "+00:00" ||
                       zone == "0:00" || zone == "+0:00" || zone == "00:00";
    return isUtc ? std::optional(moment) : std::nullopt;
}

std::string padded(std::int64_t number, std::size_t digits)
{
    const std::string text = std::to_string(number);
    return std::string(digits - std::min(digits, text.size()), '0') + text;
}

std::string textOf(const Date& date, Days seconds)
{
    const std::string text = padded(date.year, 4) + "-" + padded(date.month, 2) + "-" + padded(date.day, 2) + " " +
                             padded(seconds / 3600, 2) + ":" + padded(seconds / 60 % 60, 2);
    return seconds % 60 == 0 ? text : text + ":" + padded(seconds % 60, 2);
}

} // namespace

std::optional<std::string> dateOf(double time, std::string_view units, std::string_view calendarName)
{
    constexpr std::string_view since = " since ";
    constexpr double mostSeconds = 1e12; // more than the years up to 9999 have
    constexpr std::int64_t lastYear = 9999;
    const std::string words = inSmallLetters(units);
    const std::size_t at = words.find(since);
    const auto calendar = calendarNamed(calendarName);
    if (at == std::string::npos || !calendar)
        return std::nullopt;
    const auto unit = secondsOf(std::string_view(words).substr(0, at));
    Text text{units.substr(at + since.size())};
    text.skipBlanks();
    const auto start = momentOf(text);
    const bool hasNoYear0 = *calendar == Calendar::Mixed || *calendar == Calendar::Julian;
    if (!unit || !start || !(std::abs(time * *unit) < mostSeconds) || (hasNoYear0 && start->date.year == 0))
        return std::nullopt;
    const Days seconds = std::llround(time * *unit + start->seconds);
    const Days days = daysOf(start->date, *calendar) + floorDivided(seconds, secondsOfDay);
    const Date date = dateOfDays(days, *calendar);
    if (date.year < (hasNoYear0 ? 1 : 0) || date.year > lastYear)
        return std::nullopt;
    return textOf(date, seconds - floorDivided(seconds, secondsOfDay) * secondsOfDay);
}

} // namespace tetra
