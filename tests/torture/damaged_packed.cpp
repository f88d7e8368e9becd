// SPDX-License-Identifier: GPL-3.0-or-later
// Damages packed models and unpacks them: tan-damaged-packed SEED FIRST COUNT FILE... Attempt i is of file i modulo
// their number, and depends on the seed and i alone. Prints what came of how many, and on standard error what went
// wrong; the exit code is 1 then.
#include "tests/core/packed/packed_damage.h"
#include "tests/fuzz/fuzz_folder.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

int main(int count, char** words)
{
    using namespace tetra;
    constexpr int firstFile = 4;
    if (count <= firstFile) {
        std::fputs("tan-damaged-packed SEED FIRST COUNT FILE...: unpacks damaged forms of packed models\n", stderr);
        return 2;
    }
    const std::uint64_t seed = std::strtoull(words[1], nullptr, 10), first = std::strtoull(words[2], nullptr, 10),
                        end = first + std::strtoull(words[3], nullptr, 10);
    const FuzzFolder folder; // in memory: unpacking waits for the disk
    std::vector<std::unique_ptr<DamageJudge>> judges;
    for (int file = firstFile; file < count; ++file)
        judges.push_back(std::make_unique<DamageJudge>(words[file], folder.path()));
    std::array<std::uint64_t, 3> outcomes{};
    std::size_t failures = 0;
    for (std::uint64_t number = first; number < end; ++number) {
        DamageJudge& judge = *judges[number % judges.size()];
        const std::size_t before = judge.failures().size();
        std::seed_seq mixed{seed, number};
        std::mt19937_64 random(mixed);
        ++outcomes[static_cast<std::size_t>(judge.judge(random))];
        for (std::size_t i = before; i < judge.failures().size(); ++i, ++failures)
            std::fprintf(stderr, "%llu: %s\n", static_cast<unsigned long long>(number), judge.failures()[i].c_str());
    }
    std::printf("{\"refused\": %llu, \"the same model\": %llu, \"another model that says so\": %llu}\n",
                static_cast<unsigned long long>(outcomes[0]), static_cast<unsigned long long>(outcomes[1]),
                static_cast<unsigned long long>(outcomes[2]));
    return failures == 0 ? 0 : 1;
}
