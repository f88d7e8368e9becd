# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes of medicine: NIfTI by nibabel, DICOM by pydicom, MetaImage and NRRD byte by byte."""
import gzip
import zlib

import numpy

from bench import add, of_grid
from samples import FRAMES, ORIGIN, SIZE, SPACING, Grid, grid, library, numbers, placed, wave

nibabel = library("nibabel")
pydicom = library("pydicom")
pydicom_uid = library("pydicom.uid")
pydicom_dataset = library("pydicom.dataset")

TYPES = ("u1", "i1", "<u2", "<i2", "<u4", "<i4", "<f4", "<f8")
ORDERED = ("<i2", ">i2", "<f4", ">f4", "<f8", ">f8", ">u2", ">i4")


# NIfTI: world = sform (i, j, k), else qform, else pixdim alone; right-anterior-superior.

NIFTI_CLASSES = {("NIfTI-1", False): "Nifti1Image", ("NIfTI-1", True): "Nifti1Pair", ("NIfTI-2", False): "Nifti2Image", ("NIfTI-2", True): "Nifti2Pair"}


def nifti(folder, format="NIfTI-1", frame="offset", dtype="<f4", by="sform", ending=".nii", slope=None, volumes=1, unit="mm", options=(), take=0, **said):
    kind = getattr(nibabel, NIFTI_CLASSES[format, ending == ".hdr"])
    whole = grid(frame, dtype)
    all_of = [numbers(wave(whole.places, variant), dtype) for variant in range(volumes)]
    stored = all_of[0] if volumes == 1 else numpy.stack(all_of, axis=-1)
    header = kind.header_class(endianness="<" if numpy.dtype(dtype).byteorder in "=<|" else ">")
    header.set_data_dtype(dtype)
    matrix = numpy.eye(4)
    matrix[:3, :3], matrix[:3, 3] = whole.steps, whole.origin
    header.set_data_shape(stored.shape)
    header.set_zooms([*whole.spacing, *([0.5] if volumes > 1 else [])])
    if "qform" in by:
        header.set_qform(matrix, code=1)
    if by in ("sform", "sform before qform"):
        header.set_sform(matrix, code=2)
    if by == "sform before qform":
        header.set_qform(numpy.diag((5.0, 5, 5, 1)), code=1)
        header["pixdim"][1:4] = whole.spacing
    header.set_xyzt_units(unit, "sec")
    image = kind(stored, None, header)
    image.header.set_data_dtype(dtype)
    nibabel.save(image, str(folder / f"volume{ending}"))
    values = all_of[take].astype(float)
    if slope:  # into the header of what nibabel wrote, which would choose others
        with open(folder / f"volume{ending}", "r+b") as file:
            file.seek(112)
            file.write(numpy.array(slope, header.endianness + "f4").tobytes())
        values = values * numpy.float64(numpy.float32(slope[0])) + numpy.float64(numpy.float32(slope[1]))
    whole.values = values
    whole.steps, whole.origin = whole.steps.astype("f4").astype(float), whole.origin.astype("f4").astype(float)
    if by == "pixdim":
        whole.origin = numpy.zeros(3)
    whole.places = placed(whole.steps, whole.origin)
    return of_grid(folder / f"volume{ending}", whole, options, place_slack=2e-6 if "qform" in by else 1e-7, value_slack=1e-6 if slope else 0, **said)


for name in FRAMES:
    add("NIfTI-1", "places", f"sform {name}", nifti, frame=name, quick=name == "oblique, mirrored")
for name in ("offset", "mirrored", "turned half", "permuted", "exchanged", "oblique", "oblique twice", "oblique, mirrored"):
    add("NIfTI-1", "places", f"qform {name}", nifti, frame=name, by="qform")
