// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/opening/served_model.h"
#include "ui/work/latest_job.h"

#include <QObject>
#include <QString>

#include <cstdint>

namespace tetra {

/// Asks servers in a worker what they offer; the newest question counts.
class AddressProbe : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    void request(const QString& address, const QString& token);
    /// Nothing that was asked before is answered any more.
    void cancel();

signals:
    /// Of the newest request.
    void probed(const tetra::Result<tetra::ServerOffer>& offer);

private:
    std::uint64_t newest_ = 0;
    LatestJob job_; ///< last: ends before what it uses
};

} // namespace tetra
