// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/uniform_budget.h"

#include <algorithm>
#include <string>

namespace tetra {

Result<MeshSize> meshSizeWithin(const Model& model, const Accuracy& asked, std::uint64_t budget)
{
    const MeshSize finest = meshSizeAt(model, asked);
    const std::span<const float> errors = model.runningErrors();
    const std::span<const std::uint32_t> sizes = model.meshSizes();
    constexpr std::uint32_t checkedAtOnce = 1 << 12;
    std::uint32_t within = 0;
    for (std::uint32_t sites = 1; sites <= finest.sites; ++sites) {
        if (sites % checkedAtOnce == 1) {
            const std::size_t count = std::min<std::size_t>(checkedAtOnce, errors.size() - (sites - 1));
            const std::size_t next = sites - 1 + count < errors.size() ? 1 : 0; // the loop looks at it, too
            if (!model.check(errors.subspan(sites - 1, count + next)) || !model.check(sizes.subspan(sites - 1, count)))
                return model.checkIntact().error();
        }
        const bool endsBatch = sites == errors.size() || errors[sites] < errors[sites - 1];
        if (endsBatch && sizes[sites - 1] > budget) {
            if (within == 0)
                return Error{ErrorKind::WrongUsage, "The coarsest mesh of '" + model.path().string() + "' has " +
                                                        std::to_string(sizes[sites - 1]) +
                                                        " tetrahedra, more than the budget of " +
                                                        std::to_string(budget) + ". Allow at least as many."};
            break;
        }
        if (endsBatch)
            within = sites;
    }
    return within == finest.sites ? finest : meshSizeOf(model, within);
}

} // namespace tetra
