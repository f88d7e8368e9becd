// SPDX-License-Identifier: GPL-3.0-or-later
// picture_to_file MODEL.tan PERCENT PICTURE.ppm: the field as a translucent volume, in colours that fit its values.
#include <tan/query.h>
#include <tan/render.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

int failed(const tetra::Error& error)
{
    std::cerr << error.text() << '\n';
    return 1;
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 4) {
        std::cerr << "usage: picture_to_file MODEL.tan PERCENT PICTURE.ppm\n";
        return 2;
    }
    const auto model = tetra::Model::open(arguments[1]);
    if (!model)
        return failed(model.error());
    const tetra::ModelDescription& about = (*model)->description();
    tetra::MeshQuery query;
    query.error = std::strtod(arguments[2], nullptr);
    const auto extracted = tetra::MeshExtractor(*model).extract(query);
    if (!extracted)
        return failed(extracted.error());
    const auto mesh = tetra::meshOf(*extracted);

    const auto values = tetra::volumeHistogram(*mesh, about.range.minimum, about.range.maximum, 256);
    const double error = std::strtod(arguments[2], nullptr) / 100 * about.range.extent();
    const auto function = tetra::fittedTransferFunction(values, about.bounds.diagonal().norm() / 40, error);
    const auto volume = tetra::VolumeCache(mesh).update(function, true);
    if (!volume)
        return failed(volume.error());
    tetra::Scene scene;
    scene.bounds = about.bounds;
    scene.drawables.push_back({.id = "volume", .shape = *volume});
    const auto picture = tetra::makeCpuBackend()->render(scene, tetra::fitted({}, scene.bounds), {});
    if (!picture)
        return failed(picture.error());
    std::ofstream file(arguments[3], std::ios::binary);
    file << "P6 " << picture->width << ' ' << picture->height << " 255\n";
    for (const auto& [red, green, blue, alpha] : picture->pixels)
        file << char(red) << char(green) << char(blue);
    return file.good() ? 0 : 1;
}
