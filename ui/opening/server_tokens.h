// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <map>
#include <mutex>

namespace tetra {

/// What servers want to be shown before they answer, until the program ends; it is written nowhere. From any thread.
class ServerTokens {
public:
    /// The token for the server of the address `place`.
    void set(const QString& place, const QString& token);
    /// Empty if there is none.
    QString of(const QString& place) const;

private:
    mutable std::mutex mutex_; ///< guards the next one
    std::map<QString, QString> tokens_;
};

} // namespace tetra
