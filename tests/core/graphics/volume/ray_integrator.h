// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/camera.h"
#include "core/graphics/volume/volume_renderer.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/transfer/transfer_function.h"

#include <array>

namespace tetra::testing {

/// The volume-rendering integral, slowly and in double precision: every ray is cut with every cell by itself, the
/// pieces are sorted by depth, and each is marched through in small steps of constant colour and extinction.
class RayIntegrator {
public:
    RayIntegrator(const TetrahedralMesh& mesh, const TransferFunction& function, const Camera& camera, int width,
                  int height);

    /// Red, green, blue times opacity, and opacity.
    std::array<double, 4> sample(int column, int row) const;

private:
    struct Ray {
        Eigen::Vector3d start;     ///< on the near plane; in orthographic views before the whole mesh
        Eigen::Vector3d direction; ///< of unit length
    };
    /// A ray in a cell: from `enter` to `leave` along it, where the values are `valueIn` and `valueOut`.
    struct Piece {
        double enter, leave, valueIn, valueOut;
    };
    struct Light {
        std::array<double, 3> colour{0, 0, 0};
        double left = 1;
    };

    Ray rayOf(int column, int row) const;
    bool cut(const Ray& ray, const std::array<std::uint32_t, 4>& cell, Piece& piece) const;
    void march(Light& light, double length, double valueIn, double valueOut, int halvings) const;

    const TetrahedralMesh& mesh_;
    const TransferFunction& function_;
    Camera camera_;
    int width_, height_;
    Eigen::Matrix4d worldFromClip_;
};

/// How far a picture is from the integrator's.
struct PictureDifference {
    double largest = 0;
    double mean = 0; ///< over all samples and channels
    double seen = 0; ///< mean opacity of the integrator's picture
};

PictureDifference compare(const VolumePicture& picture, const RayIntegrator& integrator);

} // namespace tetra::testing
