// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dependency_order.h"

#include <algorithm>
#include <map>

namespace tetra {
namespace {

class DepthFirst {
public:
    explicit DepthFirst(const std::vector<Dependent>& dependents) : dependents_(dependents), seen_(dependents.size())
    {
        for (std::size_t index = 0; index < dependents.size(); ++index)
            indices_.emplace(dependents[index].id, index);
        result_.errors.resize(dependents.size());
    }

    DependencyOrder run()
    {
        for (std::size_t index = 0; index < dependents_.size(); ++index)
            visit(index);
        return std::move(result_);
    }

private:
    void visit(std::size_t index)
    {
        if (seen_[index])
            return;
        seen_[index] = true;
        path_.push_back(index);
        for (const std::string& id : dependents_[index].requiredIds)
            require(index, id);
        path_.pop_back();
        if (result_.errors[index].empty())
            result_.order.push_back(index);
    }

    void require(std::size_t index, const std::string& id)
    {
        const auto found = indices_.find(id);
        if (found == indices_.end())
            return fail(
                index, Message::say("It needs the plugin \"%1\", which is missing or cannot be used. Install it.", id));
        const std::size_t required = found->second;
        if (const auto start = std::ranges::find(path_, required); start != path_.end())
            return failCircle(start);
        visit(required);
        if (!result_.errors[required].empty())
            fail(index,
                 Message::say("It needs the plugin \"%1\", which cannot be used: %2", id, result_.errors[required]));
    }

    void failCircle(std::vector<std::size_t>::const_iterator start)
    {
        std::string circle;
        for (auto at = start; at != path_.end(); ++at)
            circle += "\"" + dependents_[*at].id + "\" > ";
        circle += "\"" + dependents_[*start].id + "\"";
        for (auto at = start; at != path_.end(); ++at)
            fail(*at, Message::say("Plugins depend on each other in a circle: %1. Remove one of them.", circle));
    }

    void fail(std::size_t index, const Message& text)
    {
        if (result_.errors[index].empty())
            result_.errors[index] = text;
    }

    const std::vector<Dependent>& dependents_;
    std::map<std::string, std::size_t> indices_;
    std::vector<bool> seen_;
    std::vector<std::size_t> path_; ///< from the first one visited to the one being visited now
    DependencyOrder result_;
};

} // namespace

DependencyOrder dependencyOrder(const std::vector<Dependent>& dependents)
{
    return DepthFirst(dependents).run();
}

} // namespace tetra
