// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/reading_program.h"
#include "plugins/readers/images/images_request.h"

namespace tetra {

/// Answers a request about a TIFF file: a volume of its pages, or of the files beside it that are numbered alike. The
/// error says what is wrong with "it". May throw std::bad_alloc.
Result<ReadAnswer> answerTiff(const ImagesRequest& request, const TellProgress& progress);

} // namespace tetra
