// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_program.h"

#include "tests/lacks.h"
#include "tests/sanitizers/leaks.h"
#include "tests/sanitizers/processes.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace {

std::map<std::string, tetra::TestMain>& tests()
{
    static std::map<std::string, tetra::TestMain> all; // made by the first test that is entered
    return all;
}

std::set<std::string>& lacks()
{
    static std::set<std::string> all;
    return all;
}

constexpr int skipped = 77; // SKIP_RETURN_CODE in CMakeLists.txt

/// On machines that have the datasets everything else is expected, too.
bool maySkip()
{
    if (const char* told = std::getenv("TAN_MAY_SKIP"))
        return std::string_view(told) != "0";
    return !std::filesystem::exists(TAN_SOURCE_DIR "/../shared/data");
}

/// What ctest is told of a test in which so many functions failed.
int exitCode(int failures)
{
    if (failures != 0)
        return 1; // their number might be that of skipping
    if (lacks().empty())
        return 0;
    const char* separator =
        maySkip() ? "Skipped in part, for lack of: " : "Failed, as nothing may be skipped, for lack of: ";
    for (const std::string& what : lacks())
        std::printf("%s%s", std::exchange(separator, ", "), what.c_str());
    std::puts("");
    return maySkip() ? skipped : 1;
}

} // namespace

void tetra::noteLack(const char* what)
{
    lacks().insert(what);
}

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
    return exitCode(test->second(argc - 1, argv + 1));
}
