// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/import_probe.h"

#include "plugins/host/dataset_opening.h"

namespace tetra {

void ImportProbe::request(const std::filesystem::path& path, const ImportOptions& options)
{
    const std::uint64_t number = ++newest_;
    job_.submit([this, path, options, number](const std::stop_token& stop) {
        const auto contents = probeDataset(host_, path, options, Progress(stop, {}));
        QMetaObject::invokeMethod(
            this,
            [this, contents, number] {
                if (number == newest_)
                    emit probed(contents);
            },
            Qt::QueuedConnection);
    });
}

} // namespace tetra
