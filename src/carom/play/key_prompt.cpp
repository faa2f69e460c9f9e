#include "carom/play/key_prompt.h"

#include <fmt/format.h>

namespace carom {
namespace {

// A key that the preferences file can name; a modifier on its own is none.
bool has_name(const Key& key) {
    return key_named(key_text(key)) == key;
}

}  // namespace

std::variant<KeyPrompt::Open, KeyPrompt::Cancelled, KeyPrompt::Changed> KeyPrompt::handle(
    const InputEvent& event, const KeyMap& keys) {
    if (event.kind != InputEvent::Kind::key || event.action != InputEvent::Action::press)
        return Open{};
    const Key key = key_of(event);
    if (!has_name(key)) return Open{};
    if (key.code == key::escape) return Cancelled{};
    if (!before_) {
        action_ = keys.action_of(key, layer_);
        if (!action_) action_ = keys.action_of(key);
        remark_ = action_ ? "" : fmt::format("{} does nothing. ", shown_key(key));
        if (action_) before_ = key;
        return Open{};
    }
    if (key == *before_) return Cancelled{};
    return Changed{key, action_, *before_, keys.action_of(key, layer_of(*action_))};
}

std::string KeyPrompt::text() const {
    if (before_)
        return fmt::format("{}: {}. Press its new key.  esc: cancel", shown_key(*before_),
                           action_->help);
    return remark_ + "Press the key that you want to change.  esc: cancel";
}

}  // namespace carom
