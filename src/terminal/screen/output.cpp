#include "terminal/screen/output.h"

#include <fcntl.h>
#include <unistd.h>

namespace carom {

TerminalOutput::TerminalOutput() {
    const char* const name = ttyname(STDOUT_FILENO);
    if (name) own_ = ::open(name, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

TerminalOutput::~TerminalOutput() {
    if (own_ >= 0) ::close(own_);
}

int TerminalOutput::handle() const {
    return own_ >= 0 ? own_ : STDOUT_FILENO;
}

}  // namespace carom
