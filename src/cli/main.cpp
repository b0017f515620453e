// The program: parses the command line and turns errors into one sentence and an exit code.
#include "base/error.hpp"
#include "cli/command.hpp"

#include <fmt/format.h>
#include <exception>
#include <new>

namespace tessera::cli {

void say(const Context& context, const std::string& line) {
    if (!context.quiet) {
        fmt::print(stderr, "{}\n", line);
    }
}

namespace {

int fail(ErrorKind kind, const std::string& sentence) {
    fmt::print(stderr, "tessera: {}\n", sentence);
    return static_cast<int>(kind);
}

int run(int argc, char** argv) {
    CLI::App app(
        "Tessera makes coarse meshes smooth with compute kernels: no tessellation stage, the same bits on every "
        "device.\nExit codes: 0 fine, 1 a check found a difference, 2 usage or input, 3 device unavailable, 4 "
        "output could not be written.");
    app.set_version_flag("--version", "tessera " TESSERA_VERSION);
    app.require_subcommand(1);
    app.fallthrough();
    Context context;
    app.add_flag("-q,--quiet", context.quiet, "Print results and errors only");
    add_render_command(app, context);
    add_tessellate_command(app, context);
    add_verify_command(app, context);
    add_diff_command(app, context);
    add_pattern_command(app, context);
    add_bench_command(app, context);
    add_devices_command(app, context);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // Help and version are "errors" of code 0 to the library; every real one is a matter of usage.
        return app.exit(error) == 0 ? exit_fine : static_cast<int>(ErrorKind::usage);
    }
    return context.chosen();
}

}  // namespace
}  // namespace tessera::cli

int main(int argc, char** argv) {
    using tessera::ErrorKind;
    try {
        return tessera::cli::run(argc, argv);
    } catch (const tessera::Error& error) {
        return tessera::cli::fail(error.kind(), error.what());
    } catch (const std::bad_alloc&) {
        return tessera::cli::fail(ErrorKind::usage, "The memory of this machine is not enough for the job.");
    } catch (const std::exception& error) {
        return tessera::cli::fail(ErrorKind::usage, fmt::format("An unexpected error occurred: {}.", error.what()));
    }
}
