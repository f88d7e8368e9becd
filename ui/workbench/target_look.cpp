// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/target_look.h"

#include "plugins/host/input_file.h"
#include "plugins/host/interrupted_build.h"

#include <system_error>
#include <utility>

namespace tetra {

TargetFacts lookAtTarget(const std::filesystem::path& target)
{
    std::error_code problem;
    const bool exists = !target.empty() && std::filesystem::exists(target, problem);
    return {exists, exists && std::filesystem::is_regular_file(target, problem) && isModelFile(target),
            interruptedNote(target)};
}

TargetLook::TargetLook(Look look, QObject* parent) : QObject(parent), look_(std::move(look)) {}

void TargetLook::begin(const std::filesystem::path& target)
{
    facts_.reset();
    answer_.ask(
        *this, [look = look_, target](const std::stop_token&) { return look(target); },
        [this](const TargetFacts& facts) {
            facts_ = facts;
            emit found();
        });
}

} // namespace tetra
