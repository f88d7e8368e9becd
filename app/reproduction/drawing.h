// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// Places of a drawing, or of a chart's data.
using Points = std::vector<Eigen::Vector2d>;

/// The border of a rectangle from its upper left corner around and back to it.
Points rectangle(double left, double top, double width, double height);

/// What things are drawn in: the parts of a chart, and from Series on eight colours that people of any colour vision
/// can tell apart (after Okabe and Ito).
enum class ChartInk { Ground, Text, Soft, Grid, Axis, Series };
/// The colour of a number, over and over.
ChartInk seriesInk(std::size_t number);

enum class Letters { Plain, Soft, Strong, Title };
enum class Anchor { Left, Middle, Right }; ///< which end of a text is at its place

/// Lines, areas, dots and texts in the plane, y pointing down. It is written as SVG, which can be read on a light and
/// on a dark ground and by a screen reader, or painted on white. Texts are UTF-8.
class Drawing {
public:
    /// The description says in words what it shows.
    Drawing(const Eigen::Vector2d& size, std::string title, std::string description);

    void text(const Eigen::Vector2d& place, const std::string& words, Letters letters = Letters::Plain,
              Anchor anchor = Anchor::Left);
    void line(const Points& points, ChartInk ink, double width = 1);
    void area(const Points& border, ChartInk ink);
    void dots(const Points& places, ChartInk ink, double diameter);

    std::string svg() const;
    /// Errors (OutOfResource): memory is short, or the system has no font.
    Result<Picture> picture(double pixelsPerUnit) const;

private:
    enum class Kind { Text, Line, Area, Dots };
    struct Shape {
        Kind kind;
        Points points;
        ChartInk ink;
        double width = 1; ///< of lines and dots
        std::string words = {};
        Letters letters = Letters::Plain;
        Anchor anchor = Anchor::Left;
    };
    static std::string svgOf(const Shape& shape);

    Eigen::Vector2d size_;
    std::string title_;
    std::string description_;
    std::vector<Shape> shapes_;
};

/// Writes FILE.png, of two pixels a unit, and FILE.svg, each whole or not at all; gives their names.
Result<std::vector<std::filesystem::path>> writeDrawing(const std::filesystem::path& file, const Drawing& drawing);

} // namespace tetra
