// glitterpath brdf: the reflectance models, one by one. A file for each of its subcommands.
#include "brdf/brdf.h"

#include <fmt/format.h>

#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  glitterpath brdf list\n"
    "  glitterpath brdf eval ward --set alpha_x=0.3 alpha_y=0.1 --wi 0.5,0,1 --wo -0.5,0,1\n"
    "  glitterpath brdf plot ward lambert --kind polar -o polar.png\n"
    "  glitterpath brdf slice ward:form=ward ward:form=duer --difference -o difference.png\n"
    "  glitterpath brdf check disney\n"
    "  glitterpath brdf sphere disney:metallic=1,roughness=0.3 grating -o spheres.png\n"
    "  glitterpath brdf sweep disney --param roughness -o sweep.png\n"
    "  glitterpath brdf export disney --set metallic=1 -o metal.binary\n\n"
    "`glitterpath brdf SUBCOMMAND --help` tells the rest.";

// "list, eval or plot"
std::string namesOf(const std::vector<Command>& commands) {
    std::string names;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const bool last = i + 1 == commands.size();
        names += (i == 0 ? "" : last ? " or " : ", ") + commands[i].app->get_name();
    }
    return names;
}

}  // namespace

Command addBrdfCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("brdf", "Look at reflectance models");
    app->footer(kExamples);
    const std::vector<Command> commands = {
        addBrdfList(*app),   addBrdfPresets(*app), addBrdfEval(*app),
        addBrdfPlot(*app),   addBrdfSlice(*app),   addBrdfCheck(*app),
        addBrdfSphere(*app), addBrdfSweep(*app),   addBrdfExport(*app)};
    return {app, [commands] {
                for (const Command& command : commands) {
                    if (command.app->parsed()) {
                        return command.run();
                    }
                }
                throw UsageError("brdf: a subcommand is missing: " + namesOf(commands));
            }};
}

}  // namespace gp::tool
