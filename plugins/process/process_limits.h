// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <string_view>

namespace tetra {

/// What a reading program may take for a file.
struct WorkLimits {
    std::uint64_t memory = 0;     ///< bytes
    std::uint64_t seconds = 0;    ///< of processor time, which is fair to slow and busy machines
    bool isHalfOfMachine = false; ///< the memory is what this machine can spare, not what the file should need
};

/// For files of so many bytes that unpack to so many: several times what any good file was seen to need, at least 2 GiB
/// and a minute, at most half of the machine's memory.
WorkLimits limitsFor(std::uint64_t bytes, std::uint64_t unpackedBytes, std::uint64_t machineBytes);

/// Keeps this process from harming others, whatever a damaged file makes its library do: it ends with the program that
/// started it, is the first to go when memory runs out, leaves no core file, and has the limits of the largest file
/// until limitWork() sets others. Call first.
void limitThisProcess();

/// From now on this process may take so much more. When its time is over it ends, having written limitNote and a few
/// words to standard error; where memory ends, std::bad_alloc is thrown, and the same written.
void limitWork(const WorkLimits& limits);

/// From now on this process opens no second file while it has one open besides those that are open now: libraries that
/// follow links from one file into others (HDF5, CGNS) find none there.
void allowOneFile();

/// The Error for std::bad_alloc under the limits that are set: that, and what to do. `library` is whose name messages
/// give the one who needs so much: "VTK".
Error memoryLimitMet(std::string_view library);

/// What a process whose limits were met begins its last words with.
inline constexpr std::string_view limitNote = "\ntan-read met a limit: ";

/// The last words, which limitNote comes before, as a sentence for the user; `library` as in memoryLimitMet().
Message limitMessage(std::string_view words, std::string_view library);

/// Sends what is printed to standard output and standard error to nowhere from now on, and gives the file descriptor
/// that still leads to the former output; limitNote still goes to the former error.
int takeStandardOutput();

} // namespace tetra
