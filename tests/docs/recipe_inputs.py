#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""recipe_inputs.py FOLDER: the image, the CT and the weather field of docs/user/recipes.md, small, by the libraries of those who make such files. Exit
code 77: one of these is missing."""
import pathlib
import sys

try:
    import netCDF4
    import numpy
    import pydicom
    import tifffile
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


def ball(places, centre, radius):
    """1 within, 0 outside, and a half at the radius."""
    return 1 / (1 + numpy.exp(2 * (numpy.linalg.norm(places - centre, axis=-1) - radius)))


def write_image(folder):
    """Two channels at three times, voxels of .2 x .25 x .4 micrometres."""
    z, y, x = numpy.meshgrid(numpy.arange(10) * .4, numpy.arange(14) * .25, numpy.arange(16) * .2, indexing="ij")
    places = numpy.stack((x, y, z), axis=-1)
    samples = numpy.array([[40_000 * ball(places * 4, (6 + time, 6, 8), 4 + channel) for channel in range(2)] for time in range(3)])
    tifffile.imwrite(folder / "cells.ome.tif", samples.astype("<u2"), ome=True, photometric="minisblack",
                     metadata={"axes": "TCZYX", "Channel": {"Name": ["DAPI", "GFP"]}, "PhysicalSizeX": .2, "PhysicalSizeXUnit": "µm", "PhysicalSizeY": .25,
                               "PhysicalSizeYUnit": "µm", "PhysicalSizeZ": .4, "PhysicalSizeZUnit": "µm"})


def write_scan(folder):
    """Two series of eight slices: air around soft tissue, then around bone."""
    study = pydicom.uid.generate_uid()
    (folder / "scan").mkdir()
    for number, (description, most) in enumerate((("Thorax", 100), ("Bone", 1000)), 1):
        series = pydicom.uid.generate_uid()
        for slice_number in range(8):
            meta = pydicom.dataset.FileMetaDataset()
            meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = "1.2.840.10008.5.1.4.1.1.2", pydicom.uid.generate_uid()
            meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
            path = folder / "scan" / f"IM{(number - 1) * 8 + slice_number + 1:04d}"
            file = pydicom.dataset.FileDataset(str(path), {}, file_meta=meta, preamble=b"\0" * 128)
            file.is_little_endian, file.is_implicit_VR = True, False
            file.SOPClassUID, file.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
            file.StudyInstanceUID, file.SeriesInstanceUID, file.Modality = study, series, "CT"
            file.SeriesNumber, file.SeriesDescription, file.InstanceNumber = number, description, slice_number + 1
            file.Rows, file.Columns, file.SamplesPerPixel, file.PhotometricInterpretation = 12, 12, 1, "MONOCHROME2"
            file.BitsAllocated, file.BitsStored, file.HighBit, file.PixelRepresentation = 16, 16, 15, 1
            file.PixelSpacing, file.ImageOrientationPatient = [2, 2], [1, 0, 0, 0, 1, 0]
            file.ImagePositionPatient = [-11, -11, 3 * slice_number]
            file.RescaleSlope, file.RescaleIntercept = 1, -1000
            y, x = numpy.meshgrid(numpy.arange(12) * 2 - 11., numpy.arange(12) * 2 - 11., indexing="ij")
            places = numpy.stack((x, y, numpy.full_like(x, 3 * slice_number)), axis=-1)
            file.PixelData = ((1000 + most) * ball(places, (0, 0, 10), 7)).astype("<i2").tobytes()
            file.save_as(str(path), write_like_original=False)


def write_weather(folder):
    """Temperature at four times, from the north to the south, on levels at uneven distances."""
    along = {"longitude": numpy.arange(12) * 5., "latitude": 90 - numpy.arange(30) * 2.5, "level": numpy.array([200, 300, 500, 700, 850, 925, 1000.])}
    with netCDF4.Dataset(folder / "era5.nc", "w") as file:
        for (name, places), unit in zip(along.items(), ("degrees_east", "degrees_north", "millibars")):
            file.createDimension(name, len(places))
            axis = file.createVariable(name, "f4", (name,))
            axis.units, axis[:] = unit, places
        file.createDimension("time", None)
        time = file.createVariable("time", "i4", ("time",))
        time.units, time.calendar, time[:] = "hours since 1900-01-01", "gregorian", 1_073_352 + 6 * numpy.arange(4)
        temperature = file.createVariable("t", "i2", ("time", "level", "latitude", "longitude"), fill_value=-32767)
        temperature.scale_factor, temperature.add_offset, temperature.units = .01, 250., "K"
        level, latitude, _ = numpy.meshgrid(along["level"], along["latitude"], along["longitude"], indexing="ij")
        for step in range(4):
            temperature[step] = 303 + step - 38 * numpy.sin(numpy.radians(latitude)) ** 2 - 66 * (1 - numpy.sqrt(level / 1000))


for write in (write_image, write_scan, write_weather):
    write(pathlib.Path(sys.argv[1]))
