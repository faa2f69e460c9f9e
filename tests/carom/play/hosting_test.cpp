#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/support/process.h"
#include "support/sandbox.h"
#include "support/sanitizers.h"
#include "support/ssh_server.h"
#include "support/terminal_program.h"

// Follows docs/hosting.md to the letter: sets the account up as the page prints it, plays through a
// real sshd, and tries to get out. All of that happens in a copy of this system (an overlay in a
// mount namespace of its own), which is gone with its last process.

using carom::test::content;
using carom::test::has_sanitizers;
using carom::test::Sandbox;
using carom::test::TemporaryFolder;
using carom::test::TerminalProgram;

namespace {

namespace fs = std::filesystem;

const std::string page = CAROM_SOURCE_DIR "/docs/hosting.md";

// The part of a page below a heading.
std::string section(std::string_view text, std::string_view heading) {
    const std::size_t from = text.find(heading);
    REQUIRE(from != text.npos);
    const std::size_t begin = from + heading.size();
    return std::string(text.substr(begin, text.find("\n## ", begin) - begin));
}

// The lines that are printed as commands: those behind four blanks.
std::string commands_in(std::string_view text) {
    std::string commands;
    bool is_fenced = false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.starts_with("```")) is_fenced = !is_fenced;
        if (!is_fenced && line.starts_with("    ")) commands += std::string(line.substr(4)) + '\n';
    }
    return commands;
}

// The text between ```LANGUAGE and ```.
std::string fenced(std::string_view text, const std::string& language) {
    const std::string opening = "```" + language + '\n';
    const std::size_t begin = text.find(opening);
    REQUIRE(begin != text.npos);
    const std::size_t from = begin + opening.size();
    return std::string(text.substr(from, text.find("```", from) - from));
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    REQUIRE(text.find(what) != text.npos);
    for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += with.size())
        text.replace(at, what.size(), with);
    return text;
}

// The commands of the page as a script for another folder of the build than the page's.
std::string in_this_build(const std::string& commands) {
    const std::string folder = fs::path(CAROM_BINARY_DIR).lexically_relative(CAROM_SOURCE_DIR);
    if (folder == "build/release") return commands;
    return replaced(replaced(commands, "cmake --preset release", "cmake " + folder),
                    "build/release", folder);
}

// What the system has and the page takes for granted, and the page.
std::string script(const std::string& folder) {
    const std::string steps = section(content(page), "## An account for guests");
    std::string commands = in_this_build(commands_in(steps));
    const std::string bobs =
        replaced(commands.substr(commands.find("printf"),
                                 commands.find("sudo chmod") - commands.find("printf")),
                 "anna", "bob");
    std::ofstream(folder + "/carom.conf") << fenced(steps, "sshd_config");
    std::string text = "set -eu\nexport PATH=/usr/sbin:/usr/bin:/sbin:/bin\n";
    text += "mkdir -p /run/sshd\n";  // as Debian's unit of the service does
    // This process is root already, and there is no service to reload: sshd is started afterwards.
    for (const char* const tool : {"sudo", "systemctl"}) {
        const std::string file = std::string("/usr/bin/") + tool;
        text += "printf '#!/bin/sh\\n" +
                std::string(tool == std::string("sudo") ? "exec \"$@\"" : "") + "\\n' >" + file +
                "\nchmod 755 " + file + "\n";
    }
    text += "cd " CAROM_SOURCE_DIR "\n";
    text += "ssh-keygen -A\n";
    text += "mkdir -p /etc/ssh/sshd_config.d\ncp " + folder +
            "/carom.conf /etc/ssh/sshd_config.d/carom.conf\n";
    text += "cp " + folder + "/anna.pub " + folder + "/bob.pub .\n";
    return text + commands + bobs;
}

// A client of the account, with a key.
struct Client {
    std::string folder;
    int port = 0;

