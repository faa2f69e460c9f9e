#include "carom/play/save_prompt.h"

#include <fmt/format.h>

namespace carom {
namespace {

constexpr std::size_t longest_name = 40;

// Without a slash or a dot the file stays in the current folder, and is no hidden one.
bool is_of_name(char32_t c) {
    return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || (c >= U'0' && c <= U'9') ||
           c == U'-' || c == U'_';
}

}  // namespace

std::variant<SavePrompt::Open, SavePrompt::Cancelled, SavePrompt::Answer> SavePrompt::handle(
    const InputEvent& event) {
    if (event.kind != InputEvent::Kind::key || event.action == InputEvent::Action::release)
        return Open{};
    switch (event.key) {
        case key::escape:
            return Cancelled{};
        case key::enter:
            if (name_.empty()) return Open{};
            return Answer{name_, is_start_};
        case key::tab:
            if (what_ == What::level) is_start_ = !is_start_;
            return Open{};
        case key::backspace:
            is_proposed_ = false;
            if (!name_.empty()) name_.pop_back();
            return Open{};
        default:
            break;
    }
    // A held key, which opened the question, types nothing.
    const bool repeats = event.action == InputEvent::Action::repeat;
    if (!is_of_name(event.key) || (event.modifiers & (control | alt)) || repeats) return Open{};
    if (std::exchange(is_proposed_, false)) name_.clear();
    if (name_.size() < longest_name) name_ += static_cast<char>(event.key);
    return Open{};
}

std::string SavePrompt::text() const {
    if (what_ == What::recording)
        return fmt::format("Keep the recording as: {}_  enter: keep  esc: cancel", name_);
    return fmt::format("Save as: {}_  ({})  enter: save  tab: {}  esc: cancel", name_,
                       is_start_ ? "its start" : "as it is now",
                       is_start_ ? "as it is now" : "its start");
}

}  // namespace carom
