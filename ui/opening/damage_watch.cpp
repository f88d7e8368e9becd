// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/damage_watch.h"

namespace tetra {
namespace {

constexpr int timeBetweenChecks = 700; // milliseconds

} // namespace

DamageWatch::DamageWatch(Session& session) : session_(session)
{
    connect(&session_, &Session::modelChanged, this, &DamageWatch::restart);
    connect(&session_, &Session::modelGrown, this, &DamageWatch::restart);
    connect(&checking_, &QTimer::timeout, this, &DamageWatch::check);
    checking_.setInterval(timeBetweenChecks);
}

void DamageWatch::restart()
{
    if (session_.model())
        checking_.start();
    else
        checking_.stop();
}

void DamageWatch::check()
{
    const Status found = session_.model()->foundDamage();
    if (found)
        return;
    checking_.stop();
    emit damageFound(found.error());
}

} // namespace tetra
