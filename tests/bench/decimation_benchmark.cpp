// SPDX-License-Identifier: GPL-3.0-or-later
// Decimation by exact errors against VTK's by quadrics, at the same numbers of tetrahedra and judged by the same code,
// on one thread; its collapses a second, and how its time grows.

#include "tests/bench/decimation_cases.h"

#include <QCommandLineParser>
#include <QCoreApplication>

namespace {

std::vector<tetra::BenchCase> measureAll(const QString& data, const QStringList& meshes,
                                         const std::vector<std::uint32_t>& sizes)
{
    const std::pair<QString, QString> files[] = {{"BluntFin", "bluntfin/bluntfin_tet.vtu"},
                                                 {"Post", "post/post_tet.vtu"},
                                                 {"bracket", "irregular/bracket_454k.vtu"}};
    std::vector<tetra::BenchCase> cases;
    const auto add = [&cases](std::vector<tetra::BenchCase> more) {
        cases.insert(cases.end(), more.begin(), more.end());
    };
    for (const auto& [name, file] : files)
        if (meshes.contains(name, Qt::CaseInsensitive))
            add(tetra::compareWithVtk(name, data + "/" + file));
    if (meshes.contains("Bucky", Qt::CaseInsensitive))
        add(tetra::collapsesOfLattice(data + "/buckyball/bucky_32x32x32_uint8.raw", 32));
    if (!sizes.empty())
        add(tetra::growthOfTime(sizes));
    return cases;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOption({"data", "The folder of the datasets.", "DIR", TAN_SOURCE_DIR "/../shared/data"});
    parser.addOption({"meshes", "Which datasets, separated by commas.", "LIST", "BluntFin,Post,bracket,Bucky"});
    parser.addOption(
        {"sizes", "Points along an axis of the synthetic C60, separated by commas; 0: none.", "LIST", "32,64,128"});
    parser.process(application);
    std::vector<std::uint32_t> sizes;
    for (const QString& size : parser.value("sizes").split(','))
        if (size.toUInt() > 1)
            sizes.push_back(size.toUInt());
    const auto cases = measureAll(parser.value("data"), parser.value("meshes").split(','), sizes);
    tetra::printReport("decimation", cases, parser.isSet("json"));
    return 0;
}
