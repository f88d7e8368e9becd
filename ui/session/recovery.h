// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QLockFile>
#include <QString>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A session that a program left behind which did not end as it should.
struct LostSession {
    std::filesystem::path path;
    std::string text; ///< sessionToText()
};

/// Keeps the session of one running program in a file of its own, that goes when the program ends as it should. Others
/// that run at the same time have theirs. A file whose program is gone is a lost session.
class Recovery {
public:
    /// `folder` is made when it is needed.
    explicit Recovery(std::filesystem::path folder);
    /// Removes the file.
    ~Recovery();
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;

    const std::filesystem::path& folder() const noexcept { return folder_; }
    /// Whole or not at all. Not from two threads at once.
    Status keep(std::string_view text);
    /// There is nothing to keep any more.
    void forget();

private:
    bool lock();

    std::filesystem::path folder_;
    QString file_;
    std::unique_ptr<QLockFile> lock_; ///< held as long as the file belongs to this program
};

/// The sessions that were lost in this folder, newest first. What is no session, or cannot be read, is left out.
std::vector<LostSession> lostSessions(const std::filesystem::path& folder);

/// Removes a lost session's file: it was restored, or is not wanted.
void removeLostSession(const LostSession& session);

/// Where this user's programs keep them.
std::filesystem::path recoveryFolder();

} // namespace tetra
