// SPDX-License-Identifier: GPL-3.0-or-later
// Samples: models that the program makes itself, to try things without data.
#include "ui/session/sample_models.h"
#include "ui/session/target_path.h"
#include "ui/session/workbench.h"

namespace tetra {

void Workbench::openSample(const std::string& name)
{
    sampling_.start([this, name](const Progress& progress) -> std::function<void()> {
        return [this, model = sampleModel(host_, name, sampleFolder(), progress)] {
            if (model)
                open(pathText(*model));
            else
                tell(model.error());
        };
    });
}

} // namespace tetra
