#include "carom/options/options.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "carom/options/option_list.h"
#include "carom/options/option_values.h"
#include "carom/text/suggest.h"
#include "carom/text/version.h"

// Parses the command line, and reports errors in it.
namespace carom {
namespace {

UsageAnswer mistake(const CLI::App* command, std::string_view what) {
    const std::string call =
        command->get_parent() == nullptr ? "carom" : "carom " + command->get_name();
    return {.text = fmt::format("carom: error: {}\n       `{} --help` lists what there is\n", what,
                                call),
            .exit_code = 2};
}

// Reports an argument that CLI11 could not interpret.
UsageAnswer unknown_option(const CLI::App* command, std::string_view spelling) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command->get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    }
    return mistake(command, fmt::format("there is no option '{}'{}", spelling,
                                        suggestion(spelling, {names.begin(), names.end()})));
}

UsageAnswer unknown_command(const CLI::App* app, std::string_view spelling) {
    const std::string meant =
        suggestion(spelling, {"play", "run", "replay", "verify", "measure", "compare", "check",
                              "explain", "new", "list", "picture"});
    const std::string what = fmt::format("there is no command '{}'", spelling);
    if (!meant.empty()) return mistake(app, what + meant);
    return mistake(app, fmt::format("{}; to play a level, write `carom play {}`", what, spelling));
}

UsageAnswer unknown_argument(const CLI::App* command, const std::string& argument) {
    const std::string_view spelling = std::string_view(argument).substr(0, argument.find('='));
    if (spelling.starts_with("-")) return unknown_option(command, spelling);
    if (command->get_parent() == nullptr) return unknown_command(command, spelling);
    return mistake(command, fmt::format("'{}' is one argument too many", spelling));
}

const CLI::App* chosen(const CLI::App& app) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    return commands.empty() ? &app : commands.front();
}

// The conflict between options that exclude each other; none if there is none.
std::optional<std::string> conflict(const RunOptions& run) {
    if (run.time && run.ticks) return "--time and --ticks cannot stand together";
    return std::nullopt;
}

std::optional<std::string> conflict(const PlayOptions& play) {
    if (!play.record.empty() && play.level.empty() && !play.resume)
        return "--record needs to know the LEVEL";
    return std::nullopt;
}

template <class Options>
Request request_of(const CLI::App* command, Options& options) {
    if (const auto what = conflict(options)) return mistake(command, *what);
    return std::move(options);
}

Request request_of(const CLI::App* command, CommandOptions& options) {
    const std::string name = command->get_parent() == nullptr ? "" : command->get_name();
    if (!options.guest.name.empty()) {
        if (!name.empty()) return mistake(command, "--guest opens the menu, and takes no command");
        options.play.guest = options.guest;
    }
    if (name == "run") return request_of(command, options.run);
    if (name == "measure") return std::move(options.measure);
    if (name == "compare") return std::move(options.compare);
    if (name == "verify") return std::move(options.verify);
    if (name == "check") return std::move(options.check);
    if (name == "picture") return std::move(options.picture);
    if (name == "list") return ListOptions{};
    if (name == "explain") return std::move(options.explain);
    if (name == "new") return std::move(options.fresh);
    return request_of(command, options.play);
}

constexpr std::size_t help_columns = 80;

// A line of help within 80 columns: what does not fit goes on below the description.
std::string wrapped_line(std::string line) {
    const std::size_t name = line.find_first_not_of(' ');
    const std::size_t gap = line.find("  ", name);
    const std::size_t indent = gap == line.npos ? 0 : line.find_first_not_of(' ', gap);
    std::string text;
    while (line.size() > help_columns) {
        const std::size_t cut = line.rfind(' ', help_columns);
        if (cut == line.npos || cut <= indent) break;
        text += line.substr(0, cut) + "\n";
        line = std::string(indent, ' ') + line.substr(cut + 1);
    }
    return text + line;
}

std::string wrapped_help(std::string_view help) {
    std::string text;
    while (!help.empty()) {
        const std::size_t end = std::min(help.find('\n'), help.size());
        text += wrapped_line(std::string(help.substr(0, end))) + "\n";
        help.remove_prefix(std::min(end + 1, help.size()));
    }
    return text;
}

}  // namespace

Request parse_options(int count, const char* const* arguments) {
    CLI::App app(
        "carom: pool, pinball and a physics laboratory, with physics you can trust.\n"
        "Without a command it opens the menu.",
        "carom");
    app.set_version_flag("--version", fmt::format("carom {}", version()));
    app.footer(
        "`carom COMMAND --help` lists a command's options. The manual: man carom, and docs/.");
    CommandOptions options;
    add_commands(app, options);
    app.require_subcommand(0, 1);
    app.allow_extras();
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        command->allow_extras();
    }
    try {
        app.parse(count, arguments);
    } catch (const CLI::CallForVersion&) {
        return UsageAnswer{.text = app.version() + "\n"};
    } catch (const CLI::CallForHelp&) {
        return UsageAnswer{.text = wrapped_help(app.help())};
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string_view what = error.what();
        return mistake(
            chosen(app),
            fmt::format("{} {}", what.substr(0, what.find(':')),
                        what.ends_with("missing") ? "needs a value" : "may be given only once"));
    } catch (const BadValue& error) {
        return mistake(chosen(app), error.what());
    } catch (const CLI::ParseError& error) {
        for (const std::string& extra : chosen(app)->remaining()) {
            return unknown_argument(chosen(app), extra);
        }
        return mistake(chosen(app), error.what());
    }
    const CLI::App* command = chosen(app);
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) return unknown_argument(command, unknown.front());
    return request_of(command, options);
}

}  // namespace carom
