// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/query/split_model.h"

#include "core/history/model_writer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace tetra {

namespace {

using Sites = std::array<std::uint32_t, 4>;
constexpr float unlimited = std::numeric_limits<float>::infinity();

struct Cell {
    Sites sites{};
    double error = 0;
    std::uint32_t worst = 0; ///< the point with that error
    bool alive = true;
};

class Splitting {
public:
    Splitting(const Dataset& dataset, HistorySink& sink) : dataset_(dataset), sink_(sink) {}

    void run()
    {
        start();
        const Cell* worst = worstCell();
        for (; worst->error > 0; worst = worstCell())
            split(worst->worst, static_cast<float>(worst->error));
        if (!sink_.finish(0))
            std::abort();
    }

private:
    Eigen::Vector3d place(std::uint32_t point) const
    {
        const auto [x, y, z] = dataset_.lattice.coordinates(point);
        return {double(x), double(y), double(z)};
    }
    double volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d) const
    {
        return (b - a).dot((c - a).cross(d - a));
    }
    /// Six volumes towards each face: exact, for they are small integers.
    std::array<double, 4> weights(const Sites& sites, std::uint32_t point) const
    {
        std::array<double, 4> found{};
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<Eigen::Vector3d, 4> corners;
            for (std::size_t k = 0; k < 4; ++k)
                corners[k] = place(k == i ? point : points_[sites[k]]);
            found[i] = volume(corners[0], corners[1], corners[2], corners[3]);
        }
        return found;
    }

    Cell measured(const Sites& sites) const
    {
        Cell cell{sites};
        for (std::uint32_t point = 0; point < dataset_.lattice.pointCount(); ++point) {
            const auto parts = weights(sites, point);
            if (std::ranges::min(parts) < 0)
                continue;
            double whole = 0, sum = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                whole += parts[i];
                sum += parts[i] * (dataset_.values.at(points_[sites[i]]) - dataset_.values.at(point));
            }
            if (std::abs(sum) / whole > cell.error) {
                cell.error = std::abs(sum) / whole;
                cell.worst = point;
            }
        }
        return cell;
    }

    const Cell* worstCell() const
    {
        const auto worse = [](const Cell& one, const Cell& other) {
            return (one.alive ? one.error : -1) < (other.alive ? other.error : -1);
        };
        return &*std::ranges::max_element(cells_, worse);
    }

    /// The eight corners, and six tetrahedra around the diagonal.
    void start()
    {
        const auto& size = dataset_.lattice.size;
        for (std::uint32_t corner = 0; corner < 8; ++corner) {
            points_.push_back(static_cast<std::uint32_t>(dataset_.lattice.index(
                (corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1), (corner >> 2) * (size[2] - 1))));
            if (corner < 7)
                hand(unlimited, {}, {});
        }
        hand(unlimited, {{7, 0, 3, 1}, {7, 0, 2, 3}, {7, 0, 6, 2}, {7, 0, 4, 6}, {7, 0, 5, 4}, {7, 0, 1, 5}}, {});
    }

    void split(std::uint32_t point, float keyBefore)
    {
        const auto creator = static_cast<std::uint32_t>(points_.size());
        std::vector<Sites> star;
        std::vector<std::uint32_t> destroyed;
        for (std::uint32_t number = 0; number < cells_.size(); ++number) {
            if (!cells_[number].alive)
                continue;
            const auto parts = weights(cells_[number].sites, point);
            if (std::ranges::min(parts) < 0)
                continue;
            cells_[number].alive = false;
            destroyed.push_back(number);
            for (std::size_t i = 0; i < 4; ++i)
                if (parts[i] > 0)
                    star.push_back(replaced(cells_[number].sites, i, creator));
        }
        points_.push_back(point);
        hand(keyBefore, star, destroyed);
    }

    /// With the creator in place of corner i, and first.
    static Sites replaced(Sites sites, std::size_t i, std::uint32_t creator)
    {
        sites[i] = creator;
        if (i > 0) {
            std::swap(sites[0], sites[i]);
            std::swap(sites[i == 1 ? 2 : 1], sites[3]);
        }
        return sites;
    }

    void hand(float keyBefore, const std::vector<Sites>& star, const std::vector<std::uint32_t>& destroyed)
    {
        std::vector<HistoryTetrahedron> history;
        for (const Sites& sites : star) {
            cells_.push_back(measured(sites));
            history.push_back(
                {{sites[1], sites[2], sites[3]}, std::nextafter(static_cast<float>(cells_.back().error), unlimited)});
        }
        if (!sink_.add({points_.back(), keyBefore, history, destroyed}))
            std::abort();
    }

    const Dataset& dataset_;
    HistorySink& sink_;
    std::vector<std::uint32_t> points_;
    std::vector<Cell> cells_;
};

} // namespace

std::shared_ptr<const Model> splitModel(const Dataset& dataset, const std::filesystem::path& path)
{
    const auto writer = ModelWriter::create(path, dataset, {});
    if (!writer)
        std::abort();
    Splitting(dataset, **writer).run();
    return Model::open(path).value();
}

} // namespace tetra
