// SPDX-License-Identifier: GPL-3.0-or-later
// In the place of the other sources of this folder where GDCM is missing.
#include "plugins/readers/images/dicom/dicom_source.h"

namespace tetra {

Result<ReadAnswer> answerDicom(const ImagesRequest&, const TellProgress&)
{
    return Error{ErrorKind::BadInput, Message::say("this TAn was built without GDCM, which reads DICOM. Rebuild it "
                                                   "after 'apt install libgdcm-dev', or convert the file to NRRD.")};
}

} // namespace tetra
