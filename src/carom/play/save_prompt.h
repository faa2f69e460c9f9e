#pragma once

#include <string>
#include <utility>
#include <variant>

#include "terminal/input/input.h"

/// The question under which name a level is saved, and whether its start or its present.
namespace carom {

class SavePrompt {
  public:
    /// `name`: proposed; the first character that the player types replaces it.
    explicit SavePrompt(std::string name) : name_(std::move(name)) {}

    struct Open {};
    struct Cancelled {};
    struct Answer {
        std::string name;  ///< letters, digits, '-' and '_'; never empty
        bool is_start = false;
    };
    std::variant<Open, Cancelled, Answer> handle(const InputEvent& event);

    /// The question, as far as it is answered.
    std::string text() const;

  private:
    std::string name_;
    bool is_proposed_ = true;
    bool is_start_ = false;
};

}  // namespace carom
