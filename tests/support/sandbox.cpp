#include "support/sandbox.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "support/ssh_server.h"

namespace carom::test {
namespace {

constexpr const char* overlay =
    "mount -t tmpfs tmpfs /mnt && mkdir /mnt/up /mnt/work /mnt/up2 /mnt/work2 /mnt/root && "
    "mount -t overlay overlay -o lowerdir=/,upperdir=/mnt/up,workdir=/mnt/work /mnt/root";
constexpr const char* namespaces =
    "unshare --mount --pid --fork --kill-child --propagation private sh -ec ";

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace

std::optional<std::string> Sandbox::obstacle() {
    if (geteuid() != 0) return "this test creates an account, and only root can";
    for (const char* const program : {"/usr/sbin/sshd", "/usr/bin/ssh", "/usr/bin/scp",
                                      "/usr/bin/dpkg-shlibdeps", "/usr/bin/file"})
        if (access(program, X_OK) != 0) return std::string("there is no ") + program;
    const std::string probe = namespaces + quoted(overlay) + " >/dev/null 2>&1";
    if (std::system(probe.c_str()) != 0)
        return "root may not mount an overlay here, to keep the account out of this system";
    return std::nullopt;
}

Sandbox::Sandbox(const std::string& folder, const std::string& command) {
    const std::string root = "/mnt/root";
    // The source may be a file system of its own, which the copy of / would lack.
    const std::string source = std::string("mkdir -p ") + root + CAROM_SOURCE_DIR + ' ' + root +
                               folder +
                               " && mount -t overlay overlay -o lowerdir=" + CAROM_SOURCE_DIR +
                               ",upperdir=/mnt/up2,workdir=/mnt/work2 " + root + CAROM_SOURCE_DIR;
    const std::string inside = std::string(overlay) + " && " + source + " && mount -t proc proc " +
                               root + "/proc && mount --rbind /dev " + root +
                               "/dev && mount --bind " + folder + ' ' + root + folder +
                               " && mount --bind " + folder + "/home " + root +
                               "/home && exec chroot " + root + " sh -c " + quoted(command);
    const std::string all =
        "exec " + (namespaces + quoted(inside)) + " >" + folder + "/out 2>&1 </dev/null";
    process_ = fork();
    if (process_ != 0) return;
    execl("/bin/sh", "sh", "-c", all.c_str(), nullptr);
    _exit(127);
}

Sandbox::~Sandbox() {
    kill(process_, SIGKILL);  // the first process of the namespace dies with it, and so do all
    waitpid(process_, nullptr, 0);
}

bool Sandbox::wait_for_port(int port, double seconds) const {
    for (double waited = 0.0; waited < seconds; waited += 0.05) {
        if (is_listening(port)) return true;
        if (waitpid(process_, nullptr, WNOHANG) != 0) return false;
        usleep(50'000);
    }
    return false;
}

}  // namespace carom::test
