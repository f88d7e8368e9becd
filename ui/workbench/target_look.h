// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/work/latest_answer.h"

#include <QObject>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tetra {

/// What is there already where a model is to be written.
struct TargetFacts {
    bool exists = false;
    bool isModel = false; ///< isModelFile()
    std::string note{};   ///< interruptedNote(): of a build that was interrupted
};

/// Looks, in this thread. Keeps others from building there meanwhile.
TargetFacts lookAtTarget(const std::filesystem::path& target);

/// Looks at where a model is to be in a worker, at each letter that is typed: a folder on a server that does not answer
/// holds up nobody.
class TargetLook : public QObject {
    Q_OBJECT
public:
    using Look = std::function<TargetFacts(const std::filesystem::path&)>;
    explicit TargetLook(Look look = &lookAtTarget, QObject* parent = nullptr);

    /// Ends with found(), unless another look begins first.
    void begin(const std::filesystem::path& target);
    bool running() const noexcept { return answer_.isWaiting(); }
    /// Of the last look; nothing while one runs.
    const std::optional<TargetFacts>& facts() const noexcept { return facts_; }

signals:
    void found();

private:
    Look look_;
    std::optional<TargetFacts> facts_;
    LatestAnswer<TargetFacts> answer_;
};

} // namespace tetra
