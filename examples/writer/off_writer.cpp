// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/writer.h>

#include <QObject>
#include <QTextStream>

/// Writes surfaces as text: the numbers of vertices and triangles, then one of them in each line.
class OffWriter : public QObject, public tetra::Writer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "off_writer.json")
    Q_INTERFACES(tetra::Writer)

public:
    std::vector<tetra::FileFormat> formats() const override
    {
        return {{tetra::WrittenContent::Surface, tetra::Message::marked("OFF files"), {".off"}}};
    }

    tetra::Status writeSurface(const tetra::SurfaceContent& surface, tetra::OutputFile& file,
                               const tetra::ParameterValues&) const override
    {
        QByteArray text;
        QTextStream lines(&text); // writes numbers alike in every language
        lines.setRealNumberPrecision(17);
        lines << "OFF\n" << surface.vertexCount() << " " << surface.triangleCount() << " 0\n";
        for (const tetra::SurfacePart& part : surface.parts)
            for (const Eigen::Vector3d& position : part.positions)
                lines << position.x() << " " << position.y() << " " << position.z() << "\n";
        std::size_t first = 0; // the file counts through the vertices of all parts
        for (const tetra::SurfacePart& part : surface.parts) {
            for (const auto& [a, b, c] : part.triangles)
                lines << "3 " << first + a << " " << first + b << " " << first + c << "\n";
            first += part.positions.size();
        }
        lines.flush();
        return file.text(text.toStdString());
    }
};

#include "off_writer.moc"
