// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/builder.h>
#include <plugins/api/plugin.h>
#include <plugins/api/threshold_parameters.h>

#include <limits>

namespace {
using namespace tetra;

/// Stands between a refinement and the model, and lets the steps through that lead to the best mesh of no more than
/// `most` points. A point may make a mesh worse before others make it better: steps wait until the mesh after them is
/// better than all before.
class Budget : public HistorySink {
public:
    Budget(HistorySink& model, std::uint64_t most, const Progress& progress)
        : model_(model), most_(most), progress_(progress)
    {
    }

    bool spent() const { return spent_; }
    std::uint64_t points() const { return points_; }
    /// Of the best mesh, in units of the values; infinite as long as there is none.
    float error() const { return error_; }

    Status begin(const HistoryTraits& traits) override { return model_.begin(traits); }
    /// The spans of `step` are valid in this call only.
    Status add(const HistoryStep& step) override
    {
        if (const Status through = letThrough(step.keyBefore); !through)
            return through;
        spent_ = points_ + waiting_.size() == most_;
        if (spent_) // an error, whatever it says, ends the refinement
            return cancelledError(Message::marked("The refinement"));
        waiting_.push_back(
            {step, {step.star.begin(), step.star.end()}, {step.destroyed.begin(), step.destroyed.end()}});
        return {};
    }
    Status finish(float finalKey) override
    {
        const Status through = letThrough(finalKey);
        return through ? model_.finish(error_) : through;
    }

private:
    struct Step {
        HistoryStep step;
        std::vector<HistoryTetrahedron> star;
        std::vector<std::uint32_t> destroyed;
    };

    /// `key` is that of the mesh after all steps that wait.
    Status letThrough(float key)
    {
        if (!(key < error_))
            return {};
        for (const auto& [step, star, destroyed] : waiting_)
            if (const Status added = model_.add({step.point, step.keyBefore, star, destroyed}); !added)
                return added;
        points_ += waiting_.size();
        waiting_.clear();
        error_ = key;
        if (points_ % 64 == 0)
            progress_.report(double(points_) / double(most_), Message::marked("Refining"));
        return {};
    }

    HistorySink& model_;
    std::uint64_t most_;
    Progress progress_;
    std::vector<Step> waiting_;
    std::uint64_t points_ = 0; ///< let through
    float error_ = std::numeric_limits<float>::infinity();
    bool spent_ = false;
};
} // namespace

/// Refines the whole dataset in memory until the points are spent.
class BudgetBuilder : public tetra::Builder {
public:
    Acceptance accepts(const Dataset& dataset) const override
    {
        if (canWarp(dataset.domain)) // whose inverted cells it would have to count in a mesh that it does not see
            return {0, Message::say("It takes regular lattices and scattered points.")};
        if (const Status possible = checkRefinement(dataset); !possible)
            return {0, possible.error().message};
        return {0.2, Message::say("Refinement that ends with a number of points, so that the model's size is known.")};
    }
    std::vector<Parameter> parameters() const override
    {
        Parameter points;
        points.id = "points";
        points.label = Message::marked("Points");
        points.explanation = Message::marked("The model has no more points than that.");
        points.defaultValue = std::int64_t{10'000};
        points.minimum = 8;
        points.maximum = 1e9;
        return {points, errorThresholdParameter(Message::marked("Where fewer points are enough for this error, they "
                                                                "are all; 0 takes as many as there may be."))};
    }

    Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                              const Progress& progress) const override
    {
        const auto most = std::uint64_t(parameterValue<std::int64_t>(parameters(), values, "points"));
        const double error = parameterValue<double>(parameters(), values, "error");
        Budget budget(target.history, most, progress);
        BuildTarget budgeted{.history = budget};
        const auto report = buildInto(dataset, Refinement{.error = error, .block = 0}, budgeted,
                                      progress.withCallback({})); // how far it is, the budget tells
        if (!budget.spent())
            return report;
        if (budget.points() == 0)
            return Error{ErrorKind::BadInput,
                         Message::say("A mesh of known error has more than %1 points. Allow more of them.", most)};
        if (const Status finished = target.history.finish(budget.error()); !finished)
            return finished.error();
        return BuildReport{}; // the sites and the tetrahedra are counted in the file
    }
};

TAN_PLUGIN(BudgetBuilder, tetra::Builder)
