// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>
#include <tan/model.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace tetra {

/// A build that can be looked at while it runs (B8). Remembers the beginning of the history that passes through
/// watch(), coarse first, and makes models of it, each the mesh of the first sites with its known error; or the mesh
/// that a builder shows which hands over nothing before its end. Safe to use from two threads: the one that builds and
/// one that looks.
class LiveBuild {
public:
    /// Of a history that has more tetrahedra than this, the later part cannot be looked at before the build is done.
    explicit LiveBuild(std::size_t mostTetrahedra = 4'000'000) : mostTetrahedra_(mostTetrahedra) {}

    /// A sink that hands everything on to `next` and remembers it; `next` and this outlive it. Called by the build.
    std::unique_ptr<HistorySink> watch(HistorySink& next, const Dataset& dataset, const ModelDescription& description);

    /// BuildTarget::preview: from now on, this mesh is what is looked at, if it is not larger than may be remembered.
    void show(const std::function<Status(HistorySink& history)>& hand);

    /// Whether there is a mesh of known error by now, so that the build can be stopped and kept.
    bool hasMesh()
    {
        const std::lock_guard lock(mutex_);
        return completeSteps_ > 0 || shown_ > 0;
    }

    /// The error of that mesh in percent of the value range; nothing without one.
    std::optional<double> error();

    /// A model of what has been made so far, as the file `path`; null if there is nothing new since the last look.
    Result<std::shared_ptr<const Model>> look(const std::filesystem::path& path);

private:
    class Watch;
    class Shown;
    struct Step {
        std::uint64_t point;
        float keyBefore;
        std::size_t starEnd;
        std::size_t destroyedEnd;
    };
    struct History {
        HistoryTraits traits;
        std::vector<Step> steps;
        std::vector<HistoryTetrahedron> stars;
        std::vector<std::uint32_t> destroyed;

        void add(const HistoryStep& step);
    };

    /// With the mutex locked.
    void beginAnew(History history);

    void record(const HistoryStep& step);
    /// Copies what has come up to the last complete batch; its key, or nothing if that is not more than before.
    std::optional<float> catchUp();

    std::size_t mostTetrahedra_;
    std::mutex mutex_; ///< guards what the build writes: the next seven
    std::optional<Dataset> dataset_;
    ModelDescription description_;
    History history_;
    float runningKey_ = std::numeric_limits<float>::infinity();
    std::size_t completeSteps_ = 0; ///< steps before the mesh of the running key
    bool full_ = false;
    std::uint32_t shown_ = 0; ///< how many meshes were shown: with each one, and after the last one, all begins anew

    History seen_; ///< the looking thread's copy
    std::uint32_t seenShown_ = 0;
};

} // namespace tetra
