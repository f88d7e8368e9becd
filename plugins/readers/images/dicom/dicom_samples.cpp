// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/dicom/dicom_header.h"

#include <gdcmByteValue.h>
#include <gdcmImage.h>
#include <gdcmReader.h>

#include <algorithm>

namespace tetra {
namespace {

gdcm::Image imageOf(const DicomHeader& header, const gdcm::File& file, const gdcm::DataElement& pixels)
{
    gdcm::Image image;
    image.SetNumberOfDimensions(header.frames.size() > 1 ? 3 : 2);
    image.SetDimension(0, static_cast<unsigned>(header.columns));
    image.SetDimension(1, static_cast<unsigned>(header.rows));
    if (header.frames.size() > 1)
        image.SetDimension(2, static_cast<unsigned>(header.frames.size()));
    image.SetPixelFormat(gdcm::PixelFormat(
        1, static_cast<unsigned short>(header.allocatedBits), static_cast<unsigned short>(header.storedBits),
        static_cast<unsigned short>(header.highBit), static_cast<unsigned short>(header.isSigned ? 1 : 0)));
    image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2); // values stay as they are
    const gdcm::TransferSyntax& syntax = file.GetHeader().GetDataSetTransferSyntax();
    image.SetTransferSyntax(syntax);
    image.SetNeedByteSwap(syntax == gdcm::TransferSyntax::ImplicitVRBigEndianPrivateGE);
    image.SetDataElement(pixels);
    return image;
}

} // namespace

Result<std::vector<char>> dicomSamples(const DicomHeader& header)
{
    const std::size_t needed = header.rows * header.columns * header.frames.size() * (header.allocatedBits / 8);
    const Error notAll = {ErrorKind::BadInput, Message::say("some of its pixels are missing. Copy the file again.")};
    gdcm::Reader reader;
    reader.SetFileName(header.path.c_str());
    const gdcm::Tag tag(0x7fe0, 0x0010);
    if (!reader.Read() || !reader.GetFile().GetDataSet().FindDataElement(tag))
        return notAll;
    const gdcm::DataElement& pixels = reader.GetFile().GetDataSet().GetDataElement(tag);
    const auto syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
    if (const gdcm::ByteValue* native = pixels.GetByteValue();
        native != nullptr && syntax != gdcm::TransferSyntax::ImplicitVRBigEndianPrivateGE) {
        if (native->GetPointer() == nullptr || static_cast<std::size_t>(native->GetLength()) < needed)
            return notAll;
        return std::vector<char>(native->GetPointer(), native->GetPointer() + needed);
    }
    const gdcm::Image image = imageOf(header, reader.GetFile(), pixels);
    std::vector<char> samples(needed);
    if (image.GetBufferLength() != needed || !image.GetBuffer(samples.data()))
        return Error{ErrorKind::BadInput,
                     Message::say("GDCM cannot unpack its pixels (%1). They are damaged, or of a kind that it does not "
                                  "support: unpack them with the program that wrote them.",
                                  printable(gdcm::TransferSyntax::GetTSString(syntax)))};
    return samples;
}

} // namespace tetra
