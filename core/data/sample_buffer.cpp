// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/sample_buffer.h"

#include "core/base/memory.h"
#include "core/base/reserved_array.h"

#include <limits>
#include <string>

namespace tetra {

Result<std::shared_ptr<std::byte>> allocateSamples(SampleType type, std::uint64_t count)
{
    const std::uint64_t physical = physicalBytes();
    const std::uint64_t limit = physical != 0 ? physical : std::numeric_limits<std::uint64_t>::max() / 2;
    if (count > limit / sampleSize(type))
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory: " + std::to_string(count) + " samples of type " +
                         std::string(sampleTypeName(type)) + " do not fit into the " + std::to_string(limit >> 20) +
                         " MiB of this machine. Use a smaller part or a coarser version of the data."};
    Result<std::shared_ptr<void>> memory = reserveMemory(count * sampleSize(type), "the samples");
    if (!memory)
        return memory.error();
    return std::static_pointer_cast<std::byte>(*std::move(memory));
}

} // namespace tetra
