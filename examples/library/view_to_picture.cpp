// SPDX-License-Identifier: GPL-3.0-or-later
// view_to_picture MODEL.tan NAME: the model as a volume, in colours of this program's choice, from the side: as a
// picture, NAME.png, and as a session, NAME.tansession, of which `tan render` makes the same picture.
#include <tan/picture.h>

#include <iostream>
#include <string>

namespace {

int failed(const tetra::Error& error)
{
    std::cerr << error.text() << '\n';
    return 1;
}

/// Blue to orange over the range, the larger the more opaque.
tetra::TransferFunction warmFunction(const tetra::ValueRange& range, double unitDistance)
{
    tetra::TransferFunction function;
    function.colours = {{range.minimum, {0.1f, 0.3f, 0.8f}}, {range.maximum, {1.0f, 0.6f, 0.1f}}};
    function.opacities = {{range.minimum, 0.0f}, {range.maximum, 0.5f}};
    function.unitDistance = unitDistance;
    return function;
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 3) {
        std::cerr << "usage: view_to_picture MODEL.tan NAME\n";
        return 2;
    }
    const auto model = tetra::Model::open(arguments[1]);
    if (!model)
        return failed(model.error());
    auto maker = tetra::PictureMaker::of(*model);
    if (!maker)
        return failed(maker.error());
    const tetra::ModelDescription& about = (*model)->description();
    tetra::ViewValue view = maker->startingView();
    view.appearance.mode = "volume";
    view.appearance.transfer = warmFunction(about.range, about.bounds.diagonal().norm() / 40);
    view.camera.azimuth = 70;
    view.camera.elevation = 15;
    const auto picture = maker->draw(view);
    if (!picture)
        return failed(picture.error());
    const std::string name = arguments[2];
    for (const tetra::Status& written :
         {tetra::writePicture(*picture, name + ".png"), maker->writeSession(view, name + ".tansession")})
        if (!written)
            return failed(written.error());
    return 0;
}
