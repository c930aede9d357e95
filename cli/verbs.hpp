// The verbs of the command, one file each. Each adds a subcommand to the application.
#pragma once

#include "cli/command_line.hpp"

namespace packstone::cli {

void add_run(Program& program);
void add_check(Program& program);
void add_info(Program& program);
void add_analyze(Program& program);
void add_convert(Program& program);
void add_render(Program& program);
void add_slice(Program& program);
void add_plot(Program& program);
void add_report(Program& program);
void add_tradeoff(Program& program);
void add_stability(Program& program);

}  // namespace packstone::cli