add("NIfTI-1", "places", "pixdim alone", nifti, by="pixdim", frame=(SPACING, (0, 0, 0)), taken={"frame": "pixdim|spacing"})
add("NIfTI-1", "places", "sform counts before qform", nifti, frame="mirrored", by="sform before qform", taken={"frame": "sform"})
add("NIfTI-1", "places", "qform is told", nifti, frame="oblique", by="qform", taken={"frame": "qform"})
add("NIfTI-1", "places", "micrometres", nifti, unit="micron", frame="permuted")
for dtype in ("u1", "i1", "<u2", "<i2", "<u4", "<i4", "<i8", "<u8", "<f4", "<f8"):
    add("NIfTI-1", "numbers", dtype, nifti, dtype=dtype, frame="mirrored")
for dtype in ("<i2", "u1", ">i2"):
    add("NIfTI-1", "numbers", f"{dtype} with slope and intercept", nifti, dtype=dtype, slope=(0.25, -12.5))
add("NIfTI-1", "numbers", "negative slope", nifti, dtype="<i2", slope=(-0.3, 1000))
for dtype in (">u2", ">i2", ">i4", ">f4", ">f8"):
    add("NIfTI-1", "storage", f"big endian {dtype}", nifti, dtype=dtype, frame="oblique")
for format in ("NIfTI-1", "NIfTI-2"):
    for ending in (".nii.gz", ".hdr"):
        add(format, "storage", f"*{ending}", nifti, format=format, ending=ending, frame="permuted", dtype="<i2")
for name in ("offset", "mirrored", "oblique", "sheared"):
    add("NIfTI-2", "places", f"sform {name}", nifti, format="NIfTI-2", frame=name)
add("NIfTI-2", "places", "qform oblique twice", nifti, format="NIfTI-2", frame="oblique twice", by="qform")
for dtype in ("u1", "<i2", "<f4", "<f8"):
    add("NIfTI-2", "numbers", dtype, nifti, format="NIfTI-2", dtype=dtype)
add("NIfTI-2", "storage", "big endian >f4", nifti, format="NIfTI-2", dtype=">f4", frame="oblique")
add("NIfTI-1", "steps", "the first of 3 volumes", nifti, volumes=3, taken={"step": "1 of 3"}, guessed=("step",), left_out=("3|other",))
add("NIfTI-1", "steps", "the second of 3 volumes", nifti, volumes=3, options=("--time", "2"), take=1, taken={"step": "2 of 3"})
add("NIfTI-2", "steps", "the third of 3 volumes", nifti, format="NIfTI-2", volumes=3, options=("--time", "3"), take=2)


# MetaImage: row a of TransformMatrix is the direction of axis a; left-posterior-superior.

META_TYPES = {name: f"MET_{word}" for name, word in {"u1": "UCHAR", "i1": "CHAR", "u2": "USHORT", "i2": "SHORT", "u4": "UINT", "i4": "INT",
              "u8": "ULONG_LONG", "i8": "LONG_LONG", "f4": "FLOAT", "f8": "DOUBLE"}.items()}


def text_of(vector):
    return " ".join(repr(float(number)) for number in numpy.ravel(vector))


def metaimage(folder, frame="offset", dtype="<f4", form="mha", names=("TransformMatrix", "Offset", "ElementSpacing"), binary=True, channels=1,
              options=(), take=0, **said):
    whole = grid(frame, dtype)
    fields = {"ObjectType": "Image", "NDims": 3}
    if binary:
        fields["BinaryData"] = "True"
    fields["BinaryDataByteOrderMSB" if form != "bytes" else "ElementByteOrderMSB"] = numpy.dtype(dtype).byteorder == ">"
    if form == "packed":
        fields["CompressedData"] = "True"
    fields[names[0]], fields[names[1]], fields[names[2]] = text_of(whole.directions.T), text_of(whole.origin), text_of(whole.spacing)
    fields["DimSize"] = " ".join(map(str, SIZE))
    if channels > 1:
        fields["ElementNumberOfChannels"] = channels
    fields["ElementType"] = META_TYPES[numpy.dtype(dtype).str[1:]]
    samples = whole.fastest_first()
    if channels > 1:
        samples = numpy.stack([numbers(wave(whole.places, variant), dtype).transpose(2, 1, 0) for variant in range(channels)], axis=-1)
        whole.values = samples[..., take].transpose(2, 1, 0)
    data = samples.tobytes()
    file = folder / ("volume.mha" if form in ("mha", "packed", "bytes") else "volume.mhd")
    tail = b""
    if form in ("mha", "bytes"):
        fields["ElementDataFile"], tail = "LOCAL", data
    elif form == "packed":
        fields["CompressedDataSize"] = len(zlib.compress(data))
        fields["ElementDataFile"], tail = "LOCAL", zlib.compress(data)
    elif form == "list":
        fields["ElementDataFile"] = "LIST\n" + "\n".join(f"slice{k}.raw" for k in range(SIZE[2]))
    elif form == "pattern":
        fields["ElementDataFile"] = f"slice%d.raw 0 {SIZE[2] - 1} 1"
    elif form == "header to be skipped":
        fields["HeaderSize"] = -1
        fields["ElementDataFile"] = "volume.raw"
        data = b"eleven byte" + data
    else:
        fields["ElementDataFile"] = "volume.raw"
    if form in ("list", "pattern"):
        for k in range(SIZE[2]):
            (folder / f"slice{k}.raw").write_bytes(samples[k].tobytes())
    elif not tail:
        (folder / "volume.raw").write_bytes(data)
    file.write_bytes("".join(f"{name} = {value}\n" for name, value in fields.items()).encode() + tail)
    return of_grid(file, whole, options, **said)


