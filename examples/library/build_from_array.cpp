// SPDX-License-Identifier: GPL-3.0-or-later
// build_from_array MODEL.tan: a model of a field that a program has in memory: two wells, as of two charges.
#include <tan/build.h>

#include <cmath>
#include <iostream>

int main(int count, char** arguments)
{
    if (count != 2) {
        std::cerr << "usage: build_from_array MODEL.tan\n";
        return 2;
    }
    tetra::Lattice lattice;
    lattice.size = {48, 40, 40};
    lattice.spacing = {0.1, 0.1, 0.1};
    const Eigen::Vector3d wells[] = {{1.4, 2, 2}, {3.3, 2, 2}};
    std::vector<float> potential(lattice.pointCount());
    for (std::uint64_t point = 0; point < potential.size(); ++point) {
        const auto [i, j, k] = lattice.coordinates(point);
        double sum = 0;
        for (const Eigen::Vector3d& well : wells)
            sum -= std::exp(-(lattice.position(i, j, k) - well).squaredNorm());
        potential[point] = static_cast<float>(sum);
    }
    const auto dataset = tetra::latticeDataset(lattice, tetra::ScalarField::of(std::move(potential)), "two wells");
    if (!dataset) {
        std::cerr << dataset.error().text() << '\n';
        return 1;
    }
    const tetra::Progress progress({}, [](double fraction, const tetra::Message& activity) {
        std::cerr << '\r' << activity.text() << ' ' << int(100 * fraction) << " %  ";
    });
    const auto report = tetra::buildModel(*dataset, arguments[1], tetra::suitableMethod(*dataset), progress);
    std::cerr << '\n';
    if (!report) {
        std::cerr << report.error().text() << '\n';
        return 1;
    }
    std::cout << report->sites << " sites, " << report->tetrahedra << " tetrahedra\n";
}
