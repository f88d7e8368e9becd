// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/stream_output.h"

#include "core/base/system_error.h"

#include <algorithm>
#include <cerrno>
#include <climits>

#include <poll.h>
#include <unistd.h>

namespace tetra {
namespace {

constexpr std::size_t bytesAtOnce = 1 << 18;

Error cannotStream(const std::filesystem::path& name, int systemError)
{
    if (systemError == EPIPE)
        return {ErrorKind::CannotWrite,
                Message::say("Cannot write '%1': the program that reads it has ended. Look at its messages.",
                             name.string())};
    return {ErrorKind::CannotWrite,
            Message::say("Cannot write '%1': %2.", name.string(), systemErrorText(systemError))};
}

/// Whether the descriptor takes more within a moment, or says what is wrong with it.
bool isReady(int descriptor)
{
    constexpr int milliseconds = 200;
    pollfd waiting{descriptor, POLLOUT, 0};
    return ::poll(&waiting, 1, milliseconds) > 0;
}

} // namespace

Status StreamOutput::bytes(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const std::size_t size = std::min(bytes.size(), bytesAtOnce - piece_.size());
        piece_.insert(piece_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        bytes = bytes.subspan(size);
        if (piece_.size() == bytesAtOnce)
            if (const Status written = flush(); !written)
                return written;
    }
    return {};
}

Status StreamOutput::flush()
{
    if (const Status written = put(piece_); !written)
        return written;
    written_ += piece_.size();
    piece_.clear();
    if (expected_ > 0)
        progress_.report(std::min(1.0, static_cast<double>(written_) / static_cast<double>(expected_)), activity_);
    return {};
}

/// A pipe that is ready takes this much without waiting, so that a reader who has stopped does not keep the program
/// from being cancelled.
Status StreamOutput::put(std::span<const std::byte> bytes)
{
    constexpr std::size_t most = PIPE_BUF;
    while (!bytes.empty()) {
        if (progress_.cancelled())
            return cancelledError(activity_);
        if (!isReady(descriptor_))
            continue;
        const ssize_t written = ::write(descriptor_, bytes.data(), std::min(bytes.size(), most));
        if (written >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        else if (errno != EINTR && errno != EAGAIN)
            return cannotStream(name_, errno);
    }
    return {};
}

Result<OutputFile*> StreamOutput::another(const std::filesystem::path& target)
{
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' would be a second file next to '%2'. Give the output a name instead of '-'.",
                              target.filename().string(), name_.string())};
}

} // namespace tetra