for name in FRAMES:
    add("MetaImage", "places", name, metaimage, frame=name, quick=name == "oblique")
add("MetaImage", "places", "Orientation, Position", metaimage, frame="oblique twice", names=("Orientation", "Position", "ElementSpacing"))
add("MetaImage", "places", "Rotation, Origin", metaimage, frame="exchanged", names=("Rotation", "Origin", "ElementSpacing"))
for dtype in TYPES + ("<i8", "<u8"):
    add("MetaImage", "numbers", dtype, metaimage, dtype=dtype)
for dtype in (">u2", ">i2", ">i4", ">f4", ">f8"):
    add("MetaImage", "storage", f"most significant byte first {dtype}", metaimage, dtype=dtype, frame="permuted")
for form in ("bytes", "packed", "mhd", "list", "pattern", "header to be skipped"):
    add("MetaImage", "storage", form, metaimage, form=form, dtype="<i2")
add("MetaImage", "storage", "no BinaryData", metaimage, form="mhd", binary=False)
for take in (0, 2):
    add("MetaImage", "arrays", f"channel {take} of 3", metaimage, channels=3, options=("--component", take), take=take, taken={"component": str(take)})


# NRRD: the columns of the space directions; as `space` says.

NRRD_TYPES = {"u1": "uint8", "i1": "signed char", "u2": "ushort", "i2": "int16_t", "u4": "unsigned int", "i4": "int", "u8": "uint64", "i8": "longlong",
              "f4": "float", "f8": "double"}


