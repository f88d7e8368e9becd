// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_program.h"

#include "tests/sanitizers/leaks.h"
#include "tests/sanitizers/processes.h"

#include <cstdio>
#include <map>
#include <string>

namespace {

std::map<std::string, tetra::TestMain>& tests()
{
    static std::map<std::string, tetra::TestMain> all; // made by the first test that is entered
    return all;
}

} // namespace

bool tetra::addTest(const char* source, TestMain run)
{
    std::string name = source;
    name.erase(0, name.rfind('/') + 1);
    name.resize(name.rfind("_test.cpp"));
    return tests().emplace(name, run).second;
}

int main(int argc, char** argv)
{
    const auto test = argc > 1 ? tests().find(argv[1]) : tests().end();
    if (test == tests().end()) {
        std::fputs("Name one of these tests, then Qt's arguments (-functions lists what it has):\n", stderr);
        for (const auto& [name, run] : tests())
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    argv[1] = argv[0];
    return test->second(argc - 1, argv + 1);
}
