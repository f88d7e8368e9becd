// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/writer.h>

#include <QObject>

/// Writes surfaces as text: the numbers of vertices and triangles, then one of them in each line.
class OffWriter : public QObject, public tetra::Writer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "off_writer.json")
    Q_INTERFACES(tetra::Writer)

public:
    std::vector<tetra::FileFormat> formats() const override
    {
        return {{tetra::WrittenContent::Surface, "OFF files", {".off"}}};
    }

    tetra::Status writeSurface(const tetra::SurfaceContent& surface, tetra::OutputFile& file,
                               const tetra::ParameterValues&) const override
    {
        std::string text =
            "OFF\n" + std::to_string(surface.vertexCount()) + " " + std::to_string(surface.triangleCount()) + " 0\n";
        for (const tetra::SurfacePart& part : surface.parts)
            for (const Eigen::Vector3f& position : part.positions)
                text += tetra::formatNumber(position.x()) + " " + tetra::formatNumber(position.y()) + " " +
                        tetra::formatNumber(position.z()) + "\n";
        std::size_t first = 0; // the file counts through the vertices of all parts
        for (const tetra::SurfacePart& part : surface.parts) {
            for (const auto& [a, b, c] : part.triangles)
                text += "3 " + std::to_string(first + a) + " " + std::to_string(first + b) + " " +
                        std::to_string(first + c) + "\n";
            first += part.positions.size();
        }
        return file.text(text);
    }
};

#include "off_writer.moc"
