// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/server_tokens.h"

#include <tan/open.h>

#include <QUrl>

namespace tetra {
namespace {

/// "http://host:8080" of an address.
QString serverOf(const QString& place)
{
    const QUrl address(QString::fromStdString(placeOf(place.toStdString(), false)));
    return address.scheme() + "://" + address.authority();
}

} // namespace

void ServerTokens::set(const QString& place, const QString& token)
{
    const std::lock_guard lock(mutex_);
    tokens_[serverOf(place)] = token;
}

QString ServerTokens::of(const QString& place) const
{
    const std::lock_guard lock(mutex_);
    const auto found = tokens_.find(serverOf(place));
    return found != tokens_.end() ? found->second : QString();
}

} // namespace tetra
