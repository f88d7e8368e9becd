// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/drawing/pdf_page.h"

namespace tetra {

bool writesPdf()
{
    return false;
}

Result<std::vector<std::byte>> pdfOf(const Picture&, const VectorDrawing&, const PdfFacts&)
{
    return Error{ErrorKind::OutOfResource, Message::say("This TAn was built without cairo, which writes PDF files. "
                                                        "Save the picture as PNG.")};
}

} // namespace tetra
