// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetra {

/// An allocator that leaves new elements of trivial types uninitialised, so that a buffer of gigabytes that is about
/// to be overwritten is not first filled with zeros.
template <class T> class UninitializedAllocator : public std::allocator<T> {
public:
    template <class U> struct rebind {
        using other = UninitializedAllocator<U>;
    };
    template <class U, class... Arguments> void construct(U* where, Arguments&&... arguments)
    {
        if constexpr (sizeof...(Arguments) == 0 && std::is_trivially_destructible_v<U>)
            ::new (static_cast<void*>(where)) U;
        else
            ::new (static_cast<void*>(where)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A std::vector whose resize() leaves new elements uninitialised.
template <class T> using Buffer = std::vector<T, UninitializedAllocator<T>>;

} // namespace tetra
