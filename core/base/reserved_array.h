// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <type_traits>

namespace tetra {

/// Reserves address space, backed by memory only where it is touched; zero at first. Asks for huge pages, which make
/// random access to gigabytes a good deal quicker. The error says how much was asked for, and for what.
Result<std::shared_ptr<void>> reserveMemory(std::size_t bytes, MarkedText purpose);

/// An array of a plain type with a known largest size and without the copies and the doubled peak of a growing vector:
/// reserve() takes address space, memory comes with the first touch. Elements are zero until written. Not copyable.
template <class T> class ReservedArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    ReservedArray() = default;
    ReservedArray(const ReservedArray&) = delete;
    ReservedArray& operator=(const ReservedArray&) = delete;

    Status reserve(std::uint64_t capacity, MarkedText purpose)
    {
        Result<std::shared_ptr<void>> memory = reserveMemory(capacity * sizeof(T), purpose);
        if (!memory)
            return memory.error();
        memory_ = *std::move(memory);
        data_ = static_cast<T*>(memory_.get());
        capacity_ = capacity;
        return {};
    }

    /// As reserve(), but keeps the memory, whatever it holds, if it is large enough.
    Status ensure(std::uint64_t capacity, MarkedText purpose)
    {
        return capacity <= capacity_ ? Status() : reserve(capacity, purpose);
    }

    std::uint64_t capacity() const noexcept { return capacity_; }
    T* data() noexcept { return data_; }
    const T* data() const noexcept { return data_; }
    T& operator[](std::uint64_t index) noexcept { return data_[index]; }
    const T& operator[](std::uint64_t index) const noexcept { return data_[index]; }

private:
    std::shared_ptr<void> memory_;
    T* data_ = nullptr;
    std::uint64_t capacity_ = 0;
};

} // namespace tetra
