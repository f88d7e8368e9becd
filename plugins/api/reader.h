// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "plugins/api/parameter.h"

#include <QtPlugin>

#include <span>

namespace tetra {

/// Reads files of some formats into datasets. Never crashes on bad input: every refusal is an Error that names the
/// file, what is wrong in it and what to do.
class Reader {
public:
    virtual ~Reader() = default;
    /// Name filters for the open dialog: {"NRRD volume (*.nrrd *.nhdr)", ...}.
    virtual std::vector<std::string> nameFilters() const = 0;
    /// 0 cannot, 1 certain; from the name and the first bytes (up to 4096) of the file.
    virtual double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const = 0;
    /// What must be known besides the file (a raw file's size and sample type).
    virtual std::vector<Parameter> parameters() const = 0;
    virtual Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                                 const Progress& progress) const = 0;
};

/// Writes datasets into files of some formats, safely: beside the target, synced, renamed.
class Writer {
public:
    virtual ~Writer() = default;
    virtual std::vector<std::string> nameFilters() const = 0;
    /// 0 cannot, 1 made for it; from the name.
    virtual double score(const std::filesystem::path& path) const = 0;
    virtual std::vector<Parameter> parameters() const = 0;
    virtual Status write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const = 0;
};

} // namespace tetra

#define TAN_READER_INTERFACE "org.tan.Reader/1"
Q_DECLARE_INTERFACE(tetra::Reader, TAN_READER_INTERFACE)
#define TAN_WRITER_INTERFACE "org.tan.Writer/1"
Q_DECLARE_INTERFACE(tetra::Writer, TAN_WRITER_INTERFACE)
