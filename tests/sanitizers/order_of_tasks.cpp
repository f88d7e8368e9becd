// SPDX-License-Identifier: GPL-3.0-or-later
/// The order of TBB's tasks, for the thread sanitizer alone: TBB's library is not compiled for it, so that it would
/// take whatever one thread prepares and another one does for a race. What comes before a task is spawned comes before
/// it is executed, and what a task did comes before the end of the wait for it. These functions take the place of the
/// library's, and call them.
#include "tests/sanitizers/next_function.h"

#include <tbb/cache_aligned_allocator.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <tbb/tbb_allocator.h>

#include <cstdint>
#include <cstdlib>
#include <new>

#include <sanitizer/tsan_interface.h>

namespace tbb::detail {
namespace {

constexpr std::size_t lineBytes = 64; ///< at least: no two threads write one line of the cache

/// Executes a task in the order described. A task that throws is cancelled then by the library, so that this one stays
/// until the other one has returned.
class OrderedTask : public d1::task {
public:
    explicit OrderedTask(d1::task& task) : task_(&task) { __tsan_release(this); }

private:
    d1::task* execute(d1::execution_data& data) override
    {
        __tsan_acquire(this);
        return endWith(task_->execute(data));
    }
    d1::task* cancel(d1::execution_data& data) override
    {
        __tsan_acquire(this);
        return endWith(task_->cancel(data));
    }
    d1::task* endWith(d1::task* next)
    {
        delete this;
        return next;
    }

    d1::task* task_;
};

/// The count that each ended task has changed stands behind one word.
void* endsOf(d1::wait_context& context)
{
    return reinterpret_cast<char*>(&context) + sizeof(std::uint64_t);
}

d1::small_object_pool* anyPool()
{
    static std::uint64_t place;
    return reinterpret_cast<d1::small_object_pool*>(&place);
}

} // namespace

// Core hides what it does not export. Hidden, these functions would serve its own calls alone, and the library would
// free by its functions what came from these.
#pragma GCC visibility push(default)
namespace r1 {

void spawn(d1::task& task, d1::task_group_context& context)
{
    static auto* const call = tetra::nextFunction<void(d1::task&, d1::task_group_context&)>(
        "_ZN3tbb6detail2r15spawnERNS0_2d14taskERNS2_18task_group_contextE");
    call(*new OrderedTask(task), context);
}

void spawn(d1::task& task, d1::task_group_context& context, d1::slot_id slot)
{
    static auto* const call = tetra::nextFunction<void(d1::task&, d1::task_group_context&, d1::slot_id)>(
        "_ZN3tbb6detail2r15spawnERNS0_2d14taskERNS2_18task_group_contextEt");
    call(*new OrderedTask(task), context, slot);
}

void execute_and_wait(d1::task& task, d1::task_group_context& context, d1::wait_context& ends,
                      d1::task_group_context& waiting)
{
    static auto* const call =
        tetra::nextFunction<void(d1::task&, d1::task_group_context&, d1::wait_context&, d1::task_group_context&)>(
            "_ZN3tbb6detail2r116execute_and_waitERNS0_2d14taskERNS2_18task_group_contextERNS2_12wait_contextES6_");
    call(task, context, ends, waiting);
    __tsan_acquire(endsOf(ends));
}

void wait(d1::wait_context& ends, d1::task_group_context& waiting)
{
    static auto* const call = tetra::nextFunction<void(d1::wait_context&, d1::task_group_context&)>(
        "_ZN3tbb6detail2r14waitERNS0_2d112wait_contextERNS2_18task_group_contextE");
    call(ends, waiting);
    __tsan_acquire(endsOf(ends));
}

// The stages of a pipeline are ordered by locks within the library, so only their calls by one thread are looked at.
void parallel_pipeline(d1::task_group_context& context, std::size_t /*tokens*/, const d1::filter_node& stages)
{
    static auto* const call = tetra::nextFunction<void(d1::task_group_context&, std::size_t, const d1::filter_node&)>(
        "_ZN3tbb6detail2r117parallel_pipelineERNS0_2d118task_group_contextEmRKNS2_11filter_nodeE");
    d1::task_arena(1).execute([&] { call(context, 1, stages); });
}

// Memory that goes from thread to thread within the library would look like a race, too; the sanitizer knows malloc.
void* cache_aligned_allocate(std::size_t bytes)
{
    void* const memory = std::aligned_alloc(lineBytes, (bytes + lineBytes - 1) / lineBytes * lineBytes);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

void cache_aligned_deallocate(void* memory)
{
    std::free(memory);
}

void* allocate_memory(std::size_t bytes)
{
    return cache_aligned_allocate(bytes);
}

void deallocate_memory(void* memory)
{
    std::free(memory);
}

void* allocate(d1::small_object_pool*& pool, std::size_t bytes)
{
    pool = anyPool();
    return cache_aligned_allocate(bytes);
}

void* allocate(d1::small_object_pool*& pool, std::size_t bytes, const d1::execution_data& /*data*/)
{
    return allocate(pool, bytes);
}

void deallocate(d1::small_object_pool& /*pool*/, void* memory, std::size_t /*bytes*/)
{
    std::free(memory);
}

void deallocate(d1::small_object_pool& pool, void* memory, std::size_t bytes, const d1::execution_data& /*data*/)
{
    deallocate(pool, memory, bytes);
}

} // namespace r1
#pragma GCC visibility pop
} // namespace tbb::detail
