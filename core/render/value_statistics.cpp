// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/render.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace tetra {

namespace {

/// How much lies in each of some equal parts of a range, of intervals of constant density. O(1) for each interval:
/// whole parts are counted by where the density begins and ends, the two at the ends directly.
class IntervalSums {
public:
    explicit IntervalSums(std::size_t parts) : amounts_(parts), steps_(parts + 1) {}

    /// `amount`, spread over [begin, end] in parts from 0; what lies outside is left out.
    void add(double begin, double end, double amount)
    {
        const auto count = static_cast<double>(amounts_.size());
        if (!(end >= 0 && begin <= count))
            return;
        if (end - begin < leastExtent) {
            amounts_[partOf(begin)] += amount;
            return;
        }
        const double density = amount / (end - begin);
        begin = std::max(begin, 0.0);
        end = std::min(end, count);
        const std::size_t first = partOf(begin), last = partOf(end);
        if (first == last) {
            amounts_[first] += density * (end - begin);
            return;
        }
        amounts_[first] += density * (static_cast<double>(first + 1) - begin);
        amounts_[last] += density * (end - static_cast<double>(last));
        steps_[first + 1] += density;
        steps_[last] -= density;
    }

    std::vector<double> amounts() const
    {
        std::vector<double> result = amounts_;
        double density = 0;
        for (std::size_t part = 0; part < result.size(); ++part)
            result[part] = std::max(0.0, result[part] + (density += steps_[part]));
        return result;
    }

private:
    static constexpr double leastExtent = 1e-6;

    std::size_t partOf(double place) const
    {
        return std::min(static_cast<std::size_t>(std::max(place, 0.0)), amounts_.size() - 1);
    }

    std::vector<double> amounts_;
    std::vector<double> steps_;
};

constexpr std::size_t parts = 256; ///< of the range of values
/// The spectrum is looked at as the mean of so many parts to either side: it is to follow the data, not the cells.
constexpr std::size_t smoothing = 4;
/// Where nearly all of the gradient lies in less than this part of the range, that part is looked at closer.
constexpr double closer = 0.25;
constexpr double leftOut = 0.0005; ///< of the gradient, at either end
constexpr int mostTurns = 8;
/// Values between which the spectrum keeps this part of its maximum serve as well as each other.
constexpr double asGood = 0.97;
/// How much the mean gradient counts against the total one: with less, noise that fills the domain is taken for a
/// surface; with more, what is small and steep is taken in place of what is large.
constexpr double steepness = 0.75;
/// A flat cell of four points near a plane may have a gradient beyond all bounds across that plane, where the field has
/// none: nothing steeper than this is believed, in slopes of the cell's steepest edge.
constexpr double steepest = 2;
/// A surface smaller than this part of the square of the mesh's diagonal is hardly seen in a picture of all of it, and
/// counts less in proportion: grids of flows have their steepest values in a thin layer around a small body.
constexpr double seenArea = 0.1;

struct GradedCell {
    double low;
    double high;
    double volume;
    double gradient; ///< its length
};

GradedCell gradedCell(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& corners)
{
    const auto place = [&](std::size_t corner) { return mesh.positions[corners[corner]]; };
    const auto value = [&](std::size_t corner) { return static_cast<double>(mesh.values[corners[corner]]); };
    Eigen::Matrix3d edges;
    Eigen::Vector3d rises;
    for (std::size_t corner = 1; corner < 4; ++corner) {
        edges.row(static_cast<Eigen::Index>(corner) - 1) = place(corner) - place(0);
        rises[static_cast<Eigen::Index>(corner) - 1] = value(corner) - value(0);
    }
    double slope = 0;
    for (std::size_t first = 0; first < 4; ++first)
        for (std::size_t second = first + 1; second < 4; ++second)
            if (const double length = (place(second) - place(first)).norm(); length > 0)
                slope = std::max(slope, std::abs(value(second) - value(first)) / length);
    const auto [low, high] = std::minmax({value(0), value(1), value(2), value(3)});
    const double volume = std::abs(edges.determinant()) / 6;
    const double gradient = volume > 0 ? (edges.inverse() * rises).norm() : 0;
    return {low, high, volume, std::min(gradient, steepest * slope)};
}

std::vector<GradedCell> gradedCells(const TetrahedralMesh& mesh)
{
    std::vector<GradedCell> cells;
    cells.reserve(mesh.tetrahedra.size());
    for (const auto& corners : mesh.tetrahedra)
        if (const GradedCell cell = gradedCell(mesh, corners);
            std::isfinite(cell.volume * cell.gradient * cell.gradient) && cell.volume * cell.gradient > 0)
            cells.push_back(cell);
    return cells;
}

/// The area of the isosurfaces and the gradient on them, summed up over each part of a range of values. By the coarea
/// formula the area between two values is the integral of the gradient's length over the volume between them; within a
/// cell all values count alike.
struct ContourSpectrum {
    double least;
    double largest;
    std::vector<double> areas;
    std::vector<double> gradients;

