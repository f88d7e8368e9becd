// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>

namespace tetra {

/// Reserves address space, backed by memory only where it is touched; zero at first. Asks for huge pages, which make
/// random access to gigabytes a good deal quicker. The error says how much was asked for, and for what.
Result<std::shared_ptr<void>> reserveMemory(std::size_t bytes, MarkedText purpose);

/// Calls `visit` for the runs of pages, in order, that may have been written since reserveMemory() gave the memory, as
/// bytes from its beginning: all of it where the system does not tell. `visit` does not throw. Costs a read of 8 bytes
/// a page. May throw std::bad_alloc.
void forEachTouchedRun(const void* memory, std::size_t bytes,
                       const std::function<void(std::size_t first, std::size_t end)>& visit);

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

    /// Calls `visit` for spans of the elements, in order, that hold all that are not zero. May throw std::bad_alloc.
    template <class Visit> void forEachTouched(const Visit& visit)
    {
        forEachTouchedRun(data_, capacity_ * sizeof(T), [&](std::size_t first, std::size_t end) {
            const std::size_t from = first / sizeof(T);
            const std::size_t to = std::min<std::size_t>((end + sizeof(T) - 1) / sizeof(T), capacity_);
            visit(std::span(data_ + from, to - from));
        });
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
