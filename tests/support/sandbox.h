#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

/// A copy of this system, in which a test may install packages and create users: an overlay in
/// memory, in a mount namespace and a process namespace of its own. The network is this system's.
namespace carom::test {

class Sandbox {
  public:
    /// Why there can be none: a sentence. It takes root, and a system that allows overlays.
    static std::optional<std::string> obstacle();

    /// Runs a shell command as root of the copy. `folder`: seen in the copy too, and writable; its
    /// `home` is the copy's /home, and its file `out` takes the output. Pre: no obstacle.
    Sandbox(const std::string& folder, const std::string& command);
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;
    ~Sandbox();  ///< kills all that runs in it

    /// Waits until something listens at a port of loopback. False: it does not within so many
    /// seconds, or the command has ended.
    bool wait_for_port(int port, double seconds) const;

  private:
    pid_t process_ = -1;
};

}  // namespace carom::test
