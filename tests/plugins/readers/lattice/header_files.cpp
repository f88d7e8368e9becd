// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/lattice/header_files.h"

namespace tetra {

namespace {

/// Bytes of a length, into which numbers are put.
class Header {
public:
    Header(qsizetype size, std::endian order) : bytes_(size, '\0'), order_(order) {}

    template <class T> void put(qsizetype place, T value)
    {
        const QByteArray number = numberBytes(value, order_);
        bytes_.replace(place, number.size(), number);
    }
    template <class T, class Numbers> void all(qsizetype place, const Numbers& numbers)
    {
        for (const auto number : numbers) {
            put(place, static_cast<T>(number));
            place += static_cast<qsizetype>(sizeof(T));
        }
    }
    void text(qsizetype place, const QByteArray& words) { bytes_.replace(place, words.size(), words); }
    const QByteArray& bytes() const { return bytes_; }

private:
    QByteArray bytes_;
    std::endian order_;
};

template <class Real> void putForms(Header& header, const NiftiFields& fields, qsizetype quaternion)
{
    const auto size = static_cast<qsizetype>(sizeof(Real));
    header.all<Real>(quaternion, fields.quaternion);
    header.all<Real>(quaternion + 3 * size, fields.qOffset);
    for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = 0; column < 4; ++column)
            header.put(quaternion + (6 + 4 * row + column) * size, static_cast<Real>(fields.rows(row, column)));
}

QByteArray firstHeader(const NiftiFields& fields)
{
    Header header(348, fields.order);
    header.put<std::int32_t>(0, 348);
    header.all<std::int16_t>(40, fields.dim);
    header.put<std::int16_t>(70, static_cast<std::int16_t>(fields.type));
    header.all<float>(76, fields.pixdim);
    header.put<float>(112, static_cast<float>(fields.slope));
    if (fields.version == 0) {
        header.text(56, "mm");
        header.all<std::int16_t>(253, fields.originator);
        return header.bytes();
    }
    header.put<float>(108, fields.isPair ? 0 : static_cast<float>(352 + fields.extension.size()));
    header.put<std::int16_t>(68, static_cast<std::int16_t>(fields.intent));
    header.put<float>(116, static_cast<float>(fields.intercept));
    header.put<std::uint8_t>(123, static_cast<std::uint8_t>(fields.units));
    header.put<float>(136, static_cast<float>(fields.timeOffset));
    header.put<std::int16_t>(252, static_cast<std::int16_t>(fields.qform));
    header.put<std::int16_t>(254, static_cast<std::int16_t>(fields.sform));
    putForms<float>(header, fields, 256);
    header.text(344, fields.isPair ? QByteArray("ni1\0", 4) : QByteArray("n+1\0", 4));
    return header.bytes();
}

QByteArray secondHeader(const NiftiFields& fields)
{
    Header header(540, fields.order);
    header.put<std::int32_t>(0, 540);
    header.text(4, fields.isPair ? QByteArray("ni2\0\r\n\x1a\n", 8) : QByteArray("n+2\0\r\n\x1a\n", 8));
    header.put<std::int16_t>(12, static_cast<std::int16_t>(fields.type));
    header.all<std::int64_t>(16, fields.dim);
    header.all<double>(104, fields.pixdim);
    header.put<std::int64_t>(168, fields.isPair ? 0 : 544 + fields.extension.size());
    header.put<double>(176, fields.slope);
    header.put<double>(184, fields.intercept);
    header.put<double>(216, fields.timeOffset);
    header.put<std::int32_t>(344, fields.qform);
    header.put<std::int32_t>(348, fields.sform);
    putForms<double>(header, fields, 352);
    header.put<std::int32_t>(500, fields.units);
    header.put<std::int32_t>(504, fields.intent);
    return header.bytes();
}

} // namespace

QByteArray turnedRound(QByteArray numbers, int size)
{
    for (qsizetype first = 0; first + size <= numbers.size(); first += size)
        std::reverse(numbers.begin() + first, numbers.begin() + first + size);
    return numbers;
}

QByteArray niftiHeader(const NiftiFields& fields)
{
    const QByteArray header = fields.version == 2 ? secondHeader(fields) : firstHeader(fields);
    if (fields.isPair || fields.version == 0)
        return header;
    return header + (fields.extension.isEmpty() ? QByteArray(4, '\0') : QByteArray("\1\0\0\0", 4)) + fields.extension;
}

NiftiFields niftiBySteps(const Eigen::Matrix3d& steps, const Eigen::Vector3d& origin)
{
    NiftiFields fields;
    fields.sform = 1;
    fields.rows << steps, origin;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        fields.pixdim[static_cast<std::size_t>(axis) + 1] = steps.col(axis).norm();
    return fields;
}

QByteArray mrcHeader(const MrcFields& fields)
{
    Header header(1024, fields.order);
    header.all<std::int32_t>(0, fields.size);
    header.put<std::int32_t>(12, fields.mode);
    header.all<std::int32_t>(16, fields.start);
    header.all<std::int32_t>(28, fields.grid);
    header.all<float>(40, fields.cell);
    header.all<float>(52, fields.angles);
    header.all<std::int32_t>(64, fields.axes);
    header.put<float>(76, fields.least);
    header.put<float>(80, fields.most);
    header.put<std::int32_t>(88, fields.spaceGroup);
    header.put<std::int32_t>(92, static_cast<std::int32_t>(fields.extension.size()));
    if (fields.imodFlags >= 0) {
        header.put<std::int32_t>(152, 1146047817);
        header.put<std::int32_t>(156, fields.imodFlags);
    }
    header.all<float>(196, fields.origin);
    header.text(208, fields.stamp);
    header.text(212, !fields.machine.isEmpty()             ? fields.machine
                     : fields.order == std::endian::little ? QByteArray("\x44\x44")
                                                           : QByteArray("\x11\x11"));
    return header.bytes() + fields.extension;
}

QByteArray metaHeader(const QByteArray& fields, const QByteArray& dataFile)
{
    QByteArray header = "ObjectType = Image\n" + fields;
    const auto addUnlessGiven = [&](const QByteArray& name, const QByteArray& value) {
        if (!header.contains("\n" + name + " ="))
            header += name + " = " + value + "\n";
    };
    addUnlessGiven("NDims", "3");
    addUnlessGiven("BinaryDataByteOrderMSB", "False");
    addUnlessGiven("DimSize", "3 4 5");
    addUnlessGiven("ElementType", "MET_FLOAT");
    return header + "ElementDataFile = " + dataFile + "\n";
}

} // namespace tetra
