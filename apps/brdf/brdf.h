// The subcommands of glitterpath brdf: a file each.
#pragma once

#include "commands.h"

namespace gp::tool {

Command addBrdfList(CLI::App& brdf);
Command addBrdfPresets(CLI::App& brdf);
Command addBrdfEval(CLI::App& brdf);
Command addBrdfPlot(CLI::App& brdf);
Command addBrdfSlice(CLI::App& brdf);
Command addBrdfCheck(CLI::App& brdf);
Command addBrdfSphere(CLI::App& brdf);
Command addBrdfSweep(CLI::App& brdf);
Command addBrdfExport(CLI::App& brdf);

}  // namespace gp::tool
