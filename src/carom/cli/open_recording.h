#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "carom/files/recording.h"

namespace carom {

/// An option whose value a recording has already decided.
struct FixedOption {
    const char* name;  ///< as typed, such as "--rate"
    bool is_given;
};

/// Opens a recording for a command without a screen. None: an option is given that the recording
/// leaves no choice of, or the recording cannot be opened; the error has been printed.
std::optional<OpenedReplay> open_recording(const std::string& path,
                                           std::initializer_list<FixedOption> fixed);

}  // namespace carom
