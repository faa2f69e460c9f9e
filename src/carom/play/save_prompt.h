#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "terminal/input/input.h"

/// The question under which name a level is saved, and whether its start or its present; or under
/// which name a recording is kept.
namespace carom {

class SavePrompt {
  public:
    enum class What : std::uint8_t { level, recording };

    /// `name`: proposed; the first character that the player types replaces it.
    SavePrompt(What what, std::string name) : what_(what), name_(std::move(name)) {}

    What what() const { return what_; }

    struct Open {};
    struct Cancelled {};
    struct Answer {
        std::string name;       ///< letters, digits, '-' and '_'; never empty
        bool is_start = false;  ///< of a level
    };
    std::variant<Open, Cancelled, Answer> handle(const InputEvent& event);

    /// The question, as far as it is answered.
    std::string text() const;

  private:
    What what_;
    std::string name_;
    bool is_proposed_ = true;
    bool is_start_ = false;
};

}  // namespace carom
