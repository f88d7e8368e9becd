// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tetra {

/// Sets libcurl's own data up, once in a process; false if that fails.
bool isCurlReady();

/// The file of the certificates that are trusted: what SSL_CERT_FILE names; nothing where libcurl knows one that is
/// there; otherwise where other systems than that of its build keep theirs.
std::string trustedCertificates();

} // namespace tetra
