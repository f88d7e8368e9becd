// SPDX-License-Identifier: GPL-3.0-or-later
// tan-torture-inputs FOLDER: the small files that the tests of VTK's formats write, each kind in a folder of its own,
// and a line of JSON for each that names what a user opens.
#include "tests/plugins/readers/vtk/written_files.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>

int main(int argumentCount, char** arguments)
{
    if (argumentCount != 2)
        return 2;
    for (const tetra::WrittenFiles& files : tetra::writeFormats(arguments[1])) {
        const QJsonObject line{{"what", QString::fromStdString(files.what)},
                               {"opened", QString::fromStdString(files.opened.string())}};
        std::puts(QJsonDocument(line).toJson(QJsonDocument::Compact).constData());
    }
    return 0;
}
