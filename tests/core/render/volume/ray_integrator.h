// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_renderer.h"

#include <tan/mesh.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace tetra::testing {

/// An isosurface that looks the same from all sides.
struct IsoLayer {
    double value = 0;
    std::array<double, 3> colour{0, 0, 0};
    double opacity = 1;
};

/// What an integrator draws beside the volume.
struct RayScene {
    std::vector<IsoLayer> layers;
    bool wholeCells = false;
    std::vector<ClipPlane> clipPlanes;
    bool shaded = false;
    /// Rays begin as far before the domain as in a scene with these bounds; empty: those of the mesh.
    Eigen::AlignedBox3d bounds;
};

/// The volume-rendering integral, slowly and in double precision: every ray is cut with every cell by itself, the
/// pieces are sorted by depth, and each is marched through in small steps of constant colour and extinction. Its light
/// is that of docs/developer/tetrahedral-graphics.md, from gradients of its own. Layers are met where the
/// piecewise-linear field has their value.
class RayIntegrator {
public:
    RayIntegrator(const TetrahedralMesh& mesh, const TransferFunction& function, const Camera& camera, int width,
                  int height, RayScene scene = {});

    struct Sample {
        std::array<double, 4> colour; ///< red, green, blue times opacity, and opacity
        double depth;                 ///< of Picture
    };
    /// At a place a little beside the sample, too.
    Sample trace(double column, double row) const;
    std::array<double, 4> sample(int column, int row) const { return trace(column, row).colour; }
    /// The picture changes so much beside the sample, at the edge of a layer or where two faces meet, that rounding
    /// decides what the ray meets.
    bool isDoubtful(int column, int row) const;

private:
    struct Ray {
        Eigen::Vector3d start;     ///< on the near plane; in orthographic views before the whole mesh
        Eigen::Vector3d direction; ///< of unit length
    };
    /// A cell with the barycentric weights of its corners 1 to 3 as an affine function, and a sphere around it.
    struct Cell {
        Eigen::Vector3d corner;
        Eigen::Matrix3d inverse;
        Eigen::Vector4d values;
        Eigen::Matrix<double, 3, 4> gradients; ///< at the corners, for light
        Eigen::Vector3d centre;
        double squaredRadius;
    };
    /// A ray in a cell: from `enter` to `leave` along it, where the values are `valueIn` and `valueOut`.
    struct Piece {
        double enter, leave, valueIn, valueOut;
        const Cell* cell;
        Eigen::Vector4d weights, perLength; ///< of the corners, at the start of the ray and for one unit of length
    };
    /// The light at a place of a ray: what colours are multiplied by, and what is added.
    struct Falling {
        double factor = 1, highlight = 0;
    };
    /// A slab of a piece, from one place of the ray to another: values, and colours under light at its ends.
    struct Slab {
        double enter, leave, valueIn, valueOut;
        std::array<double, 3> colourIn, colourOut;
    };
    struct Light {
        std::array<double, 3> colour{0, 0, 0};
        double left = 1;
        double halfAt = -1; ///< along the ray; negative where there is none
    };

    void addCell(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& corners,
                 const std::vector<Eigen::Vector3d>& gradients);
    Ray rayOf(double column, double row) const;
    bool cut(const Ray& ray, const Cell& cell, Piece& piece) const;
    bool clip(const Ray& ray, Piece& piece) const;
    void through(const Ray& ray, Light& light, const Piece& piece) const;
    TransferSample look(double value) const;
    void meet(Light& light, const IsoLayer& layer, double at) const;
    Falling fallingAt(const Ray& ray, const Piece& piece, double place) const;
    void march(const Ray& ray, Light& light, const Piece& piece, double from, double to) const;
    void marchLit(const Ray& ray, Light& light, const Piece& piece, double from, double to) const;
    void marchSlab(Light& light, const Slab& slab) const;
    void step(Light& light, double length, double valueIn, double valueOut, double at, int halvings) const;
    void pass(Light& light, const std::array<double, 3>& colour, double extinction, double length, double at) const;
    std::vector<double> knotsBetween(double valueIn, double valueOut) const;

    const TransferFunction& function_;
    Camera camera_;
    int width_, height_;
    RayScene scene_;
    Eigen::Matrix4d worldFromClip_;
    Eigen::Matrix3d cameraFromWorld_; ///< rows: right, up, back
    Eigen::AlignedBox3d bounds_;
    std::vector<Cell> cells_;
    std::vector<double> extinctions_; ///< of the function's points
    double mostExtinction_ = 0;
};

/// How far a picture is from the integrator's.
struct PictureDifference {
    double largest = 0;
    double mean = 0; ///< over all samples and channels
    double seen = 0; ///< mean opacity of the integrator's picture
};

PictureDifference compare(const VolumePicture& picture, const RayIntegrator& integrator);

} // namespace tetra::testing
