// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for the JSON text of a transfer function; what is read comes back from its text.
#include "tests/fuzz/fuzz_input.h"

#include <tan/transfer.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    const auto function = transferFunctionFromText(asText(bytes, size));
    if (!function) {
        requireText(function.error());
        return 0;
    }
    require(checkTransferFunction(*function).ok(), "what is read is a transfer function");
    const auto again = transferFunctionFromText(transferFunctionToText(*function));
    require(again && *again == *function, "a transfer function comes back");
    return 0;
}
