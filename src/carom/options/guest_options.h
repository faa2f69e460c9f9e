#pragma once

#include <cstddef>
#include <string>

namespace carom {

/// `carom --guest NAME`: somebody who plays on another's account.
struct GuestOptions {
    std::string name;             ///< 1 to 32 of a to z, digits, '-' and '_'; no '-' first
    std::size_t most_saves = 20;  ///< saved levels; the oldest gives way
    double idle = 1800.0;         ///< the longest time without a key or the mouse, s
    int most_sessions = 2;        ///< at a time
};

/// Whether a guest may have this name, which becomes a folder's.
bool is_guest_name(const std::string& name);

}  // namespace carom