    double valueAt(double part) const { return std::lerp(least, largest, part / static_cast<double>(parts)); }
};

ContourSpectrum contourSpectrum(const std::vector<GradedCell>& cells, double least, double largest)
{
    IntervalSums areas(parts), gradients(parts);
    const double partsPerUnit = static_cast<double>(parts) / (largest - least);
    for (const GradedCell& cell : cells) {
        const double begin = (cell.low - least) * partsPerUnit;
        const double end = (cell.high - least) * partsPerUnit;
        areas.add(begin, end, cell.volume * cell.gradient);
        gradients.add(begin, end, cell.volume * cell.gradient * cell.gradient);
    }
    return {least, largest, areas.amounts(), gradients.amounts()};
}

/// The spectrum of the range that holds nearly all of the gradient: a few values far away from all others would leave
/// too few parts to these.
ContourSpectrum closeSpectrum(const std::vector<GradedCell>& cells, double least, double largest)
{
    ContourSpectrum spectrum = contourSpectrum(cells, least, largest);
    for (int turn = 0; turn < mostTurns; ++turn) {
        const double total = std::accumulate(spectrum.gradients.begin(), spectrum.gradients.end(), 0.0);
        double sum = 0;
        std::size_t first = 0, end = 0;
        for (std::size_t part = 0; part < parts; ++part) {
            sum += spectrum.gradients[part];
            first += sum <= leftOut * total;
            end = sum - spectrum.gradients[part] < (1 - leftOut) * total ? part + 1 : end;
        }
        if (!(total > 0) || end <= first || static_cast<double>(end - first) > closer * static_cast<double>(parts))
            return spectrum;
        spectrum = contourSpectrum(cells, spectrum.valueAt(static_cast<double>(first)),
                                   spectrum.valueAt(static_cast<double>(end)));
    }
    return spectrum;
}

double meanAround(const std::vector<double>& amounts, std::size_t part)
{
    const std::size_t first = part > smoothing ? part - smoothing : 0;
    const std::size_t end = std::min(part + smoothing + 1, amounts.size());
    double sum = 0;
    for (std::size_t i = first; i < end; ++i)
        sum += amounts[i];
    return sum / static_cast<double>(end - first);
}

/// The total gradient of each part times a power of its mean gradient, less where the surface is smaller than `seen`.
std::vector<double> surfaceScores(const ContourSpectrum& spectrum, double seen)
{
    const double width = (spectrum.largest - spectrum.least) / static_cast<double>(parts);
    std::vector<double> scores(parts);
    for (std::size_t part = 0; part < parts; ++part) {
        const double area = meanAround(spectrum.areas, part);
        const double gradient = meanAround(spectrum.gradients, part);
        if (area > 0)
            scores[part] = gradient * std::pow(gradient / area, steepness) * std::min(1.0, area / width / seen);
    }
    return scores;
}

/// The square of the diagonal of the box around the mesh.
double squaredDiagonal(const TetrahedralMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : mesh.positions)
        if (place.allFinite())
            box.extend(place);
    return box.isEmpty() ? 0 : box.diagonal().squaredNorm();
}

} // namespace

std::optional<double> surfaceValue(const TetrahedralMesh& mesh, double least, double largest)
{
    if (!(least < largest) || !std::isfinite(largest - least))
        return std::nullopt;
    const std::vector<GradedCell> cells = gradedCells(mesh);
    const ContourSpectrum spectrum = closeSpectrum(cells, least, largest);
    const std::vector<double> scores = surfaceScores(spectrum, seenArea * squaredDiagonal(mesh));
    const auto best = std::ranges::max_element(scores);
    if (!(*best > 0))
        return std::nullopt;
    const auto serves = [&](double score) { return score >= asGood * *best; };
    const auto after = std::find_if_not(best, scores.end(), serves);
    const auto before = std::find_if_not(std::make_reverse_iterator(best), scores.rend(), serves).base();
    return spectrum.valueAt(static_cast<double>((before - scores.begin()) + (after - scores.begin())) / 2);
}

namespace {

double cellVolume(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& cell)
{
    const Eigen::Vector3d& origin = mesh.positions[cell[0]];
    const auto edge = [&](std::size_t corner) { return Eigen::Vector3d(mesh.positions[cell[corner]] - origin); };
    return std::abs(edge(1).dot(edge(2).cross(edge(3))));
}

} // namespace

ValueHistogram volumeHistogram(const TetrahedralMesh& mesh, double least, double largest, int parts)
{
    ValueHistogram histogram{least, largest, {}};
    const double extent = largest - least;
    if (!(extent > 0) || !std::isfinite(extent) || parts <= 0)
        return histogram;
    IntervalSums sums(static_cast<std::size_t>(parts));
    for (const auto& cell : mesh.tetrahedra) {
        const auto value = [&](std::size_t corner) { return double(mesh.values[cell[corner]]); };
        const auto [low, high] = std::minmax({value(0), value(1), value(2), value(3)});
        const double volume = cellVolume(mesh, cell);
        const double sum = value(0) + value(1) + value(2) + value(3);
        if (std::isfinite(sum) && std::isfinite(volume))
            sums.add((low - least) / extent * parts, (high - least) / extent * parts, volume);
    }
    const std::vector<double> amounts = sums.amounts();
    const double total = std::reduce(amounts.begin(), amounts.end());
    if (!(total > 0))
        return histogram;
    for (const double amount : amounts)
        histogram.counts.push_back(static_cast<std::uint64_t>(std::llround(amount / total * 0x1p32)));
    return histogram;
}

} // namespace tetra
