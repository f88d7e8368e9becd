// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tetra {

/// Keeps this process from harming others, whatever a damaged file makes VTK do: it ends with the program that started
/// it, may take no more memory than the machine has, is the first to go when memory runs out, and leaves no core file.
void limitThisProcess();

/// Sends what is printed to standard output to nowhere from now on, and gives the file descriptor that still leads to
/// the former one.
int takeStandardOutput();

} // namespace tetra
