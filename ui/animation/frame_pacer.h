// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// What there is to draw in a picture.
struct FrameWork {
    double tetrahedra = 0; ///< of the volume
    double triangles = 0;  ///< of the surfaces
    double samples = 0;    ///< of the picture
};

/// The time of a picture as a sum of four parts (R23), each a shape that is known beforehand times a factor that is
/// learnt from pictures: order and set-up go with the tetrahedra, filling with the tetrahedra and the fragments, the
/// rest with triangles and samples. A ray crosses about as many tetrahedra as the cube root of their number tells.
struct FrameCost {
    double order = 1;
    double setUp = 1;
    double fill = 1;
    double rest = 1;
    double fragmentsPerCrossing = 0.7; ///< fragments / (samples * cube root of the tetrahedra)
    bool operator==(const FrameCost&) const = default;
};

/// In seconds; with a new visibility order, whether or not an old one will do.
double predictedSeconds(const FrameCost& cost, const FrameWork& work);

/// After a picture that took `seconds`: halfway to what it says, so that one picture that was held up does not count
/// much. Of a back end that tells nothing but the time, all parts change alike.
FrameCost learned(const FrameCost& cost, const FrameWork& work, const RenderStatistics& statistics, double seconds);

/// The numbers of tetrahedra to prepare for moving pictures of a mesh of `whole` tetrahedra, falling: a quarter each
/// time, as long as that is worth it.
std::vector<std::uint64_t> coarserMeshes(std::uint64_t whole);

/// A mesh that a picture can be drawn of, and what that has cost so far.
struct FrameLevel {
    double tetrahedra = 0; ///< of the mesh
    bool isVolume = false; ///< else only the triangles are drawn
    double triangles = 0;
    FrameCost cost{};
    int measured = 0; ///< pictures of this level that the cost is from
};

/// How to draw a picture while there is little time.
struct FramePlan {
    std::size_t level = 0; ///< 0 is the finest
    double reduction = 1;  ///< its width and height are divided by this, one sample a pixel
    bool operator==(const FramePlan&) const = default;
};

/// Of a picture of so many pixels, with one sample each.
double predictedSeconds(const FrameLevel& level, double pixels, double reduction);

/// The plan that loses least against the finest level at full size, of those that should take no more than `budget`
/// seconds, or the quickest if none does. `last` is kept as long as it does not clearly miss the budget and no better
/// one would clearly keep it. Levels are in falling size, at least one.
FramePlan chooseFrame(std::span<const FrameLevel> levels, double pixels, double budget,
                      const std::optional<FramePlan>& last);

/// A picture of the finest level on the way to the best one.
struct RefinementStep {
    double reduction = 1;
    int samplesPerAxis = 1;
    bool operator==(const RefinementStep&) const = default;
};

/// What to draw when the camera rests: the last step is the picture at full size with `samplesPerAxis`, and before it,
/// if that will take long, such as take a fraction of it, so that all take little longer than the last alone.
std::vector<RefinementStep> refinementSteps(const FrameLevel& finest, double pixels, int samplesPerAxis);

/// What is drawn while something moves, as the user chooses (R23, C4).
struct MovingQuality {
    enum class Kind : std::uint8_t {
        FrameRate, ///< as many tetrahedra and pixels as a frame rate allows
        Error,     ///< a mesh of this error, at full size
        Share,     ///< a mesh with this share of the tetrahedra, at full size
        Full,      ///< what is drawn at rest
    };
    Kind kind = Kind::FrameRate;
    double percent = 0; ///< of the value range, or of the tetrahedra; 0 for other kinds
    bool operator==(const MovingQuality&) const = default;
};

/// Holds a frame rate while the camera moves (R23): learns from the pictures that were drawn, and says how to draw the
/// next one. Knows no clock, no scene and no thread; a value.
class FramePacer {
public:
    /// Pictures a second, above zero.
    void setFrameRate(double perSecond) noexcept { frameRate_ = perSecond; }
    double frameRate() const noexcept { return frameRate_; }
    /// Of Error and Share the one coarser level is drawn; while there is none, the frame rate counts.
    void setKind(MovingQuality::Kind kind) noexcept { kind_ = kind; }
    MovingQuality::Kind kind() const noexcept { return kind_; }

    /// What can be drawn from now on, the finest first; costs and `measured` are its own affair. What was learnt goes
    /// over to the levels nearest in size.
    void setLevels(std::vector<FrameLevel> levels);
    const std::vector<FrameLevel>& levels() const noexcept { return levels_; }

    /// For the next picture of a movement, of a viewport of so many pixels.
    FramePlan nextFrame(double pixels);
    /// For when it rests.
    std::vector<RefinementStep> refinement(double pixels, int samplesPerAxis) const;
    /// What the last of those pictures is expected to take.
    double secondsOfStill(double pixels, int samplesPerAxis) const;
    /// A picture of this level with so many samples took `seconds`.
    void learn(std::size_t level, double samples, const RenderStatistics& statistics, double seconds);

private:
    std::vector<FrameLevel> levels_{FrameLevel{}};
    std::optional<FramePlan> last_;
    double frameRate_ = 15;
    MovingQuality::Kind kind_ = MovingQuality::Kind::FrameRate;
};

} // namespace tetra