    std::vector<std::string> ssh(const std::string& guest, const std::vector<std::string>& options,
                                 const std::string& command = {}) const {
        std::vector<std::string> arguments{"/usr/bin/ssh", "-p", std::to_string(port)};
        return with_rest(arguments, guest, options, "carom@127.0.0.1", command);
    }
    std::vector<std::string> with_rest(std::vector<std::string> arguments, const std::string& guest,
                                       const std::vector<std::string>& options,
                                       const std::string& host, const std::string& more) const {
        for (const std::string& option :
             {std::string("-F"), std::string("none"), std::string("-i"), folder + "/" + guest,
              std::string("-o"), std::string("IdentitiesOnly=yes"), std::string("-o"),
              std::string("IdentityAgent=none"), std::string("-o"),
              std::string("StrictHostKeyChecking=no"), std::string("-o"),
              std::string("UserKnownHostsFile=/dev/null"), std::string("-o"),
              std::string("BatchMode=yes")})
            arguments.push_back(option);
        arguments.insert(arguments.end(), options.begin(), options.end());
        if (!host.empty()) arguments.push_back(host);
        if (!more.empty()) arguments.push_back(more);
        return arguments;
    }
    std::vector<std::string> play(const std::string& guest, const std::string& command = {}) const {
        return ssh(guest, {"-tt", "-o", "LogLevel=ERROR"}, command);
    }
};

std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(folder));
    std::ranges::sort(files);
    return files;
}

void play_as_guests(const Client& client, const fs::path& home) {
    INFO("port ", client.port);
    {
        TerminalProgram anna(client.play("anna"));
        const bool has_begun = anna.wait_for_text("enter play", 30.0);
        INFO(anna.screen().text());
        REQUIRE(has_begun);
        anna.send("cradle\r");
        REQUIRE(anna.wait_for_text("menu"));
        anna.send("w\r");
        REQUIRE(anna.wait_for_text("Saved as cradle-1.level"));

        TerminalProgram second(client.play("anna", "carom run /etc/passwd --record /tmp/out"));
        CHECK(second.wait_for_text("enter play", 30.0));  // not what was asked for
        second.send("\x1b[D");                            // the last group: the guest's own levels
        CHECK(second.wait_for_text("cradle-1", 30.0));
        TerminalProgram third(client.play("anna"));
        CHECK(third.wait_for_text("anna already plays in 2 sessions", 30.0));

        TerminalProgram bob(client.play("bob"));
        CHECK(bob.wait_for_text("enter play", 30.0));
        bob.send("\x1b[D");
        CHECK(bob.wait_for_text("No level in this folder", 30.0));
        CHECK(bob.screen().text().find("cradle-1") == std::string::npos);
        for (TerminalProgram* program : {&second, &bob}) {
            program->send("q");
            CHECK(program->exit_status() == 0);
            CHECK(program->what_is_left_dirty() == "");
        }
        anna.signal(SIGKILL);  // the connection is lost
        anna.wait_for_end();
    }
    const fs::path guests = home / "carom/.local/share/carom/guests";
    const auto is_kept = [&] {
        const auto files = files_below(guests / "anna");
        return std::ranges::any_of(files, [](const std::string& name) {
            return name.starts_with("carom/cut-off/cradle-") && name.ends_with(".resume");
        });
    };
    for (int i = 0; i < 500 && !is_kept(); ++i)
        usleep(20'000);
    CHECK(is_kept());
    TerminalProgram anna(client.play("anna"));
    CHECK(anna.wait_for_text("Unfinished", 30.0));
    anna.send("q");
    CHECK(anna.exit_status() == 0);
}

void try_to_get_out(const Client& client, const std::string& folder) {
    const auto run = [&](const std::vector<std::string>& arguments, std::string* output = nullptr) {
        TerminalProgram program(arguments);
        const auto status = program.wait_for_end(30.0);
        if (output) *output = program.output();
        INFO(program.output());
        REQUIRE(status.has_value());
        return WIFEXITED(*status) ? WEXITSTATUS(*status) : 128;
    };
    std::string output;
    CHECK(run(client.ssh("anna", {"-T"}, "id"), &output) != 0);
    CHECK(output.find("uid=") == std::string::npos);

    const std::string secret = folder + "/secret";
    std::ofstream(secret) << "secret";
    const std::string port = std::to_string(client.port);
    for (const char* const protocol : {"-s", "-O"}) {
        const auto scp = [&](const std::string& from, const std::string& to) {
            std::vector<std::string> arguments{"/usr/bin/scp", protocol, "-P", port};
            return run(client.with_rest(arguments, "anna", {}, from, to));
        };
        CHECK(scp(secret, "carom@127.0.0.1:stolen") != 0);
        CHECK(scp("carom@127.0.0.1:/etc/passwd", folder + "/stolen") != 0);
    }
    CHECK(run(client.with_rest({"/usr/bin/sftp", "-P", port}, "anna", {"-b", "/dev/null"},
                               "carom@127.0.0.1", "")) != 0);
    CHECK_FALSE(fs::exists(folder + "/stolen"));

    CHECK(run(client.ssh("anna", {"-W", "127.0.0.1:" + port})) != 0);
    CHECK(run(client.ssh("anna",
                         {"-N", "-o", "ExitOnForwardFailure=yes", "-R", "0:localhost:1"})) != 0);
    TerminalProgram program(client.ssh("anna", {"-v", "-tt"}));
    REQUIRE(program.wait_for_text("enter play", 30.0));
    CHECK(program.output().find("key options: command pty\r\n") != std::string::npos);
    program.send("q");
    CHECK(program.exit_status() == 0);
}

}  // namespace

