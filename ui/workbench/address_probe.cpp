// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/address_probe.h"

namespace tetra {

void AddressProbe::request(const QString& address, const QString& token)
{
    job_.submit([this, address = address.toStdString(), token = token.toStdString(),
                 number = ++newest_](const std::stop_token& stop) {
        const auto offer = askServer(address, token, Progress(stop, {}));
        QMetaObject::invokeMethod(
            this,
            [this, offer, number] {
                if (number == newest_)
                    emit probed(offer);
            },
            Qt::QueuedConnection);
    });
}

void AddressProbe::cancel()
{
    ++newest_;
    job_.cancel();
}

} // namespace tetra
