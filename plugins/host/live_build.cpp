// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/live_build.h"

#include "core/history/model_writer.h"

#include <span>
#include <utility>

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
            if (live_.shown_ > 0)
                live_.beginAnew({});
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

/// Takes a mesh, if it is not too large.
class LiveBuild::Shown final : public HistorySink {
public:
    explicit Shown(std::size_t mostTetrahedra) : mostTetrahedra_(mostTetrahedra) {}

    Status begin(const HistoryTraits& traits) override
    {
        history.traits = traits;
        return {};
    }
    Status add(const HistoryStep& step) override
    {
        history.add(step);
        if (history.stars.size() <= mostTetrahedra_)
            return {};
        return Error{ErrorKind::OutOfResource, Message::say("The mesh is too large to be shown.")};
    }
    Status finish(float finalKey) override
    {
        key = finalKey;
        return {};
    }

    History history;
    float key = 0;

private:
    std::size_t mostTetrahedra_;
};

void LiveBuild::show(const std::function<Status(HistorySink& history)>& hand)
{
    Shown mesh(mostTetrahedra_);
    if (!hand(mesh))
        return;
    const std::lock_guard lock(mutex_);
    beginAnew(std::move(mesh.history));
    runningKey_ = mesh.key;
    completeSteps_ = history_.steps.size();
}

void LiveBuild::beginAnew(History history)
{
    history_ = std::move(history);
    runningKey_ = std::numeric_limits<float>::infinity();
    completeSteps_ = 0;
    ++shown_;
}

void LiveBuild::History::add(const HistoryStep& step)
{
    stars.insert(stars.end(), step.star.begin(), step.star.end());
    destroyed.insert(destroyed.end(), step.destroyed.begin(), step.destroyed.end());
    steps.push_back({step.point, step.keyBefore, stars.size(), destroyed.size()});
}

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
    history_.add(step);
}

std::optional<float> LiveBuild::catchUp()
{
    const std::lock_guard lock(mutex_);
    const bool isAnew = shown_ != seenShown_;
    if (!dataset_ || completeSteps_ <= (isAnew ? 0 : seen_.steps.size()))
        return std::nullopt;
    if (isAnew)
        seen_ = {};
    seenShown_ = shown_;
    const Step& last = history_.steps[completeSteps_ - 1];
    seen_.traits = history_.traits;
    appendMissing(seen_.stars, history_.stars, last.starEnd);
    appendMissing(seen_.destroyed, history_.destroyed, last.destroyedEnd);
    appendMissing(seen_.steps, history_.steps, completeSteps_);
    return runningKey_;
}

std::optional<double> LiveBuild::error()
{
    const std::lock_guard lock(mutex_);
    if ((completeSteps_ == 0 && shown_ == 0) || !dataset_)
        return std::nullopt;
    const double extent = dataset_->values.range().extent();
    return extent > 0 ? 100 * runningKey_ / extent : 0;
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
