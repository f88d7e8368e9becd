// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/plugin_texts.h"

#include <QCoreApplication>

#include <array>

namespace tetra {
namespace {

constexpr std::array texts{
    // clang-format off
    QT_TRANSLATE_NOOP("Plugin", "Delaunay refinement"),
    QT_TRANSLATE_NOOP("Plugin", "Starts from the corners and inserts the point of the largest error until the error is small enough."),
    QT_TRANSLATE_NOOP("Plugin", "Error"),
    QT_TRANSLATE_NOOP("Plugin", "The error at which to stop; 0 keeps everything, so that any accuracy can be looked at later."),
    QT_TRANSLATE_NOOP("Plugin", "% of the value range"),
    QT_TRANSLATE_NOOP("Plugin", "Tables of points"),
    QT_TRANSLATE_NOOP("Plugin", "Reads scattered points with a value each from CSV, TSV and blank-separated text."),
    QT_TRANSLATE_NOOP("Plugin", "CSV writer"),
    QT_TRANSLATE_NOOP("Plugin", "Writes the points of any dataset as a table: x, y, z and value."),
    QT_TRANSLATE_NOOP("Plugin", "Table of points (*.csv *.tsv *.xyz *.pts *.txt *.asc)"),
    QT_TRANSLATE_NOOP("Plugin", "Table of points (*.csv)"),
    QT_TRANSLATE_NOOP("Plugin", "Positions"),
    QT_TRANSLATE_NOOP("Plugin", "Tables of points: the columns of x, y and z, by name or number, as in lon,lat,depth or 1,2,3; 'automatic' takes those called x, y and z, else the first three."),
    QT_TRANSLATE_NOOP("Plugin", "Values"),
    QT_TRANSLATE_NOOP("Plugin", "The values to take, by name or number; 'automatic' takes the first there are."),
    QT_TRANSLATE_NOOP("Plugin", "Skip incomplete rows"),
    QT_TRANSLATE_NOOP("Plugin", "Tables of points: leave out rows that lack a number, instead of refusing the file."),
    QT_TRANSLATE_NOOP("Plugin", "Scattered points: refinement fills their convex hull."),
    QT_TRANSLATE_NOOP("Plugin", "Finding the convex hull"),
    QT_TRANSLATE_NOOP("Plugin", "Weights"),
    QT_TRANSLATE_NOOP("Plugin", "Where accuracy matters: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach or value:q,reach, several separated by ';'. Errors there count in full, falling linearly to a tenth (or to ',floor' at the end) at the distance 'reach'; the largest weight holds. Examples: 'point:16,16,8,10', 'value:120,15,0.05'."),
    QT_TRANSLATE_NOOP("Plugin", "A regular lattice: refinement keeps the exact domain and needs the least time."),
    QT_TRANSLATE_NOOP("Plugin", "Block"),
    QT_TRANSLATE_NOOP("Plugin", "The cells along an edge of the blocks that are refined independently, in memory for a few of them; 'none' refines the dataset as a whole; 'automatic' takes blocks where the dataset is large."),
    QT_TRANSLATE_NOOP("Plugin", "cells"),
    QT_TRANSLATE_NOOP("Plugin", "Warping"),
    QT_TRANSLATE_NOOP("Plugin", "For curvilinear data: the warping at which to stop. Its ratio to the error says how much the shape counts against the values, 1 : 1 if either is 0; 0 keeps everything."),
    QT_TRANSLATE_NOOP("Plugin", "% of the diagonal"),
    QT_TRANSLATE_NOOP("Plugin", "Selection"),
    QT_TRANSLATE_NOOP("Plugin", "For curvilinear data: 'normalised' takes the point that is farthest off in error or warping and keeps cells from turning over; 'paper' compares the two in the units of the data and does not look at cells that turn over, as the paper did, to compare with it."),
    QT_TRANSLATE_NOOP("Plugin", "normalised"),
    QT_TRANSLATE_NOOP("Plugin", "paper"),
    QT_TRANSLATE_NOOP("Plugin", "A curvilinear grid: refinement in computational space bounds both error and warping."),
    QT_TRANSLATE_NOOP("Plugin", "Distributing the points"),
    QT_TRANSLATE_NOOP("Plugin", "Refining"),
    QT_TRANSLATE_NOOP("Plugin", "Isosurfaces"),
    QT_TRANSLATE_NOOP("Plugin", "Shows the surfaces on which the field has the chosen values, each with a colour and an opacity."),
    QT_TRANSLATE_NOOP("Plugin", "Isovalues"),
    QT_TRANSLATE_NOOP("Plugin", "The values whose surfaces are shown, each with its colour and opacity."),
    QT_TRANSLATE_NOOP("Plugin", "Outline"),
    QT_TRANSLATE_NOOP("Plugin", "Shows the edges of the box that the data fill."),
    QT_TRANSLATE_NOOP("Plugin", "Volumes on regular lattices"),
    QT_TRANSLATE_NOOP("Plugin", "Reads NRRD files with attached or detached data, raw, gzip or text, and raw files that are described."),
    QT_TRANSLATE_NOOP("Plugin", "NRRD writer"),
    QT_TRANSLATE_NOOP("Plugin", "Writes volumes on regular lattices as NRRD files, raw or gzip."),
    QT_TRANSLATE_NOOP("Plugin", "NRRD volume (*.nrrd *.nhdr)"),
    QT_TRANSLATE_NOOP("Plugin", "Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)"),
    QT_TRANSLATE_NOOP("Plugin", "Reading"),
    QT_TRANSLATE_NOOP("Plugin", "Size"),
    QT_TRANSLATE_NOOP("Plugin", "Raw files: the number of points along x (which runs fastest), y and z, as in 256x256x128."),
    QT_TRANSLATE_NOOP("Plugin", "points"),
    QT_TRANSLATE_NOOP("Plugin", "Type"),
    QT_TRANSLATE_NOOP("Plugin", "Raw files: the type of a sample."),
    QT_TRANSLATE_NOOP("Plugin", "Byte order"),
    QT_TRANSLATE_NOOP("Plugin", "Raw files: little (PC) or big endian, for types of more than one byte."),
    QT_TRANSLATE_NOOP("Plugin", "little"),
    QT_TRANSLATE_NOOP("Plugin", "big"),
    QT_TRANSLATE_NOOP("Plugin", "Skip"),
    QT_TRANSLATE_NOOP("Plugin", "Raw files: the length of a header before the samples."),
    QT_TRANSLATE_NOOP("Plugin", "bytes"),
    QT_TRANSLATE_NOOP("Plugin", "Spacing"),
    QT_TRANSLATE_NOOP("Plugin", "Raw files: the distance of neighbouring points along x, y and z, as in 1x1x2.5."),
    QT_TRANSLATE_NOOP("Plugin", "Origin"),
    QT_TRANSLATE_NOOP("Plugin", "Raw files: the position of the first point, as in 0,0,0."),
    QT_TRANSLATE_NOOP("Plugin", "uint8"),
    QT_TRANSLATE_NOOP("Plugin", "int8"),
    QT_TRANSLATE_NOOP("Plugin", "uint16"),
    QT_TRANSLATE_NOOP("Plugin", "int16"),
    QT_TRANSLATE_NOOP("Plugin", "uint32"),
    QT_TRANSLATE_NOOP("Plugin", "int32"),
    QT_TRANSLATE_NOOP("Plugin", "float"),
    QT_TRANSLATE_NOOP("Plugin", "double"),
    QT_TRANSLATE_NOOP("Plugin", "PLOT3D grids"),
    QT_TRANSLATE_NOOP("Plugin", "Reads curvilinear grids with a scalar of their solution from binary PLOT3D files of any byte order and precision."),
    QT_TRANSLATE_NOOP("Plugin", "PLOT3D writer"),
    QT_TRANSLATE_NOOP("Plugin", "Writes datasets on grids as a PLOT3D grid file and a solution file beside it."),
    QT_TRANSLATE_NOOP("Plugin", "PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)"),
    QT_TRANSLATE_NOOP("Plugin", "Values"),
    QT_TRANSLATE_NOOP("Plugin", "Which scalar of the solution: automatic takes the density, or if that is the same everywhere the first that varies."),
    QT_TRANSLATE_NOOP("Plugin", "Solution file"),
    QT_TRANSLATE_NOOP("Plugin", "The PLOT3D solution of the grid; without it the one beside it with a fitting name."),
    QT_TRANSLATE_NOOP("Plugin", "Grid"),
    QT_TRANSLATE_NOOP("Plugin", "Which grid of a PLOT3D file that holds several, from 1; 0 takes the only one."),
    QT_TRANSLATE_NOOP("Plugin", "automatic"),
    QT_TRANSLATE_NOOP("Plugin", "density"),
    QT_TRANSLATE_NOOP("Plugin", "pressure"),
    QT_TRANSLATE_NOOP("Plugin", "energy"),
    QT_TRANSLATE_NOOP("Plugin", "velocity_magnitude"),
    QT_TRANSLATE_NOOP("Plugin", "momentum_magnitude"),
    QT_TRANSLATE_NOOP("Plugin", "momentum_x"),
    QT_TRANSLATE_NOOP("Plugin", "momentum_y"),
    QT_TRANSLATE_NOOP("Plugin", "momentum_z"),
    QT_TRANSLATE_NOOP("Plugin", "temperature"),
    QT_TRANSLATE_NOOP("Plugin", "mach"),
    QT_TRANSLATE_NOOP("Plugin", "builder"),
    QT_TRANSLATE_NOOP("Plugin", "renderer"),
    QT_TRANSLATE_NOOP("Plugin", "reader"),
    QT_TRANSLATE_NOOP("Plugin", "writer"),
    QT_TRANSLATE_NOOP("Plugin", "editor"),
    QT_TRANSLATE_NOOP("Plugin", "found"),
    QT_TRANSLATE_NOOP("Plugin", "loaded"),
    QT_TRANSLATE_NOOP("Plugin", "disabled"),
    QT_TRANSLATE_NOOP("Plugin", "refused"),
    // clang-format on
};

} // namespace

std::span<const char* const> translatedPluginTexts()
{
    return texts;
}

QString pluginText(const std::string& text)
{
    return text.empty() ? QString() : QCoreApplication::translate("Plugin", text.c_str());
}

} // namespace tetra
