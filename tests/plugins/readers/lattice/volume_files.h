// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <QByteArray>
#include <QTemporaryDir>

#include <bit>
#include <filesystem>

namespace tetra {

/// The volume of the tests: 3 x 4 x 5 points, sample n is n; as the bytes of a file.
constexpr int testPoints = 60;
QByteArray testSamples(SampleType type, std::endian order = std::endian::little);

/// One gzip member.
QByteArray gzipped(const QByteArray& content);

/// A NRRD header for the test volume with the data attached: the magic, `fields` (without a dimension, sizes, type or
/// encoding of their own, the usual ones are added), and the empty line.
QByteArray nrrdHeader(const QByteArray& fields);

/// True if every sample n of `values` is n.
bool holdsTestSamples(const ScalarField& values);

/// A folder for files that live as long as the test.
class TestFolder {
public:
    std::filesystem::path path() const { return folder_.path().toStdString(); }
    /// The new file's path.
    std::filesystem::path write(const QByteArray& name, const QByteArray& content) const;

private:
    QTemporaryDir folder_;
};

} // namespace tetra
