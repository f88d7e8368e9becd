// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/process/reading_process.h"

#include "plugins/process/process_limits.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <optional>
#include <thread>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tetra {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds betweenLooks{50}; ///< at whether it is to be cancelled

Error cannotRead(const std::string& file, ErrorKind kind, const Message& reason)
{
    return {kind, Message::say("Cannot read '%1': %2", file, reason), file};
}

Error notEnoughToStart(const ReadingProgram& program, const Message& reason)
{
    return {ErrorKind::OutOfResource,
            Message::say("There is not enough memory, or there are not enough processes or open files, to start the %1 "
                         "readers (%2). Close other programs, or raise the limit (ulimit).",
                         program.library, reason)};
}

Error notStarted(const ReadingProgram& program, int systemError)
{
    const Message reason = systemErrorText(systemError);
    if (isLackOfResources(systemError))
        return notEnoughToStart(program, reason);
    std::error_code ignored;
    if (!fs::exists(program.path, ignored))
        return {ErrorKind::BadInput,
                Message::say("The %1 readers are not installed. %2", program.library, program.notInstalled)};
    return {ErrorKind::BadInput,
            Message::say("The %1 readers cannot be started: '%2': %3", program.library, program.path.string(), reason)};
}

class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { reset(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    int number() const noexcept { return number_; }
    void reset()
    {
        if (number_ >= 0)
            ::close(std::exchange(number_, -1));
    }

private:
    int number_;
};

/// The two ends of a pipe; none if there is none to be had.
struct Pipe {
    Descriptor reading;
    Descriptor writing;

