// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/render/picture_check.h"

#include <tan/render.h>

#include <QString>

#include <algorithm>

namespace tetra::testing {

inline Picture rendered(RenderBackend& backend, const Scene& scene, const Camera& camera, const PictureOptions& options)
{
    auto picture = backend.render(scene, camera, options);
    if (!picture)
        qFatal("%s", picture.error().text().c_str());
    return std::move(picture).value();
}

/// True if the pixel lies, in each channel, within what the 3 x 3 pixels around it span in `other`.
inline bool withinNeighbourhood(const Picture& picture, const Picture& other, int x, int y, int tolerance)
{
    for (std::size_t channel = 0; channel < 4; ++channel) {
        int smallest = 255;
        int largest = 0;
        for (int v = std::max(0, y - 1); v <= std::min(picture.height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(picture.width - 1, x + 1); ++u) {
                smallest = std::min<int>(smallest, pixelAt(other, u, v)[channel]);
                largest = std::max<int>(largest, pixelAt(other, u, v)[channel]);
            }
        const int value = pixelAt(picture, x, y)[channel];
        if (value < smallest - tolerance || value > largest + tolerance)
            return false;
    }
    return true;
}

/// Two pictures with one pixel for each sample of others that have `perAxis` squared of them a pixel.
struct SamplePictures {
    Picture cpu, gl;
    int perAxis = 1;
};

/// Each sample of a pixel lies within what the 3 x 3 samples around it span on the CPU, and one of them differs: an
/// edge fell on another side of it. Tells that of what is smaller than a pixel, which the pixels around it do not show.
inline bool samplesMoved(const SamplePictures& samples, int x, int y)
{
    bool differs = false;
    for (int v = y * samples.perAxis; v < (y + 1) * samples.perAxis; ++v)
        for (int u = x * samples.perAxis; u < (x + 1) * samples.perAxis; ++u) {
            if (!withinNeighbourhood(samples.gl, samples.cpu, u, v, 2))
                return false;
            differs = differs || difference(pixelAt(samples.gl, u, v), pixelAt(samples.cpu, u, v)) > 2;
        }
    return differs;
}

inline QString pixelText(const Picture& picture, int x, int y)
{
    const auto& [red, green, blue, alpha] = pixelAt(picture, x, y);
    return QString("%1 %2 %3 %4").arg(red).arg(green).arg(blue).arg(alpha);
}

/// Pixels differ by 2 at most: half a step of rounding in each picture, and half floats under many layers. Only where
/// the picture has an edge may a sample fall on its other side, since corners are rounded to 1/256 of a sample in both,
/// but not alike: there a pixel lies within its neighbours, and such pixels are few.
/// Where the samples are at hand (`samples`), a pixel may show by them that it is at an edge. Of small pictures, whose
/// neighbours may be of yet other colours, `strays` such pixels may be anything.
inline bool samePicture(const Picture& cpu, const Picture& gl, const Picture& glAgain, const QString& name,
                        int strays = 0, const SamplePictures* samples = nullptr)
{
    if (gl.pixels != glAgain.pixels) {
        qWarning("two OpenGL pictures of the same scene differ");
        return false;
    }
    int moved = 0;
    int wrong = 0;
    int largest = 0;
    Picture differences = cpu;
    for (int y = 0; y < cpu.height; ++y)
        for (int x = 0; x < cpu.width; ++x) {
            const int here = difference(pixelAt(cpu, x, y), pixelAt(gl, x, y));
            const auto shade = static_cast<std::uint8_t>(std::min(255, here * 16));
            differences.pixels[static_cast<std::size_t>(y * cpu.width + x)] = {shade, shade, shade, 255};
            largest = std::max(largest, here);
            if (here <= 2)
                continue;
            const bool explained =
                withinNeighbourhood(gl, cpu, x, y, 2) || (samples != nullptr && samplesMoved(*samples, x, y));
            ++(explained ? moved : wrong);
            if (!explained && wrong > strays && wrong <= strays + 5)
                qWarning("pixel (%d, %d): %s, not %s", x, y, qPrintable(pixelText(gl, x, y)),
                         qPrintable(pixelText(cpu, x, y)));
        }
    if (wrong <= strays && moved <= static_cast<int>(cpu.pixels.size()) / 100)
        return true;
    qWarning("%d pixels are wrong, %d moved, the largest difference is %d; %s %s %s", wrong, moved, largest,
             qPrintable(savePicture(cpu, name + "_cpu")), qPrintable(savePicture(gl, name + "_gl")),
             qPrintable(savePicture(differences, name + "_difference")));
    return false;
}

} // namespace tetra::testing