TEST_CASE("docs/hosting.md works as printed, and guests cannot leave their folders") {
    if (has_sanitizers) {
        MESSAGE("skipped: this build has sanitizers, and the page installs one for players");
        return;
    }
    if (const auto obstacle = Sandbox::obstacle()) {
        MESSAGE("skipped: ", *obstacle);
        return;
    }
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_all);
    fs::create_directory(folder.path("home"));
    fs::permissions(folder.path("home"), fs::perms(0755));
    for (const char* const guest : {"anna", "bob"})
        carom::test::make_ssh_key(folder.path(guest));
    folder.file("steps", script(folder.path()));
    const int with_pam = carom::test::free_port();
    const int without_pam = carom::test::free_port();
    const auto sshd = [&](int port, const std::string& more) {
        return "/usr/sbin/sshd -E " + folder.path("log") + " -o ListenAddress=127.0.0.1 -p " +
               std::to_string(port) + " -o PidFile=none " + more;
    };
    const Sandbox sandbox(folder.path(), "sh -e " + folder.path("steps") + " && " +
                                             sshd(without_pam, "-o UsePAM=no") + " && exec " +
                                             sshd(with_pam, "-o UsePAM=yes -D"));
    const bool is_up = sandbox.wait_for_port(with_pam, 300.0);
    INFO(content(folder.path("out")));
    REQUIRE(is_up);
    const auto log = [&] {
        return fs::exists(folder.path("log")) ? content(folder.path("log")) : std::string();
    };
    for (const int port : {without_pam, with_pam}) {
        fs::remove_all(folder.path("home/carom/.local/share/carom/guests"));
        const Client client{folder.path(), port};
        play_as_guests(client, folder.path("home"));
        try_to_get_out(client, folder.path());
        INFO(log());
        for (const std::string& name : files_below(folder.path("home/carom"))) {
            CAPTURE(name);
            const bool is_skeleton = name.starts_with(".bash") || name == ".profile";
            const bool is_guests = name.starts_with(".local/share/carom/guests/anna/") ||
                                   name.starts_with(".local/share/carom/guests/bob/");
            CHECK((is_skeleton || is_guests));
        }
    }
}
