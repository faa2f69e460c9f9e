#include "support/ssh_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <pwd.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace carom::test {
namespace {

std::optional<std::string> program(const std::string& name) {
    for (const char* const folder :
         {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"}) {
        const std::string path = folder + name;
        if (access(path.c_str(), X_OK) == 0) return path;
    }
    return std::nullopt;
}

sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

// Starts it in the background with its output in a file.
pid_t run(std::vector<std::string> arguments, const std::string& output) {
    const pid_t process = fork();
    if (process != 0) return process;
    const int handle = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(handle, STDOUT_FILENO);
    dup2(handle, STDERR_FILENO);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    execv(pointers[0], pointers.data());
    _exit(127);
}

std::string user_name() {
    const passwd* const user = getpwuid(getuid());
    return user != nullptr ? user->pw_name : "root";
}

}  // namespace

int free_port() {
    const int handle = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = loopback(0);
    socklen_t length = sizeof address;
    bind(handle, reinterpret_cast<const sockaddr*>(&address), length);
    getsockname(handle, reinterpret_cast<sockaddr*>(&address), &length);
    close(handle);
    return ntohs(address.sin_port);
}

bool is_listening(int port) {
    const int handle = socket(AF_INET, SOCK_STREAM, 0);
    const sockaddr_in address = loopback(port);
    const bool connected =
        connect(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    close(handle);
    return connected;
}

void make_ssh_key(const std::string& file) {
    const auto keygen = program("ssh-keygen");
    if (!keygen) return;
    waitpid(run({*keygen, "-q", "-t", "ed25519", "-N", "", "-f", file}, "/dev/null"), nullptr, 0);
}

std::optional<SshServer> SshServer::start() {
    const auto sshd = program("sshd");
    if (!sshd || !program("ssh-keygen") || !program("ssh")) return std::nullopt;
    SshServer server;
    std::string pattern = std::filesystem::temp_directory_path() / "carom-ssh-XXXXXX";
    server.folder_ = mkdtemp(pattern.data());
    server.port_ = free_port();
    const std::string& folder = server.folder_;
    const std::string log = folder + "/log";
    for (const char* const key : {"/host", "/user"})
        make_ssh_key(folder + key);
    std::filesystem::copy_file(folder + "/user.pub", folder + "/authorized");
    std::ofstream(folder + "/config") << "Port " << server.port_ << "\nListenAddress 127.0.0.1\n"
                                      << "HostKey " << folder << "/host\n"
                                      << "AuthorizedKeysFile " << folder << "/authorized\n"
                                      << "PidFile none\nUsePAM no\nStrictModes no\n"
                                      << "PasswordAuthentication no\nPermitRootLogin yes\n"
                                      << "PrintMotd no\nPrintLastLog no\nAcceptEnv LC_ALL\n";
    if (getuid() == 0) mkdir("/run/sshd", 0755);  // sshd requires it when run by root
    server.process_ = run({*sshd, "-D", "-e", "-f", folder + "/config"}, log);
    for (int i = 0; i < 500 && !is_listening(server.port_); ++i) {
        usleep(10'000);
    }
    return server;
}

SshServer::SshServer(SshServer&& other) noexcept
    : folder_(std::move(other.folder_)),
      port_(other.port_),
      process_(std::exchange(other.process_, -1)) {}

SshServer::~SshServer() {
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> SshServer::client(const std::string& command) const {
    return {"ssh",
            "-tt",
            "-F",
            "none",
            "-p",
            std::to_string(port_),
            "-i",
            folder_ + "/user",
            "-o",
            "IdentitiesOnly=yes",
            "-o",
            "IdentityAgent=none",
            "-o",
            "StrictHostKeyChecking=no",
            "-o",
            "UserKnownHostsFile=/dev/null",
            "-o",
            "LogLevel=ERROR",
            "-o",
            "SendEnv=LC_ALL",
            user_name() + "@127.0.0.1",
            command};
}

std::string SshServer::log() const {
    std::ifstream file(folder_ + "/log");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace carom::test
