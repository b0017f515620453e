// What every command of the command line shares.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace tessera::cli {

/// Exit codes; errors use the values of ErrorKind.
inline constexpr int exit_fine = 0;
inline constexpr int exit_difference = 1;

/// Options of the program as a whole, and the command that was chosen.
struct Context {
    bool quiet = false;
    std::function<int()> chosen;  ///< runs the command and returns the exit code
};

// Each adds one command to the program, in a file of its own.
void add_bench_command(CLI::App& app, Context& context);
void add_devices_command(CLI::App& app, Context& context);
void add_render_command(CLI::App& app, Context& context);
void add_tessellate_command(CLI::App& app, Context& context);
void add_pattern_command(CLI::App& app, Context& context);
void add_verify_command(CLI::App& app, Context& context);
void add_diff_command(CLI::App& app, Context& context);

/// Prints a line on stderr unless the program is quiet.
void say(const Context& context, const std::string& line);

}  // namespace tessera::cli
