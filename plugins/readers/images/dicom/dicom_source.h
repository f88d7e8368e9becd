// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/reading_program.h"
#include "plugins/readers/images/images_request.h"

namespace tetra {

/// Answers a request about a DICOM file: the series that it belongs to, of which the other files lie in its folder. The
/// error says what is wrong with "it". May throw std::bad_alloc.
Result<ReadAnswer> answerDicom(const ImagesRequest& request, const TellProgress& progress);

} // namespace tetra
