// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/plugin.h>
#include <plugins/api/writer.h>

/// Writes surfaces as text: the numbers of vertices and triangles, then one of them in each line.
class OffWriter : public tetra::Writer {
public:
    std::vector<tetra::FileFormat> formats() const override
    {
        return {{tetra::WrittenContent::Surface, tetra::Message::marked("OFF files"), {".off"}}};
    }

    tetra::Status writeSurface(const tetra::SurfaceContent& surface, tetra::OutputFile& file,
                               const tetra::ParameterValues&) const override
    {
        using tetra::formatNumber, std::to_string;
        std::string text =
            "OFF\n" + to_string(surface.vertexCount()) + " " + to_string(surface.triangleCount()) + " 0\n";
        for (const tetra::SurfacePart& part : surface.parts)
            for (const Eigen::Vector3d& position : part.positions)
                text += formatNumber(position.x()) + " " + formatNumber(position.y()) + " " +
                        formatNumber(position.z()) + "\n"; // alike in every language
        std::size_t first = 0;                             // the file counts through the vertices of all parts
        for (const tetra::SurfacePart& part : surface.parts) {
            for (const auto& [a, b, c] : part.triangles)
                text += "3 " + to_string(first + a) + " " + to_string(first + b) + " " + to_string(first + c) + "\n";
            first += part.positions.size();
        }
        return file.text(text);
    }
};

TAN_PLUGIN(OffWriter, tetra::Writer)
