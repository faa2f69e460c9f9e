#pragma once

#include <optional>
#include <string>
#include <variant>

#include "carom/context/key_map.h"

/// The questions that change a key: which key, and by which key from now on.
namespace carom {

class KeyPrompt {
  public:
    /// `layer`: of the way of playing; its actions precede the common ones.
    explicit KeyPrompt(KeyLayer layer) : layer_(layer) {}

    struct Open {};
    struct Cancelled {};
    /// The answer. Where the new key had an action in the layer of `action`, the two keys change
    /// places, so that no action is left without a key.
    struct Changed {
        Key key;               ///< does `action` from now on
        const Action* action;  ///< never null
        Key before;            ///< did it so far
        const Action* other;   ///< what `key` did in that layer; null: nothing
    };
    /// Pre: it is neither cancelled nor answered.
    std::variant<Open, Cancelled, Changed> handle(const InputEvent& event, const KeyMap& keys);

    /// The present question.
    std::string text() const;

  private:
    KeyLayer layer_;
    std::optional<Key> before_;
    const Action* action_ = nullptr;  ///< of `before_`
    std::string remark_;              ///< about a key that cannot be changed; empty: none
};

}  // namespace carom
