// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/build_outlook.h"

#include "ui/workbench/import_texts.h"

namespace tetra {

BuildOutlook outlookOf(const BuildQuestion& question)
{
    const unsigned threads = usableThreads();
    const auto estimateOf = [&](const ParameterValues& values) {
        return question.builder->estimate(question.size, values, threads);
    };
    BuildOutlook outlook{.estimate = estimateOf(question.values)};
    for (const ParameterValues& values : question.others)
        outlook.others.push_back(estimateOf(values));
    outlook.resumes = question.builder->abilities(*question.dataset, question.values).resumes;
    return outlook;
}

} // namespace tetra