def nrrd(folder, frame="offset", dtype="<f4", encoding="raw", form="nrrd", place="space", components=1, options=(), take=0, space="right-anterior-superior",
         **said):
    whole = grid(frame, dtype)
    samples = whole.fastest_first()
    if components > 1:
        samples = numpy.stack([numbers(wave(whole.places, variant), dtype).transpose(2, 1, 0) for variant in range(components)], axis=-1)
        whole.values = samples[..., take].transpose(2, 1, 0)
    more = f"{components} " if components > 1 else ""
    head = ["NRRD0005", f"type: {NRRD_TYPES[numpy.dtype(dtype).str[1:]]}", f"dimension: {4 if components > 1 else 3}"]
    if place == "space":
        head.append(f"space: {space}")
    head.append(f"sizes: {more}" + " ".join(map(str, SIZE)))
    if components > 1:
        head.append("kinds: vector domain domain domain")
    if place == "space":
        vectors = ["(" + ",".join(repr(float(number)) for number in step) + ")" for step in whole.steps.T]
        head += [f"space directions: {'none ' if components > 1 else ''}" + " ".join(vectors), f"space origin: ({','.join(repr(float(n)) for n in whole.origin)})"]
    elif place == "spacings":
        head += [f"spacings: {text_of(whole.spacing)}", f"axis mins: {text_of(whole.origin)}"]
    elif place == "cell centres":
        # The minimum is the side of the first cell.
        head += [f"axis mins: {text_of(whole.origin - whole.spacing / 2)}", f"axis maxs: {text_of(whole.end + whole.spacing / 2)}", "centers: cell cell cell"]
    elif place == "node centres":
        head += [f"axis mins: {text_of(whole.origin)}", f"axis maxs: {text_of(whole.end)}", "centers: node node node"]
    head += [f"encoding: {encoding}", f"endian: {'big' if numpy.dtype(dtype).byteorder == '>' else 'little'}"]
    pack = {"raw": bytes, "gzip": gzip.compress,
            "ascii": lambda _: "\n".join(" ".join(repr(number) for number in row.tolist()) for row in samples.reshape(-1, SIZE[0])).encode() + b"\n"}[encoding]
    file = folder / ("volume.nrrd" if form == "nrrd" else "volume.nhdr")
    tail = b""
    if form == "nrrd":
        tail = b"\n" + pack(samples.tobytes())
    elif form == "list":
        head.append("data file: LIST\n" + "\n".join(f"slice{k}.raw" for k in range(SIZE[2])))
    elif form == "pattern":
        head.append(f"data file: slice%02d.raw 0 {SIZE[2] - 1} 1")
    else:
        head.append("data file: volume.raw")
        (folder / "volume.raw").write_bytes(pack(samples.tobytes()))
    for k in range(SIZE[2] if form in ("list", "pattern") else 0):
        (folder / ("slice%02d.raw" % k if form == "pattern" else f"slice{k}.raw")).write_bytes(samples[k].tobytes())
    file.write_bytes("\n".join(head).encode() + b"\n" + tail)
    return of_grid(file, whole, options, place_slack=1e-12, **said)


for name in FRAMES:
    add("NRRD", "places", name, nrrd, frame=name, quick=name == "exchanged")
for place in ("spacings", "cell centres", "node centres"):
    add("NRRD", "places", place, nrrd, place=place)
for dtype in TYPES + ("<i8", "<u8"):
    add("NRRD", "numbers", dtype, nrrd, dtype=dtype, frame="mirrored")
for dtype in (">u2", ">i2", ">i4", ">f4", ">f8"):
    add("NRRD", "storage", f"big endian {dtype}", nrrd, dtype=dtype)
for encoding in ("gzip", "ascii"):
    for dtype in ("<i2", "<f4"):
        add("NRRD", "storage", f"{encoding} {dtype}", nrrd, encoding=encoding, dtype=dtype, frame="permuted")
for form in ("nhdr", "list", "pattern"):
    add("NRRD", "storage", f"data file: {form}", nrrd, form=form, dtype="<u2")
add("NRRD", "arrays", "component 1 of 3", nrrd, components=3, options=("--component", "1"), take=1, taken={"component": "1"})


# DICOM: a file a slice; columns lie along the first direction, PixelSpacing is that of rows, then that of columns; left-posterior-superior.

CT, ENHANCED = "1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.2.1"
SYNTAXES = {"explicit": "1.2.840.10008.1.2.1", "implicit": "1.2.840.10008.1.2", "big endian": "1.2.840.10008.1.2.2", "deflated": "1.2.840.10008.1.2.1.99"}


