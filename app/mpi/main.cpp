// SPDX-License-Identifier: GPL-3.0-or-later
/// tan-mpi: a shared build (D15) whose parts are the ranks of an MPI job. All that they say to each other is in the
/// files of the shared folder, as without MPI; MPI starts them, and tells when all are done.
#include "app/command_line/command_line.h"
#include "app/command_line/interruption.h"
#include "core/base/file_writer.h"
#include "plugins/host/parts/parts_plan.h"
#include "plugins/host/plugin_folders.h"

#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tetra {
namespace {

using Words = std::vector<std::string>;

constexpr int wrongUsage = 2;

/// What a job is asked for, taken apart.
struct Job {
    std::string input;
    std::string model;
    std::string folder; ///< in which the parts are built
    std::string threads;
    Words options; ///< of the build
    bool json = false;
    bool keeps = false; ///< the folder
};

constexpr std::string_view usage =
    R"(Usage: mpirun -n N tan-mpi build IN -o MODEL [OPTION...]

Builds a model as 'tan build' does, by N processes: each of them builds a part of the blocks, and the first one merges
the parts. The model is the same, byte for byte, as one that a single process builds in the same blocks. All options of
a build in blocks are those of 'tan build'.

  --parts FOLDER   where the parts are built, on a disk that all processes see (default: MODEL.parts)
  --keep-parts     leave the folder when the model is there; after a failure it always stays, and the same command goes on
  --threads N      the most threads that a process uses (default: 1)
  --json           print one JSON object instead of text
)";

/// Nothing if the words are no job.
std::optional<Job> jobOf(const Words& words)
{
    if (words.size() < 2 || words[0] != "build")
        return std::nullopt;
    Job job{.threads = "1"};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t equals = words[i].starts_with("--") ? words[i].find('=') : std::string::npos;
        const std::string name = words[i].substr(0, equals);
        const auto value = [&] {
            return equals != std::string::npos ? words[i].substr(equals + 1) : i + 1 < words.size() ? words[++i] : "";
        };
        if (name == "-o" || name == "--output")
            job.model = value();
        else if (name == "--parts")
            job.folder = value();
        else if (name == "--threads")
            job.threads = value();
        else if (name == "--json")
            job.json = true;
        else if (name == "--keep-parts")
            job.keeps = true;
        else if (job.input.empty() && !name.starts_with("-"))
            job.input = words[i];
        else
            job.options.push_back(words[i]);
    }
    if (job.input.empty() || job.model.empty())
        return std::nullopt;
    if (job.folder.empty())
        job.folder = job.model + ".parts";
    return job;
}

/// One process of the job.
class Rank {
public:
    Rank(PluginHost& host, const Interruption& interruption) : host_(host), interruption_(interruption)
    {
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }

    bool isFirst() const noexcept { return rank_ == 0; }

    /// The exit code, the same for all.
    int build(const Job& job) const
    {
        Words preparing{"build", job.input, "--part", "prepare", "-o", job.folder};
        preparing.insert(preparing.end(), job.options.begin(), job.options.end());
        if (const int code = ofFirst([&] { return run(preparing, nullptr); }); code != 0)
            return code;
        if (const int code = run(partWords(job), nullptr); code != 0)
            MPI_Abort(MPI_COMM_WORLD, code); // others may wait for this part
        MPI_Barrier(MPI_COMM_WORLD);
        return ofFirst([&] { return merge(job); });
    }

private:
    /// What the first process does while the others wait.
    template <class Work> int ofFirst(const Work& work) const
    {
        int code = isFirst() ? work() : 0;
        MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
        return code;
    }

    Words partWords(const Job& job) const
    {
        Words words{"build",     job.input,   "--part", std::to_string(rank_ + 1) + "/" + std::to_string(count_),
                    "--threads", job.threads, "-o",     job.folder};
        if (const auto plan = readPlan(job.folder); plan && plan->domain == DomainClass::Curvilinear)
            words.emplace_back("--wait");
        return words;
    }

    int merge(const Job& job) const
    {
        Words words{"merge", job.folder, "-o", job.model};
        if (job.json)
            words.emplace_back("--json");
        const int code = run(words, &std::cout);
        std::error_code problem; // what cannot be removed stays
        if (code == 0 && !job.keeps)
            std::filesystem::remove_all(job.folder, problem);
        return code;
    }

    /// Figures go to `output`, or to nobody; messages of processes that are not the first are told together at the end.
    int run(const Words& words, std::ostream* output) const
    {
        std::ostringstream unheard, told;
        const int code = runCommandLine(
            words, host_, {output != nullptr ? *output : unheard, isFirst() ? std::cerr : told}, interruption_.token());
        if (code != 0 && !isFirst())
            std::cerr << told.str() << std::flush;
        return code;
    }

    PluginHost& host_;
    const Interruption& interruption_;
    int rank_ = 0;
    int count_ = 1;
};

int run(const Words& words, const Interruption& interruption)
{
    ignoreRelativeFolders();
    const auto host = PluginHost::standard();
    const Rank rank(*host, interruption);
    const auto job = jobOf(words);
    if (job)
        return rank.build(*job);
    const bool asked = std::ranges::any_of(words, [](const auto& word) { return word == "--help" || word == "-h"; });
    if (rank.isFirst())
        (asked ? std::cout : std::cerr) << usage;
    return asked ? 0 : wrongUsage;
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    tetra::reportFailedWrites();
    const tetra::Interruption interruption;
    MPI_Init(&argc, &argv);
    const int code = tetra::run({argv + 1, argv + argc}, interruption);
    MPI_Finalize();
    return code;
}
