// SPDX-License-Identifier: GPL-3.0-or-later
/// tan-mpi: a shared build (D15) whose parts are the ranks of an MPI job. All that they say to each other is in the
/// files of the shared folder, as without MPI; MPI starts them, and tells when all are done.
#include "app/command_line/command_line.h"
#include "app/command_line/interruption.h"
#include "core/base/file_writer.h"
#include "core/base/text.h"
#include "core/build/model_build.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parts/parts_plan.h"
#include "plugins/host/plugin_folders.h"

#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {
namespace {

using Words = std::vector<std::string>;

/// What a job is asked for, taken apart.
struct Job {
    std::string input;
    std::string model;
    std::string folder; ///< in which the parts are built
    std::string threads = "1";
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

bool asksForHelp(const Words& words)
{
    return std::ranges::any_of(words, [](const std::string& word) { return word == "--help" || word == "-h"; });
}

/// Nothing if the words are no job. The input is the first word after the command: which of the later ones are values
/// of options the builders' plugins know.
std::optional<Job> jobOf(const Words& words)
{
    if (words.size() < 2 || words[0] != "build" || words[1].starts_with("-") || asksForHelp(words))
        return std::nullopt;
    Job job{.input = words[1], .model = {}, .folder = {}, .options = {}};
    for (std::size_t i = 2; i < words.size(); ++i) {
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
        else
            job.options.push_back(words[i]);
    }
    if (job.model.empty())
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
        if (const int code = ofFirst([&] { return prepare(job); }); code != 0)
            return code;
        if (const int code = run(wordsOfPart(job), nullptr); code != 0)
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

    int prepare(const Job& job) const
    {
        // Before anything long is done.
        for (const Status& safe :
             {checkOutput(job.model, std::array<std::filesystem::path, 1>{job.input}), checkModelOutput(job.model)})
            if (!safe) {
                std::cerr << "tan-mpi: " << visibleText(safe.error().message) << std::endl;
                return exitCode(safe.error().kind);
            }
        Words words{"build", job.input, "--part", "prepare", "--threads", job.threads, "-o", job.folder};
        words.insert(words.end(), job.options.begin(), job.options.end());
        return run(words, nullptr);
    }

    Words wordsOfPart(const Job& job) const
    {
        Words words{"build",     job.input,   "--part", std::to_string(rank_ + 1) + "/" + std::to_string(count_),
                    "--threads", job.threads, "-o",     job.folder};
        if (const auto plan = readPlan(job.folder); plan && plan->domain == DomainClass::Curvilinear)
            words.emplace_back("--wait");
        return words;
    }

    int merge(const Job& job) const
    {
        Words words{"merge", job.folder, "--threads", job.threads, "-o", job.model};
        if (job.json)
            words.emplace_back("--json");
        const int code = run(words, &std::cout);
        if (code == 0 && !job.keeps)
            removeParts(job.folder);
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
    const bool asked = asksForHelp(words);
    if (rank.isFirst())
        (asked ? std::cout : std::cerr) << usage;
    return asked ? 0 : exitCode(ErrorKind::WrongUsage);
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
