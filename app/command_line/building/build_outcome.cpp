// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/building/build_outcome.h"

#include "app/command_line/error_statistics.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/history/error_meaning.h"
#include "core/history/query_words.h"

#include <tan/model.h>

namespace tetra {

Outcome outcomeOf(const ModelBuild& build, const std::string& wanted, Making making, bool isPacked)
{
    const BuildReport& report = build.report;
    const std::string output = isPacked ? wanted : build.model.string();
    Outcome outcome;
    outcome.figures = {{"model", output},
                       {"builder", build.builder},
                       {"sites", report.sites},
                       {"tetrahedra", report.tetrahedra},
                       {"seconds", build.seconds},
                       {"peak_bytes", build.peakBytes},
                       {"inverted", report.inverted},
                       {"degenerate", report.degenerate},
                       {"bytes", build.fileBytes},
                       {"stopped_early", build.stoppedEarly}};
    outcome.text = visibleText(output) + ": " + std::to_string(report.sites) + " sites, " +
                   std::to_string(report.tetrahedra) + " tetrahedra in the history" +
                   (isPacked ? "" : ", " + byteText(build.fileBytes)) + "\nbuilt by " + visibleText(build.builder) +
                   (making == Making::Merged ? ", merged in " : " in ") + rounded(build.seconds, 3) +
                   " s, using at most " + byteText(build.peakBytes) + " of memory\n";
    if (const auto model = Model::open(build.model)) {
        outcome.figures["error_kind"] = wordOf(errorKindWords, errorMeaning((*model)->description()));
        outcome.text += guaranteeText((*model)->description(), false);
    }
    if (build.stoppedEarly)
        outcome.text += "Stopped early: 'tan info' tells what accuracy it has.\n";
    if (output != wanted)
        outcome.text += "The model '" + wanted + "' is as it was: what is not finished does not replace it.\n";
    if (report.inverted > 0)
        outcome.text += "inverted tetrahedra in the finest mesh: " + std::to_string(report.inverted) +
                        ", where the data's own cells are folded or bent too far\n";
    if (report.degenerate > 0)
        outcome.text += "tetrahedra without volume in the finest mesh: " + std::to_string(report.degenerate) + "\n";
    return outcome;
}

ImportOptions toKeep(ImportOptions imported, const Arguments& arguments)
{
    if (!arguments.has("reader") && imported.values.empty())
        imported.reader.reset();
    return imported;
}

} // namespace tetra
