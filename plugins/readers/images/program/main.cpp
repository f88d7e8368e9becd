// SPDX-License-Identifier: GPL-3.0-or-later
// The program in which GDCM and libtiff read a file for the plugin: takes one request from its input and writes
// messages to its output (plugins/process/exchange.h). It may break down: the plugin bears that.
#include "plugins/process/reading_program.h"
#include "plugins/readers/images/dicom/dicom_source.h"
#include "plugins/readers/images/tiff/tiff_source.h"

namespace tetra {
namespace {

Result<ReadAnswer> answer(const ImagesRequest& request, const TellProgress& progress)
{
    return request.format == ImagesFormat::Dicom ? answerDicom(request, progress) : answerTiff(request, progress);
}

} // namespace
} // namespace tetra

int main()
{
    using namespace tetra;
    std::string library; // known when the request is
    return runReadingProgram(library, [&library](RequestInput& input) -> AnswerRequest {
        ImagesRequest request;
        exchange(input.input, request);
        input.file = request.path;
        library = request.format == ImagesFormat::Dicom ? "GDCM" : "libtiff";
        return [request](const TellProgress& progress) { return answer(request, progress); };
    });
}
