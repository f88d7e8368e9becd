// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/foam_points.h"

#include <tan/base.h>

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace tetra {
namespace {

constexpr std::string_view foamBlanks = " \t\r\n";

/// The whole file, unpacked; empty if it is longer than `most` bytes, or not to be read.
std::string unpackedFoam(const std::filesystem::path& path, std::uint64_t most)
{
    constexpr std::size_t piece = 1 << 20;
    std::string text;
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    for (int got = 1; file && got > 0;) {
        const std::size_t before = text.size();
        if (before > most)
            return {};
        text.resize(before + piece);
        got = gzread(file.get(), text.data() + before, piece);
        text.resize(before + static_cast<std::size_t>(std::max(0, got)));
        if (got < 0)
            return {};
    }
    return text;
}

/// Passes over blanks and comments.
void skipFoamBlanks(std::string_view& text)
{
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(foamBlanks), text.size()));
        const bool isLine = text.starts_with("//"), isBlock = text.starts_with("/*");
        if (!isLine && !isBlock)
            return;
        const auto end = text.find(isLine ? "\n" : "*/", 2);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + (isLine ? 1 : 2));
    }
}

/// The header, "FoamFile { ... }", which is taken away; nothing without one.
std::optional<std::string_view> takeFoamHeader(std::string_view& text)
{
    skipFoamBlanks(text);
    const auto begin = text.find('{'), end = text.find('}');
    if (!text.starts_with("FoamFile") || begin == std::string_view::npos || end == std::string_view::npos ||
        end < begin)
        return std::nullopt;
    const std::string_view header = text.substr(begin + 1, end - begin - 1);
    text.remove_prefix(end + 1);
    return header;
}

/// The next number behind blanks, comments and brackets; false without one.
template <class Number> bool takeFoamNumber(std::string_view& text, Number& number)
{
    skipFoamBlanks(text);
    while (text.starts_with('(') || text.starts_with(')')) {
        text.remove_prefix(1);
        skipFoamBlanks(text);
    }
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc())
        return false;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return true;
}

bool isBinaryFoam(std::string_view header)
{
    const auto format = header.find("format");
    if (format == std::string_view::npos)
        return false;
    std::string_view value = header.substr(format + std::string_view("format").size());
    skipFoamBlanks(value);
    return value.starts_with("binary");
}

} // namespace

std::optional<std::vector<double>> readFoamPoints(const std::filesystem::path& path, std::uint64_t most)
{
    constexpr std::uint64_t bytesOfPoint = 200, bytesBefore = 1 << 16;
    if (most > (std::uint64_t(1) << 40))
        return std::nullopt;
    const std::string content = unpackedFoam(path, most * bytesOfPoint + bytesBefore);
    std::string_view text = content;
    const auto header = takeFoamHeader(text);
    std::uint64_t points = 0;
    if (!header || !takeFoamNumber(text, points) || points > most)
        return std::nullopt;
    skipFoamBlanks(text);
    if (!text.starts_with('('))
        return std::nullopt;
    std::vector<double> places(3 * points);
    if (!isBinaryFoam(*header)) {
        for (double& number : places)
            if (!takeFoamNumber(text, number))
                return std::nullopt;
        return places;
    }
    text.remove_prefix(1);
    // Of single precision, or of the other byte order, is what VTK takes as it stands, or refuses.
    if (header->find("scalar=32") != std::string_view::npos || header->find("MSB") != std::string_view::npos ||
        text.size() < places.size() * sizeof(double))
        return std::nullopt;
    std::memcpy(places.data(), text.data(), places.size() * sizeof(double));
    return places;
}

} // namespace tetra
