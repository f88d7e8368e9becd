// SPDX-License-Identifier: GPL-3.0-or-later
// tan-bench-python-module MODEL: for each line of its input, an error (%), extracts its mesh and prints the seconds
// that it took. What the Python module is measured against (module_speed.py).
#include <tan/model.h>
#include <tan/query.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>

int main(int argumentCount, char** arguments)
{
    if (argumentCount != 2) {
        std::fputs("tan-bench-python-module MODEL\n", stderr);
        return 2;
    }
    const auto model = tetra::Model::open(arguments[1]);
    if (!model) {
        std::fputs((model.error().text() + "\n").c_str(), stderr);
        return 3;
    }
    tetra::MeshQuery query;
    tetra::MeshExtractor extractor(*model);
    for (std::string line; std::getline(std::cin, line);) {
        query.error = std::atof(line.c_str());
        const auto start = std::chrono::steady_clock::now();
        const auto mesh = extractor.extract(query);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        if (!mesh)
            return 3;
        std::printf("%.6f %zu\n", seconds.count(), (*mesh)->mesh.tetrahedra.size());
        std::fflush(stdout);
    }
    return 0;
}
