// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored_volume.h"

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// How the numbers of a lattice stand in a file, one point after the other.
struct StoredNumbers {
    StoredType type = StoredType::Float64; ///< of text: what its numbers become
    bool isText = false;                   ///< with blanks, line ends or commas between them; exponents as in Fortran
    bool moreMayFollow = false;            ///< more text than these numbers is no error
    std::endian order = std::endian::native;
    std::array<std::uint32_t, 3> size{}; ///< of the lattice
    bool lastFastest = false;            ///< the last index of the lattice runs fastest, as in C, else the first
    std::uint64_t components = 1;        ///< numbers of each point, side by side
    /// Which of them is taken, from 0; none: the root of the sum of their squares.
    std::optional<std::uint64_t> component = 0;
    double factor = 1; ///< if it is not 1, or the summand not 0: the values are floats, summand + factor * number
    double summand = 0;
};

/// The type of the samples that these numbers become; none of 64-bit integers, where it depends on them.
std::optional<SampleType> sampleTypeOf(const StoredNumbers& numbers) noexcept;

/// How many bytes they take, not of text; 2^64 - 1 also if there are more.
std::uint64_t storedBytes(const StoredNumbers& numbers) noexcept;

/// The errors of readStored() that show without going through the numbers: there are too few of them. More bytes are no
/// error where they are not text.
Status checkStored(std::span<const std::byte> data, const StoredNumbers& numbers);

/// The samples, the first index of the lattice running fastest. No memory is taken where `data` hold them as memory
/// would and `owner`, which keeps them alive, is given; else only once it is plain that there are enough data. What
/// changed on the way is told in `remarks`. Errors: too few numbers, of text also too many, or no numbers; not enough
/// memory; cancelled. Linear.
Result<ScalarField> readStored(std::span<const std::byte> data, const StoredNumbers& numbers,
                               std::vector<Message>& remarks, const Progress& progress,
                               const std::shared_ptr<const void>& owner = nullptr);

} // namespace tetra
