// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/reading.h"

#include "ui/session/message_text.h"

namespace tetra {

void Reading::start(LongTask::Work work)
{
    emit aboutToRead();
    task_.start(std::move(work));
}

void Reading::passGate(bool isModel, const std::function<void()>& go, const std::function<void()>& stay) const
{
    if (gate_)
        gate_(isModel, go, stay);
    else
        go();
}

void Reading::tell(const Error& error)
{
    if (error.kind != ErrorKind::Cancelled)
        emit failed(translatedMessage(error.message));
}

std::function<void()> Reading::tellLater(const Error& error)
{
    return [this, error] { tell(error); };
}

} // namespace tetra
