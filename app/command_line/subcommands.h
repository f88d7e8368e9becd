// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"

/// One source for each, of the same name, here or in building/.
namespace tetra {

Syntax sampleSyntax(PluginHost& host);
Result<Outcome> runSample(const Invocation& invocation);

Syntax buildSyntax(PluginHost& host);
Result<Outcome> runBuild(const Invocation& invocation);

Syntax mergeSyntax(PluginHost& host);
Result<Outcome> runMerge(const Invocation& invocation);

Syntax infoSyntax(PluginHost& host);
Result<Outcome> runInfo(const Invocation& invocation);

Syntax verifySyntax(PluginHost& host);
Result<Outcome> runVerify(const Invocation& invocation);

Syntax extractSyntax(PluginHost& host);
Result<Outcome> runExtract(const Invocation& invocation);

Syntax isosurfaceSyntax(PluginHost& host);
Result<Outcome> runIsosurface(const Invocation& invocation);

Syntax renderSyntax(PluginHost& host);
Result<Outcome> runRender(const Invocation& invocation);

Syntax serveSyntax(PluginHost& host);
Result<Outcome> runServe(const Invocation& invocation);

Syntax reproduceSyntax(PluginHost& host);
Result<Outcome> runReproduce(const Invocation& invocation);

Syntax cutSyntax(PluginHost& host);
Result<Outcome> runCut(const Invocation& invocation);

Syntax packSyntax(PluginHost& host);
Result<Outcome> runPack(const Invocation& invocation);

/// In cut.cpp.
Syntax unpackSyntax(PluginHost& host);
Result<Outcome> runUnpack(const Invocation& invocation);

Syntax setFrameSyntax(PluginHost& host);
Result<Outcome> runSetFrame(const Invocation& invocation);

Syntax pluginsSyntax(PluginHost& host);
Result<Outcome> runPlugins(const Invocation& invocation);

} // namespace tetra
