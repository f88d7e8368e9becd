// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/live_build.h"

#include "core/history/model_writer.h"

#include <span>

namespace tetra {

namespace {

/// Appends to `to` the elements of `from` that it lacks, up to `end`.
template <class T> void appendMissing(std::vector<T>& to, const std::vector<T>& from, std::size_t end)
{
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(to.size()),
              from.begin() + static_cast<std::ptrdiff_t>(end));
}

} // namespace

/// Stands between the builder and the writer.
class LiveBuild::Watch final : public HistorySink {
public:
    Watch(LiveBuild& live, HistorySink& next) : live_(live), next_(next) {}

    Status begin(const HistoryTraits& traits) override
    {
        {
            const std::lock_guard lock(live_.mutex_);
            live_.history_.traits = traits;
        }
        return next_.begin(traits);
    }
    Status add(const HistoryStep& step) override
    {
        live_.record(step);
        return next_.add(step);
    }
    Status finish(float finalKey) override { return next_.finish(finalKey); }

private:
    LiveBuild& live_;
    HistorySink& next_;
};

std::unique_ptr<HistorySink> LiveBuild::watch(HistorySink& next, const Dataset& dataset,
                                              const ModelDescription& description)
{
    const std::lock_guard lock(mutex_);
    dataset_ = dataset;
    description_ = description;
    return std::make_unique<Watch>(*this, next);
}

void LiveBuild::record(const HistoryStep& step)
{
    const std::lock_guard lock(mutex_);
    if (full_)
        return;
    if (step.keyBefore < runningKey_) {
        runningKey_ = step.keyBefore;
        completeSteps_ = history_.steps.size();
        full_ = history_.stars.size() > mostTetrahedra_;
    }
    history_.stars.insert(history_.stars.end(), step.star.begin(), step.star.end());
    history_.destroyed.insert(history_.destroyed.end(), step.destroyed.begin(), step.destroyed.end());
    history_.steps.push_back({step.point, step.keyBefore, history_.stars.size(), history_.destroyed.size()});
}

std::optional<float> LiveBuild::catchUp()
{
    const std::lock_guard lock(mutex_);
    if (!dataset_ || completeSteps_ <= seen_.steps.size())
        return std::nullopt;
    const Step& last = history_.steps[completeSteps_ - 1];
    seen_.traits = history_.traits;
    appendMissing(seen_.stars, history_.stars, last.starEnd);
    appendMissing(seen_.destroyed, history_.destroyed, last.destroyedEnd);
    appendMissing(seen_.steps, history_.steps, completeSteps_);
    return runningKey_;
}

Result<std::shared_ptr<const Model>> LiveBuild::look(const std::filesystem::path& path)
{
    const std::optional<float> key = catchUp();
    if (!key)
        return std::shared_ptr<const Model>();
    const auto writer = ModelWriter::create(path, *dataset_, description_);
    if (!writer)
        return writer.error();
    if (const Status begun = (*writer)->begin(seen_.traits); !begun)
        return begun.error();
    std::size_t star = 0;
    std::size_t destroyed = 0;
    for (const Step& step : seen_.steps) {
        const HistoryStep whole{step.point, step.keyBefore, std::span(seen_.stars).subspan(star, step.starEnd - star),
                                std::span(seen_.destroyed).subspan(destroyed, step.destroyedEnd - destroyed)};
        if (const Status added = (*writer)->add(whole); !added)
            return added.error();
        star = step.starEnd;
        destroyed = step.destroyedEnd;
    }
    if (const Status finished = (*writer)->finish(*key); !finished)
        return finished.error();
    return Model::open(path);
}

} // namespace tetra