def dicom_head(file, uid, series, syntax, sop_class=CT):
    meta = pydicom_dataset.FileMetaDataset()
    meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID, meta.TransferSyntaxUID = sop_class, uid, SYNTAXES[syntax]
    data = pydicom_dataset.FileDataset(str(file), {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian, data.is_implicit_VR = syntax != "big endian", syntax == "implicit"
    data.SOPClassUID, data.SOPInstanceUID, data.Modality = sop_class, uid, "CT"
    data.StudyInstanceUID, data.SeriesInstanceUID, data.FrameOfReferenceUID = "1.2.3.1", series, "1.2.3.9"
    data.PatientName, data.PatientID, data.StudyDate, data.StudyTime, data.StudyID = "Nobody", "1", "20260101", "120000", "1"
    data.SeriesNumber = int(series.rpartition(".")[2])
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    return data


def pixels_of(data, slices, slope):
    """Samples [i, j] or [i, j, k] as pixels; their values in Hounsfield units, or so."""
    raw = slices
    data.Columns, data.Rows = raw.shape[:2]
    bits = raw.dtype.itemsize * 8
    data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = bits, bits, bits - 1, int(raw.dtype.kind == "i")
    order = raw.transpose(*range(raw.ndim)[::-1])
    data.PixelData = order.astype(order.dtype.newbyteorder(">" if not data.is_little_endian else "<")).tobytes()
    data["PixelData"].VR = "OW" if bits > 8 or data.is_implicit_VR else "OB"
    if len(data.PixelData) % 2:
        data.PixelData += b"\0"
    return numpy.float64(slope[0]) * raw + slope[1]


def decimal(number):
    """What a decimal string of at most 16 letters holds."""
    return f"{number:.10g}"


def dicom_slices(folder, whole, series="1.2.3.4.1", prefix="image", slope=(1, 0), syntax="explicit", skip=(), ending=".dcm", slope_of_slice=None,
                 shuffled=True, thickness=None):
    """A file a slice; returns the values, and the names in the order of the slices."""
    values, names = numpy.empty(whole.values.shape), []
    order = numpy.random.default_rng(7).permutation(SIZE[2]) if shuffled else numpy.arange(SIZE[2])
    for k in range(SIZE[2]):
        file = folder / f"{prefix}{order[k]:03d}{ending}"
        data = dicom_head(file, f"{series}.{k + 1}", series, syntax)
        of = slope_of_slice(k) if slope_of_slice else slope
        data.RescaleSlope, data.RescaleIntercept = map(decimal, of)
        data.ImageOrientationPatient = [decimal(n) for n in whole.directions[:, :2].T.ravel()]
        data.ImagePositionPatient = [decimal(n) for n in whole.places[0, 0, k]]
        data.PixelSpacing = [decimal(whole.spacing[1]), decimal(whole.spacing[0])]
        data.SliceThickness = decimal(thickness or whole.spacing[2])
        data.InstanceNumber = int(order[k]) + 1
        values[:, :, k] = pixels_of(data, whole.values[:, :, k], [float(decimal(n)) for n in of])
        names.append(file)
        if k not in skip:
            data.save_as(str(file), write_like_original=False)
    return values, names


def dicom(folder, frame="offset", dtype="<i2", two=None, opened=0, skip=(), said=None, **words):
    whole = grid(frame, dtype)
    values, names = dicom_slices(folder, whole, skip=skip, **words)
    whole.values = values
    if two:
        other = grid(frame, dtype, variant=1)
        more, others = dicom_slices(folder, other, series="1.2.3.4.2", prefix=two, **words)
        if opened == 1:
            whole.values, names = more, others
    if skip:
        left = [k for k in range(SIZE[2]) if k not in skip]
        whole = Grid(numpy.full((3, 3), numpy.nan), whole.origin, whole.places[:, :, left], whole.values[:, :, left])
    return of_grid(names[3], whole, place_slack=1e-8, value_slack=1e-6, **(said or {}))


def enhanced(folder, frame="offset", dtype="<i2", shared=("orientation", "spacing"), slope=(2, -1000), shuffled=False):
    """One file of all slices, placed by functional groups."""
    whole = grid(frame, dtype)
    file = folder / "volume.dcm"
    data = dicom_head(file, "1.2.3.4.5", "1.2.3.4.1", "explicit", ENHANCED)
    order = numpy.random.default_rng(3).permutation(SIZE[2]) if shuffled else numpy.arange(SIZE[2])
    whole.values = pixels_of(data, whole.values[:, :, order], slope)[:, :, numpy.argsort(order)]
    data.NumberOfFrames, data.InstanceNumber = SIZE[2], 1

    def sequence(**words):
        item = pydicom_dataset.Dataset()
        for name, value in words.items():
            setattr(item, name, value)
        return pydicom.Sequence([item])

    def add_orientation(item):
        item.PlaneOrientationSequence = sequence(ImageOrientationPatient=[decimal(n) for n in whole.directions[:, :2].T.ravel()])

    def add_spacing(item):
        item.PixelMeasuresSequence = sequence(PixelSpacing=[decimal(whole.spacing[1]), decimal(whole.spacing[0])], SliceThickness=decimal(whole.spacing[2]))

    common, frames = pydicom_dataset.Dataset(), []
    common.PixelValueTransformationSequence = sequence(RescaleSlope=decimal(slope[0]), RescaleIntercept=decimal(slope[1]), RescaleType="HU")
    for place, k in enumerate(order):
        item = pydicom_dataset.Dataset()
        item.FrameContentSequence = sequence(StackID="1", InStackPositionNumber=int(k) + 1, DimensionIndexValues=[1, int(k) + 1])
        item.PlanePositionSequence = sequence(ImagePositionPatient=[decimal(n) for n in whole.places[0, 0, k]])
        for name, give in (("orientation", add_orientation), ("spacing", add_spacing)):
            if name not in shared:
                give(item)
        frames.append(item)
    for name, give in (("orientation", add_orientation), ("spacing", add_spacing)):
        if name in shared:
            give(common)
    data.SharedFunctionalGroupsSequence = pydicom.Sequence([common])
    data.PerFrameFunctionalGroupsSequence = pydicom.Sequence(frames)
    data.save_as(str(file), write_like_original=False)
    return of_grid(file, whole, place_slack=1e-8, value_slack=1e-6)


for name in ("offset", "turned half", "permuted", "exchanged", "mirrored", "oblique", "oblique twice", "oblique, mirrored"):
    add("DICOM", "places", name, dicom, frame=name, quick=name == "oblique twice")
add("DICOM", "places", "tilted gantry", dicom, frame=(numpy.array([[0.5, 0, 0], [0, 0.7, 0.2], [0, 0, 2]]), (-30.0, 12.5, 100)))
add("DICOM", "places", "rows and columns unequal", dicom, frame=(numpy.diag((0.5, 0.7, 1.5)), ORIGIN))
add("DICOM", "places", "overlapping slices", dicom, frame=(numpy.diag((0.5, 0.5, 0.6)), ORIGIN), thickness=0.8)
add("DICOM", "places", "a missing slice is a wider step", dicom, skip=(4,))
add("DICOM", "places", "a missing slice, oblique", dicom, skip=(2,), frame="oblique")
for dtype in ("u1", "<u2", "<i2"):
    add("DICOM", "numbers", dtype, dicom, dtype=dtype)
add("DICOM", "numbers", "signed, slope 0.2", dicom, slope=(0.2, 0))
add("DICOM", "numbers", "unsigned, slope 0.5, intercept -1024", dicom, dtype="<u2", slope=(0.5, -1024))
add("DICOM", "numbers", "a slope of each slice", dicom, slope_of_slice=lambda k: (0.1 + 0.05 * k, -3))
add("DICOM", "numbers", "negative slope", dicom, slope=(-0.25, 50))
for syntax in SYNTAXES:
    add("DICOM", "storage", syntax, dicom, syntax=syntax, frame="oblique")
add("DICOM", "storage", "names without an ending", dicom, ending="")
add("DICOM", "storage", "names in the order of the slices", dicom, shuffled=False)
add("DICOM", "series", "the first of two", dicom, two="other", said={"taken": {"series": "."}})
add("DICOM", "series", "the second of two", dicom, two="aaa", opened=1, said={"taken": {"series": "."}})
for name in ("offset", "oblique", "permuted"):
    add("DICOM, multi-frame", "places", name, enhanced, frame=name)
add("DICOM, multi-frame", "places", "geometry in each frame", enhanced, shared=(), frame="oblique twice")
add("DICOM, multi-frame", "places", "frames in any order", enhanced, shuffled=True)
for dtype, slope in (("<u2", (1, 0)), ("<i2", (0.2, 0)), ("u1", (1, -100))):
    add("DICOM, multi-frame", "numbers", f"{dtype}, slope {slope[0]}", enhanced, dtype=dtype, slope=slope)