    static Pipe make()
    {
        constexpr int bytes = 1 << 20; // by default a sixteenth of that, which costs turns
        std::array<int, 2> ends{-1, -1};
        if (::pipe2(ends.data(), O_CLOEXEC) == 0)
            ::fcntl(ends[1], F_SETPIPE_SZ, bytes);
        return {Descriptor(ends[0]), Descriptor(ends[1])};
    }
};

/// A pipe that holds `content` and ends there: what a process is to read needs no one to write it meanwhile. No file in
/// memory, which a limit of the file size would count.
Descriptor filledPipe(const std::string& content)
{
    Pipe pipe = Pipe::make();
    if (pipe.reading.number() < 0)
        return Descriptor();
    ::fcntl(pipe.writing.number(), F_SETFL, O_NONBLOCK);
    const ssize_t written = ::write(pipe.writing.number(), content.data(), content.size());
    if (written == static_cast<ssize_t>(content.size()))
        return std::move(pipe.reading);
    errno = ENOMEM; // a request has some kilobytes, so it is the system that gives smaller pipes
    return Descriptor();
}

/// As the system takes lists of words: with an end.
std::vector<char*> pointersTo(std::vector<std::string>& words)
{
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// A program that runs: its input was given before, its output is read from a pipe.
class RunningProgram {
public:
    /// The error is the system's.
    static std::variant<RunningProgram, int> start(const ReadingProgram& program, const std::string& input)
    {
        const Descriptor request = filledPipe(input);
        if (request.number() < 0)
            return errno;
        Descriptor errors(::memfd_create("tan-read", MFD_CLOEXEC)); // needs no one to read it meanwhile
        if (errors.number() < 0)
            return errno;
        Pipe output = Pipe::make();
        if (output.reading.number() < 0)
            return errno;

        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_adddup2(&files, request.number(), STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&files, output.writing.number(), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&files, errors.number(), STDERR_FILENO);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t every;
        sigfillset(&every); // whatever this program ignores or blocks, but for limits of the file size
        sigdelset(&every, SIGXFSZ);
        posix_spawnattr_setsigdefault(&attributes, &every);
        sigemptyset(&every);
        posix_spawnattr_setsigmask(&attributes, &every);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
        std::vector<std::string> words = {program.path.string()};
        words.insert(words.end(), program.arguments.begin(), program.arguments.end());
        std::vector<std::string> environment = program.environment;
        for (char** word = environ; *word != nullptr; ++word)
            environment.emplace_back(*word); // the first of a name counts
        pid_t process = -1;
        const int failure = ::posix_spawn(&process, words.front().c_str(), &files, &attributes,
                                          pointersTo(words).data(), pointersTo(environment).data());
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        if (failure != 0)
            return failure;
        return RunningProgram(process, std::move(output.reading), std::move(errors));
    }

    RunningProgram(RunningProgram&& other) noexcept
        : process_(std::exchange(other.process_, -1)), output_(std::move(other.output_)),
          errors_(std::move(other.errors_))
    {
    }
    RunningProgram& operator=(RunningProgram&&) = delete;
    ~RunningProgram()
    {
        if (process_ < 0)
            return;
        ::kill(process_, SIGKILL);
        output_.reset();
        waitForEnd(std::chrono::seconds(1)); // longer only if a disk does not let it go
    }

    int output() const noexcept { return output_.number(); }

    /// The processor time that it has used; nothing if that is not known.
    std::optional<std::int64_t> processorNanoseconds() const
    {
        clockid_t clock{};
        timespec time{};
        if (process_ < 0 || ::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
            return std::nullopt;
        return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
    }

    /// How it ended, as waitpid() says it; nothing if it has not within that time.
    std::optional<int> waitForEnd(std::chrono::milliseconds patience)
    {
        const auto end = Clock::now() + patience;
        do {
            int status = 0;
            const pid_t ended = ::waitpid(process_, &status, WNOHANG);
            if (ended == process_ || (ended < 0 && errno != EINTR)) {
                process_ = -1;
                return ended < 0 ? std::nullopt : std::optional(status);
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (Clock::now() < end);
        return std::nullopt;
    }

    /// What it wrote to its standard error, up to some length.
    std::string errors() const
    {
        std::string text(16384, '\0');
        const ssize_t count = ::pread(errors_.number(), text.data(), text.size(), 0);
        text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
        return text;
    }

private:
    RunningProgram(pid_t process, Descriptor output, Descriptor errors)
        : process_(process), output_(std::move(output)), errors_(std::move(errors))
    {
    }

    pid_t process_;
    Descriptor output_;
    Descriptor errors_;
};

/// Reads what the program writes, until it ends, is idle for too long, or the user cancels.
class ProgramOutput {
public:
    ProgramOutput(const RunningProgram& process, const Progress& progress, std::chrono::milliseconds idle)
        : process_(process), progress_(progress), patience_(idle)
    {
    }

    bool read(void* to, std::size_t bytes)
    {
        for (char* place = static_cast<char*>(to); bytes > 0;) {
            if (!waitForMore())
                return false;
            const ssize_t count = ::read(process_.output(), place, bytes);
            if (count < 0 && (errno == EINTR || errno == EAGAIN))
                continue;
            if (count <= 0)
                return false;
            place += count;
            bytes -= static_cast<std::size_t>(count);
        }
        return true;
    }
    bool wasIdle() const noexcept { return wasIdle_; }

private:
    bool waitForMore()
    {
        auto lastSign = Clock::now();
        auto lastTime = process_.processorNanoseconds();
        while (!progress_.cancelled()) {
            pollfd output{process_.output(), POLLIN, 0};
            const int ready = ::poll(&output, 1, static_cast<int>(betweenLooks.count()));
            if (ready > 0)
                return true;
            const auto time = process_.processorNanoseconds();
            if (time != lastTime)
                lastSign = Clock::now();
            lastTime = time;
            wasIdle_ = Clock::now() - lastSign > patience_;
            if (wasIdle_)
                return false;
        }
        return false;
    }

    const RunningProgram& process_;
    const Progress& progress_;
    std::chrono::milliseconds patience_;
    bool wasIdle_ = false;
};

std::string firstLine(std::string_view text)
{
    text = text.substr(0, text.find('\n'));
    return std::string(text.substr(0, text.find_last_not_of(" \r\t") + 1));
}

/// Whether the system's loader says that memory or descriptors were lacking, and not a library.
bool isLoadersLack(std::string_view reason)
{
    constexpr std::array<std::string_view, 4> lacks = {"annot allocate memory", "failed to map segment",
                                                       "oo many open files", "cannot create shared object"};
    return std::ranges::any_of(lacks,
                               [&](std::string_view lack) { return reason.find(lack) != std::string_view::npos; });
}

/// What the system's loader says of libraries that it could not load; nothing if it said nothing.
std::optional<Error> loaderError(const ReadingProgram& program, std::string_view said)
{
    constexpr std::string_view start = "error while loading shared libraries: ";
    const auto place = said.find(start);
    if (place == std::string_view::npos)
        return std::nullopt;
    const std::string reason = firstLine(said.substr(place + start.size()));
    if (isLoadersLack(reason))
        return notEnoughToStart(program, reason);
    const bool missing = reason.find("cannot open shared object") != std::string::npos;
    return Error{ErrorKind::BadInput, missing ? Message::say("The %1 readers are not installed: %2. %3",
                                                             program.library, reason, program.install)
                                              : Message::say("The %1 readers are not installed correctly: %2. %3",
                                                             program.library, reason, program.install)};
}

/// Why the program gave no answer.
Error explainEnd(const ReadingProgram& program, RunningProgram& process, const std::string& file)
{
    const auto status = process.waitForEnd(std::chrono::seconds(2));
    const std::string said = process.errors();
    if (const auto place = said.rfind(limitNote); place != std::string::npos)
        return cannotRead(
            file, ErrorKind::OutOfResource,
            limitMessage(firstLine(std::string_view(said).substr(place + limitNote.size())), program.library));
    if (const auto error = loaderError(program, said))
        return *error;
    const int signal = status && WIFSIGNALED(*status) ? WTERMSIG(*status) : 0;
    if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
        return cancelledError(Message::marked("Reading"));
    if (signal == SIGKILL)
        return cannotRead(file, ErrorKind::OutOfResource,
                          Message::say("the system ended %1, which happens when memory runs out. Close other programs, "
                                       "or take a part of the file.",
                                       program.library));
    return cannotRead(file, ErrorKind::BadInput,
                      Message::say("%1's reader crashed, and TAn cannot tell why: the file may be damaged, or of a "
                                   "kind that %1 reads incorrectly. %2",
                                   program.library, program.otherwise));
}

/// Reads messages up to the answer.
Result<ReadAnswer> receive(const ReadingProgram& program, RunningProgram& process, const std::string& file,
                           const Progress& progress, std::chrono::milliseconds idle)
{
    ProgramOutput output(process, progress, idle);
    ExchangeInput input([&](void* to, std::size_t bytes) { return output.read(to, bytes); });
    std::optional<Result<ReadAnswer>> answer; // there once the last message came
    for (bool last = false; !last && input.good();) {
        ProcessMessage message{};
        exchange(input, message);
        last = message != ProcessMessage::Progress;
        if (message == ProcessMessage::Progress) {
            double fraction = 0;
            exchange(input, fraction);
            if (input.good())
                progress.report(fraction, Message::marked("Reading"));
        } else if (message == ProcessMessage::Findings) {
            FileFindings findings;
            exchange(input, findings);
            answer.emplace(ReadAnswer(std::move(findings)));
        } else if (message == ProcessMessage::Contents) {
            FileContents contents;
            exchange(input, contents);
            answer.emplace(ReadAnswer(std::move(contents)));
        } else if (message == ProcessMessage::Error) {
            Error error;
            exchange(input, error);
            answer.emplace(std::move(error));
        } else if (!progress.cancelled() && !output.wasIdle()) {
            return explainEnd(program, process, file); // the end, or no message
        }
    }
    if (progress.cancelled())
        return cancelledError(Message::marked("Reading"));
    if (output.wasIdle())
        return cannotRead(file, ErrorKind::OutOfResource,
                          Message::say("%1 has waited for its disk for minutes. Check whether the disk answers, or "
                                       "copy the file to another one.",
                                       program.library));
    if (!input.good() || !answer)
        return explainEnd(program, process, file);
    return *std::move(answer);
}

} // namespace

fs::path programBesidePlugin(const void* symbol, const std::string& name)
{
    Dl_info info{};
    if (dladdr(symbol, &info) == 0 || info.dli_fname == nullptr)
        return name;
    return fs::absolute(info.dli_fname).parent_path() / name;
}

Result<ReadAnswer> askReadingProgram(const ReadingProgram& program, const std::string& request, const std::string& file,
                                     const Progress& progress, std::chrono::milliseconds idle)
{
    auto started = RunningProgram::start(program, request);
    if (const int* failure = std::get_if<int>(&started))
        return notStarted(program, *failure);
    // The answer is whole when it came: nothing that the program still has to tidy up is worth waiting for.
    return receive(program, std::get<RunningProgram>(started), file, progress, idle);
}

} // namespace tetra
