// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for the text of an error field, asks the field, and reads it again from its own text.
#include "tests/fuzz/fuzz_input.h"

#include <tan/query.h>

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    const auto field = parseErrorField(asText(bytes, size));
    if (!field) {
        requireText(field.error());
        return 0;
    }
    const Eigen::Vector3d place(1, 2, 3);
    const double error = field->at(place, 50);
    require(error >= 0, "an error is a number, and not negative");
    require(field->bounds().minimum <= error && error <= field->bounds().maximum, "bounds hold");
    const std::array corners = {place, Eigen::Vector3d(1, 2, 4), Eigen::Vector3d(1, 4, 3), Eigen::Vector3d(5, 2, 3)};
    require(field->leastIn(corners, 0, {40, 60}) <= error, "the least is no more than what is there");
    const auto again = parseErrorField(toText(*field));
    require(again && *again == *field, "a field comes back");
    return 0;
}
