// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/findings.h"
#include "core/model/verify_each.h"
#include "core/model/verify_parts.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tetra {

namespace {

using FaceSites = std::array<std::uint32_t, 3>; ///< sites in increasing order

constexpr std::size_t groupsAtOnce = 256;

/// The tetrahedra by the site that destroys them.
struct Destroyed {
    std::vector<std::uint64_t> starts;
    std::vector<std::uint64_t> numbers;

    explicit Destroyed(const Model& model) : starts(model.siteCount() + 1)
    {
        const auto forEach = [&](auto&& use) {
            for (std::uint64_t number = 0; number < model.tetrahedronCount(); ++number)
                if (const std::uint32_t destroyer = model.destroyers()[number]; destroyer < model.siteCount())
                    use(destroyer, number);
        };
        forEach([&](std::uint32_t destroyer, std::uint64_t) { ++starts[destroyer + 1]; });
        for (std::size_t site = 1; site < starts.size(); ++site)
            starts[site] += starts[site - 1];
        numbers.resize(starts.back());
        std::vector<std::uint64_t> next(starts.begin(), starts.end() - 1);
        forEach([&](std::uint32_t destroyer, std::uint64_t number) { numbers[next[destroyer]++] = number; });
    }
};

/// The faces that belong to one of the tetrahedra, sorted.
std::vector<FaceSites> outerFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    std::vector<FaceSites> faces;
    for (const auto& t : tetrahedra)
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            FaceSites face = {t[(opposite + 1) % 4], t[(opposite + 2) % 4], t[(opposite + 3) % 4]};
            std::ranges::sort(face);
            faces.push_back(face);
        }
    std::ranges::sort(faces);
    std::vector<FaceSites> outer;
    for (auto begin = faces.begin(); begin != faces.end();) {
        const auto end = std::find_if(begin, faces.end(), [&](const FaceSites& face) { return face != *begin; });
        if (end - begin == 1)
            outer.push_back(*begin);
        begin = end;
    }
    return outer;
}

class ClosureCheck {
public:
    explicit ClosureCheck(const Model& model) : model_(model), destroyed_(model), creators_(model.tetrahedronCount())
    {
        for (std::uint32_t site = 0; site < model.siteCount(); ++site)
            std::fill(creators_.begin() + static_cast<std::ptrdiff_t>(model.starOffsets()[site]),
                      creators_.begin() + static_cast<std::ptrdiff_t>(model.starOffsets()[site + 1]), site);
        for (std::uint32_t site = 0; site < model.siteCount(); ++site)
            if (site == 0 || model.groupGoesOn()[site - 1] == 0)
                groups_.push_back(site);
        groups_.push_back(model.siteCount());
    }

    Status run(const Progress& progress)
    {
        return verifyEach(groups_.size() - 1, groupsAtOnce, "Verifying what sites depend on", progress,
                          [this](std::size_t group) {
                              if (group > 0) // the first one stands on nothing
                                  checkGroup(groups_[group], groups_[group + 1]);
                          });
    }
    void moveTo(std::vector<std::string>& failures) { findings_.moveTo(failures); }

private:
    std::array<std::uint32_t, 4> sitesOf(std::uint64_t number) const
    {
        const auto& others = model_.otherSites()[number];
        return {creators_[number], others[0], others[1], others[2]};
    }

    void checkGroup(std::uint32_t first, std::uint32_t end)
    {
        std::vector<std::array<std::uint32_t, 4>> emptied;
        std::vector<std::array<std::uint32_t, 4>> filled;
        for (std::uint64_t i = destroyed_.starts[first]; i < destroyed_.starts[end]; ++i)
            emptied.push_back(sitesOf(destroyed_.numbers[i]));
        for (std::uint64_t number = model_.starOffsets()[first]; number < model_.starOffsets()[end]; ++number)
            filled.push_back(sitesOf(number));
        const std::vector<FaceSites> before = outerFaces(emptied);
        for (const FaceSites& face : outerFaces(filled))
            if (face[2] < first && !std::ranges::binary_search(before, face))
                findings_.add(first, [&] {
                    return "The group of site " + std::to_string(first) + " has a tetrahedron on the face of sites " +
                           std::to_string(face[0]) + ", " + std::to_string(face[1]) + " and " +
                           std::to_string(face[2]) +
                           ", which is none of what it destroys: not every closed set with it has a mesh.";
                });
    }

    const Model& model_;
    Destroyed destroyed_;
    std::vector<std::uint32_t> creators_;
    std::vector<std::uint32_t> groups_; ///< their first sites, and one beyond all
    Findings findings_;
};

} // namespace

Status verifyClosure(const Model& model, std::vector<std::string>& failures, const Progress& progress)
{
    ClosureCheck check(model);
    const Status done = check.run(progress);
    check.moveTo(failures);
    return done;
}

} // namespace tetra
