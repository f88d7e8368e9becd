// SPDX-License-Identifier: GPL-3.0-or-later
// In the place of the other sources of this folder where libtiff is missing.
#include "plugins/readers/images/tiff/tiff_source.h"

namespace tetra {

Result<ReadAnswer> answerTiff(const ImagesRequest&, const TellProgress&)
{
    return Error{ErrorKind::BadInput, Message::say("this TAn was built without libtiff, which reads TIFF. Rebuild it "
                                                   "after 'apt install libtiff-dev', or convert the file to NRRD.")};
}

} // namespace tetra
