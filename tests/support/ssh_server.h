#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

/// A real sshd on loopback, for the user who runs the tests, with its own keys.
namespace carom::test {

/// A port of loopback that nothing uses.
int free_port();
bool is_listening(int port);
/// Makes a key without a passphrase: `file` and `file.pub`. Pre: ssh-keygen is installed.
void make_ssh_key(const std::string& file);

class SshServer {
  public:
    /// None if sshd, ssh or ssh-keygen is not installed.
    static std::optional<SshServer> start();
    SshServer(SshServer&& other) noexcept;
    SshServer& operator=(SshServer&&) = delete;
    ~SshServer();  ///< ends it and removes its files

    /// The local command that runs `command` there, on a terminal.
    std::vector<std::string> client(const std::string& command) const;
    /// A folder that is deleted with the server.
    const std::string& folder() const { return folder_; }
    std::string log() const;

  private:
    SshServer() = default;

    std::string folder_;
    int port_ = 0;
    pid_t process_ = -1;
};

}  // namespace carom::test
