// SPDX-License-Identifier: GPL-3.0-or-later
// In place of this folder's sources that need libcurl where the option TAN_NETWORK is off: addresses are refused.
#include "core/remote/address.h"
#include "core/remote/fetch.h"
#include "core/remote/remote_file.h"

namespace tetra {

namespace {

Error withoutNetwork(std::string_view address)
{
    const std::string shown = shownAddress(address);
    return {ErrorKind::WrongUsage,
            Message::say("This TAn was built without the network (TAN_NETWORK), so it cannot open '%1'. Download the "
                         "file and open the copy.",
                         shown),
            shown};
}

} // namespace

std::string addressWithoutUser(std::string_view /*address*/, AddressPart /*part*/)
{
    return {};
}

Result<FetchedAnswer> ServerConnection::fetch(const std::string& address, const std::string& /*token*/,
                                              const FetchLimits& /*limits*/, const Progress& /*progress*/)
{
    return withoutNetwork(address);
}

Result<FetchedAnswer> fetchOnce(const std::string& address, const std::string& /*token*/, const FetchLimits& /*limits*/,
                                const Progress& /*progress*/)
{
    return withoutNetwork(address);
}

bool isUnauthorized(const Error& error)
{
    return error.wants != Credential::None;
}

// There is no RemoteFile, whatever it is asked.

class RemoteFile::Shared {
public:
    std::string address;
};

Result<RemoteFile> RemoteFile::open(std::string_view address, const CacheFolder& /*cache*/,
                                    const RemoteOptions& /*options*/, const Progress& /*progress*/)
{
    return withoutNetwork(address);
}

const std::string& RemoteFile::address() const noexcept
{
    return shared_->address;
}

std::uint64_t RemoteFile::size() const noexcept
{
    return 0;
}

std::string RemoteFile::state() const
{
    return {};
}

ByteSource RemoteFile::source() const
{
    return {};
}

RemoteCounts RemoteFile::counts() const
{
    return {};
}

void RemoteFile::forget() const {}

} // namespace tetra
