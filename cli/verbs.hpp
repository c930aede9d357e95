// The verbs of the command, one file each. Each adds a subcommand to the application.
#pragma once

#include <CLI/CLI.hpp>

namespace packstone::cli {

void add_run(CLI::App& app);
void add_check(CLI::App& app);
void add_info(CLI::App& app);
void add_analyze(CLI::App& app);
void add_convert(CLI::App& app);
void add_render(CLI::App& app);
void add_slice(CLI::App& app);
void add_plot(CLI::App& app);
void add_report(CLI::App& app);

}  // namespace packstone::cli
